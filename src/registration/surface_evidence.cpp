// The scan's surface: a vertex should lie on the plane through its hit, and by a small share at the
// hit itself (point to plane with a tangential share tau),
//
//   H = w s (n n' + tau (I - n n')) / sigma^2,
//
// w the filters' weight, s the independent observations per vertex, sigma the noise level.
#include "registration/evidence.hpp"

namespace mien {
namespace {

class SurfaceEvidence final : public EvidenceTerm {
  public:
    explicit SurfaceEvidence(const SurfaceEvidenceSettings& settings) : settings_(settings) {}
    const char* name() const override { return "surface"; }

    void add(const EvidenceRound& round, FitTerms& terms, const Context&) override {
        const double precision = settings_.weight * static_cast<double>(round.stride) /
                                 (round.sigma_mm * round.sigma_mm);
        for (Index row = 0; row < round.matches.weight.size(); ++row) {
            const double weight = round.matches.weight[row];
            if (!(weight > 0)) continue;
            const SurfaceHit& hit = round.matches.hits[static_cast<std::size_t>(row)];
            const Vector3 normal =
                round.to_model.rotation * round.matches.normals.row(row).transpose();
            terms.add_planar(row, weight * precision, settings_.tangential, normal,
                             round.to_model.apply(hit.point) -
                                 round.rest_place(round.vertex_of[static_cast<std::size_t>(row)]));
        }
    }

  private:
    const SurfaceEvidenceSettings settings_;
};

}  // namespace

std::unique_ptr<EvidenceTerm> make_surface_evidence(const FitProblem&,
                                                    const EvidenceSettings& settings) {
    return std::make_unique<SurfaceEvidence>(settings.surface);
}

}  // namespace mien
