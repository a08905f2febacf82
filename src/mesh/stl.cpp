// STL, binary and ASCII. The size decides first: many binary files begin with "solid" too. Corners
// with equal coordinates become one vertex; normals are recomputed where they are needed.
#include <cmath>
#include <cstring>
#include <Eigen/Geometry>

#include "mesh/formats.hpp"
#include "mesh/text_cursor.hpp"
#include "mesh/weld.hpp"

namespace mien::formats {
namespace {

constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50;
constexpr std::size_t kMostMarks = 20;  // in triangles: what may stand behind a binary file's last

TriMesh weld_corners(const Points& corners, const Context& context) {
    const WeldedPoints welded = weld_points(corners, context);
    TriMesh mesh;
    mesh.vertices.resize(static_cast<Index>(welded.first_point.size()), 3);
    for (std::size_t v = 0; v < welded.first_point.size(); ++v)
        mesh.vertices.row(static_cast<Index>(v)) =
            corners.row(static_cast<Index>(welded.first_point[v]));
    mesh.triangles = Eigen::Map<const Triangles>(welded.class_of.data(), corners.rows() / 3, 3);
    return mesh;
}

TriMesh read_binary(const FileBytes& bytes, std::uint32_t count, const Context& context) {
    if (count > (bytes.size - kHeaderBytes) / kTriangleBytes)
        fail(Status::bad_format, "the STL file promises %lu triangles, its %zu bytes hold %zu",
             static_cast<unsigned long>(count), bytes.size,
             (bytes.size - kHeaderBytes) / kTriangleBytes);
    // Some programs leave marks behind the triangles, but no triangles.
    const std::size_t held = (bytes.size - kHeaderBytes) / kTriangleBytes;
    if (held > count && (count == 0 || held - count > kMostMarks))
        fail(Status::bad_format,
             "the STL file counts %lu triangles, but its %zu bytes hold %zu: the program that "
             "wrote it did not come to its end, or the count is damaged",
             static_cast<unsigned long>(count), bytes.size, held);
    context.require_memory(std::size_t(count) * 72, "an STL file's corners");
    Points corners(3 * static_cast<Index>(count), 3);
    for (std::size_t t = 0; t < count; ++t) {
        if (t % kCancelInterval == 0)
            context.progress(Stage::reading, static_cast<double>(t) / count);
        float values[9];
        std::memcpy(values, bytes.data + kHeaderBytes + kTriangleBytes * t + 12, sizeof values);
        for (int k = 0; k < 9; ++k)
            corners.data()[9 * t + static_cast<std::size_t>(k)] = static_cast<double>(values[k]);
    }
    return weld_corners(corners, context);
}

/// Only "vertex x y z" and "endloop" carry meaning; the words around them are stepped over.
bool is_word(const char* word, std::size_t size, const char* expected) {
    if (size != std::strlen(expected)) return false;
    for (std::size_t k = 0; k < size; ++k)
        if ((word[k] | 0x20) != expected[k]) return false;
    return true;
}

/// A word of a facet's normal, which is not used: a number, or what a program writes for none.
bool may_be_number(const char* word, std::size_t size) {
    return (*word >= '0' && *word <= '9') || *word == '-' || *word == '+' || *word == '.' ||
           (size >= 3 && (is_word(word, 3, "nan") || is_word(word, 3, "inf")));
}

/// "solid" and "endsolid" carry a name of any words to the line's end; in a file of one line, to
/// the word that begins a facet or ends the solid.
void skip_name(TextCursor& text) {
    const char* word = nullptr;
    std::size_t size = 0;
    for (text.skip_blanks(); !text.at_line_end(); text.skip_blanks()) {
        const TextCursor before = text;
        text.word(word, size);
        if (size == 0) {
            text.advance();
            continue;
        }
        // A name may hold these words too: a facet goes on with its normal.
        TextCursor next = text;
        next.skip_space();
        const char* second = nullptr;
        std::size_t length = 0;
        next.word(second, length);
        if ((is_word(word, size, "facet") && length != 0 && is_word(second, length, "normal")) ||
            is_word(word, size, "endsolid")) {
            text = before;
            return;
        }
    }
}

TriMesh read_ascii(const FileBytes& bytes, const Context& context) {
    TextCursor text(bytes.data, bytes.data + bytes.size);
    std::vector<double> corners, loop;
    auto fail_line = [&](const char* what) {
        fail_at(Status::bad_format, text.line(), "line %lld: %s",
                static_cast<long long>(text.line()), what);
    };
    bool complete = false, in_loop = false;
    std::size_t words = 0;
    text.skip_space();
    const char* solid = nullptr;
    std::size_t solid_size = 0;
    text.word(solid, solid_size);
    skip_name(text);
    for (;;) {
        if (words++ % kCancelInterval == 0) context.check_cancelled();
        text.skip_space();
        if (text.at_end()) break;
        const char* word = nullptr;
        std::size_t size = 0;
        text.word(word, size);
        if (size == 0) fail_line("a control character in an ASCII STL file");
        if (is_word(word, size, "vertex")) {
            if (!in_loop) fail_line("a vertex outside of a loop");
            for (int k = 0; k < 3; ++k) {
                double value = 0.0;
                text.skip_space();
                if (!text.number(value)) fail_line("a vertex needs three numbers");
                loop.push_back(value);
            }
        } else if (is_word(word, size, "loop")) {
            in_loop = true;
            loop.clear();
        } else if (is_word(word, size, "endloop")) {
            if (!in_loop || loop.size() < 9) fail_line("a loop of fewer than three vertices");
            for (std::size_t k = 6; k < loop.size(); k += 3)
                for (std::size_t corner : {std::size_t(0), k - 3, k})
                    corners.insert(corners.end(),
                                   loop.begin() + static_cast<std::ptrdiff_t>(corner),
                                   loop.begin() + static_cast<std::ptrdiff_t>(corner + 3));
            in_loop = false;
        } else if (is_word(word, size, "endsolid") || is_word(word, size, "solid")) {
            complete = is_word(word, size, "endsolid");
            skip_name(text);
        } else if (is_word(word, size, "facet") || is_word(word, size, "normal") ||
                   is_word(word, size, "outer") || is_word(word, size, "endfacet")) {
            // Structure without information.
        } else if (in_loop || !may_be_number(word, size)) {
            fail_line("an unknown word in an ASCII STL file");
        }
    }
    if (!complete || in_loop) fail_line("the file ends before 'endsolid'");
    return weld_corners(
        Eigen::Map<const Points>(corners.data(), static_cast<Index>(corners.size() / 3), 3),
        context);
}

}  // namespace

bool is_exact_binary_stl(const char* data, std::size_t size) {
    if (size < kHeaderBytes) return false;
    std::uint32_t count = 0;
    std::memcpy(&count, data + 80, 4);
    return size - kHeaderBytes == std::uint64_t(count) * kTriangleBytes;
}

bool is_ascii_stl(const char* data, std::size_t size) {
    constexpr std::size_t kLookedAt = 4096;
    const char* end = data + (size < kLookedAt ? size : kLookedAt);
    if (std::memchr(data, '\0', static_cast<std::size_t>(end - data)) != nullptr) return false;
    TextCursor text(data, end);
    text.skip_space();
    const char* word = nullptr;
    std::size_t length = 0;
    text.word(word, length);
    if (!is_word(word, length, "solid")) return false;
    for (skip_name(text), text.skip_space(); !text.at_end(); text.skip_space()) {
        text.word(word, length);
        if (length == 0) return false;
        if (is_word(word, length, "facet") || is_word(word, length, "endsolid")) return true;
    }
    return false;
}

TriMesh read_stl(const Source& source, const Context& context) {
    const FileBytes& bytes = source.bytes;
    TextCursor text(bytes.data, bytes.data + bytes.size);
    text.skip_space();
    const char* word = nullptr;
    std::size_t length = 0;
    text.word(word, length);
    const std::size_t looked_at = bytes.size < 1024 ? bytes.size : std::size_t(1024);
    const bool is_text =
        is_word(word, length, "solid") && std::memchr(bytes.data, '\0', looked_at) == nullptr;
    if (is_text && !is_exact_binary_stl(bytes.data, bytes.size)) return read_ascii(bytes, context);
    if (bytes.size < kHeaderBytes)
        fail(Status::bad_format, "not an STL file: no 'solid', and %zu bytes are no header",
             bytes.size);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data + 80, 4);
    return read_binary(bytes, count, context);
}

