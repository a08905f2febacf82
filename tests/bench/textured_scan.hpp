// A vertex-coloured scan becomes one whose colours are in texture images, as scanners export it.
//
// The atlas gives each pair of triangles a square cell; each pixel shows the scan's colour nearest
// to its place on the surface, also in the margin, so that bilinear looks find no seam.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <jpeglib.h>

#include "base/error.hpp"
#include "mesh/cleaning.hpp"
#include "mesh/decimation.hpp"
#include "mesh/manifold.hpp"
#include "mesh/mesh_file.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {

inline Vector3 color_near(const TriMesh& dense, const TriangleTree& tree, const Vector3& place) {
    const SurfaceHit hit = tree.closest(place);
    Vector3 color = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
        color += hit.barycentric[k] *
                 dense.colors.row(static_cast<Index>(dense.triangles(hit.triangle, k)))
                     .cast<double>()
                     .transpose();
    return color;
}

/// Corners of the lower and the upper triangle of a cell of `side` pixels, in pixels from its lower
/// left corner; two pixels lie between their long sides.
inline void cell_corners(bool upper, double side, double (&x)[3], double (&y)[3]) {
    const double low = upper ? side - 1.5 : 1.5, far = upper ? 3.5 : side - 3.5;
    const double xs[3] = {low, far, low}, ys[3] = {low, low, far};
    std::copy(xs, xs + 3, x);
    std::copy(ys, ys + 3, y);
}

/// Numbers of the triangles of one image. `color_at(triangle, place)`: red green blue, 0 to 255.
template <typename ColorAt>
void paint(TriMesh& mesh, const std::vector<Index>& numbers, const ColorAt& color_at, Index side) {
    const Index cells = (static_cast<Index>(numbers.size()) + 1) / 2;
    const Index columns = std::max<Index>(1, static_cast<Index>(std::ceil(std::sqrt(cells))));
    auto image = std::make_shared<TextureImage>();
    image->name = "part" + std::to_string(mesh.images.size() + 1) + ".png";
    image->width = columns * side;
    image->height = std::max<Index>(1, (cells + columns - 1) / columns) * side;
    image->pixels.assign(static_cast<std::size_t>(3 * image->width * image->height), 0);
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        const Index t = numbers[n], cell = static_cast<Index>(n / 2);
        const Index left = cell % columns * side, bottom = cell / columns * side;
        const bool upper = n % 2 == 1;
        double x[3], y[3];
        cell_corners(upper, static_cast<double>(side), x, y);
        Vector3 corner[3];
        for (int k = 0; k < 3; ++k) {
            corner[k] = mesh.vertices.row(static_cast<Index>(mesh.triangles(t, k)));
            mesh.texture.row(3 * t + k) << static_cast<float>((static_cast<double>(left) + x[k]) /
                                                              static_cast<double>(image->width)),
                static_cast<float>((static_cast<double>(bottom) + y[k]) /
                                   static_cast<double>(image->height));
            mesh.texture_triangles(t, k) = static_cast<std::uint32_t>(3 * t + k);
        }
        for (Index py = 0; py < side; ++py)
            for (Index px = 0; px < side; ++px) {
                if ((px + py >= side) != upper) continue;
                const double b = (static_cast<double>(px) + 0.5 - x[0]) / (x[1] - x[0]);
                const double c = (static_cast<double>(py) + 0.5 - y[0]) / (y[2] - y[0]);
                const Vector3 place =
                    corner[0] + b * (corner[1] - corner[0]) + c * (corner[2] - corner[0]);
                const Vector3 color = color_at(t, place);
                const Index row = image->height - 1 - (bottom + py);
                for (int k = 0; k < 3; ++k)
                    image->pixels[static_cast<std::size_t>(3 * (row * image->width + left + px) +
                                                           k)] =
                        static_cast<std::uint8_t>(std::clamp(color[k] + 0.5, 0.0, 255.0));
            }
    }
    mesh.images.push_back(image);
}

/// The coloured scan, cleaned; its tree.
struct ColoredScan {
    TriMesh mesh;
    TriangleTree tree;
};

inline ColoredScan read_colored(const std::string& path, const Context& context) {
    ColoredScan scan;
    scan.mesh = clean_mesh(read_mesh_file(path, context), {}, context).mesh;
    if (scan.mesh.colors.rows() == 0) fail(Status::invalid_mesh, "the scan has no vertex colours");
    scan.tree = TriangleTree(scan.mesh.vertices, scan.mesh.triangles, context);
    return scan;
}

