// Texture coordinates, materials and images of meshes, in the C++ face.
#ifndef MIEN_DETAIL_APPEARANCE_HPP
#define MIEN_DETAIL_APPEARANCE_HPP

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core.hpp"

namespace mien {

/// A texture image: the bytes of a JPEG or PNG file, or pixels.
struct TextureImage {
    std::string name;                  ///< UTF-8 file name without a folder; may be empty
    std::vector<std::uint8_t> file;    ///< as it was read; empty for pixels
    std::uint32_t width = 0;           ///< of pixels, else 0
    std::uint32_t height = 0;          ///< of pixels, else 0
    std::vector<std::uint8_t> pixels;  ///< height rows of width x 3 red green blue, from the top
};

struct Material {
    std::string name;                           ///< UTF-8; may be empty
    std::array<double, 3> color{{1., 1., 1.}};  ///< 0 to 1; an image is times this
    std::int32_t image = -1;                    ///< number of its image, -1: none
};

/// What of a mesh is no geometry.
struct Appearance {
    std::vector<std::array<float, 2>> texture;  ///< (0, 0) at the image's lower left corner
    std::vector<Triangle> texture_triangles;    ///< per triangle; empty: texture is per vertex
    std::vector<Material> materials;
    std::vector<std::uint32_t> triangle_materials;  ///< per triangle; empty: all are of the first
    std::vector<TextureImage> images;
};

namespace detail {

/// Reads rows by the two-call protocol: f(mesh, dst, capacity, count, error).
template <typename Row, typename Element, typename Function>
std::vector<Row> read_rows(Function function, const mien_mesh* mesh) {
    std::uint64_t count = 0;
    call(function, mesh, static_cast<Element*>(nullptr), std::uint64_t{0}, &count);
    std::vector<Row> rows(static_cast<std::size_t>(count));
    if (count != 0) call(function, mesh, reinterpret_cast<Element*>(rows.data()), count, &count);
    return rows;
}

/// The same of one of a mesh's materials or images.
template <typename Element, typename Function>
std::vector<Element> read_part(Function function, const mien_mesh* mesh, std::uint64_t part) {
    std::uint64_t count = 0;
    call(function, mesh, part, static_cast<Element*>(nullptr), std::uint64_t{0}, &count);
    std::vector<Element> elements(static_cast<std::size_t>(count));
    if (count != 0) call(function, mesh, part, elements.data(), count, &count);
    return elements;
}

inline std::string text_of(const std::vector<char>& with_zero) {
    return with_zero.empty() ? std::string() : std::string(with_zero.data());
}

}  // namespace detail

/// Decodes image number `image`: height rows of width x 3 red green blue, tightly packed.
inline TextureImage decode_image(const Session& session, const Mesh& mesh, std::size_t image) {
    const std::uint64_t number = image;
    TextureImage decoded;
    decoded.name =
        detail::text_of(detail::read_part<char>(mien_mesh_get_image_name, mesh.get(), number));
    detail::call(mien_mesh_get_image_size, mesh.get(), number, &decoded.width, &decoded.height);
    decoded.pixels.resize(std::size_t{3} * decoded.width * decoded.height);
    std::uint64_t count = 0;
    detail::call(mien_mesh_get_image_pixels, session.get(), mesh.get(), number, std::uint64_t{0},
                 decoded.pixels.data(), std::uint64_t{decoded.pixels.size()}, &count);
    return decoded;
}

/// Everything that a mesh carries beside its geometry and vertex colours. Images that were read
/// come as the bytes of their files, a host's as pixels.
inline Appearance appearance_of(const Session& session, const Mesh& mesh) {
    Appearance all;
    all.texture = detail::read_rows<std::array<float, 2>, float>(mien_mesh_get_texture, mesh.get());
    all.texture_triangles =
        detail::read_rows<Triangle, std::uint32_t>(mien_mesh_get_texture_triangles, mesh.get());
    all.triangle_materials = detail::read_rows<std::uint32_t, std::uint32_t>(
        mien_mesh_get_triangle_materials, mesh.get());
    std::uint64_t num_materials = 0, num_images = 0;
    detail::call(mien_mesh_get_material_counts, mesh.get(), &num_materials, &num_images);
    for (std::uint64_t k = 0; k < num_materials; ++k) {
        Material material;
        material.name =
            detail::text_of(detail::read_part<char>(mien_mesh_get_material_name, mesh.get(), k));
        detail::call(mien_mesh_get_material, mesh.get(), k, &material.image, &material.color[0],
                     &material.color[1], &material.color[2]);
        all.materials.push_back(std::move(material));
    }
    for (std::uint64_t k = 0; k < num_images; ++k) {
        TextureImage image;
        image.file = detail::read_part<std::uint8_t>(mien_mesh_get_image_file, mesh.get(), k);
        if (image.file.empty())
            image = decode_image(session, mesh, static_cast<std::size_t>(k));
        else
            image.name =
                detail::text_of(detail::read_part<char>(mien_mesh_get_image_name, mesh.get(), k));
        all.images.push_back(std::move(image));
    }
    return all;
}

/// A mesh of the same geometry and vertex colours with that appearance. Throws
/// std::invalid_argument for an image whose pixels are not as many as its size says, and for lists
/// per triangle of another length.
inline Mesh with_appearance(const Session& session, const Mesh& mesh, const Appearance& look) {
    const std::vector<Position> positions = mesh.positions();
    const std::vector<Triangle> triangles = mesh.triangles();
    const std::vector<Color> colors = mesh.colors();
    for (const std::size_t count : {look.texture_triangles.size(), look.triangle_materials.size()})
        if (count != 0 && count != triangles.size())
            throw std::invalid_argument("appearance and mesh differ in triangles");
    std::vector<mien_image> images;
    for (const TextureImage& image : look.images) {
        if (image.pixels.size() != std::size_t{3} * image.width * image.height)
            throw std::invalid_argument("an image's pixels and its size differ");
        images.push_back({image.name.c_str(), image.pixels.empty() ? nullptr : image.pixels.data(),
                          0, image.width, image.height,
                          image.file.empty() ? nullptr : image.file.data(),
                          std::uint64_t{image.file.size()}});
    }
    std::vector<mien_material> materials;
    for (const Material& material : look.materials)
        materials.push_back({material.name.c_str(), material.image, 0, material.color[0],
                             material.color[1], material.color[2]});
    mien_mesh_arrays arrays;
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    arrays.positions = {positions.data(), positions.size(), sizeof(Position), MIEN_DTYPE_F64, 0};
    arrays.triangles = triangles.empty() ? nullptr : triangles.front().data();
    arrays.triangle_count = triangles.size();
    arrays.colors = colors.empty() ? nullptr : colors.front().data();
    arrays.texture = look.texture.empty() ? nullptr : look.texture.front().data();
    arrays.texture_count = look.texture.size();
    arrays.texture_triangles =
        look.texture_triangles.empty() ? nullptr : look.texture_triangles.front().data();
    arrays.materials = materials.empty() ? nullptr : materials.data();
    arrays.material_count = materials.size();
    arrays.triangle_materials =
        look.triangle_materials.empty() ? nullptr : look.triangle_materials.data();
    arrays.images = images.empty() ? nullptr : images.data();
    arrays.image_count = images.size();
    mien_mesh* made = nullptr;
    detail::call(mien_mesh_create, session.get(), &arrays, &made);
    return Mesh(made);
}

}  // namespace mien

#endif
