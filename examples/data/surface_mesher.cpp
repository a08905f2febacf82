#include "surface_mesher.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace mien::demo {

void SurfaceMesher::march(V3 low, V3 high, double step) {
    const int nx = static_cast<int>((high.x - low.x) / step) + 1;
    const int ny = static_cast<int>((high.y - low.y) / step) + 1;
    const int nz = static_cast<int>((high.z - low.z) / step) + 1;
    const auto node = [&](int i, int j, int k) { return (k * ny + j) * nx + i; };
    const auto place = [&](int n) {
        return V3{low.x + step * (n % nx), low.y + step * (n / nx % ny),
                  low.z + step * (n / nx / ny)};
    };
    std::vector<double> value(static_cast<std::size_t>(nx) * ny * nz);
    // The field is nearly a distance with slope at most 2: where a coarse sample is far from zero,
    // its neighbours cannot cross it.
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx;) {
                const double v = surface_.value(place(node(i, j, k)));
                const int run = 1 + std::max(0, static_cast<int>(std::fabs(v) / (2 * step)) - 2);
                for (const int end = std::min(nx, i + run); i < end; ++i) value[node(i, j, k)] = v;
            }
    std::map<std::pair<int, int>, int> made;
    const auto crossing = [&](int a, int b) {
        if (a > b) std::swap(a, b);
        const auto [it, fresh] = made.insert({{a, b}, static_cast<int>(points.size())});
        if (fresh) {
            const double t = value[a] / (value[a] - value[b]);
            points.push_back(mix(place(a), place(b), clamp(t, 0.02, 0.98)));
        }
        return it->second;
    };
    // Six tetrahedra around the diagonal 0-7, each listed with positive orientation.
    static constexpr int kTets[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                        {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    for (int k = 0; k + 1 < nz; ++k)
        for (int j = 0; j + 1 < ny; ++j)
            for (int i = 0; i + 1 < nx; ++i)
                for (const auto& tet : kTets) {
                    int n[4], inside[4], outside[4], ni = 0, no = 0;
                    for (int c = 0; c < 4; ++c) {
                        n[c] = node(i + (tet[c] & 1), j + (tet[c] >> 1 & 1), k + (tet[c] >> 2));
                        if (value[n[c]] < 0)
                            inside[ni++] = n[c];
                        else
                            outside[no++] = n[c];
                    }
                    const auto add = [&](int a, int b, int c, V3 outward) {
                        const V3 normal = cross(points[b] - points[a], points[c] - points[a]);
                        if (dot(normal, outward) < 0) std::swap(b, c);
                        triangles.push_back({a, b, c});
                    };
                    if (ni == 0 || no == 0) continue;
                    const V3 outward = place(outside[0]) - place(inside[0]);
                    if (ni == 1)
                        add(crossing(inside[0], outside[0]), crossing(inside[0], outside[1]),
                            crossing(inside[0], outside[2]), outward);
                    else if (no == 1)
                        add(crossing(inside[0], outside[0]), crossing(inside[1], outside[0]),
                            crossing(inside[2], outside[0]), outward);
                    else {
                        const int a = crossing(inside[0], outside[0]),
                                  b = crossing(inside[0], outside[1]);
                        const int c = crossing(inside[1], outside[1]),
                                  d = crossing(inside[1], outside[0]);
                        add(a, b, c, outward);
                        add(a, c, d, outward);
                    }
                }
    flags.assign(points.size(), 0);
    build_fans();
}

void SurfaceMesher::build_fans() {
    fan_.assign(points.size(), {});
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (triangles[t][0] >= 0)
            for (int v : triangles[t]) fan_[v].push_back(static_cast<int>(t));
}

void SurfaceMesher::drop(int triangle) {
    for (int v : triangles[triangle]) {
        auto& fan = fan_[v];
        fan.erase(std::find(fan.begin(), fan.end(), triangle));
    }
    triangles[triangle] = {-1, -1, -1};
}

std::vector<SurfaceMesher::Edge> SurfaceMesher::edges() const {
    std::vector<Edge> all;
    for (const auto& t : triangles)
        if (t[0] >= 0)
            for (int k = 0; k < 3; ++k)
                all.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

int SurfaceMesher::edge_triangles(int a, int b, int out[2]) const {
    int count = 0;
    for (int t : fan_[a])
        for (int v : triangles[t])
            if (v == b && count < 2) out[count++] = t;
    return count;
}

bool SurfaceMesher::on_border(int vertex) const {
    int t[2];
    for (int n : neighbours(vertex))
        if (edge_triangles(vertex, n, t) == 1) return true;
    return false;
}

std::vector<int> SurfaceMesher::neighbours(int vertex) const {
    std::vector<int> ring;
    for (int t : fan_[vertex])
        for (int v : triangles[t])
            if (v != vertex && std::find(ring.begin(), ring.end(), v) == ring.end())
                ring.push_back(v);
    return ring;
}

void SurfaceMesher::flag_border(unsigned flag, const std::function<bool(V3)>& on_curve) {
    for (std::size_t v = 0; v < points.size(); ++v)
        if (!fan_[v].empty() && on_border(static_cast<int>(v)) && on_curve(points[v]))
            flags[v] |= flag;
}

int SurfaceMesher::split(int a, int b, V3 at) {
    int t[2];
    const int count = edge_triangles(a, b, t);
    const int m = static_cast<int>(points.size());
    points.push_back(at);
    flags.push_back(count == 1 ? flags[a] & flags[b] & ~kPinned : 0);
    fan_.emplace_back();
    for (int k = 0; k < count; ++k) {
        auto first = triangles[t[k]], second = first;
        for (int& v : first) v = v == b ? m : v;
        for (int& v : second) v = v == a ? m : v;
        drop(t[k]);
        triangles[t[k]] = first;
        for (int v : first) fan_[v].push_back(t[k]);
        for (int v : second) fan_[v].push_back(static_cast<int>(triangles.size()));
        triangles.push_back(second);
    }
    return m;
}

bool SurfaceMesher::collapse(int gone, int kept, double longest) {
    int t[2];
    const int count = edge_triangles(gone, kept, t);
    if (count == 0 || (flags[gone] & kPinned)) return false;
    if (flags[gone] != 0 && (count != 1 || (flags[gone] & ~flags[kept]) != 0)) return false;
    const auto ring = neighbours(gone), other = neighbours(kept);
    int common = 0;
    for (int v : ring) common += std::find(other.begin(), other.end(), v) != other.end();
    if (common != count) return false;
    for (int v : ring)
        if (v != kept && norm(points[v] - points[kept]) > longest) return false;
    for (int f : fan_[gone]) {
        const auto old = triangles[f];
        if (old[0] == kept || old[1] == kept || old[2] == kept) continue;
        V3 p[3], q[3];
        for (int k = 0; k < 3; ++k) {
            p[k] = points[old[k]];
            q[k] = points[old[k] == gone ? kept : old[k]];
        }
        const V3 n = cross(p[1] - p[0], p[2] - p[0]), m = cross(q[1] - q[0], q[2] - q[0]);
        if (dot(n, m) < 0.5 * norm(n) * norm(m) || norm(m) == 0) return false;
    }
    for (int k = 0; k < count; ++k) drop(t[k]);
    for (int f : fan_[gone]) {
        for (int& v : triangles[f]) v = v == gone ? kept : v;
        fan_[kept].push_back(f);
    }
    fan_[gone].clear();
    return true;
}

void SurfaceMesher::split_long() {
    std::vector<std::pair<double, Edge>> work;
    for (const Edge& e : edges()) {
        const double length = norm(points[e[0]] - points[e[1]]);
        const V3 middle = mix(points[e[0]], points[e[1]], 0.5);
        if (length > 4.0 / 3 * size_(middle)) work.push_back({-length, e});
    }
    std::sort(work.begin(), work.end());
    for (const auto& [length, e] : work) {
        int t[2];
        if (edge_triangles(e[0], e[1], t) > 0) {
            const int m = split(e[0], e[1], mix(points[e[0]], points[e[1]], 0.5));
            points[m] = project(points[m], flags[m], 2);
        }
    }
}

void SurfaceMesher::collapse_short() {
    std::vector<std::pair<double, Edge>> work;
    for (const Edge& e : edges()) {
        const double length = norm(points[e[0]] - points[e[1]]);
        const double size = size_(mix(points[e[0]], points[e[1]], 0.5));
        if (length < 0.8 * size) work.push_back({length / size, e});
    }
    std::sort(work.begin(), work.end());
    for (const auto& [ratio, e] : work) {
        if (fan_[e[0]].empty() || fan_[e[1]].empty()) continue;
        const double size = size_(mix(points[e[0]], points[e[1]], 0.5));
        // Flagged vertices stay; between equals the first goes.
        const bool first = flags[e[0]] == 0 || (flags[e[0]] & ~flags[e[1]]) == 0;
        // A very short edge has to go even when long ones come of it: those are split again.
        const double longest = (ratio < 0.45 ? 2.2 : 4.0 / 3) * size;
        if (!collapse(e[first ? 0 : 1], e[first ? 1 : 0], longest))
            collapse(e[first ? 1 : 0], e[first ? 0 : 1], longest);
    }
}

void SurfaceMesher::collapse_caps() {
    // A vertex that almost lies on a border edge cannot be helped by flips: the edge takes it in.
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (int k = 0; k < 3 && triangles[f][0] >= 0; ++k) {
            const int a = triangles[f][k], b = triangles[f][(k + 1) % 3],
                      w = triangles[f][(k + 2) % 3];
            int t[2];
            if (flags[w] != 0 || edge_triangles(a, b, t) != 1) continue;
            const V3 edge = points[b] - points[a];
            const double length = norm(edge);
            const double height = norm(cross(edge, points[w] - points[a])) / length;
            if (height > 0.4 * length) continue;
            const bool first = norm(points[w] - points[a]) < norm(points[w] - points[b]);
            if (!collapse(w, first ? a : b, 2.5 * length)) collapse(w, first ? b : a, 2.5 * length);
        }
}

void SurfaceMesher::flip(bool delaunay) {
    const auto cotangent = [&](int at, int a, int b) {
        const V3 u = points[a] - points[at], v = points[b] - points[at];
        return dot(u, v) / (norm(cross(u, v)) + 1e-12);
    };
    for (const Edge& e : edges()) {
        int t[2];
        if (edge_triangles(e[0], e[1], t) != 2) continue;
        int a = e[0], b = e[1], opposite[2] = {-1, -1};
        for (int k = 0; k < 2; ++k)
            for (int v : triangles[t[k]])
                if (v != a && v != b) opposite[k] = v;
        // Orient so that triangle 0 is (a, b, c).
        for (int k = 0; k < 3; ++k)
            if (triangles[t[0]][k] == b && triangles[t[0]][(k + 1) % 3] == a) std::swap(a, b);
        const int c = opposite[0], d = opposite[1];
        int unused[2];
        if (c == d || edge_triangles(c, d, unused) > 0) continue;
        if (delaunay) {
            if (cotangent(c, a, b) + cotangent(d, a, b) > -1e-9) continue;
        } else {
            const auto excess = [&](int v, int change) {
                const int ideal = border_[v] ? 4 : 6;
                const int valence = static_cast<int>(fan_[v].size()) + (border_[v] ? 1 : 0);
                return square(valence + change - ideal);
            };
            if (excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1) >=
                excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0))
                continue;
        }
        const auto normal = [&](int i, int j, int k) {
            return normalized(cross(points[j] - points[i], points[k] - points[i]));
        };
        const V3 n = normalized(normal(a, b, c) + normal(b, a, d));
        if (dot(normal(c, d, b), n) < 0.6 || dot(normal(d, c, a), n) < 0.6) continue;
        if (norm(points[c] - points[d]) > 1.6 * norm(points[a] - points[b])) continue;
        drop(t[0]);
        drop(t[1]);
        triangles[t[0]] = {c, d, b};
        triangles[t[1]] = {d, c, a};
        for (int k : t)
            for (int v : triangles[k]) fan_[v].push_back(k);
    }
}

