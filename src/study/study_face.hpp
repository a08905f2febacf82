// One capture of a person as a study takes it: the fitted face with what is known of its errors.
#pragma once

#include <memory>
#include <vector>

#include "registration/registration.hpp"
#include "study/settings.hpp"

namespace mien {

struct StudyFace {
    std::shared_ptr<const TriMesh> mesh;  ///< all faces of a study share one topology; mm
    Vector normal_sd_mm;  ///< #V, how far the surface may lie off the skin; empty: not known
    Vector place_sd_mm;   ///< #V, of the place, per axis; empty: not known along the skin
    Vector weights;       ///< #V in [0, 1], how far the scan was seen there; empty: not known
    bool failed = false;  ///< the fit's verdict: its deviations mean nothing
    int visit = 0;        ///< number of its visit, from 0; captures of one visit stand together
};

/// How far a fitted surface may lie off the skin along the normal, #V, mm: where the scan was seen,
/// the residual over the scanner's noise; where it was not, what the model leaves open:
///     s = w min(hypot(noise, r), c) + (1 - w) c.
/// place_sd_mm: c, the deviation of the place per axis; empty: not known, and neither is the
/// result. weights in [0, 1]; empty: all seen. residual_mm: signed distance to the scan; empty:
/// none. Throws Status::mismatch for different lengths.
Vector normal_deviation_mm(const Vector& place_sd_mm, const Vector& weights,
                           const Vector& residual_mm, double noise_mm);

/// The part of face.normal_sd_mm that a comparison with `other` is unsure by, #V, mm: what was seen
/// counts whole, and of the deviation c of a place that neither saw (the share 1 - w of it, w the
/// larger weight of both) apart_share alone: s - (1 - apart_share) (1 - w) c, at least 0. Without
/// weights or place_sd_mm of either, all of normal_sd_mm.
Vector change_deviation_mm(const StudyFace& face, const StudyFace& other, double apart_share);

/// A registration's face; `mesh`: its fitted template (a registration may have given it away).
StudyFace study_face_of(std::shared_ptr<const TriMesh> mesh, const RegistrationResult& fit,
                        double noise_mm);

/// Throws Status::mismatch or invalid_argument, naming the face, for faces of different topology,
/// arrays of another length, deviations below zero or not finite, weights outside [0, 1], and
/// visits that are not numbered 0, 1, 2 ... in order.
void check_study_faces(const std::vector<StudyFace>& faces);

}  // namespace mien
