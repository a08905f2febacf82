// One mesh as a GLB file: a vertex for each of the mesh's, and one more for each further texture
// coordinate that it has at some corner; "_VERTEX" says whose it is. A primitive for each material,
// a morph target for each named change, images as they are. Positions are float32 in millimetres
// around an origin, below a node that brings them to glTF's metres.
#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "mesh/format_table.hpp"
#include "mesh/gltf.hpp"
#include "mesh/image.hpp"

namespace mien {
namespace formats {
namespace {

constexpr std::uint32_t kEnd = 0xffffffffu;

/// The file's vertices beyond the mesh's own, and for each corner its vertex in the file.
struct SplitVertices {
    std::vector<std::uint32_t> vertex;   ///< of each file vertex
    std::vector<std::uint32_t> texture;  ///< of each file vertex; kEnd: none
    Triangles corners;                   ///< #F x 3

    explicit SplitVertices(const TriMesh& mesh) : corners(mesh.triangles) {
        const std::size_t count = static_cast<std::size_t>(mesh.vertices.rows());
        vertex.resize(count);
        for (std::size_t v = 0; v < count; ++v) vertex[v] = static_cast<std::uint32_t>(v);
        texture.assign(count, kEnd);
        if (mesh.texture_triangles.rows() == 0) return;
        std::vector<std::uint32_t> next(count, kEnd);
        for (Index k = 0; k < corners.size(); ++k) {
            const std::uint32_t wanted = mesh.texture_triangles.data()[k];
            std::uint32_t at = corners.data()[k];
            if (texture[at] == kEnd) texture[at] = wanted;
            while (texture[at] != wanted && next[at] != kEnd) at = next[at];
            if (texture[at] != wanted) {
                next[at] = static_cast<std::uint32_t>(vertex.size());
                at = next[at];
                vertex.push_back(mesh.triangles.data()[k]);
                texture.push_back(wanted);
                next.push_back(kEnd);
            }
            corners.data()[k] = at;
        }
    }
};

/// Collects the document's lists while the layout of its one buffer grows.
class GlbWriter {
  public:
    GlbWriter(Target& target, const TriMesh& mesh, const std::vector<MorphTarget>& targets,
              const Context& context)
        : target_(target), mesh_(mesh), targets_(targets), context_(context), split_(mesh) {
        count_ = split_.vertex.size();
        if (!needs_double(mesh)) return;
        origin_ =
            0.5 *
            (mesh.vertices.colwise().minCoeff() + mesh.vertices.colwise().maxCoeff()).transpose();
        // Whole millimetres, so that the difference is exact where the file's digits are few.
        for (int k = 0; k < 3; ++k) origin_[k] = std::round(origin_[k]);
    }

    void write() {
        for (const auto& image : mesh_.images) {
            const bool pixels = kind_of_image(*image) == ImageKind::pixels;
            encoded_.push_back(pixels ? encode_png(*image, context_) : std::string());
        }
        std::string json = document();
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const std::uint64_t total = 12 + 8 + json.size() + 8 + size_;
        if (total > std::numeric_limits<std::uint32_t>::max())
            fail(Status::invalid_mesh, "a GLB file holds at most 4 GB; use PLY");
        out_ = "glTF";
        put<std::uint32_t>(2);
        put(static_cast<std::uint32_t>(total));
        put(static_cast<std::uint32_t>(json.size()));
        out_ += "JSON" + json;
        put(static_cast<std::uint32_t>(size_));
        out_.append("BIN\0", 4);
        write_arrays();
        target_.file.write(out_);
    }

  private:
    template <typename T>
    void put(T value) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof value);
        out_.append(raw, sizeof raw);
    }
    void flush() { write_when_long(target_.file, out_, context_); }

    const std::string& bytes_of_image(std::size_t k) const {
        return encoded_[k].empty() ? mesh_.images[k]->encoded : encoded_[k];
    }

    /// A view of the next `bytes` of the buffer; returns its number.
    std::int64_t add_view(std::uint64_t bytes, std::int64_t use = 0) {
        views_.begin_object().field("buffer", 0).field("byteOffset", size_);
        views_.field("byteLength", bytes);
        if (use != 0) views_.field("target", use);
        views_.end_object();
        size_ += (bytes + 3) / 4 * 4;
        return num_views_++;
    }

    /// An open accessor object: the caller may add to it and must end it.
    JsonText& begin_accessor(std::int64_t view, std::uint64_t offset, int component,
                             const char* type, std::uint64_t count) {
        accessors_.begin_object().field("bufferView", view).field("componentType", component);
        if (offset != 0) accessors_.field("byteOffset", offset);
        ++num_accessors_;
        return accessors_.field("type", type).field("count", count);
    }

    Eigen::RowVector3f position(std::size_t i) const {
        const Index v = static_cast<Index>(split_.vertex[i]);
        return (mesh_.vertices.row(v) - origin_.transpose()).cast<float>();
    }

    void add_bounds(const Eigen::RowVector3f& lower, const Eigen::RowVector3f& upper) {
        for (const bool first : {true, false}) {
            accessors_.key(first ? "min" : "max").begin_array();
            for (int k = 0; k < 3; ++k)
                accessors_.number(static_cast<double>(first ? lower[k] : upper[k]));
            accessors_.end_array();
        }
    }

