// glTF 2.0 to one mesh: the triangles of all nodes of the scene, moved by their nodes, with the
// base colours' images. Files split vertices where texture coordinates jump; equal positions are
// joined again (of files that Mien wrote: by the numbers they had), and coordinates stay with the
// corners. glTF's texture coordinates run down, a TriMesh's up.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "base/error.hpp"
#include "base/json.hpp"
#include "mesh/companions.hpp"
#include "mesh/gltf.hpp"
#include "mesh/gltf_document.hpp"
#include "mesh/weld.hpp"

namespace mien::formats {
namespace {

using Value = JsonTree::Value;
constexpr std::size_t kDeepestNode = 256;

/// x -> linear * x + translation.
struct Motion {
    Matrix3 linear = Matrix3::Identity();
    Vector3 translation = Vector3::Zero();
    Vector3 apply(const Vector3& x) const { return linear * x + translation; }
    Motion after(const Motion& first) const {
        Motion both;
        both.linear = linear * first.linear;
        both.translation = apply(first.translation);
        return both;
    }
};

std::vector<double> read_doubles(Value list, std::size_t count, const char* what) {
    std::vector<double> values;
    for (Value item : list.items()) values.push_back(item.number(what));
    if (values.size() != count)
        fail(Status::bad_format, "glTF: %s has %zu numbers, not %zu", what, values.size(), count);
    return values;
}

Motion motion_of(Value node) {
    Motion motion;
    // Mien writes millimetres below a node that brings them to glTF's metres.
    if (node["extras"]["origin_mm"].exists()) {
        const auto origin = read_doubles(node["extras"]["origin_mm"], 3, "extras.origin_mm");
        motion.translation = Eigen::Map<const Vector3>(origin.data());
        return motion;
    }
    if (node["matrix"].exists()) {
        const auto m = read_doubles(node["matrix"], 16, "nodes.matrix");
        for (std::size_t column = 0; column < 3; ++column)
            for (std::size_t row = 0; row < 3; ++row)
                motion.linear(static_cast<Index>(row), static_cast<Index>(column)) =
                    m[4 * column + row];
        motion.translation = Vector3(m[12], m[13], m[14]);
        return motion;
    }
    if (node["rotation"].exists()) {
        const auto q = read_doubles(node["rotation"], 4, "nodes.rotation");
        const double x = q[0], y = q[1], z = q[2], w = q[3];
        const double norm = x * x + y * y + z * z + w * w, s = norm > 0.0 ? 2.0 / norm : 0.0;
        motion.linear << 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),
            s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w), s * (x * z - y * w),
            s * (y * z + x * w), 1 - s * (x * x + y * y);
    }
    if (node["scale"].exists()) {
        const auto scale = read_doubles(node["scale"], 3, "nodes.scale");
        for (int k = 0; k < 3; ++k) motion.linear.col(k) *= scale[static_cast<std::size_t>(k)];
    }
    if (node["translation"].exists()) {
        const auto t = read_doubles(node["translation"], 3, "nodes.translation");
        motion.translation = Eigen::Map<const Vector3>(t.data());
    }
    return motion;
}

/// Where the base colour's image lies on the texture coordinates (KHR_texture_transform).
struct TextureMotion {
    double scale[2] = {1.0, 1.0}, offset[2] = {0.0, 0.0}, turn_rad = 0.0;
    std::uint64_t set = 0;  ///< TEXCOORD_<set>
    void apply(float& u, float& v) const {
        const double x = scale[0] * static_cast<double>(u), y = scale[1] * static_cast<double>(v);
        const double c = std::cos(turn_rad), s = std::sin(turn_rad);
        u = static_cast<float>(c * x + s * y + offset[0]);
        v = static_cast<float>(-s * x + c * y + offset[1]);
    }
    bool moves() const {
        return scale[0] != 1.0 || scale[1] != 1.0 || offset[0] != 0.0 || offset[1] != 0.0 ||
               turn_rad != 0.0;
    }
};

class GltfReader {
  public:
    GltfReader(const Source& source, std::vector<MorphTarget>* targets, const Context& context)
        : source_(source), document_(source, context), targets_(targets), context_(context) {}

