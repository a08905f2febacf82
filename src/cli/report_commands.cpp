// mien report: a patient's visits -> registration, neutralization, alignment on a stable zone,
// volumes per zone over time, as a table, as JSON and as one HTML page. The numbers are those of
// mien_study_create(); here they are arranged.
//
// A folder of visits holds one entry per visit, taken in the order of their names: a mesh file, a
// record of `mien register --record`, or a folder with one or more captures of that visit;
// landmarks lie beside a mesh as NAME.json or landmarks.json. The first capture of a visit is
// measured; the others say how repeatable it is. patient.json in the folder, visit.json in a
// visit's folder and NAME.visit.json beside a mesh hold what the page tells of them.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "face_checks.hpp"
#include "report_fits.hpp"
#include "report_page.hpp"
#include "report_pictures.hpp"

namespace mien::cli {
namespace {

struct ReportSettings {
    Common common;
    std::string visits, model, expressions, zones, stable, out, title, patient, language = "en";
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

/// Everything that was measured, and which of its zones are shown.
struct Measured {
    std::vector<Visit> visits;
    std::vector<Fitted> fits;           ///< all captures
    std::vector<std::size_t> first_of;  ///< the capture of each visit that is measured
    std::unique_ptr<Study> study;
    std::vector<std::vector<std::uint32_t>> treated;  ///< vertices of the treated zones
    std::vector<std::int32_t> zones;                  ///< of the study, in the order of the tables
    nlohmann::json told;                              ///< by the study
    std::vector<std::vector<std::string>> warnings;   ///< of each visit's fit
    std::vector<std::vector<std::string>> doubts;     ///< of each visit against the first
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

/// The zones' vertices, as far as they are known: records name their zones alone.
std::vector<std::vector<std::uint32_t>> zones_called(const std::vector<std::string>& names,
                                                     const StudyOptions& options,
                                                     const Model* model) {
    std::vector<std::vector<std::uint32_t>> found;
    std::vector<ModelZone> zones;
    for (const MeasureZone& zone : options.zones) zones.push_back({zone.name, zone.vertices});
    if (zones.empty() && model != nullptr) zones = Zones::of(*model).all();
    for (const ModelZone& zone : zones)
        if (std::find(names.begin(), names.end(), zone.name) != names.end())
            found.push_back(zone.vertices);
    return found;
}

/// 1 for skin that the first visit and another saw and that neither an expression nor a treatment
/// makes larger: the zones that faces are aligned on by default or by name, without treated ones.
std::vector<char> skin_of_one_size(const Study& study, std::int32_t visit, std::size_t num_vertices,
                                   const std::vector<std::vector<std::uint32_t>>& stable,
                                   const std::vector<std::vector<std::uint32_t>>& treated) {
    constexpr double kSeen = 0.5;  // of a weight in [0, 1]
    const std::vector<double> before = field_or_none(study, 0, MIEN_STUDY_FIELD_WEIGHT),
                              after = field_or_none(study, visit, MIEN_STUDY_FIELD_WEIGHT);
    const auto seen = [&](const std::vector<double>& weights, std::uint32_t v) {
        return weights.empty() || weights[v] >= kSeen;
    };
    std::vector<char> counts(num_vertices);
    for (const std::vector<std::uint32_t>& zone : stable)
        for (const std::uint32_t v : zone)
            if (v < num_vertices) counts[v] = seen(before, v) && seen(after, v) ? 1 : 0;
    for (const std::vector<std::uint32_t>& zone : treated)
        for (const std::uint32_t v : zone)
            if (v < num_vertices) counts[v] = 0;
    return counts;
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
            result.fits.push_back(settings.fitted
                                      ? read_fitted(session, capture, visit.file, settings.sd)
                                      : fit_scan(session, *model, capture, visit.file));
            registrations.push_back(result.fits.back().fit);
            options.visits.push_back(static_cast<std::int32_t>(result.first_of.size()) - 1);
        }
    }
    const auto mesh_of = [&](std::size_t visit) {
        return result.fits[result.first_of[visit]].fit.mesh();
    };
    const Mesh first = mesh_of(0);
    warn_of_unit(session, {first, result.visits[0].name});
    for (std::size_t k = 1; k < result.visits.size(); ++k) check_same_unit(first, mesh_of(k));
    result.study = std::make_unique<Study>(session, registrations, expressions.get(), options);
    result.treated = zones_called(settings.treated, options, model.get());
    const auto stable = zones_called(
        options.stable.empty() ? std::vector<std::string>{"forehead", "nose"} : options.stable,
        options, model.get());
    for (std::size_t k = 0; k < result.visits.size(); ++k) {
        result.warnings.push_back(result.fits[result.first_of[k]].warnings);
        result.doubts.emplace_back();
        if (k == 0) continue;
        const auto visit = static_cast<std::int32_t>(k);
        const VisitPair pair{result.study->alignment(0, visit).rms_mm,
                             size_ratio(first, mesh_of(k),
                                        skin_of_one_size(*result.study, visit, first.vertex_count(),
                                                         stable, result.treated))};
        result.doubts.back() = check_visits(session, {first, result.visits[0].name},
                                            {mesh_of(k), result.visits[k].name}, pair);
    }
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
    return {v.signed_ml.value, v.signed_ml.sd,      v.signed_ml.low,
            v.signed_ml.high,  v.absolute_ml.value, v.signed_ml.limit_of_detection,
            v.detected == 0,   v.detected == 1,     unknown};
}

std::string expression_in_words(const Words& words, const std::string& name) {
    return name.empty() || name == "neutral" ? words("no_expression")
           : name == "any"                   ? words("unnamed_expression")
                                             : words("expression_off", {name});
}

/// How well a visit was fitted, in one line.
std::string verdict_in_words(const Words& words, const Fitted& fitted) {
    const mien_fit_verdict verdict = fitted.fit.verdict();
    const std::string quality = words(verdict.quality == MIEN_QUALITY_GOOD       ? "good"
                                      : verdict.quality == MIEN_QUALITY_DOUBTFUL ? "doubtful"
                                                                                 : "failed");
    if (!fitted.judged) return words("fitted_beforehand");
    if (!fitted.report.is_object() || !fitted.report.contains("coverage"))
        return words("fitted_beforehand") + "; " + quality;
    std::string text = quality + ": " +
                       words("fit_numbers", {words.number(verdict.mean_residual_mm, 2),
                                             words.number(100 * verdict.coverage, 0)});
    const nlohmann::json& errors = fitted.report.value("expected_error", nlohmann::json::object());
    if (errors.contains("face")) {
        const nlohmann::json& face = errors["face"];
        text += "; " + words("expected", {words.number(face["expected_mm"].get<double>(), 1),
                                          words.number(face["low_mm"].get<double>(), 1),
                                          words.number(face["high_mm"].get<double>(), 1)});
    }
    return text;
}

std::vector<std::string> notes_of(const Words& words, const ReportSettings& settings,
                                  const Measured& m) {
    const nlohmann::json& recipe = m.recipe();
    std::string stable;
    for (const auto& name : recipe["stable"])
        stable += (stable.empty() ? "" : ", ") + words.zone(name.get<std::string>());
    if (recipe["stable_is_untreated"])
        stable = words("all_untreated", {short_number(recipe["margin_mm"])});
    if (stable.empty()) stable = words("whole_face");
    const int blanks = recipe["blanks"];
    const auto number = [&](const char* key, double factor = 1) {
        return words.number(short_number(factor * recipe[key].get<double>()));
    };
    return {settings.fitted ? words("how_fitted") : words("how_registered", {settings.model}),
            recipe["expressions_removed"]
                ? words("how_expressions", {settings.expressions, number("untrained_share", 100)})
                : words("how_no_expressions"),
            words("how_aligned", {stable}),
            words("how_volumes"),
            words("how_intervals", {number("correlation_length_mm"), number("common_bias_mm")}),
            blanks >= 2 ? words("how_limits", {std::to_string(blanks)})
                        : words("how_limits_propagated"),
            words("how_colors")};
}

/// What the numbers were made with: enough to make them again.
ReportFields made_with(const Session& session, const Words& words, const ReportSettings& settings) {
    ReportFields rows{{words("software"), mien_build_id()}};
    const auto add = [&](const char* name, const std::string& path) {
        if (path.empty()) return;
        rows.emplace_back(words(name), path);
        rows.emplace_back(words("sha256"), session.hash_file(path));
    };
    add("model", settings.model);
    add("expression_model", settings.expressions);
    return rows;
}

void print_table(const Measured& m) {
    for (std::int32_t k = 1; k < m.study->visit_count(); ++k)
        for (const std::int32_t zone : m.zones) {
            const mien_study_value v = m.study->change(0, k, zone).signed_ml;
            std::printf("%d %-24s %11.6f %11.6f %11.6f %11.6f\n", static_cast<int>(k),
                        m.study->zone_name(zone).c_str(), v.value, v.low, v.high,
                        v.limit_of_detection);
        }
}

/// What the page shows of one visit besides its numbers.
ReportVisit visit_page(const Session& session, const Words& words, const Measured& m,
                       const ReportPictures& pictures, std::size_t k) {
    const auto number = static_cast<std::int32_t>(k);
    const Fitted& fit = m.fits[m.first_of[k]];
    const Visit& given = m.visits[k];
    ReportVisit visit;
    visit.name = given.shown();
    visit.date = given.file.date;
    visit.fields = given.file.fields;
    visit.good = fit.good();
    visit.reasons = fit.reasons();
    visit.reasons.insert(visit.reasons.end(), m.warnings[k].begin(), m.warnings[k].end());
    visit.reasons.insert(visit.reasons.end(), m.doubts[k].begin(), m.doubts[k].end());
    visit.doubts = m.doubts[k];
    const double unit_mm = fit.report.is_object() ? fit.report.value("unit_to_mm", 1.0) : 1.0;
    if (unit_mm != 1)
        visit.reasons.push_back(words("unit_taken", {words.number(short_number(unit_mm))}));
    visit.verdict = verdict_in_words(words, fit);
    if (given.captures.size() > 1)
        visit.verdict += "; " + words("captures", {std::to_string(given.captures.size())});
    if (m.recipe()["expressions_removed"])
        visit.verdict += "; " + expression_in_words(words, m.study->expression(number));
    if (k > 0)
        visit.verdict +=
            "; " + words("stable_apart", {words.number(m.study->alignment(0, number).rms_mm, 2)});
    visit.scan = pictures.scan(session, k);
    visit.face = pictures.face(k);
    if (k > 0) visit.change = pictures.change(k);
    return visit;
}

/// The report as JSON, and the page's visits beside it.
nlohmann::json describe(const Session& session, const Measured& m, ReportPage& page) {
    nlohmann::json report{{"title", valid_utf8(page.title)},
                          {"unit", "mL"},
                          {"language", page.words.language()},
                          {"visits", nlohmann::json::array()}};
    std::vector<const Fitted*> fits;
    for (const std::size_t at : m.first_of) fits.push_back(&m.fits[at]);
    const ReportPictures pictures(*m.study, fits,
                                  zone_rims(fits.front()->fit.mesh().triangles(), m.treated));
    page.range_mm = pictures.range_mm();
    page.errors_known = pictures.errors_known();
    page.outlined = !m.treated.empty();
    std::vector<std::string> names;
    for (std::size_t k = 0; k < m.visits.size(); ++k) {
        const auto number = static_cast<std::int32_t>(k);
        page.visits.push_back(visit_page(session, page.words, m, pictures, k));
        ReportVisit& visit = page.visits.back();
        names.push_back(visit.name);
        const Capture& capture = m.visits[k].captures[0];
        nlohmann::json entry{{"name", m.visits[k].name},
                             {"date", visit.date},
                             {"scan", valid_utf8(capture.mesh)},
                             {"scan_sha256", session.hash_file(capture.mesh)},
                             {"captures", m.visits[k].captures.size()},
                             {"registration", fits[k]->report},
                             {"warnings", nlohmann::json::array()}};
        for (const auto* list : {&m.warnings[k], &m.doubts[k]})
            for (const std::string& warning : *list)
                entry["warnings"].push_back(valid_utf8(warning));
        if (m.recipe()["expressions_removed"]) entry["expression"] = m.study->expression(number);
        if (k > 0) {
            entry["alignment_rms_mm"] = m.study->alignment(0, number).rms_mm;
            entry["zones"] = nlohmann::json::array();
            for (const std::int32_t zone : m.zones) {
                const mien_study_change change = m.study->change(0, number, zone);
                visit.volumes.push_back(page_volume(change, m.unknown(k, zone)));
                entry["zones"].push_back(zone_entry(m.study->zone_name(zone), change));
                entry["zones"].back()["unknown"] = m.unknown(k, zone);
            }
        }
        report["visits"].push_back(entry);
    }
    page.view = pictures.view(page.words, names);
    return report;
}

void run_report(const ReportSettings& settings) {
    if (!settings.fitted && settings.model.empty())
        throw CLI::RequiredError("--model (or --fitted for meshes that are fitted already)");
    const Session session(settings.common.num_threads);
    ReportPage page(settings.language);
    page.title = settings.title.empty() ? page.words("title") : settings.title;
    const std::string patient =
        settings.patient.empty() ? patient_file(settings.visits) : settings.patient;
    if (!patient.empty()) page.patient = read_patient(patient);
    const Measured measured = measure(session, settings);
    for (const std::int32_t zone : measured.zones)
        page.zones.push_back(page.words.zone(measured.study->zone_name(zone)));
    for (const std::string& zone : settings.treated) page.treated.push_back(page.words.zone(zone));
    nlohmann::json report = describe(session, measured, page);
    page.notes = notes_of(page.words, settings, measured);
    page.made_with = made_with(session, page.words, settings);
    for (const std::string& note : page.notes) report["notes"].push_back(valid_utf8(note));
    report["software"] = mien_build_id();
    for (const auto& [key, path] :
         {std::pair{"model", settings.model}, std::pair{"expression_model", settings.expressions}})
        if (!path.empty())
            report[key] = {{"file", valid_utf8(path)}, {"sha256", session.hash_file(path)}};
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
    command->add_flag("--unseen", settings->study.measure_unseen,
                      "measure what no scan saw too, as fits guess it: walls in nostrils, lips and "
                      "lids, skin unseen in every visit");
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
    command->add_option("--title", settings->title, "default: Volume over time");
    command->add_option("--patient", settings->patient,
                        "JSON {\"name\": ..., \"born\": ..., any others}; default: patient.json "
                        "in the folder of visits");
    command->add_option("--language", settings->language, "of the page")
        ->check(CLI::IsMember(report_languages()))
        ->capture_default_str();
    command->add_option("--out", settings->out, "HTML page")->required();
    add_common_options(*command, settings->common);
    command->footer(
        "Example: mien report --visits patient --model face.safetensors --zones zones.json --out "
        "report.html\n"
        "A visit's date is in its name (2026-03-14 before) or in visit.json: {\"date\": "
        "\"2026-03-14\", \"label\": ..., \"scan\": ..., any others}.");
    command->callback([settings] { run_report(*settings); });
}

}  // namespace mien::cli
