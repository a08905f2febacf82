#include "study/study_zones.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>

#include "base/error.hpp"
#include "base/json.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

using Vertices = std::vector<std::uint32_t>;

const Zone* look_up(const std::vector<Zone>& zones, const std::string& name) {
    for (const Zone& zone : zones)
        if (zone.name == name) return &zone;
    return nullptr;
}

const Zone& zone_called(const std::vector<Zone>& zones, const std::string& name) {
    const Zone* zone = look_up(zones, name);
    if (zone == nullptr)
        fail(Status::not_found, "no zone is called '%s'; the study has %zu zones",
             shown_name(name).c_str(), zones.size());
    return *zone;
}

void sort_once(Vertices& vertices) {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

Vertices united(const std::vector<Zone>& zones, const std::vector<std::string>& names) {
    Vertices vertices;
    for (const std::string& name : names) {
        const Vertices& of = zone_called(zones, name).vertices;
        vertices.insert(vertices.end(), of.begin(), of.end());
    }
    return vertices;
}

Vertices all_but(const std::vector<Zone>& zones, const Vertices& treated) {
    Vertices all, rest;
    for (const Zone& zone : zones)
        all.insert(all.end(), zone.vertices.begin(), zone.vertices.end());
    sort_once(all);
    std::set_difference(all.begin(), all.end(), treated.begin(), treated.end(),
                        std::back_inserter(rest));
    return rest;
}

std::string millimetres(double value) {
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

}  // namespace

Vertices with_margin(const PointsRef& face, const Vertices& vertices, double margin_mm) {
    for (const std::uint32_t v : vertices)
        if (static_cast<Index>(v) >= face.rows())
            fail_at(Status::mismatch, v, "a treated zone names vertex %u of %lld", v,
                    static_cast<long long>(face.rows()));
    Vertices near;
    const double reach = margin_mm * margin_mm;
    for (Index v = 0; v < face.rows(); ++v)
        for (const std::uint32_t of : vertices)
            if ((face.row(v) - face.row(of)).squaredNorm() <= reach) {
                near.push_back(static_cast<std::uint32_t>(v));
                break;
            }
    return near;
}

void leave_out(std::vector<Zone>& zones, const std::vector<std::uint8_t>& left_out) {
    for (Zone& zone : zones) {
        Vertices open;
        std::copy_if(zone.vertices.begin(), zone.vertices.end(), std::back_inserter(open),
                     [&](std::uint32_t v) { return left_out[v] == 0; });
        if (!open.empty()) zone.vertices = std::move(open);
    }
}

StudyZones resolve_zones(const StudyZoneSettings& settings, const PointsRef& face,
                         bool expressions_taken_off) {
    check_zones(settings.zones, face.rows());
    StudyZones result;
    result.named = settings.zones;
    result.treated = united(settings.zones, settings.treated);
    // A treatment does not end where its zone does: what lies beside it is no witness either.
    if (!result.treated.empty())
        result.treated = with_margin(face, result.treated, settings.margin_mm);
    if (settings.margin_mm > 0)
        for (const std::string& name : settings.treated)
            result.named.push_back({name + " and " + millimetres(settings.margin_mm) + " mm around",
                                    with_margin(face, zone_called(settings.zones, name).vertices,
                                                settings.margin_mm)});
    if (!settings.stable.empty()) {
        result.stable_names = settings.stable;
    } else if (!settings.treated.empty() && expressions_taken_off) {
        result.stable_is_untreated = true;
        result.stable = all_but(settings.zones, result.treated);
    } else if (!settings.zones.empty()) {
        result.stable_names = {"forehead", "nose"};
        for (const std::string& name : result.stable_names)
            if (look_up(settings.zones, name) == nullptr)
                fail(Status::not_found,
                     "no zone is called '%s', which faces are aligned on unless other stable zones "
                     "are named",
                     name.c_str());
    }
    if (!result.stable_names.empty()) result.stable = united(settings.zones, result.stable_names);
    if (result.stable.empty() && !settings.zones.empty())
        fail(Status::invalid_argument,
             "nothing is left to align on: the treated zones and %g mm around them cover every "
             "zone; name stable zones",
             settings.margin_mm);
    return result;
}

}  // namespace mien
