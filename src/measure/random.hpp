// A small generator with the same numbers on every platform and standard library.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/scalar_math.hpp"

namespace mien {

/// SplitMix64 (Steele, Lea & Flood 2014).
class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    /// 0 .. count - 1; the bias of the remainder is below count / 2^64.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
    double normal() {  // Box-Muller
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2 * kPi * uniform());
    }

  private:
    std::uint64_t state_;
};

}  // namespace mien
