#include "expression/treated_readings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/normals.hpp"

namespace mien {
namespace {

/// A third of the triangles' area vectors at each vertex, mm^2.
Points area_vectors(const PointsRef& vertices, const TrianglesRef& triangles) {
    const Points doubled = triangle_normals(vertices, triangles);
    Points sum = Points::Zero(vertices.rows(), 3);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int corner = 0; corner < 3; ++corner)
            sum.row(triangles(t, corner)) += doubled.row(t) / 6.0;
    return sum;
}

ZoneReading reading_of(const ExpressionModel& model, const TriMesh& face, const Points& areas,
                       const std::vector<std::uint32_t>& zone, const NeutralizationResult& result) {
    ZoneReading reading;
    const std::vector<double>& likely = result.component_probabilities;
    if (!likely.empty()) {
        const auto best = std::max_element(likely.begin(), likely.end());
        reading.expression = model.components[static_cast<std::size_t>(best - likely.begin())].name;
        reading.probability = *best;
    }
    double squares = 0.0, volume = 0.0;
    for (const std::uint32_t v : zone) {
        const Vector3 off = (face.vertices.row(v) - result.neutral_vertices.row(v)).transpose();
        squares += off.squaredNorm();
        volume += areas.row(v).dot(off.transpose());
    }
    if (!zone.empty()) reading.removed_mm = std::sqrt(squares / static_cast<double>(zone.size()));
    reading.removed_ml = 1e-3 * volume;
    return reading;
}

}  // namespace

TreatedReadings read_treated_zone(const Context& context, const ExpressionModel& model,
                                  const TriMesh& face, const Vector& weights_per_vertex,
                                  const NeutralizeMeshOptions& options,
                                  const NeutralizationResult& result) {
    NeutralizeMeshOptions believing = options;
    believing.neutralize.treated.clear();
    believing.neutralize.uncertainty = false;
    const NeutralizationResult other =
        neutralize_mesh(context, model, face, weights_per_vertex, believing);
    // Vertices that hold nothing finite have no volume of their own.
    std::vector<std::uint32_t> zone;
    TriMesh filled = face;
    for (Index v = 0; v < face.vertices.rows(); ++v)
        if (!face.vertices.row(v).allFinite())
            filled.vertices.row(v) = result.neutral_vertices.row(v);
    for (const std::uint32_t v : options.neutralize.treated)
        if (face.vertices.row(v).allFinite()) zone.push_back(v);
    std::sort(zone.begin(), zone.end());
    zone.erase(std::unique(zone.begin(), zone.end()), zone.end());
    const TrianglesRef triangles =
        face.triangles.rows() != 0 ? TrianglesRef(face.triangles) : TrianglesRef(model.triangles);
    const Points areas = area_vectors(filled.vertices, triangles);
    TreatedReadings readings;
    readings.treated = reading_of(model, face, areas, zone, result);
    readings.as_expression = reading_of(model, face, areas, zone, other);
    readings.differ =
        readings.treated.expression != readings.as_expression.expression &&
        std::fabs(readings.treated.removed_ml - readings.as_expression.removed_ml) > kTellingMl;
    return readings;
}

std::string treated_warning(const TreatedReadings& readings) {
    if (!readings.differ) return {};
    char text[320];
    std::snprintf(text, sizeof text,
                  "the treated zone can be read in two ways: as a treatment %.2f mL are taken off "
                  "there (%.40s), as an expression %.2f mL (%.40s, %.0f %%); the first is what "
                  "this result holds",
                  readings.treated.removed_ml, readings.treated.expression.c_str(),
                  readings.as_expression.removed_ml, readings.as_expression.expression.c_str(),
                  100.0 * readings.as_expression.probability);
    return text;
}

}  // namespace mien
