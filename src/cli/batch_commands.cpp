// `mien batch`: many scans with one model, as many at a time as there are threads, each with the
// result of `mien register`. A scan that cannot be fitted does not end the others.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>

#include "fit_options.hpp"

namespace mien::cli {
namespace {

namespace fs = std::filesystem;

/// Scans that are in memory together, for each thread: more keep the threads busy where fits take
/// unequal time.
constexpr int kScansPerThread = 4;

struct BatchArguments {
    std::string model, landmarks_suffix, out_dir;
    std::vector<std::string> scans;
    bool records = false;
    FitArguments fit;
    Common common;
};

/// One scan, and what became of it.
struct Job {
    std::string scan, name;
    std::string error;      ///< empty: it was fitted
    nlohmann::json report;  ///< of the fit
    nlohmann::json landmarks;
};

/// The files, and those of the folders in the order of their names.
std::vector<std::string> scan_files(const std::vector<std::string>& given) {
    std::vector<std::string> files;
    for (const std::string& path : given) {
        if (!fs::is_directory(fs::u8path(path))) {
            files.push_back(path);
            continue;
        }
        std::vector<std::string> inside;
        for (const fs::directory_entry& entry : fs::directory_iterator(fs::u8path(path)))
            if (entry.is_regular_file() && is_mesh_name(entry.path().u8string()))
                inside.push_back(entry.path().u8string());
        if (inside.empty()) throw std::runtime_error(path + ": the folder holds no mesh file");
        std::sort(inside.begin(), inside.end());
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

std::vector<Job> jobs_of(const std::vector<std::string>& scans) {
    std::vector<Job> jobs;
    std::map<std::string, std::string> known;
    for (const std::string& scan : scan_files(scans)) {
        Job job;
        job.scan = scan;
        job.name = fs::u8path(scan).stem().u8string();
        const auto [other, fresh] = known.emplace(job.name, scan);
        if (!fresh)
            throw std::runtime_error(other->second + " and " + scan + ": both results would be " +
                                     job.name + ".ply; rename one, or fit them apart");
        jobs.push_back(std::move(job));
    }
    return jobs;
}

/// Fits have their scans' names: a folder of PLY scans is no folder for the fits.
void expect_scans_kept(const std::vector<Job>& jobs, const BatchArguments& arguments) {
    for (const Job& job : jobs) {
        const fs::path fit = fs::u8path(arguments.out_dir) / fs::u8path(job.name + ".ply");
        std::error_code none;
        if (fs::equivalent(fit, fs::u8path(job.scan), none))
            throw std::runtime_error("--out-dir " + arguments.out_dir +
                                     ": the fit would be written over its scan " + job.scan +
                                     "; name another folder");
    }
}

/// Scans of one call of the library, and which of its fits is whose.
class Chunk {
  public:
    Chunk(const Session& session, const Model& model, const BatchArguments& arguments)
        : session_(session), model_(model), arguments_(arguments), batch_(session, model) {}

    /// Reads a scan and its landmarks; what is wrong with them is the scan's own error.
    void add(Job& job) {
        try {
            const Mesh scan(session_, job.scan);
            RegisterOptions options = register_options(arguments_.fit);
            if (!arguments_.landmarks_suffix.empty())
                job.landmarks = add_landmarks(session_, model_, landmarks_of(job), options);
            batch_.add(session_, scan, options);
            jobs_.push_back(&job);
        } catch (const std::exception& failure) {
            job.error = failure.what();
        }
    }
    void run() {
        batch_.run(session_);
        for (std::size_t k = 0; k < jobs_.size(); ++k) {
            Job& job = *jobs_[k];
            std::optional<Registration> fit;
            try {
                fit.emplace(batch_.registration(static_cast<std::int32_t>(k)));
            } catch (const mien::Exception& failure) {
                job.error = job.scan + ": " + failure.what();
                continue;
            }
            keep(*fit, job);
        }
    }

  private:
    std::string landmarks_of(const Job& job) const {
        const fs::path scan = fs::u8path(job.scan);
        return (scan.parent_path() / fs::u8path(job.name + arguments_.landmarks_suffix)).u8string();
    }
    std::string place(const Job& job, const char* ending) const {
        return (fs::u8path(arguments_.out_dir) / fs::u8path(job.name + ending)).u8string();
    }
    void keep(const Registration& fit, Job& job) const {
        fit.mesh().save(session_, place(job, ".ply"));
        nlohmann::json report = fit_report(fit, true);
        report["out"] = place(job, ".ply");
        if (!job.landmarks.is_null()) report["landmark_file"] = job.landmarks;
        write_json(place(job, ".json"), report);
        if (arguments_.records) fit.save(session_, place(job, ".safetensors"));
        job.report = fit_report(fit, false);
        job.report["out"] = place(job, ".ply");
    }

    const Session& session_;
    const Model& model_;
    const BatchArguments& arguments_;
    Batch batch_;
    std::vector<Job*> jobs_;
};

nlohmann::json batch_summary(const std::vector<Job>& jobs) {
    nlohmann::json scans = nlohmann::json::array();
    std::map<std::string, int> counts{{"good", 0}, {"doubtful", 0}, {"failed", 0}, {"error", 0}};
    for (const Job& job : jobs) {
        nlohmann::json row{{"name", job.name}, {"scan", job.scan}};
        if (job.error.empty()) {
            for (const char* key : {"quality", "reasons", "notes", "expected_error", "out"})
                if (job.report.contains(key)) row[key] = job.report[key];
            ++counts[job.report["quality"].get<std::string>()];
        } else {
            row["error"] = job.error;
            ++counts["error"];
        }
        scans.push_back(row);
    }
    return {{"scans", scans}, {"counts", counts}};
}

void run_batch(const BatchArguments& arguments) {
    if (arguments.fit.weights != "none" && arguments.fit.weights != "skin")
        throw std::runtime_error("--weights " + arguments.fit.weights +
                                 ": a list is of one scan; give none or skin");
    std::vector<Job> jobs = jobs_of(arguments.scans);
    const Session session(arguments.common.num_threads);
    const Model model(session, arguments.model);
    fs::create_directories(fs::u8path(arguments.out_dir));
    expect_scans_kept(jobs, arguments);
    const auto step = static_cast<std::size_t>(kScansPerThread) *
                      static_cast<std::size_t>(arguments.common.num_threads);
    for (std::size_t first = 0; first < jobs.size(); first += step) {
        const std::size_t end = std::min(jobs.size(), first + step);
        Chunk chunk(session, model, arguments);
        for (std::size_t k = first; k < end; ++k) chunk.add(jobs[k]);
        chunk.run();
        for (std::size_t k = first; k < end; ++k) {
            const Job& job = jobs[k];
            std::printf("%s: %s\n", job.name.c_str(),
                        job.error.empty() ? verdict_line(job.report).c_str() : "not fitted");
            if (!job.error.empty()) std::fprintf(stderr, "mien: %s\n", job.error.c_str());
        }
        std::fflush(stdout);
    }
    const nlohmann::json summary = batch_summary(jobs);
    write_report(arguments.common, summary);
    const int errors = summary["counts"]["error"];
    const int failed = arguments.fit.accept_failed ? 0 : summary["counts"]["failed"].get<int>();
    if (errors + failed > 0)
        throw std::runtime_error(std::to_string(errors) + " of " + std::to_string(jobs.size()) +
                                 " scans could not be fitted, and " + std::to_string(failed) +
                                 " fits failed; the others are in " + arguments.out_dir);
}

}  // namespace

void add_batch_commands(CLI::App& app) {
    auto* command = app.add_subcommand("batch", "fit a model's template to many scans");
    auto arguments = std::make_shared<BatchArguments>();
    command->add_option("--model", arguments->model, "deformation model")->required();
    command->add_option("--scans", arguments->scans, "mesh files, and folders of mesh files")
        ->required();
    auto* landmarks =
        command->add_option("--landmarks-suffix", arguments->landmarks_suffix,
                            "the landmarks of NAME.ply are in NAME and this, beside it; not given: "
                            "without landmarks");
    add_fit_options(*command, arguments->fit, landmarks);
    command
        ->add_option("--out-dir", arguments->out_dir,
                     "folder for NAME.ply and NAME.json, as mien register writes them")
        ->required();
    command->add_flag("--records", arguments->records,
                      "NAME.safetensors too, as mien register --record writes it");
    add_common_options(*command, arguments->common);
    command->footer(
        "Example: mien batch --model face.safetensors --scans visits --landmarks-suffix .mrk.json "
        "--out-dir fits --threads 4 --json fits.json");
    command->callback([arguments] { run_batch(*arguments); });
}

}  // namespace mien::cli
