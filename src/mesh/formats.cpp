#include "mesh/formats.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace mien::formats {

void write_when_long(AtomicFile& file, std::string& out, const Context& context) {
    if (out.size() <= kCancelInterval) return;
    context.check_cancelled();
    file.write(out);
    out.clear();
}

void PolygonSink::add(const std::uint32_t* corners, std::size_t count, const std::uint32_t* texture,
                      std::uint32_t material) {
    if (count < 3) return;
    const std::size_t before = triangles_.size();
    for (std::size_t k = 2; k < count; ++k) {
        triangles_.push_back(corners[0]);
        triangles_.push_back(corners[k - 1]);
        triangles_.push_back(corners[k]);
    }
    // The first polygon of another material than the first one: those before it had that.
    if (material != 0 && !any_material_) {
        any_material_ = true;
        materials_.assign(before / 3, 0);
    }
    if (any_material_) materials_.insert(materials_.end(), count - 2, material);
    if (texture == nullptr && !any_texture_) return;
    // The first textured polygon: those before it had none.
    if (!any_texture_) {
        any_texture_ = true;
        texture_triangles_.assign(before, kNoTexture);
    }
    for (std::size_t k = 2; k < count; ++k)
        for (std::size_t corner : {std::size_t(0), k - 1, k})
            texture_triangles_.push_back(texture == nullptr ? kNoTexture : texture[corner]);
}

void PolygonSink::finish(TriMesh& mesh, std::vector<float>& texture_values) {
    const Index count = static_cast<Index>(triangles_.size() / 3);
    mesh.triangles = Eigen::Map<const Triangles>(triangles_.data(), count, 3);
    mesh.triangle_materials.swap(materials_);
    if (!any_texture_) return;
    const std::size_t spare = texture_values.size() / 2;
    bool needs_spare = false;
    for (std::uint32_t& index : texture_triangles_)
        if (index == kNoTexture) {
            index = static_cast<std::uint32_t>(spare);
            needs_spare = true;
        }
    if (needs_spare) texture_values.insert(texture_values.end(), 2, 0.0f);
    for (float& value : texture_values)
        if (!std::isfinite(value)) value = 0.0f;
    mesh.texture_triangles = Eigen::Map<const Triangles>(texture_triangles_.data(), count, 3);
    mesh.texture = Eigen::Map<const TextureCoordinates>(
        texture_values.data(), static_cast<Index>(texture_values.size() / 2), 2);
}

Colors colors_from_numbers(const std::vector<float>& rgb) {
    float largest = 0.0f;
    for (float value : rgb) largest = std::max(largest, value);
    const float scale = largest > 1.0f ? 1.0f : 255.0f;
    Colors colors(static_cast<Index>(rgb.size() / 3), 3);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        // Written so that a value that is not a number becomes black.
        const float value = rgb[i] > 0.0f ? std::min(rgb[i] * scale, 255.0f) : 0.0f;
        colors.data()[i] = static_cast<std::uint8_t>(std::lround(value));
    }
    return colors;
}

void append_number(std::string& out, double value, int digits) {
    char text[32];
    const auto result =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
    out += ' ';
    out.append(text, result.ptr);
}

void append_coordinate(std::string& out, double value) {
    // Nine digits step by 1e-8 of the power of ten below the value.
    constexpr double kNineDigits = kCoordinateStep_mm * 1e8;
    if (std::abs(value) < kNineDigits) {
        append_number(out, value);
        return;
    }
    char text[32];
    const auto result = std::to_chars(text, text + sizeof text, value);
    out += ' ';
    out.append(text, result.ptr);
}

void append_number(std::string& out, std::uint64_t value) {
    char text[24];
    const auto result = std::to_chars(text, text + sizeof text, value);
    out += ' ';
    out.append(text, result.ptr);
}

bool needs_double(const TriMesh& mesh) {
    const double largest = mesh.vertices.size() == 0 ? 0.0 : mesh.vertices.cwiseAbs().maxCoeff();
    if (!(largest <= static_cast<double>(std::numeric_limits<float>::max()))) return true;
    const float value = static_cast<float>(largest);
    const float next = std::nextafter(value, std::numeric_limits<float>::infinity());
    return static_cast<double>(next) - static_cast<double>(value) > kCoordinateStep_mm;
}

void check_float_range(const TriMesh& mesh) {
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        if (!(mesh.vertices.row(v).cwiseAbs().maxCoeff() <=
              static_cast<double>(std::numeric_limits<float>::max())))
            fail_at(Status::invalid_mesh, v,
                    "vertex %lld has a coordinate beyond the file's number range",
                    static_cast<long long>(v));
}

}  // namespace mien::formats
