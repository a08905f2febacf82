// Calls that are cancelled, and calls without end.
#include <algorithm>
#include <cstring>
#include <vector>

#include "endurance.hpp"

namespace endurance {
namespace {

struct Countdown {
    long left;
    double last = -1;
    std::int32_t stage = 0;
    bool fell = false;
};

std::int32_t MIEN_CALL count_down(void* user, std::int32_t stage, double fraction) {
    auto* count = static_cast<Countdown*>(user);
    count->fell = count->fell || (stage == count->stage && fraction < count->last);
    count->stage = stage;
    count->last = fraction;
    return --count->left == 0 ? 1 : 0;
}

void put(void* structure, const StructRow& layout, const char* name, const void* value) {
    for (const FieldRow& field : layout.fields)
        if (std::strcmp(field.name, name) == 0)
            std::memcpy(static_cast<char*>(structure) + field.offset, value, field.size);
}

long resident_pages() {
    std::ifstream file("/proc/self/statm");
    long total = 0, resident = 0;
    file >> total >> resident;
    return resident;
}

}  // namespace

// Every function that reports progress is cancelled at its n-th report; the same call then still
// works.
void run_cancels(long count, std::uint64_t seed) {
    Fixtures fixtures;
    Verdict verdict;
    struct Long {
        const FunctionRow* row;
        std::size_t options;
        long reports;
    };
    std::vector<Long> calls;
    const auto run = [&](const Long& call, Countdown& down) {
        std::vector<Argument> arguments;
        fixtures.good_arguments(*call.row, arguments);
        const StructRow& layout = *find_struct(call.row->parameters[call.options].type);
        Countdown* user = &down;
        const mien_progress_fn function = &count_down;
        put(arguments[call.options].pointer, layout, "progress", &function);
        put(arguments[call.options].pointer, layout, "progress_user", &user);
        return observed_call(*call.row, arguments, "cancelled", verdict);
    };
    // A batch keeps the options of a scan for its run, and runs once (abi/follow_test.cpp cancels
    // it).
    const auto differs = [](const FunctionRow& row) {
        return std::strcmp(row.name, "mien_batch_add") == 0 ||
               std::strcmp(row.name, "mien_batch_run") == 0;
    };
    for (const FunctionRow& row : functions())
        for (std::size_t i = 0; i < row.parameters.size() && !differs(row); ++i) {
            if (row.parameters[i].kind != Kind::struct_in) continue;
            const StructRow& layout = *find_struct(row.parameters[i].type);
            const bool reports =
                std::any_of(layout.fields.begin(), layout.fields.end(),
                            [](const FieldRow& f) { return std::strcmp(f.name, "progress") == 0; });
            std::vector<Argument> arguments;
            if (!reports || !fixtures.good_arguments(row, arguments)) continue;
            Countdown down{-1};
            Long call{&row, i, 0};
            if (run(call, down) != MIEN_OK) fault(std::string(row.name) + " fails uncancelled");
            call.reports = -1 - down.left;
            if (call.reports == 0) {
                fault(std::string(row.name) + " reports no progress");
                continue;
            }
            if (down.last != 1)
                fault(std::string(row.name) + " ends at " + std::to_string(down.last));
            calls.push_back(call);
        }
    Random random(seed);
    for (long k = 0; k < count; ++k) {
        const Long& call = calls[static_cast<std::size_t>(k) % calls.size()];
        Countdown down{1 + static_cast<long>(random.below(static_cast<std::size_t>(call.reports)))};
        if (run(call, down) != MIEN_E_CANCELLED)
            fault(std::string(call.row->name) + " was not cancelled");
        if (down.fell) fault(std::string(call.row->name) + ": progress fell within a stage");
        Countdown never{-1};
        if (k % 16 == 0 && run(call, never) != MIEN_OK)
            fault(std::string(call.row->name) + " does not work after a cancel");
    }
    for (const std::string& found : verdict.faults) fault(found);
    std::printf("%ld cancels of %zu functions\n", count, calls.size());
}

// Rounds of every function; the process must not grow.
void run_soak(long count) {
    Fixtures fixtures;
    Verdict verdict;
    long settled = 0, now = 0;
    for (long round = 0; round < count; ++round) {
        for (const FunctionRow& row : functions()) {
            const std::string name = row.name;
            std::vector<Argument> arguments;
            if (row.result != Result::status || name.find("_add") != std::string::npos ||
                !fixtures.good_arguments(row, arguments))
                continue;
            begin_call(false);
            if (observed_call(row, arguments, "soak", verdict) != MIEN_OK)
                fault(name + " fails in round " + std::to_string(round));
        }
        now = resident_pages();
        if (round == count / 4) settled = now;
    }
    // A leak of one small block a round would show within thousands of rounds; pages come and go by
    // a few.
    if (settled > 0 && now > settled + settled / 10 + 1024)
        fault("the process grew from " + std::to_string(settled) + " to " + std::to_string(now) +
              " pages");
    for (const std::string& found : verdict.faults) fault(found);
    std::printf("%ld rounds of %d calls, %ld pages after a quarter of them, %ld at the end\n",
                count, verdict.calls, settled, now);
}

}  // namespace endurance
