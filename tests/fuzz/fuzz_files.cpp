// Feeds damaged files to every reader: fuzz_files [iterations] [seed]. An Error or a result that
// passes its check is right; anything else, and any allocation out of proportion to the file, is a
// fault. The damaged file of a fault is written to the working folder.
//   fuzz_files seeds FOLDER   writes the good files to FOLDER/KIND
// Compiled with MIEN_FUZZER it is driven by libFuzzer, and reads what the end of its name says:
// libfuzz_ply, libfuzz_landmarks.pts (tests/fuzz/run.sh makes the links).
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/safetensors.hpp"
#include "fuzz/mutate.hpp"
#include "mesh/cleaning.hpp"
#include "mesh/dataset.hpp"
#include "mesh/gltf.hpp"
#include "mesh/image.hpp"
#include "mesh/landmark_file.hpp"
#include "mesh/material_library.hpp"
#include "mesh/mesh_file.hpp"
#include "mesh/topology.hpp"
#include "mesh/zone_file.hpp"
#include "oom/fail_nth.hpp"
#include "unit/mesh/sample_images.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

/// Readers hold a file's counts against its size: no request may exceed this many times the size.
constexpr std::size_t kProportion = 40, kAllowance = 1 << 16;

struct Seed {
    std::string kind, bytes;
};

void add_text_seeds(std::vector<Seed>& seeds) {
    seeds.push_back({"xyz", "X Y Z\n0 0 0 255 0 1\n1.5 -2e1 3 7 8 9\n"});
    seeds.push_back(
        {"vtk",
         "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 1 1 "
         "0 0 1 0\nPOLYGONS 2 8\n3 0 1 2 3 0 2 3\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\nPOINT_DATA 4\n"
         "SCALARS c unsigned_char 3\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8 9 10 11 12\n"
         "TEXTURE_COORDINATES t 2 float\n0 0 1 0 1 1 0 1\nFIELD f 1\na 1 4 int\n1 2 3 4\n"});
    std::string binary =
        "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n";
    binary += std::string(30, '\0') + std::string("\x3f\x80\0\0\0\0", 6);
    binary += "\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n" + std::string(15, '\0') +
              "\3\nCONNECTIVITY vtktypeint64\n" + std::string(15, '\0') + '\1' +
              std::string(7, '\0') + "\2\n";
    seeds.push_back({"vtk", binary});
    seeds.push_back(
        {"vtp",
         "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" "
         "compressor=\"vtkZLibDataCompressor\"><PolyData><Piece NumberOfPoints=\"1\">"
         "<PointData Scalars=\"c\"><DataArray type=\"UInt8\" Name=\"c\" "
         "NumberOfComponents=\"3\" format=\"binary\">AQAAAAMAAAADAAAACwAAAA==eJxjZGIGAAAOAAc="
         "</DataArray></PointData><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
         "format=\"ascii\">1 2 3</DataArray></Points></Piece></PolyData></VTKFile>"});
    std::string appended =
        "<VTKFile type=\"PolyData\" header_type=\"UInt64\"><PolyData><Piece "
        "NumberOfPoints=\"3\"><Points><DataArray type=\"UInt8\" format=\"appended\" "
        "offset=\"0\"/></Points><Polys><DataArray type=\"Int8\" Name=\"connectivity\" "
        "format=\"appended\" offset=\"17\"/><DataArray type=\"Int8\" Name=\"offsets\" "
        "format=\"appended\" offset=\"28\"/></Polys></Piece></PolyData><AppendedData "
        "encoding=\"raw\">_";
    appended += std::string("\x09\0\0\0\0\0\0\0\0\0\0\1\0\0\0\1\0", 17);
    appended += std::string("\3\0\0\0\0\0\0\0\0\1\2\1\0\0\0\0\0\0\0\3", 20);
    seeds.push_back({"vtp", appended + "</AppendedData></VTKFile>"});
    seeds.push_back(
        {"gltf",
         "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,"
         "\"rotation\":[0,0,1,0],\"scale\":[1,-1,2],\"children\":[1]},{\"matrix\":[1,0,0,0,0,1,0,0,"
         "0,0,1,0,5,6,7,1],\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{"
         "\"POSITION\":0},\"mode\":5,\"targets\":[{\"POSITION\":0}]}]}],\"accessors\":[{"
         "\"bufferView\":0,\"componentType\":5120,\"count\":4,\"type\":\"VEC3\",\"sparse\":{"
         "\"count\":1,\"indices\":{\"bufferView\":0,\"componentType\":5121},\"values\":{"
         "\"bufferView\":0}}}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":12}],\"buffers\":[{"
         "\"byteLength\":12,\"uri\":\"data:x;base64,AAECAwQFBgcICQoL\"}]}"});
}

