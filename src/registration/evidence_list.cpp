#include "registration/evidence.hpp"

namespace mien {
namespace {

// The order decides in which order single precision sums a vertex' terms.
constexpr EvidenceFactory kKinds[] = {
    make_surface_evidence,
    make_bend_evidence,
    make_landmark_evidence,
    make_color_evidence,
};

}  // namespace

std::vector<std::unique_ptr<EvidenceTerm>> make_evidence(const FitProblem& problem,
                                                         const EvidenceSettings& settings) {
    std::vector<std::unique_ptr<EvidenceTerm>> evidence;
    for (const EvidenceFactory make : kKinds)
        if (std::unique_ptr<EvidenceTerm> term = make(problem, settings))
            evidence.push_back(std::move(term));
    return evidence;
}

Vector3 rest_place(const DeformationModel& model, Index vertex) {
    Vector3 place = model.template_mesh.vertices.row(vertex).transpose();
    if (model.mean_displacement.rows() > 0)
        place += model.mean_displacement.row(vertex).transpose();
    return place;
}

Vector3 EvidenceRound::rest_place(Index vertex) const {
    return mien::rest_place(problem.model, vertex);
}

}  // namespace mien
