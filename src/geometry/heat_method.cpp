#include "geometry/heat_method.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/SparseCore>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/heat_solver.hpp"
#include "geometry/intrinsic_mesh.hpp"
#include "mesh/shortest_paths.hpp"

#if defined(__GNUC__) && defined(__x86_64__)
#define MIEN_HEAT_AVX2 1
#define MIEN_HEAT_INLINE static inline __attribute__((always_inline))
#else
#define MIEN_HEAT_INLINE static inline
#endif

namespace mien {
namespace {

constexpr int kW = BlockLdlt::kWidth;
/// Heat below this is too close to the smallest normal double to carry a direction.
constexpr double kFaint = 1e-290;
/// exp(-distance / sqrt(t)) stays above kFaint when distance / sqrt(t) is below this.
constexpr double kReach = 600;

/// What the gradient and divergence step needs of a triangle: corners in elimination order and the
/// gradients of the hat functions of corners 1 and 2 (the one of corner 0 is minus their sum), in
/// any frame of the triangle's plane, and its area times its weight.
struct Wedge {
    std::int32_t corner[3];
    double g1x, g1y, g2x, g2y, area;
};

/// X = -grad u / |grad u| per triangle, and its integrated divergence added to `right`.
MIEN_HEAT_INLINE void flow_block(const Wedge* wedges, std::size_t count,
                                 const double* __restrict heat, const double* __restrict far_heat,
                                 double* __restrict right, bool* faint) {
    double seen_faint = 0;
    for (std::size_t w = 0; w < count; ++w) {
        const Wedge& t = wedges[w];
        const double* __restrict u0 = heat + static_cast<std::ptrdiff_t>(t.corner[0]) * kW;
        const double* __restrict u1 = heat + static_cast<std::ptrdiff_t>(t.corner[1]) * kW;
        const double* __restrict u2 = heat + static_cast<std::ptrdiff_t>(t.corner[2]) * kW;
        double d1[kW], d2[kW], highest[kW];
        for (int c = 0; c < kW; ++c) {
            highest[c] = u0[c] > u1[c] ? u0[c] : u1[c];
            highest[c] = u2[c] > highest[c] ? u2[c] : highest[c];
            const double scale = highest[c] > kFaint ? 1 / highest[c] : 0.0;
            d1[c] = (u1[c] - u0[c]) * scale;
            d2[c] = (u2[c] - u0[c]) * scale;
        }
        if (far_heat != nullptr) {
            const double* f0 = far_heat + static_cast<std::ptrdiff_t>(t.corner[0]) * kW;
            const double* f1 = far_heat + static_cast<std::ptrdiff_t>(t.corner[1]) * kW;
            const double* f2 = far_heat + static_cast<std::ptrdiff_t>(t.corner[2]) * kW;
            for (int c = 0; c < kW; ++c) {
                if (highest[c] > kFaint) continue;
                const double most = std::max(f0[c], std::max(f1[c], f2[c]));
                if (!(most > kFaint)) continue;
                d1[c] = (f1[c] - f0[c]) / most;
                d2[c] = (f2[c] - f0[c]) / most;
            }
        }
        double b1[kW], b2[kW];
        for (int c = 0; c < kW; ++c) {
            seen_faint = highest[c] > kFaint ? seen_faint : 1.0;
            const double x = d1[c] * t.g1x + d2[c] * t.g2x;
            const double y = d1[c] * t.g1y + d2[c] * t.g2y;
            const double squared = x * x + y * y;
            const double step = squared > 0 ? -t.area / std::sqrt(squared) : 0.0;
            b1[c] = step * (x * t.g1x + y * t.g1y);
            b2[c] = step * (x * t.g2x + y * t.g2y);
        }
        double* __restrict r0 = right + static_cast<std::ptrdiff_t>(t.corner[0]) * kW;
        for (int c = 0; c < kW; ++c) r0[c] -= b1[c] + b2[c];
        double* __restrict r1 = right + static_cast<std::ptrdiff_t>(t.corner[1]) * kW;
        for (int c = 0; c < kW; ++c) r1[c] += b1[c];
        double* __restrict r2 = right + static_cast<std::ptrdiff_t>(t.corner[2]) * kW;
        for (int c = 0; c < kW; ++c) r2[c] += b2[c];
    }
    *faint = seen_faint != 0;
}

void flow_portable(const Wedge* wedges, std::size_t count, const double* heat,
                   const double* far_heat, double* right, bool* faint) {
    flow_block(wedges, count, heat, far_heat, right, faint);
}

#if defined(MIEN_HEAT_AVX2)
__attribute__((target("avx2"))) void flow_avx2(const Wedge* wedges, std::size_t count,
                                               const double* heat, const double* far_heat,
                                               double* right, bool* faint) {
    flow_block(wedges, count, heat, far_heat, right, faint);
}
#endif

void flow(const std::vector<Wedge>& wedges, const double* heat, const double* far_heat,
          double* right, bool* faint) {
#if defined(MIEN_HEAT_AVX2)
    static const bool avx2 = [] {
        __builtin_cpu_init();
        return __builtin_cpu_supports("avx2") != 0;
    }();
    if (avx2) return flow_avx2(wedges.data(), wedges.size(), heat, far_heat, right, faint);
#endif
    flow_portable(wedges.data(), wedges.size(), heat, far_heat, right, faint);
}

using Sparse = Eigen::SparseMatrix<double>;

/// Stiffness and lumped mass over vertices renumbered by `place`.
void assemble(const IntrinsicMesh& mesh, const std::vector<std::int32_t>& place, Sparse& stiffness,
              Vector& mass) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(12 * mesh.triangles.rows() + mesh.num_vertices));
    mass.setZero(mesh.num_vertices);
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const double third = mesh.weights[t] * mesh.double_area(t) / 6;
        for (int k = 0; k < 3; ++k) {
            const std::int32_t i = place[mesh.triangles(t, (k + 1) % 3)];
            const std::int32_t j = place[mesh.triangles(t, (k + 2) % 3)];
            mass[place[mesh.triangles(t, k)]] += third;
            if (i == j) continue;
            const double w = 0.5 * mesh.weights[t] * mesh.cotangent(t, k);
            entries.emplace_back(i, j, -w);
            entries.emplace_back(j, i, -w);
            entries.emplace_back(i, i, w);
            entries.emplace_back(j, j, w);
        }
    }
    for (Index v = 0; v < mesh.num_vertices; ++v)
        entries.emplace_back(static_cast<int>(v), static_cast<int>(v), 0.0);
    stiffness.resize(mesh.num_vertices, mesh.num_vertices);
    stiffness.setFromTriplets(entries.begin(), entries.end());
}