/// Images, a material library beside an OBJ, and a GLB with an image inside.
void add_image_seeds(std::vector<Seed>& seeds, const ScratchFolder& folder) {
    seeds.push_back({"image", sample_png(5, 3)});
    seeds.push_back({"image", sample_jpeg()});
    seeds.push_back({"image", sample_progressive_jpeg()});
    seeds.push_back(
        {"mtl", "newmtl a b\nKd 1 .5 0\nmap_Kd -s 1 1 1 -clamp on a b.png\nnewmtl c\n"});
    TriMesh mesh = colorful();
    auto image = std::make_shared<TextureImage>();
    image->encoded = sample_png(2, 2);
    mesh.images.push_back(image);
    mesh.materials.resize(2);
    mesh.materials[1].image = 0;
    mesh.triangle_materials = {0, 1, 1, 0};
    write_mesh_file(folder / "textured.glb", mesh, Context());
    seeds.push_back({"glb", read_bytes(folder / "textured.glb")});
}

std::vector<Seed> make_seeds() {
    const Context context;
    ScratchFolder folder;
    std::vector<Seed> seeds;
    for (const char* kind : {"ply", "obj", "stl", "off", "glb"})
        for (int k = 0; k < 2; ++k) {
            const std::string path = folder / (std::string("m.") + kind);
            write_mesh_file(path, k == 0 ? colorful() : grid(4), context);
            seeds.push_back({kind, read_bytes(path)});
        }
    seeds.push_back(
        {"ply",
         "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty double y\n"
         "property float z\nproperty float red\nproperty float green\nproperty float blue\n"
         "property float s\nproperty float t\nelement face 2\nproperty list uchar int "
         "vertex_indices\nproperty list uchar float texcoord\nproperty int flags\nelement "
         "tristrips "
         "1\nproperty list int int vertex_indices\nend_header\n0 0 0 1 0 0 0 0\n1 0 0 0 .5 0 1 0\n"
         "1 1 0 0 0 1 1 1\n0 1 0 0 0 0 0 1\n4 0 1 2 3 8 0 0 1 0 1 1 0 1 7\n3 0 1 2 0 9\n"
         "6 0 1 2 3 -1 0\n"});
    std::string big =
        "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty short x\nproperty char y\n"
        "property double z\nproperty list uchar ushort junk\nelement face 1\n"
        "property list uint short vertex_index\nend_header\n";
    big += std::string("\0\1\2\0\0\0\0\0\0\0\0\1\0\5\0\0\0\3\0\0\0\0\0\0", 24);
    seeds.push_back({"ply", big});
    seeds.push_back({"obj",
                     "# c\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nvt 0 0\nvt 1 0\nvn 0 0 1\n"
                     "g a\nf 1/1/1 2/2/1 3/1/1\nf -3//1 -2//1 -1//1\nf 1 2 \\\n3\n"});
    seeds.push_back({"stl",
                     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                     "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"});
    seeds.push_back({"off",
                     "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 10 255 .5 .25\n1 0 0 0 0 1 1 2 3 255 "
                     "1 0\n0 1 0 0 0 1 4 5 6 255 0 1\n3 0 1 2 1 0 0\n"});
    std::string binary = "OFF BINARY\n";
    for (std::uint32_t word :
         {3u, 1u, 0u, 0u, 0u, 0u, 0x3f800000u, 0u, 0u, 0u, 0x3f800000u, 0u, 3u, 0u, 1u, 2u, 0u})
        for (int shift = 24; shift >= 0; shift -= 8) binary += static_cast<char>(word >> shift);
    seeds.push_back({"off", binary});

    for (const char* kind : {"json", "mrk.json", "fcsv", "pp", "pts", "ljson", "csv"}) {
        LandmarkFile marks;
        marks.marks = {{"a", Mark::Where::place, Vector3(1.5, -2, 3e-4), 0},
                       {"b, \"c\"", Mark::Where::not_picked, Vector3::Zero(), 0},
                       {"68", Mark::Where::place, Vector3(4, 5, 6), 0}};
        const std::string path = folder / (std::string("l.") + kind);
        write_landmark_file(path, marks);
        seeds.push_back({std::string("landmarks.") + kind, read_bytes(path)});
    }
    seeds.push_back({"zones", "{\"note\": 1, \"zones\": {\"a\": [1, 2]}, \"lips\": [3]}"});

    add_text_seeds(seeds);
    add_image_seeds(seeds, folder);
    FaceDatasetWriter writer(tetrahedron().triangles, 4, {"neutral", "smile"});
    writer.add(tetrahedron().vertices, 0, 0);
    writer.add(tetrahedron().vertices, 1, 1);
    writer.save(folder / "set", context);
    seeds.push_back({"safetensors", read_bytes(folder / "set")});
    return seeds;
}

