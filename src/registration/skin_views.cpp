#include "registration/skin_views.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "base/error.hpp"
#include "base/scalar_math.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

// Evenly around (Fibonacci's spiral).
Vector3 direction_of(int number, int count) {
    const double golden_rad = kPi * (3 - std::sqrt(5.0));
    const double up = 1 - 2 * (number + 0.5) / count;
    const double out = std::sqrt(1 - up * up), turn_rad = golden_rad * number;
    return {out * std::cos(turn_rad), up, out * std::sin(turn_rad)};
}

// Up in the picture is the template's y as far as that can be.
Matrix3 axes_of(const Vector3& towards) {
    Vector3 up = Vector3::UnitY() - towards.y() * towards;
    if (up.norm() < 0.1) up = Vector3::UnitX() - towards.x() * towards;
    up.normalize();
    Matrix3 axes;
    axes << up.cross(towards).transpose(), up.transpose(), towards.transpose();
    return axes;
}

std::vector<Vector3> choose_directions(const Points& normals, const Vector& area,
                                       const SkinViewSettings& settings) {
    Vector left = area;
    const double enough = settings.rest_share * area.sum();
    std::vector<Vector3> chosen;
    while (static_cast<int>(chosen.size()) < settings.most_views && left.sum() > enough) {
        double best = 0;
        Vector3 next = Vector3::Zero();
        for (int d = 0; d < settings.directions; ++d) {
            const Vector3 direction = direction_of(d, settings.directions);
            double seen = 0;
            for (Index v = 0; v < left.size(); ++v) {
                if (!(left[v] > 0)) continue;
                const double cosine = normals.row(v).dot(direction.transpose());
                if (cosine > settings.full_cosine) seen += left[v] * cosine * cosine;
            }
            if (seen > best) {
                best = seen;
                next = direction;
            }
        }
        if (!(best > 0)) break;
        chosen.push_back(next);
        for (Index v = 0; v < left.size(); ++v)
            if (normals.row(v).dot(next.transpose()) > settings.full_cosine) left[v] = 0;
    }
    return chosen;
}

// Where the skin that faces the view lies; false when none does.
bool frame_view(const Points& places, const Points& normals, const std::vector<std::uint8_t>& open,
                const SkinViewSettings& settings, SkinView& view) {
    Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()),
                   high = -low;
    for (Index v = 0; v < places.rows(); ++v) {
        if (!open[static_cast<std::size_t>(v)] ||
            normals.row(v).dot(view.axes.row(2)) < settings.least_cosine)
            continue;
        const Eigen::Array2d at(view.axes.row(0).dot(places.row(v)),
                                view.axes.row(1).dot(places.row(v)));
        low = low.min(at);
        high = high.max(at);
    }
    if (!(low <= high).all()) return false;
    // Even numbers of pixels, so that a picture of half the resolution covers the same.
    const double pixel = settings.pixel_mm;
    const Eigen::Array2d size = ((high - low) / (2 * pixel)).floor() + 2;
    if (!(4 * size[0] * size[1] <= settings.most_pixels))
        fail(Status::invalid_mesh,
             "texture: a view of the template would have %.3g x %.3g pixels of %g mm; is the "
             "template in millimetres?",
             2 * size[0], 2 * size[1], pixel);
    view.left_mm = low[0] - pixel;
    view.bottom_mm = low[1] - pixel;
    view.pixel_mm = pixel;
    view.width = 2 * static_cast<Index>(size[0]);
    view.height = 2 * static_cast<Index>(size[1]);
    return true;
}

class Painter {
  public:
    Painter(const TriMesh& mesh, const std::vector<std::uint8_t>& open, double least_cosine,
            SkinView& view)
        : mesh_(mesh),
          open_(open),
          least_cosine_(least_cosine),
          view_(view),
          depth_(static_cast<std::size_t>(view.num_pixels()),
                 -std::numeric_limits<float>::infinity()) {
        view.triangle.assign(depth_.size(), SkinView::kNone);
        view.second.assign(depth_.size(), 0);
        view.third.assign(depth_.size(), 0);
        for (Index t = 0; t < mesh.triangles.rows(); ++t) paint(t);
    }

