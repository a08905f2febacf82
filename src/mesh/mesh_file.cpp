// Reads and writes by the table of formats. The readers are our own: OpenMesh's print to stderr,
// trust a file's counts and refuse what is not manifold.
#include "mesh/mesh_file.hpp"

#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "mesh/format_table.hpp"
#include "mesh/formats.hpp"
#include "mesh/gltf.hpp"

namespace mien {
namespace {

using formats::Format;

/// Code points as UTF-8. Lone surrogates become U+FFFD.
void append_utf8(std::string& out, std::uint32_t code) {
    if (code >= 0xd800 && code < 0xe000) code = 0xfffd;
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xc0 | code >> 6);
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        out += static_cast<char>(0xe0 | code >> 12);
        out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        out += static_cast<char>(0xf0 | code >> 18);
        out += static_cast<char>(0x80 | (code >> 12 & 0x3f));
        out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    }
}

/// A text that some Windows program wrote in 16-bit units becomes UTF-8; other bytes stay.
FileBytes as_utf8(const FileBytes& bytes, const Context& context) {
    const unsigned char* raw = reinterpret_cast<const unsigned char*>(bytes.data);
    const bool little = bytes.size >= 2 && raw[0] == 0xff && raw[1] == 0xfe;
    const bool big = bytes.size >= 2 && raw[0] == 0xfe && raw[1] == 0xff;
    if ((!little && !big) || formats::is_exact_binary_stl(bytes.data, bytes.size)) return bytes;
    context.require_memory(2 * bytes.size, "a text in 16-bit units");
    auto text = std::make_shared<std::string>();
    text->reserve(bytes.size);
    const auto unit = [&](std::size_t at) {
        return static_cast<std::uint32_t>(little ? raw[at] | raw[at + 1] << 8
                                                 : raw[at] << 8 | raw[at + 1]);
    };
    for (std::size_t at = 2; at + 1 < bytes.size; at += 2) {
        std::uint32_t code = unit(at);
        if (code >= 0xd800 && code < 0xdc00 && at + 3 < bytes.size) {
            const std::uint32_t low = unit(at + 2);
            if (low >= 0xdc00 && low < 0xe000) {
                code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
                at += 2;
            }
        }
        append_utf8(*text, code);
    }
    FileBytes converted;
    converted.data = text->data();
    converted.size = text->size();
    converted.storage = std::move(text);
    return converted;
}

/// Scanners write points that they did not see as numbers that are none. Where no triangle uses
/// them they go; where one does, check_mesh() names them.
void drop_undefined_vertices(TriMesh& mesh, const Context& context) {
    const Index count = mesh.vertices.rows();
    std::vector<std::uint8_t> goes(static_cast<std::size_t>(count), 0);
    Index num_undefined = 0;
    for (Index v = 0; v < count; ++v) {
        const double sum = mesh.vertices(v, 0) + mesh.vertices(v, 1) + mesh.vertices(v, 2);
        if (std::isfinite(sum) || mesh.vertices.row(v).allFinite()) continue;
        goes[static_cast<std::size_t>(v)] = 1;
        ++num_undefined;
    }
    if (num_undefined == 0 || num_undefined == count) return;
    for (Index k = 0; k < mesh.triangles.size(); ++k) {
        const std::uint32_t v = mesh.triangles.data()[k];
        if (v >= goes.size() || goes[v]) return;
    }
    context.log(LogLevel::warning,
                "%lld of the file's %lld points are undefined and part of no triangle: dropped, "
                "those after them have new numbers",
                static_cast<long long>(num_undefined), static_cast<long long>(count));
    std::vector<std::uint32_t> new_number(static_cast<std::size_t>(count), 0);
    const bool colors = mesh.colors.rows() == count;
    Index kept = 0;
    for (Index v = 0; v < count; ++v) {
        if (goes[static_cast<std::size_t>(v)]) continue;
        new_number[static_cast<std::size_t>(v)] = static_cast<std::uint32_t>(kept);
        mesh.vertices.row(kept) = mesh.vertices.row(v).eval();
        if (colors) mesh.colors.row(kept) = mesh.colors.row(v).eval();
        ++kept;
    }
    mesh.vertices.conservativeResize(kept, 3);
    if (colors) mesh.colors.conservativeResize(kept, 3);
    for (Index k = 0; k < mesh.triangles.size(); ++k)
        mesh.triangles.data()[k] = new_number[mesh.triangles.data()[k]];
}

