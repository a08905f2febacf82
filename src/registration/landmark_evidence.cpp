// Landmarks: a vertex should lie at the place that was picked, H = I / sigma^2 with the picking
// error sigma per axis.
#include "registration/evidence.hpp"

namespace mien {
namespace {

class LandmarkEvidence final : public EvidenceTerm {
  public:
    explicit LandmarkEvidence(const std::vector<Pin>& pins) : pins_(pins) {}
    const char* name() const override { return "landmarks"; }

    void add(const EvidenceRound& round, FitTerms& terms, const Context&) override {
        add_pins(round.problem.model, pins_, round.to_model, round.row_of, terms);
    }

  private:
    const std::vector<Pin>& pins_;
};

}  // namespace

void add_pins(const DeformationModel& model, const std::vector<Pin>& pins,
              const Similarity& to_model, const std::vector<Index>& row_of, FitTerms& terms) {
    for (const Pin& pin : pins)
        terms.add_isotropic(row_of[static_cast<std::size_t>(pin.vertex)],
                            1 / (pin.sigma_mm * pin.sigma_mm),
                            to_model.apply(pin.place) - rest_place(model, pin.vertex));
}

std::unique_ptr<EvidenceTerm> make_landmark_evidence(const FitProblem& problem,
                                                     const EvidenceSettings&) {
    if (problem.pins.empty()) return nullptr;
    return std::make_unique<LandmarkEvidence>(problem.pins);
}

}  // namespace mien
