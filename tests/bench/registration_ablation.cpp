// What each evidence term and heuristic of registration brings: the same scans are fitted with one
// of them after the other switched off through its settings, and compared with the defaults.
//
//   registration_ablation MODEL.safetensors [--free] [--only NAME,NAME] SCAN_FOLDER ...
//
// A folder holds scan.ply, truth.safetensors (vertices, visible) and landmarks.json, as
// simulate_scan.py and make_mh.py write them. --free: without landmarks. Errors are distances of
// the fitted vertices from the true ones, over the visible vertices of the zone "face", over all
// vertices and over the walls that no scanner sees; differences are to the defaults on the same
// scan, positive where the thing brings something.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>

#include "registration_case.hpp"

using namespace mien;

namespace {

using Change = std::function<void(RegistrationSettings&)>;

struct Ablation {
    const char* name;
    Change change;
    enum Of { all, free_fits, landmark_fits, trained_models } of = all;  // it changes these alone
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
        {"no hit farther than 5 mm", [](S& s) { s.fit.loop.match.limit_mm = 5; }},
        {"mutual neighbours within 8 mm", [](S& s) { s.fit.loop.match.mutual_mm = 8; }},
        {"soft assignment of 1 mm", [](S& s) { s.fit.loop.match.soft_mm = 1; }},
        {"raw normals", [](S& s) { s.intake.surface.smoothing_mm = 0; }},
        {"inner walls correspond", [](S& s) { s.inner.exclude = false; }},
        // Loop
        {"one noise level", [](S& s) { s.fit.loop.sigma_start_mm = s.fit.loop.sigma_end_mm; }},
        {"all vertices in all rounds", [](S& s) { s.fit.loop.sparse_share = 0; }},
        // Landmarks
        {"landmarks as stated", [](S& s) { s.start.pin_prior.weigh = false; },
         Ablation::landmark_fits},
        {"no landmark rejected", [](S& s) { s.start.pin_prior.limit = 1e30; },
         Ablation::landmark_fits},
        {"plain first alignment", [](S& s) { s.start.alignment.fewest_for_trials = 1000; },
         Ablation::landmark_fits},
        {"no first shape from landmarks", [](S& s) { s.start.pin_fit.rounds = 0; },
         Ablation::landmark_fits},
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

void print_row(const char* name, const std::vector<Errors>& found,
               const std::vector<Errors>& base) {
    const double n = static_cast<double>(found.size());
    double face = 0, face95 = 0, all = 0, walls = 0, surface = 0, square = 0, worst = -1e9;
    int flipped = 0, crossings = 0, worse = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const double d = found[k].face_mm - base[k].face_mm;
        face += d / n;
        square += d * d / n;
        worst = std::max(worst, d);
        worse += d > 0;
        face95 += (found[k].face95_mm - base[k].face95_mm) / n;
        all += (found[k].all_mm - base[k].all_mm) / n;
        walls += (found[k].walls_mm - base[k].walls_mm) / n;
        surface += (found[k].surface_mm - base[k].surface_mm) / n;
        crossings += found[k].crossings - base[k].crossings;
        flipped += found[k].flipped - base[k].flipped;
    }
    const double error = n > 1 ? std::sqrt(std::max(0.0, square - face * face) / (n - 1)) : 0;
    std::printf(
        "| %s | %+.3f | %.3f | %+.3f | %d of %zu | %+.3f | %+.3f | %+.3f | %+.3f | %+d | %+d |",
        name, face, error, worst, worse, found.size(), face95, all, walls, surface, flipped,
        crossings);
    for (std::size_t k = 0; k < found.size(); ++k)
        std::printf(" %+.3f", found[k].face_mm - base[k].face_mm);
    std::printf(" |\n");
    std::fflush(stdout);
}

void print_defaults(const std::vector<Case>& cases, const std::vector<Errors>& base) {
    std::printf(
        "| scan | face | p95 | all | walls | surface | flipped | crossings |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for (std::size_t k = 0; k < cases.size(); ++k)
        std::printf("| %s | %.3f | %.3f | %.3f | %.3f | %.3f | %d | %d |\n", cases[k].name.c_str(),
                    base[k].face_mm, base[k].face95_mm, base[k].all_mm, base[k].walls_mm,
                    base[k].surface_mm, base[k].flipped, base[k].crossings);
    std::printf(
        "\n| switched off | face, mean | +- | worst | worse | p95 | all vertices | walls | "
        "surface | flipped | crossings | face, each scan |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n");
}

void run(const DeformationModel& model, const std::vector<Case>& cases, bool free,
         const std::vector<std::string>& only, const Context& context) {
    const std::vector<std::uint8_t> walls =
        find_inner_vertices(model.template_mesh, InnerSettings(), context);
    std::vector<Errors> base;
    for (const Ablation& ablation : ablations()) {
        const bool is_default = &ablation == &ablations().front();
        if (!is_default && !only.empty() &&
            std::find(only.begin(), only.end(), ablation.name) == only.end())
            continue;
        if (ablation.of == Ablation::free_fits && !free) continue;
        if (ablation.of == Ablation::landmark_fits && free) continue;
        if (ablation.of == Ablation::trained_models && model.pca_modes.cols == 0) continue;
        RegistrationSettings settings;
        ablation.change(settings);
        std::vector<Errors> found;
        for (const Case& one : cases)
            found.push_back(errors_of(
                model, walls, one,
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
