// Small surfaces and datasets for the tests of this room.
#pragma once

#include <cmath>
#include <string>

#include "mesh/dataset.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien::model_test {

/// (n + 1)^2 vertices over 100 x 100 mm about the origin, symmetric about x = 0, with bumps.
inline TriMesh bumpy_sheet(int n, double height = 12.0) {
    TriMesh mesh;
    mesh.vertices.resize((n + 1) * (n + 1), 3);
    mesh.triangles.resize(2 * n * n, 3);
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const double u = 100.0 * x / n - 50, v = 100.0 * y / n - 50;
            mesh.vertices.row(y * (n + 1) + x) << u, v,
                height * std::cos(u / 15) * std::cos(v / 22 + 0.4);
        }
    Index t = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const auto a = static_cast<std::uint32_t>(y * (n + 1) + x);
            const std::uint32_t b = a + 1, c = a + static_cast<std::uint32_t>(n) + 1, d = c + 1;
            // Diagonals turn over at x = 0, so that the mesh mirrors itself.
            if (2 * x < n) {
                mesh.triangles.row(t++) << a, b, d;
                mesh.triangles.row(t++) << a, d, c;
            } else {
                mesh.triangles.row(t++) << a, b, c;
                mesh.triangles.row(t++) << b, d, c;
            }
        }
    return mesh;
}

/// Faces = template + sum_k weight_k shape_k over the first `covered` rows of the sheet's vertices;
/// the weights of two known shapes vary with the subject.
inline std::string write_faces(const TriMesh& mesh, Index covered, int subjects,
                               const std::string& path) {
    Triangles triangles(mesh.triangles.rows(), 3);
    Index used = 0;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
        if (mesh.triangles.row(t).maxCoeff() < static_cast<std::uint64_t>(covered))
            triangles.row(used++) = mesh.triangles.row(t);
    triangles.conservativeResize(used, 3);
    FaceDatasetWriter writer(triangles, covered, {"neutral", "grin"});
    for (int s = 0; s < subjects; ++s)
        for (int e = 0; e < 2; ++e) {
            Points face = mesh.vertices.topRows(covered);
            const double first = 3 * std::sin(1.0 + 2 * s), second = 1.5 * std::cos(3.0 * s * s);
            for (Index v = 0; v < covered; ++v) {
                face(v, 2) += first * std::cos(face(v, 0) / 30) + 0.5;
                face(v, 0) += second * std::sin(face(v, 1) / 25);
                face(v, 1) += 4.0 * e * std::exp(-face.row(v).squaredNorm() / 800);
            }
            writer.add(face, s, e);
        }
    writer.save(path, {});
    return path;
}

}  // namespace mien::model_test
