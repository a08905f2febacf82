// The options protocol and hostile field values, for every function that takes a struct to read.
#include <cstring>
#include <limits>

#include "abuse.hpp"

namespace abuse {
namespace {

char* bytes_of(std::vector<std::uint64_t>& words) {
    return reinterpret_cast<char*>(words.data());
}

struct Case {
    const FunctionRow& row;
    const StructRow& layout;
    std::size_t index;  // of the parameter
    bool complete;      // every handle is live, so only the struct is wrong
};

std::int64_t call_with(const Case& c, Fixtures& fixtures, void* structure, const std::string& how,
                       Verdict& verdict, bool limited = true) {
    std::vector<Argument> arguments;
    fixtures.good_arguments(c.row, arguments);
    arguments[c.index].pointer = structure;
    begin_call(limited);
    return observed_call(c.row, arguments, how, verdict);
}

/// Short, exact, longer with a zero tail, longer with a non-zero tail, absurd, misaligned.
void abuse_size(const Case& c, Fixtures& fixtures, Verdict& verdict) {
    const std::string label = c.row.parameters[c.index].name;
    for (const std::uint32_t size : {0u, 3u, 4u, 0xffffffffu}) {
        auto structure = fixtures.structure(c.layout, 0, c.row.parameters[c.index].name);
        std::memcpy(structure.data(), &size, sizeof size);
        verdict.check(call_with(c, fixtures, structure.data(),
                                label + " of size " + std::to_string(size), verdict) < 0,
                      c.row.name, label + " of size " + std::to_string(size) + " is accepted");
    }
    if (!c.complete) return;
    auto exact = fixtures.structure(c.layout, 0, c.row.parameters[c.index].name);
    const std::int64_t expected =
        call_with(c, fixtures, exact.data(), label + " of exact size", verdict, false);
    verdict.check(expected != MIEN_E_UNSUPPORTED_OPTION, c.row.name,
                  label + " of exact size is refused");
    auto zero_tail = fixtures.structure(c.layout, 16, c.row.parameters[c.index].name);
    verdict.check(call_with(c, fixtures, zero_tail.data(), label + " with a zero tail", verdict,
                            false) == expected,
                  c.row.name, label + " with a zero tail is treated otherwise than the exact size");
    auto tail = fixtures.structure(c.layout, 16, c.row.parameters[c.index].name);
    bytes_of(tail)[c.layout.size + 9] = 1;
    verdict.check(call_with(c, fixtures, tail.data(), label + " with a set tail", verdict) ==
                      MIEN_E_UNSUPPORTED_OPTION,
                  c.row.name, label + " with a set tail is not MIEN_E_UNSUPPORTED_OPTION");
}

void abuse_fields(const Case& c, Fixtures& fixtures, Verdict& verdict) {
    const std::string label = c.row.parameters[c.index].name;
    for (const FieldRow& field : c.layout.fields) {
        const std::string name = field.name, how = label + "." + name;
        if (name == "struct_size") continue;
        const auto attempt = [&](const auto& value, const char* what, bool must_fail) {
            auto structure = fixtures.structure(c.layout, 0, c.row.parameters[c.index].name);
            std::memcpy(bytes_of(structure) + field.offset, &value, sizeof value);
            const std::int64_t result =
                call_with(c, fixtures, structure.data(), how + " " + what, verdict);
            if (must_fail) verdict.check(result < 0, c.row.name, how + " " + what + " is accepted");
        };
        const bool reserved = name.find("reserved") != std::string::npos;
        switch (field.kind) {
            case Field::whole32:
                attempt(std::int32_t{-1}, "-1", reserved);
                attempt(std::numeric_limits<std::int32_t>::max(), "the largest", reserved);
                attempt(std::numeric_limits<std::int32_t>::min(), "the smallest", reserved);
                break;
            case Field::whole64:
                attempt(std::numeric_limits<std::uint64_t>::max(), "the largest", reserved);
                attempt(std::uint64_t{1} << 62, "2^62", reserved);
                break;
            case Field::real32:
                attempt(std::numeric_limits<float>::quiet_NaN(), "NaN", true);
                attempt(-1e30f, "-1e30", false);
                break;
            case Field::real64:
                attempt(std::numeric_limits<double>::quiet_NaN(), "NaN", true);
                attempt(std::numeric_limits<double>::infinity(), "infinite", false);
                attempt(-1.0, "-1", false);
                attempt(1e300, "1e300", false);
                break;
            case Field::nested: {
                if (field.size != sizeof(mien_array_view)) break;
                alignas(16) static const double values[4] = {1, 2, 3, 4};
                mien_array_view view{values, std::uint64_t{1} << 61, 0, MIEN_DTYPE_F64, 0};
                attempt(view, "of 2^61 rows", true);
                view = {reinterpret_cast<const char*>(values) + 1, 1, 0, MIEN_DTYPE_F64, 0};
                attempt(view, "misaligned", true);
                view = {nullptr, 1, 0, MIEN_DTYPE_F64, 0};
                attempt(view, "null with a count", true);
                view = {values, 1, 0, 99, 0};
                attempt(view, "of an unknown dtype", true);
                view = {values, 1, 1, MIEN_DTYPE_F64, 0};
                attempt(view, "with a stride of 1", true);
                break;
            }
            case Field::pointer:
            case Field::callback:
            case Field::bytes:
                break;
        }
    }
}

/// A view with a value that is no number: refused, but for frames of a camera, where it says that
/// nothing was seen.
void abuse_values(const Case& c, Fixtures& fixtures, Verdict& verdict) {
    std::vector<double> positions(3 * Fixtures::kVertices, 1.0);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        positions[0] = bad;
        auto structure = fixtures.structure(c.layout, 0, c.row.parameters[c.index].name);
        const auto* data = positions.data();
        std::memcpy(structure.data(), &data, sizeof data);
        const bool is_frame = std::strcmp(c.row.name, "mien_follower_fit") == 0;
        const bool refused =
            call_with(c, fixtures, structure.data(), "values that are not finite", verdict) < 0;
        verdict.check(refused != is_frame, c.row.name,
                      std::string(c.row.parameters[c.index].name) +
                          " with a value that is not finite is " +
                          (refused ? "refused" : "accepted"));
    }
}

}  // namespace

void abuse_structs(Fixtures& fixtures, Verdict& verdict) {
    for (const FunctionRow& row : functions()) {
        if (row.result != Result::status) continue;
        std::vector<Argument> good;
        const bool complete = fixtures.good_arguments(row, good);
        for (std::size_t i = 0; i < row.parameters.size(); ++i) {
            if (row.parameters[i].kind != Kind::struct_in) continue;
            const Case c{row, *find_struct(row.parameters[i].type), i, complete};
            if (c.layout.tells_its_size) abuse_size(c, fixtures, verdict);
            if (complete) abuse_fields(c, fixtures, verdict);
            if (complete && std::string(c.layout.name) == "mien_array_view")
                abuse_values(c, fixtures, verdict);
            alignas(16) static char room[4096];
            auto structure = fixtures.structure(c.layout, 0, c.row.parameters[c.index].name);
            std::memcpy(room + 1, structure.data(), c.layout.size);
            verdict.check(call_with(c, fixtures, room + 1, "misaligned", verdict) < 0, row.name,
                          std::string(row.parameters[i].name) + " misaligned is accepted");
        }
    }
}

}  // namespace abuse
