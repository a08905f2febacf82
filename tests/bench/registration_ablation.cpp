// What each evidence term and heuristic of registration brings: the same scans are fitted with one
// of them after the other switched off through its settings, and compared with the defaults.
//
//   registration_ablation MODEL.safetensors [--free] [--only NAME,NAME] SCAN_FOLDER ...
//
// A folder holds scan.ply, truth.safetensors (vertices, visible) and landmarks.json, as
// simulate_scan.py and make_mh.py write them. --free: without landmarks. Errors are distances of
// the fitted vertices from the true ones, over the visible vertices of the zone "face" and over all
// vertices; differences are to the defaults on the same scan, positive where the thing brings
// something.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "geometry/normals.hpp"
#include "mesh/mesh_file.hpp"
#include "model/landmarks.hpp"
#include "registration/registration.hpp"

using namespace mien;

namespace {

using Change = std::function<void(RegistrationSettings&)>;

struct Ablation {
    const char* name;
    Change change;
    enum Of { all, free_fits, trained_models } of = all;  // other fits it does not change
};

const std::vector<Ablation>& ablations() {
    using S = RegistrationSettings;
    static const std::vector<Ablation> all = {
        {"defaults", [](S&) {}},
        // Evidence
        {"no bend evidence", [](S& s) { s.fit.loop.evidence.bend.normal_length_mm = 0; }},
        {"no colours at all", [](S& s) { s.colors.enabled = false; }},
        {"planes only (tangential 0)", [](S& s) { s.fit.loop.evidence.surface.tangential = 0; }},
        {"points (tangential 1)", [](S& s) { s.fit.loop.evidence.surface.tangential = 1; }},
        // Correspondence
        {"hits on borders kept", [](S& s) { s.fit.loop.match.reject_border = false; }},
        {"no angle filter", [](S& s) { s.fit.loop.match.max_angle_deg = 180; }},
        {"no robust weight", [](S& s) { s.fit.loop.match.robust = RobustWeight::none; }},
        {"raw normals", [](S& s) { s.intake.surface.smoothing_mm = 0; }},
        {"inner walls correspond", [](S& s) { s.inner.exclude = false; }},
        // Loop
        {"one noise level", [](S& s) { s.fit.loop.sigma_start_mm = s.fit.loop.sigma_end_mm; }},
        {"all vertices in all rounds", [](S& s) { s.fit.loop.sparse_share = 0; }},
        // Landmarks
        {"landmarks as stated", [](S& s) { s.start.pin_prior.weigh = false; }},
        {"no landmark rejected", [](S& s) { s.start.pin_prior.limit = 1e30; }},
        {"plain first alignment", [](S& s) { s.start.alignment.fewest_for_trials = 1000; }},
        {"no first shape from landmarks", [](S& s) { s.start.pin_fit.rounds = 0; }},
        // Prior
        {"motion never scales", [](S& s) { s.prior.estimate_scale = 0; }},
        {"motion always scales", [](S& s) { s.prior.estimate_scale = 1; },
         Ablation::trained_models},
        {"all kernel modes beside trained", [](S& s) { s.prior.max_residual_modes = 100000; },
         Ablation::trained_models},
        {"no kernel modes beside trained", [](S& s) { s.prior.max_residual_modes = 0; },
         Ablation::trained_models},
        {"kernel residual of 0.35 mm", [](S& s) { s.prior.residual_sd_mm = 0.35; },
         Ablation::trained_models},
        {"kernel residual of 1.4 mm", [](S& s) { s.prior.residual_sd_mm = 1.4; },
         Ablation::trained_models},
        // After the modes
        {"gap not closed", [](S& s) { s.gap.enabled = false; }},
        {"turns of the gap kept", [](S& s) { s.gap.undo_turns = false; }},
        {"inner walls not carried", [](S& s) { s.inner.carry = false; }},
        {"folds not straightened", [](S& s) { s.folds.straighten = false; }},
        // Without landmarks
        {"approach of one round", [](S& s) { s.start.approach.rounds = 1; }, Ablation::free_fits},
        {"no jaw tried", [](S& s) { s.start.openings.enabled = false; }, Ablation::free_fits},
        {"jaws by form alone", [](S& s) { s.start.openings.color_share = 0; }, Ablation::free_fits},
        {"no lids shut", [](S& s) { s.start.lids.enabled = false; }, Ablation::free_fits},
        {"weights as with landmarks",
         [](S& s) {
             s.fit.free.surface_weight = s.fit.loop.evidence.surface.weight;
             s.fit.free.color_weight = s.fit.loop.evidence.color.weight;
         },
         Ablation::free_fits},
    };
    return all;
}

struct Case {
    std::string name;
    TriMesh scan;
    std::vector<LandmarkPoint> landmarks;
    Points truth;
    std::vector<std::uint8_t> visible;
};

std::vector<LandmarkPoint> read_landmarks(const std::string& path) {
    std::ifstream file(path);
    if (!file) fail(Status::io, "%.200s: cannot be opened", path.c_str());
    const nlohmann::json json = nlohmann::json::parse(file);
    std::vector<LandmarkPoint> landmarks;
    for (const auto& [name, place] : json.at("points").items())
        landmarks.push_back({name, Vector3(place[0], place[1], place[2])});
    if (landmarks.empty()) fail(Status::not_found, "%.200s: holds no points", path.c_str());
    return landmarks;
}

Case read_case(const std::string& folder, const Context& context) {
    Case one;
    one.name = folder.substr(folder.find_last_of('/') + 1);
    one.scan = read_mesh_file(folder + "/scan.ply", context);
    one.landmarks = read_landmarks(folder + "/landmarks.json");
    const SafetensorsFile file = SafetensorsFile::open(folder + "/truth.safetensors", {}, context);
    const TensorView& vertices = file.tensor("vertices", DType::f32, {-1, 3});
    const Index n = static_cast<Index>(vertices.shape[0]);
    using Floats = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
    one.truth =
        Eigen::Map<const Floats>(static_cast<const float*>(vertices.data), n, 3).cast<double>();
    const TensorView& visible = file.tensor("visible", DType::u8, {n});
    const auto* bytes = static_cast<const std::uint8_t*>(visible.data);
    one.visible.assign(bytes, bytes + n);
    return one;
}

struct Errors {
    double face_mm = 0, face95_mm = 0, all_mm = 0, surface_mm = 0;
    int flipped = 0;
};

// Triangles of visible corners that lie the other way than the true ones.
int count_flipped(const Case& one, const TriMesh& fitted) {
    const Points now = triangle_normals(fitted.vertices, fitted.triangles),
                 true_ones = triangle_normals(one.truth, fitted.triangles);
    int flipped = 0;
    for (Index t = 0; t < now.rows(); ++t) {
        bool seen = true;
        for (int k = 0; k < 3; ++k) seen = seen && one.visible[fitted.triangles(t, k)];
        flipped += seen && now.row(t).dot(true_ones.row(t)) < 0;
    }
    return flipped;
}

Errors errors_of(const DeformationModel& model, const Case& one, const RegistrationResult& fit) {
    const Zone* face = find_zone(model.zones, "face");
    if (face == nullptr) fail(Status::not_found, "the model has no zone 'face'");
    if (fit.fitted.vertices.rows() != one.truth.rows())
        fail(Status::mismatch, "%.60s: the truth is of another template", one.name.c_str());
    const Vector distance = (fit.fitted.vertices - one.truth).rowwise().norm();
    std::vector<double> on_face;
    double residual = 0;
    for (const std::uint32_t v : face->vertices)
        if (one.visible[v]) {
            on_face.push_back(distance[v]);
            residual += std::abs(fit.residual_mm[v]);
        }
    Errors errors;
    for (const double d : on_face) errors.face_mm += d / static_cast<double>(on_face.size());
    errors.surface_mm = residual / static_cast<double>(on_face.size());
    const auto place = on_face.begin() + static_cast<std::ptrdiff_t>(on_face.size() * 95 / 100);
    std::nth_element(on_face.begin(), place, on_face.end());
    errors.face95_mm = *place;
    errors.all_mm = distance.mean();
    errors.flipped = count_flipped(one, fit.fitted);
    return errors;
}

void print_row(const char* name, const std::vector<Errors>& found,
               const std::vector<Errors>& base) {
    const double n = static_cast<double>(found.size());
    double face = 0, face95 = 0, all = 0, surface = 0, square = 0, worst = -1e9;
    int flipped = 0, worse = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const double d = found[k].face_mm - base[k].face_mm;
        face += d / n;
        square += d * d / n;
        worst = std::max(worst, d);
        worse += d > 0;
        face95 += (found[k].face95_mm - base[k].face95_mm) / n;
        all += (found[k].all_mm - base[k].all_mm) / n;
        surface += (found[k].surface_mm - base[k].surface_mm) / n;
        flipped += found[k].flipped - base[k].flipped;
    }
    const double error = n > 1 ? std::sqrt(std::max(0.0, square - face * face) / (n - 1)) : 0;
    std::printf("| %s | %+.3f | %.3f | %+.3f | %d of %zu | %+.3f | %+.3f | %+.3f | %+d |\n", name,
                face, error, worst, worse, found.size(), face95, all, surface, flipped);
    std::fflush(stdout);
}

