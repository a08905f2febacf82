// The functions that write default options report nothing, so they take no memory: what they threw
// when there is none would end the host. Not yet so, and not called here: those of registration and
// training.
#include <mien/mien.h>

#include "fail_nth.hpp"

namespace {

/// 1 with a line printed when the function allocates, else 0.
template <typename Options>
int faults_of(const char* name, void(MIEN_CALL* write_defaults)(Options*, std::size_t)) {
    Options options;
    oom::control.fail_at = 0;  // counted, not failed: a failure would end this program too
    oom::control.persistent = false;
    oom::control.seen = 0;
    oom::control.armed = true;
    write_defaults(&options, sizeof options);
    oom::control.armed = false;
    const long seen = oom::control.seen.load();
    if (seen != 0) std::printf("%s allocates %ld times\n", name, seen);
    if (options.struct_size != sizeof options) std::printf("%s writes no defaults\n", name);
    return seen != 0 || options.struct_size != sizeof options ? 1 : 0;
}

}  // namespace

#define FAULTS_OF(function) faults_of(#function, &function)

int main() {
    if (!oom::available()) {
        std::puts("the malloc family cannot be replaced in this build: skipped");
        return 0;
    }
    const int faults =
        FAULTS_OF(mien_session_options_init) + FAULTS_OF(mien_model_options_init) +
        FAULTS_OF(mien_tune_options_init) + FAULTS_OF(mien_neutralize_options_init) +
        FAULTS_OF(mien_evaluate_options_init) + FAULTS_OF(mien_measure_options_init) +
        FAULTS_OF(mien_score_options_init) + FAULTS_OF(mien_series_options_init) +
        FAULTS_OF(mien_visits_options_init) + FAULTS_OF(mien_study_options_init) +
        FAULTS_OF(mien_shard_options_init) + FAULTS_OF(mien_spectral_basis_options_init) +
        FAULTS_OF(mien_blendshape_options_init) + FAULTS_OF(mien_representation_options_init);
    std::printf("%d of the functions that write defaults are at fault\n", faults);
    return faults == 0 ? 0 : 1;
}
