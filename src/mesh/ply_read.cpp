// PLY in its three encodings, any order and type of properties; unknown elements and properties are
// stepped over. Own reader because OpenMesh's prints to stderr and trusts its input's counts.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/json.hpp"
#include "mesh/formats.hpp"
#include "mesh/ply_header.hpp"

namespace mien::formats {
namespace {

/// The values of the data part one by one; every read is held against the end of the file.
class BinaryValues {
  public:
    BinaryValues(const char* begin, const char* end, bool big_endian)
        : begin_(begin), at_(begin), end_(end), big_endian_(big_endian) {}

    double next(PlyType type) {
        const std::size_t bytes = ply_type_bytes(type);
        if (bytes > static_cast<std::size_t>(end_ - at_)) fail_truncated();
        unsigned char raw[8];
        std::memcpy(raw, at_, bytes);
        at_ += bytes;
        if (big_endian_) std::reverse(raw, raw + bytes);
        switch (type) {
            case PlyType::i8:
                return as<std::int8_t>(raw);
            case PlyType::u8:
                return as<std::uint8_t>(raw);
            case PlyType::i16:
                return as<std::int16_t>(raw);
            case PlyType::u16:
                return as<std::uint16_t>(raw);
            case PlyType::i32:
                return as<std::int32_t>(raw);
            case PlyType::u32:
                return as<std::uint32_t>(raw);
            case PlyType::f32:
                return static_cast<double>(as<float>(raw));
            case PlyType::f64:
                return as<double>(raw);
        }
        return 0.0;
    }
    void skip(PlyType type, std::uint64_t count) {
        const std::size_t bytes = ply_type_bytes(type);
        if (count > static_cast<std::size_t>(end_ - at_) / bytes) fail_truncated();
        at_ += static_cast<std::size_t>(count) * bytes;
    }
    static std::uint64_t least_bytes(PlyType type) { return ply_type_bytes(type); }
    /// How many values of this type may still follow.
    std::uint64_t capacity(PlyType type) const {
        return static_cast<std::uint64_t>(end_ - at_) / ply_type_bytes(type);
    }

  private:
    template <typename T>
    static T as(const unsigned char* raw) {
        T value;
        std::memcpy(&value, raw, sizeof value);
        return value;
    }
    [[noreturn]] void fail_truncated() const {
        fail_at(Status::bad_format, at_ - begin_, "the file ends within its data, after %lld bytes",
                static_cast<long long>(at_ - begin_));
    }

    const char* begin_;
    const char* at_;
    const char* end_;
    bool big_endian_;
};

class TextValues {
  public:
    explicit TextValues(const TextCursor& text) : text_(text) {}

    double next(PlyType) {
        double value = 0.0;
        text_.skip_space();
        if (!text_.number(value))
            fail_at(Status::bad_format, text_.line(),
                    text_.at_end() ? "the file ends within its data, at line %lld"
                                   : "line %lld: not a number",
                    static_cast<long long>(text_.line()));
        return value;
    }
    void skip(PlyType type, std::uint64_t count) {
        for (; count != 0; --count) next(type);
    }
    static std::uint64_t least_bytes(PlyType) { return 1; }
    std::uint64_t capacity(PlyType) const { return text_.remaining() / 2 + 1; }