/// The form with `num_vertices` (0: as it is), without colours.
inline TriMesh form_of(const ColoredScan& dense, Index num_vertices, const Context& context) {
    TriMesh mesh;
    mesh.vertices = dense.mesh.vertices;
    mesh.triangles = dense.mesh.triangles;
    if (num_vertices != 0)
        mesh = decimate(make_manifold(mesh, context).mesh, num_vertices, context).mesh;
    return mesh;
}

/// The same with the scan's colours at its vertices.
inline TriMesh with_vertex_colors(const ColoredScan& dense, TriMesh mesh) {
    mesh.colors.resize(mesh.vertices.rows(), 3);
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        const Vector3 color =
            color_near(dense.mesh, dense.tree, Vector3(mesh.vertices.row(v).transpose())).array() +
            0.5;
        mesh.colors.row(v) = color.transpose().cwiseMin(255.0).cast<std::uint8_t>();
    }
    return mesh;
}

/// `mesh` with colours in `parts` images, each of a material of its own. `pixel_mm`: how much of
/// the surface a pixel shows.
template <typename ColorAt>
TriMesh with_colors_in_images(TriMesh mesh, int parts, double pixel_mm, const ColorAt& color_at) {
    std::vector<double> edges;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            edges.push_back((mesh.vertices.row(mesh.triangles(t, k)) -
                             mesh.vertices.row(mesh.triangles(t, (k + 1) % 3)))
                                .norm());
    std::sort(edges.begin(), edges.end());
    const double edge_mm = edges[edges.size() * 9 / 10];
    const Index side = 7 + static_cast<Index>(std::ceil(edge_mm / pixel_mm));
    mesh.texture.resize(3 * mesh.triangles.rows(), 2);
    mesh.texture_triangles.resize(mesh.triangles.rows(), 3);
    mesh.materials.resize(static_cast<std::size_t>(parts));
    mesh.triangle_materials.resize(static_cast<std::size_t>(mesh.triangles.rows()));
    std::vector<std::vector<Index>> numbers(static_cast<std::size_t>(parts));
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const std::size_t part = static_cast<std::size_t>(t * parts / mesh.triangles.rows());
        numbers[part].push_back(t);
        mesh.triangle_materials[static_cast<std::size_t>(t)] = static_cast<std::uint32_t>(part);
    }
    for (int part = 0; part < parts; ++part) {
        mesh.materials[static_cast<std::size_t>(part)].name = "part " + std::to_string(part + 1);
        mesh.materials[static_cast<std::size_t>(part)].image = part;
        paint(mesh, numbers[static_cast<std::size_t>(part)], color_at, side);
    }
    return mesh;
}

/// The same with the scan's own colours.
inline TriMesh with_images(const ColoredScan& dense, const TriMesh& mesh, int parts,
                           double pixel_mm) {
    return with_colors_in_images(mesh, parts, pixel_mm, [&](Index, const Vector3& place) {
        return color_near(dense.mesh, dense.tree, place);
    });
}

/// The pixels as a JPEG file of usual quality. An error of libjpeg's ends the program.
inline std::string jpeg_of(const TextureImage& image) {
    constexpr int kQuality = 92;
    jpeg_compress_struct info;
    jpeg_error_mgr errors;
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &bytes, &size);
    info.image_width = static_cast<JDIMENSION>(image.width);
    info.image_height = static_cast<JDIMENSION>(image.height);
    info.input_components = 3;
    info.in_color_space = JCS_RGB;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, kQuality, TRUE);
    jpeg_start_compress(&info, TRUE);
    while (info.next_scanline < info.image_height) {
        JSAMPROW row = const_cast<JSAMPROW>(
            image.pixels.data() + 3 * info.next_scanline * static_cast<std::size_t>(image.width));
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    std::string file(reinterpret_cast<const char*>(bytes), size);
    jpeg_destroy_compress(&info);
    std::free(bytes);
    return file;
}

/// Each image as a JPEG in place of its pixels.
inline TriMesh with_jpegs(TriMesh mesh) {
    for (auto& image : mesh.images) {
        auto packed = std::make_shared<TextureImage>();
        packed->name = image->name.substr(0, image->name.rfind('.')) + ".jpg";
        packed->encoded = jpeg_of(*image);
        image = packed;
    }
    return mesh;
}

}  // namespace mien