    /// Is a place of the template the nearest to the viewer at its pixel?
    bool sees(const Vector3& place) const {
        constexpr double kBehind_mm = 1;  // a pixel's slope
        const Eigen::Vector2d at = view_.pixel_of(place);
        const Index x = static_cast<Index>(std::lround(at[0])),
                    y = static_cast<Index>(std::lround(at[1]));
        if (x < 0 || y < 0 || x >= view_.width || y >= view_.height) return false;
        const std::size_t pixel = static_cast<std::size_t>(y * view_.width + x);
        return view_.triangle[pixel] != SkinView::kNone &&
               view_.axes.row(2).dot(place) > static_cast<double>(depth_[pixel]) - kBehind_mm;
    }

  private:
    void paint(Index t) {
        Vector3 place[3];
        Eigen::Vector2d at[3];
        bool is_open = true;
        for (int k = 0; k < 3; ++k) {
            const std::size_t v = mesh_.triangles(t, k);
            place[k] = mesh_.vertices.row(static_cast<Index>(v));
            at[k] = view_.pixel_of(place[k]);
            is_open = is_open && open_[v];
        }
        const Vector3 normal = (place[1] - place[0]).cross(place[2] - place[0]);
        const double facing = view_.axes.row(2).dot(normal);
        if (!(facing > 0)) return;
        is_open = is_open && facing > least_cosine_ * normal.norm();
        const Eigen::Vector2d b = at[1] - at[0], c = at[2] - at[0];
        const double area = b[0] * c[1] - b[1] * c[0];
        if (!(area > 0)) return;
        const auto range = [&](int axis, Index size) {
            const auto [low, high] = std::minmax({at[0][axis], at[1][axis], at[2][axis]});
            const double last = static_cast<double>(size - 1);
            return std::pair<Index, Index>(
                static_cast<Index>(std::ceil(std::clamp(low, 0.0, last + 1))),
                static_cast<Index>(std::floor(std::clamp(high, -1.0, last))));
        };
        const auto [x0, x1] = range(0, view_.width);
        const auto [y0, y1] = range(1, view_.height);
        for (Index y = y0; y <= y1; ++y)
            for (Index x = x0; x <= x1; ++x) {
                const Eigen::Vector2d p =
                    Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y)) - at[0];
                const double second = (p[0] * c[1] - p[1] * c[0]) / area;
                const double third = (b[0] * p[1] - b[1] * p[0]) / area;
                if (second < 0 || third < 0 || second + third > 1) continue;
                const float depth = static_cast<float>(view_.axes.row(2).dot(
                    place[0] + second * (place[1] - place[0]) + third * (place[2] - place[0])));
                const std::size_t pixel = static_cast<std::size_t>(y * view_.width + x);
                if (!(depth > depth_[pixel])) continue;
                depth_[pixel] = depth;
                view_.triangle[pixel] = is_open ? static_cast<std::uint32_t>(t) : SkinView::kNone;
                view_.second[pixel] = static_cast<float>(second);
                view_.third[pixel] = static_cast<float>(third);
            }
    }

    const TriMesh& mesh_;
    const std::vector<std::uint8_t>& open_;
    double least_cosine_;
    SkinView& view_;
    std::vector<float> depth_;
};