  private:
    TextCursor text_;
};

std::uint32_t to_index(double value, const char* what, std::uint64_t element) {
    // 2^32 - 1 itself is the mark for "none".
    if (!(value >= 0.0 && value < 4294967295.0 && value == std::floor(value)))
        fail_at(Status::bad_format, static_cast<std::int64_t>(element), "%s %llu: %g is no index",
                what, static_cast<unsigned long long>(element), value);
    return static_cast<std::uint32_t>(value);
}

/// A list's length, held against what the file can still contain.
template <typename Values>
std::size_t read_length(Values& values, const PlyProperty& property, const char* what,
                        std::uint64_t element) {
    const double length = values.next(property.count_type);
    if (!(length >= 0.0) || length != std::floor(length) ||
        length > static_cast<double>(values.capacity(property.type)))
        fail_at(Status::bad_format, static_cast<std::int64_t>(element),
                "%s %llu has a list of %g values, more than the file holds", what,
                static_cast<unsigned long long>(element), length);
    return static_cast<std::size_t>(length);
}

template <typename Values>
void skip_property(Values& values, const PlyProperty& property, const char* what,
                   std::uint64_t element) {
    if (property.is_list)
        values.skip(property.type, read_length(values, property, what, element));
    else
        values.skip(property.type, 1);
}

enum VertexRole { x, y, z, red, green, blue, u, v, none };

VertexRole role_of(const PlyProperty& property) {
    static const struct {
        const char* name;
        VertexRole role;
    } kNames[] = {{"x", x},
                  {"y", y},
                  {"z", z},
                  {"red", red},
                  {"green", green},
                  {"blue", blue},
                  {"diffuse_red", red},
                  {"diffuse_green", green},
                  {"diffuse_blue", blue},
                  {"r", red},
                  {"g", green},
                  {"b", blue},
                  {"s", u},
                  {"t", v},
                  {"u", u},
                  {"v", v},
                  {"texture_u", u},
                  {"texture_v", v}};
    if (!property.is_list)
        for (const auto& entry : kNames)
            if (property.name == entry.name) return entry.role;
    return none;
}

template <typename Values>
class PlyReader {
  public:
    PlyReader(const PlyHeader& header, const Values& values, const Context& context)
        : header_(header), values_(values), context_(context) {}

    TriMesh read() {
        bool has_vertices = false;
        std::size_t done = 0;
        for (const PlyElement& element : header_.elements) {
            // An element without properties has no bytes, whatever its count says.
            if (element.properties.empty() && element.name != "vertex") continue;
            check_count(element);
            if (element.name == "vertex") {
                if (has_vertices) fail(Status::bad_format, "the PLY file has two vertex elements");
                has_vertices = true;
                read_vertices(element);
            } else if (element.name == "face" || element.name == "tristrips") {
                read_polygons(element, element.name == "tristrips");
            } else {
                for (std::uint64_t i = 0; i < element.count; ++i) {
                    if (i % kCancelInterval == 0) context_.check_cancelled();
                    for (const PlyProperty& property : element.properties)
                        skip_property(values_, property, "element", i);
                }
            }
            context_.progress(Stage::reading, static_cast<double>(++done) /
                                                  static_cast<double>(header_.elements.size()));
        }
        if (!has_vertices) fail(Status::bad_format, "the PLY file has no vertex element");
        polygons_.finish(mesh_, texture_);
        // Per-vertex coordinates serve only where the faces brought none of their own.
        if (mesh_.texture_triangles.rows() == 0 && !vertex_texture_.empty()) {
            mesh_.texture = Eigen::Map<const TextureCoordinates>(vertex_texture_.data(),
                                                                 mesh_.vertices.rows(), 2);
            mesh_.texture_triangles = mesh_.triangles;
        }
        return std::move(mesh_);
    }

  private:
    void check_count(const PlyElement& element) const {
        std::uint64_t least = 0;
        for (const PlyProperty& property : element.properties)
            least += Values::least_bytes(property.is_list ? property.count_type : property.type);
        if (least == 0 || element.count > values_.capacity(PlyType::u8) / least)
            fail(Status::bad_format,
                 "the PLY header promises %llu of '%s', more than the file holds",
                 static_cast<unsigned long long>(element.count), shown_name(element.name).c_str());
    }

