// Loops over fixed chunks. Same bits for any thread count: chunk limits depend on the size alone
// and reductions combine chunk results in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/context.hpp"

namespace mien {

/// Calls body(begin, end) over [0, count) cut into chunks of chunk_size; cancellation is checked
/// before each chunk. body must write to places of its own range only.
template <typename Body>
void parallel_for(const Context& context, std::size_t count, std::size_t chunk_size, Body&& body) {
    const std::size_t num_chunks = (count + chunk_size - 1) / chunk_size;
    auto run_chunk = [&](std::size_t chunk) {
        context.check_cancelled();
        const std::size_t begin = chunk * chunk_size;
        body(begin, std::min(count, begin + chunk_size));
    };
    if (context.pool != nullptr)
        context.pool->run(num_chunks, run_chunk);
    else
        for (std::size_t chunk = 0; chunk < num_chunks; ++chunk) run_chunk(chunk);
}

/// Sums map(begin, end) over the chunks of [0, count) in chunk order, starting from `zero`.
template <typename T, typename Map>
T parallel_sum(const Context& context, std::size_t count, std::size_t chunk_size, T zero,
               Map&& map) {
    std::vector<T> parts((count + chunk_size - 1) / chunk_size, zero);
    parallel_for(context, count, chunk_size, [&](std::size_t begin, std::size_t end) {
        parts[begin / chunk_size] = map(begin, end);
    });
    T total = zero;
    for (const T& part : parts) total += part;
    return total;
}

}  // namespace mien
