#include "registration/gross_pins.hpp"

#include <algorithm>
#include <cmath>

#include "registration/evidence.hpp"

namespace mien {
namespace {

// Do two landmarks stand where only one can: a placeholder, which its neighbours share?
bool stand_together(const Pin& a, const Pin& b, double rest_mm, double together) {
    return (a.place - b.place).norm() < together * rest_mm;
}

}  // namespace

std::vector<std::size_t> far_pins(const std::vector<Pin>& pins, const Vector3& low,
                                  const Vector3& high, const GrossPinSettings& settings) {
    std::vector<std::size_t> far;
    if (!settings.enabled) return far;
    const Vector3 middle = (low + high) / 2;
    const double limit_mm = settings.far * (high - low).norm() / 2;
    for (std::size_t k = 0; k < pins.size(); ++k)
        if (!((pins[k].place - middle).norm() <= limit_mm)) far.push_back(k);
    if (static_cast<double>(far.size()) > settings.most * static_cast<double>(pins.size()))
        far.clear();
    return far;
}

std::vector<std::size_t> gross_pins(const DeformationModel& model, const std::vector<Pin>& pins,
                                    const Similarity& motion, const GrossPinSettings& settings) {
    std::vector<std::size_t> gross;
    if (!settings.enabled || pins.size() < settings.fewest) return gross;
    std::vector<Vector3> rest, moved;
    for (const Pin& pin : pins) {
        rest.push_back(rest_place(model, pin.vertex));
        moved.push_back(pin.place - motion.apply(rest.back()));
    }
    for (std::size_t k = 0; k < pins.size(); ++k) {
        // At its own place within the limit, whatever the others do.
        if (moved[k].norm() < settings.apart_mm) continue;
        std::vector<std::pair<double, std::size_t>> near;
        for (std::size_t j = 0; j < pins.size(); ++j)
            if (j != k) near.push_back({(rest[j] - rest[k]).squaredNorm(), j});
        const std::size_t count = std::min(settings.neighbours, near.size());
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count),
                          near.end());
        bool alone = true;
        for (std::size_t i = 0; i < count; ++i) {
            const auto [squared_mm2, j] = near[i];
            alone = alone &&
                    ((moved[j] - moved[k]).norm() > settings.apart_mm ||
                     stand_together(pins[j], pins[k], std::sqrt(squared_mm2), settings.together));
        }
        if (alone) gross.push_back(k);
    }
    if (static_cast<double>(gross.size()) > settings.most * static_cast<double>(pins.size()))
        gross.clear();
    return gross;
}

}  // namespace mien
