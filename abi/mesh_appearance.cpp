// Texture coordinates, materials, images and morph targets of meshes, and the table of formats.
#include "arrays.hpp"
#include "base/json.hpp"
#include "guard.hpp"
#include "mesh.hpp"
#include "mesh/gltf.hpp"
#include "mesh/image.hpp"
#include "mesh/mesh_file.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

const MeshFormat* format_at(std::uint32_t number) noexcept {
    try {
        static const std::vector<MeshFormat> formats = mesh_formats();
        return number < formats.size() ? &formats[number] : nullptr;
    } catch (...) {
        return nullptr;
    }
}

const Material& material_at(const mien_mesh* mesh, std::uint64_t number) {
    const TriMesh& data = *checked(mesh, "mesh").mesh;
    if (number >= data.materials.size())
        fail(Status::invalid_argument, "material is %llu, the mesh has %zu",
             static_cast<unsigned long long>(number), data.materials.size());
    return data.materials[static_cast<std::size_t>(number)];
}

const TextureImage& image_at(const mien_mesh* mesh, std::uint64_t number) {
    const TriMesh& data = *checked(mesh, "mesh").mesh;
    if (number >= data.images.size())
        fail(Status::invalid_argument, "image is %llu, the mesh has %zu",
             static_cast<unsigned long long>(number), data.images.size());
    return *data.images[static_cast<std::size_t>(number)];
}

void copy_pixels(const TextureImage& image, std::uint64_t stride, std::uint8_t* dst,
                 std::uint64_t capacity, std::uint64_t* count, const Context& context) {
    const ImageSize size = size_of_image(image);
    const std::uint64_t row = 3 * static_cast<std::uint64_t>(size.width);
    const std::uint64_t height = static_cast<std::uint64_t>(size.height);
    if (stride == 0) stride = row;
    if (stride < row || stride > std::numeric_limits<std::uint64_t>::max() / 2 / height)
        fail(Status::invalid_argument, "row_stride_bytes is %llu, a row has %llu bytes",
             static_cast<unsigned long long>(stride), static_cast<unsigned long long>(row));
    if (!wants_copy(stride * (height - 1) + row, dst, capacity, count)) return;
    const Image decoded = decode_image(image, context);
    for (std::uint64_t y = 0; y < height; ++y)
        std::memcpy(dst + y * stride, decoded.rgb.data() + y * row, static_cast<std::size_t>(row));
}

std::vector<MorphTarget> read_targets(const TriMesh& mesh, const mien_mesh* const* targets,
                                      const char* const* names, std::uint64_t count) {
    check_array(targets, count, alignof(void*), kMostNames, "targets");
    check_array(names, count, alignof(void*), kMostNames, "names");
    std::vector<MorphTarget> all;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        const TriMesh& changed = *checked(targets[k], "targets[]").mesh;
        if (changed.vertices.rows() != mesh.vertices.rows())
            fail_at(Status::mismatch, static_cast<std::int64_t>(k),
                    "targets[%zu] has %lld vertices, the mesh %lld", k,
                    static_cast<long long>(changed.vertices.rows()),
                    static_cast<long long>(mesh.vertices.rows()));
        all.push_back({checked_text(names[k], "names[]"), changed.vertices - mesh.vertices});
    }
    return all;
}

}  // namespace

