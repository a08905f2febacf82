#include "abuse.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

namespace abuse {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A handle made by a successful abusive call is given back.
void release_outputs(const FunctionRow& row, const std::vector<Argument>& arguments) {
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
        if (row.parameters[i].kind != Kind::handle_out || arguments[i].pointer == nullptr) continue;
        Argument made;
        std::memcpy(&made.pointer, arguments[i].pointer, sizeof made.pointer);
        if (made.pointer != nullptr)
            find_function(std::string(row.parameters[i].type) + "_release")->call(&made);
    }
}

}  // namespace

void Verdict::check(bool good, const std::string& function, const std::string& what) {
    if (!good) faults.push_back(function + ": " + what);
}

std::int64_t observed_call(const FunctionRow& row, std::vector<Argument> arguments,
                           const std::string& how, Verdict& verdict, std::string* message,
                           bool keep) {
    mien_error error;
    std::memset(&error, 0x5A, sizeof error);
    error.struct_size = sizeof error;
    bool has_record = false;
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
        if (row.parameters[i].kind == Kind::error) {
            arguments[i].pointer = &error;
            has_record = true;
        }
        if (row.parameters[i].kind == Kind::handle_out && arguments[i].pointer != nullptr)
            std::memset(arguments[i].pointer, 0x5A, sizeof(void*));
    }
    ++verdict.calls;
    if (verdict.trace != nullptr) {
        std::fprintf(verdict.trace, "%s: %s\n", row.name, how.c_str());
        std::fflush(verdict.trace);
    }
    const std::int64_t result = row.call(arguments.data());
    if (row.result != Result::status) return result;
    verdict.check(
        result <= 0 && result > MIEN_E_INTERNAL, row.name,
        how + ": unexpected status " + mien_status_name(static_cast<mien_status>(result)) +
            (has_record && result < 0 ? std::string(": ") + error.message : std::string()));
    if (has_record) {
        verdict.check(error.status == result, row.name,
                      how + ": the record and the returned status differ");
        const bool ended = std::memchr(error.message, 0, sizeof error.message) != nullptr;
        verdict.check(ended, row.name, how + ": the message has no end");
        verdict.check(!ended || (result < 0) == (error.message[0] != '\0'), row.name,
                      how + ": a failure without a message, or a message without one");
        if (message != nullptr && ended) *message = error.message;
    }
    for (std::size_t i = 0; i < row.parameters.size(); ++i)
        if (row.parameters[i].kind == Kind::handle_out && arguments[i].pointer != nullptr &&
            result < 0) {
            void* made = nullptr;
            std::memcpy(&made, arguments[i].pointer, sizeof made);
            verdict.check(made == nullptr, row.name, how + ": failed, and *out is not null");
        }
    if (result == MIEN_OK && !keep) release_outputs(row, arguments);
    return result;
}

namespace {

struct Attempt {
    std::string how;
    Argument argument;
    bool must_fail;
};

/// Foreign memory of the three sorts that a tag can tell: nothing, another live type, a released
/// object.
std::vector<Attempt> wrong_handles(const Fixtures& fixtures, const ParameterRow& parameter) {
    alignas(16) static unsigned char zeroes[512], released[512];
    const std::uint32_t released_tag = 0xDEADC0DE;
    std::memcpy(released, &released_tag, sizeof released_tag);
    std::vector<Attempt> attempts;
    const auto add = [&](const char* how, void* pointer, bool must_fail) {
        Argument argument;
        argument.pointer = pointer;
        attempts.push_back({how, argument, must_fail});
    };
    add("null", nullptr, !parameter.nullable);
    add("of another type", fixtures.other_handle(parameter.type), true);
    add("memory of zeroes", zeroes, true);
    add("released", released, true);
    add("misaligned", zeroes + 1, true);
    return attempts;
}

std::vector<Attempt> wrong_arguments(const Fixtures& fixtures, const ParameterRow& parameter) {
    static const char* const hole[] = {nullptr, nullptr};
    static const std::string endless(100000, 'x');
    static std::vector<std::uint64_t> room(std::size_t{1} << 19);
    std::fill_n(room.begin(), 4096, 0);  // an earlier call may have left a handle there
    char* const crooked = reinterpret_cast<char*>(room.data()) + 1;
    std::vector<Attempt> attempts;
    const auto pointer = [&](const char* how, const void* value, bool must_fail) {
        Argument argument;
        argument.pointer = const_cast<void*>(value);
        attempts.push_back({how, argument, must_fail});
    };
    const auto whole = [&](const char* how, std::int64_t value) {
        Argument argument;
        argument.whole = value;
        attempts.push_back({how, argument, false});
    };
    const auto real = [&](const char* how, double value, bool must_fail) {
        Argument argument;
        argument.real = value;
        attempts.push_back({how, argument, must_fail});
    };
    switch (parameter.kind) {
        case Kind::handle:
            return wrong_handles(fixtures, parameter);
        case Kind::text:
            pointer("null", nullptr, !parameter.nullable);
            pointer("empty", "", false);
            pointer("no UTF-8", "\xff\xfe\x80", false);
            pointer("endless", endless.c_str(), false);
            pointer("a folder that is not there", "/absent/folder/file.ply", false);
            break;
        case Kind::text_list:
            pointer("null", nullptr, !parameter.nullable);
            pointer("a list of nulls", hole, true);
            break;
        case Kind::handle_list:
        case Kind::array_in:
        case Kind::struct_in:
        case Kind::struct_out:
        case Kind::handle_out:
        case Kind::value_out:
        case Kind::view_out:
            pointer("null", nullptr, !parameter.nullable);
            // A correct result is as good as an error; a sanitizer sees whether it was read in
            // order.
            pointer("misaligned", crooked, false);
            break;
        case Kind::array_out:
            pointer("null with a capacity", nullptr, false);
            pointer("misaligned", crooked, false);
            break;
        case Kind::whole:
            whole("0", 0);
            whole("-1", -1);
            whole("the largest 32 bits", 0x7fffffff);
            whole("the smallest 32 bits", std::numeric_limits<std::int32_t>::min());
            whole("the largest 64 bits", std::numeric_limits<std::int64_t>::max());
            break;
        case Kind::real:
            real("NaN", kNaN, true);
            real("infinite", kInfinity, false);
            real("-1", -1, false);
            real("1e300", 1e300, false);
            break;
        case Kind::callback:
        case Kind::user:
        case Kind::error:
            break;
    }
    return attempts;
}

}  // namespace

