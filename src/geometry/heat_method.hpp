// Geodesic distances by the heat method (2.20)-(2.22): Crane, Weischedel and Wardetzky, "Geodesics
// in heat". One factorisation per mesh, many sources in blocks of eight.
//
// Departures: the surface is the intrinsic Delaunay two-sided cover of intrinsic_mesh.hpp, so no
// cotangent weight is negative and the heat stays positive whatever the triangles; gradients are
// taken of the heat divided by its largest value in the triangle, so that values of 1e-300 far from
// the source still give a direction; where even those underflow, a second heat flow with a longer
// time takes over; other components are infinitely far.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

/// What the heat does at borders. Neumann keeps it in (level lines meet the border at a right
/// angle), Dirichlet cools it to zero, average takes half of each and bends the least.
enum class HeatBoundary : std::int32_t { neumann = 1, dirichlet = 2, average = 3 };

struct HeatOptions {
    /// t = time_factor * (mean edge length)^2; 0.01 .. 10000. The usual factor of 1 leaves the heat
    /// close to counting edges; 4 halves the error on every sphere we tried (regular, spiral,
    /// random points) and makes the way there and back differ least on a head with open eyes and
    /// mouth.
    double time_factor = 4.0;
    HeatBoundary boundary = HeatBoundary::neumann;
};

/// Immutable after construction; distances() may be called from several threads.
class HeatGeodesics {
  public:
    /// Throws Status::invalid_mesh or invalid_argument. O(#V^1.5) time, about 60 numbers a vertex.
    HeatGeodesics(const PointsRef& vertices, const TrianglesRef& triangles,
                  const HeatOptions& options, const Context& context);
    ~HeatGeodesics();
    HeatGeodesics(HeatGeodesics&&) noexcept;
    HeatGeodesics& operator=(HeatGeodesics&&) noexcept;

    Index num_vertices() const;
    /// Column s of `out` (#V x sources, float) holds the distances from sources[s] in mm, infinity
    /// for other components. Not symmetric: the way there and back differ by the method's error,
    /// about one percent. Parallel over blocks of eight sources, same bits for any thread count.
    void distances(const std::vector<std::uint32_t>& sources, Eigen::Ref<Eigen::MatrixXf> out,
                   const Context& context) const;
    /// One source, double precision.
    Vector distances_from(std::uint32_t source) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Averages the way there and the way back between the sources of a #V x sources matrix, so that
/// distances(sources[i], j) == distances(sources[j], i).
void make_symmetric(const std::vector<std::uint32_t>& sources,
                    Eigen::Ref<Eigen::MatrixXf> distances);

}  // namespace mien