void print_defaults(const std::vector<Case>& cases, const std::vector<Errors>& base) {
    std::printf(
        "| scan | face | p95 | all | surface | flipped |\n|---|---:|---:|---:|---:|---:|\n");
    for (std::size_t k = 0; k < cases.size(); ++k)
        std::printf("| %s | %.3f | %.3f | %.3f | %.3f | %d |\n", cases[k].name.c_str(),
                    base[k].face_mm, base[k].face95_mm, base[k].all_mm, base[k].surface_mm,
                    base[k].flipped);
    std::printf(
        "\n| switched off | face, mean | +- | worst | worse | p95 | all vertices | surface | "
        "flipped |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
}

void run(const DeformationModel& model, const std::vector<Case>& cases, bool free,
         const std::vector<std::string>& only, const Context& context) {
    std::vector<Errors> base;
    for (const Ablation& ablation : ablations()) {
        const bool is_default = &ablation == &ablations().front();
        if (!is_default && !only.empty() &&
            std::find(only.begin(), only.end(), ablation.name) == only.end())
            continue;
        if (ablation.of == Ablation::free_fits && !free) continue;
        if (ablation.of == Ablation::trained_models && model.pca_modes.cols == 0) continue;
        RegistrationSettings settings;
        ablation.change(settings);
        std::vector<Errors> found;
        for (const Case& one : cases)
            found.push_back(errors_of(
                model, one,
                register_scan(model, one.scan, free ? std::vector<LandmarkPoint>() : one.landmarks,
                              settings, context)));
        if (is_default) {
            base = found;
            print_defaults(cases, base);
        } else {
            print_row(ablation.name, found, base);
        }
    }
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

}  // namespace

int main(int argc, char** argv) {
    bool free = false;
    std::vector<std::string> only, folders;
    for (int k = 2; k < argc; ++k) {
        if (std::strcmp(argv[k], "--free") == 0)
            free = true;
        else if (std::strcmp(argv[k], "--only") == 0 && k + 1 < argc)
            only = split(argv[++k]);
        else
            folders.push_back(argv[k]);
    }
    if (folders.empty()) {
        std::fprintf(stderr,
                     "usage: registration_ablation MODEL.safetensors [--free] [--only NAME,NAME] "
                     "SCAN_FOLDER ...\n");
        return 2;
    }
    try {
        Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        std::vector<Case> cases;
        for (const std::string& folder : folders) cases.push_back(read_case(folder, context));
        run(*model, cases, free, only, context);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "registration_ablation: %s\n", error.what());
        return 1;
    }
    return 0;
}
