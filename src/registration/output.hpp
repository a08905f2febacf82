// The last stage, output: what the host gets from the finished fit.
#pragma once

#include "registration/registration.hpp"

namespace mien {

/// All that the stages before left.
struct FinishedStages {
    const DeformationModel& model;
    const PreparedScan& scan;
    const PriorState& prior;
    const StartState& start;
    const FitOutcome& fit;
    const GapState& gap;
    const InnerPartsState& inner;
};

/// Throws Status::no_solution when a vertex ended beyond reach of the scan.
RegistrationResult make_result(const FinishedStages& stages, const RegistrationSettings& settings,
                               const Context& context);

}  // namespace mien
