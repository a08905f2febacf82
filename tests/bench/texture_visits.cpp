// How well do two visits of a person lie on the same skin, by form alone and by texture?
//
//   texture_visits paint MODEL SCAN_FOLDER SKIN_SEED LIGHT_SEED OUT_STEM [KIND] [TEXEL_MM]
//   texture_visits measure MODEL FOLDER1 STEM1 FOLDER2 STEM2
//
// paint: the scan of a folder (simulate_scan.py or make_mh.py) with a procedural skin that is fixed
// to the person, seen in another light at each visit: STEM.ply with STEM.jpg. KIND: skin (default),
// plain (blotches alone), treated (a cheek without freckles, redder), vertex (colours at vertices).
// measure: fits both scans with their landmarks (or reads STEM.fit.safetensors), ties the second to
// the first, and prints one row per zone: how far, in true skin coordinates, both visits' places of
// a vertex lie apart, mm.
#include <chrono>
#include <ctime>
#include <fstream>
#include <numeric>

#include "textured_scan.hpp"

#include "geometry/alignment.hpp"
#include "painted_skin.hpp"
#include "registration/fit_record.hpp"
#include "registration/texture_tie.hpp"
#include "registration_case.hpp"

namespace {

using namespace mien;

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void paint_scan(int argc, char** argv) {
    const Context context;
    const auto model = load_deformation_model(argv[2], {}, context);
    const Case one = read_case(argv[3], context);
    const std::string stem = argv[6], kind = argc > 7 ? argv[7] : "skin";
    const double texel_mm = argc > 8 ? std::atof(argv[8]) : 0.35;
    SkinPaintSettings settings;
    if (kind == "plain") {
        settings.freckles_per_cm2 = settings.pores_per_cm2 = 0;
        settings.blotches = 0;
    }
    if (kind == "treated")
        for (const Zone& zone : model->zones)
            if (zone.name == "cheek_left") {
                for (const std::uint32_t v : zone.vertices)
                    settings.treated += model->template_mesh.vertices.row(v).transpose() /
                                        static_cast<double>(zone.vertices.size());
                settings.treated_mm = 15;
            }
    const PaintedSkin skin(*model, static_cast<std::uint64_t>(std::atoll(argv[4])), settings);
    const VisitLight light(static_cast<std::uint64_t>(std::atoll(argv[5])), 2, skin.tone());
    TriMesh scan = clean_mesh(one.scan, {}, context).mesh;
    scan.colors.resize(0, 3);
    const ScanPainter painter(*model, skin, light, one.truth, scan, context);
    if (kind == "vertex") {
        const IncidentTriangles at = incident_triangles(scan.vertices.rows(), scan.triangles);
        scan.colors = Colors::Constant(scan.vertices.rows(), 3, 128);
        for (Index v = 0; v < scan.vertices.rows(); ++v) {
            if (at.of(static_cast<std::size_t>(v)).size() == 0) continue;
            const Vector3 color = painter(*at.of(static_cast<std::size_t>(v)).begin(),
                                          scan.vertices.row(v).transpose());
            for (int k = 0; k < 3; ++k)
                scan.colors(v, k) =
                    static_cast<std::uint8_t>(std::clamp(color[k] + 0.5, 0.0, 255.0));
        }
    } else {
        scan = with_jpegs(with_colors_in_images(scan, 1, texel_mm, painter));
        scan.images.front() = [&] {
            auto image = std::make_shared<TextureImage>(*scan.images.front());
            image->name = stem.substr(stem.find_last_of('/') + 1) + ".jpg";
            return image;
        }();
    }
    write_mesh_file(stem + ".ply", scan, context);
}

struct Visit {
    Case truth;
    TriMesh scan;
    PreparedScan prepared;
    FitRecord record;
};

Visit read_visit(const DeformationModel& model, const std::string& folder, const std::string& stem,
                 const Context& context) {
    Visit visit;
    visit.truth = read_case(folder, context);
    visit.scan = read_mesh_file(stem + ".ply", context);
    const std::string path = stem + ".fit.safetensors";
    if (!std::ifstream(path)) {
        const RegistrationResult fit =
            register_scan(model, visit.scan, visit.truth.landmarks, {}, context);
        save_fit_record(path, fit.fitted, fit, model.zones, nullptr, context);
    }
    visit.record = load_fit_record(path, context);
    IntakeSettings intake;
    intake.unit_to_mm = 1;
    intake.image_radius_mm = 0;
    visit.prepared = prepare_scan(visit.scan, intake, context);
    return visit;
}

// NAME=NUMBER, for trials.
void set(TextureTieSettings& settings, const std::string& text) {
    const std::size_t mark = text.find('=');
    const std::string name = text.substr(0, mark);
    const double value = std::atof(text.substr(mark + 1).c_str());
    const struct {
        const char* name;
        double* number;
    } numbers[] = {{"least_share", &settings.least_share},
                   {"floor", &settings.detail.floor},
                   {"noise_floor", &settings.detail.noise_mm},
                   {"least_agreement", &settings.least_agreement},
                   {"full_agreement", &settings.full_agreement},
                   {"tied_agreement", &settings.tied_agreement},
                   {"tied_off_mm", &settings.tied_off_mm},
                   {"full_sd_mm", &settings.full_sd_mm},
                   {"pixel_mm", &settings.views.pixel_mm},
                   {"ground_mm", &settings.field.ground_mm},
                   {"window0", &settings.rounds[0].window_mm},
                   {"window1", &settings.rounds[1].window_mm},
                   {"window2", &settings.rounds[2].window_mm},
                   {"window3", &settings.rounds[3].window_mm},
                   {"coarse0", &settings.rounds[0].coarse_mm},
                   {"coarse1", &settings.rounds[1].coarse_mm},
                   {"coarse2", &settings.rounds[2].coarse_mm},
                   {"coarse3", &settings.rounds[3].coarse_mm},
                   {"smooth0", &settings.rounds[0].smooth_mm},
                   {"smooth1", &settings.rounds[1].smooth_mm},
                   {"smooth2", &settings.rounds[2].smooth_mm},
                   {"smooth3", &settings.rounds[3].smooth_mm}};
    for (const auto& one : numbers)
        if (name == one.name) {
            *one.number = value;
            return;
        }
    fail(Status::invalid_argument, "no setting %s", name.c_str());
}

// Where a fit's places lie on the true face.
std::vector<SurfaceHit> skin_of(const TriangleTree& face, const Points& places,
                                const Context& context) {
    std::vector<SurfaceHit> hits;
    face.closest(places, 1e30, hits, context);
    return hits;
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return -1;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void measure(int argc, char** argv) {
    const Context context;
    const auto model = load_deformation_model(argv[2], {}, context);
    const Triangles& triangles = model->template_mesh.triangles;
    const Visit first = read_visit(*model, argv[3], argv[4], context),
                second = read_visit(*model, argv[5], argv[6], context);
    TextureTieSettings settings;
    for (int k = 7; k < argc; ++k) set(settings, argv[k]);
    const double begin = processor_seconds();
    const TextureTie tie = tie_by_texture(
        *model, {first.record.mesh.vertices, first.record.fit.weight, first.prepared},
        {second.record.mesh.vertices, second.record.fit.weight, second.prepared}, settings,
        context);
    const double seconds = processor_seconds() - begin;
    const TriangleTree face1(first.truth.truth, triangles, context),
        face2(second.truth.truth, triangles, context);
    const auto skin1 = skin_of(face1, first.record.mesh.vertices, context);
    const auto form = skin_of(face2, second.record.mesh.vertices, context),
               tied = skin_of(face2, tie.places, context);
    const Index n = tie.places.rows();
    Vector before(n), after(n);
    for (Index v = 0; v < n; ++v) {
        const SurfaceHit& hit = skin1[static_cast<std::size_t>(v)];
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place +=
                hit.barycentric[k] * second.truth.truth.row(triangles(hit.triangle, k)).transpose();
        before[v] = (form[static_cast<std::size_t>(v)].point - place).norm();
        after[v] = (tied[static_cast<std::size_t>(v)].point - place).norm();
    }
    std::printf(
        "%s: tied %d, compared %.2f, agreeing %.3f, median slide %.2f mm, undone %lld, %.2f s %s\n",
        argv[6], tie.tied, tie.compared, tie.agreeing, tie.median_slide_mm,
        static_cast<long long>(tie.undone), seconds, tie.why_not.c_str());
    std::printf(
        "  %-18s %5s  form: median p90 | tied: median p90 | held %% | sd said/real | surface form "
        "tied\n",
        "zone", "n");
    for (const Zone& zone : model->zones) {
        std::vector<double> b, a, held, error;
        double said = 0, surface_form = 0, surface_tied = 0;
        for (const std::uint32_t v : zone.vertices) {
            if (!first.truth.visible[v] || !second.truth.visible[v]) continue;
            b.push_back(before[v]);
            a.push_back(after[v]);
            held.push_back(tie.share[v]);
            if (tie.share[v] > 0.5) {
                said += tie.sd_mm[v];
                error.push_back(after[v]);
            }
            surface_form += form[v].distance();
            surface_tied += tied[v].distance();
        }
        if (b.empty()) continue;
        const double count = static_cast<double>(b.size());
        double real = 0;
        for (const double e : error) real += e * e / 2;
        std::printf("  %-18s %5.0f  %6.2f %6.2f | %6.2f %6.2f | %3.0f | %.2f %.2f | %.3f %.3f\n",
                    zone.name.c_str(), count, quantile(b, 0.5), quantile(b, 0.9), quantile(a, 0.5),
                    quantile(a, 0.9), 100 * std::accumulate(held.begin(), held.end(), 0.0) / count,
                    said / std::max(1.0, static_cast<double>(error.size())),
                    std::sqrt(real / std::max(1.0, static_cast<double>(error.size()))),
                    surface_form / count, surface_tied / count);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    try {
        if (what == "paint" && argc >= 7) {
            paint_scan(argc, argv);
            return 0;
        }
        if (what == "measure" && argc >= 7) {
            measure(argc, argv);
            return 0;
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "texture_visits: %s\n", error.what());
        return 1;
    }
    std::fprintf(stderr, "usage: see the head of texture_visits.cpp\n");
    return 2;
}
