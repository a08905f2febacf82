#include "scanner.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "sculpture.hpp"

namespace mien::demo {
namespace {

enum Kind : unsigned char { kSkin, kCavity, kEyeball, kHair };

constexpr double kAxisZ = 10, kReferenceRadius = 95, kHalfAngle = 1.92;  // cylinder; mm, mm, rad
constexpr double kYLow = -138, kYHigh = 152, kXHigh = 105;               // field of view, mm

// What a scanner may meet: all pieces in one list, each corner with colour and template position.
struct Scene {
    std::vector<V3> points, colors, rest;
    std::vector<std::array<int, 3>> triangles;
    std::vector<Kind> kinds;  // per triangle

    int add(V3 p, V3 color, V3 at_rest) {
        points.push_back(p);
        colors.push_back(color);
        rest.push_back(at_rest);
        return static_cast<int>(points.size()) - 1;
    }
    void add(int a, int b, int c, Kind kind) {
        triangles.push_back({a, b, c});
        kinds.push_back(kind);
    }
};

class Waves {  // smooth random function of position with unit variance
  public:
    Waves(Random& random, double wavelength) {
        for (auto& [k, phase] : waves_) {
            const V3 d = random.direction();
            k = (2 * kPi / (wavelength * random.uniform(0.7, 1.5))) * d;
            phase = random.uniform(0, 2 * kPi);
        }
    }
    double operator()(V3 p) const {
        double sum = 0;
        for (const auto& [k, phase] : waves_) sum += cos_of(dot(k, p) + phase);
        return sum * std::sqrt(2.0 / 12);
    }

