// A vertex-coloured scan becomes one of fewer vertices whose colours are in texture images, as
// scanners export it: textured_scan SCAN.ply STEM NUM_VERTICES PIXEL_MM (NUM_VERTICES 0: all).
// Writes STEM.obj (two materials, two PNG images), STEM.glb, STEM_texture.ply, and
// STEM_vertex.ply, which has the colours at its vertices alone.
//
// The atlas gives each pair of triangles a square cell; each pixel shows the scan's colour nearest
// to its place on the surface, also in the margin, so that bilinear looks find no seam.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <Eigen/Geometry>
#include <string>

#include "base/error.hpp"
#include "mesh/cleaning.hpp"
#include "mesh/decimation.hpp"
#include "mesh/mesh_file.hpp"
#include "spatial/triangle_tree.hpp"

namespace {

using namespace mien;

Vector3 color_near(const TriMesh& dense, const TriangleTree& tree, const Vector3& place) {
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
void cell_corners(bool upper, double side, double (&x)[3], double (&y)[3]) {
    const double low = upper ? side - 1.5 : 1.5, far = upper ? 3.5 : side - 3.5;
    const double xs[3] = {low, far, low}, ys[3] = {low, low, far};
    std::copy(xs, xs + 3, x);
    std::copy(ys, ys + 3, y);
}

/// Numbers of the triangles of one image.
void paint(TriMesh& mesh, const std::vector<Index>& numbers, const TriMesh& dense,
           const TriangleTree& tree, Index side) {
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
                const Vector3 color = color_near(dense, tree, place);
                const Index row = image->height - 1 - (bottom + py);
                for (int k = 0; k < 3; ++k)
                    image->pixels[static_cast<std::size_t>(3 * (row * image->width + left + px) +
                                                           k)] =
                        static_cast<std::uint8_t>(std::min(color[k] + 0.5, 255.0));
            }
    }
    mesh.images.push_back(image);
}

void make(char** argv) {
    const Context context;
    const TriMesh dense = clean_mesh(read_mesh_file(argv[1], context), {}, context).mesh;
    if (dense.colors.rows() == 0) fail(Status::invalid_mesh, "the scan has no vertex colours");
    const TriangleTree tree(dense.vertices, dense.triangles, context);
    const Index wanted = std::atol(argv[3]);
    const double pixel_mm = std::atof(argv[4]);
    TriMesh mesh;
    mesh.vertices = dense.vertices;
    mesh.triangles = dense.triangles;
    if (wanted != 0) mesh = decimate(dense, wanted, context).mesh;

    TriMesh plain = mesh;
    plain.colors.resize(plain.vertices.rows(), 3);
    for (Index v = 0; v < plain.vertices.rows(); ++v) {
        const Vector3 color =
            color_near(dense, tree, Vector3(plain.vertices.row(v).transpose())).array() + 0.5;
        plain.colors.row(v) = color.transpose().cwiseMin(255.0).cast<std::uint8_t>();
    }
    const std::string stem = argv[2];
    write_mesh_file(stem + "_vertex.ply", plain, context);

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
    mesh.materials.resize(2);
    mesh.triangle_materials.resize(static_cast<std::size_t>(mesh.triangles.rows()));
    std::vector<Index> numbers[2];
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const int part = t < mesh.triangles.rows() / 2 ? 0 : 1;
        numbers[part].push_back(t);
        mesh.triangle_materials[static_cast<std::size_t>(t)] = static_cast<std::uint32_t>(part);
    }
    for (int part = 0; part < 2; ++part) {
        mesh.materials[static_cast<std::size_t>(part)].name = "part " + std::to_string(part + 1);
        mesh.materials[static_cast<std::size_t>(part)].image = part;
        paint(mesh, numbers[part], dense, tree, side);
    }
    for (const char* end : {".obj", ".glb", "_texture.ply"})
        write_mesh_file(stem + end, mesh, context);
    std::printf("%lld vertices, %lld triangles, two images, the first of %lld x %lld pixels\n",
                static_cast<long long>(mesh.vertices.rows()),
                static_cast<long long>(mesh.triangles.rows()),
                static_cast<long long>(mesh.images[0]->width),
                static_cast<long long>(mesh.images[0]->height));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::printf("textured_scan SCAN.ply STEM NUM_VERTICES PIXEL_MM\n");
        return 2;
    }
    try {
        make(argv);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
