// mien measure volume|area|distance|curvature|length (anthropometry, norms and asymmetry:
// anthropometry_commands.cpp): faces in, numbers per zone out, as a table
// and as JSON.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "face_checks.hpp"
#include "measure_faces.hpp"

namespace mien::cli {
namespace {

struct MeasureSettings {
    Common common;
    std::string before, after, before_json, after_json, mesh, zones, field_path, carry, stable,
        field = "mean", landmarks;
    std::vector<double> direction;
    std::vector<std::string> between;
    double radius = 6;
    bool not_robust = false;
    std::optional<double> sd_before, sd_after;
    double correlation = MeasureOptions().correlation_length_mm;
    double bias = 0, limit = 0, max_distance = 0;
    bool surfaces = false, keep_borders = false, closed = false, close_rims = false;
};

MeasureOptions options_of(const MeasureSettings& settings) {
    MeasureOptions options;
    options.zones = measure_zones(settings.zones);
    options.correlation_length_mm = settings.correlation;
    options.common_bias_mm = settings.bias;
    options.limit_of_detection_ml = settings.limit;
    options.max_distance_mm = settings.max_distance;
    options.skip_borders = !settings.keep_borders;
    options.progress = progress_bar();
    return options;
}

void print_volume_row(const std::string& name, const mien_zone_volume& v) {
    std::printf("%-16.16s %9.3f %9.3f %9.3f %9.3f", name.c_str(), v.signed_ml, v.positive_ml,
                v.negative_ml, v.absolute_ml);
    if (std::isfinite(v.sd_ml)) std::printf("   %8.3f .. %8.3f", v.low95_ml, v.high95_ml);
    if (v.detected == 0) std::printf("   below the limit of detection");
    std::printf("\n");
}

void print_volumes(const Measurement& result, const std::vector<MeasureZone>& zones) {
    std::printf("%-16s %9s %9s %9s %9s   mL\n", "zone", "signed", "gained", "lost", "absolute");
    for (std::size_t z = 0; z < result.zone_count(); ++z)
        print_volume_row(zones[z].name, result.zone_volume(static_cast<std::int32_t>(z)));
    if (result.zone_count() != 0) print_volume_row("rest", result.zone_volume(MIEN_ZONE_REST));
    print_volume_row("whole", result.zone_volume(MIEN_ZONE_WHOLE));
}

/// Two surfaces that no template joins, two scans: aligned on a zone of the first where asked, then
/// measured.
void run_scan_volume(const MeasureSettings& settings) {
    if (settings.carry == "direction" && settings.direction.size() != 3)
        throw CLI::RequiredError("--direction (three numbers) with --surfaces direction");
    const Session session(settings.common.num_threads);
    const Mesh before(session, settings.before);
    Mesh after(session, settings.after);
    expect_outside_out(session, {before, settings.before});
    warn_of_unit(session, {before, settings.before});
    const MeasureOptions options = options_of(settings);
    nlohmann::json alignment;
    if (!settings.stable.empty()) {
        std::vector<std::uint32_t> stable;
        for (const MeasureZone& zone : options.zones)
            if (zone.name == settings.stable) stable = zone.vertices;
        if (stable.empty())
            throw std::runtime_error(settings.zones + ": has no zone '" + settings.stable +
                                     "' to align on");
        mien_zone_alignment info{};
        after = align_on_zone(session, after, before, stable, &info);
        alignment = {{"zone", settings.stable}, {"rms_mm", info.rms_mm}, {"matrix", info.matrix}};
    }
    const std::int32_t carry = settings.carry == "direction" ? MIEN_CARRY_DIRECTION
                               : settings.carry == "normal"  ? MIEN_CARRY_VERTEX_NORMAL
                                                             : MIEN_CARRY_CLOSEST_POINT;
    Position direction{{0, 0, 1}};
    if (settings.direction.size() == 3)
        direction = {{settings.direction[0], settings.direction[1], settings.direction[2]}};
    double coverage = 0;
    const Measurement result =
        Measurement::scan_volume(session, before, after, carry, direction, options, &coverage);
    print_volumes(result, options.zones);
    std::printf("%.1f %% of the first surface has something opposite it\n", 100 * coverage);
    nlohmann::json report = nlohmann::json::parse(result.json());
    report["before"] = settings.before;
    report["after"] = settings.after;
    report["surfaces"] = settings.carry;
    report["coverage"] = coverage;
    if (!alignment.is_null()) report["alignment"] = alignment;
    write_report(settings.common, report);
}

void run_volume(const MeasureSettings& settings) {
    if (!settings.carry.empty()) return run_scan_volume(settings);
    const Session session(settings.common.num_threads);
    const KnownFace before =
        read_known_face(session, settings.before, settings.before_json, settings.sd_before);
    KnownFace after =
        read_known_face(session, settings.after, settings.after_json, settings.sd_after);
    expect_same_triangles({before.mesh, settings.before}, {after.mesh, settings.after});
    expect_outside_out(session, {before.mesh, settings.before});
    warn_of_unit(session, {before.mesh, settings.before});
    MeasureOptions options = options_of(settings);
    nlohmann::json alignment;
    if (!settings.stable.empty()) {
        mien_zone_alignment info{};
        after.mesh = align_on_zone(session, after.mesh, before.mesh,
                                   zone_vertices(settings.zones, settings.stable), &info);
        options.alignment_rotation_sd_rad = info.rotation_sd_rad;
        options.alignment_translation_sd_mm = info.translation_sd_mm;
        options.alignment_centre = {{info.centre[0], info.centre[1], info.centre[2]}};
        alignment = {{"zone", settings.stable}, {"rms_mm", info.rms_mm}, {"matrix", info.matrix}};
    }
    const std::vector<std::string> warnings =
        warn_of_frames(session, {before.mesh, settings.before}, {after.mesh, settings.after},
                       !settings.stable.empty());
    // An interval from a part of the errors would promise too much.
    const bool known = !before.sd_mm.empty() && !after.sd_mm.empty();
    if (known) {
        options.before_sd_mm = before.sd_mm;
        options.after_sd_mm = after.sd_mm;
    } else {
        options.common_bias_mm = options.alignment_rotation_sd_rad =
            options.alignment_translation_sd_mm = 0;
    }
    const Measurement result = Measurement::volume(session, before.mesh, after.mesh, options);
    print_volumes(result, options.zones);
    if (!known) std::puts("no interval: the surfaces' errors are unknown");
    nlohmann::json report = nlohmann::json::parse(result.json());
    report["before"] = settings.before;
    report["after"] = settings.after;
    report["warnings"] = warnings;
    if (!alignment.is_null()) report["alignment"] = alignment;
    write_report(settings.common, report);
}

void run_distance(const MeasureSettings& settings) {
    const Session session(settings.common.num_threads);
    const Mesh before(session, settings.before), after(session, settings.after);
    const NamedFace first{before, settings.before}, second{after, settings.after};
    expect_outside_out(session, first);
    warn_of_unit(session, first);
    std::vector<std::string> warnings;
    if (!settings.surfaces) {
        expect_same_triangles(first, second);
        warnings = warn_of_frames(session, first, second, false);
    }
    const MeasureOptions options = options_of(settings);
    const Measurement result = settings.surfaces
                                   ? Measurement::surface_distance(session, before, after, options)
                                   : Measurement::distance(session, before, after, options);
    std::printf("%-16s %8s %8s %8s %8s %8s %8s   mm\n", "zone", "signed", "absolute", "rms",
                "median", "95 %", "max");
    auto row = [&](const std::string& name, std::int32_t zone) {
        const mien_zone_distance d = result.zone_distance(zone);
        std::printf("%-16.16s %8.3f %8.3f %8.3f %8.3f %8.3f %8.3f\n", name.c_str(),
                    d.mean_signed_mm, d.mean_absolute_mm, d.rms_mm, d.median_length_mm,
                    d.p95_length_mm, d.max_length_mm);
    };
    for (std::size_t z = 0; z < result.zone_count(); ++z)
        row(options.zones[z].name, static_cast<std::int32_t>(z));
    row("whole", MIEN_ZONE_WHOLE);
    if (!settings.field_path.empty())
        write_field(settings.field_path, result.field(MIEN_FIELD_SIGNED_DISTANCE_MM));
    nlohmann::json report = nlohmann::json::parse(result.json());
    report["before"] = settings.before;
    report["after"] = settings.after;
    report["warnings"] = warnings;
    write_report(settings.common, report);
}

/// Area of one mesh, whole and per zone, and what it encloses where asked.
nlohmann::json areas_of(const Session& session, const MeasureSettings& settings, const Mesh& mesh) {
    nlohmann::json areas{{"area_mm2", area_mm2(session, mesh)}, {"zones", nlohmann::json::array()}};
    for (const MeasureZone& zone : measure_zones(settings.zones))
        areas["zones"].push_back(
            {{"name", zone.name}, {"area_mm2", area_mm2(session, mesh, zone)}});
    if (settings.closed || settings.close_rims)
        areas["closed_volume_ml"] = closed_volume_ml(session, mesh, settings.close_rims);
    return areas;
}

void run_area_change(const MeasureSettings& settings) {
    const Session session(settings.common.num_threads);
    const Mesh first(session, settings.before), second(session, settings.after);
    warn_of_unit(session, {first, settings.before});
    warn_of_unit(session, {second, settings.after});
    nlohmann::json before = areas_of(session, settings, first);
    nlohmann::json after = areas_of(session, settings, second);
    std::printf("%-16s %12s %12s %10s   mm^2\n", "zone", "before", "after", "change");
    auto row = [](const std::string& name, double a, double b) {
        std::printf("%-16.16s %12.2f %12.2f %9.2f%%\n", name.c_str(), a, b, 100 * (b - a) / a);
    };
    for (std::size_t z = 0; z < before["zones"].size(); ++z)
        row(before["zones"][z]["name"], before["zones"][z]["area_mm2"],
            after["zones"][z]["area_mm2"]);
    row("whole", before["area_mm2"], after["area_mm2"]);
    before["mesh"] = settings.before;
    after["mesh"] = settings.after;
    write_report(settings.common, {{"before", before}, {"after", after}});
}

void run_area(const MeasureSettings& settings) {
    if (settings.mesh.empty() == (settings.before.empty() || settings.after.empty()))
        throw CLI::ValidationError("measure area", "give one mesh, or --before and --after");
    if (settings.mesh.empty()) return run_area_change(settings);
    const Session session(settings.common.num_threads);
    const Mesh mesh(session, settings.mesh);
    warn_of_unit(session, {mesh, settings.mesh});
    nlohmann::json report = areas_of(session, settings, mesh);
    for (const nlohmann::json& zone : report["zones"])
        std::printf("%-16.16s %12.2f mm^2\n", zone["name"].get<std::string>().c_str(),
                    zone["area_mm2"].get<double>());
    std::printf("%-16s %12.2f mm^2\n", "whole", report["area_mm2"].get<double>());
    if (report.contains("closed_volume_ml"))
        std::printf("%-16s %12.4f mL\n", "enclosed", report["closed_volume_ml"].get<double>());
    report["mesh"] = settings.mesh;
    write_report(settings.common, report);
}

void run_curvature(const MeasureSettings& settings) {
    const Session session(settings.common.num_threads);
    const Mesh mesh(session, settings.mesh);
    warn_of_unit(session, {mesh, settings.mesh});
    const Measurement result = Measurement::curvature(session, mesh, settings.radius,
                                                      !settings.not_robust, options_of(settings));
    nlohmann::json report = nlohmann::json::parse(result.json());
    std::printf("%-16s %10s %10s %10s %12s\n", "zone", "mean 1/mm", "k1 1/mm", "k2 1/mm",
                "Gauss 1/mm^2");
    const auto row = [](const nlohmann::json& zone) {
        std::printf(
            "%-16.16s %10.5f %10.5f %10.5f %12.7f\n", zone["name"].get<std::string>().c_str(),
            zone["mean_mean_per_mm"].get<double>(), zone["mean_maximal_per_mm"].get<double>(),
            zone["mean_minimal_per_mm"].get<double>(), zone["mean_gaussian_per_mm2"].get<double>());
    };
    for (const nlohmann::json& zone : report["curvature"]["zones"]) row(zone);
    row(report["curvature"]["whole"]);
    if (!settings.field_path.empty())
        write_field(settings.field_path,
                    result.field(settings.field == "maximal"    ? MIEN_FIELD_CURVATURE_MAXIMAL
                                 : settings.field == "minimal"  ? MIEN_FIELD_CURVATURE_MINIMAL
                                 : settings.field == "gaussian" ? MIEN_FIELD_CURVATURE_GAUSSIAN
                                                                : MIEN_FIELD_CURVATURE_MEAN));
    report["mesh"] = settings.mesh;
    report["radius_mm"] = settings.radius;
    write_report(settings.common, report);
}

/// Lengths between landmarks of a template, which every face in its topology has.
void run_length(const MeasureSettings& settings) {
    if (settings.between.size() % 2 != 0)
        throw CLI::ValidationError("--between", "names come in pairs: A,B or A,B,C,D");
    const std::vector<std::pair<std::string, std::uint32_t>> marks =
        read_landmark_vertices(settings.landmarks);
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (std::size_t k = 0; k < settings.between.size(); ++k) {
        const auto found = std::find_if(marks.begin(), marks.end(), [&](const auto& mark) {
            return mark.first == settings.between[k];
        });
        if (found == marks.end())
            throw std::runtime_error(settings.landmarks + ": has no landmark '" +
                                     settings.between[k] + "'");
        if (k % 2 == 0)
            pairs.push_back({found->second, 0});
        else
            pairs.back()[1] = found->second;
    }
    const Session session(settings.common.num_threads);
    const Mesh mesh(session, settings.mesh);
    warn_of_unit(session, {mesh, settings.mesh});
    const PlaceLengths lengths = lengths_mm(session, mesh, pairs);
    nlohmann::json report{
        {"mesh", settings.mesh}, {"unit", "mm"}, {"lengths", nlohmann::json::array()}};
    std::printf("%-34s %10s %10s   mm\n", "", "straight", "geodesic");
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const std::string &from = settings.between[2 * k], &to = settings.between[2 * k + 1];
        const bool joined = std::isfinite(lengths.geodesic_mm[k]);
        std::printf("%-34.34s %10.3f %10s\n", (from + " to " + to).c_str(), lengths.straight_mm[k],
                    joined ? std::to_string(lengths.geodesic_mm[k]).c_str() : "none");
        report["lengths"].push_back(
            {{"from", from},
             {"to", to},
             {"straight_mm", lengths.straight_mm[k]},
             {"geodesic_mm", joined ? nlohmann::json(lengths.geodesic_mm[k]) : nlohmann::json()}});
    }
    write_report(settings.common, report);
}

void add_pair(CLI::App& command, MeasureSettings& settings) {
    command.add_option("--before", settings.before, "first face")
        ->required()
        ->check(CLI::ExistingFile);
    command.add_option("--after", settings.after, "second face, in the frame of the first")
        ->required()
        ->check(CLI::ExistingFile);
    command.add_option("--zones", settings.zones, "zone file {\"zones\": {name: [vertex, ...]}}")
        ->check(CLI::ExistingFile);
}

using SharedSettings = std::shared_ptr<MeasureSettings>;

void add_volume(CLI::App* measure, const SharedSettings& settings) {
    CLI::App* volume =
        measure->add_subcommand("volume", "volume between two faces in correspondence");
    add_pair(*volume, *settings);
    volume
        ->add_option("--before-json", settings->before_json,
                     "what `mien register --json` wrote of the first face: tells its errors")
        ->check(CLI::ExistingFile);
    volume
        ->add_option("--after-json", settings->after_json,
                     "the same of the second face; records of `mien register --record` as --before "
                     "and --after tell them too")
        ->check(CLI::ExistingFile);
    volume->add_option("--sd-before", settings->sd_before,
                       "of a bare mesh: deviation of the first surface, mm; 0: exact");
    volume->add_option("--sd-after", settings->sd_after,
                       "of a bare mesh: deviation of the second surface, mm; 0: exact");
    volume
        ->add_option("--correlation", settings->correlation,
                     "length over which errors go together, mm")
        ->capture_default_str();
    volume->add_option("--bias", settings->bias, "error common to all vertices, mm")
        ->capture_default_str();
    volume
        ->add_option("--limit-of-detection", settings->limit,
                     "mL; smaller changes are marked, 0: unknown")
        ->capture_default_str();
    auto* carry =
        volume
            ->add_option(
                "--surfaces", settings->carry,
                "the faces are not in correspondence: carry the first onto the second by this")
            ->check(CLI::IsMember({"closest", "normal", "direction"}));
    volume->add_option("--direction", settings->direction, "with --surfaces direction: x y z")
        ->expected(3)
        ->needs(carry);
    volume->add_option("--stable", settings->stable,
                       "first align the second face on this zone of the first; without --surfaces "
                       "several may be named, separated by commas");
    volume
        ->add_option("--max-distance", settings->max_distance,
                     "with --surfaces: farther places count for nothing, mm; 0: 20")
        ->needs(carry)
        ->capture_default_str();
    add_common_options(*volume, settings->common);
    volume->footer(
        "Example: mien measure volume --before before.ply --after after.ply --zones zones.json");
    volume->callback([settings] { run_volume(*settings); });
}

void add_distance(CLI::App* measure, const SharedSettings& settings) {
    CLI::App* distance = measure->add_subcommand("distance", "distances between two faces");
    add_pair(*distance, *settings);
    auto* surfaces = distance->add_flag(
        "--surfaces", settings->surfaces,
        "the faces are not in correspondence: closest place on the second surface");
    distance
        ->add_option("--max-distance", settings->max_distance,
                     "with --surfaces: ignore farther ones, mm")
        ->needs(surfaces)
        ->capture_default_str();
    distance
        ->add_flag("--keep-borders", settings->keep_borders,
                   "with --surfaces: count places beyond the second surface's border")
        ->needs(surfaces);
    distance->add_option("--field", settings->field_path,
                         "write the signed distance of each vertex");
    add_common_options(*distance, settings->common);
    distance->footer(
        "Example: mien measure distance --before fitted.ply --after scan.ply --surfaces");
    distance->callback([settings] { run_distance(*settings); });
}

void add_area(CLI::App* measure, const SharedSettings& settings) {
    CLI::App* area =
        measure->add_subcommand("area", "surface area, and the volume a mesh encloses");
    area->add_option("mesh", settings->mesh, "mesh file")->check(CLI::ExistingFile);
    area->add_option("--before", settings->before, "instead of a mesh: first face")
        ->check(CLI::ExistingFile);
    area->add_option("--after", settings->after, "and second face")->check(CLI::ExistingFile);
    area->add_option("--zones", settings->zones, "zone file")->check(CLI::ExistingFile);
    area->add_flag("--closed", settings->closed,
                   "also the enclosed volume; an open mesh is an error");
    area->add_flag("--close-rims", settings->close_rims, "the same, closing open rims by fans");
    add_common_options(*area, settings->common);
    area->footer("Example: mien measure area face.ply --zones zones.json");
    area->callback([settings] { run_area(*settings); });
}

void add_curvature(CLI::App* measure, const SharedSettings& settings) {
    CLI::App* curvature =
        measure->add_subcommand("curvature", "mean, Gaussian and principal curvatures");
    curvature->add_option("mesh", settings->mesh, "mesh file")
        ->required()
        ->check(CLI::ExistingFile);
    curvature->add_option("--zones", settings->zones, "zone file")->check(CLI::ExistingFile);
    curvature->add_option("--radius", settings->radius, "of the fits, mm")->capture_default_str();
    curvature->add_flag("--no-robust", settings->not_robust, "keep spikes in the fits");
    curvature->add_option("--field", settings->field_path, "write one value per vertex");
    curvature->add_option("--what", settings->field, "which one")
        ->check(CLI::IsMember({"mean", "gaussian", "maximal", "minimal"}))
        ->capture_default_str();
    add_common_options(*curvature, settings->common);
    curvature->footer(
        "Example: mien measure curvature fitted.ply --zones zones.json --field mean.txt");
    curvature->callback([settings] { run_curvature(*settings); });
}

void add_length(CLI::App* measure, const SharedSettings& settings) {
    CLI::App* length =
        measure->add_subcommand("length", "lengths between landmarks, straight and along the skin");
    length->add_option("mesh", settings->mesh, "mesh in the template's topology")
        ->required()
        ->check(CLI::ExistingFile);
    length->add_option("--landmarks", settings->landmarks, "{\"vertices\": {name: index}}")
        ->required()
        ->check(CLI::ExistingFile);
    length->add_option("--between", settings->between, "pairs of names: A,B or A,B,C,D")
        ->required()
        ->delimiter(',');
    add_common_options(*length, settings->common);
    length->footer(
        "Example: mien measure length fitted.ply --landmarks landmarks.json --between "
        "pronasale,gnathion");
    length->callback([settings] { run_length(*settings); });
}

}  // namespace

void add_measure_commands(CLI::App& app) {
    CLI::App* measure =
        app.add_subcommand("measure", "volumes, areas, distances, anthropometry, asymmetry");
    measure->require_subcommand(1);
    const auto settings = std::make_shared<MeasureSettings>();
    add_volume(measure, settings);
    add_distance(measure, settings);
    add_area(measure, settings);
    add_curvature(measure, settings);
    add_length(measure, settings);
    add_geodesic_command(*measure);
    add_anthropometry_commands(*measure);
}

}  // namespace mien::cli
