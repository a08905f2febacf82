#include "registration/tie_record.hpp"

#include <limits>

#include "base/error.hpp"

namespace mien {
namespace {

constexpr double kAny = std::numeric_limits<double>::max();

/// A field of a tie, its tensor and the values that it can have.
struct TieField {
    const char* tensor;
    Vector TextureTie::*values;
    double low, high;
};
constexpr TieField kFields[] = {{"tie_slide_mm", &TextureTie::slide_mm, 0, kAny},
                                {"tie_agreement", &TextureTie::agreement, -1, 1},
                                {"tie_share", &TextureTie::share, 0, 1},
                                {"tie_standard_deviation_mm", &TextureTie::sd_mm, 0, kAny}};

void check_values(const double* values, Index count, double low, double high, const char* tensor) {
    // Correlations are sums of float: a part in a million above 1 is none too many.
    const double slack = 1e-6;
    for (Index k = 0; k < count; ++k)
        if (!(values[k] >= low - slack) || !(values[k] <= high + slack))
            fail_at(Status::corrupt, k, "tensor '%s': value %lld is %g, which no tie has", tensor,
                    static_cast<long long>(k), values[k]);
}

}  // namespace

std::vector<double> tie_numbers(const TextureTie& tie) {
    return {tie.tied ? 1.0 : 0.0, tie.compared, tie.agreeing, tie.median_slide_mm,
            static_cast<double>(tie.undone)};
}

void add_tie(const TextureTie& tie, const std::vector<double>& numbers,
             std::vector<TensorToWrite>& tensors, std::map<std::string, std::string>& metadata) {
    metadata["tie_why_not"] = tie.why_not;
    tensors.push_back({"tie", DType::f64, {numbers.size()}, numbers.data()});
    for (const TieField& field : kFields) {
        const Vector& values = tie.*field.values;
        if (values.size() == 0) continue;
        tensors.push_back(
            {field.tensor, DType::f64, {static_cast<std::uint64_t>(values.size())}, values.data()});
    }
}

std::shared_ptr<const TextureTie> read_tie(const SafetensorsFile& file, Index num_vertices) {
    if (!file.has("tie")) return nullptr;
    const auto* numbers = static_cast<const double*>(file.tensor("tie", DType::f64, {5}).data);
    check_values(numbers, 3, 0, 1, "tie");
    check_values(numbers + 3, 2, 0, 1e9, "tie");
    auto tie = std::make_shared<TextureTie>();
    tie->tied = numbers[0] != 0;
    tie->why_not = file.metadata("tie_why_not");
    tie->compared = numbers[1];
    tie->agreeing = numbers[2];
    tie->median_slide_mm = numbers[3];
    tie->undone = static_cast<Index>(numbers[4]);
    for (const TieField& field : kFields) {
        if (!file.has(field.tensor)) continue;
        const auto* values =
            static_cast<const double*>(file.tensor(field.tensor, DType::f64, {num_vertices}).data);
        check_values(values, num_vertices, field.low, field.high, field.tensor);
        (*tie).*field.values = Eigen::Map<const Vector>(values, num_vertices);
    }
    return tie;
}

}  // namespace mien