formats::Source source_of(const FileBytes& file, const std::string& path, const Context& context) {
    if (file.size == 0) fail(Status::bad_format, "the file is empty");
    formats::Source source;
    source.path = path;
    source.bytes = as_utf8(file, context);
    return source;
}

TriMesh read_checked(const FileBytes& file, const std::string& path, const std::string& extension,
                     const Context& context) {
    const formats::Source source = source_of(file, path, context);
    const Format* format =
        formats::format_of_bytes(source.bytes.data, source.bytes.size, extension);
    if (format == nullptr)
        fail(Status::invalid_argument,
             "neither its extension nor its content tells a mesh format; known are %s",
             formats::list_of_extensions(false).c_str());
    TriMesh mesh = format->read(source, context);
    drop_undefined_vertices(mesh, context);
    check_mesh(mesh, "mesh");
    return mesh;
}

/// Calls `read` with the file's bytes and puts the path before what it reports.
template <typename Read>
auto read_named(const std::string& path, const Context& context, Read&& read) {
    const FileBytes bytes = read_whole_file(path, context);
    try {
        return read(bytes);
    } catch (const Error& error) {
        if (error.status() == Status::cancelled || error.status() == Status::memory_budget) throw;
        fail_at(error.status(), error.detail_index(), "'%s': %s", shown_path(path).c_str(),
                error.what());
    }
}

void commit(formats::Target& target) {
    for (const auto& companion : target.companions) companion->commit();
    target.file.commit();
}

}  // namespace

TriMesh read_mesh_memory(const void* data, std::size_t size, const std::string& extension,
                         const Context& context) {
    FileBytes bytes;
    bytes.data = static_cast<const char*>(data);
    bytes.size = data == nullptr ? 0 : size;
    return read_checked(bytes, std::string(), extension, context);
}

TriMesh read_mesh_file(const std::string& path, const Context& context) {
    return read_named(path, context, [&](const FileBytes& bytes) {
        return read_checked(bytes, path, formats::extension_of(path), context);
    });
}

MorphMesh read_morph_mesh(const std::string& path, const Context& context) {
    return read_named(path, context, [&](const FileBytes& bytes) {
        const formats::Source source = source_of(bytes, path, context);
        MorphMesh morph;
        morph.mesh = formats::read_gltf_document(source, &morph.targets, context);
        check_mesh(morph.mesh, "mesh");
        for (const MorphTarget& target : morph.targets)
            if (!target.offsets.allFinite())
                fail(Status::invalid_mesh, "the morph target '%s' has offsets that are not finite",
                     shown_name(target.name).c_str());
        return morph;
    });
}

void write_morph_mesh(const std::string& path, const TriMesh& mesh,
                      const std::vector<MorphTarget>& targets, const Context& context) {
    const Format* format = formats::find_format(formats::extension_of(path));
    if (format == nullptr || format->write != formats::write_glb)
        fail(Status::invalid_argument, "'%s': morph targets are written to .glb files",
             shown_path(path).c_str());
    check_mesh(mesh, "mesh");
    AtomicFile file(path);
    formats::Target target{file, path, {}};
    formats::write_glb_document(target, mesh, targets, context);
    commit(target);
}

void write_mesh_file(const std::string& path, const TriMesh& mesh, const Context& context) {
    const Format* format = formats::find_format(formats::extension_of(path));
    if (format == nullptr || format->write == nullptr)
        fail(Status::invalid_argument, "'%s': %s; written are %s", shown_path(path).c_str(),
             format == nullptr ? "the extension tells no mesh format" : "this format is read only",
             formats::list_of_extensions(true).c_str());
    check_mesh(mesh, "mesh");
    AtomicFile file(path);
    formats::Target target{file, path, {}};
    format->write(target, mesh, context);
    commit(target);
}

std::vector<MeshFormat> mesh_formats() {
    std::vector<MeshFormat> all;
    for (std::size_t k = 0; const Format* format = formats::format_at(k); ++k)
        all.push_back({format->extension, format->description, format->write != nullptr});
    return all;
}

}  // namespace mien
