#include "registration/depth_grid.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"

namespace mien {
namespace {

constexpr double kShortest = 1e-12;

// Slope and offset of the line that gives pixels from ratios, and its root mean square misfit.
struct Line {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    void add(double ratio, double pixel) {
        ++n;
        x += ratio;
        y += pixel;
        xx += ratio * ratio;
        xy += ratio * pixel;
        yy += pixel * pixel;
    }
    bool solve(double& slope, double& offset, double& misfit) const {
        const double spread = xx - x * x / n, shared = xy - x * y / n;
        if (!(spread > kShortest * n)) return false;
        slope = shared / spread;
        offset = (y - slope * x) / n;
        misfit = std::sqrt(std::max(0.0, yy - y * y / n - slope * shared) / n);
        return std::isfinite(slope) && slope != 0;
    }
};

}  // namespace

DepthGrid::DepthGrid(const PointsRef& points, Index width, Index height,
                     const PinholeCamera& camera, const DepthGridSettings& settings)
    : width_(width),
      height_(height),
      camera_(camera),
      reach_px_(settings.reach_px),
      most_slope_(settings.most_slope) {
    if (width < 3 || height < 3 || points.rows() / width != height || points.rows() % width != 0)
        fail(Status::mismatch,
             "a depth frame of %lld x %lld pixels with %lld points; it must have one point a "
             "pixel, and 3 pixels a side",
             static_cast<long long>(width), static_cast<long long>(height),
             static_cast<long long>(points.rows()));
    points_.setZero(points.rows(), 4);
    seen_.assign(static_cast<std::size_t>(points.rows()), 0);
    for (Index i = 0; i < points.rows(); ++i) {
        if (!points.row(i).allFinite() || points(i, 2) == 0) continue;
        points_.row(i).head<3>() = points.row(i).cast<float>();
        seen_[static_cast<std::size_t>(i)] = 1;
        ++num_points_;
    }
    if (!camera_.known()) find_camera(settings);
}

void DepthGrid::find_camera(const DepthGridSettings& settings) {
    if (num_points_ < settings.fewest_points) return;  // nothing is in view of any camera
    const Index stride = std::max<Index>(1, points_.rows() / settings.camera_sample);
    Line columns, rows;
    for (Index i = 0; i < points_.rows(); i += stride) {
        if (!seen_[static_cast<std::size_t>(i)]) continue;
        const Index row = i / width_, column = i % width_;
        const double z = static_cast<double>(points_(i, 2));
        columns.add(static_cast<double>(points_(i, 0)) / z, static_cast<double>(column));
        rows.add(static_cast<double>(points_(i, 1)) / z, static_cast<double>(row));
    }
    double column_misfit = 0, row_misfit = 0;
    const bool found = columns.solve(camera_.focal_x, camera_.centre_x, column_misfit) &&
                       rows.solve(camera_.focal_y, camera_.centre_y, row_misfit);
    if (found && std::max(column_misfit, row_misfit) <= settings.most_misfit_px) return;
    fail(Status::invalid_argument,
         "the points of the depth frame are not those of a pinhole camera (%.3g pixels off); give "
         "points in the camera's frame, row by row, without lens distortion",
         found ? std::max(column_misfit, row_misfit) : 0.0);
}

bool DepthGrid::pixel_of(const Vector3& place, Pixel& pixel) const {
    if (!camera_.known() || !(std::abs(place[2]) > 0)) return false;
    const double column = camera_.focal_x * place[0] / place[2] + camera_.centre_x,
                 row = camera_.focal_y * place[1] / place[2] + camera_.centre_y;
    if (!(column > -0.5 && row > -0.5 && column < static_cast<double>(width_) - 0.5 &&
          row < static_cast<double>(height_) - 0.5))
        return false;
    pixel = {static_cast<Index>(std::lround(column)), static_cast<Index>(std::lround(row))};
    return true;
}

bool DepthGrid::in_view(const Vector3& place) const {
    Pixel pixel{};
    return pixel_of(place, pixel);
}

bool DepthGrid::joined(const Point& from, Index column, Index row, Index steps) const {
    if (!seen(column, row)) return false;
    const Point to = at(column, row);
    const float depth = std::abs(to[2] - from[2]),
                width = std::abs(from[2]) / static_cast<float>(std::min(std::abs(camera_.focal_x),
                                                                        std::abs(camera_.focal_y)));
    return depth <= static_cast<float>(most_slope_) * width * static_cast<float>(steps);
}

bool DepthGrid::tangent(const Pixel& pixel, Index step_column, Index step_row, Point& along) const {
    const Point middle = at(pixel.column, pixel.row);
    const Index reach = reach_px_;
    const Index c = reach * step_column, r = reach * step_row;
    const bool after = joined(middle, pixel.column + c, pixel.row + r, reach),
               before = joined(middle, pixel.column - c, pixel.row - r, reach);
    if (!after && !before) return false;
    along = (after ? at(pixel.column + c, pixel.row + r) : middle) -
            (before ? at(pixel.column - c, pixel.row - r) : middle);
    return true;
}

bool DepthGrid::plane_at(const Pixel& pixel, Vector3& point, Vector3& normal, double& whole) const {
    if (!seen(pixel.column, pixel.row)) return false;
    Point across, down;
    if (!tangent(pixel, 1, 0, across) || !tangent(pixel, 0, 1, down)) return false;
    const Vector3 cross = across.cross(down).cast<double>();
    const double length = cross.norm();
    if (!(length > kShortest)) return false;
    const Point middle = at(pixel.column, pixel.row);
    Point sum = middle;
    int count = 1;
    for (Index row = -1; row <= 1; ++row)
        for (Index column = -1; column <= 1; ++column) {
            if ((row == 0 && column == 0) ||
                !joined(middle, pixel.column + column, pixel.row + row, 1))
                continue;
            sum += at(pixel.column + column, pixel.row + row);
            ++count;
        }
    point = (sum / static_cast<float>(count)).cast<double>();
    normal = cross / length;
    if (normal.dot(point) > 0) normal = -normal;
    whole = count / 9.0;
    return true;
}

GridHit DepthGrid::look(const Vector3& place) const {
    constexpr int kSteps = 3;
    GridHit hit;
    Pixel pixel{};
    Vector3 foot = place, point, normal;
    for (int step = 0; step < kSteps; ++step) {
        Pixel next{};
        if (!pixel_of(foot, next)) return hit;
        if (step > 0 && next.column == pixel.column && next.row == pixel.row) break;
        pixel = next;
        if (!plane_at(pixel, point, normal, hit.whole)) return GridHit();
        foot = place - normal * normal.dot(place - point);
    }
    hit.point = foot;
    hit.normal = normal;
    hit.valid = true;
    return hit;
}

void DepthGrid::to_mesh(Points& vertices, Triangles& triangles) const {
    std::vector<std::uint32_t> number(seen_.size(), 0);
    vertices.resize(num_points_, 3);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        if (!seen_[i]) continue;
        vertices.row(next) = points_.row(static_cast<Index>(i)).head<3>().cast<double>();
        number[i] = next++;
    }
    std::vector<std::uint32_t> corners;
    // Corners so that normals look at the camera: d point / d row x d point / d column is
    // -z^2 / (focal_x focal_y) along z.
    const double hand = camera_.focal_x * camera_.focal_y;
    const auto add = [&](const Index(&pixels)[3][2]) {
        for (int k = 0; k < 3; ++k)
            if (!seen(pixels[k][0], pixels[k][1])) return;
        for (int k = 0; k < 3; ++k) {
            const auto& to = pixels[(k + 1) % 3];
            if (!joined(at(pixels[k][0], pixels[k][1]), to[0], to[1], 1)) return;
        }
        const bool as_given = hand * static_cast<double>(at(pixels[0][0], pixels[0][1])[2]) > 0;
        for (int k = 0; k < 3; ++k) {
            const auto& corner = pixels[as_given ? k : 2 - k];
            corners.push_back(number[static_cast<std::size_t>(corner[1] * width_ + corner[0])]);
        }
    };
    for (Index r = 0; r + 1 < height_; ++r)
        for (Index c = 0; c + 1 < width_; ++c) {
            add({{c, r}, {c, r + 1}, {c + 1, r}});
            add({{c + 1, r}, {c, r + 1}, {c + 1, r + 1}});
        }
    triangles.resize(static_cast<Index>(corners.size() / 3), 3);
    std::copy(corners.begin(), corners.end(), triangles.data());
}

}  // namespace mien