    void read_vertices(const PlyElement& element) {
        std::vector<VertexRole> roles;
        bool found[none + 1] = {};
        bool float_colors = false;
        for (const PlyProperty& property : element.properties) {
            VertexRole role = role_of(property);
            if (found[role]) role = none;
            roles.push_back(role);
            if (role == none) continue;
            found[role] = true;
            if (role >= red && role <= blue)
                float_colors = float_colors || property.type >= PlyType::f32;
        }
        if (!found[x] || !found[y] || !found[z])
            fail(Status::bad_format, "the PLY file's vertices lack x, y or z");
        const bool has_colors = found[red] && found[green] && found[blue];
        const bool has_texture = found[u] && found[v];
        for (VertexRole& role : roles)
            if ((role >= red && role <= blue && !has_colors) || (role >= u && !has_texture))
                role = none;
        const std::size_t count = static_cast<std::size_t>(element.count);
        context_.require_memory(count * (24 + (has_colors ? 15 : 0) + (has_texture ? 8 : 0)),
                                "a mesh file's vertices");
        mesh_.vertices.resize(static_cast<Index>(count), 3);
        if (has_colors && !float_colors) mesh_.colors.resize(static_cast<Index>(count), 3);
        std::vector<float> color_numbers(has_colors && float_colors ? 3 * count : 0);
        if (has_texture) vertex_texture_.resize(2 * count);

        for (std::size_t i = 0; i < count; ++i) {
            if (i % kCancelInterval == 0) context_.check_cancelled();
            const Index row = static_cast<Index>(i);
            for (std::size_t k = 0; k < roles.size(); ++k) {
                const PlyProperty& property = element.properties[k];
                const VertexRole role = roles[k];
                if (role == none) {
                    skip_property(values_, property, "vertex", i);
                    continue;
                }
                const double value = values_.next(property.type);
                if (role <= z) {
                    mesh_.vertices(row, role) = value;
                } else if (role <= blue && float_colors) {
                    color_numbers[3 * i + static_cast<std::size_t>(role - red)] =
                        static_cast<float>(value);
                } else if (role <= blue) {
                    const double byte = property.type == PlyType::u16 ? value / 257.0 : value;
                    mesh_.colors(row, role - red) =
                        static_cast<std::uint8_t>(byte >= 0.0 ? std::min(byte + 0.5, 255.0) : 0.0);
                } else {
                    vertex_texture_[2 * i + static_cast<std::size_t>(role - u)] =
                        std::isfinite(value) ? static_cast<float>(value) : 0.0f;
                }
            }
        }
        if (float_colors && has_colors) mesh_.colors = colors_from_numbers(color_numbers);
    }

    void read_polygons(const PlyElement& element, bool strips) {
        std::size_t index_at = element.properties.size(), texture_at = element.properties.size();
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (!property.is_list) continue;
            if (property.name == "vertex_indices" || property.name == "vertex_index") index_at = k;
            if (property.name == "texcoord" && !strips) texture_at = k;
        }
        std::vector<std::uint32_t> corners, corner_texture;
        std::vector<float> coordinates;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (i % kCancelInterval == 0) context_.check_cancelled();
            corners.clear();
            coordinates.clear();
            for (std::size_t k = 0; k < element.properties.size(); ++k) {
                const PlyProperty& property = element.properties[k];
                if (k != index_at && k != texture_at) {
                    skip_property(values_, property, "face", i);
                    continue;
                }
                const std::size_t length = read_length(values_, property, "face", i);
                for (std::size_t j = 0; j < length; ++j) {
                    const double value = values_.next(property.type);
                    if (k == texture_at)
                        coordinates.push_back(static_cast<float>(value));
                    else if (strips && value == -1.0)
                        end_strip(corners);
                    else
                        corners.push_back(to_index(value, "face", i));
                }
            }
            if (strips) {
                end_strip(corners);
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
                          textured ? corner_texture.data() : nullptr);
        }
    }

    /// Every second triangle of a strip runs the other way round.
    void end_strip(std::vector<std::uint32_t>& corners) {
        for (std::size_t k = 2; k < corners.size(); ++k) {
            const std::uint32_t triangle[3] = {corners[k - (k % 2 == 0 ? 2 : 1)],
                                               corners[k - (k % 2 == 0 ? 1 : 2)], corners[k]};
            const bool stitch = triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
                                triangle[0] == triangle[2];
            if (!stitch) polygons_.add(triangle, 3, nullptr);
        }
        corners.clear();
    }

    const PlyHeader& header_;
    Values values_;
    const Context& context_;
    TriMesh mesh_;
    PolygonSink polygons_;
    std::vector<float> texture_, vertex_texture_;
};

}  // namespace

TriMesh read_ply(const FileBytes& bytes, const Context& context) {
    TextCursor text(bytes.data, bytes.data + bytes.size);
    const PlyHeader header = parse_ply_header(text);
    if (header.encoding == PlyEncoding::ascii)
        return PlyReader<TextValues>(header, TextValues(text), context).read();
    const BinaryValues values(text.at(), bytes.data + bytes.size,
                              header.encoding == PlyEncoding::big_endian);
    return PlyReader<BinaryValues>(header, values, context).read();
}

}  // namespace mien::formats
