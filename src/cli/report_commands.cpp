// mien report: a patient's visits -> registration, neutralization, alignment on a stable zone,
// volumes per zone over time, as a table, as JSON and as one HTML page. The numbers are those of
// mien_study_create(); here they are arranged.
//
// A folder of visits holds one entry per visit, taken in the order of their names: a mesh file, a
// record of `mien register --record`, or a folder with one or more captures of that visit;
// landmarks lie beside a mesh as NAME.json or landmarks.json. The first capture of a visit is
// measured; the others say how repeatable it is.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render.hpp"
#include "report_fits.hpp"
#include "report_page.hpp"

namespace mien::cli {
namespace {

struct ReportSettings {
    Common common;
    std::string visits, model, expressions, zones, stable, out, title = "Volume over time";
    std::vector<std::string> shown, treated;
    bool fitted = false;
    std::optional<double> sd;
    mien_study_options study = StudyOptions().c;
};

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

/// Everything that was measured, and which of its zones are shown.
struct Measured {
    std::vector<Visit> visits;
    std::vector<Fitted> fits;           ///< all captures
    std::vector<std::size_t> first_of;  ///< the capture of each visit that is measured
    std::unique_ptr<Study> study;
    std::vector<std::int32_t> zones;  ///< of the study, in the order of the tables
    nlohmann::json told;              ///< by the study
    const nlohmann::json& recipe() const { return told["recipe"]; }
    /// Why a zone's change has no interval; empty: it has one.
    std::string unknown(std::size_t visit, std::int32_t zone) const {
        const nlohmann::json& reason =
            told["visits"][visit]["changes_since_first"][static_cast<std::size_t>(zone)]["unknown"];
        return reason.is_null() ? std::string() : reason.get<std::string>();
    }
};

/// The zones asked for, or all, then the treated ones with their margin.
std::vector<std::int32_t> shown_zones(const Study& study, const ReportSettings& settings,
                                      std::size_t num_zones) {
    std::vector<std::int32_t> shown;
    for (const std::string& name : settings.shown) {
        std::int32_t zone = 0;
        while (zone < static_cast<std::int32_t>(num_zones) && study.zone_name(zone) != name) ++zone;
        if (zone == static_cast<std::int32_t>(num_zones))
            throw std::runtime_error("no zone is called '" + name + "', which is to be shown");
        shown.push_back(zone);
    }
    const std::int32_t begin = shown.empty() ? 0 : static_cast<std::int32_t>(num_zones);
    for (std::int32_t zone = begin; zone < study.zone_count(); ++zone) shown.push_back(zone);
    return shown;
}

Measured measure(const Session& session, const ReportSettings& settings) {
    Measured result;
    result.visits = find_visits(settings.visits);
    std::unique_ptr<Model> model;
    std::unique_ptr<ExpressionModel> expressions;
    if (!settings.model.empty()) model = std::make_unique<Model>(session, settings.model);
    if (!settings.expressions.empty())
        expressions = std::make_unique<ExpressionModel>(session, settings.expressions);
    StudyOptions options;
    options.c = settings.study;
    if (settings.sd) options.c.noise_mm = *settings.sd;
    if (!settings.zones.empty())
        for (auto& [name, vertices] : read_zones(settings.zones))
            options.zones.push_back({name, std::move(vertices)});
    options.treated = settings.treated;
    options.stable = split(settings.stable);
    options.progress = progress_bar();
    std::vector<Registration> registrations;
    for (const Visit& visit : result.visits) {
        result.first_of.push_back(result.fits.size());
        for (const Capture& capture : visit.captures) {
            result.fits.push_back(settings.fitted ? read_fitted(session, capture, settings.sd)
                                                  : fit_scan(session, *model, capture));
            registrations.push_back(result.fits.back().fit);
            options.visits.push_back(static_cast<std::int32_t>(result.first_of.size()) - 1);
        }
    }
    result.study = std::make_unique<Study>(session, registrations, expressions.get(), options);
    if (result.study->zone_count() == 0)
        throw CLI::RequiredError("--zones (the fits know of no zone)");
    // Every treated zone stands a second time at the end, unless it has no margin.
    const std::size_t around = options.c.margin_mm > 0 ? settings.treated.size() : 0;
    result.zones = shown_zones(*result.study, settings,
                               static_cast<std::size_t>(result.study->zone_count()) - around);
    result.told = nlohmann::json::parse(result.study->json());
    return result;
}

nlohmann::json number(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json zone_entry(const std::string& name, const mien_study_change& v) {
    nlohmann::json entry{{"name", name},
                         {"signed_ml", number(v.signed_ml.value)},
                         {"absolute_ml", number(v.absolute_ml.value)},
                         {"sd_ml", number(v.signed_ml.sd)},
                         {"sd_parts_ml",
                          {{"surface", number(v.surface_sd_ml)},
                           {"alignment", number(v.alignment_sd_ml)},
                           {"bias", number(v.bias_sd_ml)},
                           {"expression", number(v.expression_sd_ml)}}},
                         {"expression_removed_ml", v.expression_removed_ml},
                         {"low95_ml", number(v.signed_ml.low)},
                         {"high95_ml", number(v.signed_ml.high)},
                         {"limit_of_detection_ml", number(v.signed_ml.limit_of_detection)},
                         {"seen_share", number(v.seen_share)}};
    entry["below_limit_of_detection"] =
        v.detected < 0 ? nlohmann::json() : nlohmann::json(v.detected == 0);
    const struct {
        const char* name;
        const mien_study_value& value;
    } others[] = {{"gained_ml", v.gained_ml},
                  {"lost_ml", v.lost_ml},
                  {"absolute_ml", v.absolute_ml},
                  {"area_change_mm2", v.area_change_mm2},
                  {"mean_distance_mm", v.mean_distance_mm}};
    for (const auto& other : others)
        entry["more"][other.name] = {
            {"value", number(other.value.value)},
            {"sd", number(other.value.sd)},
            {"low95", number(other.value.low)},
            {"high95", number(other.value.high)},
            {"limit_of_detection", number(other.value.limit_of_detection)}};
    return entry;
}

ReportVolume page_volume(const mien_study_change& v, const std::string& unknown) {
    return {v.signed_ml.value,   v.signed_ml.sd,
            v.signed_ml.low,     v.signed_ml.high,
            v.absolute_ml.value, v.signed_ml.limit_of_detection,
            v.detected == 0,     unknown};
}

std::string expression_in_words(const std::string& name) {
    return name.empty() || name == "neutral" ? "; no expression"
           : name == "any"                   ? "; an expression without a name taken off"
                                             : "; expression taken off: " + name;
}

std::vector<std::string> notes_of(const ReportSettings& settings, const Measured& m) {
    std::string stable;
    for (const auto& name : m.recipe()["stable"])
        stable += (stable.empty() ? "" : ",") + name.get<std::string>();
    if (m.recipe()["stable_is_untreated"])
        stable = "all zones but the treated ones and " + short_number(m.recipe()["margin_mm"]) +
                 " mm around them";
    const int blanks = m.recipe()["blanks"];
    return {
        settings.fitted ? "Faces were fitted beforehand."
                        : "Each scan was registered with the template of " + settings.model + ".",
        m.recipe()["expressions_removed"]
            ? "Expressions were removed with " + settings.expressions +
                  ", from all captures together; what that leaves open widens the intervals: the "
                  "fit's posterior and " +
                  short_number(100 * m.recipe()["untrained_share"].get<double>()) +
                  " % of the volume that an expression accounted for."
            : "Expressions were not removed: the intervals hold for faces that are held alike.",
        "Faces were aligned on: " + (stable.empty() ? std::string("the whole face") : stable) + ".",
        std::string("Volumes are exact between corresponding triangles; zones share their edge "
                    "triangles linearly."),
        "Intervals combine the deviations of both fits, alike over " +
            short_number(m.recipe()["correlation_length_mm"]) +
            " mm, the alignment's and a common bias of " +
            short_number(m.recipe()["common_bias_mm"]) +
            " mm. Where the errors of a fit are not known, or too little of a zone was seen, "
            "none is given.",
        blanks >= 2
            ? "Limits of detection come from " + std::to_string(blanks) +
                  " pairs of captures of the same visit."
            : "Limits of detection are propagated from the deviations: no visit was captured often "
              "enough to measure them."};
}

/// Faces and differences of the visits, drawn alike.
struct Pictures {
    Pictures(const Session& session, const Measured& m)
        : framing(arrays_of(m.fits[0].fit.mesh())), range(0.5) {
        const Mesh first = m.study->neutral(0);
        faces.push_back(first);
        differences.emplace_back();
        for (std::int32_t k = 1; k < m.study->visit_count(); ++k) {
            faces.push_back(m.study->neutral(k, 0));
            const Measurement distance = Measurement::distance(session, first, faces.back());
            differences.push_back(distance.field(MIEN_FIELD_SIGNED_DISTANCE_MM));
            range = std::max(range, distance.zone_distance(MIEN_ZONE_WHOLE).p95_length_mm);
        }
        range = std::min(range, 10.0);
    }
    MeshArrays framing;
    double range;  ///< of the colours, mm
    std::vector<Mesh> faces;
    std::vector<std::vector<double>> differences;
};

void print_table(const Measured& m) {
    for (std::int32_t k = 1; k < m.study->visit_count(); ++k)
        for (const std::int32_t zone : m.zones) {
            const mien_study_value v = m.study->change(0, k, zone).signed_ml;
            std::printf("%d %-24s %11.6f %11.6f %11.6f %11.6f\n", static_cast<int>(k),
                        m.study->zone_name(zone).c_str(), v.value, v.low, v.high,
                        v.limit_of_detection);
        }
}

/// The report as JSON, and the page's visits beside it.
nlohmann::json describe(const Session& session, const ReportSettings& settings, const Measured& m,
                        ReportPage& page) {
    nlohmann::json report{
        {"title", settings.title}, {"unit", "mL"}, {"visits", nlohmann::json::array()}};
    const Pictures pictures(session, m);
    for (std::size_t k = 0; k < m.visits.size(); ++k) {
        const auto number_of = static_cast<std::int32_t>(k);
        const Fitted& fit = m.fits[m.first_of[k]];
        ReportVisit visit;
        visit.name = m.visits[k].name;
        visit.good = fit.good;
        visit.verdict = fit.verdict;
        nlohmann::json entry{{"name", visit.name},
                             {"scan", m.visits[k].captures[0].mesh},
                             {"captures", m.visits[k].captures.size()},
                             {"registration", fit.report}};
        if (m.recipe()["expressions_removed"]) {
            entry["expression"] = m.study->expression(number_of);
            visit.verdict += expression_in_words(m.study->expression(number_of));
        }
        const MeshArrays face = arrays_of(pictures.faces[k]);
        visit.face = draw_face(face, pictures.framing);
        if (k > 0) {
            const double rms_mm = m.study->alignment(0, number_of).rms_mm;
            char text[120];
            std::snprintf(text, sizeof text, "; stable zone %.2f mm apart after alignment", rms_mm);
            visit.verdict += text;
            visit.difference =
                draw_difference(face, pictures.differences[k], pictures.framing, pictures.range);
            entry["alignment_rms_mm"] = rms_mm;
            entry["zones"] = nlohmann::json::array();
            for (const std::int32_t zone : m.zones) {
                const mien_study_change change = m.study->change(0, number_of, zone);
                visit.volumes.push_back(page_volume(change, m.unknown(k, zone)));
                entry["zones"].push_back(zone_entry(m.study->zone_name(zone), change));
                entry["zones"].back()["unknown"] = m.unknown(k, zone);
            }
        }
        page.visits.push_back(std::move(visit));
        report["visits"].push_back(entry);
    }
    return report;
}

void run_report(const ReportSettings& settings) {
    if (!settings.fitted && settings.model.empty())
        throw CLI::RequiredError("--model (or --fitted for meshes that are fitted already)");
    const Session session(settings.common.num_threads);
    const Measured measured = measure(session, settings);
    ReportPage page;
    page.title = settings.title;
    for (const std::int32_t zone : measured.zones)
        page.zones.push_back(measured.study->zone_name(zone));
    nlohmann::json report = describe(session, settings, measured, page);
    page.notes = notes_of(settings, measured);
    report["notes"] = page.notes;
    report["study"] = measured.told;
    const std::string html = report_html(page);
    write_file(settings.out, html);
    write_report(settings.common, report);
    print_table(measured);
    std::printf("%s: %zu visits, %zu zones, %.0f kB\n", settings.out.c_str(),
                measured.visits.size(), measured.zones.size(),
                static_cast<double>(html.size()) / 1000);
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
    command->add_option("--sd", settings->sd,
                        "deviation of a fitted surface along its normal where it was seen, mm; "
                        "default: 0.08 for fits with a record or JSON, not known for bare meshes");
    command->add_option("--expressions", settings->expressions,
                        "expression model, to neutralize the faces");
    command->add_option("--zones", settings->zones, "zone file; default: the zones of the model");
    command->add_option("--show", settings->shown, "zones to report; default: all")->delimiter(',');
    command
        ->add_option("--treated", settings->treated,
                     "zones where the person may have changed: no witness of the expression")
        ->delimiter(',');
    command
        ->add_option("--margin", settings->study.margin_mm,
                     "mm around the treated zones that are no witness either, and are reported "
                     "with them: treatments spread")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    command->add_option("--stable", settings->stable,
                        "zones to align on; default: forehead,nose, and with --expressions and "
                        "--treated all that was not treated");
    command
        ->add_option("--correlation", settings->study.correlation_length_mm,
                     "length over which errors go together, mm")
        ->capture_default_str();
    command
        ->add_option("--bias", settings->study.common_bias_mm, "error common to all vertices, mm")
        ->capture_default_str();
    command
        ->add_option(
            "--expression-share", settings->study.untrained_share,
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
