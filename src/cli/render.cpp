#include "render.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mien::cli {
namespace {

using Vec = std::array<double, 3>;
constexpr int kSamples = 2;  // samples per pixel and axis
constexpr int kMargin = 10;  // pixels around each view
// A line lies on the surface, whose triangles may hide it by rounding and by their bends.
constexpr double kLineSlackMm = 1.5;
constexpr Rgb kLineColor{30, 90, 60};

Vec minus(const Vec& a, const Vec& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec unit(Vec a) {
    const double n = std::sqrt(dot(a, a));
    if (n > 0)
        for (double& x : a) x /= n;
    return a;
}

/// Rows: the camera's right, up and backward directions in the mesh's frame.
using Camera = std::array<Vec, 3>;

Camera camera_of(const std::string& view) {
    const double pi = std::acos(-1.0);
    double turn = 0;
    if (view == "front")
        turn = 0;
    else if (view == "left")
        turn = 90;
    else if (view == "right")
        turn = -90;
    else if (view == "left45")
        turn = 45;
    else if (view == "right45")
        turn = -45;
    else if (view == "back")
        turn = 180;
    else if (view == "top")
        return {Vec{1, 0, 0}, Vec{0, 0, -1}, Vec{0, 1, 0}};
    else {
        std::size_t used = 0;
        try {
            turn = std::stod(view, &used);
        } catch (const std::exception&) {
            used = 0;
        }
        if (used == 0 || used != view.size() || !std::isfinite(turn)) {
            std::string known;
            for (const std::string& name : view_names())
                known += (known.empty() ? "" : ", ") + name;
            throw std::invalid_argument("unknown view '" + view + "'; use " + known +
                                        " or an angle in degrees");
        }
    }
    const double c = std::cos(turn * pi / 180), s = std::sin(turn * pi / 180);
    return {Vec{c, 0, -s}, Vec{0, 1, 0}, Vec{s, 0, c}};
}

Vec to_camera(const Camera& camera, const Vec& p) {
    return {dot(camera[0], p), dot(camera[1], p), dot(camera[2], p)};
}

std::vector<Vec> vertex_normals(const MeshArrays& mesh) {
    std::vector<Vec> normals(mesh.positions.size(), Vec{0, 0, 0});
    for (const Triangle& t : mesh.triangles) {
        const Vec n = cross(minus(mesh.positions[t[1]], mesh.positions[t[0]]),
                            minus(mesh.positions[t[2]], mesh.positions[t[0]]));
        for (std::uint32_t v : t)
            for (std::size_t k = 0; k < 3; ++k) normals[v][k] += n[k];
    }
    for (Vec& n : normals) n = unit(n);
    return normals;
}

/// Two lights and a little ambient, in camera space; the back of a surface is darker.
Rgb shade(const Vec& normal, const Vec& base) {
    static const Vec kKey = unit({-0.45, 0.55, 0.75}), kFill = unit({0.75, 0.10, 0.55});
    const bool back = normal[2] < 0;
    const Vec n = back ? Vec{-normal[0], -normal[1], -normal[2]} : normal;
    double light = 0.26 + 0.56 * std::max(0.0, dot(n, kKey)) + 0.30 * std::max(0.0, dot(n, kFill));
    if (back) light *= 0.45;
    Rgb out;
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = static_cast<std::uint8_t>(std::clamp(base[k] * light + 0.5, 0.0, 255.0));
    return out;
}

struct Frame {
    Vec centre{};      // mesh frame
    double scale = 1;  // pixels per mm
};

class Raster {
  public:
    Raster(int width, int height)
        : image(width, height),
          depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -HUGE_VAL) {}

    void triangle(const Vec p[3], const Vec normals[3], const Vec colors[3]) {
        const double area =
            (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
        if (area == 0 || !std::isfinite(area)) return;
        const auto first = [](double a, double b, double c) {
            return static_cast<int>(std::max(0.0, std::ceil(std::min({a, b, c}))));
        };
        const auto last = [](double a, double b, double c, int end) {
            return static_cast<int>(std::min<double>(end - 1, std::floor(std::max({a, b, c}))));
        };
        const int x_end = last(p[0][0], p[1][0], p[2][0], image.width);
        const int y_end = last(p[0][1], p[1][1], p[2][1], image.height);
        for (int y = first(p[0][1], p[1][1], p[2][1]); y <= y_end; ++y)
            for (int x = first(p[0][0], p[1][0], p[2][0]); x <= x_end; ++x) {
                double w[3];
                for (int k = 0; k < 3; ++k) {
                    const Vec &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
                    w[k] = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
                }
                if (w[0] < 0 || w[1] < 0 || w[2] < 0) continue;
                const double z = w[0] * p[0][2] + w[1] * p[1][2] + w[2] * p[2][2];
                double& nearest =
                    depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x)];
                if (z <= nearest) continue;
                nearest = z;
                Vec n{}, c{};
                for (std::size_t k = 0; k < 3; ++k)
                    for (std::size_t i = 0; i < 3; ++i) {
                        n[i] += w[k] * normals[k][i];
                        c[i] += w[k] * colors[k][i];
                    }
                image.set(x, y, shade(unit(n), c));
            }
    }
    void dot_at(const Vec& p, const Vec& color) {
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const int x = static_cast<int>(p[0]) + i, y = static_cast<int>(p[1]) + j;
                if (!image.contains(x, y)) continue;
                double& nearest =
                    depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x)];
                if (p[2] <= nearest) continue;
                nearest = p[2];
                image.set(x, y, shade({0, 0, 1}, color));
            }
    }
    /// A line on the surface: hidden only by what lies in front of it by more than `slack`.
    void line(const Vec& from, const Vec& to, double slack, const Rgb& color) {
        const double steps = std::clamp(
            std::ceil(std::max(std::fabs(to[0] - from[0]), std::fabs(to[1] - from[1]))), 1.0, 1e5);
        for (double step = 0; step <= steps; ++step) {
            const double t = step / steps, z = from[2] + t * (to[2] - from[2]);
            const int x = static_cast<int>(std::lround(from[0] + t * (to[0] - from[0])));
            const int y = static_cast<int>(std::lround(from[1] + t * (to[1] - from[1])));
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    if (image.contains(x + i, y + j) &&
                        z + slack >= depth_[static_cast<std::size_t>(y + j) *
                                                static_cast<std::size_t>(image.width) +
                                            static_cast<std::size_t>(x + i)])
                        image.set(x + i, y + j, color);
        }
    }
    Image image;

  private:
    std::vector<double> depth_;
};

