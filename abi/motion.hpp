// Rigid motions as 12 numbers of the host's: R row by row, then t in mm.
#pragma once

#include <optional>

#include "base/error.hpp"
#include "base/types.hpp"

namespace mien::abi {

/// Nothing for null. Throws Status::invalid_argument for what is no rigid motion.
inline std::optional<Similarity> read_motion(const double* motion) {
    if (motion == nullptr) return std::nullopt;
    if (reinterpret_cast<std::uintptr_t>(motion) % alignof(double) != 0)
        fail(Status::invalid_argument, "motion is misaligned");
    Similarity result;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) result.rotation(r, c) = motion[3 * r + c];
    result.translation = Vector3(motion[9], motion[10], motion[11]);
    if (!result.rotation.allFinite() || !result.translation.allFinite() ||
        !(result.rotation * result.rotation.transpose()).isIdentity(1e-6))
        fail(Status::invalid_argument, "motion is not a rotation and a translation");
    return result;
}

/// Does nothing for null.
inline void write_motion(const Similarity& motion, double* to) {
    if (to == nullptr) return;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) to[3 * r + c] = motion.rotation(r, c);
    for (int r = 0; r < 3; ++r) to[9 + r] = motion.translation[r];
}

}  // namespace mien::abi