  private:
    std::array<std::pair<V3, double>, 12> waves_;
};

double hair_above(V3 p) {  // height above the hair line of a template position; negative: bare skin
    const double turn = std::fabs(atan2_of(p.x, p.z - kAxisZ)) * 180 / kPi;
    static constexpr double kTurn[] = {0, 35, 52, 64, 74, 84, 112, 124, 180};
    static constexpr double kLine[] = {97, 94, 80, 62, 44, 48, 42, -10, -45};
    for (int k = 0; k + 1 < 9; ++k)
        if (turn <= kTurn[k + 1])
            return p.y - mix(kLine[k], kLine[k + 1], (turn - kTurn[k]) / (kTurn[k + 1] - kTurn[k]));
    return -1;
}

// The skin, every edge split at the middle of its cubic (PN triangles: Vlachos et al. 2001), so
// that a scan finer than the template does not show its facets.
void add_skin(Scene& scene, const Anatomy& a, const std::vector<V3>& shape, V3 tone,
              Random& random) {
    const Waves blotches(random, 40), pores(random, 7);
    const auto normals = normals_of(shape, a.head.triangles);
    const auto color = [&](V3 base, V3 rest) {
        const double spot = 5 * blotches(rest) + 2.5 * pores(rest);
        return V3{base.x * tone.x + spot, base.y * tone.y + spot, base.z * tone.z + spot};
    };
    const auto painted = [&](int v) {
        const auto& c = a.head.colors[v];
        return V3{double(c[0]), double(c[1]), double(c[2])};
    };
    for (int v = 0; v < a.count(); ++v)
        scene.add(shape[v], color(painted(v), a.rest[v]), a.rest[v]);
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int u, int v) {
        const auto [it, fresh] = middles.insert({std::minmax(u, v), 0});
        if (fresh) {
            const V3 edge = shape[v] - shape[u];
            const V3 bend = dot(edge, normals[u]) * normals[u] - dot(edge, normals[v]) * normals[v];
            const V3 rest = mix(a.rest[u], a.rest[v], 0.5);
            it->second = scene.add(mix(shape[u], shape[v], 0.5) - bend / 8,
                                   color(mix(painted(u), painted(v), 0.5), rest), rest);
        }
        return it->second;
    };
    for (const auto& t : a.head.triangles) {
        const int m[3] = {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
        scene.add(t[0], m[0], m[2], kSkin);
        scene.add(m[0], t[1], m[1], kSkin);
        scene.add(m[2], m[1], t[2], kSkin);
        scene.add(m[0], m[1], m[2], kSkin);
    }
}

void add_hair(Scene& scene, const Anatomy& a, const std::vector<V3>& shape, Random& random) {
    const Waves edge(random, 35), tufts(random, 30), strands(random, 8), fine(random, 4);
    const V3 dark = V3{58, 42, 32} * random.uniform(0.7, 2.2);
    const double thickness = random.uniform(6, 12);
    const auto normals = normals_of(shape, a.head.triangles);
    std::vector<int> hair(shape.size(), -1);
    for (int v = 0; v < a.count(); ++v) {
        const V3 rest = a.rest[v];
        const double above = hair_above(rest) + 5 * edge(rest);
        if (above < 0) continue;
        const V3 along{rest.x, 0.3 * rest.y, rest.z};
        double height = ramp(0, 14, above) * (thickness + 2.5 * tufts(rest));
        height +=
            ramp(0, 4, above) * (1.5 + 1.6 * strands(along) + fine(along) + 0.6 * random.normal());
        hair[v] = scene.add(shape[v] + std::max(0.3, height) * normals[v],
                            dark + 10 * strands(along) * V3{1, 1, 1}, rest);
    }
    for (const auto& t : a.head.triangles)
        if (hair[t[0]] >= 0 && hair[t[1]] >= 0 && hair[t[2]] >= 0)
            scene.add(hair[t[0]], hair[t[1]], hair[t[2]], kHair);
}

void add_eyeballs(Scene& scene, const Anatomy& a, const std::vector<V3>& neutral, Random& random) {
    const V3 iris = random.uniform() < 0.5 ? V3{86, 58, 40} : V3{92, 120, 140};
    for (int side = 0; side < 2; ++side) {
        const V3 centre = neutral[a.eyeball[side]];
        constexpr int kRows = 33, kColumns = 33;
        int grid[kRows][kColumns];
        for (int j = 0; j < kRows; ++j)
            for (int i = 0; i < kColumns; ++i) {
                const double up = 1.25 * (2.0 * j / (kRows - 1) - 1),
                             across = 1.25 * (2.0 * i / (kColumns - 1) - 1);
                const V3 n{cos_of(up) * sin_of(across), sin_of(up), cos_of(up) * cos_of(across)};
                const V3 color = n.z > 0.985  ? V3{18, 16, 16}
                                 : n.z > 0.91 ? iris
                                              : V3{232, 224, 218};
                const V3 p = centre + (plan::kEyeballRadius - 0.3) * n;
                grid[j][i] = scene.add(p, color, p);
            }
        for (int j = 0; j + 1 < kRows; ++j)
            for (int i = 0; i + 1 < kColumns; ++i) {
                scene.add(grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], kEyeball);
                scene.add(grid[j][i], grid[j + 1][i + 1], grid[j + 1][i], kEyeball);
            }
    }
}

// A dark bag behind the lips: rings from the mouth's border back to a point.
void add_cavity(Scene& scene, const Anatomy& a, const std::vector<V3>& shape) {
    std::map<std::pair<int, int>, int> directed;
    for (const auto& t : a.head.triangles)
        for (int k = 0; k < 3; ++k) directed[{t[k], t[(k + 1) % 3]}] = 1;
    V3 centre;
    double count = 0;
    for (int v = 0; v < a.count(); ++v)
        if (a.head.rim[v] >= Rim::lip_upper && a.head.rim_row[v] == 3) {
            centre += shape[v];
            ++count;
        }
    centre = centre / count - V3{0, 0, 34};
    constexpr int kRings = 5;
    const V3 dark{88, 40, 40};
    std::vector<std::array<int, kRings + 1>> spoke(shape.size());
    for (int v = 0; v < a.count(); ++v)
        if (a.head.rim[v] >= Rim::lip_upper && a.head.rim_row[v] == 3)
            for (int k = 0; k <= kRings; ++k) {
                const double t = static_cast<double>(k) / kRings;
                V3 p = mix(shape[v], centre, t * t);
                p.z = mix(shape[v].z, centre.z, t);
                spoke[v][k] = scene.add(p, dark, a.rest[v]);
            }
    for (const auto& [edge, one] : directed) {
        const int u = edge.first, v = edge.second;
        if (a.head.rim[u] < Rim::lip_upper || a.head.rim_row[u] != 3 ||
            a.head.rim[v] < Rim::lip_upper || a.head.rim_row[v] != 3 || directed.count({v, u}) != 0)
            continue;
        for (int k = 0; k < kRings; ++k) {
            scene.add(spoke[v][k], spoke[u][k], spoke[u][k + 1], kCavity);
            scene.add(spoke[v][k], spoke[u][k + 1], spoke[v][k + 1], kCavity);
        }
    }
}

// The scanner's grid: what each cell sees first.
struct Grid {
    int width = 0, height = 0;
    double step = 1;
    bool cylindrical = true;
    std::vector<double> depth;  // distance from the cylinder's axis, or z; -1e9: nothing
    std::vector<int> triangle;
    std::vector<std::array<double, 3>> weights;