void use_mesh(const TriMesh& mesh) {
    check_mesh(mesh, "read");
    const Context context;
    const CleanedMesh cleaned = clean_mesh(mesh, {}, context);
    check_mesh(cleaned.mesh, "cleaned");
    const EdgeTable table =
        build_edge_table(cleaned.mesh.triangles, cleaned.mesh.vertices.rows(), context);
    border_loops(table, cleaned.mesh.triangles, cleaned.mesh.vertices.rows());
    inspect_topology(table, cleaned.mesh.triangles, cleaned.mesh.vertices.rows());
}

/// Every byte that a tensor claims must be there.
void use_tensors(const SafetensorsFile& file) {
    unsigned sum = 0;
    for (const auto& entry : file.tensors()) {
        const auto* bytes = static_cast<const unsigned char*>(entry.second.data);
        const std::uint64_t size = entry.second.count * dtype_bytes(entry.second.dtype);
        for (std::uint64_t i = 0; i < size; ++i) sum += bytes[i];
    }
    volatile unsigned kept = sum;
    (void)kept;
}

/// The reader of morph targets throws what it has to say; what it returns must fit its mesh.
void read_targets(const char* data, std::size_t size, const Context& context) {
    formats::Source source;
    source.bytes.data = data;
    source.bytes.size = size;
    std::vector<MorphTarget> targets;
    const TriMesh mesh = formats::read_gltf_document(source, &targets, context);
    for (const MorphTarget& target : targets)
        if (target.offsets.rows() != mesh.vertices.rows())
            throw std::runtime_error("a morph target of another number of vertices");
}

long num_read = 0;

