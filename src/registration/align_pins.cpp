#include "registration/align_pins.hpp"

#include <algorithm>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/median.hpp"
#include "geometry/alignment.hpp"
#include "registration/evidence.hpp"

namespace mien {
namespace {

// Pinned places at rest and where they should be, row by row.
struct PinPairs {
    Points from, to;

    std::vector<double> distances(const Similarity& motion) const {
        std::vector<double> d(static_cast<std::size_t>(from.rows()));
        for (Index k = 0; k < from.rows(); ++k)
            d[static_cast<std::size_t>(k)] =
                (motion.apply(Vector3(from.row(k))) - to.row(k).transpose()).norm();
        return d;
    }
};

// False when the three lie nearly on a line.
bool align_three(const PinPairs& pairs, const Index (&pick)[3], double least_area_mm2,
                 Similarity& motion) {
    Points a(3, 3), b(3, 3);
    for (int k = 0; k < 3; ++k)
        a.row(k) = pairs.from.row(pick[k]), b.row(k) = pairs.to.row(pick[k]);
    if ((Vector3(a.row(1) - a.row(0)).cross(Vector3(a.row(2) - a.row(0)))).norm() < least_area_mm2)
        return false;
    try {
        motion = align_points(a, b, Vector(), false);
    } catch (const Error& error) {
        if (error.status() != Status::no_solution) throw;
        return false;  // their places on the scan lie on a line
    }
    return true;
}

}  // namespace

Similarity align_pins(const DeformationModel& model, const std::vector<Pin>& pins, bool with_scale,
                      const PinAlignmentSettings& settings) {
    const Index n = static_cast<Index>(pins.size());
    PinPairs pairs{Points(n, 3), Points(n, 3)};
    for (Index k = 0; k < n; ++k) {
        pairs.from.row(k) = rest_place(model, pins[static_cast<std::size_t>(k)].vertex).transpose();
        pairs.to.row(k) = pins[static_cast<std::size_t>(k)].place.transpose();
    }
    Similarity best = align_points(pairs.from, pairs.to, Vector(), with_scale);
    if (n < settings.fewest_for_trials) return best;
    double best_median = median(pairs.distances(best));
    // Fixed samples (Numerical Recipes' linear congruential generator); size is taken from the
    // whole.
    std::uint32_t state = settings.seed;
    const auto next = [&]() {
        state = state * 1664525u + 1013904223u;
        return static_cast<Index>((state >> 8) % static_cast<std::uint32_t>(n));
    };
    for (int trial = 0; trial < settings.trials; ++trial) {
        const Index pick[3] = {next(), next(), next()};
        if (pick[0] == pick[1] || pick[1] == pick[2] || pick[0] == pick[2]) continue;
        Similarity motion;
        if (!align_three(pairs, pick, settings.least_area_mm2, motion)) continue;
        const double m = median(pairs.distances(motion));
        if (m < settings.clearly * best_median) best = motion, best_median = m;
    }
    for (int round = 0; round < settings.rounds; ++round) {
        const std::vector<double> d = pairs.distances(best);
        const double scale = std::max(settings.least_scale_mm, settings.scale_medians * median(d));
        Vector weights(n);
        for (Index k = 0; k < n; ++k) {
            const double x = d[static_cast<std::size_t>(k)] / scale;
            weights[k] = 1 / (1 + x * x);
        }
        best = align_points(pairs.from, pairs.to, weights, with_scale);
    }
    return best;
}

}  // namespace mien
