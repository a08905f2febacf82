#include "expression/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "geometry/alignment.hpp"

namespace mien {
namespace {

struct Spread {
    double mean = 0, variance = 0;
};

Spread spread_of(const std::vector<double>& values) {
    Spread spread;
    for (double value : values) spread.mean += value;
    spread.mean /= static_cast<double>(values.size());
    for (double value : values) spread.variance += (value - spread.mean) * (value - spread.mean);
    spread.variance =
        values.size() > 1 ? spread.variance / static_cast<double>(values.size() - 1) : 0.0;
    return spread;
}

void check_vertices(const std::vector<std::uint32_t>& vertices, Index count, const char* what) {
    for (std::size_t k = 0; k < vertices.size(); ++k)
        if (vertices[k] >= static_cast<std::uint64_t>(count))
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(k),
                    "%s names vertex %u of %lld", what, vertices[k], static_cast<long long>(count));
}

Points rows_of(const Points& points, const std::vector<std::uint32_t>& rows) {
    Points picked(static_cast<Index>(rows.size()), 3);
    for (std::size_t k = 0; k < rows.size(); ++k)
        picked.row(static_cast<Index>(k)) = points.row(rows[k]);
    return picked;
}

ErrorSummary summary_of(const std::string& name, const std::vector<double>& means,
                        double max_vertex) {
    ErrorSummary summary;
    summary.name = name;
    summary.count = static_cast<Index>(means.size());
    if (means.empty()) return summary;
    const Spread spread = spread_of(means);
    summary.mean_mm = spread.mean;
    summary.deviation_mm = std::sqrt(spread.variance);
    summary.max_vertex_mm = max_vertex;
    return summary;
}

}  // namespace

EvaluatedFaces evaluate_faces(const Context& context, const FaceDataset& dataset,
                              const EvaluationOptions& options, const Neutralizer& neutralizer) {
    const Index n = dataset.num_vertices();
    check_vertices(options.zone, n, "the zone");
    check_vertices(options.stable, n, "the stable zone");
    if (dataset.neutral_expression() < 0)
        fail(Status::invalid_argument, "the data set's expression_names have no entry 'neutral'");
    std::map<int, Index> target_of;
    for (Index face = 0; face < dataset.num_faces(); ++face)
        if (dataset.expression(face) == dataset.neutral_expression())
            target_of.emplace(dataset.subject(face), face);
    EvaluatedFaces errors;
    Points face, target;
    Index held = -1;
    for (Index k = 0; k < dataset.num_faces(); ++k) {
        context.check_cancelled();
        const auto found = target_of.find(dataset.subject(k));
        if (found == target_of.end()) continue;
        if (found->second != held) dataset.face(held = found->second, target);
        dataset.face(k, face);
        if (neutralizer) neutralizer(k, face);
        if (!options.stable.empty())
            face = align_points(rows_of(face, options.stable), rows_of(target, options.stable),
                                Vector(), false)
                       .apply(PointsRef(face));
        Vector distance = (face - target).rowwise().norm();
        if (!options.zone.empty()) {
            Vector picked(static_cast<Index>(options.zone.size()));
            for (std::size_t i = 0; i < options.zone.size(); ++i)
                picked[static_cast<Index>(i)] = distance[options.zone[i]];
            distance = picked;
        }
        errors.face.push_back(k);
        errors.expression.push_back(dataset.expression(k));
        errors.mean_mm.push_back(distance.mean());
        errors.max_mm.push_back(distance.maxCoeff());
        if (options.volumes_ml) errors.volumes_ml.push_back(options.volumes_ml(target, face));
    }
    return errors;
}

EvaluatedFaces evaluate_model(const Context& context, const FaceDataset& dataset,
                              const ExpressionModel& model, const EvaluationOptions& options) {
    check_topology(model, dataset.num_vertices(), dataset.triangles());
    // Progress belongs to the evaluation as a whole, not to each of its faces.
    Context quiet = context;
    quiet.progress_function = nullptr;
    const double total = static_cast<double>(std::max<Index>(1, dataset.num_faces()));
    return evaluate_faces(context, dataset, options, [&](Index face, Points& vertices) {
        vertices =
            neutralize(quiet, model, vertices, Vector(), options.neutralize).neutral_vertices;
        context.progress(Stage::neutralizing, static_cast<double>(face + 1) / total);
    });
}

std::vector<ErrorSummary> summarize(const EvaluatedFaces& errors,
                                    const std::vector<std::string>& names) {
    std::vector<ErrorSummary> summaries;
    for (std::size_t expression = 0; expression < names.size(); ++expression) {
        std::vector<double> means;
        double max_vertex = 0;
        for (std::size_t k = 0; k < errors.face.size(); ++k)
            if (errors.expression[k] == static_cast<int>(expression)) {
                means.push_back(errors.mean_mm[k]);
                max_vertex = std::max(max_vertex, errors.max_mm[k]);
            }
        if (!means.empty()) summaries.push_back(summary_of(names[expression], means, max_vertex));
    }
    return summaries;
}

ErrorSummary summarize_moved(const EvaluatedFaces& errors, int neutral) {
    std::vector<double> means;
    double max_vertex = 0;
    for (std::size_t k = 0; k < errors.face.size(); ++k)
        if (errors.expression[k] != neutral) {
            means.push_back(errors.mean_mm[k]);
            max_vertex = std::max(max_vertex, errors.max_mm[k]);
        }
    return summary_of("all", means, max_vertex);
}

VolumeSummary summarize_volume(std::vector<double> volumes) {
    VolumeSummary summary;
    if (volumes.empty()) return summary;
    const Spread spread = spread_of(volumes);
    summary.mean_ml = spread.mean;
    summary.deviation_ml = std::sqrt(spread.variance);
    std::sort(volumes.begin(), volumes.end());
    const std::size_t half = volumes.size() / 2;
    summary.median_ml =
        volumes.size() % 2 == 1 ? volumes[half] : 0.5 * (volumes[half - 1] + volumes[half]);
    return summary;
}

Effect effect_size(const std::vector<double>& first, const std::vector<double>& second) {
    Effect effect;
    effect.cohens_d = std::numeric_limits<double>::quiet_NaN();
    if (first.size() < 2 || second.size() < 2) return effect;
    const Spread a = spread_of(first), b = spread_of(second);
    const double spread = std::sqrt(0.5 * (a.variance + b.variance));
    if (!(spread > 0.0)) return effect;
    effect.cohens_d = (a.mean - b.mean) / spread;
    effect.superiority = 0.5 * std::erfc(-effect.cohens_d / 2.0);
    return effect;
}

}  // namespace mien
