#include "registration/intake.hpp"

#include "base/error.hpp"
#include "mesh/cleaning.hpp"

namespace mien {
namespace {

void check_weights(const Vector& weights, Index num_vertices) {
    if (weights.size() == 0) return;
    if (weights.size() != num_vertices)
        fail(Status::mismatch, "registration: %lld scan weights for %lld scan vertices",
             static_cast<long long>(weights.size()), static_cast<long long>(num_vertices));
    for (Index i = 0; i < weights.size(); ++i)
        if (!(weights[i] >= 0 && weights[i] <= 1))
            fail_at(Status::invalid_argument, i,
                    "registration: scan weight %lld is %g, outside 0 and 1",
                    static_cast<long long>(i), weights[i]);
}

// The host's weights of the vertices that stayed; empty when there are none.
Vector given_weights(const CleanedMesh& cleaned, const Vector& given) {
    Vector weight(given.size() == 0 ? 0 : cleaned.mesh.vertices.rows());
    for (Index i = 0; i < weight.size(); ++i)
        weight[i] = given[cleaned.vertex_to_old[static_cast<std::size_t>(i)]];
    return weight;
}

// Returns the fans of the mesh as it is then.
TriangleFans make_windings_alike(TriMesh& mesh, const WindingSettings& settings, PreparedScan& scan,
                                 const Context& context) {
    TriangleFans fans(mesh.vertices.rows(), mesh.triangles, context);
    const WindingReport report = make_windings_consistent(mesh, fans, settings, context);
    scan.outward = report.outward;
    scan.num_turned = static_cast<Index>(report.turned.size());
    if (!report.turned.empty())
        scan.turned.assign(static_cast<std::size_t>(mesh.triangles.rows()), 0);
    for (const std::uint32_t t : report.turned) scan.turned[t] = 1;
    return fans;
}

// What hits take from images, and from a host's weights where these are to be weighed.
ScanImages take_images(const TriMesh& mesh, const IntakeSettings& settings,
                       const Context& context) {
    ScanImages images;
    images.sampler = ImageSampler(mesh, context);
    images.radius_mm = settings.image_radius_mm;
    images.signals = settings.signals;
    images.skin = settings.skin;
    images.weighs_skin = settings.skin_weights;
    return images;
}

// Of the vertices, from the images where there are some.
void take_colors(const Colors& colors, const IntakeSettings& settings, ScanSurface& surface) {
    if (colors.rows() != surface.vertices.rows()) return;
    surface.colors = color_signals(colors, settings.signals);
    if (!settings.skin_weights) return;
    surface.images.given_weight = surface.weight;
    const Vector skin = skin_weights(colors, settings.skin);
    if (surface.weight.size() == 0)
        surface.weight = skin;
    else
        surface.weight.array() *= skin.array();
}

}  // namespace

PreparedScan prepare_scan(const TriMesh& raw, const IntakeSettings& settings,
                          const Context& context) {
    check_weights(settings.weight_per_vertex, raw.vertices.rows());
    CleanedMesh cleaned = clean_mesh(raw, CleaningOptions(), context);
    TriMesh& mesh = cleaned.mesh;
    cleaned.vertex_to_new = {};  // not asked for
    cleaned.triangle_to_new = {};
    PreparedScan scan;
    scan.unit_to_mm = settings.unit_to_mm > 0
                          ? settings.unit_to_mm
                          : choose_unit_mm(mesh.vertices, settings.units, settings.unit);
    mesh.vertices *= scan.unit_to_mm;
    const TriangleFans fans = make_windings_alike(mesh, settings.windings, scan, context);
    scan.pieces = find_pieces(mesh, settings.pieces);
    const Vector weight = given_weights(cleaned, settings.weight_per_vertex);
    ScanImages images = take_images(mesh, settings, context);
    const Colors colors = images.sampler.empty()
                              ? std::move(mesh.colors)
                              : images.sampler.vertex_colors(mesh, settings.image_radius_mm);
    scan.surface = build_scan_surface(std::move(mesh.vertices), std::move(mesh.triangles), fans,
                                      settings.surface, context);
    scan.surface.weight = weight;
    scan.surface.images = std::move(images);
    take_colors(colors, settings, scan.surface);
    scan.vertex_to_raw = std::move(cleaned.vertex_to_old);
    scan.triangle_to_raw = std::move(cleaned.triangle_to_old);
    return scan;
}

}  // namespace mien