    V3 to_grid(V3 p) const {
        const double v = (p.y - kYLow) / step;
        if (!cylindrical) return {(p.x + kXHigh) / step, v, p.z};
        const double turn = atan2_of(p.x, p.z - kAxisZ);
        return {(turn + kHalfAngle) * kReferenceRadius / step, v,
                std::sqrt(p.x * p.x + square(p.z - kAxisZ))};
    }
    V3 ray(int cell) const {  // towards the scanner
        if (!cylindrical) return {0, 0, 1};
        const double turn = cell % width * step / kReferenceRadius - kHalfAngle;
        return {sin_of(turn), 0, cos_of(turn)};
    }
    V3 point(int cell) const {
        const double y = kYLow + step * (cell / width);
        if (!cylindrical) return {cell % width * step - kXHigh, y, depth[cell]};
        const V3 n = ray(cell);
        return {depth[cell] * n.x, y, kAxisZ + depth[cell] * n.z};
    }
};

Grid look(const Scene& scene, const ScanOptions& options) {
    Grid grid;
    grid.step = options.step_mm;
    grid.cylindrical = options.cylindrical;
    const double wide = options.cylindrical ? 2 * kHalfAngle * kReferenceRadius : 2 * kXHigh;
    grid.width = static_cast<int>(wide / grid.step) + 1;
    grid.height = static_cast<int>((kYHigh - kYLow) / grid.step) + 1;
    const std::size_t cells = static_cast<std::size_t>(grid.width) * grid.height;
    grid.depth.assign(cells, -1e9);
    grid.triangle.assign(cells, -1);
    grid.weights.resize(cells);
    std::vector<V3> seen;
    seen.reserve(scene.points.size());
    for (const V3 p : scene.points) seen.push_back(grid.to_grid(p));
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        const V3 a = seen[scene.triangles[t][0]], b = seen[scene.triangles[t][1]],
                 c = seen[scene.triangles[t][2]];
        const double low = std::min({a.x, b.x, c.x}), high = std::max({a.x, b.x, c.x});
        if (grid.cylindrical && high - low > 0.5 * wide / grid.step) continue;  // across the seam
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (area <= 0) continue;  // turned away
        const int x_end = static_cast<int>(std::min<double>(grid.width - 1, std::floor(high)));
        const int y_end = static_cast<int>(
            std::min<double>(grid.height - 1, std::floor(std::max({a.y, b.y, c.y}))));
        for (int y = static_cast<int>(std::max(0.0, std::ceil(std::min({a.y, b.y, c.y}))));
             y <= y_end; ++y)
            for (int x = static_cast<int>(std::max(0.0, std::ceil(low))); x <= x_end; ++x) {
                const double wa = ((b.x - x) * (c.y - y) - (b.y - y) * (c.x - x)) / area;
                const double wb = ((c.x - x) * (a.y - y) - (c.y - y) * (a.x - x)) / area;
                const double wc = 1 - wa - wb;
                if (wa < 0 || wb < 0 || wc < 0) continue;
                const double depth = wa * a.z + wb * b.z + wc * c.z;
                const std::size_t cell = static_cast<std::size_t>(y) * grid.width + x;
                if (depth <= grid.depth[cell]) continue;
                grid.depth[cell] = depth;
                grid.triangle[cell] = static_cast<int>(t);
                grid.weights[cell] = {wa, wb, wc};
            }
    }
    return grid;
}

