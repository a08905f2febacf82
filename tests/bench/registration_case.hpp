// A scan whose true face is known, as simulate_scan.py and make_mh.py write it, and how far a fit
// lies from that face.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/safetensors.hpp"
#include "geometry/normals.hpp"
#include "mesh/mesh_file.hpp"
#include "model/landmarks.hpp"
#include "registration/registration.hpp"

namespace mien {

/// A folder with scan.ply, landmarks.json and truth.safetensors (vertices, visible).
struct Case {
    std::string name;
    TriMesh scan;
    std::vector<LandmarkPoint> landmarks;
    Points truth;
    std::vector<std::uint8_t> visible;
};

inline std::vector<LandmarkPoint> read_landmarks(const std::string& path) {
    std::ifstream file(path);
    if (!file) fail(Status::io, "%.200s: cannot be opened", path.c_str());
    const nlohmann::json json = nlohmann::json::parse(file);
    std::vector<LandmarkPoint> landmarks;
    for (const auto& [name, place] : json.at("points").items())
        landmarks.push_back({name, Vector3(place[0], place[1], place[2])});
    if (landmarks.empty()) fail(Status::not_found, "%.200s: holds no points", path.c_str());
    return landmarks;
}

inline Case read_case(const std::string& folder, const Context& context) {
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

/// Distances of the fitted vertices from the true ones, over the visible vertices of the zone
/// "face", over all vertices and over the walls that no scanner sees.
struct Errors {
    double face_mm = 0, face95_mm = 0, all_mm = 0, walls_mm = 0, surface_mm = 0;
    int flipped = 0;
    int crossings = 0;  ///< pairs of triangles that cross
};

// Triangles of visible corners that lie the other way than the true ones.
inline int count_flipped(const Case& one, const TriMesh& fitted) {
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

/// `walls`: #V, find_inner_vertices() of the model's template, or empty.
inline Errors errors_of(const DeformationModel& model, const std::vector<std::uint8_t>& walls,
                        const Case& one, const RegistrationResult& fit) {
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
    double on_walls = 0;
    for (std::size_t v = 0; v < walls.size(); ++v)
        if (walls[v] != 0) errors.walls_mm += distance[static_cast<Index>(v)], ++on_walls;
    if (on_walls > 0) errors.walls_mm /= on_walls;
    errors.flipped = count_flipped(one, fit.fitted);
    errors.crossings = fit.verdict.self_intersections;
    return errors;
}

}  // namespace mien
