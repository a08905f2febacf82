#include "registration/fit_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/json.hpp"
#include "registration/tie_record.hpp"

namespace mien {
namespace {

constexpr const char* kKind = "mien-fit-record";
constexpr std::int64_t kNumVerdict = 15, kNumMotion = 13;
constexpr std::int64_t kNumWhole = 17, kNumZone = 16, kNumExpected = 5;
// Files of before hold fewer measures; those that they lack are 0.
constexpr std::int64_t kLeastWhole = 12, kLeastZone = 8;

std::uint64_t size_of(Index count) {
    return static_cast<std::uint64_t>(count);
}

std::vector<double> numbers_of(const Verdict& v, const RegistrationResult& fit) {
    return {static_cast<double>(v.quality),
            v.coverage,
            v.inlier_share,
            v.mean_residual_mm,
            v.landmark_rms_mm,
            static_cast<double>(v.landmarks_used),
            v.size_ratio,
            v.mean_deviation,
            static_cast<double>(v.flipped_triangles),
            static_cast<double>(v.repaired_triangles),
            static_cast<double>(v.self_intersections),
            v.search_score,
            v.unit_to_mm,
            v.may_slide ? 1.0 : 0.0,
            static_cast<double>(fit.iterations)};
}

int whole(double value, const char* what) {
    if (!(value >= 0) || !(value <= std::numeric_limits<int>::max()) || value != std::floor(value))
        fail(Status::bad_format, "tensor 'verdict': %s is %g", what, value);
    return static_cast<int>(value);
}

void read_numbers(const double* n, Verdict& v, RegistrationResult& fit) {
    const int quality = whole(n[0], "quality");
    if (quality > static_cast<int>(FitQuality::failed))
        fail(Status::bad_format, "tensor 'verdict': quality %d is none", quality);
    v.quality = static_cast<FitQuality>(quality);
    v.coverage = n[1];
    v.inlier_share = n[2];
    v.mean_residual_mm = n[3];
    v.landmark_rms_mm = n[4];
    v.landmarks_used = whole(n[5], "landmarks_used");
    v.size_ratio = n[6];
    v.mean_deviation = n[7];
    v.flipped_triangles = whole(n[8], "flipped_triangles");
    v.repaired_triangles = whole(n[9], "repaired_triangles");
    v.self_intersections = whole(n[10], "self_intersections");
    v.search_score = n[11];
    v.unit_to_mm = n[12];
    v.may_slide = n[13] != 0;
    fit.iterations = whole(n[14], "iterations");
}

// Measures of the whole, then rows of measures and expected errors of the zones.
std::vector<double> numbers_of(const WholeMeasures& w) {
    return {
        w.search_miss,      w.landmark_misfit, w.landmarks_out, w.color_miss, w.trained_deviation,
        w.kernel_deviation, w.kernel_mm,       w.size,          w.folds,      w.is_free,
        w.is_trained,       w.no_colors,       w.landmarks,     w.lips_miss,  w.brows_miss,
        w.worst_open_mm,    w.worst_unseen};
}

void read_numbers(const double* n, WholeMeasures& w) {
    for (double* number : {&w.search_miss, &w.landmark_misfit, &w.landmarks_out, &w.color_miss,
                           &w.trained_deviation, &w.kernel_deviation, &w.kernel_mm, &w.size,
                           &w.folds, &w.is_free, &w.is_trained, &w.no_colors, &w.landmarks,
                           &w.lips_miss, &w.brows_miss, &w.worst_open_mm, &w.worst_unseen})
        *number = *n++;
}

void add_numbers(const ZoneMeasures& z, std::vector<double>& out) {
    out.insert(out.end(), {z.unseen, z.residual_mm, z.open_mm, z.turn, z.deviation_mm, z.stretch,
                           z.landmark_mm, static_cast<double>(z.landmarks), z.open_most_mm,
                           z.asymmetry_mm, z.shape_deviation, z.slid_mm, z.pin_far_mm,
                           z.pin_misfit_mm, z.color_hold, z.color_doubt});
}

void read_numbers(const double* n, ZoneMeasures& z) {
    for (double* number : {&z.unseen, &z.residual_mm, &z.open_mm, &z.turn, &z.deviation_mm,
                           &z.stretch, &z.landmark_mm})
        *number = *n++;
    z.landmarks = whole(*n++, "landmarks of a zone");
    for (double* number : {&z.open_most_mm, &z.asymmetry_mm, &z.shape_deviation, &z.slid_mm,
                           &z.pin_far_mm, &z.pin_misfit_mm, &z.color_hold, &z.color_doubt})
        *number = *n++;
}

void add_numbers(const ExpectedError& e, std::vector<double>& out) {
    out.insert(out.end(), {e.expected_mm, e.low_mm, e.high_mm, static_cast<double>(e.quality),
                           static_cast<double>(e.cause)});
}

void read_numbers(const double* n, ExpectedError& e) {
    e.expected_mm = n[0];
    e.low_mm = n[1];
    e.high_mm = n[2];
    const int quality = whole(n[3], "quality of a zone"), cause = whole(n[4], "cause of a zone");
    if (quality > static_cast<int>(FitQuality::failed) ||
        cause >= static_cast<int>(FitMeasure::count))
        fail(Status::bad_format, "tensor 'expected_errors': quality %d or cause %d is none",
             quality, cause);
    e.quality = static_cast<FitQuality>(quality);
    e.cause = static_cast<FitMeasure>(cause);
}

// Rows of a tensor, each with zeros after what the file holds.
std::vector<double> padded_rows(const TensorView& tensor, const char* name, std::int64_t least,
                                std::int64_t columns) {
    const std::int64_t held = static_cast<std::int64_t>(tensor.shape.back());
    if (held < least || held > columns)
        fail(Status::bad_format, "tensor '%s' has %lld measures; %lld to %lld are known", name,
             static_cast<long long>(held), static_cast<long long>(least),
             static_cast<long long>(columns));
    const std::int64_t rows = static_cast<std::int64_t>(tensor.count) / held;
    const auto* from = static_cast<const double*>(tensor.data);
    std::vector<double> out(static_cast<std::size_t>(rows * columns), 0.0);
    for (std::int64_t k = 0; k < rows; ++k)
        std::copy(from + k * held, from + (k + 1) * held, out.begin() + k * columns);
    return out;
}

// What is expected of the zones; files of before have none.
void read_expected(const SafetensorsFile& file, Verdict& v) {
    if (!file.has("expected_errors")) return;
    const std::vector<std::string> names =
        parse_json_string_list(file.metadata("measured_zones"), "measured_zones");
    const auto count = static_cast<std::int64_t>(names.size());
    const std::vector<double> whole_row =
        padded_rows(file.tensor("measures", DType::f64, {-1}), "measures", kLeastWhole, kNumWhole);
    read_numbers(whole_row.data(), v.whole);
    const std::vector<double> zone_rows =
        padded_rows(file.tensor("zone_measures", DType::f64, {count, -1}), "zone_measures",
                    kLeastZone, kNumZone);
    const double* measures = zone_rows.data();
    const auto* errors = static_cast<const double*>(
        file.tensor("expected_errors", DType::f64, {count, kNumExpected}).data);
    for (std::int64_t k = 0; k < count; ++k) {
        const std::string& name = names[static_cast<std::size_t>(k)];
        v.zones.emplace_back();
        v.zones.back().name = name;
        read_numbers(measures + kNumZone * k, v.zones.back());
        v.expected.emplace_back();
        v.expected.back().zone = name;
        read_numbers(errors + kNumExpected * k, v.expected.back());
    }
}

std::vector<double> numbers_of(const Similarity& motion) {
    std::vector<double> numbers;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) numbers.push_back(motion.rotation(i, j));
    for (int i = 0; i < 3; ++i) numbers.push_back(motion.translation[i]);
    numbers.push_back(motion.scale);
    return numbers;
}

Similarity motion_of(const double* numbers) {
    Similarity motion;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) motion.rotation(i, j) = numbers[3 * i + j];
    for (int i = 0; i < 3; ++i) motion.translation[i] = numbers[9 + i];
    motion.scale = numbers[12];
    return motion;
}

