// OFF (Geomview): [ST][C][N]OFF, ASCII with '#' comments or binary of either byte order. Vertex
// colours and texture coordinates are kept, normals and face colours stepped over.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesh/formats.hpp"
#include "mesh/text_cursor.hpp"

namespace mien::formats {
namespace {

struct OffHeader {
    bool texture = false, colors = false, normals = false, binary = false;
};

OffHeader parse_keyword(TextCursor& text) {
    OffHeader header;
    text.skip_space('#');
    auto take = [&](const char* word) {
        const std::size_t size = std::strlen(word);
        if (text.remaining() < size || std::memcmp(text.at(), word, size) != 0) return false;
        for (std::size_t k = 0; k < size; ++k) text.advance();
        return true;
    };
    header.texture = take("ST");
    header.colors = take("C");
    header.normals = take("N");
    if (take("4") || take("n"))
        fail(Status::bad_format, "an OFF file of another dimension than three");
    if (!take("OFF")) fail(Status::bad_format, "not an OFF file: it does not begin with 'OFF'");
    while (text.peek() == ' ' || text.peek() == '\t') text.advance();
    header.binary = take("BINARY");
    return header;
}

/// What both encodings fill.
struct OffMesh {
    std::vector<double> positions;
    std::vector<float> colors, texture;
    PolygonSink polygons;

    TriMesh finish() {
        TriMesh mesh;
        const Index count = static_cast<Index>(positions.size() / 3);
        mesh.vertices = Eigen::Map<const Points>(positions.data(), count, 3);
        if (!colors.empty()) mesh.colors = colors_from_numbers(colors);
        std::vector<float> none;
        polygons.finish(mesh, none);
        if (!texture.empty()) {
            for (float& value : texture)
                if (!std::isfinite(value)) value = 0.0f;
            mesh.texture = Eigen::Map<const TextureCoordinates>(texture.data(), count, 2);
            mesh.texture_triangles = mesh.triangles;
        }
        return mesh;
    }
};

[[noreturn]] void fail_counts(std::uint64_t vertices, std::uint64_t faces) {
    fail(Status::bad_format,
         "the OFF header promises %llu vertices and %llu faces, more than the "
         "file holds",
         static_cast<unsigned long long>(vertices), static_cast<unsigned long long>(faces));
}

TriMesh read_ascii(TextCursor text, const OffHeader& header, const Context& context) {
    auto fail_line = [&](const char* what) {
        fail_at(Status::bad_format, text.line(), "line %lld: %s",
                static_cast<long long>(text.line()), what);
    };
    std::int64_t counts[2];
    for (std::int64_t& count : counts) {
        text.skip_space('#');
        if (!text.integer(count) || count < 0) fail_line("the OFF header needs counts");
    }
    text.skip_line();  // the number of edges, which nobody uses and some leave out
    const std::uint64_t num_vertices = static_cast<std::uint64_t>(counts[0]);
    const std::uint64_t num_faces = static_cast<std::uint64_t>(counts[1]);
    // The least text of a vertex is "0 0 0\n", of a face "0\n".
    if (num_vertices > text.remaining() / 5 || num_faces > text.remaining())
        fail_counts(num_vertices, num_faces);
    context.require_memory(static_cast<std::size_t>(num_vertices) * 44, "an OFF file's vertices");

    OffMesh mesh;
    mesh.positions.reserve(3 * static_cast<std::size_t>(num_vertices));
    const int skipped = header.normals ? 3 : 0;
    for (std::uint64_t v = 0; v < num_vertices; ++v) {
        if (v % kCancelInterval == 0) context.check_cancelled();
        text.skip_space('#');
        double values[16];
        int count = 0;
        for (; count < 16; ++count) {
            text.skip_blanks();
            if (text.at_line_end() || text.peek() == '#' || !text.number(values[count])) break;
        }
        // After position and normal, the colour of three or four numbers, then two of texture.
        const int last = header.texture ? 2 : 0;
        const int needed = 3 + skipped + (header.colors ? 3 : 0) + last;
        if (count < needed) fail_line("a vertex has too few numbers");
        mesh.positions.insert(mesh.positions.end(), values, values + 3);
        if (header.colors)
            for (int k = 0; k < 3; ++k)
                mesh.colors.push_back(static_cast<float>(values[3 + skipped + k]));
        if (header.texture)
            for (int k = count - 2; k < count; ++k)
                mesh.texture.push_back(static_cast<float>(values[k]));
        text.skip_line();
    }
    std::vector<std::uint32_t> corners;
    for (std::uint64_t f = 0; f < num_faces; ++f) {
        if (f % kCancelInterval == 0)
            context.progress(Stage::reading,
                             static_cast<double>(f) / static_cast<double>(num_faces));
        text.skip_space('#');
        std::int64_t length = 0;
        if (!text.integer(length) || length < 0 ||
            static_cast<std::uint64_t>(length) > text.remaining())
            fail_line("a face needs the number of its corners");
        corners.clear();
        for (; length != 0; --length) {
            std::int64_t index = 0;
            text.skip_space('#');
            if (!text.integer(index) || index < 0 || index >= counts[0])
                fail_line("a face's corner is no index of a vertex");
            corners.push_back(static_cast<std::uint32_t>(index));
        }
        mesh.polygons.add(corners.data(), corners.size(), nullptr);
        text.skip_line();  // perhaps a colour
    }
    return mesh.finish();
}

/// How a binary file was written: Geomview's is big-endian with the number of a face's colour
/// components after each face; OpenMesh writes this machine's order, others leave the number out.
struct BinaryLayout {
    bool big_endian = true, face_colors = true;
};

class OffBytes {
  public:
    OffBytes(const char* begin, std::size_t size, bool big_endian)
        : at_(reinterpret_cast<const unsigned char*>(begin)), left_(size), big_(big_endian) {}
    std::size_t left() const { return left_; }
    std::uint32_t u32() {
        const unsigned char* p = at_;
        skip(1);
        return big_ ? std::uint32_t(p[0]) << 24 | std::uint32_t(p[1]) << 16 |
                          std::uint32_t(p[2]) << 8 | std::uint32_t(p[3])
                    : std::uint32_t(p[3]) << 24 | std::uint32_t(p[2]) << 16 |
                          std::uint32_t(p[1]) << 8 | std::uint32_t(p[0]);
    }
    void skip(std::size_t words) {
        if (left_ / 4 < words) fail(Status::bad_format, "the OFF file ends within its data");
        at_ += 4 * words;
        left_ -= 4 * words;
    }
    float f32() {
        const std::uint32_t bits = u32();
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }

