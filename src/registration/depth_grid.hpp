// One frame of a depth camera: points on a grid, and where a place near them lies on their surface.
//
// The grid is its own search structure (projective association; Blais and Levine, Registering
// multiview range data to create 3D computer objects, 1995): a place is projected to its pixel, and
// steps from tangent plane to tangent plane lead to the foot of its perpendicular.
#pragma once

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

/// column = focal_x x / z + centre_x, row = focal_y y / z + centre_y, whatever the axes' signs.
struct PinholeCamera {
    double focal_x = 0, focal_y = 0;    ///< pixels; 0: not known
    double centre_x = 0, centre_y = 0;  ///< pixels

    bool known() const { return focal_x != 0 && focal_y != 0; }
};

/// Tags in brackets: registration/settings.hpp.
struct DepthGridSettings {
    int reach_px = 2;       ///< >= 1: to both sides, of the differences that give a normal [J]
    double most_slope = 5;  ///< > 0, depth over width: steeper steps are edges of what is seen [J]
    double most_misfit_px = 1;   ///< > 0, pixels, root mean square: of a camera that is found
    Index camera_sample = 4000;  ///< >= 10: points that a camera is found from
    Index fewest_points = 50;    ///< >= 10: with fewer there is no camera to find
};

/// Where a place lies on the grid's surface.
struct GridHit {
    Vector3 point = Vector3::Zero();
    Vector3 normal = Vector3::Zero();  ///< unit, towards the camera
    double whole = 0;                  ///< 0 to 1: share of the pixels around that belong to it
    bool valid = false;
};

class DepthGrid {
  public:
    /// `points`: height x width rows, row by row, in the camera's frame, mm; not finite, or of
    /// depth 0: nothing was seen. A camera that is not known is found from the points. Throws
    /// Status::mismatch for another number of points, invalid_argument for points that are no
    /// pinhole camera's. O(pixels).
    DepthGrid(const PointsRef& points, Index width, Index height, const PinholeCamera& camera,
              const DepthGridSettings& settings);

    const PinholeCamera& camera() const { return camera_; }
    Index num_points() const { return num_points_; }
    Index width() const { return width_; }
    Index height() const { return height_; }
    /// Whether the camera looks at the place, seen or not.
    bool in_view(const Vector3& place) const;
    /// The foot of the place's perpendicular on the surface near where the camera sees it.
    GridHit look(const Vector3& place) const;
    /// The surface as triangles, without those over edges. Vertices are the points seen, ascending.
    void to_mesh(Points& vertices, Triangles& triangles) const;

  private:
    using Point = Eigen::Vector3f;
    struct Pixel {
        Index column, row;
    };

    void find_camera(const DepthGridSettings& settings);
    bool pixel_of(const Vector3& place, Pixel& pixel) const;
    bool seen(Index column, Index row) const {
        return column >= 0 && row >= 0 && column < width_ && row < height_ &&
               seen_[static_cast<std::size_t>(row * width_ + column)] != 0;
    }
    Point at(Index column, Index row) const {
        return points_.row(row * width_ + column).head<3>().transpose();
    }
    /// Whether both are seen and no edge lies between them.
    bool joined(const Point& from, Index column, Index row, Index steps) const;
    bool tangent(const Pixel& pixel, Index step_column, Index step_row, Point& along) const;
    bool plane_at(const Pixel& pixel, Vector3& point, Vector3& normal, double& whole) const;

    Index width_, height_, num_points_ = 0;
    PinholeCamera camera_;
    int reach_px_;
    double most_slope_;
    Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor> points_;
    std::vector<std::uint8_t> seen_;
};

}  // namespace mien
