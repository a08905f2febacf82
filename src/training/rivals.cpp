#include "training/rivals.hpp"

#include <algorithm>
#include <Eigen/Eigenvalues>

#include "base/error.hpp"
#include "learning/blendshapes.hpp"
#include "spectral/deformation_transfer.hpp"

namespace mien::training {
namespace {

using Json = nlohmann::json;

/// Neutral faces in the frame of their mean, displacements in the same, one column a person.
struct Columns {
    std::shared_ptr<const FaceFeatures> features;
    Matrix neutral, displacement;
};

Columns columns_of(const FaceDataset& data, const FacePairs& pairs) {
    Columns columns;
    Points neutral, face;
    FaceSource source;
    source.count = pairs.count;
    source.face = [&](Index k, Points& into) { pairs.pair(k, into, face); };
    columns.features = FaceFeatures::train(data.triangles(), source, FeatureKind::euclidean, {});
    const Index size = 3 * columns.features->num_vertices();
    columns.neutral.resize(size, pairs.count);
    columns.displacement.resize(size, pairs.count);
    for (Index k = 0; k < pairs.count; ++k) {
        pairs.pair(k, neutral, face);
        Similarity motion;
        const Points own = onto_mean_shape(neutral, columns.features->mean(), &motion);
        const Points moved = motion.apply(face) - own;
        columns.neutral.col(k) = Eigen::Map<const Vector>(own.data(), size);
        columns.displacement.col(k) = Eigen::Map<const Vector>(moved.data(), size);
    }
    return columns;
}

/// The neutral face with a displacement that is a function of it, in the mean's frame.
PredictExpression displaced(const std::shared_ptr<const FaceFeatures>& features,
                            std::function<Vector(const Points& own)> displacement) {
    return [features, displacement = std::move(displacement)](const Points& neutral) {
        Similarity motion;
        Points own = onto_mean_shape(neutral, features->mean(), &motion);
        const Vector moved = displacement(own);
        own += Eigen::Map<const Points>(moved.data(), own.rows(), 3);
        return motion.inverse().apply(own);
    };
}

Rival mean_displacement(const FaceDataset& data, const FacePairs& training) {
    const Columns columns = columns_of(data, training);
    Rival rival;
    rival.scale_mm = columns.features->scale_mm();
    rival.ways = {displaced(
        columns.features,
        [mean = Vector(columns.displacement.rowwise().mean())](const Points&) { return mean; })};
    return rival;
}

/// Displacement = mean + B scores by least squares, scores of at most `latent` components.
Rival principal_regression(const FaceDataset& data, const FacePairs& training, Index latent) {
    const Columns columns = columns_of(data, training);
    const Vector mean_face = columns.neutral.rowwise().mean();
    const Vector mean_moved = columns.displacement.rowwise().mean();
    const Matrix x = columns.neutral.colwise() - mean_face;
    const Matrix gram = x.transpose() * x;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(gram);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the neutral faces have no principal components");
    // Scores of different components are uncorrelated: each has its own slope.
    const Index count = x.cols();
    Index used = 0;
    while (used < std::min(latent, count - 1) &&
           solver.eigenvalues()[count - 1 - used] > 1e-9 * solver.eigenvalues()[count - 1])
        ++used;
    const Matrix u = solver.eigenvectors().rightCols(used);
    const Vector values = solver.eigenvalues().tail(used);
    Rival rival;
    rival.numbers = used;
    rival.scale_mm = columns.features->scale_mm();
    // B scores(y) = D u diag(1 / values) u' x' (y - mean).
    const Matrix slopes =
        (columns.displacement.colwise() - mean_moved) * u * values.cwiseInverse().asDiagonal();
    const Matrix scores = u.transpose() * x.transpose();
    rival.ways = {displaced(columns.features, [=](const Points& own) -> Vector {
        const Vector face = Eigen::Map<const Vector>(own.data(), own.size()) - mean_face;
        return mean_moved + slopes * (scores * face);
    })};
    return rival;
}

Rival deformation_transfer(const FaceDataset& data, const FacePairs& training) {
    Rival rival;
    rival.scale_mm = columns_of(data, training).features->scale_mm();
    for (const Index source : {Index(0), training.count / 3, 2 * training.count / 3}) {
        Points neutral, face;
        training.pair(source, neutral, face);
        rival.ways.push_back(
            [neutral, face, triangles = Triangles(data.triangles())](const Points& target) {
                TriMesh own;
                own.vertices = target;
                own.triangles = triangles;
                return DeformationTransfer(own, {}).transfer(neutral, face, {});
            });
    }
    return rival;
}

Rival regression(const RunContext& context, const FacePairs& training, const BasisFor& basis_for) {
    const Configuration& c = context.configuration;
    const auto model = BlendshapeModel::train(context.data.triangles(), training, {}, {});
    Rival rival;
    rival.scale_mm = model->mean().vertices.cwiseAbs().maxCoeff();
    rival.run = {{"spatial_ridge", model->spatial_ridge()},
                 {"differential_ridge", model->differential_ridge()}};
    if (c.rival == "ridge") {
        rival.ways = {
            [model](const Points& neutral) { return model->predict(neutral, {}).spatial; }};
        return rival;
    }
    const auto [basis, candidates] = basis_for(model->mean());
    const std::vector<std::int32_t>& people =
        context.split.validation.empty() ? context.split.training : context.split.validation;
    Index k = 0;
    for (const BandChoice& choice : search_band_limit(
             *model, *basis, expression_pairs(context.data, people, c.data.expression), candidates,
             {}))
        if (choice.chosen) k = choice.k;
    rival.run["band_limit"] = k > basis->num_modes() ? Json("all") : Json(k);
    if (k > basis->num_modes()) k = basis->num_vertices();
    rival.ways = {[model, basis = basis, k](const Points& neutral) {
        return model->predict(neutral, *basis, k, {});
    }};
    return rival;
}

}  // namespace

Rival make_rival(const RunContext& context, const BasisFor& basis_for) {
    const Configuration& c = context.configuration;
    const FacePairs training =
        expression_pairs(context.data, context.split.training, c.data.expression);
    Rival rival = c.rival == "mean-displacement"      ? mean_displacement(context.data, training)
                  : c.rival == "deformation-transfer" ? deformation_transfer(context.data, training)
                  : c.rival == "pca" ? principal_regression(context.data, training, c.model.latent)
                                     : regression(context, training, basis_for);
    if (rival.run.is_null()) rival.run = Json::object();
    return rival;
}

}  // namespace mien::training