    TriMesh read() {
        check_extensions();
        for (std::uint64_t k = 0; k < document_.size_of("materials"); ++k)
            read_material(document_.at("materials", k));
        if (document_.size_of("scenes") != 0) {
            const std::uint64_t scene = document_.root()["scene"].count("scene", 0);
            for (Value node : document_.at("scenes", scene)["nodes"].items())
                read_node(node.count("scenes.nodes"), Motion(), 0);
        } else {
            for (std::uint64_t k = 0; k < document_.size_of("nodes"); ++k)
                if (!is_child(k)) read_node(k, Motion(), 0);
            for (std::uint64_t k = 0;
                 document_.size_of("nodes") == 0 && k < document_.size_of("meshes"); ++k)
                read_mesh(document_.at("meshes", k), Motion());
        }
        if (positions_.empty())
            fail(Status::bad_format, "glTF: the scene has no mesh of triangles and no points");
        return finish();
    }

  private:
    void check_extensions() const {
        for (Value extension : document_.root()["extensionsRequired"].items()) {
            const std::string name = extension.text("extensionsRequired");
            const bool known = name == "KHR_mesh_quantization" || name == "KHR_texture_transform" ||
                               name == "EXT_texture_webp" || name == "KHR_texture_basisu" ||
                               name.compare(0, 14, "KHR_materials_") == 0 ||
                               name == "KHR_lights_punctual";
            if (!known)
                fail(Status::bad_format,
                     "glTF: the file needs the extension '%s', which is not read; export it "
                     "without compression",
                     shown_name(name).c_str());
        }
    }

    bool is_child(std::uint64_t node) const {
        if (!children_known_) {
            child_.assign(static_cast<std::size_t>(document_.size_of("nodes")), 0);
            for (std::uint64_t k = 0; k < child_.size(); ++k)
                for (Value child : document_.at("nodes", k)["children"].items()) {
                    const std::uint64_t number = child.count("nodes.children");
                    if (number < child_.size()) child_[static_cast<std::size_t>(number)] = 1;
                }
            children_known_ = true;
        }
        return child_[static_cast<std::size_t>(node)] != 0;
    }

    void read_node(std::uint64_t number, const Motion& parent, std::size_t depth) {
        if (depth > kDeepestNode || ++num_nodes_read_ > 4 * document_.size_of("nodes") + 64)
            fail(Status::bad_format, "glTF: the nodes form a circle or are nested too deep");
        const Value node = document_.at("nodes", number);
        const Motion motion = parent.after(motion_of(node));
        if (node["mesh"].exists()) {
            // A skin's joints, not its node, place a skinned mesh: it is read as it was bound.
            const bool skinned = node["skin"].exists();
            if (skinned)
                context_.log(LogLevel::warning, "glTF: a skinned mesh is read as it was bound");
            read_mesh(document_.at("meshes", node["mesh"].count("nodes.mesh")),
                      skinned ? Motion() : motion);
        }
        for (Value child : node["children"].items())
            read_node(child.count("nodes.children"), motion, depth + 1);
    }

    void read_material(Value entry) {
        Material material;
        material.name = entry["name"].text("materials.name", "");
        const Value surface = entry["pbrMetallicRoughness"];
        if (surface["baseColorFactor"].exists()) {
            const auto color = read_doubles(surface["baseColorFactor"], 4, "baseColorFactor");
            for (std::size_t k = 0; k < 3; ++k)
                material.color[k] = static_cast<float>(std::min(std::max(color[k], 0.0), 1.0));
        }
        TextureMotion motion;
        const Value texture = surface["baseColorTexture"];
        if (texture.exists()) {
            motion.set = texture["texCoord"].count("texCoord", 0);
            const Value moved = texture["extensions"]["KHR_texture_transform"];
            for (const char* name : {"scale", "offset"})
                if (moved[name].exists()) {
                    const auto pair = read_doubles(moved[name], 2, "KHR_texture_transform");
                    double* to = *name == 's' ? motion.scale : motion.offset;
                    std::copy(pair.begin(), pair.end(), to);
                }
            motion.turn_rad = moved["rotation"].number("KHR_texture_transform", 0.0);
            motion.set = moved["texCoord"].count("texCoord", motion.set);
            const Value used =
                document_.at("textures", texture["index"].count("baseColorTexture.index"));
            if (used["source"].exists())
                material.image = read_image(used["source"].count("textures.source"));
            else
                context_.log(LogLevel::warning, "glTF: a texture's image is of a kind not read");
        }
        materials_.push_back(std::move(material));
        motions_.push_back(motion);
    }