/// What is wrong with a fit's arrays, as an error of `status`.
void check_fit(const TriMesh& mesh, const RegistrationResult& fit, Status status) {
    const Index n = mesh.vertices.rows();
    for (const Vector* values : {&fit.weight, &fit.residual_mm, &fit.confidence_mm})
        if (values->size() != n && values->size() != 0)
            fail(Status::mismatch, "%lld weights, residuals or deviations for %lld vertices",
                 static_cast<long long>(values->size()), static_cast<long long>(n));
    for (Index v = 0; v < fit.weight.size(); ++v)
        if (!(fit.weight[v] >= 0) || !(fit.weight[v] <= 1))
            fail_at(status, v, "weight %lld is %g; weights are 0 to 1", static_cast<long long>(v),
                    fit.weight[v]);
    for (Index v = 0; v < fit.residual_mm.size(); ++v)
        if (!std::isfinite(fit.residual_mm[v]))
            fail_at(status, v, "residual %lld is not finite", static_cast<long long>(v));
    for (Index v = 0; v < fit.confidence_mm.size(); ++v)
        if (!(fit.confidence_mm[v] >= 0) || !std::isfinite(fit.confidence_mm[v]))
            fail_at(status, v, "deviation %lld is %g; deviations are zero or more",
                    static_cast<long long>(v), fit.confidence_mm[v]);
}

