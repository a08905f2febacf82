// A small face-like sheet with a nose, a model over it, and scans of it: seconds, not minutes.
#pragma once

#include <cmath>
#include <Eigen/Geometry>
#include <memory>
#include <random>

#include "model/deformation_model.hpp"

namespace mien::test {

struct SmallFace {
    DeformationModel model;
    Points truth;  ///< deformed template, template frame
};

inline double gauss(double x, double s) {
    return std::exp(-0.5 * x * x / (s * s));
}

/// 140 x 180 mm, nose towards +z, brows and chin; `cells` quads a side.
inline TriMesh face_sheet(Index cells) {
    TriMesh mesh;
    const Index n = cells + 1;
    mesh.vertices.resize(n * n, 3);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            const double x = -70 + 140.0 * static_cast<double>(i) / static_cast<double>(cells);
            const double y = -90 + 180.0 * static_cast<double>(j) / static_cast<double>(cells);
            double z = 60 * std::sqrt(std::max(0.05, 1 - x * x / 8100 - y * y / 14000));
            z += 24 * gauss(x, 8) * gauss(y, 14) + 6 * gauss(y - 35, 8) * gauss(x, 40);
            z += 7 * gauss(x, 14) * gauss(y + 65, 10) -
                 7 * gauss(std::abs(x) - 32, 9) * gauss(y - 20, 7);
            z += 4 * gauss(x, 22) * gauss(y + 35, 5);
            mesh.vertices.row(i * n + j) << x, y, z;
        }
    mesh.triangles.resize(2 * cells * cells, 3);
    for (Index i = 0; i < cells; ++i)
        for (Index j = 0; j < cells; ++j) {
            const auto a = static_cast<std::uint32_t>(i * n + j),
                       b = a + static_cast<std::uint32_t>(n);
            mesh.triangles.row(2 * (i * cells + j)) << a, b, b + 1;
            mesh.triangles.row(2 * (i * cells + j) + 1) << a, b + 1, a + 1;
        }
    return mesh;
}

/// Scalar modes: Gaussian bumps on a grid, orthogonalised by nothing: any basis will do.
inline SmallFace small_face(Index cells = 36, Index side = 5, double amplitude = 6) {
    SmallFace face;
    DeformationModel& m = face.model;
    m.template_mesh = face_sheet(cells);
    const Points& v = m.template_mesh.vertices;
    auto basis = std::make_shared<Eigen::MatrixXf>(v.rows(), side * side);
    for (Index a = 0; a < side; ++a)
        for (Index b = 0; b < side; ++b)
            for (Index i = 0; i < v.rows(); ++i) {
                const double cx =
                    -60 + 120.0 * static_cast<double>(a) / static_cast<double>(side - 1);
                const double cy =
                    -80 + 160.0 * static_cast<double>(b) / static_cast<double>(side - 1);
                (*basis)(i, a * side + b) = static_cast<float>(amplitude * gauss(v(i, 0) - cx, 28) *
                                                               gauss(v(i, 1) - cy, 36));
            }
    m.basis = {basis->data(), basis->rows(), basis->cols()};
    m.eigenvalues = Vector::Ones(basis->cols());
    m.pca_modes = {nullptr, 3 * v.rows(), 0};
    m.storage = basis;
    const Index n = cells + 1;
    int number = 0;
    for (const double fx : {0.2, 0.5, 0.8})
        for (const double fy : {0.15, 0.35, 0.5, 0.7, 0.85})
            m.landmarks.push_back(
                {"p" + std::to_string(number++),
                 static_cast<std::uint32_t>(std::lround(fx * static_cast<double>(cells)) * n +
                                            std::lround(fy * static_cast<double>(cells)))});
    std::mt19937 random(7);
    Eigen::MatrixXf a(basis->cols(), 3);
    for (Index j = 0; j < a.rows(); ++j)
        for (int k = 0; k < 3; ++k)
            a(j, k) =
                static_cast<float>(1.2 * (random() / 4294967296.0 + random() / 4294967296.0 - 1));
    face.truth = v + (*basis * a).cast<double>();
    return face;
}

inline std::vector<LandmarkPoint> landmarks_of(const SmallFace& face, const Similarity& motion) {
    std::vector<LandmarkPoint> points;
    for (const Landmark& l : face.model.landmarks)
        points.push_back({l.name, motion.apply(Vector3(face.truth.row(l.vertex)))});
    return points;
}

/// The true face in another order of vertices and triangles, moved.
inline TriMesh scan_of(const SmallFace& face, const Similarity& motion, unsigned seed = 3) {
    const Index n = face.truth.rows();
    std::vector<std::uint32_t> order(static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    std::mt19937 random(seed);
    for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[random() % (i + 1)]);
    TriMesh scan;
    scan.vertices.resize(n, 3);
    for (Index i = 0; i < n; ++i)
        scan.vertices.row(order[static_cast<std::size_t>(i)]) =
            motion.apply(Vector3(face.truth.row(i))).transpose();
    const Triangles& t = face.model.template_mesh.triangles;
    scan.triangles.resize(t.rows(), 3);
    for (Index k = 0; k < t.rows(); ++k)
        for (int c = 0; c < 3; ++c) scan.triangles(t.rows() - 1 - k, c) = order[t(k, c)];
    return scan;
}

inline Similarity motion_of(double degrees, const Vector3& axis, const Vector3& shift) {
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(degrees * 3.14159265358979323846 / 180, axis.normalized())
                          .toRotationMatrix();
    motion.translation = shift;
    return motion;
}

}  // namespace mien::test