    std::int32_t read_image(std::uint64_t number) {
        const auto known = images_.find(number);
        if (known != images_.end()) return known->second;
        const Value entry = document_.at("images", number);
        auto image = std::make_shared<TextureImage>();
        image->name = last_part(entry["name"].text("images.name", ""));
        if (entry["bufferView"].exists()) {
            const auto span = document_.buffer_view(entry["bufferView"].count("images.bufferView"));
            image->encoded.assign(span.data, span.size);
        } else {
            const std::string uri = entry["uri"].text("images.uri");
            if (!decode_data_uri(uri, image->encoded)) {
                FileBytes bytes;
                const std::string name = decode_percent(uri);
                if (read_companion(source_, name, bytes, context_))
                    image->encoded.assign(bytes.data, bytes.size);
                image->name = last_part(name);
            }
        }
        if (!is_utf8(image->name)) image->name = shown_name(image->name);
        std::int32_t index = -1;
        if (!image->encoded.empty()) {
            index = static_cast<std::int32_t>(mesh_.images.size());
            mesh_.images.push_back(std::move(image));
        }
        images_.emplace(number, index);
        return index;
    }

    void read_mesh(Value mesh, const Motion& motion) {
        std::vector<std::string> names;
        for (Value name : mesh["extras"]["targetNames"].items())
            names.push_back(name.text("targetNames"));
        shared_.clear();
        for (Value primitive : mesh["primitives"].items()) {
            context_.check_cancelled();
            const std::uint64_t mode = primitive["mode"].count("primitives.mode", 4);
            if (mode > 6) fail(Status::bad_format, "glTF: a primitive has an unknown mode");
            if (mode >= 1 && mode <= 3) continue;  // lines
            read_primitive(primitive, static_cast<int>(mode), motion, names);
        }
    }

    /// The material's number among those used, in the order of their first use.
    std::uint32_t material_of(Value primitive) {
        const std::uint64_t none = materials_.size();
        std::uint64_t number = primitive["material"].count("primitives.material", none);
        if (number > none) document_.at("materials", number);
        const auto known = used_materials_.find(number);
        if (known != used_materials_.end()) return known->second;
        const auto index = static_cast<std::uint32_t>(mesh_.materials.size());
        mesh_.materials.push_back(number == none ? Material()
                                                 : materials_[static_cast<std::size_t>(number)]);
        used_materials_.emplace(number, index);
        return index;
    }

    void read_primitive(Value primitive, int mode, const Motion& motion,
                        const std::vector<std::string>& target_names) {
        const Value attributes = primitive["attributes"];
        const std::uint64_t accessor = attributes["POSITION"].count("attributes.POSITION");
        const std::uint64_t material =
            primitive["material"].count("primitives.material", motions_.size());
        const TextureMotion placed = material < motions_.size()
                                         ? motions_[static_cast<std::size_t>(material)]
                                         : TextureMotion();
        // Primitives of one mesh may share their vertices.
        const auto shared = shared_.find(accessor);
        std::size_t first = positions_.size() / 3;
        if (shared != shared_.end() && !primitive["targets"].exists())
            first = shared->second;
        else
            read_vertices(attributes, accessor, motion);
        const std::size_t count = static_cast<std::size_t>(document_.count_of(accessor));
        if (shared == shared_.end()) shared_.emplace(accessor, first);
        if (targets_ != nullptr) read_targets(primitive, first, count, motion, target_names);
        if (mode == 0) return;
        std::vector<std::uint32_t> corners;
        if (primitive["indices"].exists()) {
            corners = document_.indices(primitive["indices"].count("primitives.indices"));
        } else {
            corners.resize(count);
            for (std::size_t k = 0; k < count; ++k) corners[k] = static_cast<std::uint32_t>(k);
        }
        add_triangles(corners, mode, first, count, motion.linear.determinant() < 0.0,
                      material_of(primitive), texture_of(attributes, placed, count));
    }

