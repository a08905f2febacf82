// PLY in its three encodings, any order and type of properties; unknown elements and properties are
// stepped over. Own reader because OpenMesh's prints to stderr and trusts its input's counts.
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/json.hpp"
#include "mesh/companions.hpp"
#include "mesh/formats.hpp"
#include "mesh/ply_header.hpp"
#include "mesh/ply_values.hpp"
#include "mesh/ply_vertices.hpp"

namespace mien::formats {
namespace {

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
}

enum class ElementKind { vertices, faces, strips, other };

/// The names of the properties of a face that are read; `none` where it has no such property.
struct FaceLayout {
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::size_t indices = none, texture = none, image = none;
};

bool is_index_list(const PlyProperty& property) {
    return property.is_list && is_one_of(property.name, {"vertex_indices", "vertex_index"});
}

/// Names under which other programs write the same list.
bool is_index_list_by_another_name(const PlyProperty& property) {
    return property.is_list && property.type < PlyType::f32 &&
           (property.name.compare(0, 4, "vert") == 0 ||
            is_one_of(property.name, {"indices", "index", "vi", "v", "corners"}));
}

FaceLayout find_layout(const PlyElement& element, bool strips) {
    FaceLayout layout;
    std::string lists;
    std::size_t num_others = 0, other = 0;
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (is_index_list(property)) {
            layout.indices = k;
        } else if (property.is_list && property.name == "texcoord") {
            if (!strips) layout.texture = k;
        } else if (!property.is_list && property.name == "texnumber") {
            if (!strips) layout.image = k;
        } else if (property.is_list) {
            lists += (lists.empty() ? "'" : ", '") + shown_name(property.name) + "'";
            if (is_index_list_by_another_name(property)) {
                ++num_others;
                other = k;
            }
        }
    }
    if (layout.indices == FaceLayout::none && num_others == 1) layout.indices = other;
    if (layout.indices == FaceLayout::none && element.count != 0)
        fail(Status::bad_format,
             "the PLY file's '%s' has no list 'vertex_indices', but %s: give the list of vertex "
             "numbers this name",
             shown_name(element.name).c_str(), lists.empty() ? "no list" : lists.c_str());
    return layout;
}

template <typename Values>
class PlyReader {
  public:
    PlyReader(const PlyHeader& header, const Values& values, const Source& source,
              const Context& context)
        : header_(header), values_(values), source_(source), context_(context) {}

    TriMesh read() {
        bool has_vertices = false;
        std::size_t done = 0;
        for (const PlyElement& element : header_.elements) {
            const ElementKind kind = kind_of(element);
            // An element without properties has no bytes, whatever its count says.
            if (element.properties.empty() && kind != ElementKind::vertices) continue;
            check_count(element);
            if (kind == ElementKind::vertices) {
                if (has_vertices) fail(Status::bad_format, "the PLY file has two vertex elements");
                has_vertices = true;
                PlyVertices vertices(element, context_);
                vertices.read(values_, context_);
                mesh_.vertices.swap(vertices.points);
                mesh_.colors.swap(vertices.colors);
                vertex_texture_.swap(vertices.texture);
            } else if (kind == ElementKind::other) {
                skip_element(element);
            } else {
                read_polygons(element, kind == ElementKind::strips);
            }
            context_.progress(Stage::reading, static_cast<double>(++done) /
                                                  static_cast<double>(header_.elements.size()));
        }
        if (!has_vertices) fail(Status::bad_format, "the PLY file has no vertex element");
        // Less than a triangle may be a mark of some program; more is a part of the surface.
        constexpr std::size_t kLeastFaceBytes = 6;  // of "3 0 1 2" and of the shortest binary list
        if (const std::size_t bytes = values_.left_over(); bytes > kLeastFaceBytes)
            fail(Status::bad_format,
                 "the PLY file goes on for %zu bytes after the last element that its header "
                 "counts: the header's counts are too small, or the file was put together from "
                 "several",
                 bytes);
        if (plain_.rows() != 0)
            mesh_.triangles.swap(plain_);
        else
            polygons_.finish(mesh_, texture_);
        // Per-vertex coordinates serve only where the faces brought none of their own.
        if (mesh_.texture_triangles.rows() == 0 && !vertex_texture_.empty()) {
            mesh_.texture = Eigen::Map<const TextureCoordinates>(vertex_texture_.data(),
                                                                 mesh_.vertices.rows(), 2);
            mesh_.texture_triangles = mesh_.triangles;
        }
        take_images();
        return std::move(mesh_);
    }

