// A step of a longer work: what it reports from 0 to 1 the host sees as a part of the whole.
#pragma once

#include "base/context.hpp"

namespace mien {

/// A context whose fractions 0 .. 1 become `from` .. `to` of the whole's. Borrows the whole; both
/// and this object must outlive the step.
class ProgressPart {
  public:
    ProgressPart(const Context& whole, double from, double to)
        : whole_(whole), from_(from), to_(to), context_(whole) {
        if (whole.progress_function == nullptr) return;
        context_.progress_function = &ProgressPart::forward;
        context_.progress_user = this;
    }
    ProgressPart(const ProgressPart&) = delete;
    ProgressPart& operator=(const ProgressPart&) = delete;
    const Context& context() const { return context_; }

  private:
    static std::int32_t forward(void* user, std::int32_t stage, double fraction) {
        const auto* part = static_cast<const ProgressPart*>(user);
        return part->whole_.progress_function(part->whole_.progress_user, stage,
                                              part->from_ + (part->to_ - part->from_) * fraction);
    }

    const Context& whole_;
    const double from_, to_;
    Context context_;
};

}  // namespace mien
