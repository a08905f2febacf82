#include "measure/lengths.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "geometry/heat_method.hpp"
#include "measure/pair_check.hpp"

namespace mien {

std::vector<PlaceLength> measure_lengths(const PointsRef& vertices, const TrianglesRef& triangles,
                                         const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                         const Context& context) {
    check_surface(vertices, triangles, "the surface");
    std::vector<std::uint32_t> places;
    for (std::size_t k = 0; k < pairs.size(); ++k)
        for (const std::uint32_t place : pairs[k]) {
            if (place >= static_cast<std::uint64_t>(vertices.rows()))
                fail_at(Status::mismatch, static_cast<std::int64_t>(k),
                        "pair %zu names vertex %u of %lld", k, place,
                        static_cast<long long>(vertices.rows()));
            places.push_back(place);
        }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<PlaceLength> lengths(pairs.size());
    if (pairs.empty()) return lengths;
    context.require_memory(
        static_cast<std::size_t>(vertices.rows()) * places.size() * sizeof(float),
        "geodesic distances");
    const HeatGeodesics geodesics(vertices, triangles, HeatOptions(), context);
    Eigen::MatrixXf distances(vertices.rows(), static_cast<Index>(places.size()));
    geodesics.distances(places, distances, context);
    make_symmetric(places, distances);
    const auto column_of = [&](std::uint32_t place) {
        return static_cast<Index>(std::lower_bound(places.begin(), places.end(), place) -
                                  places.begin());
    };
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto [from, to] = pairs[k];
        lengths[k].straight_mm = (vertices.row(from) - vertices.row(to)).norm();
        const double along = from == to ? 0.0 : static_cast<double>(distances(to, column_of(from)));
        // The method's error must not make a way along the surface shorter than the straight one.
        lengths[k].geodesic_mm = std::max(along, lengths[k].straight_mm);
    }
    return lengths;
}

}  // namespace mien
