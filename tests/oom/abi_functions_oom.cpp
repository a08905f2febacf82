// Every function of the interface, called with good arguments while memory fails or is limited. The
// calls come from tests/abi/abuse, whose tables are made from the headers, so a new function is
// swept without being listed.
//
//   oom_abi_functions sweep [all | a part of a function's name]
//     Allocation n fails, alone and with all after it. Each call must end with MIEN_OK or
//     MIEN_E_NO_MEMORY, a failed one with a null handle and a message, leak nothing, and leave
//     everything as it was: afterwards the same call gives the same bytes. Without "all", a choice
//     of n per function.
//   oom_abi_functions budget [a part of a function's name]
//     Sessions with a budget below what the call takes: it must end with MIEN_E_MEMORY_BUDGET, or
//     with MIEN_OK within the budget, and the process's heap may grow by 10 % more than the budget.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "abi/abuse/abuse.hpp"
#include "fail_nth.hpp"

namespace {

using namespace abuse;

constexpr long long kSlackBytes = 64 << 10;  // names, records and what the C library keeps

class OwnFolder {
  public:
    OwnFolder() : before_(std::filesystem::current_path()) {
        std::random_device chance;
        folder_ = std::filesystem::temp_directory_path() / ("mien_oom_" + std::to_string(chance()));
        std::filesystem::create_directory(folder_);
        std::filesystem::current_path(folder_);
    }
    ~OwnFolder() {
        std::error_code ignored;
        std::filesystem::current_path(before_, ignored);
        std::filesystem::remove_all(folder_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

  private:
    std::filesystem::path before_, folder_;
};

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// What takes or gives a reference says nothing about memory and cannot be repeated.
bool is_swept(const FunctionRow& row) {
    const std::string name = row.name;
    return !ends_with(name, "_release") && !ends_with(name, "_retain") &&
           name != "mien_cancel_request";
}

/// Functions that add to an object: it is larger after each good call, which is no leak.
bool grows_its_object(const FunctionRow& row) {
    return ends_with(row.name, "_add");
}

/// One function with everything that its calls need, so that a call allocates nothing but the
/// library's own.
class Subject {
  public:
    Subject(const FunctionRow& row, Fixtures& fixtures) : row_(row) {
        complete_ = fixtures.good_arguments(row, arguments_);
        begin_call(false);
        for (std::size_t i = 0; i < row.parameters.size(); ++i) {
            const ParameterRow& parameter = row.parameters[i];
            if (parameter.kind == Kind::error) arguments_[i].pointer = &error_;
            if (parameter.kind == Kind::handle_out) {
                made_ = static_cast<void**>(arguments_[i].pointer);
                release_ = find_function(std::string(parameter.type) + "_release");
            }
            if (parameter.kind == Kind::array_out || parameter.kind == Kind::value_out)
                outputs_.push_back(static_cast<unsigned char*>(arguments_[i].pointer));
            if (parameter.kind == Kind::handle && std::string(parameter.type) == "mien_session")
                session_ = i;
        }
    }
    bool complete() const { return complete_; }
    bool has_session() const { return session_ != ~std::size_t(0); }
    void set_session(mien_session* session) { arguments_[session_].pointer = session; }

    /// The status; 0 for functions that return none.
    std::int64_t call() {
        std::memset(&error_, 0, sizeof error_);
        error_.struct_size = sizeof error_;
        handle_was_null_ = true;
        const std::int64_t result = row_.call(arguments_.data());
        const std::int64_t status = row_.result == Result::status ? result : 0;
        if (made_ != nullptr) {
            handle_was_null_ = *made_ == nullptr;
            if (*made_ != nullptr) {
                Argument argument;
                argument.pointer = *made_;
                release_->call(&argument);
            }
        }
        return status;
    }
    /// True when the last call's record and handle agree with its status.
    bool consistent(std::int64_t status) const {
        if (status == MIEN_OK) return made_ == nullptr || !handle_was_null_;
        return handle_was_null_ && error_.status == status && error_.message[0] != '\0';
    }
    const char* message() const { return error_.message; }

    /// FNV-1a over the outputs, which must not depend on what happened before.
    std::uint64_t outputs() const {
        std::uint64_t hash = 0xcbf29ce484222325u;
        for (const unsigned char* bytes : outputs_)
            for (std::size_t k = 0; k < kWatchedBytes; ++k)
                hash = (hash ^ bytes[k]) * 0x100000001b3u;
        return hash;
    }

  private:
    static constexpr std::size_t kWatchedBytes = 8192;
    const FunctionRow& row_;
    std::vector<Argument> arguments_;
    std::vector<unsigned char*> outputs_;
    mien_error error_ = {};
    void** made_ = nullptr;
    const FunctionRow* release_ = nullptr;
    std::size_t session_ = ~std::size_t(0);
    bool complete_ = false, handle_was_null_ = true;
};

class Report {
  public:
    void fault(const FunctionRow& row, const std::string& what) {
        if (++faults_ <= 40) std::printf("FAULT %s: %s\n", row.name, what.c_str());
        std::fflush(stdout);
    }
    long faults() const { return faults_; }

  private:
    long faults_ = 0;
};

/// One call with allocation n failing; false when the call makes fewer.
bool fail_one(const FunctionRow& row, Subject& subject, long n, bool persistent, Report& report) {
    const long live_before = oom::control.live.load();
    oom::control.persistent = persistent;
    oom::control.fail_at = n;
    oom::control.seen = 0;
    oom::control.armed = true;
    const std::int64_t status = subject.call();
    oom::control.armed = false;
    const long leaked = oom::control.live.load() - live_before;
    if (oom::control.seen.load() < n) return false;
    const std::string where =
        "allocation " + std::to_string(n) + (persistent ? " and all after it" : "");
    if (status != MIEN_OK && status != MIEN_E_NO_MEMORY)
        report.fault(row, where + " ends as " + mien_status_name(static_cast<mien_status>(status)) +
                              ": " + subject.message());
    if (!subject.consistent(status))
        report.fault(row, where + ": status, record and handle differ");
    if (leaked != 0 && !grows_its_object(row))
        report.fault(row, where + " leaks " + std::to_string(leaked) + " blocks");
    return true;
}

/// All n, or a choice: the first, then ever wider steps, at most `most`.
long sweep(const FunctionRow& row, Subject& subject, bool all, Report& report) {
    constexpr long kMost = 14;
    oom::control.persistent = false;
    oom::control.fail_at = 0;
    oom::control.seen = 0;
    oom::control.armed = true;
    subject.call();
    oom::control.armed = false;
    const long allocations = oom::control.seen.load();
    long failed = 0;
    for (const bool persistent : {false, true}) {
        const double growth =
            all ? 1 : std::max(1.0, std::pow(static_cast<double>(allocations), 1.0 / kMost));
        double next = 1;
        for (long n = 1; n <= allocations;) {
            if (!fail_one(row, subject, n, persistent, report)) break;
            ++failed;
            next = std::max(next * growth, static_cast<double>(n + 1));
            n = all ? n + 1 : static_cast<long>(next);
        }
    }
    return failed;
}

int run_sweep(bool all, const std::string& filter) {
    Fixtures fixtures;
    Report report;
    long failed = 0;
    int swept = 0;
    for (const FunctionRow& row : functions()) {
        if (!is_swept(row) || (!filter.empty() && std::strstr(row.name, filter.c_str()) == nullptr))
            continue;
        Subject subject(row, fixtures);
        if (!subject.complete()) {
            report.fault(row, "no good arguments are known");
            continue;
        }
        std::int64_t status = subject.call();
        status = subject.call();  // twice: what is made once for good is there now
        if (status != MIEN_OK) {
            report.fault(row, std::string("fails with memory at hand: ") + subject.message());
            continue;
        }
        const std::uint64_t before = subject.outputs();
        const long points = sweep(row, subject, all, report);
        if (ends_with(row.name, "_init") && points != 0)
            report.fault(row, "allocates, and can report nothing");
        if (subject.call() != MIEN_OK) report.fault(row, "fails after the sweep");
        if (subject.outputs() != before) report.fault(row, "gives other results after the sweep");
        failed += points;
        ++swept;
        if (all) std::printf("%-44s %6ld\n", row.name, points);
        std::fflush(stdout);
    }
    std::printf("%ld failed allocations in %d functions, %ld faults\n", failed, swept,
                report.faults());
    return report.faults() == 0 && swept > 0 ? 0 : 1;
}

/// The growth of the heap over a call.
long long peak_of(Subject& subject, std::int64_t& status) {
    const long long before = oom::control.bytes.load();
    oom::control.peak = before;
    status = subject.call();
    return oom::control.peak.load() - before;
}

mien_session* session_with(std::uint64_t max_bytes) {
    mien_session_options options;
    mien_session_options_init(&options, sizeof options);
    options.max_bytes = max_bytes;
    mien_session* session = nullptr;
    mien_session_create_with_options(MIEN_ABI_VERSION, &options, &session, nullptr);
    return session;
}

void check_budget(const FunctionRow& row, Subject& subject, long long needed, double share,
                  Report& report) {
    const auto budget = static_cast<std::uint64_t>(share * static_cast<double>(needed)) + 1;
    mien_session* session = session_with(budget);
    subject.set_session(session);
    std::int64_t status = 0;
    const long long peak = peak_of(subject, status);
    const auto limit = static_cast<long long>(1.1 * static_cast<double>(budget)) + kSlackBytes;
    const std::string where = "needs " + std::to_string(needed) + ", budget " +
                              std::to_string(budget) + ", heap grew by " + std::to_string(peak);
    if (status != MIEN_OK && status != MIEN_E_MEMORY_BUDGET)
        report.fault(row, where + ": ends as " +
                              mien_status_name(static_cast<mien_status>(status)) + ": " +
                              subject.message());
    if (peak > limit) report.fault(row, where + ": over the budget");
    if (share < 1 && status == MIEN_OK && needed > limit)
        report.fault(row, where + ": not refused");
    mien_session_release(session);
}

int run_budget(const std::string& filter) {
    Fixtures fixtures;
    Report report;
    int limited = 0, small = 0;
    for (const FunctionRow& row : functions()) {
        if (!is_swept(row) || (!filter.empty() && std::strstr(row.name, filter.c_str()) == nullptr))
            continue;
        Subject subject(row, fixtures);
        if (!subject.complete() || !subject.has_session()) continue;
        mien_session* unlimited = session_with(0);
        subject.set_session(unlimited);
        std::int64_t status = subject.call();
        const long long needed = peak_of(subject, status);
        mien_session_release(unlimited);
        if (status != MIEN_OK) report.fault(row, "fails without a budget");
        needed > kSlackBytes ? ++limited : ++small;
        std::printf("%-44s %10lld bytes\n", row.name, needed);
        for (const double share : {0.01, 0.3, 0.6, 0.9, 1.2})
            check_budget(row, subject, needed, share, report);
    }
    std::printf(
        "%d functions kept to their budget, %d more take less than %lld bytes, %ld faults\n",
        limited, small, kSlackBytes, report.faults());
    return report.faults() == 0 && limited > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (!oom::available()) {
        std::puts("the malloc family cannot be replaced in this build: skipped");
        return 0;
    }
    const std::string what = argc > 1 ? argv[1] : "sweep", filter = argc > 2 ? argv[2] : "";
    const OwnFolder folder;
    if (what == "budget") return run_budget(filter);
    return run_sweep(filter == "all", filter == "all" ? (argc > 3 ? argv[3] : "") : filter);
}