    /// Views and accessors of a vertex's arrays; the attributes' JSON.
    std::string attributes() {
        constexpr std::int64_t kVertices = 34962;
        JsonText text;
        text.begin_object().field("POSITION", num_accessors_);
        begin_accessor(add_view(12 * count_, kVertices), 0, 5126, "VEC3", count_);
        Eigen::RowVector3f lower = position(0), upper = lower;
        for (std::size_t i = 1; i < count_; ++i) {
            lower = lower.cwiseMin(position(i));
            upper = upper.cwiseMax(position(i));
        }
        add_bounds(lower, upper);
        accessors_.end_object();
        if (has_texture()) {
            text.field("TEXCOORD_0", num_accessors_);
            begin_accessor(add_view(8 * count_, kVertices), 0, 5126, "VEC2", count_).end_object();
        }
        if (has_colors()) {
            text.field("COLOR_0", num_accessors_);
            begin_accessor(add_view(4 * count_, kVertices), 0, 5121, "VEC4", count_)
                .field("normalized", true)
                .end_object();
        }
        if (has_numbers()) {
            text.field("_VERTEX", num_accessors_);
            begin_accessor(add_view(4 * count_, kVertices), 0, 5126, "SCALAR", count_).end_object();
        }
        return text.end_object().take();
    }

    bool has_texture() const { return mesh_.texture_triangles.rows() != 0; }
    bool has_colors() const { return mesh_.colors.rows() != 0; }
    /// float32 counts to 2^24 without a gap.
    bool has_numbers() const { return mesh_.vertices.rows() <= (Index(1) << 24); }

    std::string target_list() {
        JsonText text;
        text.begin_array();
        for (const MorphTarget& target : targets_) {
            text.begin_object().field("POSITION", num_accessors_).end_object();
            begin_accessor(add_view(12 * count_), 0, 5126, "VEC3", count_);
            const Eigen::MatrixXf offsets = target.offsets.cast<float>();
            add_bounds(offsets.colwise().minCoeff(), offsets.colwise().maxCoeff());
            accessors_.end_object();
        }
        return text.end_array().take();
    }

    std::size_t material_of(std::size_t t) const {
        return mesh_.triangle_materials.empty() ? 0 : mesh_.triangle_materials[t];
    }

    void add_primitives(JsonText& json) {
        const std::string vertex_arrays = attributes();
        const std::size_t num_triangles = static_cast<std::size_t>(mesh_.triangles.rows());
        const std::size_t parts = std::max<std::size_t>(1, mesh_.materials.size());
        by_material_.resize(parts);
        for (std::size_t t = 0; t < num_triangles; ++t)
            by_material_[material_of(t)].push_back(static_cast<std::uint32_t>(t));
        const std::int64_t view =
            num_triangles == 0 ? -1 : add_view(std::uint64_t(12) * num_triangles, 34963);
        const std::string targets = targets_.empty() ? std::string() : target_list();
        std::uint64_t offset = 0;
        json.key("primitives").begin_array();
        for (std::size_t m = 0; m < parts; ++m) {
            const std::uint64_t corners = 3 * std::uint64_t(by_material_[m].size());
            if (corners == 0 && num_triangles != 0) continue;
            json.begin_object().key("attributes").raw(vertex_arrays);
            if (corners == 0) json.field("mode", 0);
            if (corners != 0) {
                json.field("indices", num_accessors_);
                begin_accessor(view, offset, 5125, "SCALAR", corners).end_object();
                offset += 4 * corners;
            }
            if (!mesh_.materials.empty()) json.field("material", m);
            if (!targets.empty()) json.key("targets").raw(targets);
            json.end_object();
        }
        json.end_array();
    }

    void add_materials(JsonText& json) {
        if (mesh_.materials.empty()) return;
        json.key("materials").begin_array();
        for (const Material& material : mesh_.materials) {
            json.begin_object();
            if (!material.name.empty()) json.field("name", material.name);
            json.key("pbrMetallicRoughness").begin_object().field("metallicFactor", 0);
            json.key("baseColorFactor").begin_array();
            for (float value : material.color) json.number(static_cast<double>(value));
            json.number(1.0).end_array();
            if (material.image >= 0)
                json.key("baseColorTexture")
                    .begin_object()
                    .field("index", material.image)
                    .end_object();
            json.end_object().end_object();
        }
        json.end_array();
        if (mesh_.images.empty()) return;
        json.key("textures").begin_array();
        for (std::size_t k = 0; k < mesh_.images.size(); ++k)
            json.begin_object().field("source", k).end_object();
        json.end_array().key("images").begin_array();
        for (std::size_t k = 0; k < mesh_.images.size(); ++k) {
            TextureImage probe;
            probe.encoded = bytes_of_image(k).substr(0, 16);
            const ImageKind kind = kind_of_image(probe);
            json.begin_object().field("bufferView", add_view(bytes_of_image(k).size()));
            json.field("mimeType", kind == ImageKind::jpeg  ? "image/jpeg"
                                   : kind == ImageKind::png ? "image/png"
                                                            : "application/octet-stream");
            if (!mesh_.images[k]->name.empty()) json.field("name", mesh_.images[k]->name);
            json.end_object();
        }
        json.end_array();
    }