  private:
    const unsigned char* at_;
    std::size_t left_;
    bool big_;
};

std::size_t vertex_words(const OffHeader& header) {
    return 3 + (header.normals ? 3u : 0u) + (header.colors ? 4u : 0u) + (header.texture ? 2u : 0u);
}

/// True when the file has exactly the bytes that this layout needs and its faces name vertices.
bool fits(const TextCursor& text, const OffHeader& header, const BinaryLayout& layout) {
    OffBytes bytes(text.at(), text.remaining(), layout.big_endian);
    if (bytes.left() < 12) return false;
    const std::uint32_t num_vertices = bytes.u32(), num_faces = bytes.u32();
    bytes.u32();
    const std::size_t words = vertex_words(header);
    if (num_vertices > bytes.left() / (4 * words) || num_faces > bytes.left() / 4) return false;
    bytes.skip(num_vertices * words);
    for (std::uint32_t f = 0; f < num_faces; ++f) {
        if (bytes.left() < 4) return false;
        const std::uint32_t length = bytes.u32();
        if (length == 0 || length > bytes.left() / 4) return false;
        for (std::uint32_t k = 0; k < length; ++k)
            if (bytes.u32() >= num_vertices) return false;
        if (!layout.face_colors) continue;
        if (bytes.left() < 4) return false;
        const std::uint32_t components = bytes.u32();
        if (components > 4 || components > bytes.left() / 4) return false;
        bytes.skip(components);
    }
    return bytes.left() == 0;
}

/// The first layout that fits the whole file; else the documented one, whose reading tells what is
/// wrong (or that bytes follow the last face).
BinaryLayout find_layout(const TextCursor& text, const OffHeader& header) {
    for (bool face_colors : {true, false})
        for (bool big_endian : {true, false})
            if (fits(text, header, {big_endian, face_colors})) return {big_endian, face_colors};
    return {};
}

TriMesh read_binary(const TextCursor& text, const OffHeader& header, const Context& context) {
    const BinaryLayout layout = find_layout(text, header);
    OffBytes bytes(text.at(), text.remaining(), layout.big_endian);
    const std::uint32_t num_vertices = bytes.u32(), num_faces = bytes.u32();
    bytes.u32();
    if (num_vertices > bytes.left() / (4 * vertex_words(header)) || num_faces > bytes.left() / 4)
        fail_counts(num_vertices, num_faces);
    context.require_memory(std::size_t(num_vertices) * 44, "an OFF file's vertices");
    OffMesh mesh;
    mesh.positions.reserve(3 * std::size_t(num_vertices));
    for (std::uint32_t v = 0; v < num_vertices; ++v) {
        if (v % kCancelInterval == 0) context.check_cancelled();
        for (int k = 0; k < 3; ++k) mesh.positions.push_back(static_cast<double>(bytes.f32()));
        if (header.normals) bytes.skip(3);
        for (int k = 0; header.colors && k < 4; ++k) {
            const float value = bytes.f32();
            if (k < 3) mesh.colors.push_back(value);
        }
        for (int k = 0; header.texture && k < 2; ++k) mesh.texture.push_back(bytes.f32());
    }
    std::vector<std::uint32_t> corners;
    for (std::uint32_t f = 0; f < num_faces; ++f) {
        if (f % kCancelInterval == 0) context.check_cancelled();
        const std::uint32_t length = bytes.u32();
        if (length > bytes.left() / 4)
            fail_at(Status::bad_format, f, "face %lu has %lu corners, more than the file holds",
                    static_cast<unsigned long>(f), static_cast<unsigned long>(length));
        corners.clear();
        for (std::uint32_t k = 0; k < length; ++k) corners.push_back(bytes.u32());
        if (layout.face_colors) bytes.skip(bytes.u32());
        mesh.polygons.add(corners.data(), corners.size(), nullptr);
    }
    return mesh.finish();
}

}  // namespace

TriMesh read_off(const Source& source, const Context& context) {
    TextCursor text(source.bytes.data, source.bytes.data + source.bytes.size);
    const OffHeader header = parse_keyword(text);
    if (!header.binary) return read_ascii(text, header, context);
    // The data begins after one line end, and may itself begin with the byte of another.
    while (!text.at_line_end()) text.advance();
    if (text.peek() == '\r' && text.remaining() > 1 && text.at()[1] == '\n') text.advance();
    if (!text.at_end()) text.advance();
    return read_binary(text, header, context);
}

void write_off(Target& target, const TriMesh& mesh, const Context& context) {
    const bool colors = mesh.colors.rows() != 0;
    std::string out = colors ? "COFF\n" : "OFF\n";
    out +=
        std::to_string(mesh.vertices.rows()) + ' ' + std::to_string(mesh.triangles.rows()) + " 0\n";
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        const std::size_t begin = out.size();
        for (int k = 0; k < 3; ++k) append_coordinate(out, mesh.vertices(v, k));
        out.erase(begin, 1);
        if (colors) {
            for (int k = 0; k < 3; ++k) append_number(out, std::uint64_t(mesh.colors(v, k)));
            out += " 255";
        }
        out += '\n';
        write_when_long(target.file, out, context);
    }
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        out += '3';
        for (int k = 0; k < 3; ++k) append_number(out, std::uint64_t(mesh.triangles(t, k)));
        out += '\n';
        write_when_long(target.file, out, context);
    }
    target.file.write(out);
}

}  // namespace mien::formats
