#include "mesh/vtk_arrays.hpp"

#include <cmath>

#include "base/error.hpp"

namespace mien::formats {

bool parse_vtk_type(const std::string& word, VtkType& type) {
    static const struct {
        const char* name;
        VtkType type;
    } kTypes[] = {{"char", {PlyType::i8}},
                  {"signed_char", {PlyType::i8}},
                  {"int8", {PlyType::i8}},
                  {"unsigned_char", {PlyType::u8}},
                  {"uint8", {PlyType::u8}},
                  {"short", {PlyType::i16}},
                  {"int16", {PlyType::i16}},
                  {"unsigned_short", {PlyType::u16}},
                  {"uint16", {PlyType::u16}},
                  {"int", {PlyType::i32}},
                  {"int32", {PlyType::i32}},
                  {"unsigned_int", {PlyType::u32}},
                  {"uint32", {PlyType::u32}},
                  {"float", {PlyType::f32}},
                  {"float32", {PlyType::f32}},
                  {"double", {PlyType::f64}},
                  {"float64", {PlyType::f64}},
                  {"long", {PlyType::i32, true, false}},
                  {"vtkidtype", {PlyType::i32}},
                  {"int64", {PlyType::i32, true, false}},
                  {"vtktypeint64", {PlyType::i32, true, false}},
                  {"unsigned_long", {PlyType::u32, true, true}},
                  {"uint64", {PlyType::u32, true, true}},
                  {"vtktypeuint64", {PlyType::u32, true, true}},
                  {"vtktypeint32", {PlyType::i32}}};
    const std::string lower = ply_lower_case(word);
    for (const auto& entry : kTypes)
        if (lower == entry.name) {
            type = entry.type;
            return true;
        }
    return false;
}

double load_vtk(const char* raw, const VtkType& type, bool swapped) {
    if (type.wide)
        return type.wide_unsigned ? static_cast<double>(load_ply<std::uint64_t>(raw, swapped))
                                  : static_cast<double>(load_ply<std::int64_t>(raw, swapped));
    return with_ply_type(type.type, [&](auto kind) {
        return static_cast<double>(load_ply<decltype(kind)>(raw, swapped));
    });
}

void VtkPolyData::add_cells(const std::vector<double>& offsets,
                            const std::vector<double>& connectivity, bool strips) {
    const std::size_t num_points = points.size() / 3;
    const auto count = static_cast<double>(num_points);
    std::vector<std::uint32_t> corners;
    std::size_t begin = 0;
    for (std::size_t cell = 0; cell < offsets.size(); ++cell) {
        const double end = offsets[cell];
        if (!(end >= static_cast<double>(begin) &&
              end <= static_cast<double>(connectivity.size())) ||
            end != std::floor(end))
            fail_at(Status::bad_format, static_cast<std::int64_t>(cell),
                    "cell %zu ends at %g of %zu vertex numbers", cell, end, connectivity.size());
        corners.clear();
        for (; begin < static_cast<std::size_t>(end); ++begin) {
            const double number = connectivity[begin];
            if (!(number >= 0.0 && number < count) || number != std::floor(number))
                fail_at(Status::bad_format, static_cast<std::int64_t>(cell),
                        "cell %zu names vertex %g, the file has %g", cell, number, count);
            corners.push_back(static_cast<std::uint32_t>(number));
        }
        if (!strips) {
            polygons.add(corners.data(), corners.size(), nullptr);
            continue;
        }
        for (std::size_t k = 2; k < corners.size(); ++k) {
            const bool even = k % 2 == 0;
            const std::uint32_t triangle[3] = {corners[k - (even ? 2 : 1)],
                                               corners[k - (even ? 1 : 2)], corners[k]};
            polygons.add(triangle, 3, nullptr);
        }
    }
}

void VtkPolyData::add_point_array(const std::string& name, const VtkType& type, std::size_t columns,
                                  const std::vector<double>& values, bool named_as_texture,
                                  bool named_as_color) {
    const std::size_t count = points.size() / 3;
    if (columns == 0 || values.size() != columns * count) return;
    const std::string lower = ply_lower_case(name);
    const auto has = [&](const char* word) { return lower.find(word) != std::string::npos; };
    if (texture.empty() && (columns == 2 || columns == 3) &&
        (named_as_texture || (columns == 2 && (has("tcoord") || has("texture") || has("uv"))))) {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 2; ++k)
                texture.push_back(static_cast<float>(values[columns * i + k]));
        return;
    }
    // Bytes are colours whatever they are called; other numbers only by their name.
    const bool bytes = !type.wide && type.type == PlyType::u8;
    const bool color = named_as_color || bytes || has("rgb") || has("color") || has("colour");
    if (!colors.empty() || !color || (columns != 3 && columns != 4)) return;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            colors.push_back(static_cast<float>(values[columns * i + k]) / (bytes ? 255.f : 1.f));
}

TriMesh VtkPolyData::finish() {
    if (points.empty()) fail(Status::bad_format, "the VTK file has no points");
    TriMesh mesh;
    const Index count = static_cast<Index>(points.size() / 3);
    mesh.vertices = Eigen::Map<const Points>(points.data(), count, 3);
    if (!colors.empty()) mesh.colors = colors_from_numbers(colors);
    std::vector<float> none;
    polygons.finish(mesh, none);
    if (!texture.empty() && mesh.triangles.rows() != 0) {
        for (float& value : texture)
            if (!std::isfinite(value)) value = 0.f;
        mesh.texture = Eigen::Map<const TextureCoordinates>(texture.data(), count, 2);
        mesh.texture_triangles = mesh.triangles;
    }
    return mesh;
}

}  // namespace mien::formats
