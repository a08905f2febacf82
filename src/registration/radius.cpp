#include "registration/radius.hpp"

#include <algorithm>

namespace mien {

Vector radius95_mm(const Vector& deviation_mm, const Verdict& verdict,
                   const std::vector<Zone>& zones, const RadiusSettings& settings) {
    const Index n = deviation_mm.size();
    // Expected errors and measures have the same order, the whole face first.
    const auto factor_of = [&](std::size_t k) {
        const double stated = verdict.zones[k].deviation_mm;
        const double factor =
            stated > 0 ? settings.of_expected * verdict.expected[k].expected_mm / stated : 1;
        return std::clamp(factor, settings.least_factor, settings.most_factor);
    };
    const std::size_t known = std::min(verdict.expected.size(), verdict.zones.size());
    Vector factor = Vector::Constant(n, known > 0 ? factor_of(0) : 1.0);
    std::vector<std::size_t> size_of_zone(static_cast<std::size_t>(n),
                                          static_cast<std::size_t>(n) + 1);
    for (std::size_t k = 1; k < known; ++k)
        for (const Zone& zone : zones) {
            if (zone.name != verdict.expected[k].zone) continue;
            for (const std::uint32_t v : zone.vertices) {
                if (static_cast<Index>(v) >= n || zone.vertices.size() >= size_of_zone[v]) continue;
                size_of_zone[v] = zone.vertices.size();
                factor[v] = factor_of(k);
            }
        }
    return settings.of_sigma * factor.cwiseProduct(deviation_mm);
}

}  // namespace mien
