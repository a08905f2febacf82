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

const Format* find_format(std::string extension) {
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const Format& format : kFormats)
        if (extension == format.extension) return &format;
    return nullptr;
}

const Format& format_of(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    const Format* format =
        find_format(dot == std::string::npos ? std::string() : path.substr(dot + 1));
    if (format == nullptr)
        fail(Status::invalid_argument,
             "'%s': the extension tells no mesh format; use .ply, .obj, .stl or .off",
             shown_path(path).c_str());
    return *format;
}

TriMesh read_checked(const Format& format, const FileBytes& bytes, const Context& context) {
    if (bytes.size == 0) fail(Status::bad_format, "the file is empty");
    TriMesh mesh = format.read(bytes, context);
    check_mesh(mesh, "mesh");
    return mesh;
}

}  // namespace

TriMesh read_mesh_memory(const void* data, std::size_t size, const std::string& extension,
                         const Context& context) {
    const Format* format = find_format(extension);
    if (format == nullptr)
        fail(Status::invalid_argument, "'%s' is no mesh format; use ply, obj, stl or off",
             shown_path(extension).c_str());
    FileBytes bytes;
    bytes.data = static_cast<const char*>(data);
    bytes.size = data == nullptr ? 0 : size;
    return read_checked(*format, bytes, context);
}

TriMesh read_mesh_file(const std::string& path, const Context& context) {
    const Format& format = format_of(path);
    const FileBytes bytes = read_whole_file(path, context);
    try {
        return read_checked(format, bytes, context);
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
