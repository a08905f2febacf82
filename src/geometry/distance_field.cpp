#include "geometry/distance_field.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"

namespace mien {
namespace {

/// Fields that are held at once: enough to keep several threads busy, each with eight.
constexpr std::size_t kBlock = 64;

}  // namespace

Vector distance_field(const PointsRef& vertices, const TrianglesRef& triangles,
                      const std::vector<std::uint32_t>& sources, const HeatOptions& options,
                      const Context& context) {
    if (sources.empty())
        fail(Status::invalid_argument, "no source; give at least one vertex to measure from");
    for (std::size_t i = 0; i < sources.size(); ++i)
        if (static_cast<Index>(sources[i]) >= vertices.rows())
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(i),
                    "source %zu is vertex %lld of %lld", i, static_cast<long long>(sources[i]),
                    static_cast<long long>(vertices.rows()));
    const HeatGeodesics heat(vertices, triangles, options, context);
    if (sources.size() == 1) return heat.distances_from(sources.front());
    Vector nearest = Vector::Constant(vertices.rows(), std::numeric_limits<double>::infinity());
    for (std::size_t begin = 0; begin < sources.size(); begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, sources.size());
        const auto from = [&](std::size_t at) {
            return sources.begin() + static_cast<std::ptrdiff_t>(at);
        };
        Eigen::MatrixXf fields(vertices.rows(), static_cast<Index>(end - begin));
        heat.distances({from(begin), from(end)}, fields, context);
        nearest = nearest.cwiseMin(fields.rowwise().minCoeff().cast<double>());
        context.progress(Stage::geodesics,
                         static_cast<double>(end) / static_cast<double>(sources.size()));
    }
    return nearest;
}

}  // namespace mien