/// Largest distance along edges from the first vertex of each component: half of it bounds no
/// geodesic, twice of it bounds all of them.
double edge_eccentricity(const IntrinsicMesh& mesh) {
    const auto n = static_cast<std::size_t>(mesh.num_vertices);
    // Lengths are the intrinsic edges' own, and two vertices may have several edges.
    PathGraph graph;
    graph.begin.assign(n + 1, 0);
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) graph.begin[mesh.triangles(t, k) + 1] += 2;
    std::partial_sum(graph.begin.begin(), graph.begin.end(), graph.begin.begin());
    graph.edges.resize(graph.begin.back());
    std::vector<std::uint32_t> next(graph.begin.begin(), graph.begin.end() - 1);
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t i = mesh.triangles(t, (k + 1) % 3),
                                j = mesh.triangles(t, (k + 2) % 3);
            graph.edges[next[i]++] = {j, mesh.lengths(t, k)};
            graph.edges[next[j]++] = {i, mesh.lengths(t, k)};
        }
    std::vector<std::uint32_t> sources;
    std::vector<char> begun(static_cast<std::size_t>(mesh.num_components), 0);
    for (std::size_t v = 0; v < n; ++v)
        if (!begun[static_cast<std::size_t>(mesh.component[v])]) {
            begun[static_cast<std::size_t>(mesh.component[v])] = 1;
            sources.push_back(static_cast<std::uint32_t>(v));
        }
    std::vector<double> distance(n, std::numeric_limits<double>::infinity());
    double largest = 0;
    walk_paths(graph, sources, std::numeric_limits<double>::infinity(), distance,
               [&](const ReachedVertex& at) { largest = at.path; });
    return largest;
}

