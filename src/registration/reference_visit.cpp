#include "registration/reference_visit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "geometry/normals.hpp"
#include "registration/ready_scan.hpp"

namespace mien {
namespace {

// Side of a texel on the surface, mm; 0 without images whose size is known.
double texel_mm(const TriMesh& mesh, double unit_to_mm) {
    if (mesh.texture_triangles.rows() != mesh.triangles.rows() || mesh.materials.empty()) return 0;
    std::vector<double> pixels_of_image;
    for (const auto& image : mesh.images) {
        double pixels = 0;
        try {
            const ImageSize size = size_of_image(*image);
            pixels = static_cast<double>(size.width) * static_cast<double>(size.height);
        } catch (const Error& error) {  // the sampler warns of it
            if (error.status() != Status::bad_format &&
                error.status() != Status::unsupported_option)
                throw;
        }
        pixels_of_image.push_back(pixels);
    }
    double area_mm2 = 0, texels = 0;
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const std::size_t row = static_cast<std::size_t>(t);
        const std::int32_t image =
            mesh.materials[mesh.triangle_materials.empty() ? 0 : mesh.triangle_materials[row]]
                .image;
        if (image < 0) continue;
        const auto corner = [&](int k) -> Vector3 {
            return mesh.vertices.row(mesh.triangles(t, k)).transpose();
        };
        const auto place = [&](int k) -> Eigen::Vector2d {
            return mesh.texture.row(mesh.texture_triangles(t, k)).transpose().cast<double>();
        };
        const Eigen::Vector2d b = place(1) - place(0), c = place(2) - place(0);
        area_mm2 += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2 * unit_to_mm *
                    unit_to_mm;
        texels += std::abs(b[0] * c[1] - b[1] * c[0]) / 2 *
                  pixels_of_image[static_cast<std::size_t>(image)];
    }
    return texels > 0 ? std::sqrt(area_mm2 / texels) : 0;
}

// A visit's scan, prepared near the origin, with the fit's places there.
struct ReadyVisit {
    ReadyScan ready;
    Points places;
    Vector3 shift = Vector3::Zero();  // mm, that places were moved by
};

ReadyVisit prepare_visit(const KeptVisit& visit, const char* name,
                         const ReferenceSettings& settings, const Context& context) {
    IntakeSettings intake;
    intake.unit_to_mm = visit.fit.verdict.unit_to_mm;
    const double texel = texel_mm(visit.scan, intake.unit_to_mm),
                 pixel = settings.tie.views.pixel_mm;
    intake.image_radius_mm = texel > 0 && texel < settings.fine_texel * pixel ? pixel / 2 : 0;
    ReadyVisit made;
    made.ready = make_ready(visit.scan, intake, {}, context);
    const ScanSurface& surface = made.ready.scan.surface;
    if (!surface.has_colors() || (surface.images.sampler.empty() && visit.scan.colors.rows() == 0))
        fail(Status::invalid_argument,
             "the %s scan has no colours: neither a texture image that can be read nor colours at "
             "its vertices; a tie by texture needs those of both visits",
             name);
    made.shift = intake.unit_to_mm * made.ready.origin;
    made.places = visit.fitted.vertices.rowwise() - made.shift.transpose();
    std::vector<SurfaceHit> hits;
    surface.tree.closest(made.places, settings.beside_mm, hits, context);
    double counted = 0, beside = 0;
    for (std::size_t v = 0; v < hits.size(); ++v) {
        const double weight =
            visit.fit.weight.size() > 0 ? visit.fit.weight[static_cast<Index>(v)] : 1;
        counted += weight;
        beside += hits[v].valid() ? weight : 0;
    }
    if (!(beside >= settings.least_beside * counted) || !(counted > 0))
        fail(
            Status::mismatch,
            "the %s scan does not lie under its fit: %.0f %% of the fitted places that counted are "
            "within %g mm of it; give the scan that the fit was made of",
            name, counted > 0 ? 100 * beside / counted : 0.0, settings.beside_mm);
    return made;
}

void check_topology(const DeformationModel& model, const KeptVisit& visit, const char* name) {
    if (visit.fitted.vertices.rows() == model.num_vertices() &&
        visit.fitted.triangles.rows() == model.template_mesh.triangles.rows() &&
        visit.fitted.triangles == model.template_mesh.triangles)
        return;
    fail(
        Status::mismatch,
        "the %s is no fit of this model: it has %lld vertices and %lld triangles, or others, where "
        "the model's template has %lld and %lld",
        name, static_cast<long long>(visit.fitted.vertices.rows()),
        static_cast<long long>(visit.fitted.triangles.rows()),
        static_cast<long long>(model.num_vertices()),
        static_cast<long long>(model.template_mesh.triangles.rows()));
}

// Residuals and correspondence of the moved places.
void measure_again(const ReadyVisit& made, const Points& places, const Triangles& triangles,
                   RegistrationResult& fit, const Context& context) {
    constexpr double kBeyondReach_mm = 1e30;
    const Points normals = vertex_normals(places, triangles);
    const PreparedScan& scan = made.ready.scan;
    fit.correspondence.clear();
    scan.surface.tree.closest(places, kBeyondReach_mm, fit.correspondence, context);
    fit.residual_mm.resize(places.rows());
    for (Index v = 0; v < places.rows(); ++v) {
        SurfaceHit& hit = fit.correspondence[static_cast<std::size_t>(v)];
        const double side = normals.row(v).dot(hit.point.transpose() - places.row(v));
        fit.residual_mm[v] = side < 0 ? -hit.distance() : hit.distance();
        hit.barycentric = scan.raw_barycentric(hit);
        hit.triangle = scan.raw_primitive(hit);
        hit.point += made.shift;
    }
}

void add_note(const TextureTie& tie, Verdict& verdict) {
    char text[400];
    if (tie.tied)
        std::snprintf(text, sizeof text,
                      "tied to the reference visit by texture: the pictures agree on a share of "
                      "%.2f of the skin seen twice, and held places slid by %.2f mm (median)",
                      tie.agreeing, tie.median_slide_mm);
    else
        std::snprintf(text, sizeof text, "not tied to the reference visit, nothing moved: %s",
                      tie.why_not.c_str());
    verdict.notes.emplace_back(text);
}

void check_range(double value, double low, double high, const char* what) {
    if (!(value >= low) || !(value <= high))
        fail(Status::invalid_argument, "texture: %s is %g, outside of %g to %g", what, value, low,
             high);
}

}  // namespace

