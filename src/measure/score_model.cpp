#include "measure/score_model.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "measure/distributions.hpp"
#include "measure/pair_check.hpp"
#include "measure/score_features.hpp"

namespace mien {
namespace {

void check_face(const ScoreModel& model, const PointsRef& face) {
    if (face.rows() != model.mean_face.rows())
        fail(Status::mismatch,
             "the face has %lld vertices, the score model %lld; fit it with the same template",
             static_cast<long long>(face.rows()), static_cast<long long>(model.mean_face.rows()));
    check_surface(face, model.triangles, "the face");
}

Vector latent_scores(const ScoreModel& model, const Points& aligned) {
    Eigen::RowVectorXd row(model.feature_mean.size());
    features_of(aligned, model.mean_face, model.triangles,
                {model.displacement_scale, model.curvature_scale, model.curvature_radius_mm,
                 model.shape_scale},
                row);
    return model.rotations.transpose() * (row.transpose() - model.feature_mean);
}

}  // namespace

ScorePrediction predict_score(const ScoreModel& model, const PointsRef& face,
                              const Context& context) {
    check_face(model, face);
    context.check_cancelled();
    const Points aligned = align_face(face, model.mean_face, model.triangles, model.stable_zone);
    const Vector t = latent_scores(model, aligned);
    ScorePrediction result;
    result.score = model.y_mean + model.y_loadings.dot(t);
    result.leverage = (t.array().square() / model.score_squares.array()).sum();
    const double n = static_cast<double>(model.num_samples);
    const double a = static_cast<double>(model.num_components());
    result.extrapolates = result.leverage > 3.0 * (a + 1.0) / n;
    const double half = student_t_quantile(0.975, std::max(1.0, n - a - 1.0)) * model.rmse *
                        std::sqrt((1 + 1 / n + result.leverage) / (1 + (a + 1) / n));
    result.low95 = result.score - half;
    result.high95 = result.score + half;
    if (model.highest > model.lowest) {
        auto limit = [&](double v) { return std::clamp(v, model.lowest, model.highest); };
        result.score = limit(result.score);
        result.low95 = limit(result.low95);
        result.high95 = limit(result.high95);
    }
    return result;
}

Points simulate_score(const ScoreModel& model, const PointsRef& face, double target,
                      const Context& context) {
    check_face(model, face);
    context.check_cancelled();
    if (!std::isfinite(target)) fail(Status::invalid_argument, "the target score is not finite");
    const RigidZoneResult pose = pose_of(face, model.mean_face, model.triangles, model.stable_zone);
    Points aligned = pose.motion.apply(face);
    const double own = model.y_mean + model.y_loadings.dot(latent_scores(model, aligned));
    aligned += (target - own) * model.unit_displacement;
    return pose.motion.inverse().apply(PointsRef(aligned));
}

}  // namespace mien
