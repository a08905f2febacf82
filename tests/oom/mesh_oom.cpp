// Every allocation of the file layer fails once: reading, cleaning, half edges, writing.
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "fail_nth.hpp"
#include "mesh/cleaning.hpp"
#include "mesh/dataset.hpp"
#include "mesh/half_edge.hpp"
#include "mesh/image.hpp"
#include "mesh/mesh_file.hpp"
#include "mesh/topology.hpp"
#include "unit/mesh/sample_images.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using mien::testing::ScratchFolder;

/// True for a result and for a clean out-of-memory error, false for any other one.
template <typename Call>
bool clean(Call&& call) {
    try {
        call();
        return true;
    } catch (const std::bad_alloc&) {
        return true;
    } catch (const Error& error) {
        return error.status() == Status::no_memory;
    }
}

/// The file's bytes without a byte of heap, so that they can be looked at while memory fails.
std::size_t read_into(const char* path, char* buffer, std::size_t capacity) {
    const bool armed = oom::control.armed.exchange(false);
    std::FILE* file = std::fopen(path, "rb");
    const std::size_t size = file == nullptr ? 0 : std::fread(buffer, 1, capacity, file);
    if (file != nullptr) std::fclose(file);
    oom::control.armed = armed;
    return size;
}

/// A textured mesh in each format that keeps images, and their decoders.
int sweep_textures() {
    const Context context;
    ScratchFolder folder;
    TriMesh mesh = mien::testing::colorful();
    for (const std::string& bytes :
         {mien::testing::sample_png(4, 3), mien::testing::sample_progressive_jpeg()}) {
        auto image = std::make_shared<TextureImage>();
        image->encoded = bytes;
        mesh.images.push_back(image);
    }
    mesh.materials.resize(2);
    mesh.materials[0].image = 0;
    mesh.materials[1].image = 1;
    mesh.triangle_materials = {0, 1, 1, 0};
    int failed = 0;
    for (const char* name : {"t.obj", "t.ply", "t.glb"}) {
        const std::string path = folder / name;
        write_mesh_file(path, mesh, context);
        oom::Sweep reading("read textured " + std::string(name));
        reading.run([&] { return clean([&] { read_mesh_file(path, context); }); });
        failed += reading.report();
        oom::Sweep writing("write textured " + std::string(name));
        writing.run([&] { return clean([&] { write_mesh_file(path, mesh, context); }); });
        failed += writing.report();
    }
    for (const auto& image : mesh.images) {
        if (!images_are_decoded()) break;
        oom::Sweep decoding("decode an image");
        decoding.run([&] { return clean([&] { decode_image(*image, context); }); });
        failed += decoding.report();
    }
    return failed;
}

}  // namespace

int main() {
    if (!oom::available()) {
        std::puts("the malloc family cannot be replaced in this build: skipped");
        return 0;
    }
    const Context context;
    ScratchFolder folder;
    const TriMesh mesh = mien::testing::colorful(), disc = mien::testing::grid(12);
    int failed = 0;

    for (const char* extension : {"ply", "obj", "stl", "off", "glb"}) {
        const std::string path = folder / (std::string("m.") + extension);
        write_mesh_file(path, mesh, context);
        oom::Sweep reading("read " + std::string(extension));
        reading.run([&] { return clean([&] { read_mesh_file(path, context); }); });
        failed += reading.report();

        // A failed write keeps the old bytes and leaves no temporary file behind.
        static char before[4096], after[4096];
        const std::size_t size = read_into(path.c_str(), before, sizeof before);
        oom::Sweep writing("write " + std::string(extension));
        writing.run([&] {
            const bool right = clean([&] { write_mesh_file(path, mesh, context); });
            return right && read_into(path.c_str(), after, sizeof after) == size &&
                   std::memcmp(before, after, size) == 0;
        });
        failed += writing.report();
        std::filesystem::remove(path);
        if (folder.num_entries() != 0) {
            std::puts("a temporary file was left behind");
            ++failed;
        }
    }

    failed += sweep_textures();

    const std::string path = folder / "set.safetensors";
    FaceDatasetWriter writer(mesh.triangles, 4, {"neutral", "smile"});
    writer.add(mesh.vertices, 0, 0);
    writer.add(mesh.vertices, 0, 1);
    oom::Sweep saving("save dataset");
    saving.run([&] { return clean([&] { writer.save(path, context); }); });
    failed += saving.report();
    oom::Sweep opening("open dataset");
    opening.run([&] { return clean([&] { FaceDataset::open(path, {}, context); }); });
    failed += opening.report();

    oom::Sweep cleaning("clean mesh");
    cleaning.run([&] { return clean([&] { clean_mesh(disc, {}, context); }); });
    failed += cleaning.report();
    oom::Sweep borders("borders");
    borders.run([&] {
        return clean([&] {
            const EdgeTable table = build_edge_table(disc.triangles, 144, context);
            border_loops(table, disc.triangles, 144);
        });
    });
    failed += borders.report();
    oom::Sweep half_edges("half edges");
    half_edges.run([&] { return clean([&] { build_half_edge_mesh(disc, "disc", context); }); });
    failed += half_edges.report();
    return failed == 0 ? 0 : 1;
}