void SurfaceMesher::relax() {
    // Weighting triangles by area evens out their sizes; the constant keeps a vertex off an edge
    // that it lies close to, where the area would let it rest.
    constexpr double kEven = 0.5;
    const auto old = points;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (fan_[v].empty() || (flags[v] & kPinned)) continue;
        V3 sum;
        double weights = 0;
        if (flags[v] == 0) {
            for (int f : fan_[v]) {
                const auto& t = triangles[f];
                const V3 centre = (old[t[0]] + old[t[1]] + old[t[2]]) / 3;
                const double area = norm(cross(old[t[1]] - old[t[0]], old[t[2]] - old[t[0]]));
                const double size = size_(centre), w = area / (size * size) + kEven;
                sum += w * centre;
                weights += w;
            }
        } else {
            int t[2];
            for (int n : neighbours(static_cast<int>(v)))
                if (edge_triangles(static_cast<int>(v), n, t) == 1 &&
                    ((flags[n] & flags[v]) != 0 || (flags[n] & kPinned))) {
                    const double w = norm(old[n] - old[v]) / size_(mix(old[n], old[v], 0.5));
                    sum += w * old[n];
                    weights += w;
                }
        }
        // Along a border, lengths as weights already overshoot by two: a longer step would swing.
        const double step = flags[v] == 0 ? 0.7 : 0.3;
        if (weights > 0) points[v] = project(mix(old[v], sum / weights, step), flags[v], 1);
    }
}

