// The functions that write default options report nothing, so they take no memory: what they threw
// when there is none would end the host. CMake lists them from abi/symbols.txt: none is left out.
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

int main() {
    if (!oom::available()) {
        std::puts("the malloc family cannot be replaced in this build: skipped");
        return 0;
    }
    int faults = 0;
#define MIEN_WRITES_DEFAULTS(function) faults += faults_of(#function, &function);
#include "functions_that_write_defaults.inc"
    std::printf("%d of the functions that write defaults are at fault\n", faults);
    return faults == 0 ? 0 : 1;
}