/// The triangles as the flow needs them, by elimination order `place`; those without area fall out.
std::vector<Wedge> make_wedges(const IntrinsicMesh& mesh, const std::vector<std::int32_t>& place) {
    std::vector<Wedge> wedges;
    wedges.reserve(static_cast<std::size_t>(mesh.triangles.rows()));
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        // Corner 0 at the origin, corner 1 on the x axis.
        const double to1 = mesh.lengths(t, 2), to2 = mesh.lengths(t, 1),
                     across = mesh.lengths(t, 0);
        const double doubled = mesh.double_area(t);
        if (!(doubled > 0)) continue;
        const double x2 = ((to2 - across) * (to2 + across) + to1 * to1) / (2 * to1);
        const double y2 = doubled / to1;
        Wedge w;
        for (int k = 0; k < 3; ++k) w.corner[k] = place[mesh.triangles(t, k)];
        w.g1x = y2 / doubled;
        w.g1y = -x2 / doubled;
        w.g2x = 0;
        w.g2y = to1 / doubled;
        w.area = 0.5 * doubled * mesh.weights[t];
        wedges.push_back(w);
    }
    return wedges;
}

/// M + t L; with `cold`, the vertices marked there (in elimination order) keep temperature zero:
/// they are cut off from the others.
Sparse heat_operator(const Sparse& stiffness, const Vector& mass, double t,
                     const std::vector<char>* cold) {
    Sparse matrix = t * stiffness;
    for (Index v = 0; v < mass.size(); ++v) matrix.coeffRef(v, v) += mass[v];
    if (cold != nullptr)
        for (Index j = 0; j < matrix.outerSize(); ++j)
            for (Sparse::InnerIterator it(matrix, j); it; ++it)
                if (it.row() != it.col() && ((*cold)[static_cast<std::size_t>(it.row())] ||
                                             (*cold)[static_cast<std::size_t>(it.col())]))
                    it.valueRef() = 0;
    return matrix;
}

}  // namespace

struct HeatGeodesics::State {
    HeatOptions options;
    Index num_vertices = 0;
    std::vector<int> component;
    int num_components = 0;
    std::vector<char> on_border;      ///< in elimination order
    std::vector<std::int32_t> place;  ///< elimination order of a vertex
    std::vector<Wedge> wedges;
    BlockLdlt neumann, dirichlet, neumann_far, dirichlet_far, poisson;
    bool has_border = false, needs_far = false;

    struct Scratch {
        std::vector<double> heat, other, far_heat, right;
    };

    void heat_of(const std::uint32_t* sources, int count, bool far, std::vector<double>& heat,
                 std::vector<double>& other) const;
    void block(const std::uint32_t* sources, int count, Scratch& scratch) const;
};

/// Heat of up to eight sources, each as the boundary condition asks.
void HeatGeodesics::State::heat_of(const std::uint32_t* sources, int count, bool far,
                                   std::vector<double>& heat, std::vector<double>& other) const {
    const auto size = static_cast<std::size_t>(num_vertices) * kW;
    const BlockLdlt& open = far ? neumann_far : neumann;
    const BlockLdlt& cold = far ? dirichlet_far : dirichlet;
    const auto start = [&](std::vector<double>& field) {
        field.assign(size, 0.0);
        for (int c = 0; c < count; ++c)
            field[static_cast<std::size_t>(place[sources[c]]) * kW + static_cast<std::size_t>(c)] =
                1;
    };
    start(heat);
    open.solve(heat.data());
    if (!has_border || options.boundary == HeatBoundary::neumann) return;
    start(other);
    cold.solve(other.data());
    const double keep = options.boundary == HeatBoundary::average ? 0.5 : 0.0;
    for (int c = 0; c < count; ++c) {
        // A source on the border would be cold itself; its heat stays the Neumann one.
        if (on_border[static_cast<std::size_t>(place[sources[c]])]) continue;
        for (std::size_t v = 0; v < static_cast<std::size_t>(num_vertices); ++v) {
            const std::size_t at = v * kW + static_cast<std::size_t>(c);
            const double cooled = on_border[v] ? 0.0 : other[at];
            heat[at] = keep * heat[at] + (1 - keep) * cooled;
        }
    }
}

