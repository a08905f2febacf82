// Bumpy sheets of square cells: small surfaces with a known shape.
#pragma once

#include "handles.hpp"

namespace mien_test {

struct SheetArrays {
    std::vector<double> positions;  ///< side^2 x 3, mm
    std::vector<std::uint32_t> triangles;
};

/// side x side vertices, `cell` mm apart, with bumps of `height` mm whose places depend on `shape`.
inline SheetArrays sheet_arrays(int side, double cell = 1, double height = 1, double shape = 0) {
    SheetArrays sheet;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            sheet.positions.insert(
                sheet.positions.end(),
                {cell * x, cell * y,
                 height * (std::sin(0.3 * x + shape) * std::cos(0.2 * y - 0.7 * shape) +
                           0.4 * std::sin(0.11 * x * y / side + 2 * shape))});
    for (int y = 0; y + 1 < side; ++y)
        for (int x = 0; x + 1 < side; ++x) {
            const auto a = static_cast<std::uint32_t>(y * side + x), b = a + 1,
                       c = a + static_cast<std::uint32_t>(side), d = c + 1;
            sheet.triangles.insert(sheet.triangles.end(), {a, b, d, a, d, c});
        }
    return sheet;
}

inline Mesh make_mesh(mien_session* session, const SheetArrays& sheet) {
    mien_mesh_arrays arrays;
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    arrays.positions = {sheet.positions.data(), sheet.positions.size() / 3, 0, MIEN_DTYPE_F64, 0};
    arrays.triangles = sheet.triangles.data();
    arrays.triangle_count = sheet.triangles.size() / 3;
    mien_mesh* mesh = nullptr;
    EXPECT_EQ(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, nullptr));
    return Mesh(mesh, mien_mesh_release);
}

inline Mesh make_sheet(mien_session* session, int side) {
    return make_mesh(session, sheet_arrays(side));
}

/// The vertices of a mesh, #V x 3.
inline std::vector<double> positions_of(const mien_mesh* mesh) {
    std::uint64_t count = 0;
    EXPECT_EQ(MIEN_OK, mien_mesh_get_positions(mesh, MIEN_DTYPE_F64, nullptr, 0, &count, nullptr));
    std::vector<double> positions(3 * count);
    EXPECT_EQ(MIEN_OK, mien_mesh_get_positions(mesh, MIEN_DTYPE_F64, positions.data(), count,
                                               nullptr, nullptr));
    return positions;
}

/// Mean distance between corresponding vertices.
inline double mean_distance(const std::vector<double>& a, const std::vector<double>& b) {
    EXPECT_EQ(a.size(), b.size());
    double sum = 0;
    for (std::size_t i = 0; i + 2 < a.size(); i += 3)
        sum += std::sqrt(std::pow(a[i] - b[i], 2) + std::pow(a[i + 1] - b[i + 1], 2) +
                         std::pow(a[i + 2] - b[i + 2], 2));
    return sum / (static_cast<double>(a.size()) / 3);
}

/// Text by the two-call protocol; get(dst, capacity, count) gives a status.
template <typename Get>
std::string text_of(Get&& get) {
    std::uint64_t count = 0;
    EXPECT_EQ(MIEN_OK, get(nullptr, std::uint64_t{0}, &count));
    std::string text(count, 'x');
    EXPECT_EQ(MIEN_OK, get(&text[0], count, &count));
    EXPECT_EQ('\0', text.back());
    text.pop_back();
    return text;
}

/// The number behind "key": in a JSON text; NaN when it is not there.
inline double json_number(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\":");
    return at == std::string::npos ? std::nan("") : std::atof(json.c_str() + at + key.size() + 3);
}

}  // namespace mien_test
