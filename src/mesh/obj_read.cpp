// Wavefront OBJ: v with optional colour, vt, f (or fo, its old name) with relative indices,
// materials with their images; polygons become fans. Groups, normals, lines and curves are stepped
// over.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <unordered_map>

#include "base/json.hpp"
#include "mesh/companions.hpp"
#include "mesh/formats.hpp"
#include "mesh/material_library.hpp"
#include "mesh/text_cursor.hpp"

namespace mien::formats {
namespace {

class ObjReader {
  public:
    ObjReader(const Source& source, const Context& context)
        : text_(source.bytes.data, source.bytes.data + source.bytes.size),
          size_(source.bytes.size),
          source_(source),
          context_(context) {
        // The least text of a vertex is "v 0 0 0\n": what is reserved here the file can fill.
        positions_.reserve(3 * (size_ / 64));
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
            else if ((length == 1 && *word == 'f') || is_keyword(word, length, "fo"))
                read_face();
            else if (length == 2 && word[0] == 'v' && word[1] == 't')
                read_texture();
            else if (is_keyword(word, length, "usemtl"))
                use_material();
            else if (is_keyword(word, length, "mtllib"))
                name_libraries();
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
        take_materials(mesh);
        return mesh;
    }

  private:
    static bool is_keyword(const char* word, std::size_t length, const char* keyword) {
        return length == std::strlen(keyword) && std::memcmp(word, keyword, length) == 0;
    }

    std::string rest_of_line() {
        const char* begin = nullptr;
        std::size_t size = 0;
        text_.rest_of_line(begin, size);
        return std::string(begin, size);
    }

    /// Materials are numbered as they are first used; faces before the first have one without name.
    void use_material() {
        const std::string name = rest_of_line();
        if (material_names_.empty() && polygons_.any()) number_of_material(std::string());
        material_ = number_of_material(name);
    }

    std::uint32_t number_of_material(const std::string& name) {
        const auto known = material_numbers_.find(name);
        if (known != material_numbers_.end()) return known->second;
        const auto number = static_cast<std::uint32_t>(material_names_.size());
        material_numbers_.emplace(name, number);
        material_names_.push_back(name);
        return number;
    }

    void name_libraries() {
        const std::string rest = rest_of_line();
        if (!rest.empty() && libraries_.size() < kMostLibraries) libraries_.push_back(rest);
    }

    /// What the libraries say of the materials that the faces use.
    void take_materials(TriMesh& mesh) const {
        if (mesh.triangles.rows() == 0) return;
        std::vector<LibraryMaterial> known;
        for (const std::string& library : libraries_)
            read_material_library(source_, library, known, context_);
        // A file that uses no material of its library is meant to use its only one.
        std::vector<std::string> names = material_names_;
        if (names.empty() && known.size() == 1) names.push_back(known[0].name);
        KnownImages images;
        for (const std::string& name : names) {
            Material material;
            material.name = is_utf8(name) ? name : shown_name(name);
            for (const LibraryMaterial& entry : known) {
                if (entry.name != name) continue;
                material.color = entry.color;
                if (!entry.image.empty())
                    material.image =
                        add_companion_image(mesh, source_, entry.image, images, context_);
                break;
            }
            mesh.materials.push_back(std::move(material));
        }
        if (mesh.materials.empty()) mesh.triangle_materials.clear();
    }

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
        if (text_.peek() == ',') fail_line("a number has a decimal comma; write decimal points");
        if (count < 3)
            fail_line("a vertex needs three numbers, with decimal points and blanks between them");
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
            } else if (static_cast<unsigned char>(text_.peek()) > ' ' && text_.peek() != '#') {
                fail_line("a face's corner is no index");
            }
            textured = textured && texture != kNoTexture;
            corner_texture_.push_back(texture);
        }
        polygons_.add(corners_.data(), corners_.size(), textured ? corner_texture_.data() : nullptr,
                      material_);
    }

    static constexpr std::size_t kMostLibraries = 64;

    TextCursor text_;
    std::size_t size_;
    const Source& source_;
    const Context& context_;
    std::vector<std::string> libraries_, material_names_;
    std::unordered_map<std::string, std::uint32_t> material_numbers_;
    std::uint32_t material_ = 0;
    std::vector<double> positions_;
    std::vector<float> colors_, texture_;
    std::vector<std::uint32_t> corners_, corner_texture_;
    PolygonSink polygons_;
};

}  // namespace

TriMesh read_obj(const Source& source, const Context& context) {
    return ObjReader(source, context).read();
}

}  // namespace mien::formats