void SurfaceMesher::remesh(int rounds, bool delaunay) {
    build_fans();
    for (int round = 0; round < rounds; ++round) {
        split_long();
        collapse_short();
        collapse_caps();
        border_.assign(points.size(), 0);
        for (std::size_t v = 0; v < points.size(); ++v) border_[v] = on_border(static_cast<int>(v));
        flip(delaunay && round + 3 >= rounds);
        for (int k = 0; k < 2; ++k) relax();
    }
    if (delaunay)
        for (int k = 0; k < 4; ++k) {
            relax();
            flip(true);
        }
    compact();
}

V3 SurfaceMesher::project(V3 p, unsigned own, int steps) const {
    if (own & kPinned) return p;
    for (int step = 0; step < steps; ++step) {
        // Least-norm Newton step: orthogonalise the gradients, then satisfy one field after
        // another.
        V3 basis[4], move;
        double largest = 0;
        int count = 0;
        const auto satisfy = [&](const Constraint& c) {
            if (count == 3) return;
            const double value = c.value(p);
            V3 g = c.gradient(p);
            const V3 gradient = g;
            for (int k = 0; k < count; ++k) g -= dot(g, basis[k]) * basis[k];
            const double length = norm(g);
            if (length < 1e-9) return;
            basis[count] = g / length;
            const double rest = value + dot(gradient, move);
            const double stride = clamp(-rest / length, -3, 3);
            move += stride * basis[count];
            largest = std::max(largest, std::fabs(stride));
            ++count;
        };
        satisfy(surface_);
        for (std::size_t k = 0; k < curves_.size(); ++k)
            if (own & (1u << k)) satisfy(curves_[k]);
        p += move;
        if (largest < 1e-7) break;
    }
    return p;
}