void HeatGeodesics::State::block(const std::uint32_t* sources, int count, Scratch& scratch) const {
    const auto size = static_cast<std::size_t>(num_vertices) * kW;
    heat_of(sources, count, false, scratch.heat, scratch.other);
    scratch.right.assign(size, 0.0);
    bool faint = false;
    flow(wedges, scratch.heat.data(), nullptr, scratch.right.data(), &faint);
    if (faint && needs_far) {
        heat_of(sources, count, true, scratch.far_heat, scratch.other);
        scratch.right.assign(size, 0.0);
        flow(wedges, scratch.heat.data(), scratch.far_heat.data(), scratch.right.data(), &faint);
    }
    poisson.solve(scratch.right.data());
}

HeatGeodesics::HeatGeodesics(const PointsRef& vertices, const TrianglesRef& triangles,
                             const HeatOptions& options, const Context& context)
    : state_(std::make_unique<State>()) {
    if (!(options.time_factor >= 0.01 && options.time_factor <= 1e4))
        fail(Status::invalid_argument, "heat time factor %g is outside 0.01 .. 10000",
             options.time_factor);
    State& s = *state_;
    s.options = options;
    const IntrinsicMesh mesh = build_intrinsic_mesh(vertices, triangles);
    context.check_cancelled();
    s.num_vertices = mesh.num_vertices;
    s.component = mesh.component;
    s.num_components = mesh.num_components;

    Sparse stiffness;
    Vector mass;
    std::vector<std::int32_t> identity(static_cast<std::size_t>(mesh.num_vertices));
    for (std::size_t v = 0; v < identity.size(); ++v) identity[v] = static_cast<std::int32_t>(v);
    assemble(mesh, identity, stiffness, mass);
    s.place = elimination_order(stiffness);
    assemble(mesh, s.place, stiffness, mass);
    s.on_border.assign(static_cast<std::size_t>(mesh.num_vertices), 0);
    for (std::size_t v = 0; v < mesh.on_border.size(); ++v)
        if (mesh.on_border[v]) {
            s.on_border[static_cast<std::size_t>(s.place[v])] = 1;
            s.has_border = true;
        }

    s.wedges = make_wedges(mesh, s.place);
    // Vertices without triangles have no mass; any positive number keeps the matrix definite.
    const double h = mesh.mean_edge_mm > 0 ? mesh.mean_edge_mm : 1.0;
    for (Index v = 0; v < mass.size(); ++v)
        if (!(mass[v] > 0)) mass[v] = h * h;
    const double time = options.time_factor * h * h;
    const double reach = 2 * edge_eccentricity(mesh);
    s.needs_far = reach > kReach * std::sqrt(time);
    const bool cools = s.has_border && options.boundary != HeatBoundary::neumann;
    const auto heat_matrix = [&](double t, bool cold) {
        return heat_operator(stiffness, mass, t, cold ? &s.on_border : nullptr);
    };
    const double far_time = std::pow(reach / kReach, 2);
    s.neumann = BlockLdlt(heat_matrix(time, false), "heat");
    if (cools) s.dirichlet = BlockLdlt(heat_matrix(time, true), "heat");
    if (s.needs_far) {
        s.neumann_far = BlockLdlt(heat_matrix(far_time, false), "heat");
        if (cools) s.dirichlet_far = BlockLdlt(heat_matrix(far_time, true), "heat");
    }
    // Stiffness is singular once per component. Weight on one diagonal entry of each fixes the
    // value there at exactly zero, because the right-hand side of each component sums to zero.
    std::vector<char> pinned(static_cast<std::size_t>(mesh.num_components), 0);
    for (std::size_t v = 0; v < s.place.size(); ++v) {
        char& done = pinned[static_cast<std::size_t>(mesh.component[v])];
        if (done) continue;
        done = 1;
        const double diagonal = stiffness.coeff(s.place[v], s.place[v]);
        stiffness.coeffRef(s.place[v], s.place[v]) += diagonal > 0 ? diagonal : 1.0;
    }
    s.poisson = BlockLdlt(stiffness, "Poisson");
    context.check_cancelled();
}

