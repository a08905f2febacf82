// SHA-256 (FIPS 180-4), with the processor's own instructions where it has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mien {

class Sha256 {
  public:
    static constexpr std::size_t kDigits = 64;  ///< of a hexadecimal digest

    Sha256();
    void update(const void* data, std::size_t size);
    /// 64 lower-case hexadecimal digits; the object is spent afterwards.
    std::string hex_digest();

    /// For tests: the portable loop even where the processor has SHA instructions.
    static Sha256 portable();
    /// True when this processor's SHA instructions are in use.
    static bool uses_hardware();

  private:
    using Compress = void (*)(std::uint32_t* state, const std::uint8_t* blocks, std::size_t count);
    explicit Sha256(Compress compress);

    Compress compress_;
    std::uint32_t state_[8];
    std::uint64_t total_ = 0;
    std::uint8_t pending_[64];
};

}  // namespace mien