  private:
    ElementKind kind_of(const PlyElement& element) const {
        const std::string name = ply_lower_case(element.name);
        if (is_one_of(name, {"vertex", "vertices", "vertexes"})) return ElementKind::vertices;
        if (is_one_of(name, {"tristrips", "tristrip"})) return ElementKind::strips;
        const auto names_faces = [](const PlyElement& e) {
            return is_one_of(ply_lower_case(e.name),
                             {"face", "faces", "triangle", "triangles", "polygon", "polygons"});
        };
        if (names_faces(element)) return ElementKind::faces;
        // A file without faces, but with their list in an element of another name.
        const bool lists_vertices =
            std::any_of(element.properties.begin(), element.properties.end(), is_index_list);
        const bool any_faces =
            std::any_of(header_.elements.begin(), header_.elements.end(), names_faces);
        return lists_vertices && !any_faces ? ElementKind::faces : ElementKind::other;
    }

    void check_count(const PlyElement& element) const {
        std::uint64_t least = 0;
        for (const PlyProperty& property : element.properties)
            least += Values::least_bytes(property.is_list ? property.count_type : property.type);
        if (least == 0 || element.count > values_.capacity(PlyType::u8) / least)
            fail(Status::bad_format,
                 "the PLY header promises %llu of '%s', more than the file holds",
                 static_cast<unsigned long long>(element.count), shown_name(element.name).c_str());
    }

    void skip_property(const PlyProperty& property, const char* what, std::uint64_t element) {
        values_.skip(property.type, property.is_list ? values_.length(property, what, element) : 1);
    }

