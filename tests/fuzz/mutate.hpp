// Damages bytes the way files are damaged and forged: flipped bits, numbers at their limits,
// pieces cut out, doubled and moved, texts with numbers made absurd. Same seed, same damage.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace mien::fuzz {

/// SplitMix64: small, and the same everywhere. Or the bytes of a fuzzer, two for each number and 0
/// after their end, so that the fuzzer learns which byte decides what.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// Borrows the bytes.
    Random(const unsigned char* bytes, std::size_t size)
        : state_(0), bytes_(bytes), end_(bytes + size) {}
    std::uint64_t next() {
        if (bytes_ != nullptr) {
            std::uint64_t number = bytes_ < end_ ? *bytes_++ : 0;
            if (bytes_ < end_) number |= static_cast<std::uint64_t>(*bytes_++) << 8;
            return number;
        }
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    /// True when a fuzzer's bytes are at their end; a seed has none.
    bool exhausted() const { return bytes_ != nullptr && bytes_ == end_; }
    std::size_t below(std::size_t limit) {
        return limit == 0 ? 0 : static_cast<std::size_t>(next() % limit);
    }

  private:
    std::uint64_t state_;
    const unsigned char *bytes_ = nullptr, *end_ = nullptr;
};

inline void overwrite_with_limit(std::string& bytes, Random& random) {
    static const std::uint64_t kLimits[] = {0,
                                            1,
                                            0x7f,
                                            0x80,
                                            0xff,
                                            0x7fff,
                                            0xffff,
                                            0x7fffffff,
                                            0x80000000,
                                            0xffffffff,
                                            0x7fffffffffffffff,
                                            0x8000000000000000,
                                            0xffffffffffffffff,
                                            0x7f800000,
                                            0x7fc00000,
                                            0x7ff0000000000000,
                                            0x40000001,
                                            0x55555556};
    const std::size_t width = std::size_t(1) << random.below(4);
    if (bytes.size() < width) return;
    std::uint64_t value = kLimits[random.below(sizeof kLimits / sizeof kLimits[0])];
    if (random.below(4) == 0) value += random.below(5) - 2;
    char raw[8];
    std::memcpy(raw, &value, 8);
    if (random.below(2) == 0) std::reverse(raw, raw + width);
    std::memcpy(&bytes[random.below(bytes.size() - width + 1)], raw, width);
}

inline void replace_text_number(std::string& bytes, Random& random) {
    static const char* const kTexts[] = {"0",
                                         "-1",
                                         "1e999",
                                         "-1e-999",
                                         "nan",
                                         "inf",
                                         "4294967296",
                                         "2147483648",
                                         "18446744073709551616",
                                         "99999999999999999",
                                         "0x10",
                                         "1.",
                                         ".",
                                         "+",
                                         "-",
                                         "\"",
                                         "{",
                                         "[",
                                         "//",
                                         "\\\n",
                                         "#"};
    std::size_t at = random.below(bytes.size() + 1);
    while (at < bytes.size() && (bytes[at] < '0' || bytes[at] > '9')) ++at;
    std::size_t end = at;
    while (end < bytes.size() && bytes[end] >= '0' && bytes[end] <= '9') ++end;
    bytes.replace(at, end - at, kTexts[random.below(sizeof kTexts / sizeof kTexts[0])]);
}

inline std::string mutate(std::string bytes, const std::string& other, Random& random) {
    for (std::size_t round = 1 + random.below(6); round != 0; --round) {
        const std::size_t at = random.below(bytes.size() + 1);
        const std::size_t length = random.below(std::min<std::size_t>(bytes.size() - at, 64) + 1);
        switch (random.below(9)) {
            case 0:
            case 1:
                if (at < bytes.size())
                    bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
                break;
            case 2:
                overwrite_with_limit(bytes, random);
                break;
            case 3:
                replace_text_number(bytes, random);
                break;
            case 4:
                bytes.erase(at, length);
                break;
            case 5:
                bytes.insert(at, bytes.substr(at, length));
                break;
            case 6:
                bytes.resize(at);
                break;
            case 7: {
                const std::size_t from = random.below(other.size() + 1);
                bytes.insert(at, other.substr(from, random.below(64)));
                break;
            }
            default:
                for (std::size_t k = at; k < at + length; ++k)
                    bytes[k] = static_cast<char>(random.next());
        }
        if (bytes.size() > 65536) bytes.resize(65536);
    }
    return bytes;
}

}  // namespace mien::fuzz
