// Wavefront OBJ: v with optional colour, vt, f with relative indices; polygons become fans. Groups,
// materials, normals, lines and curves are stepped over.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesh/formats.hpp"
#include "mesh/text_cursor.hpp"

namespace mien::formats {
namespace {

class ObjReader {
  public:
    ObjReader(const FileBytes& bytes, const Context& context)
        : text_(bytes.data, bytes.data + bytes.size), size_(bytes.size), context_(context) {
        // The least text of a vertex is "v 0 0 0\n": what is reserved here the file can fill.
        positions_.reserve(3 * (bytes.size / 64));
    }

    TriMesh read() {
        std::size_t next_check = size_;
        for (; !text_.at_end(); text_.skip_line()) {
            if (text_.remaining() <= next_check) {
                context_.progress(Stage::reading, 1.0 - static_cast<double>(text_.remaining()) /
                                                            static_cast<double>(size_));
                next_check = text_.remaining() - std::min(text_.remaining(), std::size_t(1) << 20);
            }
            text_.skip_blanks();
            const char* word = nullptr;
            std::size_t length = 0;
            text_.word(word, length);
            if (length == 1 && *word == 'v')
                read_vertex();
            else if (length == 1 && *word == 'f')
                read_face();
            else if (length == 2 && word[0] == 'v' && word[1] == 't')
                read_texture();
        }
        if (positions_.empty())
            fail(Status::bad_format, "not an OBJ file, or an empty one: it has no line 'v x y z'");
        TriMesh mesh;
        const Index count = static_cast<Index>(positions_.size() / 3);
        mesh.vertices = Eigen::Map<const Points>(positions_.data(), count, 3);
        if (!colors_.empty()) {
            colors_.resize(positions_.size(), 0.0f);
            mesh.colors = colors_from_numbers(colors_);
        }
        polygons_.finish(mesh, texture_);
        return mesh;
    }

  private:
    [[noreturn]] void fail_line(const char* what) const {
        fail_at(Status::bad_format, text_.line(), "line %lld: %s",
                static_cast<long long>(text_.line()), what);
    }

    void read_vertex() {
        double values[8];
        int count = 0;
        for (; count < 8; ++count) {
            text_.skip_blanks();
            if (text_.at_line_end() || !text_.number(values[count])) break;
        }
        if (count < 3) fail_line("a vertex needs three numbers");
        positions_.insert(positions_.end(), values, values + 3);
        // Three or four more numbers are a colour; one more is the weight of a rational curve.
        if (count >= 6) {
            colors_.resize(positions_.size() - 3, 0.0f);
            for (int k = 3; k < 6; ++k) colors_.push_back(static_cast<float>(values[k]));
        }
    }

    void read_texture() {
        double values[2] = {0.0, 0.0};
        for (int k = 0; k < 2; ++k) {
            text_.skip_blanks();
            if (!text_.number(values[k]) && k == 0) fail_line("a texture coordinate needs numbers");
        }
        texture_.push_back(static_cast<float>(values[0]));
        texture_.push_back(static_cast<float>(values[1]));
    }

    std::uint32_t read_index(std::size_t num_known) {
        std::int64_t index = 0;
        if (!text_.integer(index)) fail_line("a face's corner is no index");
        if (index < 0) index += static_cast<std::int64_t>(num_known) + 1;
        if (index < 1 || index > std::numeric_limits<std::int32_t>::max())
            fail_line("a face names a vertex before the first; indices begin at 1");
        return static_cast<std::uint32_t>(index - 1);
    }

    void read_face() {
        corners_.clear();
        corner_texture_.clear();
        bool textured = true;
        for (;;) {
            text_.skip_blanks();
            if (text_.at_line_end() || text_.peek() == '#') break;
            corners_.push_back(read_index(positions_.size() / 3));
            std::uint32_t texture = kNoTexture;
            if (text_.peek() == '/') {
                text_.advance();
                if (text_.peek() != '/' && static_cast<unsigned char>(text_.peek()) > ' ')
                    texture = read_index(texture_.size() / 2);
                // The normal's index has no use here.
                const char* word = nullptr;
                std::size_t length = 0;
                text_.word(word, length);
            } else if (static_cast<unsigned char>(text_.peek()) > ' ') {
                fail_line("a face's corner is no index");
            }
            textured = textured && texture != kNoTexture;
            corner_texture_.push_back(texture);
        }
        polygons_.add(corners_.data(), corners_.size(),
                      textured ? corner_texture_.data() : nullptr);
    }

    TextCursor text_;
    std::size_t size_;
    const Context& context_;
    std::vector<double> positions_;
    std::vector<float> colors_, texture_;
    std::vector<std::uint32_t> corners_, corner_texture_;
    PolygonSink polygons_;
};

}  // namespace

TriMesh read_obj(const FileBytes& bytes, const Context& context) {
    return ObjReader(bytes, context).read();
}

void write_obj(AtomicFile& file, const TriMesh& mesh, const Context& context) {
    std::string out = "# millimetres\n";
    const bool colors = mesh.colors.rows() != 0, texture = mesh.texture_triangles.rows() != 0;
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        out += 'v';
        for (int k = 0; k < 3; ++k) append_number(out, mesh.vertices(v, k));
        // Six digits bring every byte back.
        if (colors)
            for (int k = 0; k < 3; ++k) append_number(out, mesh.colors(v, k) / 255.0, 6);
        out += '\n';
        write_when_long(file, out, context);
    }
    for (Index t = 0; texture && t < mesh.texture.rows(); ++t) {
        out += "vt";
        for (int k = 0; k < 2; ++k) append_number(out, static_cast<double>(mesh.texture(t, k)));
        out += '\n';
        write_when_long(file, out, context);
    }
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        out += 'f';
        for (int k = 0; k < 3; ++k) {
            append_number(out, std::uint64_t(mesh.triangles(t, k)) + 1);
            if (!texture) continue;
            const std::size_t blank = out.size();
            append_number(out, std::uint64_t(mesh.texture_triangles(t, k)) + 1);
            out[blank] = '/';
        }
        out += '\n';
        write_when_long(file, out, context);
    }
    file.write(out);
}

}  // namespace mien::formats
