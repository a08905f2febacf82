#include "report_fits.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "fit_options.hpp"
#include "report_words.hpp"

namespace mien::cli {
namespace {

namespace fs = std::filesystem;

std::string extension_of(const fs::path& path) {
    std::string extension = path.extension().u8string();
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return extension;
}

/// A mesh, by the library's own table of formats, or a record of a fit.
bool is_capture(const fs::path& path) {
    return is_mesh_name(path.u8string()) || extension_of(path) == ".safetensors";
}

/// A record beside a mesh of the same name holds that mesh: taken both, one fit would be two
/// captures.
bool has_record(const fs::path& mesh) {
    fs::path record = mesh;
    record.replace_extension(".safetensors");
    return extension_of(mesh) != ".safetensors" && fs::exists(record);
}

Capture capture_of(const fs::path& mesh, bool own_folder) {
    fs::path beside = mesh;
    beside.replace_extension(".json");
    Capture capture{mesh.u8string(), ""};
    if (fs::exists(beside))
        capture.landmarks = beside.u8string();
    else if (own_folder && fs::exists(mesh.parent_path() / "landmarks.json"))
        capture.landmarks = (mesh.parent_path() / "landmarks.json").u8string();
    return capture;
}

std::vector<fs::path> sorted_entries(const fs::path& folder) {
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::vector<double> values_of(const nlohmann::json& file, const std::string& path, const char* key,
                              std::size_t count) {
    if (!file.contains(key) || !file[key].is_array() || file[key].size() != count)
        throw std::runtime_error(path + ": \"" + key +
                                 "\" does not hold one number per vertex of the mesh beside it");
    std::vector<double> values;
    for (const nlohmann::json& value : file[key]) {
        if (!value.is_number())
            throw std::runtime_error(path + ": \"" + key + "\" holds " + value.dump());
        values.push_back(value.get<double>());
    }
    return values;
}

Fitted described(Registration fit, std::string scan) {
    nlohmann::json report = nlohmann::json::parse(fit.json());
    return {std::move(fit), true, std::move(report), std::move(scan), {}};
}

std::int32_t quality_called(const std::string& name) {
    return name == "good"       ? MIEN_QUALITY_GOOD
           : name == "doubtful" ? MIEN_QUALITY_DOUBTFUL
                                : MIEN_QUALITY_FAILED;
}

}  // namespace

std::vector<Visit> find_visits(const std::string& folder) {
    if (!fs::is_directory(fs::u8path(folder)))
        throw std::runtime_error(folder + ": is not a folder of visits");
    std::vector<Visit> visits;
    for (const fs::path& entry : sorted_entries(fs::u8path(folder))) {
        Visit visit;
        visit.name = valid_utf8(entry.stem().u8string());
        fs::path file = entry;
        file.replace_extension(".visit.json");
        if (fs::is_directory(entry)) {
            visit.name = valid_utf8(entry.filename().u8string());
            file = entry / "visit.json";
            for (const fs::path& mesh : sorted_entries(entry))
                if (is_capture(mesh) && !has_record(mesh))
                    visit.captures.push_back(capture_of(mesh, true));
        } else if (is_capture(entry) && !has_record(entry)) {
            visit.captures.push_back(capture_of(entry, false));
        }
        if (visit.captures.empty()) continue;
        if (fs::exists(file)) visit.file = read_visit(file.u8string());
        const auto [date, rest] = date_of_name(visit.name);
        if (visit.file.date.empty()) {
            visit.file.date = date;
            if (visit.file.label.empty() && !date.empty()) visit.file.label = rest;
        }
        visits.push_back(visit);
    }
    if (visits.size() < 2)
        throw std::runtime_error(
            folder +
            ": needs at least two visits (mesh files, records of fits, or folders with them)");
    const Visit* before = nullptr;
    for (const Visit& visit : visits) {
        if (visit.file.date.empty()) continue;
        if (before != nullptr && visit.file.date < before->file.date)
            throw std::runtime_error(folder + ": visit '" + visit.name + "' of " + visit.file.date +
                                     " stands after '" + before->name + "' of " +
                                     before->file.date +
                                     "; name the visits in the order of their dates");
        before = &visit;
    }
    std::string undated;
    for (const Visit& visit : visits)
        if (visit.file.date.empty()) undated += (undated.empty() ? "'" : ", '") + visit.name + "'";
    if (!undated.empty())
        std::fprintf(stderr,
                     "mien: warning: %s: visits without a date are taken in the order of their "
                     "names: %s\n",
                     valid_utf8(folder).c_str(), undated.c_str());
    return visits;
}

std::string patient_file(const std::string& folder) {
    const fs::path path = fs::u8path(folder) / "patient.json";
    return fs::exists(path) ? path.u8string() : std::string();
}

std::string Visit::shown() const {
    if (file.date.empty()) return file.label.empty() ? name : file.label;
    return file.label.empty() ? file.date : file.date + ", " + file.label;
}

bool Fitted::good() const {
    return fit.verdict().quality == MIEN_QUALITY_GOOD;
}

std::vector<std::string> Fitted::reasons() const {
    std::vector<std::string> said;
    for (const char* key : {"reasons", "notes"})
        if (report.is_object() && report.contains(key))
            for (const nlohmann::json& reason : report[key])
                said.push_back(reason.get<std::string>());
    return said;
}

bool is_record(const std::string& path) {
    return extension_of(fs::u8path(path)) == ".safetensors";
}

Fitted fit_scan(const Session& session, const Model& model, const Capture& capture,
                const VisitFile& visit) {
    if (is_record(capture.mesh)) return described(Registration(session, capture.mesh), visit.scan);
    RegisterOptions options = register_options({});
    std::vector<std::string> warnings;
    if (!capture.landmarks.empty()) {
        const nlohmann::json landmarks = add_landmarks(session, model, capture.landmarks, options);
        for (const nlohmann::json& warning : landmarks["warnings"])
            warnings.push_back(warning.get<std::string>());
    }
    options.progress = progress_bar();
    const std::size_t told = session.warnings().size();
    Fitted fitted =
        described(Registration(session, model, Mesh(session, capture.mesh), options), capture.mesh);
    const std::vector<std::string> all = session.warnings();
    warnings.insert(warnings.end(), all.begin() + static_cast<std::ptrdiff_t>(told), all.end());
    fitted.warnings = std::move(warnings);
    return fitted;
}

Fitted read_fitted(const Session& session, const Capture& capture, const VisitFile& visit,
                   std::optional<double> sd_mm) {
    if (is_record(capture.mesh)) return described(Registration(session, capture.mesh), visit.scan);
    const Mesh mesh(session, capture.mesh);
    const std::size_t count = mesh.vertex_count();
    const nlohmann::json file =
        capture.landmarks.empty() ? nlohmann::json() : read_json(capture.landmarks);
    if (!file.is_object() || !file.contains("weight")) {
        std::vector<double> sd;
        if (sd_mm) sd.assign(count, *sd_mm);
        return {
            Registration(session, mesh, {}, {}, sd, MIEN_QUALITY_GOOD), false, {}, visit.scan, {}};
    }
    const auto values = [&](const char* key) {
        return values_of(file, capture.landmarks, key, count);
    };
    const bool judged = file.contains("quality") && file["quality"].is_string();
    const std::string quality = judged ? file["quality"].get<std::string>() : "good";
    nlohmann::json said;
    for (const char* key : {"reasons", "notes", "unit_to_mm"})
        if (file.contains(key)) said[key] = file[key];
    return {Registration(session, mesh, values("weight"), values("residual_mm"),
                         values("standard_deviation_mm"), quality_called(quality)),
            judged,
            std::move(said),
            visit.scan,
            {}};
}

}  // namespace mien::cli
