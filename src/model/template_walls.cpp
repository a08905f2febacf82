#include "model/template_walls.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>

#include "base/parallel.hpp"
#include "geometry/normals.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

/// True when fewer than open_rays of the directions about the normal lead out.
bool is_enclosed(const TriangleTree& tree, const Vector3& place, const Vector3& normal,
                 const WallSettings& settings) {
    constexpr double kGolden_rad = 2.399963229728653;  // the golden angle: a sunflower's spiral
    const Vector3 side = normal.unitOrthogonal(), up = normal.cross(side);
    int open = 0;
    for (int k = 0; k < settings.rays; ++k) {
        const double squared = (k + 0.5) / settings.rays, turn = kGolden_rad * k;
        const double radius = std::sqrt(squared);
        const Vector3 direction = radius * (std::cos(turn) * side + std::sin(turn) * up) +
                                  std::sqrt(1 - squared) * normal;
        open += !tree.first_hit(place + settings.lift_mm * normal, direction, settings.sight_mm)
                     .valid();
    }
    return open < settings.open_rays;
}

// Eight bytes at a time into a hash: multiply and fold. It tells templates apart and guards against
// nothing else.
class Hash {
  public:
    template <typename T>
    void add(const T* values, std::size_t count) {
        const char* bytes = reinterpret_cast<const char*>(values);
        for (std::size_t left = count * sizeof(T); left > 0;) {
            std::uint64_t word = 0;
            const std::size_t taken = left < sizeof word ? left : sizeof word;
            std::memcpy(&word, bytes, taken);
            state_ = (state_ ^ word) * 0x9e3779b97f4a7c15u;
            state_ ^= state_ >> 32;
            bytes += taken;
            left -= taken;
        }
    }
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0x6d69656e;
};

}  // namespace

std::vector<std::uint8_t> find_walls(const TriMesh& mesh, const WallSettings& settings,
                                     const Context& context) {
    const Points& places = mesh.vertices;
    std::vector<std::uint8_t> walls(static_cast<std::size_t>(places.rows()), 0);
    const Points normals = vertex_normals(places, mesh.triangles),
                 faces = triangle_normals(places, mesh.triangles);
    const TriangleTree tree(places, mesh.triangles, context);
    parallel_for(context, walls.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Index v = static_cast<Index>(i);
            const Vector3 place = places.row(v).transpose(), normal = normals.row(v).transpose();
            for (const double radius : settings.probes_mm) {
                const SurfaceHit hit =
                    tree.closest(place + radius * normal, settings.touch * radius);
                if (!hit.valid()) continue;
                const Vector3 other = faces.row(static_cast<Index>(hit.triangle)).transpose();
                if (normal.dot(other) >= settings.facing * other.norm()) continue;
                walls[i] = is_enclosed(tree, place, normal, settings);
                break;
            }
        }
    });
    return walls;
}

std::string walls_key(const TriMesh& mesh, const WallSettings& settings) {
    constexpr std::uint64_t kRule = 1;  // of find_walls(): another number when it finds others
    Hash hash;
    hash.add(&kRule, 1);
    hash.add(settings.probes_mm.data(), settings.probes_mm.size());
    const double numbers[] = {settings.touch,
                              settings.facing,
                              static_cast<double>(settings.rays),
                              static_cast<double>(settings.open_rays),
                              settings.sight_mm,
                              settings.lift_mm};
    hash.add(numbers, sizeof numbers / sizeof numbers[0]);
    hash.add(mesh.vertices.data(), static_cast<std::size_t>(mesh.vertices.size()));
    hash.add(mesh.triangles.data(), static_cast<std::size_t>(mesh.triangles.size()));
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.value()));
    return text;
}

}  // namespace mien
