// Norms of the anthropometric measurements: mean and deviation over the people of a reference
// dataset, and where one person stands among them: z = (value - mean) / deviation.
//
// A norm is for the population of its dataset, and for faces fitted with the same template: the
// place of a landmark on another template is another place.
#pragma once

#include <string>
#include <vector>

#include "measure/anthropometry.hpp"
#include "mesh/dataset.hpp"

namespace mien {

/// Fewer people give no deviation that a z-score could stand on.
constexpr Index kFewestNormPeople = 10;

struct Norm {
    std::string name;             ///< of the measurement
    double mean = 0.0, sd = 0.0;  ///< over people, in the measurement's unit
    Index people = 0;             ///< that had it
};

class NormSet {
  public:
    NormSet() = default;
    /// `list` of at least kFewestNormPeople each. Throws Status::invalid_argument for names that
    /// stand there twice and numbers that are none.
    explicit NormSet(std::vector<Norm> list);
    const std::vector<Norm>& list() const { return list_; }
    /// Null: there is none.
    const Norm* find(const std::string& name) const;

  private:
    std::vector<Norm> list_;
};

/// Where a value stands; not a number throughout without a norm or without a value.
struct NormScore {
    double z = 0.0;
    double sd = 0.0;  ///< of z, by the measurement's own deviation
    double mean = 0.0, population_sd = 0.0;
    Index people = 0;
};
NormScore score_against(const NormSet* norms, const AnthropometricValue& value);

/// Over the neutral faces of a dataset, one vote per person (the mean of a person's neutral faces).
/// places: vertices of the dataset's topology. Measurements that fewer than kFewestNormPeople have
/// are left out. Throws Status::not_found for a dataset without neutral faces or landmarks without
/// a measurement, invalid_argument for too few people or places that are no vertices, and as
/// measure_anthropometry(). About one factorisation a face.
NormSet norms_of_dataset(const FaceDataset& dataset, const std::vector<FacePlace>& places,
                         const Context& context);

/// {"norms": {name: {"mean": x, "sd": x, "people": n, "unit": "mm"}}}.
std::string norms_json(const NormSet& norms);
/// Throws Status::bad_format naming the file and the norm.
NormSet parse_norms(const char* data, std::size_t size, const std::string& path);
NormSet read_norms(const std::string& path, const Context& context);
void write_norms(const std::string& path, const NormSet& norms);

}  // namespace mien
