#include "registration/shut_lids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "model/landmarks.hpp"

namespace mien {
namespace {

struct Eye {
    Index corner[2], upper[2], lower[2];  // vertices; upper[k] lies over lower[k]
};

bool find_eye(const DeformationModel& model, const std::string& side, Eye& eye) {
    Index* const slots[] = {&eye.corner[0], &eye.upper[0], &eye.upper[1],
                            &eye.corner[1], &eye.lower[1], &eye.lower[0]};
    for (int k = 0; k < 6; ++k) {
        const Landmark* known =
            find_landmark(model.landmarks, "eye_" + side + "_" + std::to_string(k));
        if (known == nullptr) return false;
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
bool tone_at(const ScanSurface& scan, const Points& places, double reach_mm, Tone& tone,
             const Context& context) {
    std::vector<SurfaceHit> hits;
    scan.tree.closest(places, reach_mm, hits, context);
    std::vector<double> values[2];
    for (const SurfaceHit& hit : hits) {
        if (!hit.valid()) continue;
        const Eigen::Vector2d signals = scan.colors_at(hit);
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
template <std::size_t kCount>
Points places_between(const Points& places, const Eye& eye, int columns,
                      const std::array<double, kCount>& shares) {
    Points between(columns * static_cast<Index>(shares.size()), 3);
    Index row = 0;
    for (int column = 0; column < columns; ++column) {
        const double along = column / (columns - 1.0);
        const Eigen::RowVector3d upper =
            (1 - along) * places.row(eye.upper[0]) + along * places.row(eye.upper[1]);
        const Eigen::RowVector3d lower =
            (1 - along) * places.row(eye.lower[0]) + along * places.row(eye.lower[1]);
        for (const double share : shares) between.row(row++) = (1 - share) * upper + share * lower;
    }
    return between;
}

}  // namespace

std::vector<Pin> shut_lids(const DeformationModel& model, const ScanView& scan,
                           const FitState& state, double sigma_mm, const ShutLidSettings& settings,
                           const Context& context) {
    std::vector<Pin> pins;
    const ScanSurface& surface = scan.surface();
    if (!settings.enabled || !surface.has_colors()) return pins;
    const Eigen::Array2d alike(settings.alike_red, settings.alike_dark),
        even(settings.even_red, settings.even_dark);
    for (const char* side : {"right", "left"}) {
        Eye eye;
        Tone eyeball, skin;
        if (!find_eye(model, side, eye) ||
            !tone_at(surface, places_between(state.places, eye, settings.columns, settings.eyeball),
                     settings.reach_mm, eyeball, context) ||
            !tone_at(surface, places_between(state.places, eye, settings.columns, settings.skin),
                     settings.reach_mm, skin, context))
            continue;
        const Eigen::Array2d differs = (eyeball.middle - skin.middle).array().abs();
        const bool shut = (differs < alike).all() && (eyeball.width.array() < even).all();
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
