// Frames of a depth camera, simulated: the nearest surface along the ray of each pixel.
#pragma once

#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <random>
#include <vector>

#include "base/types.hpp"
#include "registration/depth_grid.hpp"

namespace mien::test {

struct DepthCamera {
    Index width = 320, height = 200;
    double focal = 400;  ///< pixels
    double distance_mm = 500;

    PinholeCamera pinhole() const {
        return {focal, focal, static_cast<double>(width - 1) / 2,
                static_cast<double>(height - 1) / 2};
    }
    /// x to the right of the picture, y down, z away: before a face that looks along +z.
    Similarity from_face() const {
        Similarity motion;
        motion.rotation = Vector3(1, -1, -1).asDiagonal();
        motion.translation = Vector3(0, 0, distance_mm);
        return motion;
    }
};

/// What the camera sees of `places`, in its own frame; NaN where nothing is. `noise_mm` along the
/// ray.
inline Points depth_frame(const DepthCamera& camera, const Points& places,
                          const Triangles& triangles, double noise_mm, unsigned seed) {
    const PinholeCamera lens = camera.pinhole();
    const Index width = camera.width, height = camera.height;
    std::vector<double> depth(static_cast<std::size_t>(width * height),
                              std::numeric_limits<double>::infinity());
    for (Index t = 0; t < triangles.rows(); ++t) {
        Vector3 x[3];
        double left = 1e30, right = -1e30, top = 1e30, bottom = -1e30;
        for (int k = 0; k < 3; ++k) {
            x[k] = places.row(triangles(t, k)).transpose();
            const double column = lens.focal_x * x[k][0] / x[k][2] + lens.centre_x,
                         row = lens.focal_y * x[k][1] / x[k][2] + lens.centre_y;
            left = std::min(left, column), right = std::max(right, column);
            top = std::min(top, row), bottom = std::max(bottom, row);
        }
        const Vector3 normal = (x[1] - x[0]).cross(x[2] - x[0]);
        if (!(normal.dot(x[0]) < 0)) continue;  // its back
        const double offset = normal.dot(x[0]);
        for (Index r = std::max<Index>(0, static_cast<Index>(std::ceil(top)));
             r <= std::min<Index>(height - 1, static_cast<Index>(std::floor(bottom))); ++r)
            for (Index c = std::max<Index>(0, static_cast<Index>(std::ceil(left)));
                 c <= std::min<Index>(width - 1, static_cast<Index>(std::floor(right))); ++c) {
                const Vector3 ray((static_cast<double>(c) - lens.centre_x) / lens.focal_x,
                                  (static_cast<double>(r) - lens.centre_y) / lens.focal_y, 1);
                const double z = offset / normal.dot(ray);
                const Vector3 place = z * ray;
                bool inside = z > 0;
                for (int k = 0; k < 3 && inside; ++k)
                    inside = normal.dot((x[(k + 1) % 3] - x[k]).cross(place - x[k])) >= 0;
                double& best = depth[static_cast<std::size_t>(r * width + c)];
                if (inside && z < best) best = z;
            }
    }
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1);
    Points frame(width * height, 3);
    for (Index r = 0; r < height; ++r)
        for (Index c = 0; c < width; ++c) {
            const Index i = r * width + c;
            const Vector3 ray((static_cast<double>(c) - lens.centre_x) / lens.focal_x,
                              (static_cast<double>(r) - lens.centre_y) / lens.focal_y, 1);
            const double z = depth[static_cast<std::size_t>(i)];
            if (std::isfinite(z))
                frame.row(i) = (z + noise_mm * noise(random)) * ray.transpose();
            else
                frame.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
        }
    return frame;
}

}  // namespace mien::test
