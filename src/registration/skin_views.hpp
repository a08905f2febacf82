// The skin as pictures that two visits share: orthographic views of the template at rest. A pixel
// is a place of the template, whoever's fit carries it, so that a slide between two fits is a move
// between two pictures of the same view, measured as any optical flow is.
//
// Views are chosen one by one from directions all around: each next one is that which looks most
// straight at most of the skin that none sees yet. A vertex is measured in the view that it faces
// most and is not hidden in.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct SkinViewSettings {
    double pixel_mm = 0.5;      ///< mm, > 0: half of a freckle [J]
    double full_cosine = 0.8;   ///< 0 to 1: skin that faces a view so needs no other [J]
    double least_cosine = 0.5;  ///< 0 to full_cosine: skin that faces a view less is not in it [J]
    double margin_mm = 10;      ///< mm, >= 0: of skin around a view's own vertices [J]
    double rest_share = 0.01;   ///< 0 to 1: of the skin that may stay without a view [J]
    int most_views = 8;         ///< >= 1 [J]
    int directions = 200;       ///< >= 1: that are tried [J]
    double most_pixels = 4e6;   ///< > 0: of one view; a larger template is refused
};

/// Pixel (column, row) is centred at (left + (column + 1/2) pixel, bottom + (row + 1/2) pixel) in
/// the plane of the first two axes; number row * width + column.
struct SkinView {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    Matrix3 axes = Matrix3::Identity();  ///< rows: right, up, towards the viewer
    double left_mm = 0, bottom_mm = 0, pixel_mm = 1;
    Index width = 0, height = 0;
    std::vector<std::uint32_t> triangle;  ///< of the template, kNone: nothing to measure
    std::vector<float> second, third;     ///< barycentric coordinates of its corners 1 and 2
    std::vector<std::uint32_t> vertices;  ///< that are measured in this view, ascending

    Index num_pixels() const { return width * height; }
    /// In pixels from the centre of the first one.
    Eigen::Vector2d pixel_of(const Vector3& place) const {
        return {(axes.row(0).dot(place) - left_mm) / pixel_mm - 0.5,
                (axes.row(1).dot(place) - bottom_mm) / pixel_mm - 0.5};
    }
    /// A field with a row for each vertex, at a pixel that has a triangle.
    Vector3 at(std::size_t pixel, const Triangles& triangles, const Points& field) const;
};

/// `open`: #V, 1 where skin is to be seen; only triangles whose corners all are get pixels, the
/// others hide what is behind them. Empty when no skin is open. Throws Status::invalid_mesh when a
/// view would have more pixels than settings allow (a template that is not in millimetres),
/// memory_budget, cancelled. O(directions #V + pixels).
std::vector<SkinView> look_at_skin(const TriMesh& template_mesh,
                                   const std::vector<std::uint8_t>& open,
                                   const SkinViewSettings& settings, const Context& context);

}  // namespace mien
