// The software renderer: what is in front hides what is behind, colours mean what the bar says,
// wrong input is refused.
#include "render.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "plot.hpp"

namespace mien::cli {
namespace {

MeshArrays square(double z, Color color, double half = 50) {
    MeshArrays mesh;
    mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.colors.assign(4, color);
    return mesh;
}
MeshArrays joined(const MeshArrays& a, const MeshArrays& b) {
    MeshArrays both = a;
    const auto shift = static_cast<std::uint32_t>(a.positions.size());
    both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
    both.colors.insert(both.colors.end(), b.colors.begin(), b.colors.end());
    for (const Triangle& t : b.triangles)
        both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    return both;
}
RenderOptions front(int size = 100) {
    RenderOptions options;
    options.views = {"front"};
    options.size = size;
    return options;
}
int brightness(Rgb c) {
    return c[0] + c[1] + c[2];
}

TEST(Render, ShowsWhatIsNearer) {
    const MeshArrays red = square(10, {220, 30, 30}), blue = square(-10, {30, 30, 220});
    for (const MeshArrays& scene : {joined(red, blue), joined(blue, red)}) {
        const Image picture = render_mesh(scene, front());
        const Rgb middle = picture.at(picture.width / 2, picture.height / 2);
        EXPECT_GT(middle[0], 2 * middle[2]);
    }
    RenderOptions behind = front();
    behind.views = {"back"};
    const Image picture = render_mesh(joined(red, blue), behind);
    const Rgb middle = picture.at(picture.width / 2, picture.height / 2);
    EXPECT_GT(middle[2], 2 * middle[0]);
}

TEST(Render, BackFacesAreDarker) {
    RenderOptions options = front();
    const Rgb facing = render_mesh(square(0, {200, 200, 200}), options).at(50, 50);
    options.views = {"back"};
    const Rgb away = render_mesh(square(0, {200, 200, 200}), options).at(50, 50);
    EXPECT_LT(brightness(away), 0.7 * brightness(facing));
}

TEST(Render, LeftViewShowsTheSubjectsLeft) {
    MeshArrays mesh = joined(square(0, {200, 200, 200}), square(0, {200, 200, 200}));
    // A red square standing at x = +50, facing +x.
    for (std::size_t v = 4; v < 8; ++v) {
        mesh.positions[v] = {60, mesh.positions[v][1], -mesh.positions[v][0]};
        mesh.colors[v] = {220, 20, 20};
    }
    RenderOptions options = front();
    options.views = {"left"};
    const Image picture = render_mesh(mesh, options);
    const Rgb middle = picture.at(picture.width / 2, picture.height / 2);
    EXPECT_GT(middle[0], 3 * middle[1]);
}

TEST(Render, ViewsStandSideBySideAndTheBarComesLast) {
    const MeshArrays mesh = square(0, {200, 200, 200});
    const int one = render_mesh(mesh, front()).width;
    RenderOptions options = front();
    options.views = {"front", "front"};
    EXPECT_EQ(render_mesh(mesh, options).width, 2 * one);
    options.scalar = {0, 1, 2, 3};
    EXPECT_GT(render_mesh(mesh, options).width, 2 * one);
}

TEST(Render, EdgesAreSmoothedByFourSamples) {
    MeshArrays mesh = square(0, {0, 0, 0});
    mesh.triangles.pop_back();  // a slanted edge
    const Image picture = render_mesh(mesh, front());
    int between = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const int c = picture.at(x, y)[0];
            between += c > 40 && c < 220;
        }
    EXPECT_GT(between, 30);
}

TEST(Render, HeatMapPaintsLowAndHighAndGreyWithoutValue) {
    MeshArrays mesh = square(0, {});
    RenderOptions options = front();
    const auto middle = [&](double value) {
        options.scalar.assign(4, value);
        options.low = 0;
        options.high = 1;
        const Image picture = render_mesh(mesh, options);
        return picture.at(45, 50);
    };
    EXPECT_GT(brightness(middle(1)), brightness(middle(0)) + 100);
    const Rgb none = middle(std::nan(""));
    EXPECT_NEAR(none[0], none[2], 6);
}

TEST(Render, ColorMapsGrowEvenly) {
    // Lightness of the sequential map rises all the way; the diverging one is brightest in the
    // middle.
    const auto light = [](Rgb c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
    for (int k = 0; k < 50; ++k)
        EXPECT_LT(light(map_color(ColorMap::sequential, k / 50.0)),
                  light(map_color(ColorMap::sequential, (k + 1) / 50.0)) + 0.5);
    EXPECT_GT(light(map_color(ColorMap::diverging, 0.5)),
              light(map_color(ColorMap::diverging, 0.1)));
    EXPECT_GT(light(map_color(ColorMap::diverging, 0.5)),
              light(map_color(ColorMap::diverging, 0.9)));
    EXPECT_EQ(map_color(ColorMap::sequential, -3), map_color(ColorMap::sequential, 0));
    EXPECT_EQ(map_color(ColorMap::sequential, 7), map_color(ColorMap::sequential, 1));
}

TEST(Render, DrawsPointCloudsAndFlatMeshes) {
    MeshArrays cloud;
    cloud.positions = {{0, 0, 0}, {10, 5, 0}, {-10, -5, 0}};
    const Image picture = render_mesh(cloud, front());
    int dark = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) dark += brightness(picture.at(x, y)) < 700;
    EXPECT_GT(dark, 2);
    MeshArrays point;
    point.positions = {{1, 2, 3}};
    point.triangles = {{0, 0, 0}};
    EXPECT_NO_THROW(render_mesh(point, front()));
}

TEST(Render, RefusesWhatMakesNoSense) {
    const MeshArrays mesh = square(0, {1, 2, 3});
    EXPECT_THROW(render_mesh({}, front()), std::invalid_argument);
    EXPECT_THROW(render_mesh(mesh, front(8)), std::invalid_argument);
    RenderOptions options = front();
    options.views = {"sideways"};
    EXPECT_THROW(render_mesh(mesh, options), std::invalid_argument);
    options.views = {};
    EXPECT_THROW(render_mesh(mesh, options), std::invalid_argument);
    options = front();
    options.scalar = {1, 2};
    EXPECT_THROW(render_mesh(mesh, options), std::invalid_argument);
    options = front();
    options.views = {"12.5"};
    EXPECT_NO_THROW(render_mesh(mesh, options));
}

TEST(Plot, PutsCurvesWhereTheirNumbersAre) {
    Curve curve{"rising", {0, 1, 2}, {0, 1, 2}, {}, true, false, 1};
    PlotOptions options;
    options.title = "A title";
    const Image picture = draw_plot({curve}, options);
    EXPECT_EQ(picture.width, options.width);
    // The curve's colour appears low on the left and high on the right.
    const Rgb color = palette_color(1);
    const auto mean_row = [&](int from, int to) {
        double sum = 0, count = 0;
        for (int y = 40; y < picture.height - 50; ++y)
            for (int x = from; x < to; ++x)
                if (picture.at(x, y) == color) sum += y, ++count;
        return count > 0 ? sum / count : -1;
    };
    EXPECT_GT(mean_row(100, 200), mean_row(480, 600) + 100);
}

TEST(Plot, CopesWithGapsConstantsAndLogarithms) {
    PlotOptions options;
    EXPECT_NO_THROW(
        draw_plot({{"gap", {0, 1, 2}, {1, std::nan(""), 3}, {0.1, 0.1, 0.1}}}, options));
    EXPECT_NO_THROW(draw_plot({{"flat", {0, 1}, {5, 5}, {}}}, options));
    EXPECT_NO_THROW(draw_plot({{"one", {3}, {0}, {}, false, true}}, options));
    options.log_x = options.log_y = true;
    EXPECT_NO_THROW(draw_plot({{"log", {1, 10, 1000}, {0, 1e-3, 2}, {}}}, options));
    EXPECT_THROW(draw_plot({}, options), std::invalid_argument);
    EXPECT_THROW(draw_plot({{"bad", {1, 2}, {1}, {}}}, options), std::invalid_argument);
}

TEST(Plot, BarsGrowWithTheirValues) {
    const Image picture = draw_bars({"a", "b"}, {"s"}, {{1, 3}}, {});
    int first = 0, second = 0;
    for (int y = 30; y < picture.height - 40; ++y)
        for (int x = 70; x < picture.width; ++x)
            if (picture.at(x, y) == palette_color(0)) ++(x < picture.width / 2 ? first : second);
    EXPECT_GT(second, 2 * first);
    EXPECT_GT(first, 0);
    EXPECT_THROW(draw_bars({"a"}, {"s"}, {{1, 2}}, {}), std::invalid_argument);
}

TEST(Plot, TicksAreRoundAndInside) {
    for (const auto& [low, high] :
         {std::pair{0.0, 1.0}, std::pair{-3.2, 17.9}, std::pair{1e-7, 3e-7}, std::pair{0.0, 1e9}}) {
        const auto ticks = round_ticks(low, high, 6);
        EXPECT_GE(ticks.size(), 3u);
        EXPECT_LE(ticks.size(), 14u);
        for (double t : ticks) {
            EXPECT_GE(t, low - 1e-9 * (high - low));
            EXPECT_LE(t, high + 1e-9 * (high - low));
        }
    }
    EXPECT_EQ(round_ticks(2, 2, 5).size(), 1u);
}

}  // namespace
}  // namespace mien::cli