// Empties pixels that are far from the view's own vertices: another view has them.
void keep_near(const Points& places, double margin_mm, SkinView& view) {
    const Index reach = static_cast<Index>(std::ceil(margin_mm / view.pixel_mm));
    const std::size_t columns = static_cast<std::size_t>(view.width + 1);
    // Corners of the squares around the vertices; sums of them count the squares over a pixel.
    std::vector<std::int32_t> count(columns * static_cast<std::size_t>(view.height + 1), 0);
    for (const std::uint32_t v : view.vertices) {
        const Eigen::Vector2d at = view.pixel_of(places.row(v));
        const Index x = static_cast<Index>(std::lround(at[0])),
                    y = static_cast<Index>(std::lround(at[1]));
        const auto clip = [](Index value, Index most) {
            return static_cast<std::size_t>(std::clamp<Index>(value, 0, most));
        };
        const std::size_t x0 = clip(x - reach, view.width), x1 = clip(x + reach + 1, view.width);
        const std::size_t y0 = clip(y - reach, view.height), y1 = clip(y + reach + 1, view.height);
        ++count[y0 * columns + x0];
        --count[y0 * columns + x1];
        --count[y1 * columns + x0];
        ++count[y1 * columns + x1];
    }
    for (std::size_t y = 0; y < static_cast<std::size_t>(view.height); ++y)
        for (std::size_t x = 0; x < static_cast<std::size_t>(view.width); ++x) {
            std::int32_t& here = count[y * columns + x];
            if (x > 0) here += count[y * columns + x - 1];
            if (y > 0) here += count[(y - 1) * columns + x];
            if (x > 0 && y > 0) here -= count[(y - 1) * columns + x - 1];
            if (here == 0)
                view.triangle[y * static_cast<std::size_t>(view.width) + x] = SkinView::kNone;
        }
}

}  // namespace

Vector3 SkinView::at(std::size_t pixel, const Triangles& triangles, const Points& field) const {
    const auto corner = triangles.row(static_cast<Index>(triangle[pixel]));
    const double b = static_cast<double>(second[pixel]), c = static_cast<double>(third[pixel]);
    return ((1 - b - c) * field.row(corner[0]) + b * field.row(corner[1]) +
            c * field.row(corner[2]))
        .transpose();
}

std::vector<SkinView> look_at_skin(const TriMesh& template_mesh,
                                   const std::vector<std::uint8_t>& open,
                                   const SkinViewSettings& settings, const Context& context) {
    const Points& places = template_mesh.vertices;
    const Points normals = vertex_normals(places, template_mesh.triangles);
    const Points facets = triangle_normals(places, template_mesh.triangles);
    Vector area = Vector::Zero(places.rows());
    for (Index t = 0; t < facets.rows(); ++t)
        for (int k = 0; k < 3; ++k) area[template_mesh.triangles(t, k)] += facets.row(t).norm();
    for (Index v = 0; v < area.size(); ++v)
        if (!open[static_cast<std::size_t>(v)]) area[v] = 0;
    std::vector<SkinView> views;
    std::vector<double> best(open.size(), settings.least_cosine);
    std::vector<std::size_t> view_of(open.size(), open.size());
    for (const Vector3& direction : choose_directions(normals, area, settings)) {
        context.check_cancelled();
        SkinView view;
        view.axes = axes_of(direction);
        if (!frame_view(places, normals, open, settings, view)) continue;
        context.require_memory(static_cast<std::size_t>(view.num_pixels()) * 16,
                               "views of the skin");
        const Painter painter(template_mesh, open, settings.least_cosine, view);
        for (std::size_t v = 0; v < open.size(); ++v) {
            const Index row = static_cast<Index>(v);
            const double cosine = normals.row(row).dot(direction.transpose());
            if (!open[v] || cosine <= best[v] || !painter.sees(places.row(row))) continue;
            best[v] = cosine;
            view_of[v] = views.size();
        }
        views.push_back(std::move(view));
    }
    for (std::size_t v = 0; v < open.size(); ++v)
        if (view_of[v] < views.size())
            views[view_of[v]].vertices.push_back(static_cast<std::uint32_t>(v));
    for (SkinView& view : views) keep_near(places, settings.margin_mm, view);
    return views;
}

}  // namespace mien
