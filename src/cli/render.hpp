// A software renderer for people and reports: smooth-shaded orthographic views of a mesh, side by
// side, with vertex colours or a scalar as a heat map with its colour bar.
#pragma once

#include <array>
#include <limits>
#include <mien/mien.hpp>
#include <string>
#include <vector>

#include "image.hpp"

namespace mien::cli {

struct MeshArrays {
    std::vector<Position> positions;  ///< mm
    std::vector<Triangle> triangles;  ///< empty: a point cloud, drawn as dots
    std::vector<Color> colors;        ///< per vertex, or empty
};
MeshArrays arrays_of(const Mesh& mesh);

enum class ColorMap {
    sequential,  ///< dark to bright, perceptually uniform
    diverging    ///< blue - white - red; the range is made symmetric when not given
};
/// Colour at t in 0..1; not a number gives grey.
Rgb map_color(ColorMap map, double t);

struct RenderOptions {
    std::vector<std::string> views{"front", "left45", "left"};  ///< see view_names()
    int size = 480;              ///< pixels, height of a view, 32 to 4096
    std::vector<double> scalar;  ///< per vertex, or empty; not-a-number: no value, grey
    ColorMap color_map = ColorMap::sequential;
    double low =
        std::numeric_limits<double>::quiet_NaN();  ///< of the colour bar; NaN: from the data
    double high = std::numeric_limits<double>::quiet_NaN();
    std::string label;             ///< under the colour bar, e.g. "distance, mm"
    std::string title;             ///< above the views
    bool use_colors = true;        ///< vertex colours, when there are any and no scalar
    bool color_bar = true;         ///< beside the views, when there is a scalar
    std::vector<Position> points;  ///< drawn as dots on top, e.g. landmarks
    /// Pairs of vertices, drawn as dark lines where they are seen, e.g. the rim of a zone.
    std::vector<std::array<std::uint32_t, 2>> lines;
    /// Another mesh whose bounding box sets the camera, so that pictures can be compared.
    const MeshArrays* framing = nullptr;
};

/// front, left, right, left45, right45, back, top; left shows the subject's left side. An angle in
/// degrees is also a view.
std::vector<std::string> view_names();

/// Throws std::invalid_argument for an unknown view, a size out of range, an empty mesh or a scalar
/// of another length.
Image render_mesh(const MeshArrays& mesh, const RenderOptions& options);

/// Pictures below one another or side by side on white.
Image stack_images(const std::vector<Image>& images, bool sideways);

}  // namespace mien::cli