Image smaller(const Image& big) {
    Image out(big.width / kSamples, big.height / kSamples);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            int sum[3] = {0, 0, 0};
            for (int j = 0; j < kSamples; ++j)
                for (int i = 0; i < kSamples; ++i) {
                    const Rgb c = big.at(kSamples * x + i, kSamples * y + j);
                    for (std::size_t k = 0; k < 3; ++k) sum[k] += c[k];
                }
            Rgb mean;
            for (std::size_t k = 0; k < 3; ++k)
                mean[k] = static_cast<std::uint8_t>((sum[k] + kSamples * kSamples / 2) /
                                                    (kSamples * kSamples));
            out.set(x, y, mean);
        }
    return out;
}

Image render_view(const MeshArrays& mesh, const std::vector<Vec>& normals,
                  const std::vector<Vec>& colors, const Camera& camera, const MeshArrays& framing,
                  const Frame& frame, const RenderOptions& options) {
    double half_width = 0;
    for (const Vec& p : framing.positions)
        half_width = std::max(half_width, std::fabs(dot(camera[0], minus(p, frame.centre))));
    const int width = std::clamp(static_cast<int>(2 * half_width * frame.scale) + 2 * kMargin, 32,
                                 3 * options.size);
    const int height = options.size;
    const auto place = [&](const Vec& p, int samples) {
        Vec q = to_camera(camera, minus(p, frame.centre));
        q[0] = samples * (q[0] * frame.scale + width / 2.0) - 0.5;
        q[1] = samples * (height / 2.0 - q[1] * frame.scale) - 0.5;
        return q;
    };
    Raster raster(width * kSamples, height * kSamples);
    std::vector<Vec> placed(mesh.positions.size()), turned(mesh.positions.size());
    for (std::size_t v = 0; v < placed.size(); ++v) {
        placed[v] = place(mesh.positions[v], kSamples);
        turned[v] = to_camera(camera, normals[v]);
    }
    for (const Triangle& t : mesh.triangles) {
        const Vec p[3] = {placed[t[0]], placed[t[1]], placed[t[2]]};
        const Vec n[3] = {turned[t[0]], turned[t[1]], turned[t[2]]};
        const Vec c[3] = {colors[t[0]], colors[t[1]], colors[t[2]]};
        raster.triangle(p, n, c);
    }
    if (mesh.triangles.empty())
        for (std::size_t v = 0; v < placed.size(); ++v) raster.dot_at(placed[v], colors[v]);
    for (const auto& edge : options.lines)
        raster.line(placed[edge[0]], placed[edge[1]], kLineSlackMm, kLineColor);
    Image view = smaller(raster.image);
    for (const Position& p : options.points) {
        const Vec q = place(p, 1);
        draw_disc(view, q[0], q[1], 2.2, {225, 30, 30});
    }
    return view;
}