void write_stl(Target& target, const TriMesh& mesh, const Context& context) {
    if (needs_double(mesh))
        fail(Status::invalid_mesh,
             "an STL file holds float32, which would move these coordinates by more than %g mm: "
             "use PLY or OBJ, or move the mesh to the origin",
             kCoordinateStep_mm / 2);
    if (mesh.triangles.rows() == 0)
        fail(Status::invalid_mesh, "an STL file holds triangles, the mesh has none; use PLY");
    if (static_cast<std::uint64_t>(mesh.triangles.rows()) > 0xffffffffu)
        fail(Status::invalid_mesh, "an STL file holds at most 2^32 - 1 triangles; use PLY");
    std::string out = "binary STL, millimetres";
    out.resize(80, ' ');
    const std::uint32_t count = static_cast<std::uint32_t>(mesh.triangles.rows());
    out.append(reinterpret_cast<const char*>(&count), 4);
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        Vector3 corners[3];
        for (int k = 0; k < 3; ++k)
            corners[k] = mesh.vertices.row(static_cast<Index>(mesh.triangles(t, k)));
        Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        const double length = normal.norm();
        normal = length > 0.0 && std::isfinite(length) ? Vector3(normal / length) : Vector3::Zero();
        float values[12];
        for (int axis = 0; axis < 3; ++axis) {
            values[axis] = static_cast<float>(normal[axis]);
            for (int k = 0; k < 3; ++k)
                values[3 + 3 * k + axis] = static_cast<float>(corners[k][axis]);
        }
        out.append(reinterpret_cast<const char*>(values), sizeof values);
        out.append(2, '\0');
        write_when_long(target.file, out, context);
    }
    target.file.write(out);
}

}  // namespace mien::formats