HeatGeodesics::~HeatGeodesics() = default;
HeatGeodesics::HeatGeodesics(HeatGeodesics&&) noexcept = default;
HeatGeodesics& HeatGeodesics::operator=(HeatGeodesics&&) noexcept = default;

Index HeatGeodesics::num_vertices() const {
    return state_->num_vertices;
}

void HeatGeodesics::distances(const std::vector<std::uint32_t>& sources,
                              Eigen::Ref<Eigen::MatrixXf> out, const Context& context) const {
    const State& s = *state_;
    if (out.rows() != s.num_vertices || out.cols() != static_cast<Index>(sources.size()))
        fail(Status::internal, "distances from %zu sources need %lld x %zu numbers", sources.size(),
             static_cast<long long>(s.num_vertices), sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i)
        if (static_cast<Index>(sources[i]) >= s.num_vertices)
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(i),
                    "source %zu is vertex %lld of %lld", i, static_cast<long long>(sources[i]),
                    static_cast<long long>(s.num_vertices));
    parallel_for(context, sources.size(), kW, [&](std::size_t begin, std::size_t end) {
        State::Scratch scratch;
        s.block(&sources[begin], static_cast<int>(end - begin), scratch);
        const std::size_t count = end - begin;
        double at_source[kW] = {};
        int component[kW] = {};
        float* column[kW] = {};
        for (std::size_t c = 0; c < count; ++c) {
            const std::uint32_t source = sources[begin + c];
            at_source[c] = scratch.right[static_cast<std::size_t>(s.place[source]) * kW + c];
            component[c] = s.component[source];
            column[c] = out.col(static_cast<Index>(begin + c)).data();
        }
        for (std::size_t v = 0; v < s.place.size(); ++v) {
            const double* row = &scratch.right[static_cast<std::size_t>(s.place[v]) * kW];
            for (std::size_t c = 0; c < count; ++c)
                column[c][v] = s.component[v] == component[c]
                                   ? static_cast<float>(std::max(row[c] - at_source[c], 0.0))
                                   : std::numeric_limits<float>::infinity();
        }
    });
}

void make_symmetric(const std::vector<std::uint32_t>& sources,
                    Eigen::Ref<Eigen::MatrixXf> distances) {
    for (std::size_t i = 0; i < sources.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            float& there = distances(static_cast<Index>(sources[i]), static_cast<Index>(j));
            float& back = distances(static_cast<Index>(sources[j]), static_cast<Index>(i));
            there = back = 0.5f * (there + back);
        }
}

Vector HeatGeodesics::distances_from(std::uint32_t source) const {
    const State& s = *state_;
    if (static_cast<Index>(source) >= s.num_vertices)
        fail(Status::invalid_argument, "source vertex %lld of %lld", static_cast<long long>(source),
             static_cast<long long>(s.num_vertices));
    State::Scratch scratch;
    s.block(&source, 1, scratch);
    Vector out(s.num_vertices);
    const double at_source = scratch.right[static_cast<std::size_t>(s.place[source]) * kW];
    for (std::size_t v = 0; v < s.place.size(); ++v)
        out[static_cast<Index>(v)] =
            s.component[v] == s.component[source]
                ? std::max(scratch.right[static_cast<std::size_t>(s.place[v]) * kW] - at_source,
                           0.0)
                : std::numeric_limits<double>::infinity();
    return out;
}

}  // namespace mien
