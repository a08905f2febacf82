#include "spectral/flat_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <utility>

#include "base/scalar_math.hpp"

namespace mien {
namespace {

/// A vertex whose angles sum to 2 pi within this may be flat or on a straight crease, rad.
constexpr double kLargestDefect = 1e-2;
/// Of the largest coordinate: four units in the last place of a float.
constexpr double kStorageRounding = 0x1.0p-22;
constexpr int kMostPasses = 64;

class Reducer {
  public:
    explicit Reducer(const TriMesh& mesh)
        : vertices_(mesh.vertices),
          triangles_(mesh.triangles),
          alive_(static_cast<std::size_t>(mesh.triangles.rows()), 1),
          around_(static_cast<std::size_t>(mesh.vertices.rows())),
          gone_into_(static_cast<std::size_t>(mesh.vertices.rows())),
          fixed_(static_cast<std::size_t>(mesh.vertices.rows()), 0),
          tolerance_(kStorageRounding * mesh.vertices.cwiseAbs().maxCoeff()) {
        for (std::size_t v = 0; v < gone_into_.size(); ++v)
            gone_into_[v] = static_cast<std::uint32_t>(v);
        for (Index f = 0; f < triangles_.rows(); ++f)
            for (int c = 0; c < 3; ++c) {
                around_[triangles_(f, c)].push_back(static_cast<std::uint32_t>(f));
                if (triangles_(f, c) == triangles_(f, (c + 1) % 3) ||
                    triangles_(f, c) == triangles_(f, (c + 2) % 3))
                    fixed_[triangles_(f, 0)] = fixed_[triangles_(f, 1)] = fixed_[triangles_(f, 2)] =
                        1;
            }
    }

    void run(const Context& context) {
        for (int pass = 0; pass < kMostPasses; ++pass) {
            context.check_cancelled();
            bool changed = false;
            for (std::size_t v = 0; v < around_.size(); ++v)
                changed = try_vertex(static_cast<std::uint32_t>(v)) || changed;
            if (!changed) return;
        }
    }

    ReducedSurface result() const {
        ReducedSurface out;
        std::vector<std::uint32_t> number(around_.size(), 0);
        Index kept = 0;
        for (std::size_t v = 0; v < around_.size(); ++v)
            if (gone_into_[v] == v) number[v] = static_cast<std::uint32_t>(kept++);
        out.mesh.vertices.resize(kept, 3);
        for (std::size_t v = 0; v < around_.size(); ++v) {
            if (gone_into_[v] == v)
                out.mesh.vertices.row(number[v]) = vertices_.row(static_cast<Index>(v));
            std::uint32_t stands = static_cast<std::uint32_t>(v);
            while (gone_into_[stands] != stands) stands = gone_into_[stands];
            out.into.push_back(number[stands]);
        }
        out.mesh.triangles.resize(std::count(alive_.begin(), alive_.end(), 1), 3);
        Index row = 0;
        for (Index f = 0; f < triangles_.rows(); ++f) {
            if (!alive_[static_cast<std::size_t>(f)]) continue;
            for (int c = 0; c < 3; ++c) out.mesh.triangles(row, c) = number[triangles_(f, c)];
            ++row;
        }
        return out;
    }

  private:
    Vector3 at(std::uint32_t v) const { return vertices_.row(v); }
    /// The two other corners of a triangle of v, in its winding.
    std::pair<std::uint32_t, std::uint32_t> others(std::uint32_t f, std::uint32_t v) const {
        const int c = triangles_(f, 0) == v ? 0 : triangles_(f, 1) == v ? 1 : 2;
        return {triangles_(f, (c + 1) % 3), triangles_(f, (c + 2) % 3)};
    }

    /// The ring of a vertex with one fan of triangles, in order; `open` when it begins and ends at
    /// a border. Empty for any other vertex.
    std::vector<std::uint32_t> ring_of(std::uint32_t v, bool& open) const {
        const std::vector<std::uint32_t>& fan = around_[v];
        std::vector<std::uint32_t> ring;
        if (fan.empty()) return ring;
        const auto next_of = [&](std::uint32_t from, std::uint32_t& next) {
            int found = 0;
            for (const std::uint32_t f : fan) {
                const auto [a, b] = others(f, v);
                if (a == from) next = b, ++found;
            }
            return found;
        };
        // A border's first vertex is one that no triangle of the fan leads to.
        std::uint32_t first = others(fan.front(), v).first;
        open = false;
        for (const std::uint32_t f : fan) {
            const std::uint32_t a = others(f, v).first;
            const bool led_to = std::any_of(
                fan.begin(), fan.end(), [&](std::uint32_t g) { return others(g, v).second == a; });
            if (!led_to) first = a, open = true;
        }
        ring.push_back(first);
        for (std::size_t step = 0; step < fan.size(); ++step) {
            std::uint32_t next = 0;
            if (next_of(ring.back(), next) != 1) return {};
            if (next == first) return !open && step + 1 == fan.size() ? ring : Ring();
            ring.push_back(next);
        }
        return open && ring.size() == fan.size() + 1 ? ring : Ring();
    }
    using Ring = std::vector<std::uint32_t>;

