// The visits of one person, from fitted faces to numbers that a clinic signs: expressions off
// (neutral_faces.hpp), alignment on a stable zone (geometry/rigid_zone.hpp), change per zone and
// pair of visits with its errors (zone_change.hpp), limits of detection from repeated captures.
//
//     Study study(context, model, faces, settings);
//     study.change(0, 1).zones[0].signed_ml.low;
//
// The first capture of a visit is measured. Two captures of one visit have no change between them:
// every pair of them is a blank, and two blanks or more give the limit of detection (repeatability
// .hpp); otherwise it is propagated from the deviation.
#pragma once

#include <map>
#include <mutex>
#include <utility>

#include "study/zone_change.hpp"

namespace mien {

/// Immutable once made, but for the pairs it remembers: safe to ask from many threads.
class Study {
  public:
    /// model: null measures the faces as they are held. Throws as check_study_settings(),
    /// check_study_faces(), resolve_zones(), neutral_faces() and align_fits_on_zone(). O(K^2) for K
    /// faces in the joint fit; the pairs (0, k) and the blanks are measured here.
    Study(const Context& context, std::shared_ptr<const ExpressionModel> model,
          std::vector<StudyFace> faces, StudySettings settings);

    std::size_t num_visits() const { return first_of_.size(); }
    const StudyData& data() const { return data_; }
    const std::vector<Zone>& zones() const { return data_.zones.measured; }
    /// Place in data().faces of the capture that stands for a visit. Throws Status::not_found.
    std::size_t face_of(std::size_t visit) const;
    std::size_t num_captures(std::size_t visit) const;
    /// Pairs of captures that the limits of detection come from; below two: they are propagated.
    std::size_t num_blanks() const { return num_blanks_; }

    /// From one visit to another. A pair is measured when it is first asked for. Throws
    /// Status::not_found for a visit that is none and invalid_argument for one against itself.
    const PairChange& change(std::size_t first, std::size_t second) const;
    /// The neutral face of `visit` in the frame of `frame`'s face; of its own when both are one.
    TriMesh neutral(std::size_t visit, std::size_t frame) const;
    /// Signed distance of the second neutral face from the first along its normals, #V, mm.
    Vector distances_mm(std::size_t first, std::size_t second) const;

  private:
    void measure_blanks(const Context& context);
    PairChange measured(const Context& context, std::size_t first, std::size_t second) const;

    StudyData data_;
    std::vector<std::size_t> first_of_;  // the capture of each visit that is measured
    std::size_t num_blanks_ = 0;
    /// Per zone: limits of signed, gained, lost, absolute, area, distance; empty: propagated.
    std::vector<std::vector<double>> limits_;
    mutable std::mutex mutex_;
    mutable std::map<std::pair<std::size_t, std::size_t>, PairChange> pairs_;
};

}  // namespace mien
