// Colours: what lips and brows ask for (color_features.hpp), carried into the model's frame. Where
// a vertex should end is known in the direction of the gradient g only, H = w g g'.
#include <algorithm>

#include "registration/evidence.hpp"

namespace mien {
namespace {

class ColorEvidence final : public EvidenceTerm {
  public:
    explicit ColorEvidence(const ColorEvidenceSettings& settings) : settings_(settings) {}
    const char* name() const override { return "colors"; }

    void add(const EvidenceRound& round, FitTerms& terms, const Context& context) override {
        const FitProblem& problem = round.problem;
        const FitState& state = round.state;
        const double blur_mm = std::clamp(settings_.blur_sigmas * round.sigma_mm,
                                          settings_.least_blur_mm, settings_.most_blur_mm);
        const double precision = settings_.weight * static_cast<double>(round.stride);
        const Matrix3 to_model =
            state.motion.scale * state.motion.rotation.transpose();  // of a gradient
        const Points& mean = problem.model.mean_displacement;
        for (const ColorPull& pull :
             problem.colors.pulls(problem.scan, state.places, round.normals, round.match, blur_mm,
                                  matches_, context)) {
            const Index row = round.row_of[static_cast<std::size_t>(pull.vertex)];
            if (row < 0) continue;
            const Vector3 gradient = to_model * pull.gradient;
            Vector3 moved = state.displacement.row(pull.vertex).transpose();
            if (mean.rows() > 0) moved -= mean.row(pull.vertex).transpose();
            const double weight = pull.weight * precision;
            terms.add(row, weight * gradient * gradient.transpose(),
                      weight * gradient * (pull.difference + gradient.dot(moved)));
        }
    }

  private:
    const ColorEvidenceSettings settings_;
    std::vector<Correspondences> matches_;  // of the round before, as hints
};

}  // namespace

std::unique_ptr<EvidenceTerm> make_color_evidence(const FitProblem& problem,
                                                  const EvidenceSettings& settings) {
    if (problem.colors.empty() || !problem.scan.surface().has_colors() ||
        !(settings.color.weight > 0))
        return nullptr;
    return std::make_unique<ColorEvidence>(settings.color);
}

}  // namespace mien
