// Training of a score: the graded faces as rows of features, their number of components by
// cross-validation, and what the model keeps (score_model.hpp).
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "measure/area.hpp"
#include "measure/pair_check.hpp"
#include "measure/score_direction.hpp"
#include "measure/score_features.hpp"
#include "measure/score_model.hpp"

namespace mien {
namespace {

/// The faces that have a grade.
struct GradedFaces {
    const FaceDataset& faces;
    std::vector<Index> places;  ///< n, in the dataset
    std::vector<int> subjects;  ///< n
    Vector grades;              ///< n
    Index count() const { return grades.size(); }
};

/// What the faces say, and what of it belongs to the score.
struct TrainingRows {
    Matrix features;       ///< n x p
    Matrix displacements;  ///< 3#V x n, mm, from their mean
    Vector areas;          ///< #V, mm^2
};

void check_options(const ScoreOptions& options) {
    if (options.max_components < 1 || options.max_components > 50 || options.num_components < 0 ||
        options.num_components > 50 || options.folds < 0 || !(options.curvature_share >= 0) ||
        !std::isfinite(options.curvature_share) || !(options.curvature_radius_mm > 0) ||
        !std::isfinite(options.lowest) || !std::isfinite(options.highest) ||
        options.lowest > options.highest)
        fail(Status::invalid_argument,
             "score settings: components 1 to 50, folds 0 or more, curvature share %g (>= 0), "
             "radius %g "
             "mm (> 0), range %g to %g",
             options.curvature_share, options.curvature_radius_mm, options.lowest, options.highest);
}

GradedFaces graded_faces(const FaceDataset& faces, const Vector& grades) {
    if (grades.size() != faces.num_faces())
        fail(Status::mismatch,
             "%lld grades for %lld faces; give one per face, not-a-number for none",
             static_cast<long long>(grades.size()), static_cast<long long>(faces.num_faces()));
    GradedFaces result{faces, {}, {}, {}};
    for (Index k = 0; k < grades.size(); ++k)
        if (std::isfinite(grades[k])) {
            result.places.push_back(k);
            result.subjects.push_back(faces.subject(k));
        }
    const Index n = static_cast<Index>(result.places.size());
    if (n < 6)
        fail(Status::invalid_argument, "%lld graded faces; a score needs six or more",
             static_cast<long long>(n));
    result.grades.resize(n);
    for (Index i = 0; i < n; ++i)
        result.grades[i] = grades[result.places[static_cast<std::size_t>(i)]];
    return result;
}

/// Mean of the faces aligned to the first one, then to that mean.
Points mean_aligned_face(const GradedFaces& graded, const ScoreModel& model,
                         const Context& context) {
    Points face;
    graded.faces.face(graded.places.front(), face);
    Points reference = face;
    for (int round = 0; round < 2; ++round) {
        Points sum = Points::Zero(face.rows(), 3);
        for (const Index k : graded.places) {
            context.check_cancelled();
            graded.faces.face(k, face);
            sum += align_face(face, reference, model.triangles, model.stable_zone);
        }
        reference = sum / static_cast<double>(graded.count());
    }
    return reference;
}

/// The square roots of the vertices' areas in the zone of interest.
Vector area_scale(const std::vector<std::uint32_t>& zone, const Vector& areas) {
    const std::vector<char> inside =
        zone.empty() ? std::vector<char>(static_cast<std::size_t>(areas.size()), 1)
                     : membership(zone, areas.size());
    Vector scale = Vector::Zero(areas.size());
    for (Index v = 0; v < areas.size(); ++v)
        if (inside[static_cast<std::size_t>(v)]) scale[v] = std::sqrt(areas[v]);
    if (!(scale.maxCoeff() > 0)) fail(Status::invalid_argument, "the zone of interest has no area");
    return scale;
}

/// Gives the curvatures of all faces together the chosen share of the displacements' variance.
void balance_curvature(double share, Index num_displacements, Matrix& features,
                       Vector& curvature_scale) {
    const Index num_curvatures = features.cols() - num_displacements;
    if (num_curvatures == 0) return;
    const auto variance = [](const auto& block) {
        return (block.rowwise() - block.colwise().mean()).squaredNorm();
    };
    const double spread = variance(features.leftCols(num_displacements));
    const double bending = variance(features.rightCols(num_curvatures));
    const double scale = bending > 0 ? std::sqrt(share * spread / bending) : 0.0;
    features.rightCols(num_curvatures) *= scale;
    curvature_scale *= scale;
}

/// The same for all shape features: each of them an equal part of the share.
void balance_shape(double share, Index num_displacements, Matrix& features, Vector& shape_scale) {
    const auto variance = [](const auto& column) {
        return (column.array() - column.mean()).square().sum();
    };
    double spread = 0.0;
    for (Index c = 0; c < num_displacements; ++c) spread += variance(features.col(c));
    Vector bending = Vector::Zero(kShapeFeatures);
    for (Index c = num_displacements; c < features.cols(); ++c)
        bending[(c - num_displacements) % kShapeFeatures] += variance(features.col(c));
    for (Index k = 0; k < kShapeFeatures; ++k)
        shape_scale[k] =
            bending[k] > 0 ? std::sqrt(share * spread / kShapeFeatures / bending[k]) : 0.0;
    for (Index c = num_displacements; c < features.cols(); ++c)
        features.col(c) *= shape_scale[(c - num_displacements) % kShapeFeatures];
}

/// Chooses the scales of the model's features and reads the faces by them.
TrainingRows training_rows(const GradedFaces& graded, const ScoreOptions& options,
                           ScoreModel& model, const Context& context) {
    const Index n = graded.count(), num_vertices = model.mean_face.rows();
    TrainingRows rows;
    rows.areas = vertex_areas(model.mean_face, model.triangles);
    model.displacement_scale = area_scale(options.zone, rows.areas);
    model.curvature_scale =
        options.curvature_share > 0 ? model.displacement_scale : Vector(Vector::Zero(num_vertices));
    const bool all = options.features == ScoreFeatures::all && options.curvature_share > 0;
    if (all) model.shape_scale = Vector::Ones(kShapeFeatures);
    const FeatureScales scales{model.displacement_scale, model.curvature_scale,
                               model.curvature_radius_mm, model.shape_scale};
    const Index p = feature_count(scales);
    context.require_memory(
        static_cast<std::size_t>(n) * static_cast<std::size_t>(3 * p + 15 * num_vertices) * 8,
        "score features");
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> by_row(n, p);
    rows.displacements.resize(3 * num_vertices, n);
    parallel_for(context, static_cast<std::size_t>(n), 1, [&](std::size_t begin, std::size_t) {
        const Index i = static_cast<Index>(begin);
        Points face;
        graded.faces.face(graded.places[begin], face);
        const Points aligned =
            align_face(face, model.mean_face, model.triangles, model.stable_zone);
        const Points displacement = aligned - model.mean_face;
        rows.displacements.col(i) =
            Eigen::Map<const Vector>(displacement.data(), displacement.size());
        Eigen::RowVectorXd row(p);
        features_of(aligned, model.mean_face, model.triangles, scales, row);
        by_row.row(i) = row;
    });
    context.progress(Stage::training, 0.7);
    rows.features = by_row;
    if (all)
        balance_shape(options.curvature_share, displacement_count(scales), rows.features,
                      model.shape_scale);
    else
        balance_curvature(options.curvature_share, displacement_count(scales), rows.features,
                          model.curvature_scale);
    rows.displacements.colwise() -= rows.displacements.rowwise().mean().eval();
    return rows;
}

/// Cross-validation over subjects; with a focus, each fold learns its own from its training faces.
CrossValidation validate(const GradedFaces& graded, const TrainingRows& rows,
                         const ScoreOptions& options, const ScoreModel& model,
                         const Context& context) {
    CrossValidationOptions settings;
    settings.method = options.method;
    settings.max_components = std::max(options.max_components, options.num_components);
    settings.seed = options.seed;
    settings.groups = graded.subjects;
    std::vector<int> distinct(graded.subjects);
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    settings.folds =
        options.folds == 0 ? 0 : std::min<int>(options.folds, static_cast<int>(distinct.size()));
    const Index p = rows.features.cols();
    if (options.focus)
        settings.column_factors = [&](const std::vector<Index>& training) {
            Matrix own(rows.displacements.rows(), static_cast<Index>(training.size()));
            Vector grades(own.cols());
            for (Index i = 0; i < own.cols(); ++i) {
                own.col(i) = rows.displacements.col(training[static_cast<std::size_t>(i)]);
                grades[i] = graded.grades[training[static_cast<std::size_t>(i)]];
            }
            if ((grades.array() == grades[0]).all()) return Vector(Vector::Ones(p));
            const Vector focus =
                focus_of(score_direction(model.mean_face, own, rows.areas, grades, context));
            return repeated_for_features(focus, model.displacement_scale, p);
        };
    return cross_validate_pls(rows.features, graded.grades, settings, context);
}

/// Weighs features and scales by how far each vertex moves with the score.
void apply_focus(const ScoreDirection& direction, Matrix& features, ScoreModel& model) {
    const Vector focus = focus_of(direction);
    model.focus_places = direction.places;
    features *=
        repeated_for_features(focus, model.displacement_scale, features.cols()).asDiagonal();
    model.displacement_scale.array() *= focus.array();
    model.curvature_scale.array() *= focus.array();
}

void keep_validation(const CrossValidation& cv, Index num_components, ScoreModel& model) {
    model.cv_error = cv.mean_squared_error;
    model.cv_standard_error = cv.standard_error;
    model.best_components = cv.best_components;
    model.one_se_components = cv.one_standard_error_components;
    const Index column = std::min<Index>(num_components, cv.mean_squared_error.size() - 1);
    model.rmse = std::sqrt(model.cv_error[column]);
    model.q2 = cv.r2(static_cast<int>(column));
    model.cv_predictions = cv.predictions.col(column);
}

/// The regression, and the displacement that goes with each of its latent variables.
void keep_regression(const PlsModel& pls, const Matrix& displacements, ScoreModel& model) {
    model.feature_mean = pls.x_mean;
    model.rotations = pls.rotations;
    model.y_loadings = pls.y_loadings.row(0).transpose();
    model.score_squares = pls.scores.colwise().squaredNorm().transpose();
    model.y_mean = pls.y_mean[0];
    const Index num_vertices = model.mean_face.rows();
    model.latent_pictures.resize(num_vertices, pls.num_components());
    for (Index c = 0; c < pls.num_components(); ++c) {
        const double deviation =
            std::sqrt(model.score_squares[c] / static_cast<double>(model.num_samples - 1));
        const Vector pattern =
            displacements * pls.scores.col(c) * (deviation / model.score_squares[c]);
        model.latent_pictures.col(c) =
            Eigen::Map<const Points>(pattern.data(), num_vertices, 3).rowwise().norm();
    }
}

}  // namespace

ScoreModel train_score(const FaceDataset& faces, const Vector& grades, const ScoreOptions& options,
                       const Context& context) {
    check_options(options);
    const GradedFaces graded = graded_faces(faces, grades);
    check_zones({{"of interest", options.zone}, {"stable", options.stable_zone}},
                faces.num_vertices());

    ScoreModel model;
    model.triangles = faces.triangles();
    model.stable_zone = options.stable_zone;
    model.curvature_radius_mm = options.curvature_radius_mm;
    model.lowest = options.lowest;
    model.highest = options.highest;
    model.num_samples = graded.count();
    model.mean_face = mean_aligned_face(graded, model, context);
    context.progress(Stage::training, 0.2);

    TrainingRows rows = training_rows(graded, options, model, context);
    if ((graded.grades.array() == graded.grades[0]).all())
        fail(Status::no_solution, "all graded faces have the grade %g: there is nothing to learn",
             graded.grades[0]);
    const ScoreDirection direction =
        score_direction(model.mean_face, rows.displacements, rows.areas, graded.grades, context);
    model.unit_displacement =
        Eigen::Map<const Points>(direction.displacement.data(), model.mean_face.rows(), 3);

    const CrossValidation cv = validate(graded, rows, options, model, context);
    if (options.focus) apply_focus(direction, rows.features, model);
    PlsOptions settings;
    settings.method = options.method;
    settings.num_components =
        options.num_components > 0 ? options.num_components : cv.one_standard_error_components;
    const PlsModel pls = fit_pls(rows.features, graded.grades, settings, context);
    keep_validation(cv, pls.num_components(), model);
    keep_regression(pls, rows.displacements, model);
    context.progress(Stage::training, 1.0);
    return model;
}

}  // namespace mien
