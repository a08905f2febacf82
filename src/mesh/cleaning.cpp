#include "mesh/cleaning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "mesh/topology.hpp"
#include "mesh/weld.hpp"

namespace mien {
namespace {

constexpr std::size_t kChunk = 8192;  // vertices or triangles at a time

/// How many triangles do not stay, by cause.
struct NotKept {
    Index bad_index = 0, degenerate = 0;
    void operator+=(const NotKept& other) {
        bad_index += other.bad_index;
        degenerate += other.degenerate;
    }
};

/// For each input vertex the input vertex that stands for it, or kDropped.
std::vector<std::uint32_t> choose_representatives(const TriMesh& raw,
                                                  const CleaningOptions& options,
                                                  const Context& context, CleanedMesh& cleaned) {
    const std::size_t count = static_cast<std::size_t>(raw.vertices.rows());
    std::vector<std::uint32_t> representative(count);
    std::iota(representative.begin(), representative.end(), 0u);
    if (options.merge_equal_vertices) {
        const WeldedPoints welded = weld_points(raw.vertices, context);
        for (std::size_t v = 0; v < count; ++v)
            representative[v] = welded.first_point[welded.class_of[v]];
    }
    for (std::size_t v = 0; v < count; ++v)
        if (!raw.vertices.row(static_cast<Index>(v)).allFinite()) {
            representative[v] = kDropped;
            ++cleaned.num_not_finite;
        } else if (representative[v] != v) {
            ++cleaned.num_merged;
        }
    return representative;
}

/// No area beyond rounding: twice the area against the square of the longest side.
bool has_no_area(const Points& vertices, const std::array<std::uint32_t, 3>& corners) {
    const Vector3 a = vertices.row(static_cast<Index>(corners[0]));
    const Vector3 ab = vertices.row(static_cast<Index>(corners[1])).transpose() - a;
    const Vector3 ac = vertices.row(static_cast<Index>(corners[2])).transpose() - a;
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    // Divided first, so that huge and tiny coordinates neither overflow nor vanish.
    return !(longest > 0.0) || !((ab / longest).cross(ac / longest).norm() > 1e-12);
}

/// The triangles between the vertices that stand for theirs; those without any, or without area, do
/// not stay.
void join_corners(const TriMesh& raw, const CleaningOptions& options,
                  const std::vector<std::uint32_t>& representative, const Context& context,
                  std::vector<std::array<std::uint32_t, 3>>& corners,
                  std::vector<std::uint8_t>& stays, CleanedMesh& cleaned) {
    const auto join = [&](std::size_t t) {
        auto& triangle = corners[t];
        bool known = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex =
                raw.triangles(static_cast<Index>(t), static_cast<Index>(k));
            triangle[k] = vertex < representative.size() ? representative[vertex] : kDropped;
            known = known && triangle[k] != kDropped;
        }
        if (!known) return NotKept{1, 0};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
            triangle[0] == triangle[2] ||
            (options.drop_zero_area && has_no_area(raw.vertices, triangle)))
            return NotKept{0, 1};
        return NotKept{0, 0};
    };
    const NotKept not_kept = parallel_sum<NotKept>(
        context, corners.size(), kChunk, NotKept{}, [&](std::size_t begin, std::size_t end) {
            NotKept sum;
            for (std::size_t t = begin; t < end; ++t) {
                const NotKept one = join(t);
                stays[t] = one.bad_index == 0 && one.degenerate == 0;
                sum += one;
            }
            return sum;
        });
    cleaned.num_bad_index += not_kept.bad_index;
    cleaned.num_degenerate += not_kept.degenerate;
}