    void read_vertices(Value attributes, std::uint64_t accessor, const Motion& motion) {
        const std::vector<float> points = document_.numbers(accessor, 3, 0);
        const std::size_t count = points.size() / 3, first = positions_.size() / 3;
        // Every vertex has at least a byte in the file: more would be one mesh many times over.
        if (count > document_.file_size() || first > document_.file_size() - count)
            fail(Status::bad_format, "glTF: more vertices than the file holds");
        context_.require_memory(60 * count, "a glTF file's vertices");
        for (std::size_t i = 0; i < count; ++i) {
            const Vector3 point(static_cast<double>(points[3 * i]),
                                static_cast<double>(points[3 * i + 1]),
                                static_cast<double>(points[3 * i + 2]));
            const Vector3 moved = motion.apply(point);
            positions_.insert(positions_.end(), moved.data(), moved.data() + 3);
        }
        if (attributes["COLOR_0"].exists()) {
            const auto colors =
                document_.colors(attributes["COLOR_0"].count("attributes.COLOR_0"), count);
            colors_.resize(3 * first, 1.f);
            colors_.insert(colors_.end(), colors.begin(), colors.end());
        }
        if (attributes["_VERTEX"].exists()) {
            const auto numbers =
                document_.numbers(attributes["_VERTEX"].count("attributes._VERTEX"), 1, count);
            own_numbers_.resize(first, -1.f);
            own_numbers_.insert(own_numbers_.end(), numbers.begin(), numbers.end());
        }
    }

    /// 2 x count, v upwards, or nothing.
    std::vector<float> texture_of(Value attributes, const TextureMotion& placed,
                                  std::size_t count) const {
        const std::string name = "TEXCOORD_" + std::to_string(placed.set);
        if (!attributes[name.c_str()].exists()) return {};
        std::vector<float> values =
            document_.numbers(attributes[name.c_str()].count("TEXCOORD"), 2, count);
        for (std::size_t k = 0; k + 1 < values.size(); k += 2) {
            if (placed.moves()) placed.apply(values[k], values[k + 1]);
            values[k + 1] = 1.f - values[k + 1];
        }
        return values;
    }

    void add_triangles(const std::vector<std::uint32_t>& corners, int mode, std::size_t first,
                       std::size_t count, bool mirrored, std::uint32_t material,
                       const std::vector<float>& texture) {
        for (std::uint32_t corner : corners)
            if (corner >= count)
                fail(Status::bad_format, "glTF: an index is %lu, the primitive has %zu vertices",
                     static_cast<unsigned long>(corner), count);
        num_corners_ += corners.size();
        if (num_corners_ > 3 * document_.file_size())
            fail(Status::bad_format,
                 "glTF: more triangles than the file holds: its nodes form a circle, or name one "
                 "mesh very often");
        const auto texture_first = static_cast<std::uint32_t>(texture_.size() / 2);
        texture_.insert(texture_.end(), texture.begin(), texture.end());
        const std::size_t step = mode == 4 ? 3 : 1;
        for (std::size_t k = 0; k + 2 < corners.size(); k += step) {
            // Strips turn every second triangle; fans keep their first corner.
            std::uint32_t c[3] = {corners[mode == 6 ? 0 : k], corners[k + 1], corners[k + 2]};
            if ((mode == 5 && k % 2 == 1) != mirrored) std::swap(c[1], c[2]);
            std::uint32_t vertices[3], places[3];
            for (int j = 0; j < 3; ++j) {
                vertices[j] = c[j] + static_cast<std::uint32_t>(first);
                places[j] = c[j] + texture_first;
            }
            polygons_.add(vertices, 3, texture.empty() ? nullptr : places, material);
        }
    }

    void read_targets(Value primitive, std::size_t first, std::size_t count, const Motion& motion,
                      const std::vector<std::string>& names) {
        std::size_t number = 0;
        for (Value target : primitive["targets"].items()) {
            if (number == targets_->size()) {
                targets_->emplace_back();
                targets_->back().name =
                    number < names.size() ? names[number] : "target_" + std::to_string(number);
                offsets_.emplace_back();
            }
            if (target["POSITION"].exists()) {
                const auto values =
                    document_.numbers(target["POSITION"].count("targets.POSITION"), 3, count);
                context_.require_memory(24 * (first + count), "morph targets");
                std::vector<double>& offsets = offsets_[number];
                offsets.resize(3 * (first + count), 0.0);
                for (std::size_t i = 0; i < count; ++i) {
                    const Vector3 offset =
                        motion.linear * Vector3(static_cast<double>(values[3 * i]),
                                                static_cast<double>(values[3 * i + 1]),
                                                static_cast<double>(values[3 * i + 2]));
                    std::copy(offset.data(), offset.data() + 3,
                              offsets.begin() + static_cast<std::ptrdiff_t>(3 * (first + i)));
                }
            }
            ++number;
        }
    }

