// Units and frame of a scan and its landmarks, settled by the landmarks: their distances from each
// other tell what unit they are in, and that they lie on the scan tells what unit it is in.
//
// Each pair of landmarks gives a ratio of its distance to the template's; the median over a
// landmark's pairs, and of these over the landmarks, holds while less than half of them is wrong.
// Where that is no unit at all (a scan from photographs alone knows no size), the face is taken to
// be as large as the template, and the host is told that its size is a guess. 3D Slicer writes
// landmarks in RAS and meshes in LPS: half a turn about z between the two.
#pragma once

#include <string>
#include <vector>

#include "model/deformation_model.hpp"
#include "registration/units.hpp"

namespace mien {

/// All [J] (registration/settings.hpp): heads differ by 20 % and units by 2.5 times at least.
struct LandmarkFrameSettings {
    bool enabled = true;
    std::size_t fewest = 4;      ///< >= 3: known landmarks below which nothing is settled
    double size_range = 1.5;     ///< > 1: by how much a face may differ from the template
    double on_scan_mm = 15;      ///< mm, > 0: median distance of landmarks that lie on the scan
    Index scan_vertices = 5000;  ///< >= 1: of the scan, that distances are measured to
};

struct LandmarkFrame {
    bool settled = false;                  ///< the landmarks lie on the scan in these units
    double scan_to_mm = 1;                 ///< one unit of the scan
    double landmarks_to_mm = 1;            ///< one unit of the landmarks
    bool unit_guessed = false;             ///< no known unit: the template's size was taken
    bool half_turn = false;                ///< the landmarks' x and y are negated
    std::vector<LandmarkPoint> landmarks;  ///< in the scan's unit and frame
};

/// `known_scan_to_mm`: the scan's unit when the host told it, else 0. Landmarks that the model does
/// not know are moved along. Not settled: too few are known, or they lie on the scan in no unit;
/// then they come back as they are. O(#landmarks scan_vertices).
LandmarkFrame settle_landmark_frame(const DeformationModel& model, const PointsRef& scan,
                                    const std::vector<LandmarkPoint>& landmarks,
                                    double known_scan_to_mm, const LandmarkFrameSettings& settings,
                                    const UnitSettings& unit);

/// What was done, in words; empty when nothing was.
std::string describe(const LandmarkFrame& frame);

}  // namespace mien