Image color_bar(const RenderOptions& options, double low, double high, int height) {
    const std::vector<double> ticks = round_ticks(low, high, 5);
    std::size_t longest = 0;
    for (double t : ticks) longest = std::max(longest, short_number(t).size());
    const int top = height / 8, span = height - 2 * top, text = static_cast<int>(longest) * 6;
    Image bar(14 + 18 + 8 + text + (options.label.empty() ? 8 : 24), height);
    for (int y = 0; y < span; ++y)
        fill_box(bar, 14, top + y, 18, 1, map_color(options.color_map, 1 - (y + 0.5) / span));
    for (double t : ticks) {
        const double at = high > low ? (t - low) / (high - low) : 0;
        const int y = top + static_cast<int>(std::lround((1 - at) * (span - 1)));
        fill_box(bar, 32, y, 4, 1, kBlack);
        draw_text(bar, 39, y - 3, short_number(t));
    }
    if (!options.label.empty())
        draw_text(bar, bar.width - 12, height / 2 + text_width(options.label) / 2, options.label,
                  kBlack, 1, true);
    return bar;
}

/// Smallest and largest finite value, or 0..1 when there is none.
std::pair<double, double> range_of(const RenderOptions& options) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (double s : options.scalar)
        if (std::isfinite(s)) {
            low = std::min(low, s);
            high = std::max(high, s);
        }
    if (low > high) low = 0, high = 1;
    if (options.color_map == ColorMap::diverging) {
        high = std::max(std::fabs(low), std::fabs(high));
        low = -high;
    }
    if (!std::isnan(options.low)) low = options.low;
    if (!std::isnan(options.high)) high = options.high;
    return {low, high};
}

}  // namespace

MeshArrays arrays_of(const Mesh& mesh) {
    return {mesh.positions(), mesh.triangles(), mesh.colors()};
}

std::vector<std::string> view_names() {
    return {"front", "left", "right", "left45", "right45", "back", "top"};
}