extern "C" {

uint32_t MIEN_CALL mien_mesh_format_count(void) {
    std::uint32_t count = 0;
    while (format_at(count) != nullptr) ++count;
    return count;
}

const char* MIEN_CALL mien_mesh_format_extension(uint32_t format) {
    const MeshFormat* found = format_at(format);
    return found == nullptr ? nullptr : found->extension;
}

const char* MIEN_CALL mien_mesh_format_description(uint32_t format) {
    const MeshFormat* found = format_at(format);
    return found == nullptr ? nullptr : found->description;
}

int32_t MIEN_CALL mien_mesh_format_writes(uint32_t format) {
    const MeshFormat* found = format_at(format);
    return found != nullptr && found->writes ? 1 : 0;
}

mien_status MIEN_CALL mien_mesh_get_texture(const mien_mesh* mesh, float* dst, uint64_t capacity,
                                            uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const TextureCoordinates& texture = checked(mesh, "mesh").mesh->texture;
        copy_rows(texture.data(), static_cast<uint64_t>(texture.rows()), 2 * sizeof(float), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_get_texture_triangles(const mien_mesh* mesh, uint32_t* dst,
                                                      uint64_t capacity, uint64_t* count,
                                                      mien_error* error) {
    return guarded(error, [&] {
        const Triangles& triangles = checked(mesh, "mesh").mesh->texture_triangles;
        copy_rows(triangles.data(), static_cast<uint64_t>(triangles.rows()), 3 * sizeof(uint32_t),
                  dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_get_triangle_materials(const mien_mesh* mesh, uint32_t* dst,
                                                       uint64_t capacity, uint64_t* count,
                                                       mien_error* error) {
    return guarded(error, [&] {
        const std::vector<uint32_t>& numbers = checked(mesh, "mesh").mesh->triangle_materials;
        copy_rows(numbers.data(), numbers.size(), sizeof(uint32_t), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_get_material_counts(const mien_mesh* mesh, uint64_t* material_count,
                                                    uint64_t* image_count, mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        store(material_count, data.materials.size());
        store(image_count, data.images.size());
    });
}

mien_status MIEN_CALL mien_mesh_get_material(const mien_mesh* mesh, uint64_t material,
                                             int32_t* image, double* red, double* green,
                                             double* blue, mien_error* error) {
    return guarded(error, [&] {
        const Material& found = material_at(mesh, material);
        store(image, found.image);
        store(red, found.color[0]);
        store(green, found.color[1]);
        store(blue, found.color[2]);
    });
}

mien_status MIEN_CALL mien_mesh_get_material_name(const mien_mesh* mesh, uint64_t material,
                                                  char* dst, uint64_t capacity, uint64_t* count,
                                                  mien_error* error) {
    return guarded(error, [&] {
        const std::string& name = material_at(mesh, material).name;
        copy_text(name.data(), name.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_get_image_name(const mien_mesh* mesh, uint64_t image, char* dst,
                                               uint64_t capacity, uint64_t* count,
                                               mien_error* error) {
    return guarded(error, [&] {
        const std::string& name = image_at(mesh, image).name;
        copy_text(name.data(), name.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_get_image_file(const mien_mesh* mesh, uint64_t image, uint8_t* dst,
                                               uint64_t capacity, uint64_t* count,
                                               mien_error* error) {
    return guarded(error, [&] {
        const std::string& bytes = image_at(mesh, image).encoded;
        copy_rows(bytes.data(), bytes.size(), 1, dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_get_image_size(const mien_mesh* mesh, uint64_t image,
                                               uint32_t* width, uint32_t* height,
                                               mien_error* error) {
    return guarded(error, [&] {
        const ImageSize size = size_of_image(image_at(mesh, image));
        store(width, size.width);
        store(height, size.height);
    });
}

mien_status MIEN_CALL mien_mesh_get_image_pixels(mien_session* session, const mien_mesh* mesh,
                                                 uint64_t image, uint64_t row_stride_bytes,
                                                 uint8_t* dst, uint64_t capacity, uint64_t* count,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        copy_pixels(image_at(mesh, image), row_stride_bytes, dst, capacity, count, call.context());
    });
}

mien_status MIEN_CALL mien_mesh_save_targets(mien_session* session, const mien_mesh* mesh,
                                             const mien_mesh* const* targets,
                                             const char* const* names, uint64_t target_count,
                                             const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        const TriMesh& base = *checked(mesh, "mesh").mesh;
        write_morph_mesh(checked_text(path, "path"), base,
                         read_targets(base, targets, names, target_count), call.context());
    });
}

mien_status MIEN_CALL mien_mesh_load_target(mien_session* session, const char* path,
                                            const char* name, mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const std::string wanted = checked_text(name, "name");
        MorphMesh morph = read_morph_mesh(checked_text(path, "path"), call.context());
        std::string known;
        for (const MorphTarget& target : morph.targets) {
            if (target.name == wanted) {
                morph.mesh.vertices += target.offsets;
                check_mesh(morph.mesh, "the changed mesh");
                return new mien_mesh(std::make_shared<const TriMesh>(std::move(morph.mesh)));
            }
            if (known.size() < 80)
                known += (known.empty() ? "'" : ", '") + shown_name(target.name) + "'";
        }
        fail(Status::not_found, "no morph target '%s'; the file has %s", shown_name(wanted).c_str(),
             known.empty() ? "none" : known.c_str());
    });
}

}  // extern "C"