/// Marks all but the first of triangles with equal vertex sets.
void drop_duplicates(const std::vector<std::array<std::uint32_t, 3>>& corners,
                     std::vector<std::uint8_t>& stays, std::size_t num_vertices,
                     const Context& context, CleanedMesh& cleaned) {
    auto sorted = [](std::array<std::uint32_t, 3> triangle) {
        std::sort(triangle.begin(), triangle.end());
        return triangle;
    };
    // Buckets by lowest vertex keep every sort small.
    std::vector<std::uint32_t> start(num_vertices + 1, 0);
    for (std::size_t t = 0; t < corners.size(); ++t)
        if (stays[t]) ++start[sorted(corners[t])[0] + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    struct Entry {
        std::uint32_t middle, high, triangle;
    };
    std::vector<Entry> entries(start.back());
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (std::size_t t = 0; t < corners.size(); ++t) {
        if (!stays[t]) continue;
        const auto key = sorted(corners[t]);
        entries[fill[key[0]]++] = {key[1], key[2], static_cast<std::uint32_t>(t)};
    }
    const auto drop_within = [&](std::size_t v) {
        Index dropped = 0;
        const auto begin = entries.begin() + start[v], end = entries.begin() + start[v + 1];
        std::sort(begin, end, [](const Entry& a, const Entry& b) {
            if (a.middle != b.middle) return a.middle < b.middle;
            return a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
        });
        for (auto entry = begin; entry != end; ++entry)
            if (entry != begin && entry->middle == (entry - 1)->middle &&
                entry->high == (entry - 1)->high) {
                stays[entry->triangle] = 0;
                ++dropped;
            }
        return dropped;
    };
    cleaned.num_duplicate += parallel_sum<Index>(context, num_vertices, kChunk, 0,
                                                 [&](std::size_t first, std::size_t last) {
                                                     Index dropped = 0;
                                                     for (std::size_t v = first; v < last; ++v)
                                                         dropped += drop_within(v);
                                                     return dropped;
                                                 });
}

void drop_small_components(const std::vector<std::array<std::uint32_t, 3>>& corners,
                           std::vector<std::uint8_t>& stays, std::size_t num_vertices, Index least,
                           CleanedMesh& cleaned) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t t = 0; t < corners.size(); ++t)
        if (stays[t]) numbers.push_back(static_cast<std::uint32_t>(t));
    Triangles triangles(static_cast<Index>(numbers.size()), 3);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (int k = 0; k < 3; ++k)
            triangles(static_cast<Index>(i), k) = corners[numbers[i]][static_cast<std::size_t>(k)];
    const ConnectedComponents parts =
        connected_components(triangles, static_cast<Index>(num_vertices));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (parts.num_triangles[parts.of_triangle[i]] < least) {
            stays[numbers[i]] = 0;
            ++cleaned.num_small_component;
        }
}

void gather(const TriMesh& raw, const std::vector<std::array<std::uint32_t, 3>>& corners,
            const Context& context, CleanedMesh& cleaned) {
    const Index num_vertices = static_cast<Index>(cleaned.vertex_to_old.size());
    const Index num_triangles = static_cast<Index>(cleaned.triangle_to_old.size());
    const bool colors = raw.colors.rows() == raw.vertices.rows();
    const bool texture = raw.texture_triangles.rows() == raw.triangles.rows() &&
                         raw.texture.rows() != 0 && raw.texture_triangles.size() != 0 &&
                         static_cast<Index>(raw.texture_triangles.maxCoeff()) < raw.texture.rows();
    TriMesh& mesh = cleaned.mesh;
    mesh.vertices.resize(num_vertices, 3);
    if (colors) mesh.colors.resize(num_vertices, 3);
    const auto take_vertices = [&](std::size_t first, std::size_t last) {
        for (Index v = static_cast<Index>(first); v < static_cast<Index>(last); ++v) {
            const Index old =
                static_cast<Index>(cleaned.vertex_to_old[static_cast<std::size_t>(v)]);
            mesh.vertices.row(v) = raw.vertices.row(old);
            if (colors) mesh.colors.row(v) = raw.colors.row(old);
        }
    };
    parallel_for(context, cleaned.vertex_to_old.size(), kChunk, take_vertices);
    mesh.triangles.resize(num_triangles, 3);
    if (texture) {
        mesh.texture = raw.texture;
        mesh.texture_triangles.resize(num_triangles, 3);
    }
    const std::vector<std::uint32_t>& numbers = raw.triangle_materials;
    const bool materials = !numbers.empty() &&
                           numbers.size() == static_cast<std::size_t>(raw.triangles.rows()) &&
                           *std::max_element(numbers.begin(), numbers.end()) < raw.materials.size();
    if (materials || numbers.empty()) {
        mesh.materials = raw.materials;
        mesh.images = raw.images;
    }
    if (materials) mesh.triangle_materials.resize(static_cast<std::size_t>(num_triangles));
    const auto take_triangles = [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Index t = static_cast<Index>(i);
            const std::size_t old = cleaned.triangle_to_old[i];
            for (std::size_t k = 0; k < 3; ++k)
                mesh.triangles(t, static_cast<Index>(k)) = cleaned.vertex_to_new[corners[old][k]];
            if (materials) mesh.triangle_materials[i] = raw.triangle_materials[old];
            if (texture)
                mesh.texture_triangles.row(t) = raw.texture_triangles.row(static_cast<Index>(old));
        }
    };
    parallel_for(context, cleaned.triangle_to_old.size(), kChunk, take_triangles);
}

}  // namespace

