#include "expression/training.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "base/dense.hpp"
#include "base/error.hpp"

namespace mien {
namespace {

std::string number_text(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    return std::string(text, end.ptr);
}

/// Modes in the model's own memory, with what the model needs of them.
struct ModesStorage {
    Eigen::MatrixXf identity, expression;
};

/// Decides the sign of a mode by the mode alone, whatever basis it was found in: its product with a
/// fixed irregular pattern, which no mode is orthogonal to by its symmetry.
double side_of(const Eigen::Ref<const Vector>& mode) {
    double sum = 0.0;
    for (Index row = 0; row < mode.size(); ++row)
        sum += mode[row] * std::sin(0.7 + 12.9898 * static_cast<double>(row % 1009));
    return sum;
}

Vector root_mean_square_rows(const Matrix& coordinates, double count) {
    const Vector values = (coordinates.rowwise().squaredNorm() / count).cwiseSqrt();
    // A direction without variance would make the prior singular.
    return values.cwiseMax(1e-6 * std::max(values.maxCoeff(), 1e-6));
}

/// The identity coordinates (p x m) of each displacement's person, p x s.
Matrix identities_of_faces(const ColumnSource& source, const Matrix& identity_coordinates) {
    std::map<int, Index> column_of;
    for (Index k = 0; k < source.num_neutrals(); ++k)
        column_of[source.neutral_subject[static_cast<std::size_t>(k)]] = k;
    Matrix identities(identity_coordinates.rows(), source.num_displacements());
    for (Index k = 0; k < source.num_displacements(); ++k)
        identities.col(k) = identity_coordinates.col(
            column_of.at(source.displacement_subject[static_cast<std::size_t>(k)]));
    return identities;
}

void fill_report(const ColumnSource& source, const JointSpan& span, const JointPca& subspaces,
                 const Matrix& identity_coordinates, const Matrix& expression_coordinates,
                 const NoiseLevels& noise, TrainReport& report) {
    report.subjects = source.num_neutrals();
    report.faces = source.num_neutrals() + source.num_displacements();
    report.skipped_faces = source.num_skipped;
    report.k = subspaces.k;
    report.lambda = subspaces.lambda;
    report.iterations = subspaces.iterations;
    report.last_angle_rad = subspaces.last_angle_rad;
    report.converged = subspaces.converged;
    report.orthogonality = orthogonality_scores(subspaces.identity, subspaces.expression);
    report.joint_pca_orthogonality = subspaces.start_orthogonality;
    report.identity_explained = identity_coordinates.squaredNorm() / span.neutral_energy;
    report.expression_explained = expression_coordinates.squaredNorm() / span.displacement_energy;
    report.span_cut = (span.neutral_energy_cut + span.displacement_energy_cut) /
                      (span.neutral_energy + span.displacement_energy);
    report.noise = noise;
}

/// The span of the training columns, wide enough for the modes asked for.
JointSpan span_for(const Context& context, const ColumnSource& source,
                   const TrainOptions& options) {
    JointSpanOptions span = options.span;
    const auto default_rank = [&](Index modes) {
        if (modes == 0 && !options.search.counts.empty()) modes = options.search.counts.back();
        return std::max(3 * modes, modes + 60);
    };
    if (span.identity_rank == 0)
        span.identity_rank = default_rank(options.subspaces.identity_modes);
    if (span.expression_rank == 0)
        span.expression_rank = default_rank(options.subspaces.expression_modes);
    return find_joint_span(context, source, span);
}

/// Unit modes in 3#V from coordinates in the span, whose columns take the side that side_of()
/// chooses.
Eigen::MatrixXf lift_modes(const Context& context, const JointSpan& span, Matrix& coordinates) {
    Matrix modes(span.basis.rows(), coordinates.cols());
    dense::multiply(context, 1.0, span.basis, dense::Op::none, coordinates, dense::Op::none, 0.0,
                    modes);
    for (Index k = 0; k < modes.cols(); ++k)
        if (side_of(modes.col(k)) < 0.0) {
            modes.col(k) *= -1.0;
            coordinates.col(k) *= -1.0;
        }
    return modes.cast<float>();
}

ModesView view_of(const Eigen::MatrixXf& modes) {
    return ModesView{modes.data(), modes.rows(), modes.cols()};
}

void put_gram(const Matrix& identity, const Matrix& expression, ExpressionModel& model) {
    Matrix modes(identity.rows(), identity.cols() + expression.cols());
    modes << identity, expression;
    model.gram = modes.transpose() * modes;
}

/// Mean, modes and their products, and the sides of `subspaces` with them.
void put_modes(const Context& context, const ColumnSource& source, const JointSpan& span,
               JointPca& subspaces, ExpressionModel& model) {
    model.mean = Eigen::Map<const Points>(span.mean.data(), source.num_vertices, 3);
    model.triangles = source.triangles;
    auto storage = std::make_shared<ModesStorage>();
    storage->identity = lift_modes(context, span, subspaces.identity);
    storage->expression = lift_modes(context, span, subspaces.expression);
    model.identity_modes = view_of(storage->identity);
    model.expression_modes = view_of(storage->expression);
    model.storage = storage;
    put_gram(subspaces.identity, subspaces.expression, model);
}

/// The training faces in coordinates of the modes.
struct Coordinates {
    Matrix identity;    ///< p x m, of the neutral faces
    Matrix expression;  ///< q x s, of the displacements
};

/// How far coordinates go; with quasi-orthogonal modes also how they spill into each other.
void put_deviations(const ColumnSource& source, const JointSpan& span, const JointPca& subspaces,
                    const Coordinates& coordinates, const TrainOptions& options,
                    ExpressionModel& model) {
    const double m = static_cast<double>(source.num_neutrals());
    const double s = static_cast<double>(source.num_displacements());
    model.identity_deviations = root_mean_square_rows(coordinates.identity, std::max(1.0, m - 1.0));
    model.expression_deviations = root_mean_square_rows(coordinates.expression, s);
    if (options.subspaces.method == TrainMethod::quasi_orthogonal)
        model.spill = learn_spill(
            coordinates.identity, subspaces.expression.transpose() * span.neutrals,
            subspaces.identity.transpose() * span.displacements, coordinates.expression);
    model.expression_names = source.expression_names;
    model.stable_vertices = source.stable_vertices;
}

void put_components(const ColumnSource& source, const Coordinates& coordinates,
                    const PriorOptions& prior, ExpressionModel& model) {
    model.components = expression_components(coordinates.expression, source.displacement_expression,
                                             source.expression_names, model.expression_deviations,
                                             identities_of_faces(source, coordinates.identity),
                                             model.identity_deviations, prior);
    model.intensities = intensities_for(source.displacement_expression, prior);
}

/// What leaving people out decides.
struct HeldOut {
    FollowChoice follow;
    SmoothChoice smooth;
};

/// The expressions' components and the noise of both fits, given or by leaving people out, and with
/// it what people may differ by beyond the training's.
HeldOut put_priors(const Context& context, const ColumnSource& source, const JointSpan& span,
                   const Matrix& smooth, const JointPca& subspaces, const Coordinates& coordinates,
                   const TrainOptions& options, ExpressionModel& model) {
    HeldOut choice;
    PriorOptions prior = options.prior;
    if (options.map_noise_mm2 <= 0.0 || options.mixture_noise_mm2 <= 0.0) {
        Matrix basis = subspaces.expression;
        if (!model.spill.empty()) basis += subspaces.identity * model.spill.expression;
        choice.follow = choose_following(context, source, span, basis, coordinates.expression,
                                         options.subspaces.identity_modes, prior);
        prior.identity_directions = choice.follow.directions;
        choice.smooth = choose_smooth_prior(context, source, span, basis, coordinates.expression,
                                            options.subspaces.identity_modes, prior, options.smooth,
                                            smooth, choice.follow.noise);
    }
    put_components(source, coordinates, prior, model);
    const NoiseLevels& noise = choice.smooth.noise;
    model.map_noise_mm2 = options.map_noise_mm2 > 0.0 ? options.map_noise_mm2 : noise.map_mm2;
    model.mixture_noise_mm2 =
        options.mixture_noise_mm2 > 0.0 ? options.mixture_noise_mm2 : noise.mixture_mm2;
    model.expected_residual_mm = noise.residual_mm;
    return choice;
}

/// Appends the smooth directions to the identity modes, whose coordinates get a full covariance.
void put_smooth_modes(const Context& context, const JointSpan& span, const JointPca& subspaces,
                      const SmoothPrior& prior, ExpressionModel& model) {
    const Index p = subspaces.identity.cols(), q = subspaces.expression.cols();
    Matrix moved = subspaces.identity;
    if (!model.spill.empty()) moved += subspaces.expression * model.spill.identity;
    SmoothIdentity smooth = smooth_identity(subspaces.identity, moved, model.identity_deviations,
                                            prior.gram, prior.variance_mm2, prior.most_modes);
    const Index extra = smooth.modes.cols();
    if (extra == 0) return;
    Vector sides = Vector::Ones(p + extra);
    Matrix sided = smooth.modes;
    const Eigen::MatrixXf lifted = lift_modes(context, span, sided);
    for (Index k = 0; k < extra; ++k)
        if (sided.col(k).dot(smooth.modes.col(k)) < 0.0) sides[p + k] = -1.0;
    model.identity_covariance = sides.asDiagonal() * smooth.covariance * sides.asDiagonal();
    model.smooth_modes = extra;
    const Vector deviations = model.identity_covariance.diagonal().tail(extra).cwiseSqrt();
    model.identity_deviations.conservativeResize(p + extra);
    model.identity_deviations.tail(extra) = deviations;

    auto storage = std::make_shared<ModesStorage>();
    storage->identity.resize(lifted.rows(), p + extra);
    storage->identity << model.identity_modes.map(), lifted;
    storage->expression = model.expression_modes.map();
    model.identity_modes = view_of(storage->identity);
    model.expression_modes = view_of(storage->expression);
    model.storage = storage;
    Matrix identity(sided.rows(), p + extra);
    identity << subspaces.identity, sided;
    put_gram(identity, subspaces.expression, model);
    if (model.spill.empty()) return;  // smooth directions spill nowhere
    model.spill.identity.conservativeResizeLike(Matrix::Zero(q, p + extra));
    model.spill.expression.conservativeResizeLike(Matrix::Zero(p + extra, q));
}

std::map<std::string, std::string> training_info(const ColumnSource& source,
                                                 const JointPca& subspaces, bool quasi) {
    std::map<std::string, std::string> info;
    info["method"] = quasi ? "qojpca" : "jpca";
    info["subjects"] = std::to_string(source.num_neutrals());
    info["faces"] = std::to_string(source.num_neutrals() + source.num_displacements());
    if (quasi) {
        info["lambda"] = number_text(subspaces.lambda);
        info["iterations"] = std::to_string(subspaces.iterations);
        info["converged"] = subspaces.converged ? "yes" : "no";
    }
    return info;
}

}  // namespace

std::shared_ptr<const ExpressionModel> train_expression_model(const ColumnSource& source,
                                                              const TrainOptions& given,
                                                              const Context& context,
                                                              TrainReport* report) {
    if (given.subspaces.identity_modes > 4000 || given.subspaces.expression_modes > 4000)
        fail(Status::invalid_argument, "at most 4000 modes of each kind can be trained");
    const JointSpan span = span_for(context, source, given);
    TrainOptions options = given;
    JointPcaOptions& counts = options.subspaces;
    const bool smoothed = options.smooth.modes > 0;
    const Matrix smooth = smoothed ? smooth_gram(context, span, options.smooth) : Matrix();
    ModeChoice choice;
    if (counts.identity_modes == 0 || counts.expression_modes == 0) {
        choice = choose_modes(context, source, span, counts.identity_modes, counts.expression_modes,
                              options.prior, options.search);
        counts.identity_modes = choice.identity_modes;
        counts.expression_modes = choice.expression_modes;
    }
    JointPca subspaces = joint_pca(context, span.neutrals, span.displacements, options.subspaces);
    auto model = std::make_shared<ExpressionModel>();
    put_modes(context, source, span, subspaces, *model);
    const Coordinates coordinates{subspaces.identity.transpose() * span.neutrals,
                                  subspaces.expression.transpose() * span.displacements};
    put_deviations(source, span, subspaces, coordinates, options, *model);
    HeldOut held_out =
        put_priors(context, source, span, smooth, subspaces, coordinates, options, *model);
    SmoothChoice& noise = held_out.smooth;
    put_smooth_modes(context, span, subspaces, noise.prior, *model);
    model->info =
        training_info(source, subspaces, options.subspaces.method == TrainMethod::quasi_orthogonal);
    finish_expression_model(*model);
    if (model->smooth_modes > 0)
        put_people(*model, {options.map_noise_mm2 > 0.0 ? options.map_noise_mm2
                                                        : held_out.follow.noise.map_mm2,
                            options.mixture_noise_mm2 > 0.0 ? options.mixture_noise_mm2
                                                            : held_out.follow.noise.mixture_mm2,
                            held_out.follow.noise.residual_mm});
    if (report != nullptr)
        fill_report(source, span, subspaces, coordinates.identity, coordinates.expression,
                    noise.noise, *report);
    if (report != nullptr) {
        report->tried_modes = std::move(choice.tried);
        report->tried_smoothness = std::move(noise.tried);
        report->smooth_modes = model->smooth_modes;
        report->smooth_variance_mm2 = model->smooth_modes > 0 ? noise.prior.variance_mm2 : 0.0;
    }
    context.progress(Stage::training, 1.0);
    return model;
}

std::shared_ptr<const ExpressionModel> train_expression_model(
    std::shared_ptr<const FaceDataset> dataset, const TrainOptions& options, const Context& context,
    TrainReport* report) {
    return train_expression_model(*dataset_columns(std::move(dataset), {}, options.stable_vertices),
                                  options, context, report);
}

}  // namespace mien
