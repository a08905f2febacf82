// mien report: a patient's visits -> registration, neutralization, alignment on a stable zone,
// volumes per zone over time, as JSON and as one HTML page.
//
// A folder of visits holds one entry per visit, taken in the order of their names: a mesh file, or
// a folder with one or more captures (mesh files) of that visit; landmarks lie beside a mesh as
// NAME.json or landmarks.json. The first capture of a visit is measured; the others say how
// repeatable it is.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "render.hpp"
#include "report_fits.hpp"
#include "report_page.hpp"

namespace mien::cli {
namespace {

constexpr const char* kStable = "forehead,nose";

std::vector<std::string> split(const std::string& names) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= names.size() && !names.empty();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        parts.push_back(names.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// Pictures that differ between visits only where the faces do.
Image draw_face(const MeshArrays& face, const MeshArrays& framing) {
    RenderOptions options;
    options.views = {"front", "left45"};
    options.size = 360;
    options.framing = &framing;
    return render_mesh(face, options);
}

Image draw_difference(const MeshArrays& face, const std::vector<double>& signed_mm,
                      const MeshArrays& framing, double range) {
    RenderOptions options;
    options.views = {"front", "left45"};
    options.size = 360;
    options.framing = &framing;
    options.scalar = signed_mm;
    options.color_map = ColorMap::diverging;
    options.low = -range;
    options.high = range;
    options.label = "mm, red: gained";
    return render_mesh(face, options);
}

/// One zone's change with what its deviation is made of, mL.
struct ZoneChange {
    double signed_ml = 0, absolute_ml = 0, sd_ml = 0;
    double surface_ml = 0, alignment_ml = 0, bias_ml = 0, expression_ml = 0, removed_ml = 0;
    double low95_ml() const { return signed_ml - 1.959963984540054 * sd_ml; }
    double high95_ml() const { return signed_ml + 1.959963984540054 * sd_ml; }
};

struct Pair {
    std::vector<ZoneChange> changes;  ///< one per zone
    Measurement distance;
    mien_zone_alignment alignment;
    Mesh aligned;
};

/// first, second: captures in the order of `visits`, which may be null.
Pair compare(const Session& session, const ReportSettings& settings,
             const std::vector<Fitted>& fits, std::size_t first, std::size_t second,
             const Visits* visits, const std::vector<MeasureZone>& zones,
             const std::vector<std::uint32_t>& stable) {
    mien_zone_alignment info{};
    Mesh aligned = align_on_zone(session, fits[second].mesh, fits[first].mesh, stable, &info);
    MeasureOptions options;
    options.zones = zones;
    options.before_sd_mm = fits[first].sd;
    options.after_sd_mm = fits[second].sd;
    options.correlation_length_mm = settings.correlation;
    options.alignment_rotation_sd_rad = info.rotation_sd_rad;
    options.alignment_translation_sd_mm = info.translation_sd_mm;
    options.alignment_centre = {{info.centre[0], info.centre[1], info.centre[2]}};
    options.common_bias_mm = settings.bias;
    const Measurement volume = Measurement::volume(session, fits[first].mesh, aligned, options);
    const nlohmann::json parts = nlohmann::json::parse(volume.json())["volume"]["zones"];
    std::vector<ZoneChange> changes;
    for (std::size_t z = 0; z < zones.size(); ++z) {
        const mien_zone_volume measured = volume.zone_volume(static_cast<std::int32_t>(z));
        ZoneChange change{measured.signed_ml, measured.absolute_ml, measured.sd_ml};
        change.surface_ml = parts[z]["sd_parts_ml"]["surface"];
        change.alignment_ml = parts[z]["sd_parts_ml"]["alignment"];
        change.bias_ml = parts[z]["sd_parts_ml"]["bias"];
        if (visits != nullptr) {
            const RemovedVolume removed = visits->removed_volume(
                static_cast<std::int32_t>(first), static_cast<std::int32_t>(second), zones[z]);
            // No training set holds every way of smiling: a share of what was taken off stays open
            // beside the posterior.
            change.expression_ml =
                std::hypot(settings.posterior * removed.sd_ml, settings.share * removed.removed_ml);
            change.removed_ml = removed.removed_ml;
            change.sd_ml = std::hypot(change.sd_ml, change.expression_ml);
        }
        changes.push_back(change);
    }
    options.zones.clear();
    return {changes, Measurement::distance(session, fits[first].mesh, aligned, options), info,
            aligned};
}

const MeasureZone& find_zone(const ReportSettings& settings, const std::vector<MeasureZone>& zones,
                             const std::string& name) {
    for (const MeasureZone& zone : zones)
        if (zone.name == name) return zone;
    throw std::runtime_error(settings.zones + ": has no zone '" + name + "'");
}

/// By default, all that was not treated once a treatment is named and expressions are taken off:
/// the farther the aligned skin reaches, the less a face can tilt. Otherwise what an expression
/// moves least.
bool stable_is_untreated(const ReportSettings& settings) {
    return settings.stable.empty() && !settings.treated.empty() && !settings.expressions.empty();
}

std::vector<std::uint32_t> stable_vertices(const ReportSettings& settings,
                                           const std::vector<MeasureZone>& zones,
                                           const std::vector<std::uint32_t>& treated) {
    std::vector<std::uint32_t> stable;
    if (stable_is_untreated(settings)) {
        for (const MeasureZone& zone : zones)
            stable.insert(stable.end(), zone.vertices.begin(), zone.vertices.end());
        std::sort(stable.begin(), stable.end());
        stable.erase(std::unique(stable.begin(), stable.end()), stable.end());
        std::vector<std::uint32_t> sorted(treated), rest;
        std::sort(sorted.begin(), sorted.end());
        std::set_difference(stable.begin(), stable.end(), sorted.begin(), sorted.end(),
                            std::back_inserter(rest));
        return rest;
    }
    for (const std::string& name : split(settings.stable.empty() ? kStable : settings.stable)) {
        const auto& vertices = find_zone(settings, zones, name).vertices;
        stable.insert(stable.end(), vertices.begin(), vertices.end());
    }
    return stable;
}

void run_report(const ReportSettings& settings) {
    if (!settings.fitted && settings.model.empty())
        throw CLI::RequiredError("--model (or --fitted for meshes that are fitted already)");
    const std::vector<Visit> visits = find_visits(settings.visits);
    std::vector<MeasureZone> all_zones, zones;
    for (auto& [name, vertices] : read_zones(settings.zones))
        all_zones.push_back({name, std::move(vertices)});
    auto zone_called = [&](const std::string& name) -> const MeasureZone& {
        return find_zone(settings, all_zones, name);
    };
    std::vector<std::uint32_t> treated;
    for (const std::string& name : settings.treated) {
        const auto& vertices = zone_called(name).vertices;
        treated.insert(treated.end(), vertices.begin(), vertices.end());
    }
    if (settings.shown.empty()) zones = all_zones;
    for (const std::string& name : settings.shown) zones.push_back(zone_called(name));

    const Session session(settings.common.num_threads);
    std::unique_ptr<Model> model;
    std::unique_ptr<ExpressionModel> expressions;
    if (!settings.model.empty()) model = std::make_unique<Model>(session, settings.model);
    if (!settings.expressions.empty())
        expressions = std::make_unique<ExpressionModel>(session, settings.expressions);

    std::vector<Fitted> fits;           // all captures
    std::vector<std::size_t> first_of;  // the capture of each visit that is measured
    for (const Visit& visit : visits) {
        first_of.push_back(fits.size());
        for (const Capture& capture : visit.captures)
            fits.push_back(fit_capture(session, settings, model.get(), capture));
    }
    // A treatment does not end where its zone does: what lies beside it is no witness either.
    if (!treated.empty()) treated = with_margin(fits[0].mesh, treated, settings.margin);
    if (settings.margin > 0)
        for (const std::string& name : settings.treated)
            zones.push_back(
                {name + " and " + short_number(settings.margin) + " mm around",
                 with_margin(fits[0].mesh, zone_called(name).vertices, settings.margin)});
    const std::vector<std::uint32_t> stable = stable_vertices(settings, all_zones, treated);
    std::unique_ptr<Visits> neutral;
    if (expressions) neutral = neutralize_all(session, *expressions, treated, fits);
    // The same visit captured twice has no change in it: blanks, both ways.
    std::vector<std::vector<double>> blanks(zones.size());
    for (std::size_t k = 0; k < visits.size(); ++k) {
        const std::size_t end = first_of[k] + visits[k].captures.size();
        for (std::size_t a = first_of[k]; a < end; ++a)
            for (std::size_t b = a + 1; b < end; ++b) {
                const Pair pair =
                    compare(session, settings, fits, a, b, neutral.get(), zones, stable);
                for (std::size_t z = 0; z < zones.size(); ++z)
                    blanks[z].push_back(pair.changes[z].signed_ml);
            }
    }

    ReportPage page;
    page.title = settings.title;
    const MeshArrays framing = arrays_of(fits[0].mesh);
    std::vector<Pair> pairs;
    for (std::size_t k = 1; k < visits.size(); ++k)
        pairs.push_back(
            compare(session, settings, fits, 0, first_of[k], neutral.get(), zones, stable));
    double range = 0.5;
    for (const Pair& pair : pairs)
        range = std::max(range, pair.distance.zone_distance(MIEN_ZONE_WHOLE).p95_length_mm);
    range = std::min(range, 10.0);
    for (std::size_t z = 0; z < zones.size(); ++z) {
        page.zones.push_back(zones[z].name);
    }
    // Blank's bound and detection, 1.645 deviations each, where repeated captures do not tell.
    auto limit_ml = [&](std::size_t zone, const ZoneChange& change) {
        if (blanks[zone].size() < 2) return 2 * 1.6448536269514722 * change.sd_ml;
        return nlohmann::json::parse(
                   repeatability(session, {}, {}, blanks[zone]))["limit_of_detection"]
            .get<double>();
    };
    nlohmann::json report{
        {"title", settings.title}, {"unit", "mL"}, {"visits", nlohmann::json::array()}};
    for (std::size_t k = 0; k < visits.size(); ++k) {
        ReportVisit visit;
        visit.name = visits[k].name;
        const Fitted& fit = fits[first_of[k]];
        visit.good = fit.good;
        visit.verdict = fit.verdict;
        nlohmann::json entry{{"name", visit.name},
                             {"scan", visits[k].captures[0].mesh},
                             {"captures", visits[k].captures.size()},
                             {"registration", fit.report}};
        if (neutral)
            entry["expression"] = neutral->expression(static_cast<std::int32_t>(first_of[k]));
        const MeshArrays face = arrays_of(k == 0 ? fit.mesh : pairs[k - 1].aligned);
        visit.face = draw_face(face, framing);
        if (k > 0) {
            const Pair& pair = pairs[k - 1];
            char text[120];
            std::snprintf(text, sizeof text, "; stable zone %.2f mm apart after alignment",
                          pair.alignment.rms_mm);
            visit.verdict += text;
            visit.difference = draw_difference(
                face, pair.distance.field(MIEN_FIELD_SIGNED_DISTANCE_MM), framing, range);
            entry["alignment_rms_mm"] = pair.alignment.rms_mm;
            entry["zones"] = nlohmann::json::array();
            for (std::size_t z = 0; z < zones.size(); ++z) {
                const ZoneChange& v = pair.changes[z];
                const double limit = limit_ml(z, v);
                ReportVolume volume{v.signed_ml,
                                    v.sd_ml,
                                    v.low95_ml(),
                                    v.high95_ml(),
                                    v.absolute_ml,
                                    limit,
                                    std::fabs(v.signed_ml) < limit};
                visit.volumes.push_back(volume);
                entry["zones"].push_back({{"name", zones[z].name},
                                          {"signed_ml", v.signed_ml},
                                          {"absolute_ml", v.absolute_ml},
                                          {"sd_ml", v.sd_ml},
                                          {"sd_parts_ml",
                                           {{"surface", v.surface_ml},
                                            {"alignment", v.alignment_ml},
                                            {"bias", v.bias_ml},
                                            {"expression", v.expression_ml}}},
                                          {"expression_removed_ml", v.removed_ml},
                                          {"low95_ml", v.low95_ml()},
                                          {"high95_ml", v.high95_ml()},
                                          {"limit_of_detection_ml", limit},
                                          {"below_limit_of_detection", volume.below_limit}});
            }
        }
        page.visits.push_back(std::move(visit));
        report["visits"].push_back(entry);
    }
    page.notes = {
        settings.fitted ? "Faces were fitted beforehand."
                        : "Each scan was registered with the template of " + settings.model + ".",
        expressions
            ? "Expressions were removed with " + settings.expressions +
                  ", from all captures together; what that leaves "
                  "open widens the intervals: the fit's posterior and " +
                  short_number(100 * settings.share) +
                  " % of the volume that an expression accounted for."
            : "Expressions were not removed: the intervals hold for faces that are held alike.",
        std::string("Faces were aligned on: ") +
            (stable_is_untreated(settings) ? "all zones but the treated ones and " +
                                                 short_number(settings.margin) + " mm around them"
             : settings.stable.empty() ? std::string(kStable)
                                       : settings.stable) +
            ".",
        "Volumes are exact between corresponding triangles; zones share their edge triangles "
        "linearly.",
        "Intervals combine the deviations of both fits, alike over " +
            short_number(settings.correlation) + " mm, the alignment's and a common bias of " +
            short_number(settings.bias) + " mm.",
        !blanks.empty() && blanks[0].size() >= 2
            ? "Limits of detection come from " + std::to_string(blanks[0].size()) +
                  " pairs of captures of the same visit."
            : "Limits of detection are propagated (3.29 deviations): no visit was captured often "
              "enough to measure them."};
    report["notes"] = page.notes;
    const std::string html = report_html(page);
    write_file(settings.out, html);
    write_report(settings.common, report);
    std::printf("%s: %zu visits, %zu zones, %.0f kB\n", settings.out.c_str(), visits.size(),
                zones.size(), static_cast<double>(html.size()) / 1000);
}

}  // namespace

void add_report_commands(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("report", "one patient's visits: volumes per zone over time, as a page");
    auto settings = std::make_shared<ReportSettings>();
    command
        ->add_option("--visits", settings->visits,
                     "folder with one mesh, or folder of captures, per visit")
        ->required();
    command->add_option("--model", settings->model, "deformation model, to register the scans");
    command->add_flag("--fitted", settings->fitted, "the meshes are fitted templates already");
    command->add_option("--sd", settings->sd, "deviation of a fitted surface along its normal, mm")
        ->capture_default_str();
    command->add_option("--expressions", settings->expressions,
                        "expression model, to neutralize the faces");
    command->add_option("--zones", settings->zones, "zone file")->required();
    command->add_option("--show", settings->shown, "zones to report; default: all")->delimiter(',');
    command
        ->add_option("--treated", settings->treated,
                     "zones where the person may have changed: no witness of the expression")
        ->delimiter(',');
    command
        ->add_option("--margin", settings->margin,
                     "mm around the treated zones that are no witness either, and are reported "
                     "with them: treatments spread")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    command->add_option("--stable", settings->stable,
                        "zones to align on; default: forehead,nose, and with --expressions and "
                        "--treated all that was not treated");
    command
        ->add_option("--correlation", settings->correlation,
                     "length over which errors go together, mm")
        ->capture_default_str();
    command->add_option("--bias", settings->bias, "error common to all vertices, mm")
        ->capture_default_str();
    command
        ->add_option(
            "--expression-share", settings->share,
            "of the volume that an expression accounted for: what no training set knew of it")
        ->capture_default_str();
    command->add_option("--title", settings->title)->capture_default_str();
    command->add_option("--out", settings->out, "HTML page")->required();
    add_common_options(*command, settings->common);
    command->footer(
        "Example: mien report --visits patient --model face.safetensors --zones zones.json --out "
        "report.html");
    command->callback([settings] { run_report(*settings); });
}

}  // namespace mien::cli
