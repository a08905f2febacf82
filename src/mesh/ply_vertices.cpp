#include "mesh/ply_vertices.hpp"

namespace mien::formats {

PlyVertices::PlyVertices(const PlyElement& element, const Context& context)
    : element_(element), count_(static_cast<std::size_t>(element.count)) {
    bool found[kNumVertexRoles] = {};
    auto has = [&](VertexRole role) { return found[static_cast<int>(role)]; };
    for (const PlyProperty& property : element.properties) {
        VertexRole role = ply_vertex_role(property);
        if (has(role)) role = VertexRole::none;
        roles_.push_back(role);
        if (role == VertexRole::none) continue;
        found[static_cast<int>(role)] = true;
        float_colors_ = float_colors_ || (is_color(role) && property.type >= PlyType::f32);
    }
    if (!has(VertexRole::x) || !has(VertexRole::y) || !has(VertexRole::z))
        fail(Status::bad_format, "the PLY file's vertices lack x, y or z");
    const bool has_colors = has(VertexRole::red) && has(VertexRole::green) && has(VertexRole::blue);
    const bool has_texture = has(VertexRole::u) && has(VertexRole::v);
    for (VertexRole& role : roles_)
        if ((is_color(role) && !has_colors) || (role >= VertexRole::u && !has_texture))
            role = VertexRole::none;
    context.require_memory(count_ * (24 + (has_colors ? 15 : 0) + (has_texture ? 8 : 0)),
                           "a mesh file's vertices");
    points.resize(static_cast<Index>(count_), 3);
    if (has_colors && !float_colors_) colors.resize(static_cast<Index>(count_), 3);
    color_numbers_.resize(has_colors && float_colors_ ? 3 * count_ : 0);
    texture.resize(has_texture ? 2 * count_ : 0);
}

void PlyVertices::put(std::size_t row, std::size_t column, double value) {
    const int role = static_cast<int>(roles_[column]);
    constexpr int kRed = static_cast<int>(VertexRole::red), kU = static_cast<int>(VertexRole::u);
    if (role < kRed)
        points(static_cast<Index>(row), role) = value;
    else if (role >= kU)
        texture[2 * row + static_cast<std::size_t>(role - kU)] = static_cast<float>(value);
    else if (float_colors_)
        color_numbers_[3 * row + static_cast<std::size_t>(role - kRed)] = static_cast<float>(value);
    else
        colors(static_cast<Index>(row), role - kRed) =
            to_byte(value, element_.properties[column].type);
}

void PlyVertices::put_column(std::size_t first, std::size_t count, const char* rows,
                             std::size_t stride, std::size_t column, bool swapped) {
    const PlyType type = element_.properties[column].type;
    const std::size_t role = static_cast<std::size_t>(roles_[column]);
    constexpr std::size_t kRed = static_cast<std::size_t>(VertexRole::red);
    if (role >= kRed) {
        if (type == PlyType::u8 && !float_colors_ && is_color(roles_[column])) {
            std::uint8_t* to = colors.data() + 3 * first + (role - kRed);
            for (std::size_t i = 0; i < count; ++i)
                to[3 * i] = static_cast<std::uint8_t>(rows[i * stride]);
            return;
        }
        with_ply_type(type, [&](auto kind) {
            using T = decltype(kind);
            for (std::size_t i = 0; i < count; ++i)
                put(first + i, column,
                    static_cast<double>(load_ply<T>(rows + i * stride, swapped)));
        });
        return;
    }
    double* to = points.data() + 3 * first + role;
    with_ply_type(type, [&](auto kind) {
        using T = decltype(kind);
        if (swapped)
            for (std::size_t i = 0; i < count; ++i)
                to[3 * i] = static_cast<double>(load_ply<T>(rows + i * stride, true));
        else
            for (std::size_t i = 0; i < count; ++i)
                to[3 * i] = static_cast<double>(load_ply<T>(rows + i * stride, false));
    });
}

}  // namespace mien::formats