V3 blend(const std::vector<V3>& values, const Scene& scene, const Grid& grid, int cell) {
    const auto& t = scene.triangles[grid.triangle[cell]];
    const auto& w = grid.weights[cell];
    return w[0] * values[t[0]] + w[1] * values[t[1]] + w[2] * values[t[2]];
}

// Ragged blobs on the face where nothing came back, as beards and highlights leave them.
std::vector<char> punch_holes(const Scene& scene, const Grid& grid, int holes, Random& random) {
    std::vector<char> seen(grid.triangle.size());
    std::vector<int> face;
    for (std::size_t cell = 0; cell < seen.size(); ++cell) {
        seen[cell] = grid.triangle[cell] >= 0;
        if (!seen[cell]) continue;
        const V3 rest = blend(scene.rest, scene, grid, static_cast<int>(cell));
        if (rest.z > 35 && rest.y > -80 && rest.y < 95) face.push_back(static_cast<int>(cell));
    }
    for (int k = 0; k < holes && !face.empty(); ++k) {
        const V3 centre = grid.point(face[random.bits() % face.size()]);
        const double radius = random.uniform(4, 10);
        const Waves ragged(random, 11);
        for (int cell : face) {
            const V3 p = grid.point(cell);
            const double d = norm(p - centre);
            if (d < 2 * radius && d * std::max(0.5, 1 + 0.35 * ragged(p)) < radius) seen[cell] = 0;
        }
    }
    return seen;
}

// Two triangles per cell of four seen points, split along the flatter diagonal and cut at steps of
// depth; small fragments dropped.
std::vector<std::array<int, 3>> triangulate(const Grid& grid, const std::vector<char>& seen) {
    std::vector<std::array<int, 3>> out;
    const auto add = [&](int a, int b, int c) {
        if (!seen[a] || !seen[b] || !seen[c]) return;
        const double high = std::max({grid.depth[a], grid.depth[b], grid.depth[c]});
        const double low = std::min({grid.depth[a], grid.depth[b], grid.depth[c]});
        if (high - low < 4.5 * grid.step) out.push_back({a, b, c});
    };
    for (int y = 0; y + 1 < grid.height; ++y)
        for (int x = 0; x + 1 < grid.width; ++x) {
            const int a = y * grid.width + x, b = a + 1, c = b + grid.width, d = a + grid.width;
            const bool first = !seen[b] || !seen[d] ||
                               (seen[a] && seen[c] &&
                                std::fabs(grid.depth[a] - grid.depth[c]) <=
                                    std::fabs(grid.depth[b] - grid.depth[d]));
            if (first) {
                add(a, b, c);
                add(a, c, d);
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        }
    std::vector<int> parent(seen.size());
    for (std::size_t k = 0; k < parent.size(); ++k) parent[k] = static_cast<int>(k);
    const auto find = [&](int k) {
        while (parent[k] != k) k = parent[k] = parent[parent[k]];
        return k;
    };
    for (const auto& t : out) {
        parent[find(t[0])] = find(t[1]);
        parent[find(t[1])] = find(t[2]);
    }
    std::vector<int> size(seen.size(), 0);
    for (const auto& t : out) ++size[find(t[0])];
    out.erase(std::remove_if(out.begin(), out.end(),
                             [&](const auto& t) { return size[find(t[0])] < 40; }),
              out.end());
    return out;
}

}  // namespace