    void skip_element(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (i % kCancelInterval == 0) context_.check_cancelled();
            for (const PlyProperty& property : element.properties)
                skip_property(property, "element", i);
        }
    }

    void read_polygons(const PlyElement& element, bool strips) {
        const FaceLayout layout = find_layout(element, strips);
        if (!strips && read_plain_triangles(element)) return;
        std::vector<std::uint32_t> corners, corner_texture;
        std::vector<float> coordinates;
        if (!strips) polygons_.reserve(static_cast<std::size_t>(element.count));
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (i % kCancelInterval == 0) context_.check_cancelled();
            corners.clear();
            coordinates.clear();
            std::uint32_t image = 0;
            for (std::size_t k = 0; k < element.properties.size(); ++k) {
                const PlyProperty& property = element.properties[k];
                if (k == layout.indices) {
                    const std::size_t length = values_.length(property, "face", i);
                    values_.indices(property.type, length, strips, i, corners);
                } else if (k == layout.texture) {
                    coordinates.resize(values_.length(property, "face", i));
                    for (float& value : coordinates)
                        value = static_cast<float>(values_.next(property.type));
                } else if (k == layout.image) {
                    image = image_number(values_.next(property.type), i);
                } else {
                    skip_property(property, "face", i);
                }
            }
            if (strips) {
                add_strips(corners);
                continue;
            }
            const bool textured = !corners.empty() && coordinates.size() == 2 * corners.size();
            if (textured) {
                corner_texture.resize(corners.size());
                for (std::size_t j = 0; j < corners.size(); ++j)
                    corner_texture[j] = static_cast<std::uint32_t>(texture_.size() / 2 + j);
                texture_.insert(texture_.end(), coordinates.begin(), coordinates.end());
            }
            polygons_.add(corners.data(), corners.size(),
                          textured ? corner_texture.data() : nullptr, image);
        }
    }

    /// A file whose only polygons are triangles without anything else is copied as it is.
    bool read_plain_triangles(const PlyElement& element) {
        const auto has_polygons = [&](const PlyElement& e) {
            const ElementKind kind = kind_of(e);
            return kind == ElementKind::faces || kind == ElementKind::strips;
        };
        if (!Values::kBinary || element.properties.size() != 1 || element.count == 0 ||
            std::count_if(header_.elements.begin(), header_.elements.end(), has_polygons) != 1)
            return false;
        context_.check_cancelled();
        const std::size_t count = static_cast<std::size_t>(element.count);
        plain_.resize(static_cast<Index>(count), 3);
        if (values_.plain_triangles(element.properties[0], count, plain_.data())) return true;
        plain_.resize(0, 3);
        return false;
    }

    /// The material of a face: one per texture file, and one without an image for -1.
    std::uint32_t image_number(double value, std::uint64_t face) {
        const std::size_t count = header_.texture_files.size();
        if (count == 0) return 0;
        if (value == -1.0) {
            any_without_image_ = true;
            return static_cast<std::uint32_t>(count);
        }
        if (!(value >= 0.0 && value < static_cast<double>(count)) || value != std::floor(value))
            fail_at(Status::bad_format, static_cast<std::int64_t>(face),
                    "face %llu names texture %g, the header has %zu 'comment TextureFile'",
                    static_cast<unsigned long long>(face), value, count);
        return static_cast<std::uint32_t>(value);
    }

    void take_images() {
        if (mesh_.texture_triangles.rows() == 0) {
            mesh_.triangle_materials.clear();
            return;
        }
        KnownImages known;
        for (const std::string& name : header_.texture_files) {
            Material material;
            material.name = stem_of(shown_name(last_part(name)));
            material.image = add_companion_image(mesh_, source_, name, known, context_);
            mesh_.materials.push_back(std::move(material));
        }
        if (any_without_image_) mesh_.materials.emplace_back();
    }

    void add_strips(const std::vector<std::uint32_t>& numbers) {
        auto begin = numbers.begin();
        while (begin != numbers.end()) {
            const auto end = std::find(begin, numbers.end(), kStripEnd);
            add_strip(&*begin, static_cast<std::size_t>(end - begin));
            begin = end == numbers.end() ? end : end + 1;
        }
    }

    /// Every second triangle of a strip runs the other way round.
    void add_strip(const std::uint32_t* corners, std::size_t count) {
        for (std::size_t k = 2; k < count; ++k) {
            const std::uint32_t triangle[3] = {corners[k - (k % 2 == 0 ? 2 : 1)],
                                               corners[k - (k % 2 == 0 ? 1 : 2)], corners[k]};
            const bool stitch = triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
                                triangle[0] == triangle[2];
            if (!stitch) polygons_.add(triangle, 3, nullptr, 0);
        }
    }

    const PlyHeader& header_;
    Values values_;
    const Source& source_;
    const Context& context_;
    TriMesh mesh_;
    PolygonSink polygons_;
    Triangles plain_;
    std::vector<float> texture_, vertex_texture_;
    bool any_without_image_ = false;
};

bool is_little_endian_machine() {
    const std::uint16_t one = 1;
    unsigned char first;
    std::memcpy(&first, &one, 1);
    return first == 1;
}

}  // namespace

TriMesh read_ply(const Source& source, const Context& context) {
    const char* end = source.bytes.data + source.bytes.size;
    TextCursor text(source.bytes.data, end);
    const PlyHeader header = parse_ply_header(text);
    if (header.encoding == PlyEncoding::ascii)
        return PlyReader<TextValues>(header, TextValues(text), source, context).read();
    const bool little = header.encoding == PlyEncoding::little_endian;
    const BinaryValues values(text.at(), end, little != is_little_endian_machine());
    return PlyReader<BinaryValues>(header, values, source, context).read();
}

}  // namespace mien::formats
