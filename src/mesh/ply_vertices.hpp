// The vertices of a PLY file: which property is what, and their columns. In binary files without
// lists among a vertex's properties every column is converted in one loop over rows of equal
// length.
#pragma once

#include <algorithm>
#include <cmath>

#include "mesh/formats.hpp"
#include "mesh/ply_values.hpp"

namespace mien::formats {

enum class VertexRole { x, y, z, red, green, blue, u, v, none };
constexpr int kNumVertexRoles = static_cast<int>(VertexRole::none) + 1;

inline VertexRole ply_vertex_role(const PlyProperty& property) {
    static const struct {
        const char* name;
        VertexRole role;
    } kNames[] = {{"x", VertexRole::x},
                  {"y", VertexRole::y},
                  {"z", VertexRole::z},
                  {"red", VertexRole::red},
                  {"green", VertexRole::green},
                  {"blue", VertexRole::blue},
                  {"diffuse_red", VertexRole::red},
                  {"diffuse_green", VertexRole::green},
                  {"diffuse_blue", VertexRole::blue},
                  {"r", VertexRole::red},
                  {"g", VertexRole::green},
                  {"b", VertexRole::blue},
                  {"s", VertexRole::u},
                  {"t", VertexRole::v},
                  {"u", VertexRole::u},
                  {"v", VertexRole::v},
                  {"texture_u", VertexRole::u},
                  {"texture_v", VertexRole::v}};
    if (!property.is_list)
        for (const auto& entry : kNames)
            if (property.name == entry.name) return entry.role;
    return VertexRole::none;
}

/// What the vertices of a file are read into.
class PlyVertices {
  public:
    PlyVertices(const PlyElement& element, const Context& context);

    template <typename Values>
    void read(Values& values, const Context& context);

    Points points;               ///< #V x 3
    Colors colors;               ///< #V x 3 or empty
    std::vector<float> texture;  ///< 2 #V or empty

  private:
    bool is_color(VertexRole role) const {
        return role >= VertexRole::red && role <= VertexRole::blue;
    }
    /// Bytes as they are, the upper byte of 16 bits, numbers as they are.
    static std::uint8_t to_byte(double value, PlyType type) {
        const double byte = type == PlyType::u16 ? value / 257.0 : value;
        return static_cast<std::uint8_t>(byte >= 0.0 ? std::min(byte + 0.5, 255.0) : 0.0);
    }
    void put(std::size_t row, std::size_t column, double value);
    /// `count` rows from `first`, each of `stride` bytes from `rows`.
    void put_column(std::size_t first, std::size_t count, const char* rows, std::size_t stride,
                    std::size_t column, bool swapped);

    const PlyElement& element_;
    std::size_t count_;
    std::vector<VertexRole> roles_;  ///< per property
    bool float_colors_ = false;
    std::vector<float> color_numbers_;
};

template <typename Values>
void PlyVertices::read(Values& values, const Context& context) {
    const std::vector<PlyProperty>& properties = element_.properties;
    const bool fixed = std::none_of(properties.begin(), properties.end(),
                                    [](const PlyProperty& p) { return p.is_list; });
    if constexpr (Values::kBinary) {
        // So many rows stay in the nearest cache while their columns are read one after another.
        constexpr std::size_t kRowsAtOnce = 512;
        std::vector<std::size_t> offsets;
        std::size_t stride = 0;
        for (const PlyProperty& property : properties) {
            offsets.push_back(stride);
            stride += ply_type_bytes(property.type);
        }
        for (std::size_t first = 0; fixed && first < count_; first += kRowsAtOnce) {
            if (first % kCancelInterval == 0) context.check_cancelled();
            const std::size_t count = std::min(kRowsAtOnce, count_ - first);
            const char* rows = values.take(count * stride);
            for (std::size_t k = 0; k < roles_.size(); ++k)
                if (roles_[k] != VertexRole::none)
                    put_column(first, count, rows + offsets[k], stride, k, values.swapped());
        }
    }
    for (std::size_t i = 0; (!fixed || !Values::kBinary) && i < count_; ++i) {
        if (i % kCancelInterval == 0) context.check_cancelled();
        for (std::size_t k = 0; k < roles_.size(); ++k) {
            const PlyProperty& property = properties[k];
            if (roles_[k] != VertexRole::none)
                put(i, k, values.next(property.type));
            else
                values.skip(property.type,
                            property.is_list ? values.length(property, "vertex", i) : 1);
        }
    }
    if (!color_numbers_.empty()) colors = colors_from_numbers(color_numbers_);
    for (float& value : texture)
        if (!std::isfinite(value)) value = 0.0f;
}

}  // namespace mien::formats