void SurfaceMesher::project_all() {
    for (std::size_t v = 0; v < points.size(); ++v) points[v] = project(points[v], flags[v]);
}

int SurfaceMesher::nearest(V3 p) const {
    return nearest(p, ~0u);
}

int SurfaceMesher::nearest(V3 p, unsigned flag) const {
    int best = -1;
    double distance = 1e300;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (flag != ~0u && !(flags[v] & flag)) continue;
        const double d = norm(points[v] - p);
        if (d < distance) {
            distance = d;
            best = static_cast<int>(v);
        }
    }
    return best;
}

void SurfaceMesher::pin(int vertex, V3 position, unsigned own) {
    points[vertex] = position;
    flags[vertex] = own | kPinned;
}

void SurfaceMesher::insert_curve(unsigned flag, const std::function<double(V3)>& field,
                                 const std::function<bool(V3)>& where) {
    build_fans();
    std::vector<double> value(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) value[v] = field(points[v]);
    for (const Edge& e : edges()) {  // snap the nearer end of a crossed edge when it is very near
        const double a = value[e[0]], b = value[e[1]];
        if (a * b >= 0 || !where(points[e[0]]) || !where(points[e[1]])) continue;
        const double t = a / (a - b);
        for (int k = 0; k < 2; ++k) {
            const int v = e[k], other = e[1 - k];
            if ((k == 0 ? t : 1 - t) > 0.25 || (flags[v] & kPinned)) continue;
            if (flags[v] != 0 && flags[other] != flags[v]) continue;
            points[v] =
                project(mix(points[v], points[other], k == 0 ? t : 1 - t), flags[v] | flag, 4);
            value[v] = 0;
            break;
        }
    }
    for (const Edge& e : edges()) {
        const double a = value[e[0]], b = value[e[1]];
        if (a * b >= 0) continue;
        const V3 at = mix(points[e[0]], points[e[1]], a / (a - b));
        if (!where(at)) continue;
        const int m = split(e[0], e[1], at);
        points[m] = project(at, flags[m] | flag, 4);
        value.push_back(0);
    }
    for (std::size_t v = 0; v < points.size(); ++v)
        if (value[v] == 0 && !(flags[v] & kPinned) && where(points[v])) flags[v] |= flag;
}

