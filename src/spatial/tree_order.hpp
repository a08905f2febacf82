// The order of primitives in a tree's leaves: cut at box medians again and again. Which order it is
// changes how long a search takes, and never its answer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/context.hpp"
#include "base/raw_vector.hpp"

namespace mien {

struct alignas(16) TreeItem {
    float centroid[3];
    std::uint32_t id;
};

/// Sorts the items into leaves of `leaf_size` (a power of two). The order follows from the items
/// alone, whatever the threads. O(N log N).
void order_for_tree(RawVector<TreeItem>& items, std::size_t leaf_size, const Context& context);

}  // namespace mien