void check_reference_settings(const ReferenceSettings& settings) {
    const TextureTieSettings& tie = settings.tie;
    check_range(tie.most_slide_mm, 0.1, 20, "most_slide_mm (mm)");
    check_range(tie.least_share, 0, 1, "least_share");
    check_range(tie.views.pixel_mm, 0.1, 5, "views.pixel_mm (mm)");
    for (const TieRound& round : tie.rounds) {
        check_range(round.halvings, 0, 4, "a round's halvings");
        check_range(round.reach, 1, 32, "a round's reach");
        check_range(round.window_mm, 1, 100, "round's window_mm");
        check_range(round.coarse_mm, 0.5, 100, "round's coarse_mm");
    }
}

TiedVisit tie_to_reference(const DeformationModel& model, const KeptVisit& reference,
                           const KeptVisit& visit, const ReferenceSettings& settings,
                           const Context& context) {
    check_reference_settings(settings);
    check_topology(model, reference, "reference");
    check_topology(model, visit, "registration");
    context.progress(Stage::alignment, 0);
    Context quiet = context;
    quiet.progress_function = nullptr;
    const ReadyVisit first = prepare_visit(reference, "reference", settings, quiet),
                     second = prepare_visit(visit, "registration's", settings, quiet);
    context.progress(Stage::alignment, 1);
    TiedVisit made;
    made.tie =
        tie_by_texture(model, {first.places, reference.fit.weight, first.ready.scan},
                       {second.places, visit.fit.weight, second.ready.scan}, settings.tie, context);
    made.fit = visit.fit;
    RegistrationResult& fit = made.fit;
    fit.fitted = visit.fitted;
    if (made.tie.tied) {
        fit.fitted.vertices = made.tie.places.rowwise() + second.shift.transpose();
        measure_again(second, made.tie.places, model.template_mesh.triangles, fit, quiet);
        const Vector& before = reference.fit.confidence_mm;
        if (before.size() == fit.confidence_mm.size())
            for (Index v = 0; v < before.size(); ++v) {
                const double held = std::hypot(before[v], made.tie.sd_mm[v]);
                fit.confidence_mm[v] += made.tie.share[v] * (held - fit.confidence_mm[v]);
            }
    }
    made.tie.places.rowwise() += second.shift.transpose();
    add_note(made.tie, fit.verdict);
    return made;
}

std::string tie_json(const TextureTie& tie, const std::vector<Zone>& zones) {
    JsonText json;
    json.begin_object();
    json.field("tied", tie.tied);
    json.field("why_not", tie.why_not);
    json.field("compared", tie.compared);
    json.field("agreeing", tie.agreeing);
    json.field("median_slide_mm", tie.median_slide_mm);
    json.field("most_slide_mm", tie.slide_mm.size() > 0 ? tie.slide_mm.maxCoeff() : 0);
    json.field("repaired_triangles", static_cast<int>(tie.undone));
    json.key("zones").begin_object();
    for (const Zone& zone : zones) {
        double held = 0, agreement = 0, slide = 0;
        for (const std::uint32_t v : zone.vertices) {
            const Index row = static_cast<Index>(v);
            if (row >= tie.share.size()) continue;
            held += tie.share[row];
            agreement += tie.agreement[row];
            slide += tie.slide_mm[row];
        }
        const double count = static_cast<double>(std::max<std::size_t>(1, zone.vertices.size()));
        json.key(zone.name).begin_object();
        json.field("held", held / count);
        json.field("agreement", agreement / count);
        json.field("slide_mm", slide / count);
        json.end_object();
    }
    json.end_object();
    json.end_object();
    return json.take();
}

}  // namespace mien
