// Where a surface bends, a normal that differs from the one seen tells of a slide: with S the
// scan's shape operator, p the shift along the surface and l a length,
//
//   w s l^2 / sigma^2 |(n_t - n_s) - S p|^2
//
// is one more part of the energy. A large turn comes from another shape and not from a slide, and
// the sharpest bends are noise, lids and lips: both are weighted down.
#include <cmath>

#include "base/parallel.hpp"
#include "registration/evidence.hpp"

namespace mien {
namespace {

constexpr std::size_t kRows = 512;  // of a chunk

class BendEvidence final : public EvidenceTerm {
  public:
    explicit BendEvidence(const EvidenceSettings& settings)
        : settings_(settings.bend), observations_(settings.surface.weight) {}
    const char* name() const override { return "bend"; }

    void add(const EvidenceRound& round, FitTerms& terms, const Context& context) override {
        const double precision =
            observations_ * static_cast<double>(round.stride) / (round.sigma_mm * round.sigma_mm);
        const Vector& weights = round.matches.weight;
        parallel_for(context, static_cast<std::size_t>(weights.size()), kRows,
                     [&](std::size_t first, std::size_t end) {
                         for (Index row = static_cast<Index>(first); row < static_cast<Index>(end);
                              ++row)
                             if (weights[row] > 0)
                                 add_turn(round, row,
                                          weights[row] * precision * settings_.normal_length_mm *
                                              settings_.normal_length_mm,
                                          terms);
                     });
    }

  private:
    void add_turn(const EvidenceRound& round, Index row, double weight, FitTerms& terms) const {
        const SurfaceHit& hit = round.matches.hits[static_cast<std::size_t>(row)];
        const Index vertex = round.vertex_of[static_cast<std::size_t>(row)];
        const Similarity& to_model = round.to_model;
        const Vector3 seen = round.matches.normals.row(row).transpose();
        const Vector3 target = to_model.apply(hit.point) - round.rest_place(vertex);
        Vector3 turn = round.normals.row(vertex).transpose() - seen;
        turn -= seen * seen.dot(turn);
        const Matrix3 bend =
            to_model.rotation * round.problem.scan.bending_at(hit) * to_model.rotation.transpose();
        const Matrix3 squared = bend * bend;
        weight *= std::exp(-0.5 * turn.squaredNorm() / (settings_.turn_rad * settings_.turn_rad)) /
                  (1 + squared.trace() / (settings_.bend_per_mm * settings_.bend_per_mm));
        terms.add(row, weight * squared,
                  weight * (squared * target + bend * (to_model.rotation * turn)));
    }

    const BendEvidenceSettings settings_;
    const double observations_;  // per vertex, as the surface's
};

}  // namespace

std::unique_ptr<EvidenceTerm> make_bend_evidence(const FitProblem&,
                                                 const EvidenceSettings& settings) {
    if (!(settings.bend.normal_length_mm > 0)) return nullptr;
    return std::make_unique<BendEvidence>(settings);
}

}  // namespace mien