SimulatedScan simulate_scan(const Anatomy& a, const std::vector<V3>& neutral,
                            const std::vector<V3>& shape, const Person& person,
                            const ScanOptions& options) {
    // Looks belong to the person; pose and errors to the scan.
    Random looks(person.seed, 1000003u * static_cast<std::uint64_t>(person.subject) + 500);
    Random random(person.seed ^ (0x1234567ull * (options.seed + 1)),
                  1000003u * static_cast<std::uint64_t>(person.subject) + 501);
    Scene scene;
    static const V3 kTones[] = {
        {1, 1, 1}, {0.92, 0.88, 0.85}, {0.74, 0.68, 0.62}, {0.52, 0.45, 0.40}};
    add_skin(scene, a, shape, kTones[looks.bits() % 4], looks);
    add_eyeballs(scene, a, neutral, looks);
    add_cavity(scene, a, shape);
    if (options.hair) add_hair(scene, a, shape, looks);
    const V3 pose_axis = random.direction(), pose_shift = random.direction();
    const double angle = options.pose_deg * kPi / 180 * random.uniform(0.5, 1);
    const V3 shift = options.pose_mm * random.uniform(0.5, 1) * pose_shift;
    const auto to_scan = [&](V3 p) { return rotate(p, pose_axis, angle) + shift; };

    const Grid grid = look(scene, options);
    const std::vector<char> seen = punch_holes(scene, grid, options.holes, random);
    const auto triangles = triangulate(grid, seen);
    std::vector<int> index(seen.size(), -1);
    for (const auto& t : triangles)
        for (int cell : t) index[cell] = 0;
    SimulatedScan scan;
    std::uint32_t count = 0;
    for (std::size_t c = 0; c < index.size(); ++c) {
        if (index[c] < 0) continue;
        const int cell = static_cast<int>(c);
        index[c] = static_cast<int>(count++);
        const Kind kind = scene.kinds[grid.triangle[cell]];
        // Wet and dark surfaces and hair scan badly.
        double error = options.noise_mm * random.normal() *
                       (kind == kSkin   ? 1
                        : kind == kHair ? 2
                                        : 3);
        if (random.uniform() < options.spike_share)
            error += (random.bits() & 1 ? 1 : -1) * random.uniform(3, 25);
        const V3 p = to_scan(grid.point(cell) + error * grid.ray(cell));
        scan.mesh.vertices.insert(scan.mesh.vertices.end(), {p.x, p.y, p.z});
        const V3 color = blend(scene.colors, scene, grid, cell);
        const double flicker = 2.5 * random.normal();
        for (int k = 0; k < 3; ++k)
            scan.mesh.colors.push_back(
                static_cast<std::uint8_t>(clamp(color[k] + flicker, 0, 255)));
    }
    for (const auto& t : triangles)
        for (int cell : t) scan.mesh.triangles.push_back(static_cast<std::uint32_t>(index[cell]));

    const auto normals = normals_of(shape, a.head.triangles);
    for (int v = 0; v < a.count(); ++v) {
        const V3 p = to_scan(shape[v]), q = to_scan(neutral[v]);
        scan.truth.insert(scan.truth.end(), {p.x, p.y, p.z});
        scan.truth_neutral.insert(scan.truth_neutral.end(), {q.x, q.y, q.z});
        const V3 g = grid.to_grid(shape[v]);
        const int x = static_cast<int>(std::floor(g.x + 0.5)),
                  y = static_cast<int>(std::floor(g.y + 0.5));
        bool visible = false;
        if (x >= 0 && y >= 0 && x < grid.width && y < grid.height) {
            const int cell = y * grid.width + x;
            if (index[cell] >= 0) {
                const V3 n = grid.ray(cell);
                // Half a cell sideways, less than half a millimetre off the surface.
                visible = dot(normals[v], n) > 0.1 &&
                          std::fabs(dot(grid.point(cell) - shape[v], normals[v])) < 0.5;
            }
        }
        scan.visible.push_back(visible);
    }
    for (const auto& [name, vertex] : a.head.landmarks) {
        const V3 error{random.normal(), random.normal(), random.normal()};
        const V3 p = to_scan(shape[vertex]) + options.pick_mm * error;
        scan.landmarks.push_back({name, {p.x, p.y, p.z}});
    }
    for (int k = 0; k < 3; ++k) {
        V3 axis;
        axis[k] = 1;
        const V3 column = rotate(axis, pose_axis, angle);
        for (int row = 0; row < 3; ++row) scan.rotation[3 * row + k] = column[row];
        scan.translation[k] = shift[k];
    }
    return scan;
}

}  // namespace mien::demo
