#include "mesh/weld.hpp"

#include <algorithm>
#include <cstring>

namespace mien {
namespace {

std::uint64_t mixed(std::uint64_t x) {
    x ^= x >> 33;
    x *= 0xff51afd7ed558ccdULL;
    x ^= x >> 33;
    x *= 0xc4ceb9fe1a85ec53ULL;
    return x ^ (x >> 33);
}

std::uint64_t hash_of(const double* point) {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) {
        const double value = point[k] + 0.0;  // -0 becomes 0
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        hash = mixed(hash + bits + 0x9e3779b97f4a7c15ULL);
    }
    return hash;
}

}  // namespace

WeldedPoints weld_points(const PointsRef& points, const Context& context) {
    constexpr std::uint32_t kFree = 0xffffffffu;
    const std::size_t count = static_cast<std::size_t>(points.rows());
    std::size_t slots = 16;
    while (slots < 2 * count) slots *= 2;
    context.require_memory(8 * slots + 8 * count, "welding points");
    // Slots hold part of the hash beside the class: most strangers are told apart without a look
    // at their coordinates.
    struct Slot {
        std::uint32_t hash, number;
    };
    std::vector<Slot> table(slots, Slot{0, kFree});
    WeldedPoints welded;
    welded.class_of.resize(count);
    const auto put = [&](std::size_t i, std::uint64_t hash) {
        const auto point = points.row(static_cast<Index>(i));
        const std::uint32_t check = static_cast<std::uint32_t>(hash >> 32);
        for (std::size_t slot = static_cast<std::size_t>(hash) & (slots - 1);;
             slot = (slot + 1) & (slots - 1)) {
            Slot& entry = table[slot];
            if (entry.number == kFree) {
                entry = Slot{check, static_cast<std::uint32_t>(welded.first_point.size())};
                welded.first_point.push_back(static_cast<std::uint32_t>(i));
                welded.class_of[i] = entry.number;
                return;
            }
            if (entry.hash == check &&
                points.row(static_cast<Index>(welded.first_point[entry.number])) == point) {
                welded.class_of[i] = entry.number;
                return;
            }
        }
    };
    // The table is larger than the cache: slots are called for some points ahead.
    constexpr std::size_t kAhead = 32;
    std::uint64_t hashes[kAhead];
    for (std::size_t first = 0; first < count; first += kAhead) {
        if (first % (1 << 16) == 0) context.check_cancelled();
        const std::size_t last = std::min(count, first + kAhead);
        for (std::size_t i = first; i < last; ++i) {
            hashes[i - first] = hash_of(points.row(static_cast<Index>(i)).data());
            __builtin_prefetch(&table[static_cast<std::size_t>(hashes[i - first]) & (slots - 1)]);
        }
        for (std::size_t i = first; i < last; ++i) put(i, hashes[i - first]);
    }
    return welded;
}

}  // namespace mien
