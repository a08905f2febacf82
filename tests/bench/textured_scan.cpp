// A vertex-coloured scan becomes files of fewer vertices whose colours are in texture images:
// textured_scan SCAN.ply STEM NUM_VERTICES PIXEL_MM (NUM_VERTICES 0: all). Writes STEM.obj (two
// materials, two PNG images), STEM_jpeg.obj (one JPEG), STEM.glb, STEM_texture.ply, and
// STEM_vertex.ply, which has the colours at its vertices alone.
#include "textured_scan.hpp"

namespace {

using namespace mien;

void make(char** argv) {
    const Context context;
    const ColoredScan dense = read_colored(argv[1], context);
    const std::string stem = argv[2];
    const double pixel_mm = std::atof(argv[4]);
    const TriMesh form = form_of(dense, std::atol(argv[3]), context);
    write_mesh_file(stem + "_vertex.ply", with_vertex_colors(dense, form), context);
    const TriMesh two = with_images(dense, form, 2, pixel_mm);
    for (const char* end : {".obj", ".glb", "_texture.ply"})
        write_mesh_file(stem + end, two, context);
    write_mesh_file(stem + "_jpeg.obj", with_jpegs(with_images(dense, form, 1, pixel_mm)), context);
    std::printf("%lld vertices, %lld triangles, two images, the first of %lld x %lld pixels\n",
                static_cast<long long>(two.vertices.rows()),
                static_cast<long long>(two.triangles.rows()),
                static_cast<long long>(two.images[0]->width),
                static_cast<long long>(two.images[0]->height));
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
