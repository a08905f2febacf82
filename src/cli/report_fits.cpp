#include "report_fits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace mien::cli {
namespace {

namespace fs = std::filesystem;

/// By the library's own table of formats.
bool is_mesh(const fs::path& path) {
    std::string extension = path.extension().u8string();
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    for (std::uint32_t k = 0; k < mien_mesh_format_count(); ++k)
        if (extension == std::string(".") + mien_mesh_format_extension(k)) return true;
    return false;
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

/// How far a fit may lie off the skin along the normal: where the scan is, the residual over the
/// scanner's noise; where it is not, what the model leaves open.
std::vector<double> normal_deviation(std::vector<double> sd, const std::vector<double>& weight,
                                     const std::vector<double>& residual, double noise_mm) {
    for (std::size_t v = 0; v < sd.size(); ++v)
        sd[v] = weight[v] * std::min(std::hypot(noise_mm, residual[v]), sd[v]) +
                (1 - weight[v]) * sd[v];
    return sd;
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

/// A mesh that was fitted beforehand, with what `mien register --json` wrote beside it, if
/// anything.
Fitted read_fitted(const Session& session, const ReportSettings& settings, const Capture& capture) {
    Fitted fitted{Mesh(session, capture.mesh), {}, {}, "fitted beforehand", true, {}};
    const std::size_t count = fitted.mesh.vertex_count();
    fitted.sd.assign(count, settings.sd);
    fitted.weight.assign(count, 1.0);
    if (capture.landmarks.empty()) return fitted;
    const nlohmann::json file = read_json(capture.landmarks);
    if (!file.is_object() || !file.contains("weight")) return fitted;
    fitted.weight = values_of(file, capture.landmarks, "weight", count);
    fitted.sd = normal_deviation(
        values_of(file, capture.landmarks, "standard_deviation_mm", count), fitted.weight,
        values_of(file, capture.landmarks, "residual_mm", count), settings.sd);
    if (file.contains("quality") && file["quality"].is_string()) {
        fitted.good = file["quality"] == "good";
        fitted.verdict += ", fit " + file["quality"].get<std::string>();
    }
    return fitted;
}

}  // namespace

std::vector<Visit> find_visits(const std::string& folder) {
    if (!fs::is_directory(fs::u8path(folder)))
        throw std::runtime_error(folder + ": is not a folder of visits");
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
        throw std::runtime_error(
            folder + ": needs at least two visits (mesh files or folders with mesh files)");
    return visits;
}

Fitted fit_capture(const Session& session, const ReportSettings& settings, const Model* model,
                   const Capture& capture) {
    if (settings.fitted) return read_fitted(session, settings, capture);
    RegisterOptions options;
    if (!capture.landmarks.empty())
        for (const NamedPoint& p : read_landmark_points(capture.landmarks))
            options.landmarks.push_back({p.name, p.point});
    options.progress = progress_bar();
    const Registration fit(session, *model, Mesh(session, capture.mesh), options);
    const mien_fit_verdict verdict = fit.verdict();
    const std::vector<double> weight = fit.field(MIEN_REGISTRATION_WEIGHT);
    Fitted fitted{fit.mesh(),
                  normal_deviation(fit.field(MIEN_REGISTRATION_STANDARD_DEVIATION_MM), weight,
                                   fit.field(MIEN_REGISTRATION_RESIDUAL_MM), settings.sd),
                  weight,
                  "",
                  verdict.quality == MIEN_QUALITY_GOOD,
                  nlohmann::json::parse(fit.json())};
    char text[160];
    std::snprintf(text, sizeof text, "fit %s: %.2f mm from the scan, %.0f %% of the face seen",
                  verdict.quality == MIEN_QUALITY_GOOD       ? "good"
                  : verdict.quality == MIEN_QUALITY_DOUBTFUL ? "doubtful"
                                                             : "failed",
                  verdict.mean_residual_mm, 100 * verdict.coverage);
    fitted.verdict = text;
    return fitted;
}

std::vector<std::uint32_t> with_margin(const Mesh& face, const std::vector<std::uint32_t>& vertices,
                                       double margin_mm) {
    const std::vector<Position> places = face.positions();
    for (const std::uint32_t v : vertices)
        if (v >= places.size())
            throw std::runtime_error("a treated zone names vertex " + std::to_string(v) + " of " +
                                     std::to_string(places.size()));
    std::vector<std::uint32_t> near;
    for (std::size_t v = 0; v < places.size(); ++v)
        for (const std::uint32_t of : vertices) {
            const double x = places[v][0] - places[of][0], y = places[v][1] - places[of][1],
                         z = places[v][2] - places[of][2];
            if (x * x + y * y + z * z > margin_mm * margin_mm) continue;
            near.push_back(static_cast<std::uint32_t>(v));
            break;
        }
    return near;
}

std::unique_ptr<Visits> neutralize_all(const Session& session, const ExpressionModel& expressions,
                                       const std::vector<std::uint32_t>& treated,
                                       std::vector<Fitted>& fits) {
    std::vector<Mesh> faces;
    std::vector<double> weights;
    for (const Fitted& fit : fits) {
        faces.push_back(fit.mesh);
        weights.insert(weights.end(), fit.weight.begin(), fit.weight.end());
    }
    VisitsOptions options;
    options.set_weights(weights);
    options.set_treated(treated);
    auto visits = std::make_unique<Visits>(session, expressions, faces, options, progress_bar());
    for (std::size_t k = 0; k < fits.size(); ++k) {
        fits[k].mesh = visits->neutral(static_cast<std::int32_t>(k));
        const std::string name = visits->expression(static_cast<std::int32_t>(k));
        fits[k].verdict += name.empty() || name == "neutral" ? "; no expression"
                           : name == "any" ? "; an expression without a name taken off"
                                           : "; expression taken off: " + name;
    }
    return visits;
}

}  // namespace mien::cli