    double angle_sum(std::uint32_t v) const {
        double sum = 0;
        for (const std::uint32_t f : around_[v]) {
            const auto [a, b] = others(f, v);
            const Vector3 u = at(a) - at(v), w = at(b) - at(v);
            sum += std::atan2(u.cross(w).norm(), u.dot(w));
        }
        return sum;
    }

    bool joined(std::uint32_t a, std::uint32_t b) const {
        return std::any_of(around_[a].begin(), around_[a].end(), [&](std::uint32_t f) {
            const auto [x, y] = others(f, a);
            return x == b || y == b;
        });
    }

    /// Vertices of the ring that p is joined with otherwise than as v's neighbour in the ring would
    /// give the surface a second edge between two vertices.
    bool keeps_topology(const Ring& ring, bool open, std::size_t p) const {
        const std::size_t n = ring.size();
        for (std::size_t k = 0; k < n; ++k) {
            const bool beside =
                open ? k + 1 == p || p + 1 == k : (k + 1) % n == p || (p + 1) % n == k;
            if (k != p && !beside && joined(ring[p], ring[k])) return false;
        }
        return n >= 3;
    }

    /// Whether each triangle of v keeps its plane and its side when v moves to ring[p].
    bool keeps_surface(std::uint32_t v, std::uint32_t target) const {
        for (const std::uint32_t f : around_[v]) {
            const auto [a, b] = others(f, v);
            if (a == target || b == target) continue;
            const Vector3 before = (at(a) - at(v)).cross(at(b) - at(v));
            const Vector3 side = at(b) - at(a), after = (at(a) - at(target)).cross(side);
            const double area = after.norm();
            // As thin as the tolerance, a triangle has no plane that could be compared.
            if (!(area > 64 * tolerance_ * std::max(side.norm(), (at(a) - at(target)).norm())))
                return false;
            if (!(after.dot(before) > 0)) return false;
            if (std::abs(after.dot(at(v) - at(a))) > tolerance_ * area) return false;
        }
        return true;
    }

    bool on_straight_border(std::uint32_t v, const Ring& ring) const {
        const Vector3 along = at(ring.back()) - at(ring.front());
        const double length = along.norm();
        return length > 0 && along.cross(at(v) - at(ring.front())).norm() <= tolerance_ * length;
    }

    bool try_vertex(std::uint32_t v) {
        if (around_[v].size() < 2 || fixed_[v]) return false;
        const double sum = angle_sum(v);
        if (std::abs(sum - 2 * kPi) > kLargestDefect && std::abs(sum - kPi) > kLargestDefect)
            return false;
        bool open = false;
        const Ring ring = ring_of(v, open);
        if (ring.size() < 3) return false;
        if (open && !on_straight_border(v, ring)) return false;
        for (std::size_t p = 0; p < ring.size(); ++p) {
            if (open && p != 0 && p + 1 != ring.size()) continue;
            if (!keeps_topology(ring, open, p) || !keeps_surface(v, ring[p])) continue;
            collapse(v, ring[p]);
            return true;
        }
        return false;
    }

    void collapse(std::uint32_t v, std::uint32_t target) {
        for (const std::uint32_t f : around_[v]) {
            const auto [a, b] = others(f, v);
            if (a == target || b == target) {
                alive_[f] = 0;
                for (const std::uint32_t corner : {a, b}) {
                    auto& list = around_[corner];
                    list.erase(std::find(list.begin(), list.end(), f));
                }
                continue;
            }
            for (int c = 0; c < 3; ++c)
                if (triangles_(f, c) == v) triangles_(f, c) = target;
            around_[target].push_back(f);
        }
        around_[v].clear();
        gone_into_[v] = target;
    }

    const Points& vertices_;
    Triangles triangles_;
    std::vector<char> alive_;
    std::vector<std::vector<std::uint32_t>> around_;
    std::vector<std::uint32_t> gone_into_;
    std::vector<char> fixed_;  ///< of a triangle that names a vertex twice
    double tolerance_;
};

}  // namespace

ReducedSurface without_flat_vertices(const TriMesh& mesh, const Context& context) {
    Reducer reducer(mesh);
    reducer.run(context);
    return reducer.result();
}

}  // namespace mien