Rgb map_color(ColorMap map, double t) {
    if (!(t == t)) return kGrey;
    t = std::clamp(t, 0.0, 1.0);
    Rgb out{};
    if (map == ColorMap::sequential) {
        // Polynomials of degree 6 through the viridis map (van der Walt and Smith 2015), error < 2
        // %.
        static constexpr double kFit[3][7] = {
            {0.2745, 0.1077, -0.3272, -4.5999, 6.2037, 4.7518, -5.4321},
            {0.0058, 1.3965, 0.2148, -5.7582, 14.154, -13.7494, 4.6416},
            {0.3327, 1.3868, 0.092, -19.2918, 56.6563, -65.321, 26.2721}};
        for (std::size_t k = 0; k < 3; ++k) {
            double value = 0;
            for (int power = 6; power >= 0; --power) value = value * t + kFit[k][power];
            out[k] = static_cast<std::uint8_t>(std::clamp(255 * value + 0.5, 0.0, 255.0));
        }
        return out;
    }
    static constexpr double kEnds[2][3] = {{44, 84, 178}, {178, 34, 40}};
    const double* end = kEnds[t > 0.5];
    const double away = std::fabs(2 * t - 1);
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = static_cast<std::uint8_t>(
            std::lround(242 + (end[k] - 242) * (0.35 * away * away + 0.65 * away)));
    return out;
}

Image render_mesh(const MeshArrays& mesh, const RenderOptions& options) {
    if (mesh.positions.empty()) throw std::invalid_argument("there is no vertex to draw");
    if (options.size < 32 || options.size > 4096)
        throw std::invalid_argument("the size of a view must be 32 to 4096 pixels");
    if (options.views.empty() || options.views.size() > 16)
        throw std::invalid_argument("give 1 to 16 views");
    if (!options.scalar.empty() && options.scalar.size() != mesh.positions.size())
        throw std::invalid_argument("the scalar has " + std::to_string(options.scalar.size()) +
                                    " values for " + std::to_string(mesh.positions.size()) +
                                    " vertices");
    for (const auto& edge : options.lines)
        if (edge[0] >= mesh.positions.size() || edge[1] >= mesh.positions.size())
            throw std::invalid_argument("a line ends at a vertex that the mesh does not have");
    std::vector<Vec> colors(mesh.positions.size(), Vec{205, 200, 195});
    const auto [low, high] = range_of(options);
    for (std::size_t v = 0; v < colors.size(); ++v) {
        if (!options.scalar.empty()) {
            const double s = options.scalar[v];
            const Rgb c =
                map_color(options.color_map, high > low ? (s - low) / (high - low) : s - low);
            colors[v] = {double(c[0]), double(c[1]), double(c[2])};
        } else if (options.use_colors && mesh.colors.size() == mesh.positions.size()) {
            const Color c = mesh.colors[v];
            colors[v] = {double(c[0]), double(c[1]), double(c[2])};
        }
    }
    const MeshArrays& framing = options.framing != nullptr ? *options.framing : mesh;
    Vec least = framing.positions.front(), most = least;
    for (const Vec& p : framing.positions)
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    Frame frame;
    const Vec span = minus(most, least);
    for (std::size_t k = 0; k < 3; ++k) frame.centre[k] = 0.5 * (least[k] + most[k]);
    const double tallest = std::max({span[1], span[0] / 3, span[2] / 3, 1e-9});
    frame.scale = (options.size - 2 * kMargin) / tallest;
    const std::vector<Vec> normals = vertex_normals(mesh);
    std::vector<Image> parts;
    for (const std::string& view : options.views)
        parts.push_back(
            render_view(mesh, normals, colors, camera_of(view), framing, frame, options));
    if (!options.scalar.empty() && options.color_bar)
        parts.push_back(color_bar(options, low, high, options.size));
    Image picture = stack_images(parts, true);
    if (options.title.empty()) return picture;
    Image titled(std::max(picture.width, text_width(options.title, 2) + 20), picture.height + 26);
    draw_text(titled, (titled.width - text_width(options.title, 2)) / 2, 8, options.title, kBlack,
              2);
    paste(titled, picture, 0, 26);
    return titled;
}

Image stack_images(const std::vector<Image>& images, bool sideways) {
    int width = 0, height = 0;
    for (const Image& image : images) {
        width = sideways ? width + image.width : std::max(width, image.width);
        height = sideways ? std::max(height, image.height) : height + image.height;
    }
    Image out(width, height);
    int at = 0;
    for (const Image& image : images) {
        paste(out, image, sideways ? at : 0, sideways ? 0 : at);
        at += sideways ? image.width : image.height;
    }
    return out;
}

}  // namespace mien::cli