Vector read_vector(const SafetensorsFile& file, const char* name, Index count) {
    if (!file.has(name)) return {};  // was not known
    return Eigen::Map<const Vector>(
        static_cast<const double*>(file.tensor(name, DType::f64, {count}).data), count);
}

void read_zones(const SafetensorsFile& file, Index num_vertices, std::vector<Zone>& zones) {
    if (!file.has("zone_vertices")) return;
    const auto names = parse_json_string_list(file.metadata("zone_names"), "zone_names");
    const TensorView& vertices = file.tensor("zone_vertices", DType::u32, {-1});
    const TensorView& sizes =
        file.tensor("zone_sizes", DType::u32, {static_cast<std::int64_t>(names.size())});
    const auto* vertex = static_cast<const std::uint32_t*>(vertices.data);
    std::uint64_t left = vertices.count;
    for (std::size_t z = 0; z < names.size(); ++z) {
        const std::uint64_t size = static_cast<const std::uint32_t*>(sizes.data)[z];
        if (size > left)
            fail(Status::bad_format, "tensor 'zone_sizes' asks for more than 'zone_vertices' has");
        zones.push_back({names[z], {vertex, vertex + size}});
        for (const std::uint32_t v : zones.back().vertices)
            if (static_cast<Index>(v) >= num_vertices)
                fail(Status::bad_format, "tensor 'zone_vertices' names vertex %u of %lld", v,
                     static_cast<long long>(num_vertices));
        vertex += size;
        left -= size;
    }
}

void read_hits(const SafetensorsFile& file, Index num_vertices, std::vector<SurfaceHit>& hits) {
    if (!file.has("scan_triangles")) return;
    const auto* triangles = static_cast<const std::uint32_t*>(
        file.tensor("scan_triangles", DType::u32, {num_vertices}).data);
    const auto* places = static_cast<const double*>(
        file.tensor("scan_barycentric", DType::f64, {num_vertices, 3}).data);
    hits.resize(static_cast<std::size_t>(num_vertices));
    for (std::size_t v = 0; v < hits.size(); ++v) {
        hits[v].triangle = triangles[v];
        hits[v].barycentric = Vector3(places[3 * v], places[3 * v + 1], places[3 * v + 2]);
    }
}

/// Tensors and names, gathered with the arrays that they borrow.
struct Writing {
    std::vector<TensorToWrite> tensors;
    std::map<std::string, std::string> metadata;
    std::vector<double> verdict, start, motion, energy, correlations, barycentric, measures,
        zone_measures, expected_errors;
    std::vector<std::uint32_t> scan_triangles, zone_vertices, zone_sizes;

    void add(const char* name, const std::vector<double>& values,
             std::vector<std::uint64_t> shape = {}) {
        if (shape.empty()) shape = {values.size()};
        if (!values.empty()) tensors.push_back({name, DType::f64, std::move(shape), values.data()});
    }
    void add(const char* name, const Vector& values) {
        if (values.size() != 0)
            tensors.push_back({name, DType::f64, {size_of(values.size())}, values.data()});
    }
    void add(const char* name, const std::vector<std::uint32_t>& values) {
        if (!values.empty()) tensors.push_back({name, DType::u32, {values.size()}, values.data()});
    }
};