CleanedMesh clean_mesh(const TriMesh& raw, const CleaningOptions& options, const Context& context) {
    constexpr Index kMost = std::numeric_limits<std::int32_t>::max();
    if (raw.vertices.rows() > kMost || raw.triangles.rows() > kMost)
        fail(Status::invalid_mesh, "the mesh has more than 2^31 - 1 vertices or triangles");
    const std::size_t num_vertices = static_cast<std::size_t>(raw.vertices.rows());
    const std::size_t num_triangles = static_cast<std::size_t>(raw.triangles.rows());
    // Besides what welding asks for itself: the corners as they are joined, numbers, the new mesh.
    context.require_memory(40 * num_vertices + (raw.texture.rows() > 0 ? 48 : 36) * num_triangles,
                           "cleaning a mesh");
    CleanedMesh cleaned;
    const std::vector<std::uint32_t> representative =
        choose_representatives(raw, options, context, cleaned);

    std::vector<std::array<std::uint32_t, 3>> corners(num_triangles);
    std::vector<std::uint8_t> stays(num_triangles, 1);
    join_corners(raw, options, representative, context, corners, stays, cleaned);
    context.check_cancelled();
    if (options.drop_duplicate_triangles)
        drop_duplicates(corners, stays, num_vertices, context, cleaned);
    context.check_cancelled();
    if (options.min_component_triangles > 1)
        drop_small_components(corners, stays, num_vertices, options.min_component_triangles,
                              cleaned);

    std::vector<std::uint8_t> used(num_vertices, 0);
    cleaned.triangle_to_new.assign(num_triangles, kDropped);
    for (std::size_t t = 0; t < num_triangles; ++t) {
        if (!stays[t]) continue;
        cleaned.triangle_to_new[t] = static_cast<std::uint32_t>(cleaned.triangle_to_old.size());
        cleaned.triangle_to_old.push_back(static_cast<std::uint32_t>(t));
        for (std::uint32_t vertex : corners[t]) used[vertex] = 1;
    }
    const bool keep_unused = num_triangles == 0 || !options.drop_unused_vertices;
    cleaned.vertex_to_new.assign(num_vertices, kDropped);
    for (std::size_t v = 0; v < num_vertices; ++v) {
        if (representative[v] == v) {
            if (!used[v] && !keep_unused) {
                ++cleaned.num_unused;
                continue;
            }
            cleaned.vertex_to_new[v] = static_cast<std::uint32_t>(cleaned.vertex_to_old.size());
            cleaned.vertex_to_old.push_back(static_cast<std::uint32_t>(v));
        } else if (representative[v] != kDropped) {
            // The first of equal vertices has the lowest number, so its own is known by now.
            cleaned.vertex_to_new[v] = cleaned.vertex_to_new[representative[v]];
        }
    }
    if (cleaned.vertex_to_old.empty() || (num_triangles != 0 && cleaned.triangle_to_old.empty()))
        fail(Status::invalid_mesh,
             "nothing is left of the mesh: of %zu vertices %lld are not finite, of %zu triangles "
             "%lld are degenerate",
             num_vertices, static_cast<long long>(cleaned.num_not_finite), num_triangles,
             static_cast<long long>(cleaned.num_degenerate));
    gather(raw, corners, context, cleaned);
    return cleaned;
}

}  // namespace mien
