// Chance that depends on a seed and a place alone: number i of stream s is the same whatever was
// drawn before it, on however many threads.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/scalar_math.hpp"

namespace mien {

/// The finaliser of SplitMix64 (Steele, Lea and Flood, 2014): a bijection that scatters neighbours.
constexpr std::uint64_t scatter_bits(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

class CounterRandom {
  public:
    CounterRandom(std::uint64_t seed, std::uint64_t stream)
        : key_(scatter_bits(scatter_bits(seed) ^ (stream * 0xD1342543DE82EF95u + 1))) {}

    /// Uniform in (0, 1), never an end.
    double uniform(std::uint64_t i) const {
        const std::uint64_t bits = scatter_bits(key_ ^ scatter_bits(i));
        return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;
    }
    /// Standard normal (Box and Muller).
    double normal(std::uint64_t i) const {
        const double radius = std::sqrt(-2 * std::log(uniform(2 * i)));
        return radius * std::cos(2 * kPi * uniform(2 * i + 1));
    }

  private:
    std::uint64_t key_;
};

}  // namespace mien