void add_names(Writing& out, const RegistrationResult& fit, const std::vector<Zone>& zones) {
    const Verdict& verdict = fit.verdict;
    std::vector<std::string> colors, zone_names, measured;
    for (const ColorAgreement& feature : verdict.colors) {
        colors.push_back(feature.name);
        out.correlations.push_back(feature.correlation);
    }
    for (const Zone& zone : zones) {
        zone_names.push_back(zone.name);
        out.zone_sizes.push_back(static_cast<std::uint32_t>(zone.vertices.size()));
        out.zone_vertices.insert(out.zone_vertices.end(), zone.vertices.begin(),
                                 zone.vertices.end());
    }
    for (const ZoneMeasures& zone : verdict.zones) measured.push_back(zone.name);
    if (!measured.empty()) out.metadata["measured_zones"] = json_string_list(measured);
    out.metadata["colors_left_out"] = json_string_list(verdict.colors_left_out);
    out.metadata["reasons"] = json_string_list(verdict.reasons);
    out.metadata["notes"] = json_string_list(verdict.notes);
    out.metadata["landmarks_rejected"] = json_string_list(verdict.landmarks_rejected);
    out.metadata["landmarks_unknown"] = json_string_list(fit.unknown_landmarks);
    out.metadata["color_features"] = json_string_list(colors);
    if (!out.zone_vertices.empty()) out.metadata["zone_names"] = json_string_list(zone_names);
}

}  // namespace

void save_fit_record(const std::string& path, const TriMesh& mesh, const RegistrationResult& fit,
                     const std::vector<Zone>& zones, const TextureTie* tie,
                     const Context& context) {
    check_fit(mesh, fit, Status::invalid_argument);
    const std::uint64_t n = size_of(mesh.vertices.rows());
    Writing out;
    out.metadata = {{"kind", kKind}, {"units", "millimetres"}};
    add_names(out, fit, zones);
    out.verdict = numbers_of(fit.verdict, fit);
    out.verdict.push_back(fit.sigma_mm);
    if (!fit.verdict.expected.empty()) out.measures = numbers_of(fit.verdict.whole);
    for (const ZoneMeasures& zone : fit.verdict.zones) add_numbers(zone, out.zone_measures);
    for (const ExpectedError& error : fit.verdict.expected) add_numbers(error, out.expected_errors);
    out.start = numbers_of(fit.start);
    out.motion = numbers_of(fit.motion);
    out.energy = fit.energy;
    for (const SurfaceHit& hit : fit.correspondence) {
        out.scan_triangles.push_back(hit.triangle);
        for (int k = 0; k < 3; ++k) out.barycentric.push_back(hit.barycentric[k]);
    }
    out.tensors.push_back({"vertices", DType::f64, {n, 3}, mesh.vertices.data()});
    out.add("residual_mm", fit.residual_mm);
    out.add("weight", fit.weight);
    out.add("standard_deviation_mm", fit.confidence_mm);
    out.add("verdict", out.verdict);
    out.add("measures", out.measures);
    out.add("zone_measures", out.zone_measures, {fit.verdict.zones.size(), kNumZone});
    out.add("expected_errors", out.expected_errors, {fit.verdict.expected.size(), kNumExpected});
    out.add("start", out.start);
    out.add("motion", out.motion);
    out.add("energy_mm2", out.energy);
    out.add("color_correlations", out.correlations);
    out.add("scan_barycentric", out.barycentric, {n, 3});
    out.tensors.push_back(
        {"triangles", DType::u32, {size_of(mesh.triangles.rows()), 3}, mesh.triangles.data()});
    out.add("scan_triangles", out.scan_triangles);
    out.add("zone_vertices", out.zone_vertices);
    if (!out.zone_vertices.empty()) out.add("zone_sizes", out.zone_sizes);
    const std::vector<double> tied = tie != nullptr ? tie_numbers(*tie) : std::vector<double>();
    if (tie != nullptr) add_tie(*tie, tied, out.tensors, out.metadata);
    if (mesh.colors.rows() != 0)
        out.tensors.push_back({"colors", DType::u8, {n, 3}, mesh.colors.data()});
    write_safetensors(path, out.tensors, std::move(out.metadata), context);
}

