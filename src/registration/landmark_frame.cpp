#include "registration/landmark_frame.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/length_unit.hpp"
#include "model/landmarks.hpp"

namespace mien {
namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

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

// mm of the template per unit of the landmarks; 0 when all coincide.
double size_ratio(const KnownLandmarks& known) {
    std::vector<double> ratios;
    for (Index i = 0; i < known.places.rows(); ++i)
        for (Index j = 0; j < i; ++j) {
            const double there = (known.places.row(i) - known.places.row(j)).norm();
            const double here = (known.rest.row(i) - known.rest.row(j)).norm();
            if (there > 0 && here > 0) ratios.push_back(here / there);
        }
    return ratios.empty() ? 0 : median(std::move(ratios));
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

}  // namespace

LandmarkFrame settle_landmark_frame(const DeformationModel& model, const PointsRef& scan,
                                    const std::vector<LandmarkPoint>& landmarks,
                                    double known_scan_to_mm,
                                    const LandmarkFrameSettings& settings) {
    LandmarkFrame frame;
    frame.landmarks = landmarks;
    if (!settings.enabled) return frame;
    const KnownLandmarks known = find_known(model, landmarks);
    if (known.places.rows() < static_cast<Index>(settings.fewest)) return frame;
    const double ratio = size_ratio(known);
    const Points thinned = thin_out(scan, settings.scan_vertices);
    if (!(ratio > 0) || thinned.rows() == 0) return frame;
    // The landmarks' units, nearest first; the scan's own is tried first with each.
    std::vector<double> units;
    for (const LengthUnit& unit : length_units())
        if (std::abs(std::log(ratio / unit.to_mm)) < std::log(settings.size_range))
            units.push_back(unit.to_mm);
    double best = settings.on_scan_mm;
    for (const double landmarks_to_mm : units)
        for (const bool half_turn : {false, true}) {
            Points places = landmarks_to_mm * known.places;
            if (half_turn) places.leftCols<2>() *= -1;
            std::vector<double> scan_units{landmarks_to_mm};
            if (known_scan_to_mm > 0)
                scan_units = {known_scan_to_mm};
            else
                for (const LengthUnit& unit : length_units())
                    if (unit.to_mm != landmarks_to_mm) scan_units.push_back(unit.to_mm);
            for (const double scan_to_mm : scan_units) {
                const double distance = distance_to_scan(scan_to_mm * thinned, places);
                // What the files say is kept unless something else is clearly better.
                const bool plain = scan_to_mm == landmarks_to_mm && !half_turn;
                if (!(distance < (plain ? settings.on_scan_mm : best / 2)) ||
                    (frame.settled && !(distance < best / 2)))
                    continue;
                best = distance;
                frame.settled = true;
                frame.scan_to_mm = scan_to_mm;
                frame.landmarks_to_mm = landmarks_to_mm;
                frame.half_turn = half_turn;
            }
        }
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
