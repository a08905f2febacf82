#include "registration/shut_lids.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace mien {
namespace {

// Of redness and darkness (color_features.hpp). A shut lid is as the skin under it, and even; an
// eyeball is white, coloured and black.
const Eigen::Vector2d kAlike(0.12, 0.3), kEven(0.15, 0.7);

struct Eye {
    Index corner[2], upper[2], lower[2];  // vertices; upper[k] lies over lower[k]
};

bool find_eye(const DeformationModel& model, const std::string& side, Eye& eye) {
    Index* const slots[] = {&eye.corner[0], &eye.upper[0], &eye.upper[1],
                            &eye.corner[1], &eye.lower[1], &eye.lower[0]};
    for (int k = 0; k < 6; ++k) {
        const std::string name = "eye_" + side + "_" + std::to_string(k);
        const auto known =
            std::find_if(model.landmarks.begin(), model.landmarks.end(),
                         [&](const Landmark& landmark) { return landmark.name == name; });
        if (known == model.landmarks.end()) return false;
        *slots[k] = static_cast<Index>(known->vertex);
    }
    return true;
}

// The middle and the width from the tenth to the ninetieth percentile of the signals beside the
// places.
struct Tone {
    Eigen::Vector2d middle, width;
};

// False when the scan has little there.
bool tone_at(const ScanSurface& scan, const ColorFeatures& colors, const Points& places, Tone& tone,
             const Context& context) {
    constexpr double kReach_mm = 8;  // an eyeball lies behind the line between the lids
    std::vector<SurfaceHit> hits;
    scan.tree.closest(places, kReach_mm, hits, context);
    std::vector<double> values[2];
    for (const SurfaceHit& hit : hits) {
        if (!hit.valid()) continue;
        const Eigen::Vector2d signals = colors.signals_at(hit);
        for (int c = 0; c < 2; ++c) values[c].push_back(signals[c]);
    }
    if (2 * values[0].size() < hits.size()) return false;
    for (int c = 0; c < 2; ++c) {
        std::sort(values[c].begin(), values[c].end());
        const std::size_t count = values[c].size();
        tone.middle[c] = values[c][count / 2];
        tone.width[c] = values[c][9 * count / 10] - values[c][count / 10];
    }
    return true;
}

// Places on lines from the upper lid to the lower one, at the given shares of the way.
Points places_between(const Points& places, const Eye& eye, const std::vector<double>& shares) {
    constexpr int kColumns = 5;
    Points between(kColumns * static_cast<Index>(shares.size()), 3);
    Index row = 0;
    for (int column = 0; column < kColumns; ++column) {
        const double along = column / (kColumns - 1.0);
        const Eigen::RowVector3d upper =
            (1 - along) * places.row(eye.upper[0]) + along * places.row(eye.upper[1]);
        const Eigen::RowVector3d lower =
            (1 - along) * places.row(eye.lower[0]) + along * places.row(eye.lower[1]);
        for (const double share : shares) between.row(row++) = (1 - share) * upper + share * lower;
    }
    return between;
}

}  // namespace

std::vector<Pin> shut_lids(const DeformationModel& model, const ScanSurface& scan,
                           const FitState& state, double sigma_mm, const Context& context) {
    std::vector<Pin> pins;
    if (!state.colors) return pins;
    for (const char* side : {"right", "left"}) {
        Eye eye;
        Tone eyeball, skin;
        if (!find_eye(model, side, eye) ||
            !tone_at(scan, *state.colors, places_between(state.places, eye, {0.25, 0.5, 0.75}),
                     eyeball, context) ||
            !tone_at(scan, *state.colors, places_between(state.places, eye, {1.5, 2}), skin,
                     context))
            continue;
        const Eigen::Array2d differs = (eyeball.middle - skin.middle).array().abs();
        const bool shut =
            (differs < kAlike.array()).all() && (eyeball.width.array() < kEven.array()).all();
        context.log(LogLevel::debug, "%s eye: %s", side, shut ? "shut" : "open");
        if (!shut) continue;
        for (int k = 0; k < 2; ++k) {
            const Vector3 lower = state.places.row(eye.lower[k]).transpose();
            pins.push_back({eye.corner[k], state.places.row(eye.corner[k]).transpose(), sigma_mm});
            pins.push_back({eye.lower[k], lower, sigma_mm});
            pins.push_back({eye.upper[k], lower, sigma_mm});
        }
    }
    return pins;
}

}  // namespace mien