void abuse_parameters(Fixtures& fixtures, Verdict& verdict) {
    for (const FunctionRow& row : functions()) {
        const std::string name = row.name;
        const bool reference_counting = ends_with(name, "_release") || ends_with(name, "_retain");
        std::vector<Argument> good;
        const bool complete = fixtures.good_arguments(row, good);
        // One call at a time is wrong, so all others must be right: else an error says nothing.
        if (complete && !reference_counting && row.result == Result::status) {
            std::string message;
            begin_call(false);
            const std::int64_t result =
                observed_call(row, good, "good arguments", verdict, &message);
            verdict.check(result == MIEN_OK, name, "good arguments are refused: " + message);
        }
        for (std::size_t i = 0; i < row.parameters.size(); ++i) {
            const ParameterRow& parameter = row.parameters[i];
            // A capacity that is larger than the host's memory is a lie that nobody can see
            // through.
            if (std::string(parameter.name) == "capacity" || ends_with(name, "_init")) continue;
            for (const Attempt& attempt : wrong_arguments(fixtures, parameter)) {
                // Fresh arguments: an earlier attempt may have written to them.
                fixtures.good_arguments(row, good);
                good[i] = attempt.argument;
                const std::string how = std::string(parameter.name) + " " + attempt.how;
                std::string message;
                const std::int64_t result = observed_call(row, good, how, verdict, &message);
                if (row.result == Result::pointer && parameter.kind == Kind::handle)
                    verdict.check(result == 0, name, how + " gives a pointer");
                if (row.result != Result::status || !attempt.must_fail) continue;
                verdict.check(result < 0, name, how + " is accepted");
                if (parameter.kind == Kind::handle && complete)
                    verdict.check(message.find(parameter.name) != std::string::npos, name,
                                  how + ": the message does not name the parameter: " + message);
            }
        }
        // Short outputs: the count is written, the buffer is not.
        for (std::size_t i = 0; complete && i < row.parameters.size(); ++i) {
            if (row.parameters[i].kind != Kind::array_out) continue;
            fixtures.good_arguments(row, good);
            for (std::size_t k = i; k < row.parameters.size(); ++k)
                if (std::string(row.parameters[k].name) == "capacity") good[k].whole = 1;
            auto* bytes = static_cast<unsigned char*>(good[i].pointer);
            std::memset(bytes, 0x5A, 4096);
            if (observed_call(row, good, "capacity 1", verdict) < 0)
                for (int k = 0; k < 4096; ++k)
                    if (bytes[k] != 0x5A) {
                        verdict.check(false, name,
                                      "capacity 1: failed, and the buffer was written");
                        break;
                    }
        }
        // An error record of an older or absent sort.
        if (complete && !reference_counting && row.result == Result::status) {
            fixtures.good_arguments(row, good);
            ++verdict.calls;
            if (row.call(good.data()) == MIEN_OK)
                release_outputs(row, good);  // its error argument is null
        }
    }
}

void check_init_functions(Verdict& verdict) {
    for (const StructRow& row : structs()) {
        if (row.init == nullptr) continue;
        const std::string name = row.name;
        row.init(nullptr, row.size);
        std::vector<unsigned char> whole(row.size), buffer(row.size + 96);
        row.init(whole.data(), row.size);
        for (std::size_t size = 0; size <= row.size + 32; ++size) {
            std::memset(buffer.data(), 0x5A, buffer.size());
            row.init(buffer.data(), size);
            ++verdict.calls;
            const std::size_t written = size < 4 ? 0 : size;
            bool good = true;
            for (std::size_t i = written; i < buffer.size(); ++i) good = good && buffer[i] == 0x5A;
            verdict.check(good, name + "_init",
                          "writes behind the size of " + std::to_string(size));
            if (written == 0) continue;
            std::uint32_t told = 0;
            std::memcpy(&told, buffer.data(), sizeof told);
            verdict.check(told == size, name + "_init", "writes another size than it was given");
            for (std::size_t i = 4; i < written; ++i)
                good = good && buffer[i] == (i < row.size ? whole[i] : 0);
            verdict.check(good, name + "_init",
                          "defaults differ for a size of " + std::to_string(size));
        }
    }
}

}  // namespace abuse
