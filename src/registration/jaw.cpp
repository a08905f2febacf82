#include "registration/jaw.hpp"

#include <algorithm>
#include <cstdlib>
#include <Eigen/Geometry>

#include "model/landmarks.hpp"

namespace mien {
namespace {

// The number behind `prefix`, or -1 for another name.
int number_of(const std::string& name, const std::string& prefix) {
    return name.compare(0, prefix.size(), prefix) == 0 ? std::atoi(name.c_str() + prefix.size())
                                                       : -1;
}

// How much of the jaw's turn a landmark of the 68-point scheme takes part in: 1 at the chin and the
// lower lip; negative where the cheek pulls and nothing is known.
double share_of_jaw(const std::string& name, const JawSettings& settings) {
    if (const int k = number_of(name, "jaw_"); k >= 0) {
        switch (std::min(k, 16 - k)) {  // from the ear
            case 4:
                return settings.share_4;
            case 5:
                return settings.share_5;
            case 6:
                return settings.share_6;
            case 2:
            case 3:
                return -1;
            default:
                return std::min(k, 16 - k) >= 7 ? 1 : 0;
        }
    }
    if (const int k = number_of(name, "mouth_outer_"); k >= 0)
        return k == 0 || k == 6 ? settings.share_corner : (k > 6 ? 1 : 0);
    if (const int k = number_of(name, "mouth_inner_"); k >= 0)
        return k == 0 || k == 4 ? settings.share_corner : (k > 4 ? 1 : 0);
    return 0;
}

}  // namespace

std::vector<Pin> open_jaw(const DeformationModel& model, const FitState& state, double opening_rad,
                          const JawSettings& settings) {
    Points shape = model.template_mesh.vertices;
    if (state.displacement.rows() == shape.rows())
        shape += state.displacement;
    else if (model.mean_displacement.rows() > 0)
        shape += model.mean_displacement;
    const auto place = [&](const char* name, Vector3& at) {
        const Landmark* landmark = find_landmark(model.landmarks, name);
        if (landmark == nullptr) return false;
        at = shape.row(landmark->vertex).transpose();
        return true;
    };
    Vector3 right, left, angle, lip;
    if (!place("jaw_00", right) || !place("jaw_16", left) || !place("jaw_03", angle) ||
        !place("mouth_outer_09", lip))
        return {};
    const double width = (left - right).norm();
    if (!(width > 0)) return {};
    right[1] = left[1] = angle[1];
    right[2] -= settings.axis_back * width;
    left[2] -= settings.axis_back * width;
    const Vector3 axis = (left - right).normalized();
    const double down = axis.cross(lip - 0.5 * (left + right))[1] > 0 ? -1 : 1;
    std::vector<Pin> pins;
    for (const Landmark& landmark : model.landmarks) {
        const double share = share_of_jaw(landmark.name, settings);
        if (share < 0) continue;
        const Eigen::AngleAxisd turn(share * down * opening_rad, axis);
        const Vector3 from = shape.row(landmark.vertex).transpose();
        pins.push_back({static_cast<Index>(landmark.vertex),
                        state.motion.apply(Vector3(right + turn * (from - right))),
                        settings.sigma_mm});
    }
    return pins;
}

}  // namespace mien
