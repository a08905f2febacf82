// Chooses the format by extension. The readers are our own: OpenMesh's print to stderr, trust a
// file's counts and refuse what is not manifold.
#include "mesh/mesh_file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "mesh/formats.hpp"

namespace mien {
namespace {

struct Format {
    const char* extension;
    TriMesh (*read)(const FileBytes&, const Context&);
    void (*write)(AtomicFile&, const TriMesh&, const Context&);
};

constexpr Format kFormats[] = {
    {"ply", formats::read_ply, formats::write_ply},  {"obj", formats::read_obj, formats::write_obj},
    {"stl", formats::read_stl, formats::write_stl},  {"off", formats::read_off, formats::write_off},
    {"coff", formats::read_off, formats::write_off},
};

const Format& format_of(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    std::string extension = dot == std::string::npos ? std::string() : path.substr(dot + 1);
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const Format& format : kFormats)
        if (extension == format.extension) return format;
    fail(Status::invalid_argument,
         "'%s': the extension tells no mesh format; use .ply, .obj, .stl or .off",
         shown_path(path).c_str());
}

}  // namespace

TriMesh read_mesh_file(const std::string& path, const Context& context) {
    const Format& format = format_of(path);
    const FileBytes bytes = read_whole_file(path, context);
    try {
        if (bytes.size == 0) fail(Status::bad_format, "the file is empty");
        TriMesh mesh = format.read(bytes, context);
        check_mesh(mesh, "mesh");
        return mesh;
    } catch (const Error& error) {
        if (error.status() == Status::cancelled || error.status() == Status::memory_budget) throw;
        fail_at(error.status(), error.detail_index(), "'%s': %s", shown_path(path).c_str(),
                error.what());
    }
}

void write_mesh_file(const std::string& path, const TriMesh& mesh, const Context& context) {
    const Format& format = format_of(path);
    check_mesh(mesh, "mesh");
    AtomicFile file(path);
    format.write(file, mesh, context);
    file.commit();
}

}  // namespace mien
