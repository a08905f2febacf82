// Many scans side by side with one model: each runs on one thread, and as many at a time as there
// are threads, so that no thread waits for another's serial stage. What one scan needs is freed
// before the next begins: memory is that of as many scans as threads, and of the results.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "registration/registration.hpp"

namespace mien {

struct BatchJob {
    std::shared_ptr<const TriMesh> scan;
    std::vector<LandmarkPoint> landmarks;
    RegistrationSettings settings;
};

/// A fit, or why there is none.
struct BatchOutcome {
    std::unique_ptr<RegistrationResult> fit;
    Status status = Status::ok;
    std::string message;
};

/// One outcome a job, in their order, each with the bits of register_scan() alone. A scan that
/// fails does not end the others; only Status::cancelled, callback and time_limit do.
std::vector<BatchOutcome> register_batch(const DeformationModel& model,
                                         const std::vector<BatchJob>& jobs, const Context& context);

}  // namespace mien
