// What tells where the template's vertices should be: the scan's surface, the turn of its normals,
// landmarks, colours. Each kind is one EvidenceTerm that adds its quadratics to the round's system.
//
// To add a kind: write one file like landmark_evidence.cpp (the class and its factory), declare
// the factory below, and list it in evidence_list.cpp. A kind with settings adds its struct to
// EvidenceSettings.
#pragma once

#include <memory>
#include <vector>

#include "registration/fit_state.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct SurfaceEvidenceSettings {
    double weight = 0.03;     ///< > 0: independent hits per vertex, as neighbours' errors are alike
                              ///< [J]
    double tangential = 0.1;  ///< 0 to 1: weight of sliding along the surface against leaving it;
                              ///< 1: point to point [A]
};

struct BendEvidenceSettings {
    double normal_length_mm = 5;  ///< mm, >= 0: how far a turn of the normal by one radian counts
                                  ///< as a shift; 0: no such evidence [A]
    double turn_rad = 0.3;        ///< rad, > 0: a turn beyond comes from another shape and not from
                                  ///< a slide [J]
    double bend_per_mm = 0.1;     ///< 1/mm, > 0: bends beyond are noise, lids and lips [J]
};

struct ColorEvidenceSettings {
    double weight = 0.1;  ///< >= 0: independent observations per vertex; 0: no such evidence [A]
    double blur_sigmas = 1.3;  ///< > 0: blur in noise levels of the surface ... [J]
    double least_blur_mm = 1, most_blur_mm = 8;  ///< ... and its limits, mm [J]
};

struct EvidenceSettings {
    SurfaceEvidenceSettings surface;
    BendEvidenceSettings bend;
    ColorEvidenceSettings color;
};

/// What a term sees of the round that it adds to. Borrowed, for the length of the call.
struct EvidenceRound {
    const FitProblem& problem;
    const FitState& state;
    const Similarity& to_model;           ///< scan frame -> model frame
    const Points& normals;                ///< #V x 3 of state.places, scan frame
    const std::vector<Index>& row_of;     ///< #V: the vertex' row of the terms, or -1
    const std::vector<Index>& vertex_of;  ///< the row's vertex
    const Correspondences& matches;       ///< of the rows, filtered and weighted
    const CorrespondenceSettings& match;  ///< the filters that gave them
    double sigma_mm;                      ///< noise level
    Index stride;                         ///< about one vertex in so many has a row

    /// Template plus mean, model frame: what displacements are counted from.
    Vector3 rest_place(Index vertex) const;
};

class EvidenceTerm {
  public:
    virtual ~EvidenceTerm() = default;
    /// For logs and tests.
    virtual const char* name() const = 0;
    /// Adds to the rows of `terms`. Called once a round, by one thread, in the order of the list.
    virtual void add(const EvidenceRound& round, FitTerms& terms, const Context& context) = 0;
};

/// Null when the problem has nothing of the kind, or the settings switch it off.
using EvidenceFactory = std::unique_ptr<EvidenceTerm> (*)(const FitProblem& problem,
                                                          const EvidenceSettings& settings);

std::unique_ptr<EvidenceTerm> make_surface_evidence(const FitProblem&, const EvidenceSettings&);
std::unique_ptr<EvidenceTerm> make_bend_evidence(const FitProblem&, const EvidenceSettings&);
std::unique_ptr<EvidenceTerm> make_landmark_evidence(const FitProblem&, const EvidenceSettings&);
std::unique_ptr<EvidenceTerm> make_color_evidence(const FitProblem&, const EvidenceSettings&);

/// All that the problem and the settings ask for, in the order of the list.
std::vector<std::unique_ptr<EvidenceTerm>> make_evidence(const FitProblem& problem,
                                                         const EvidenceSettings& settings);

/// x + mean of a vertex, model frame.
Vector3 rest_place(const DeformationModel& model, Index vertex);

/// Landmarks' part alone, for fits that have nothing else.
void add_pins(const DeformationModel& model, const std::vector<Pin>& pins,
              const Similarity& to_model, const std::vector<Index>& row_of, FitTerms& terms);

}  // namespace mien
