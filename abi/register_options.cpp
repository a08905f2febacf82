#include "register_options.hpp"

#include <cmath>

#include "arrays.hpp"
#include "model/landmark_names.hpp"
#include "options.hpp"

namespace mien::abi {
namespace {

void check_options(const mien_register_options& given) {
    check_choice(given.growth, MIEN_GROWTH_CONSTANT, MIEN_GROWTH_CUBIC, "options.growth");
    check_choice(given.start, MIEN_START_AUTOMATIC, MIEN_START_SEARCH, "options.start");
    check_choice(given.units, MIEN_UNITS_DETECT, MIEN_UNITS_REFUSE, "options.units");
    check_choice(given.landmark_sides, MIEN_SIDES_REFUSE, MIEN_SIDES_IGNORE,
                 "options.landmark_sides");
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    check_numbers({{"landmark_sigma_mm", given.landmark_sigma_mm},
                   {"sigma_start_mm", given.sigma_start_mm},
                   {"sigma_end_mm", given.sigma_end_mm},
                   {"max_angle_deg", given.max_angle_deg},
                   {"start_scale", given.start_scale},
                   {"unit_to_mm", given.unit_to_mm}});
    for (const auto& [name, value] :
         {std::pair{"max_distance_mm", given.max_distance_mm},
          std::pair{"mutual_mm", given.mutual_mm}, std::pair{"soft_mm", given.soft_mm}})
        if (!(value >= 0) || !std::isfinite(value))
            fail(Status::invalid_argument, "options.%s is %g, it must be positive, or 0", name,
                 value);
    if (given.reserved2 != 0) fail(Status::unsupported_option, "options.reserved2 is not zero");
    if (given.unit_to_mm < 0 || !std::isfinite(given.unit_to_mm))
        fail(Status::invalid_argument, "options.unit_to_mm is %g, it must be positive, or 0",
             given.unit_to_mm);
    for (const double number : given.start_rotation) check_numbers({{"start_rotation", number}});
    for (const double number : given.start_translation)
        check_numbers({{"start_translation", number}});
}

std::vector<LandmarkPoint> given_landmarks(const mien_register_options& given) {
    check_array(given.landmarks, given.landmark_count, alignof(mien_scan_landmark), 1000000,
                "options.landmarks");
    std::vector<LandmarkPoint> landmarks;
    for (std::uint64_t k = 0; k < given.landmark_count; ++k) {
        const mien_scan_landmark& landmark = given.landmarks[k];
        landmarks.push_back(
            {checked_text(landmark.name, "a landmark's name"),
             Vector3(landmark.position[0], landmark.position[1], landmark.position[2])});
    }
    return landmarks;
}

/// The landmarks under the model's own names. Those it does not know keep theirs and are reported.
std::vector<LandmarkPoint> as_model_names(std::vector<LandmarkPoint> landmarks,
                                          const DeformationModel& model) {
    std::vector<Mark> marks;
    marks.reserve(landmarks.size());
    for (const LandmarkPoint& landmark : landmarks)
        marks.push_back({landmark.name, Mark::Where::place, landmark.point, 0});
    const NameMatch match = match_landmark_names(model, marks);
    require_known_landmark(model, match, marks);
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        if (match.landmark[i] >= 0)
            landmarks[i].name = model.landmarks[static_cast<std::size_t>(match.landmark[i])].name;
    return landmarks;
}

}  // namespace

mien_register_options default_register_options() {
    const RegistrationSettings core;
    const LoopSettings& loop = core.fit.loop;
    mien_register_options options{};
    options.growth = static_cast<std::int32_t>(loop.growth);
    options.landmark_sigma_mm = core.start.landmark_sigma_mm;
    options.close_gap = core.gap.enabled ? 1 : 0;
    options.max_scalar_modes = -1;
    options.max_pca_modes = -1;
    options.reject_border = loop.match.reject_border ? 1 : 0;
    options.sigma_start_mm = loop.sigma_start_mm;
    options.sigma_end_mm = loop.sigma_end_mm;
    options.max_angle_deg = loop.match.max_angle_deg;
    options.start_rotation[0] = options.start_rotation[4] = options.start_rotation[8] = 1;
    options.start_scale = 1;
    options.color_features = core.colors.enabled ? 1 : 0;
    options.landmark_sides = static_cast<std::int32_t>(core.start.sides.rule);
    return options;
}

RegistrationSettings register_settings(const mien_register_options& given) {
    check_options(given);
    RegistrationSettings settings;
    settings.intake.units = static_cast<UnitRule>(given.units);
    settings.intake.skin_weights = read_switch(given.skin_weights, "options.skin_weights");
    settings.intake.unit_to_mm = given.unit_to_mm;
    settings.start.sides.rule = static_cast<SideRule>(given.landmark_sides);
    if (given.scan_weights.count != 0)
        settings.intake.weight_per_vertex = read_values(given.scan_weights, "options.scan_weights");
    settings.prior.max_scalar_modes = given.max_scalar_modes;
    settings.prior.max_pca_modes = given.max_pca_modes;
    settings.colors.enabled = read_switch(given.color_features, "options.color_features");
    settings.start.kind = static_cast<StartKind>(given.start);
    settings.start.landmark_sigma_mm = given.landmark_sigma_mm;
    Similarity& pose = settings.start.pose;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) pose.rotation(i, j) = given.start_rotation[3 * i + j];
        pose.translation[i] = given.start_translation[i];
    }
    pose.scale = given.start_scale;
    LoopSettings& loop = settings.fit.loop;
    loop.growth = static_cast<ModeGrowth>(given.growth);
    if (given.iterations != 0) loop.rounds = given.iterations;
    loop.sigma_start_mm = given.sigma_start_mm;
    loop.sigma_end_mm = given.sigma_end_mm;
    loop.match.reject_border = read_switch(given.reject_border, "options.reject_border");
    loop.match.max_angle_deg = given.max_angle_deg;
    if (given.max_distance_mm > 0) loop.match.limit_mm = given.max_distance_mm;
    if (given.mutual_mm > 0) loop.match.mutual_mm = given.mutual_mm;
    loop.match.soft_mm = given.soft_mm;
    settings.gap.enabled = read_switch(given.close_gap, "options.close_gap");
    return settings;
}

std::vector<LandmarkPoint> read_landmarks(const mien_register_options& given,
                                          const DeformationModel& model) {
    return as_model_names(given_landmarks(given), model);
}

}  // namespace mien::abi