/// Empty when all is right.
std::string feed(const std::string& kind, const char* data, std::size_t size,
                 const std::string& path) {
    const Context context;
    try {
        if (kind == "safetensors") {
            SafetensorsReadOptions trusting;
            trusting.verify_hash = false;
            use_tensors(SafetensorsFile::from_memory(data, size, trusting, context));
            write_bytes(path, std::string(data, size));
            const FaceDataset set = FaceDataset::open(path, trusting, context);
            Points face;
            set.face(set.num_faces() - 1, face);
            ++num_read;
        } else if (kind == "zones") {
            parse_zones(data, size, "z.json");
            ++num_read;
        } else if (kind.compare(0, 10, "landmarks.") == 0) {
            parse_landmarks(data, size, kind);
            ++num_read;
        } else if (kind == "image") {
            TextureImage image;
            image.encoded.assign(data, size);
            const Image decoded = decode_image(image, context);
            if (decoded.rgb.size() != std::size_t(3 * decoded.width * decoded.height))
                return "an image of another size than it says";
            ++num_read;
        } else if (kind == "mtl") {
            std::vector<formats::LibraryMaterial> materials;
            formats::parse_material_library(data, data + size, materials);
            ++num_read;
        } else {
            if (kind == "glb" || kind == "gltf") read_targets(data, size, context);
            const TriMesh mesh = read_mesh_memory(data, size, kind, context);
            if (oom::control.largest > kProportion * size + kAllowance)
                return "an allocation of " + std::to_string(oom::control.largest) + " bytes";
            use_mesh(mesh);
            ++num_read;
        }
    } catch (const Error& error) {
        if (error.status() == Status::internal || error.what()[0] == '\0') return error.what();
    } catch (const std::exception& error) {
        return error.what();
    }
    return std::string();
}

}  // namespace

#if defined(MIEN_FUZZER)

namespace {
std::string fuzzed_kind;
}

extern "C" int LLVMFuzzerInitialize(int*, char*** argv) {
    const std::string name = (*argv)[0];
    fuzzed_kind = name.substr(name.rfind("libfuzz_") + 8);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static const ScratchFolder folder;
    static const std::string path = folder / "damaged";
    const std::string fault = feed(fuzzed_kind, reinterpret_cast<const char*>(data), size, path);
    if (fault.empty()) return 0;
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
}

#else

int main(int argc, char** argv) {
    if (argc == 3 && std::string(argv[1]) == "seeds") {
        std::size_t number = 0;
        for (const Seed& from : make_seeds()) {
            const std::filesystem::path folder = std::filesystem::path(argv[2]) / from.kind;
            std::filesystem::create_directories(folder);
            write_bytes((folder / std::to_string(number++)).string(), from.bytes);
        }
        return 0;
    }
    const long iterations = argc > 1 ? std::atol(argv[1]) : 60000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    const std::vector<Seed> seeds = make_seeds();
    const ScratchFolder folder;
    const std::string path = folder / "damaged";
    long faults = 0;
    double slowest = 0.0;
    for (long k = 0; k < iterations && faults < 10; ++k) {
        fuzz::Random random(seed * 0x100000001b3ULL + static_cast<std::uint64_t>(k));
        const Seed& from = seeds[random.below(seeds.size())];
        const std::string damaged =
            fuzz::mutate(from.bytes, seeds[random.below(seeds.size())].bytes, random);
        // Exactly so long, so that a sanitizer sees the first byte too far.
        const std::unique_ptr<char[]> exact(new char[damaged.size()]);
        std::copy(damaged.begin(), damaged.end(), exact.get());
        oom::control.largest = 0;
        oom::control.refuse_above = std::size_t(1) << 28;
        const auto begin = std::chrono::steady_clock::now();
        const std::string fault = feed(from.kind, exact.get(), damaged.size(), path);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        slowest = std::max(slowest, taken.count());
        if (fault.empty()) continue;
        ++faults;
        const std::string name = "fault-" + std::to_string(k) + "." + from.kind;
        write_bytes(name, damaged);
        std::printf("iteration %ld (%s): %s; see %s\n", k, from.kind.c_str(), fault.c_str(),
                    name.c_str());
    }
    std::printf("%ld damaged files, %ld read all the same, %ld faults, slowest %.1f ms\n",
                iterations, num_read, faults, 1e3 * slowest);
    return faults == 0 ? 0 : 1;
}

#endif