void SurfaceMesher::remove_inside(unsigned flag, const std::function<bool(V3)>& inside) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (triangles[t][0] < 0) continue;
        bool all = true, any = false;
        for (int v : triangles[t]) {
            const bool in = inside(points[v]);
            all = all && (in || (flags[v] & flag));
            any = any || (in && !(flags[v] & flag));
        }
        if (all && !any) {  // three corners on the curve: the middle decides
            const auto& c = triangles[t];
            any = inside((points[c[0]] + points[c[1]] + points[c[2]]) / 3);
        }
        if (all && any) drop(static_cast<int>(t));
    }
    compact();
}

void SurfaceMesher::cut(unsigned flag, unsigned below, const std::function<double(V3)>& field,
                        int tip) {
    std::vector<int> copy(points.size(), -1);
    const std::size_t count = points.size();
    for (std::size_t v = 0; v < count; ++v) {
        if (!(flags[v] & flag) || static_cast<int>(v) == tip) continue;
        copy[v] = static_cast<int>(points.size());
        points.push_back(points[v]);
        flags.push_back((flags[v] & ~flag) | below);
    }
    for (auto& t : triangles) {
        if (t[0] < 0) continue;
        double side = 0;
        for (int v : t)
            if (static_cast<std::size_t>(v) < count && copy[v] < 0 && v != tip)
                side += field(points[v]);
        if (side < 0)
            for (int& v : t) v = copy[v] >= 0 ? copy[v] : v;
    }
    build_fans();
}

void SurfaceMesher::compact() {
    std::vector<int> renamed(points.size(), -1);
    std::vector<std::array<int, 3>> kept;
    for (const auto& t : triangles)
        if (t[0] >= 0) {
            kept.push_back(t);
            for (int v : t) renamed[v] = 0;
        }
    int next = 0;
    for (std::size_t v = 0; v < points.size(); ++v)
        if (renamed[v] == 0) {
            points[next] = points[v];
            flags[next] = flags[v];
            renamed[v] = next++;
        }
    points.resize(next);
    flags.resize(next);
    for (auto& t : kept)
        for (int& v : t) v = renamed[v];
    triangles = std::move(kept);
    build_fans();
}

}  // namespace mien::demo
