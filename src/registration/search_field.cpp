#include "registration/search_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien {
namespace {

// A cell's three numbers, 21 bits each: neighbours differ by fixed steps, whatever the signs.
constexpr std::int64_t kMiddle = std::int64_t(1) << 20, kMost = kMiddle - 8;

std::int64_t number_of(double value_mm, double cell_mm) {
    const double cell = std::floor(value_mm / cell_mm);
    const double most = static_cast<double>(kMost);
    return static_cast<std::int64_t>(std::min(std::max(cell, -most), most)) + kMiddle;
}

Vector3 middle_of(std::int64_t key, double cell_mm) {
    const auto part = [&](int shift) {
        return (static_cast<double>((key >> shift & 0x1fffff) - kMiddle) + 0.5) * cell_mm;
    };
    return Vector3(part(42), part(21), part(0));
}

std::vector<std::int64_t> steps_to_neighbours() {
    std::vector<std::int64_t> steps;
    for (std::int64_t a = -1; a <= 1; ++a)
        for (std::int64_t b = -1; b <= 1; ++b)
            for (std::int64_t c = -1; c <= 1; ++c)
                if (a != 0 || b != 0 || c != 0)
                    steps.push_back(a * (std::int64_t(1) << 42) + b * (std::int64_t(1) << 21) + c);
    return steps;
}

constexpr std::int32_t kUnknown = -1;

}  // namespace

std::int64_t SearchField::key_of(const Vector3& place) const {
    return number_of(place[0], cell_mm_) << 42 | number_of(place[1], cell_mm_) << 21 |
           number_of(place[2], cell_mm_);
}

SearchField::SearchField(const ScanView& scan, const std::vector<Index>& numbers,
                         const Matrix3& frame, const SearchFieldSettings& settings)
    : frame_(frame), cell_mm_(settings.cell_mm) {
    const Index count = static_cast<Index>(numbers.size());
    places_.resize(count, 3);
    normals_.resize(count, 3);
    for (Index k = 0; k < count; ++k) {
        const Index vertex = numbers[static_cast<std::size_t>(k)];
        places_.row(k) = scan.surface().vertices.row(vertex) * frame_;
        normals_.row(k) = scan.vertex_normal(vertex) * frame_;
    }
    const auto from_middle = [&](std::int32_t point, const Vector3& middle) {
        return (places_.row(point).transpose() - middle).squaredNorm();
    };
    std::vector<std::int64_t> front;
    for (Index k = 0; k < count; ++k) {
        const std::int64_t key = key_of(places_.row(k).transpose());
        const auto [cell, is_new] = nearest_.try_emplace(key, static_cast<std::int32_t>(k));
        if (is_new) {
            front.push_back(key);
            continue;
        }
        const Vector3 middle = middle_of(key, cell_mm_);
        if (from_middle(static_cast<std::int32_t>(k), middle) < from_middle(cell->second, middle))
            cell->second = static_cast<std::int32_t>(k);
    }
    // Layer by layer outwards: a cell takes over the nearest of what its neighbours further in
    // know.
    const std::vector<std::int64_t> steps = steps_to_neighbours();
    for (int layer = 0; layer < settings.layers; ++layer) {
        std::vector<std::int64_t> next;
        for (const std::int64_t key : front)
            for (const std::int64_t step : steps)
                if (nearest_.try_emplace(key + step, kUnknown).second) next.push_back(key + step);
        std::vector<std::int32_t> found(next.size(), kUnknown);
        for (std::size_t k = 0; k < next.size(); ++k) {
            const Vector3 middle = middle_of(next[k], cell_mm_);
            double least = std::numeric_limits<double>::infinity();
            for (const std::int64_t step : steps) {
                const auto cell = nearest_.find(next[k] + step);
                if (cell == nearest_.end() || cell->second == kUnknown) continue;
                const double distance = from_middle(cell->second, middle);
                if (distance < least) least = distance, found[k] = cell->second;
            }
        }
        for (std::size_t k = 0; k < next.size(); ++k) nearest_[next[k]] = found[k];
        front.swap(next);
    }
}

SearchField::Near SearchField::near(const Vector3& place) const {
    const auto cell = nearest_.find(key_of(place));
    if (cell == nearest_.end()) return {nullptr, nullptr};
    return {places_.row(cell->second).data(), normals_.row(cell->second).data()};
}

}  // namespace mien
