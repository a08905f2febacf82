#include "registration/landmark_sides.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/median.hpp"
#include "registration/evidence.hpp"

namespace mien {
namespace {

// For each pin the vertex of the model's landmark across the face; its own where there is none.
std::vector<Index> find_partners(const DeformationModel& model, const std::vector<Pin>& pins,
                                 double partner_mm) {
    std::vector<Index> partners;
    const Points& rest = model.template_mesh.vertices;
    for (const Pin& pin : pins) {
        const Eigen::RowVector3d image(-rest(pin.vertex, 0), rest(pin.vertex, 1),
                                       rest(pin.vertex, 2));
        Index best = pin.vertex;
        double nearest = partner_mm;
        for (const Landmark& landmark : model.landmarks) {
            const double distance = (rest.row(landmark.vertex) - image).norm();
            if (distance >= nearest) continue;
            nearest = distance;
            best = static_cast<Index>(landmark.vertex);
        }
        partners.push_back(best);
    }
    return partners;
}

std::vector<double> distances(const DeformationModel& model, const std::vector<Pin>& pins,
                              const Similarity& motion) {
    std::vector<double> d;
    d.reserve(pins.size());
    for (const Pin& pin : pins)
        d.push_back((motion.apply(rest_place(model, pin.vertex)) - pin.place).norm());
    return d;
}

}  // namespace

ExchangedSides find_exchanged_sides(const DeformationModel& model, const std::vector<Pin>& pins,
                                    bool with_scale, const SideSettings& settings,
                                    const PinAlignmentSettings& alignment) {
    ExchangedSides sides;
    sides.partner_vertex = find_partners(model, pins, settings.partner_mm);
    std::vector<Pin> exchanged = pins;
    std::size_t moved = 0;
    for (std::size_t k = 0; k < pins.size(); ++k) {
        exchanged[k].vertex = sides.partner_vertex[k];
        moved += exchanged[k].vertex != pins[k].vertex;
    }
    if (moved < settings.fewest) return sides;
    const Similarity as_named = align_pins(model, pins, with_scale, alignment);
    const std::vector<double> own = distances(model, pins, as_named);
    const double misfit = median(own);
    if (misfit >= settings.least_mm) {
        const Similarity across = align_pins(model, exchanged, with_scale, alignment);
        if (median(distances(model, exchanged, across)) < settings.clearly * misfit) {
            sides.all = true;
            for (std::size_t k = 0; k < pins.size(); ++k)
                if (exchanged[k].vertex != pins[k].vertex) sides.pins.push_back(k);
            return sides;
        }
    }
    const std::vector<double> partner = distances(model, exchanged, as_named);
    for (std::size_t k = 0; k < pins.size(); ++k)
        if (exchanged[k].vertex != pins[k].vertex && own[k] > settings.own_mm &&
            partner[k] < settings.share * own[k])
            sides.pins.push_back(k);
    if (sides.pins.size() < settings.fewest) sides.pins.clear();
    return sides;
}

std::string describe(const ExchangedSides& sides, const std::vector<std::string>& names) {
    if (sides.all)
        return "the landmarks are mirrored: left and right are exchanged in their names, or the "
               "scan itself is mirrored";
    std::string text = "the landmarks";
    constexpr std::size_t kShown = 3;
    for (std::size_t i = 0; i < std::min(kShown, sides.pins.size()); ++i)
        text += " " + names[sides.pins[i]];
    if (sides.pins.size() > kShown)
        text += " and " + std::to_string(sides.pins.size() - kShown) + " more";
    return text + " are mirrored: left and right are exchanged in their names";
}

}  // namespace mien
