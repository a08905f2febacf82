// Small vectors, elementary functions and random numbers whose bits do not depend on the platform.
// The C library's exp or cos may differ in the last bit from one system to the next; a template
// whose connectivity hangs on comparisons must not. So only + - * / and sqrt are used, which
// IEEE 754 rounds in one way. Not a general-purpose library: arguments are moderate and finite.
#pragma once

#include <cmath>
#include <cstdint>

namespace mien::demo {

struct V3 {
    double x = 0, y = 0, z = 0;
    double& operator[](int k) { return k == 0 ? x : k == 1 ? y : z; }
    double operator[](int k) const { return k == 0 ? x : k == 1 ? y : z; }
};
inline V3 operator+(V3 a, V3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline V3 operator-(V3 a, V3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline V3 operator-(V3 a) {
    return {-a.x, -a.y, -a.z};
}
inline V3 operator*(double s, V3 a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline V3 operator*(V3 a, double s) {
    return s * a;
}
inline V3 operator/(V3 a, double s) {
    return {a.x / s, a.y / s, a.z / s};
}
inline V3& operator+=(V3& a, V3 b) {
    return a = a + b;
}
inline V3& operator-=(V3& a, V3 b) {
    return a = a - b;
}
inline double dot(V3 a, V3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline V3 cross(V3 a, V3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(V3 a) {
    return std::sqrt(dot(a, a));
}
inline V3 normalized(V3 a) {
    const double n = norm(a);
    return n > 0 ? a / n : a;
}
inline V3 mix(V3 a, V3 b, double t) {
    return a + t * (b - a);
}

inline double clamp(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
}
inline double mix(double a, double b, double t) {
    return a + t * (b - a);
}
inline double square(double x) {
    return x * x;
}
/// 0 below `low`, 1 above `high`, with continuous slope (low > high turns it round).
inline double ramp(double low, double high, double x) {
    const double t = clamp((x - low) / (high - low), 0, 1);
    return t * t * (3 - 2 * t);
}

inline constexpr double kPi = 3.14159265358979323846;

/// e^x: argument halved until small, Taylor series, squared back.
inline double exp_of(double x) {
    if (x < -700) return 0;
    int halvings = 0;
    while (x > 0.25 || x < -0.25) {
        x *= 0.5;
        ++halvings;
    }
    double sum = 1, term = 1;
    for (int k = 1; k < 14; ++k) {
        term *= x / k;
        sum += term;
    }
    while (halvings-- > 0) sum *= sum;
    return sum;
}
/// exp(-d2) for the many bumps of the sculpture; zero where it would be below 1e-6.
inline double bump(double d2) {
    return d2 > 14 ? 0 : exp_of(-d2);
}

/// Natural logarithm of x > 0: powers of two split off, atanh series.
inline double log_of(double x) {
    int power = 0;
    while (x > 1.5) {
        x *= 0.5;
        ++power;
    }
    while (x < 0.75) {
        x *= 2;
        --power;
    }
    const double y = (x - 1) / (x + 1), y2 = y * y;
    double sum = 0, term = y;
    for (int k = 1; k < 34; k += 2) {
        sum += term / k;
        term *= y2;
    }
    return 2 * sum + power * 0.69314718055994530942;
}

inline double sin_of(double x) {
    const double turns = x / (2 * kPi);
    x -= 2 * kPi * std::floor(turns + 0.5);
    if (x > kPi / 2) x = kPi - x;
    if (x < -kPi / 2) x = -kPi - x;
    double sum = x, term = x;
    for (int k = 2; k < 22; k += 2) {
        term *= -x * x / (k * (k + 1));
        sum += term;
    }
    return sum;
}
inline double cos_of(double x) {
    return sin_of(x + kPi / 2);
}

/// Angle of (x, y), -pi..pi, by Newton steps on the sine; good to 1e-12.
inline double atan2_of(double y, double x) {
    const double r = std::sqrt(x * x + y * y);
    if (r == 0) return 0;
    const double c = x / r, s = y / r;
    double angle = s * (1 + 0.2 * s * s);
    if (c < 0) angle = (s < 0 ? -kPi : kPi) - angle;
    for (int k = 0; k < 6; ++k) angle += s * cos_of(angle) - c * sin_of(angle);
    return angle;
}

/// x turned about `axis` (unit length) through `angle`, right-handed (Rodrigues).
inline V3 rotate(V3 x, V3 axis, double angle) {
    const double c = cos_of(angle), s = sin_of(angle);
    return c * x + s * cross(axis, x) + ((1 - c) * dot(axis, x)) * axis;
}

/// Counter-based random numbers (splitmix64): value k of a stream is a pure function of
/// (seed, stream, k), so a person can be made again without making the others.
class Random {
  public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
        : state_(scramble(seed * 0x9E3779B97F4A7C15ull + 1) ^
                 scramble(stream + 0x5851F42D4C957F2Dull)) {}

    std::uint64_t bits() { return scramble(state_ += 0x9E3779B97F4A7C15ull); }
    /// In [0, 1).
    double uniform() { return static_cast<double>(bits() >> 11) * (1.0 / 9007199254740992.0); }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// Standard normal (Box-Muller; both numbers are used).
    double normal() {
        if (has_spare_) {
            has_spare_ = false;
            return spare_;
        }
        const double radius = std::sqrt(-2 * log_of(1 - uniform())), angle = 2 * kPi * uniform();
        spare_ = radius * sin_of(angle);
        has_spare_ = true;
        return radius * cos_of(angle);
    }
    V3 direction() {
        const double x = normal(), y = normal(), z = normal();
        return normalized(V3{x, y, z});
    }

  private:
    static std::uint64_t scramble(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
    double spare_ = 0;
    bool has_spare_ = false;
};

}  // namespace mien::demo