    std::string document() {
        JsonText json;
        views_.begin_array();
        accessors_.begin_array();
        json.begin_object().key("asset").begin_object();
        json.field("version", "2.0").field("generator", "Mien").end_object();
        json.field("scene", 0).key("scenes").begin_array().begin_object();
        json.key("nodes").begin_array().integer(0).end_array().end_object().end_array();
        json.key("nodes").begin_array().begin_object().field("mesh", 0);
        const double to_metres = 1e-3;
        json.field("scale", std::vector<double>{to_metres, to_metres, to_metres});
        if (!origin_.isZero())
            json.field("translation",
                       std::vector<double>{to_metres * origin_[0], to_metres * origin_[1],
                                           to_metres * origin_[2]});
        json.key("extras").begin_object();
        json.field("origin_mm", std::vector<double>{origin_[0], origin_[1], origin_[2]});
        json.end_object().end_object().end_array();
        json.key("meshes").begin_array().begin_object();
        add_primitives(json);
        if (!targets_.empty()) {
            std::vector<std::string> names;
            for (const MorphTarget& target : targets_) names.push_back(target.name);
            json.field("weights", std::vector<double>(targets_.size(), 0.0));
            json.key("extras").begin_object().field("targetNames", names).end_object();
        }
        json.end_object().end_array();
        add_materials(json);
        json.key("accessors").raw(accessors_.end_array().take());
        json.key("bufferViews").raw(views_.end_array().take());
        json.key("buffers").begin_array().begin_object().field("byteLength", size_);
        return json.end_object().end_array().end_object().take();
    }

    /// In the order in which the views were added.
    void write_arrays() {
        for (std::size_t i = 0; i < count_; ++i, flush()) {
            const Eigen::RowVector3f point = position(i);
            for (int k = 0; k < 3; ++k) put(point[k]);
        }
        for (std::size_t i = 0; has_texture() && i < count_; ++i, flush()) {
            const std::uint32_t at = split_.texture[i];
            put(at == kEnd ? 0.f : mesh_.texture(static_cast<Index>(at), 0));
            put(at == kEnd ? 0.f : 1.f - mesh_.texture(static_cast<Index>(at), 1));
        }
        for (std::size_t i = 0; has_colors() && i < count_; ++i, flush()) {
            for (int k = 0; k < 3; ++k) put(mesh_.colors(static_cast<Index>(split_.vertex[i]), k));
            put<std::uint8_t>(255);
        }
        for (std::size_t i = 0; has_numbers() && i < count_; ++i, flush())
            put(static_cast<float>(split_.vertex[i]));
        for (const auto& triangles : by_material_)
            for (std::uint32_t t : triangles) {
                for (int k = 0; k < 3; ++k) put(split_.corners(static_cast<Index>(t), k));
                flush();
            }
        for (const MorphTarget& target : targets_)
            for (std::size_t i = 0; i < count_; ++i, flush())
                for (int k = 0; k < 3; ++k)
                    put(static_cast<float>(
                        target.offsets(static_cast<Index>(split_.vertex[i]), k)));
        for (std::size_t k = 0; !mesh_.materials.empty() && k < mesh_.images.size(); ++k) {
            const std::string& bytes = bytes_of_image(k);
            out_ += bytes;
            out_.append((4 - bytes.size() % 4) % 4, '\0');
            flush();
        }
    }

    Target& target_;
    const TriMesh& mesh_;
    const std::vector<MorphTarget>& targets_;
    const Context& context_;
    SplitVertices split_;
    std::size_t count_ = 0;
    Vector3 origin_ = Vector3::Zero();
    std::vector<std::string> encoded_;  ///< of images that are pixels
    std::vector<std::vector<std::uint32_t>> by_material_;
    JsonText views_, accessors_;
    std::int64_t num_views_ = 0, num_accessors_ = 0;
    std::uint64_t size_ = 0;
    std::string out_;
};

}  // namespace

void write_glb_document(Target& target, const TriMesh& mesh,
                        const std::vector<MorphTarget>& targets, const Context& context) {
    check_float_range(mesh);
    for (const MorphTarget& morph : targets) {
        if (morph.offsets.rows() != mesh.vertices.rows())
            fail(Status::mismatch, "the morph target '%s' has %lld vertices, the mesh %lld",
                 shown_name(morph.name).c_str(), static_cast<long long>(morph.offsets.rows()),
                 static_cast<long long>(mesh.vertices.rows()));
        if (!morph.offsets.allFinite())
            fail(Status::invalid_mesh, "the morph target '%s' has offsets that are not finite",
                 shown_name(morph.name).c_str());
    }
    GlbWriter(target, mesh, targets, context).write();
}

void write_glb(Target& target, const TriMesh& mesh, const Context& context) {
    write_glb_document(target, mesh, {}, context);
}

}  // namespace formats

}  // namespace mien
