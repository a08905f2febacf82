// Faces for the studies' tests: a bumpy sheet of 10 mm triangles, its captures with errors along
// the normals, zones on it.
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "geometry/normals.hpp"
#include "study/study.hpp"
#include "unit/expression/trained_study.hpp"

namespace mien::test {

inline std::shared_ptr<const TriMesh> sheet(const Points& places) {
    auto mesh = std::make_shared<TriMesh>();
    mesh->vertices = places;
    mesh->triangles = study().triangles;
    return mesh;
}

/// `places` seen by a scanner: off by sd_mm along the normals, each vertex by itself (the errors'
/// correlation length, 4 mm, is below the sheet's spacing).
inline StudyFace seen(const Points& places, double sd_mm, unsigned seed, int visit) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const Points normals = vertex_normals(places, study().triangles);
    Points off = places;
    for (Index v = 0; v < off.rows(); ++v) off.row(v) += sd_mm * normal(random) * normals.row(v);
    StudyFace face;
    face.mesh = sheet(off);
    face.normal_sd_mm = Vector::Constant(off.rows(), sd_mm);
    face.place_sd_mm = Vector::Constant(off.rows(), sd_mm);
    face.weights = Vector::Ones(off.rows());
    face.visit = visit;
    return face;
}

/// Vertices within x0 .. x1, y0 .. y1 mm of the sheet at rest.
inline Zone box(const std::string& name, double x0, double x1, double y0, double y1) {
    Zone zone{name, {}};
    const Points& rest = study().rest;
    for (Index v = 0; v < rest.rows(); ++v)
        if (rest(v, 0) >= x0 && rest(v, 0) <= x1 && rest(v, 1) >= y0 && rest(v, 1) <= y1)
            zone.vertices.push_back(static_cast<std::uint32_t>(v));
    return zone;
}

/// "low" and "high" halves and a "spot" within "high".
inline StudySettings settings_with_zones() {
    StudySettings settings;
    settings.zones.zones = {box("low", 0, 130, 0, 60), box("high", 0, 130, 70, 130),
                            box("spot", 80, 110, 80, 110)};
    settings.zones.stable = {"low"};
    return settings;
}

/// `places` with `height_mm` of growth in the middle of "spot".
inline Points grown(const Points& places, double height_mm) {
    return places + study().bump(95, 95, 12, Vector3(0, 0, height_mm));
}

}  // namespace mien::test
