#include "model/profile_landmarks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace mien {
namespace {

/// A sheet about x = 0 whose profile, y from -80 to 80, bulges and sinks at known heights.
struct Sheet {
    static constexpr int kHalf = 6, kRows = 161;
    TriMesh mesh;
    std::vector<Landmark> points;
    Sheet() {
        const int columns = 2 * kHalf + 1;
        mesh.vertices.resize(columns * kRows, 3);
        for (int j = 0; j < kRows; ++j)
            for (int i = 0; i < columns; ++i)
                mesh.vertices.row(j * columns + i) << 3.0 * (i - kHalf), j - 80.0,
                    profile(j - 80.0) - 0.05 * (i - kHalf) * (i - kHalf);
        mesh.triangles.resize(2 * (columns - 1) * (kRows - 1), 3);
        Index t = 0;
        for (int j = 0; j + 1 < kRows; ++j)
            for (int i = 0; i + 1 < columns; ++i) {
                const auto a = static_cast<std::uint32_t>(j * columns + i), b = a + 1;
                const auto c = a + static_cast<std::uint32_t>(columns), d = c + 1;
                mesh.triangles.row(t++) << a, b, d;
                mesh.triangles.row(t++) << a, d, c;
            }
        points = {{"Nose-Bridge 3", at(5)},    {"nose_base_2", at(-12)},
                  {"mouth_outer_09", at(-40)}, {"jaw_08", at(-75)},
                  {"eye_right_3", at(33, -4)}, {"eye_left_0", at(33, 4)}};
    }
    static double bump(double y, double centre, double width) {
        return std::exp(-(y - centre) * (y - centre) / (2 * width * width));
    }
    static double profile(double y) {
        const double under_chin = y < -65 ? 0.02 * (y + 65) * (y + 65) : 0;  // it recedes
        return 100 - under_chin + 30 * bump(y, 5, 9) + 4 * bump(y, 58, 8) + 9 * bump(y, -35, 8) +
               6 * bump(y, -65, 6);
    }
    static std::uint32_t at(int y, int column = 0) {
        return static_cast<std::uint32_t>((y + 80) * (2 * kHalf + 1) + column + kHalf);
    }
    double height(const std::vector<Landmark>& found, const char* name) const {
        for (const Landmark& one : found)
            if (one.name == name) {
                EXPECT_EQ(mesh.vertices(one.vertex, 0), 0.0) << name;
                return mesh.vertices(one.vertex, 1);
            }
        ADD_FAILURE() << "no " << name;
        return NAN;
    }
};

TEST(ProfileLandmarks, LieAtTheProfilesBulgesAndHollows) {
    const Sheet sheet;
    const auto found = profile_landmarks(sheet.mesh, sheet.points);
    ASSERT_EQ(found.size(), 5u);
    EXPECT_EQ(sheet.height(found, "glabella"), 58);
    const double nasion = sheet.height(found, "nasion");
    for (int y = 20; y < 58; ++y) EXPECT_LE(Sheet::profile(nasion), Sheet::profile(y)) << y;
    EXPECT_NEAR(sheet.height(found, "pogonion"), -65, 1);
    const double hollow = sheet.height(found, "sublabiale");
    EXPECT_GT(hollow, -65);
    EXPECT_LT(hollow, -40);
    const double columella = sheet.height(found, "columella");
    EXPECT_GT(columella, -12);
    EXPECT_LT(columella, 5);
}

TEST(ProfileLandmarks, AreNotSoughtOnTheBackOfTheHead) {
    Sheet head;
    const Index n = head.mesh.vertices.rows(), m = head.mesh.triangles.rows();
    Points both(2 * n, 3);
    both << head.mesh.vertices, head.mesh.vertices;
    both.bottomRows(n).col(2).array() = -both.bottomRows(n).col(2).array() + 20;
    Triangles triangles(2 * m, 3);
    triangles << head.mesh.triangles, head.mesh.triangles;
    triangles.bottomRows(m).array() += static_cast<std::uint32_t>(n);
    head.mesh.vertices = both;
    head.mesh.triangles = triangles;
    for (const Landmark& one : profile_landmarks(head.mesh, head.points))
        EXPECT_GT(head.mesh.vertices(one.vertex, 2), 50) << one.name;
}

TEST(ProfileLandmarks, GivenOnesStayAndAreNotDoubled) {
    Sheet sheet;
    sheet.points.push_back({"Nasion", Sheet::at(40)});
    for (const Landmark& one : profile_landmarks(sheet.mesh, sheet.points))
        EXPECT_NE(one.name, "nasion");
}

TEST(ProfileLandmarks, SayWhatTheyLack) {
    const auto status = [](const TriMesh& mesh, const std::vector<Landmark>& points) {
        try {
            (void)profile_landmarks(mesh, points);
        } catch (const Error& error) {
            return error.status();
        }
        return Status::ok;
    };
    Sheet sheet;
    EXPECT_EQ(status(sheet.mesh, {}), Status::not_found);
    auto beyond = sheet.points;
    beyond[0].vertex = 1u << 30;
    EXPECT_EQ(status(sheet.mesh, beyond), Status::mismatch);
    TriMesh lopsided = sheet.mesh;
    lopsided.vertices.col(0).array() += 20;
    EXPECT_EQ(status(lopsided, sheet.points), Status::invalid_mesh);
}

}  // namespace
}  // namespace mien