FitRecord load_fit_record(const std::string& path, const Context& context) {
    return read_fit_record(SafetensorsFile::open(path, {}, context));
}

FitRecord read_fit_record(const SafetensorsFile& file) {
    file.require_kind(kKind);
    FitRecord record;
    TriMesh& mesh = record.mesh;
    RegistrationResult& fit = record.fit;
    const TensorView& places = file.tensor("vertices", DType::f64, {-1, 3});
    const Index n = static_cast<Index>(places.shape[0]);
    mesh.vertices = Eigen::Map<const Points>(static_cast<const double*>(places.data), n, 3);
    const TensorView& corners = file.tensor("triangles", DType::u32, {-1, 3});
    mesh.triangles = Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(corners.data),
                                                 static_cast<Index>(corners.shape[0]), 3);
    if (file.has("colors"))
        mesh.colors = Eigen::Map<const Colors>(
            static_cast<const std::uint8_t*>(file.tensor("colors", DType::u8, {n, 3}).data), n, 3);
    check_mesh(mesh, "the fit record's mesh");
    fit.residual_mm = read_vector(file, "residual_mm", n);
    fit.weight = read_vector(file, "weight", n);
    fit.confidence_mm = read_vector(file, "standard_deviation_mm", n);
    check_fit(mesh, fit, Status::corrupt);
    const auto* numbers =
        static_cast<const double*>(file.tensor("verdict", DType::f64, {kNumVerdict + 1}).data);
    read_numbers(numbers, fit.verdict, fit);
    fit.sigma_mm = numbers[kNumVerdict];
    fit.start =
        motion_of(static_cast<const double*>(file.tensor("start", DType::f64, {kNumMotion}).data));
    fit.motion =
        motion_of(static_cast<const double*>(file.tensor("motion", DType::f64, {kNumMotion}).data));
    if (file.has("energy_mm2")) {
        const TensorView& energy = file.tensor("energy_mm2", DType::f64, {-1});
        const auto* values = static_cast<const double*>(energy.data);
        fit.energy.assign(values, values + energy.count);
    }
    read_hits(file, n, fit.correspondence);
    const auto names = [&](const char* key) {
        return parse_json_string_list(file.metadata(key), key);
    };
    fit.verdict.reasons = names("reasons");
    fit.verdict.landmarks_rejected = names("landmarks_rejected");
    fit.unknown_landmarks = names("landmarks_unknown");
    read_expected(file, fit.verdict);
    if (file.metadata().count("colors_left_out") != 0)
        fit.verdict.colors_left_out = names("colors_left_out");
    if (file.metadata().count("notes") != 0) fit.verdict.notes = names("notes");
    const std::vector<std::string> colors = names("color_features");
    for (std::size_t i = 0; i < colors.size(); ++i)
        fit.verdict.colors.push_back(
            {colors[i],
             static_cast<const double*>(file.tensor("color_correlations", DType::f64,
                                                    {static_cast<std::int64_t>(colors.size())})
                                            .data)[i]});
    read_zones(file, n, record.zones);
    record.tie = read_tie(file, n);
    return record;
}

FitRecord fit_record_of(TriMesh mesh, Vector weights, Vector residual_mm, Vector place_sd_mm,
                        FitQuality quality, std::vector<Zone> zones) {
    check_mesh(mesh, "the fitted mesh");
    FitRecord record;
    record.mesh = std::move(mesh);
    record.fit.weight = std::move(weights);
    record.fit.residual_mm = std::move(residual_mm);
    record.fit.confidence_mm = std::move(place_sd_mm);
    record.fit.verdict.quality = quality;
    record.zones = std::move(zones);
    check_fit(record.mesh, record.fit, Status::invalid_argument);
    const Index n = record.mesh.vertices.rows();
    for (const Zone& zone : record.zones)
        for (const std::uint32_t v : zone.vertices)
            if (static_cast<Index>(v) >= n)
                fail_at(Status::mismatch, v, "zone '%s' names vertex %u of %lld",
                        shown_name(zone.name).c_str(), v, static_cast<long long>(n));
    return record;
}

}  // namespace mien
