// mien report: a patient's visits -> registration, neutralization, alignment on a stable zone, volumes per
// zone over time, as JSON and as one HTML page.
//
// A folder of visits holds one entry per visit, taken in the order of their names: a mesh file, or a
// folder with one or more captures (mesh files) of that visit; landmarks lie beside a mesh as NAME.json or
// landmarks.json. The first capture of a visit is measured; the others say how repeatable it is.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "commands.hpp"
#include "render.hpp"
#include "report_page.hpp"

namespace mien::cli {
namespace {

namespace fs = std::filesystem;

struct ReportSettings {
    Common common;
    std::string visits, model, expressions, zones, stable = "forehead,nose", out, title = "Volume over time";
    std::vector<std::string> shown;
    bool fitted = false;
    double sd = 0.08, correlation = 10, bias = 0.03;
};

struct Capture {
    std::string mesh, landmarks;
};
struct Visit {
    std::string name;
    std::vector<Capture> captures;
};

bool is_mesh(const fs::path& path) {
    std::string extension = path.extension().u8string();
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return extension == ".ply" || extension == ".obj" || extension == ".stl" || extension == ".off";
}

Capture capture_of(const fs::path& mesh, bool own_folder) {
    fs::path beside = mesh;
    beside.replace_extension(".json");
    Capture capture{mesh.u8string(), ""};
    if (fs::exists(beside)) capture.landmarks = beside.u8string();
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

std::vector<Visit> find_visits(const std::string& folder) {
    if (!fs::is_directory(fs::u8path(folder))) throw std::runtime_error(folder + ": is not a folder of visits");
    std::vector<Visit> visits;
    for (const fs::path& entry : sorted_entries(fs::u8path(folder))) {
        Visit visit{entry.stem().u8string(), {}};
        if (fs::is_directory(entry)) {
            visit.name = entry.filename().u8string();
            for (const fs::path& mesh : sorted_entries(entry))
                if (is_mesh(mesh)) visit.captures.push_back(capture_of(mesh, true));
        } else if (is_mesh(entry)) {
            visit.captures.push_back(capture_of(entry, false));
        }
        if (!visit.captures.empty()) visits.push_back(visit);
    }
    if (visits.size() < 2)
        throw std::runtime_error(folder + ": needs at least two visits (mesh files or folders with mesh files)");
    return visits;
}

struct Fitted {
    Mesh mesh;
    std::vector<double> sd;      ///< along the normal, per vertex, mm
    std::vector<double> shared;  ///< what the removed expression leaves open: alike over a whole zone, mm
    std::string verdict;
    bool good = true;
    nlohmann::json report;
};

/// How far a fit may lie off the skin along the normal: where the scan is, the residual over the scanner's noise;
/// where it is not, what the model leaves open.
std::vector<double> normal_deviation(const Registration& fit, double noise_mm) {
    std::vector<double> sd = fit.field(MIEN_REGISTRATION_STANDARD_DEVIATION_MM);
    const std::vector<double> weight = fit.field(MIEN_REGISTRATION_WEIGHT);
    const std::vector<double> residual = fit.field(MIEN_REGISTRATION_RESIDUAL_MM);
    for (std::size_t v = 0; v < sd.size(); ++v)
        sd[v] = weight[v] * std::min(std::hypot(noise_mm, residual[v]), sd[v]) + (1 - weight[v]) * sd[v];
    return sd;
}

/// Face: a Registration or a Mesh.
template <typename Face>
void neutralize(const Session& session, const ExpressionModel& expressions, const Face& face, Fitted& fitted) {
    NeutralizeOptions options;
    options.uncertainty = 1;
    const Neutralization neutral(session, expressions, face, options);
    fitted.mesh = neutral.mesh();
    fitted.shared = neutral.uncertainty();
    fitted.verdict += ", neutralized";
}

Fitted fit_capture(const Session& session, const ReportSettings& settings, const Model* model,
                   const ExpressionModel* expressions, const Capture& capture) {
    if (settings.fitted) {
        Mesh mesh(session, capture.mesh);
        Fitted fitted{mesh, std::vector<double>(mesh.vertex_count(), settings.sd), {}, "fitted beforehand", true, {}};
        if (expressions != nullptr) neutralize(session, *expressions, mesh, fitted);
        return fitted;
    }
    RegisterOptions options;
    if (!capture.landmarks.empty())
        for (const NamedPoint& p : read_landmark_points(capture.landmarks)) options.landmarks.push_back({p.name, p.point});
    options.progress = progress_bar();
    const Registration fit(session, *model, Mesh(session, capture.mesh), options);
    const mien_fit_verdict verdict = fit.verdict();
    Fitted fitted{fit.mesh(), normal_deviation(fit, settings.sd), {}, "", verdict.quality == MIEN_QUALITY_GOOD,
                  nlohmann::json::parse(fit.json())};
    char text[160];
    std::snprintf(text, sizeof text, "fit %s: %.2f mm from the scan, %.0f %% of the face seen",
                  verdict.quality == MIEN_QUALITY_GOOD ? "good" : verdict.quality == MIEN_QUALITY_DOUBTFUL ? "doubtful" : "failed",
                  verdict.mean_residual_mm, 100 * verdict.coverage);
    fitted.verdict = text;
    if (expressions != nullptr) neutralize(session, *expressions, fit, fitted);
    return fitted;
}

std::vector<std::string> split(const std::string& names) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= names.size() && !names.empty();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        parts.push_back(names.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// Pictures that differ between visits only where the faces do.
Image draw_face(const MeshArrays& face, const MeshArrays& framing) {
    RenderOptions options;
    options.views = {"front", "left45"};
    options.size = 360;
    options.framing = &framing;
    return render_mesh(face, options);
}

Image draw_difference(const MeshArrays& face, const std::vector<double>& signed_mm, const MeshArrays& framing, double range) {
    RenderOptions options;
    options.views = {"front", "left45"};
    options.size = 360;
    options.framing = &framing;
    options.scalar = signed_mm;
    options.color_map = ColorMap::diverging;
    options.low = -range;
    options.high = range;
    options.label = "mm, red: gained";
    return render_mesh(face, options);
}

struct Pair {
    std::vector<mien_zone_volume> volumes;  ///< one per zone
    Measurement distance;
    mien_zone_alignment alignment;
    Mesh aligned;
};

double mean_over(const std::vector<std::uint32_t>& zone, const std::vector<double>& values) {
    if (values.empty() || zone.empty()) return 0;
    double sum = 0;
    for (const std::uint32_t v : zone) sum += values.at(v);
    return sum / static_cast<double>(zone.size());
}

Pair compare(const Session& session, const ReportSettings& settings, const Fitted& first, const Fitted& second,
             const std::vector<MeasureZone>& zones, const std::vector<std::uint32_t>& stable) {
    mien_zone_alignment info{};
    Mesh aligned = align_on_zone(session, second.mesh, first.mesh, stable, &info);
    MeasureOptions options;
    options.before_sd_mm = first.sd;
    options.after_sd_mm = second.sd;
    options.correlation_length_mm = settings.correlation;
    options.alignment_rotation_sd_rad = info.rotation_sd_rad;
    options.alignment_translation_sd_mm = info.translation_sd_mm;
    options.alignment_centre = {{info.centre[0], info.centre[1], info.centre[2]}};
    std::vector<mien_zone_volume> volumes;
    for (const MeasureZone& zone : zones) {  // one by one: each has its own share of the neutralizations' errors
        options.zones = {zone};
        options.common_bias_mm = std::hypot(settings.bias, std::hypot(mean_over(zone.vertices, first.shared),
                                                                      mean_over(zone.vertices, second.shared)));
        volumes.push_back(Measurement::volume(session, first.mesh, aligned, options).zone_volume(0));
    }
    options.zones.clear();
    return {volumes, Measurement::distance(session, first.mesh, aligned, options), info, aligned};
}

void run_report(const ReportSettings& settings) {
    if (!settings.fitted && settings.model.empty())
        throw CLI::RequiredError("--model (or --fitted for meshes that are fitted already)");
    const std::vector<Visit> visits = find_visits(settings.visits);
    std::vector<MeasureZone> all_zones, zones;
    for (auto& [name, vertices] : read_zones(settings.zones)) all_zones.push_back({name, std::move(vertices)});
    auto zone_called = [&](const std::string& name) -> const MeasureZone& {
        for (const MeasureZone& zone : all_zones)
            if (zone.name == name) return zone;
        throw std::runtime_error(settings.zones + ": has no zone '" + name + "'");
    };
    std::vector<std::uint32_t> stable;
    for (const std::string& name : split(settings.stable)) {
        const auto& vertices = zone_called(name).vertices;
        stable.insert(stable.end(), vertices.begin(), vertices.end());
    }
    if (settings.shown.empty()) zones = all_zones;
    for (const std::string& name : settings.shown) zones.push_back(zone_called(name));

    const Session session(settings.common.num_threads);
    std::unique_ptr<Model> model;
    std::unique_ptr<ExpressionModel> expressions;
    if (!settings.model.empty()) model = std::make_unique<Model>(session, settings.model);
    if (!settings.expressions.empty()) expressions = std::make_unique<ExpressionModel>(session, settings.expressions);

    std::vector<std::vector<Fitted>> fits;
    for (const Visit& visit : visits) {
        fits.emplace_back();
        for (const Capture& capture : visit.captures)
            fits.back().push_back(fit_capture(session, settings, model.get(), expressions.get(), capture));
    }
    // The same visit captured twice has no change in it: blanks, both ways.
    std::vector<std::vector<double>> blanks(zones.size());
    for (const auto& captures : fits)
        for (std::size_t a = 0; a < captures.size(); ++a)
            for (std::size_t b = a + 1; b < captures.size(); ++b) {
                const Pair pair = compare(session, settings, captures[a], captures[b], zones, stable);
                for (std::size_t z = 0; z < zones.size(); ++z)
                    blanks[z].push_back(pair.volumes[z].signed_ml);
            }

    ReportPage page;
    page.title = settings.title;
    const MeshArrays framing = arrays_of(fits[0][0].mesh);
    std::vector<Pair> pairs;
    for (std::size_t k = 1; k < visits.size(); ++k)
        pairs.push_back(compare(session, settings, fits[0][0], fits[k][0], zones, stable));
    double range = 0.5;
    for (const Pair& pair : pairs)
        range = std::max(range, pair.distance.zone_distance(MIEN_ZONE_WHOLE).p95_length_mm);
    range = std::min(range, 10.0);
    for (std::size_t z = 0; z < zones.size(); ++z) {
        page.zones.push_back(zones[z].name);
    }
    // Blank's bound and detection, 1.645 deviations each, where repeated captures do not tell.
    auto limit_ml = [&](std::size_t zone, const mien_zone_volume& volume) {
        if (blanks[zone].size() < 2) return 2 * 1.6448536269514722 * volume.sd_ml;
        return nlohmann::json::parse(repeatability(session, {}, {}, blanks[zone]))["limit_of_detection"].get<double>();
    };
    nlohmann::json report{{"title", settings.title}, {"unit", "mL"}, {"visits", nlohmann::json::array()}};
    for (std::size_t k = 0; k < visits.size(); ++k) {
        ReportVisit visit;
        visit.name = visits[k].name;
        visit.good = fits[k][0].good;
        visit.verdict = fits[k][0].verdict;
        nlohmann::json entry{{"name", visit.name}, {"scan", visits[k].captures[0].mesh}, {"captures", fits[k].size()},
                             {"registration", fits[k][0].report}};
        const MeshArrays face = arrays_of(k == 0 ? fits[0][0].mesh : pairs[k - 1].aligned);
        visit.face = draw_face(face, framing);
        if (k > 0) {
            const Pair& pair = pairs[k - 1];
            char text[120];
            std::snprintf(text, sizeof text, "; stable zone %.2f mm apart after alignment", pair.alignment.rms_mm);
            visit.verdict += text;
            visit.difference = draw_difference(face, pair.distance.field(MIEN_FIELD_SIGNED_DISTANCE_MM), framing, range);
            entry["alignment_rms_mm"] = pair.alignment.rms_mm;
            entry["zones"] = nlohmann::json::array();
            for (std::size_t z = 0; z < zones.size(); ++z) {
                const mien_zone_volume& v = pair.volumes[z];
                const double limit = limit_ml(z, v);
                ReportVolume volume{v.signed_ml, v.sd_ml, v.low95_ml, v.high95_ml, v.absolute_ml, limit,
                                    std::fabs(v.signed_ml) < limit};
                visit.volumes.push_back(volume);
                entry["zones"].push_back({{"name", zones[z].name},
                                          {"signed_ml", v.signed_ml},
                                          {"absolute_ml", v.absolute_ml},
                                          {"sd_ml", v.sd_ml},
                                          {"low95_ml", v.low95_ml},
                                          {"high95_ml", v.high95_ml},
                                          {"limit_of_detection_ml", limit},
                                          {"below_limit_of_detection", volume.below_limit}});
            }
        }
        page.visits.push_back(std::move(visit));
        report["visits"].push_back(entry);
    }
    page.notes = {
        settings.fitted ? "Faces were fitted beforehand." : "Each scan was registered with the template of " + settings.model + ".",
        expressions ? "Expressions were removed with " + settings.expressions + "; what that leaves open widens the intervals."
                    : "Expressions were not removed: the intervals hold for faces that are held alike.",
        "Faces were aligned on: " + settings.stable + ".",
        "Volumes are exact between corresponding triangles; zones share their edge triangles linearly.",
        "Intervals combine the deviations of both fits, alike over " + short_number(settings.correlation) +
            " mm, the alignment's and a common bias of " + short_number(settings.bias) + " mm.",
        !blanks.empty() && blanks[0].size() >= 2
            ? "Limits of detection come from " + std::to_string(blanks[0].size()) + " pairs of captures of the same visit."
            : "Limits of detection are propagated (3.29 deviations): no visit was captured often enough to measure them."};
    report["notes"] = page.notes;
    const std::string html = report_html(page);
    write_file(settings.out, html);
    write_report(settings.common, report);
    std::printf("%s: %zu visits, %zu zones, %.0f kB\n", settings.out.c_str(), visits.size(), zones.size(),
                static_cast<double>(html.size()) / 1000);
}

}  // namespace

void add_report_commands(CLI::App& app) {
    CLI::App* command = app.add_subcommand("report", "one patient's visits: volumes per zone over time, as a page");
    auto settings = std::make_shared<ReportSettings>();
    command->add_option("--visits", settings->visits, "folder with one mesh, or folder of captures, per visit")->required();
    command->add_option("--model", settings->model, "deformation model, to register the scans");
    command->add_flag("--fitted", settings->fitted, "the meshes are fitted templates already");
    command->add_option("--sd", settings->sd, "deviation of a fitted surface along its normal, mm")->capture_default_str();
    command->add_option("--expressions", settings->expressions, "expression model, to neutralize the faces");
    command->add_option("--zones", settings->zones, "zone file")->required();
    command->add_option("--show", settings->shown, "zones to report; default: all")->delimiter(',');
    command->add_option("--stable", settings->stable, "zones to align on")->capture_default_str();
    command->add_option("--correlation", settings->correlation, "length over which errors go together, mm")->capture_default_str();
    command->add_option("--bias", settings->bias, "error common to all vertices, mm")->capture_default_str();
    command->add_option("--title", settings->title)->capture_default_str();
    command->add_option("--out", settings->out, "HTML page")->required();
    add_common_options(*command, settings->common);
    command->footer("Example: mien report --visits patient --model face.safetensors --zones zones.json --out report.html");
    command->callback([settings] { run_report(*settings); });
}

}  // namespace mien::cli