    /// For each vertex of the file the number of the mesh's, and how many those are.
    std::vector<std::uint32_t> joined(std::size_t& count) const {
        const std::size_t total = positions_.size() / 3;
        if (own_numbers_.size() == total) {
            std::vector<std::uint32_t> numbers(total);
            std::vector<std::uint8_t> seen(total, 0);
            count = 0;
            bool sound = true;
            for (std::size_t i = 0; i < total && sound; ++i) {
                const float number = own_numbers_[i];
                sound = number >= 0.f && number < static_cast<float>(total) &&
                        number == std::floor(number);
                if (!sound) break;
                numbers[i] = static_cast<std::uint32_t>(number);
                sound = numbers[i] < total;
                if (!sound) break;
                count += seen[numbers[i]] == 0 ? 1 : 0;
                seen[numbers[i]] = 1;
            }
            for (std::size_t v = 0; v < count && sound; ++v) sound = seen[v] != 0;
            if (sound) return numbers;
        }
        const Eigen::Map<const Points> points(positions_.data(), static_cast<Index>(total), 3);
        WeldedPoints welded = weld_points(points, context_);
        count = welded.first_point.size();
        return std::move(welded.class_of);
    }

    TriMesh finish() {
        std::size_t count = 0;
        const std::size_t total = positions_.size() / 3;
        const std::vector<std::uint32_t> number = joined(count);
        mesh_.vertices.resize(static_cast<Index>(count), 3);
        if (!colors_.empty()) colors_.resize(positions_.size(), 1.f);
        std::vector<float> colors(colors_.empty() ? 0 : 3 * count);
        for (std::size_t i = total; i-- > 0;) {
            // Backwards, so that of joined vertices the first one stays.
            const Index row = static_cast<Index>(number[i]);
            for (int k = 0; k < 3; ++k)
                mesh_.vertices(row, k) = positions_[3 * i + static_cast<std::size_t>(k)];
            for (std::size_t k = 0; k < 3 && !colors.empty(); ++k)
                colors[3 * number[i] + k] = colors_[3 * i + k];
        }
        if (!colors.empty()) mesh_.colors = colors_from_numbers(colors);
        polygons_.finish(mesh_, texture_);
        for (Index k = 0; k < mesh_.triangles.size(); ++k)
            mesh_.triangles.data()[k] = number[mesh_.triangles.data()[k]];
        for (std::size_t t = 0; targets_ != nullptr && t < targets_->size(); ++t) {
            offsets_[t].resize(positions_.size(), 0.0);
            Points& offsets = (*targets_)[t].offsets;
            offsets.setZero(static_cast<Index>(count), 3);
            for (std::size_t i = total; i-- > 0;)
                for (int k = 0; k < 3; ++k)
                    offsets(static_cast<Index>(number[i]), k) =
                        offsets_[t][3 * i + static_cast<std::size_t>(k)];
        }
        // A file of one material that says nothing has none.
        const bool silent = mesh_.materials.size() == 1 && used_materials_.count(materials_.size());
        if (silent || mesh_.triangles.rows() == 0) {
            mesh_.materials.clear();
            mesh_.triangle_materials.clear();
        }
        return std::move(mesh_);
    }

    const Source& source_;
    GltfDocument document_;
    std::vector<MorphTarget>* targets_;
    const Context& context_;
    TriMesh mesh_;
    PolygonSink polygons_;
    std::vector<Material> materials_;
    std::vector<TextureMotion> motions_;  ///< of materials_
    std::map<std::uint64_t, std::int32_t> images_;
    std::map<std::uint64_t, std::uint32_t> used_materials_;
    std::map<std::uint64_t, std::size_t> shared_;  ///< POSITION accessor to its first vertex
    std::vector<double> positions_;
    std::vector<float> colors_, texture_, own_numbers_;
    std::vector<std::vector<double>> offsets_;
    mutable std::vector<std::uint8_t> child_;
    mutable bool children_known_ = false;
    std::uint64_t num_nodes_read_ = 0, num_corners_ = 0;
};

}  // namespace

TriMesh read_gltf_document(const Source& source, std::vector<MorphTarget>* targets,
                           const Context& context) {
    return GltfReader(source, targets, context).read();
}

TriMesh read_gltf(const Source& source, const Context& context) {
    return read_gltf_document(source, nullptr, context);
}

}  // namespace mien::formats
