#include "registration/landmark_frame.hpp"

#include <algorithm>
#include <cmath>

#include "base/median.hpp"
#include "mesh/length_unit.hpp"
#include "model/landmarks.hpp"

namespace mien {
namespace {

// Places of known landmarks and of their vertices, row by row.
struct KnownLandmarks {
    Points places, rest;
};

KnownLandmarks find_known(const DeformationModel& model,
                          const std::vector<LandmarkPoint>& landmarks) {
    KnownLandmarks known{Points(static_cast<Index>(landmarks.size()), 3),
                         Points(static_cast<Index>(landmarks.size()), 3)};
    Index count = 0;
    for (const LandmarkPoint& landmark : landmarks) {
        const Landmark* found = find_landmark(model.landmarks, landmark.name);
        if (found == nullptr || !landmark.point.allFinite()) continue;
        known.places.row(count) = landmark.point.transpose();
        known.rest.row(count++) = model.template_mesh.vertices.row(found->vertex);
    }
    known.places.conservativeResize(count, 3);
    known.rest.conservativeResize(count, 3);
    return known;
}

// mm of the template per unit of the landmarks; 0 when all coincide. The repeated median (Siegel,
// Robust regression using repeated medians, 1982).
double size_ratio(const KnownLandmarks& known) {
    std::vector<double> of_landmarks;
    for (Index i = 0; i < known.places.rows(); ++i) {
        std::vector<double> ratios;
        for (Index j = 0; j < known.places.rows(); ++j) {
            const double there = (known.places.row(i) - known.places.row(j)).norm();
            const double here = (known.rest.row(i) - known.rest.row(j)).norm();
            if (there > 0 && here > 0) ratios.push_back(here / there);
        }
        if (!ratios.empty()) of_landmarks.push_back(median(std::move(ratios)));
    }
    return of_landmarks.empty() ? 0 : median(std::move(of_landmarks));
}

// Median over the landmarks of the squared distance to the nearest of the thinned vertices, root.
double distance_to_scan(const Points& thinned, const Points& places) {
    std::vector<double> nearest;
    for (Index i = 0; i < places.rows(); ++i)
        nearest.push_back((thinned.rowwise() - places.row(i)).rowwise().squaredNorm().minCoeff());
    return std::sqrt(median(std::move(nearest)));
}

Points thin_out(const PointsRef& scan, Index about) {
    const Index stride = std::max<Index>(1, scan.rows() / about);
    Points thinned((scan.rows() + stride - 1) / stride, 3);
    Index count = 0;
    for (Index i = 0; i < scan.rows(); i += stride)
        if (scan.row(i).allFinite()) thinned.row(count++) = scan.row(i);
    thinned.conservativeResize(count, 3);
    return thinned;
}

/// A frame that was tried: units, turn, and how far from the scan the landmarks then lie.
struct Trial {
    double scan_to_mm, landmarks_to_mm;
    bool half_turn;
};

// The trial under which the landmarks lie on the scan; what the files say (one unit for both, no
// turn) is kept unless something else is clearly better.
void choose_frame(const KnownLandmarks& known, const Points& thinned,
                  const std::vector<Trial>& trials, double on_scan_mm, LandmarkFrame& frame) {
    double best = on_scan_mm;
    for (const Trial& trial : trials) {
        Points places = trial.landmarks_to_mm * known.places;
        if (trial.half_turn) places.leftCols<2>() *= -1;
        const double distance = distance_to_scan(trial.scan_to_mm * thinned, places);
        const bool plain = trial.scan_to_mm == trial.landmarks_to_mm && !trial.half_turn;
        if (!(distance < (plain ? on_scan_mm : best / 2)) ||
            (frame.settled && !(distance < best / 2)))
            continue;
        best = distance;
        frame.settled = true;
        frame.scan_to_mm = trial.scan_to_mm;
        frame.landmarks_to_mm = trial.landmarks_to_mm;
        frame.half_turn = trial.half_turn;
    }
}

// Known units of the landmarks, nearest first, each with the scan in the same unit before others.
std::vector<Trial> trials_in_known_units(double ratio, double known_scan_to_mm, double size_range) {
    std::vector<Trial> trials;
    for (const LengthUnit& own : length_units()) {
        if (!(std::abs(std::log(ratio / own.to_mm)) < std::log(size_range))) continue;
        for (const bool half_turn : {false, true}) {
            if (known_scan_to_mm > 0) {
                trials.push_back({known_scan_to_mm, own.to_mm, half_turn});
                continue;
            }
            trials.push_back({own.to_mm, own.to_mm, half_turn});
            for (const LengthUnit& unit : length_units())
                if (unit.to_mm != own.to_mm) trials.push_back({unit.to_mm, own.to_mm, half_turn});
        }
    }
    return trials;
}

}  // namespace

LandmarkFrame settle_landmark_frame(const DeformationModel& model, const PointsRef& scan,
                                    const std::vector<LandmarkPoint>& landmarks,
                                    double known_scan_to_mm, const LandmarkFrameSettings& settings,
                                    const UnitSettings& unit) {
    LandmarkFrame frame;
    frame.landmarks = landmarks;
    if (!settings.enabled) return frame;
    const KnownLandmarks known = find_known(model, landmarks);
    if (known.places.rows() < static_cast<Index>(settings.fewest)) return frame;
    const double ratio = size_ratio(known);
    const Points thinned = thin_out(scan, settings.scan_vertices);
    if (!(ratio > 0) || thinned.rows() == 0) return frame;
    std::vector<Trial> trials = trials_in_known_units(ratio, known_scan_to_mm, settings.size_range);
    // What is as large as a head in millimetres is in millimetres, whatever the landmarks say.
    frame.unit_guessed =
        trials.empty() && !(known_scan_to_mm > 0) && detect_unit_mm(thinned, unit) != 1;
    if (frame.unit_guessed) trials = {{ratio, ratio, false}, {ratio, ratio, true}};
    choose_frame(known, thinned, trials, settings.on_scan_mm, frame);
    frame.unit_guessed = frame.unit_guessed && frame.settled;
    if (!frame.settled) return frame;
    const double factor = frame.landmarks_to_mm / frame.scan_to_mm;
    for (LandmarkPoint& landmark : frame.landmarks) {
        landmark.point *= factor;
        if (frame.half_turn) landmark.point.head<2>() *= -1;
    }
    return frame;
}

std::string describe(const LandmarkFrame& frame) {
    if (!frame.settled) return std::string();
    std::string text;
    if (frame.landmarks_to_mm != frame.scan_to_mm)
        text = "the landmarks are in another unit than the scan (landmarks in " +
               unit_text(frame.landmarks_to_mm) + ", scan in " + unit_text(frame.scan_to_mm) +
               "): both were brought to mm";
    if (frame.half_turn)
        text += std::string(text.empty() ? "" : "; ") +
                "the landmarks were turned by half a turn about z to lie on the scan (RAS and LPS)";
    return text;
}

}  // namespace mien
