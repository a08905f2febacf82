// Kernel ridge regression with the linear kernel K = X X' / #features, centred; the prediction is
// mean(Y) + w' (Y - mean(Y)), w = (K + rho I)^-1 k(x), so it lies in the span of what was seen. rho
// minimises the leave-one-out error, which has a closed form: e_i = (Y - H Y)_i / (1 - H_ii).
// Standardising or normalising the outputs scales both sides and changes nothing, except in the
// error that chooses rho, which is taken in millimetres or deformations, as the thesis found best
// (3.3.9).
//
// The differential band is the deformation of the person's own neutral face, not of the mean:
// wrinkles and pores then come from the person, only their motion from the regression.
#include "learning/blendshapes.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "geometry/alignment.hpp"
#include "spectral/metrics.hpp"

namespace mien {
namespace {

Eigen::VectorXf flat(const Features& f) {
    return Eigen::Map<const Vector>(f.data(), f.size()).cast<float>();
}

}  // namespace

void BlendshapeModel::fit(const Samples& inputs, const Samples& outputs, double ridge, Band& band,
                          const Context& context) {
    const Index count = inputs.rows();
    const auto gram_of = [&](const Samples& samples) {
        // Row-major samples are the columns of a column-major matrix.
        const Eigen::Map<const Eigen::MatrixXf> columns(samples.data(), samples.cols(),
                                                        samples.rows());
        Matrix gram = Matrix::Zero(count, count);
        // Panels in double: sums of ten thousands of floats lose what the ridge looks at.
        for (Index first = 0; first < columns.rows(); first += 4096) {
            const Index size = std::min<Index>(4096, columns.rows() - first);
            const Matrix panel = columns.middleRows(first, size).cast<double>();
            dense::multiply(context, 1.0, panel, dense::Op::transpose, panel, dense::Op::none, 1.0,
                            gram);
        }
        return gram;
    };
    Matrix kernel = gram_of(inputs) / static_cast<double>(inputs.cols());
    band.mean_weight = kernel.rowwise().mean();
    band.grand_mean = band.mean_weight.mean();
    kernel = (kernel.colwise() - band.mean_weight).rowwise() - band.mean_weight.transpose();
    kernel.array() += band.grand_mean;
    Matrix output_gram = gram_of(outputs);
    const Vector output_mean = output_gram.rowwise().mean();
    const double output_grand = output_mean.mean();
    output_gram = (output_gram.colwise() - output_mean).rowwise() - output_mean.transpose();
    output_gram.array() += output_grand;

    const Eigen::SelfAdjointEigenSolver<Matrix> solver(kernel);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the kernel of the faces has no spectrum");
    const Vector values = solver.eigenvalues().cwiseMax(0.0);
    const Matrix& u = solver.eigenvectors();
    const double scale = std::max(values.sum() / static_cast<double>(count), 1e-300);
    const Matrix rotated = u.transpose() * output_gram * u;
    if (!(ridge > 0)) {
        double best = std::numeric_limits<double>::infinity();
        for (double candidate = 1e-4; candidate <= 1e4; candidate *= 1.7782794) {
            const Vector shrink = values.array() / (values.array() + candidate * scale);
            const Vector left = Vector::Ones(count) - shrink;
            const Matrix half = u * left.asDiagonal();
            const Vector residual = (half * rotated).cwiseProduct(half).rowwise().sum();
            const Vector leverage = (u * shrink.asDiagonal()).cwiseProduct(u).rowwise().sum();
            double error = 0;
            for (Index i = 0; i < count; ++i) {
                // The mean takes one sample's worth of each as well.
                const double free = 1.0 - leverage[i] - 1.0 / static_cast<double>(count);
                error += residual[i] / std::max(free * free, 1e-12);
            }
            if (error < best) {
                best = error;
                ridge = candidate;
            }
        }
    }
    band.ridge = ridge;
    band.inverse =
        u * (values.array() + ridge * scale).inverse().matrix().asDiagonal() * u.transpose();
}

Vector BlendshapeModel::weights(const Samples& inputs, const Eigen::VectorXf& input,
                                const Band& band) {
    Vector kernel(inputs.rows());
    for (Index i = 0; i < inputs.rows(); ++i)
        kernel[i] = inputs.row(i).cast<double>().dot(input.transpose().cast<double>()) /
                    static_cast<double>(inputs.cols());
    kernel.array() -= kernel.mean();
    kernel -= band.mean_weight;
    kernel.array() += band.grand_mean;
    Vector w = band.inverse * kernel;
    // Around the mean of the outputs: 1/N each, plus the centred weights.
    w.array() -= w.mean() - 1.0 / static_cast<double>(w.size());
    return w;
}

std::shared_ptr<const BlendshapeModel> BlendshapeModel::train(const TrianglesRef& triangles,
                                                              const FacePairs& pairs,
                                                              const BlendshapeOptions& options,
                                                              const Context& context) {
    if (pairs.count < 2 || pairs.count > options.max_samples)
        fail(Status::invalid_argument, "%lld pairs of faces; 2 to %lld are possible",
             static_cast<long long>(pairs.count), static_cast<long long>(options.max_samples));
    if (!(options.ridge >= 0) || !std::isfinite(options.ridge))
        fail(Status::invalid_argument, "a ridge of %g; 0 chooses one", options.ridge);
    auto model = std::make_shared<BlendshapeModel>();
    Points neutral, expression;
    FaceSource neutrals;
    neutrals.count = pairs.count;
    neutrals.face = [&](Index k, Points& face) { pairs.pair(k, face, expression); };
    const auto features =
        FaceFeatures::train(triangles, neutrals, FeatureKind::euclidean_standardised, context);
    model->mean_ = features->mean();
    const Index n = model->num_vertices();
    context.require_memory(
        static_cast<std::size_t>(pairs.count) * static_cast<std::size_t>(n) * 24 * 4,
        "the training faces");
    model->deformation_ = std::make_shared<DeformationRepresentation>(model->mean_, context);
    model->spatial_input_.resize(pairs.count, 3 * n);
    model->spatial_output_.resize(pairs.count, 3 * n);
    model->differential_input_.resize(pairs.count, 9 * n);
    model->differential_output_.resize(pairs.count, 9 * n);
    model->neutral_statistics_ = feature_statistics(pairs.count, [&](Index k) -> Features {
        context.check_cancelled();
        pairs.pair(k, neutral, expression);
        return align_points(neutral, model->mean_.vertices, {}, false).apply(neutral);
    });
    model->deformation_statistics_ = feature_statistics(pairs.count, [&](Index k) {
        context.check_cancelled();
        pairs.pair(k, neutral, expression);
        const Points aligned =
            align_points(neutral, model->mean_.vertices, {}, false).apply(neutral);
        Features f = model->deformation_->encode(aligned, context);
        model->differential_input_.row(k) = flat(f).transpose();
        return f;
    });
    for (Index k = 0; k < pairs.count; ++k) {
        context.progress(Stage::training,
                         static_cast<double>(k) / static_cast<double>(pairs.count));
        pairs.pair(k, neutral, expression);
        if (neutral.rows() != n || expression.rows() != n)
            fail(Status::mismatch, "pair %lld does not have %lld vertices",
                 static_cast<long long>(k), static_cast<long long>(n));
        const Similarity motion = align_points(neutral, model->mean_.vertices, {}, false);
        TriMesh own;
        own.vertices = motion.apply(neutral);
        own.triangles = model->mean_.triangles;
        const Points moved = motion.apply(expression);
        Features input = own.vertices;
        standardise(model->neutral_statistics_, input);
        model->spatial_input_.row(k) = flat(input).transpose();
        model->spatial_output_.row(k) = flat(moved - own.vertices).transpose();
        Features deformation =
            Eigen::Map<const Samples>(model->differential_input_.row(k).data(), n, 9)
                .cast<double>();
        normalise(model->deformation_statistics_, deformation);
        model->differential_input_.row(k) = flat(deformation).transpose();
        model->differential_output_.row(k) =
            flat(DeformationRepresentation(own, context).encode(moved, context)).transpose();
    }
    model->finish(options.ridge, options.ridge, context);
    context.progress(Stage::training, 1.0);
    return model;
}

void BlendshapeModel::finish(double spatial_ridge, double differential_ridge,
                             const Context& context) {
    fit(spatial_input_, spatial_output_, spatial_ridge, spatial_, context);
    fit(differential_input_, differential_output_, differential_ridge, differential_, context);
}

BlendshapeModel::Prediction BlendshapeModel::predict(const PointsRef& neutral,
                                                     const Context& context) const {
    const Index n = num_vertices();
    if (neutral.rows() != n)
        fail(Status::mismatch, "a neutral face with %lld vertices for a model with %lld",
             static_cast<long long>(neutral.rows()), static_cast<long long>(n));
    if (!neutral.allFinite())
        fail(Status::invalid_mesh, "a neutral face with a vertex that is not finite");
    const Similarity motion = align_points(neutral, mean_.vertices, {}, false);
    TriMesh own;
    own.vertices = motion.apply(neutral);
    own.triangles = mean_.triangles;
    Prediction prediction;
    Features input = own.vertices;
    standardise(neutral_statistics_, input);
    const auto combine = [&](const Samples& outputs, const Vector& w, int channels) {
        const Vector sum = outputs.cast<double>().transpose() * w;
        return Features(Eigen::Map<const Features>(sum.data(), n, channels));
    };
    prediction.spatial =
        own.vertices + combine(spatial_output_, weights(spatial_input_, flat(input), spatial_), 3);
    Features deformation = deformation_->encode(own.vertices, context);
    normalise(deformation_statistics_, deformation);
    const Features predicted = combine(
        differential_output_, weights(differential_input_, flat(deformation), differential_), 9);
    prediction.differential = DeformationRepresentation(own, context).decode(predicted, context);
    // Deformations carry no position: it comes from the spatial prediction.
    const Eigen::RowVector3d shift =
        prediction.spatial.colwise().mean() - prediction.differential.colwise().mean();
    prediction.differential.rowwise() += shift;
    const Similarity back = motion.inverse();
    prediction.spatial = back.apply(prediction.spatial);
    prediction.differential = back.apply(prediction.differential);
    return prediction;
}

Points BlendshapeModel::predict(const PointsRef& neutral, const SpectralBasis& basis, Index k,
                                const Context& context) const {
    const Prediction prediction = predict(neutral, context);
    return assemble(basis, prediction.spatial, prediction.differential, k, context);
}

void BlendshapeModel::save(const std::string& path, const Context& context) const {
    const auto n = static_cast<std::uint64_t>(num_vertices());
    const auto s = static_cast<std::uint64_t>(num_samples());
    const double ridges[2] = {spatial_.ridge, differential_.ridge};
    const auto& d = deformation_statistics_;
    write_safetensors(
        path,
        {{"mean_shape", DType::f64, {n, 3}, mean_.vertices.data()},
         {"ridges", DType::f64, {2}, ridges},
         {"neutral_mean", DType::f64, {n, 3}, neutral_statistics_.mean.data()},
         {"neutral_deviation", DType::f64, {n, 3}, neutral_statistics_.deviation.data()},
         {"deformation_least", DType::f64, {n, 9}, d.least.data()},
         {"deformation_greatest", DType::f64, {n, 9}, d.greatest.data()},
         {"spatial_input", DType::f32, {s, 3 * n}, spatial_input_.data()},
         {"spatial_output", DType::f32, {s, 3 * n}, spatial_output_.data()},
         {"differential_input", DType::f32, {s, 9 * n}, differential_input_.data()},
         {"differential_output", DType::f32, {s, 9 * n}, differential_output_.data()},
         {"triangles",
          DType::u32,
          {static_cast<std::uint64_t>(mean_.triangles.rows()), 3},
          mean_.triangles.data()}},
        {{"kind", "mien-blendshape-model"}, {"units", "millimetres"}}, context);
}

std::shared_ptr<const BlendshapeModel> BlendshapeModel::load(const std::string& path,
                                                             const SafetensorsReadOptions& options,
                                                             const Context& context) {
    const SafetensorsFile file = SafetensorsFile::open(path, options, context);
    file.require_kind("mien-blendshape-model");
    auto model = std::make_shared<BlendshapeModel>();
    const TensorView& mean = file.tensor("mean_shape", DType::f64, {-1, 3});
    const auto n = static_cast<std::int64_t>(mean.shape[0]);
    model->mean_.vertices = Eigen::Map<const Points>(static_cast<const double*>(mean.data), n, 3);
    const TensorView& triangles = file.tensor("triangles", DType::u32, {-1, 3});
    model->mean_.triangles =
        Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(triangles.data),
                                    static_cast<Index>(triangles.shape[0]), 3);
    check_mesh(model->mean_, "the model's mean shape");
    const auto statistics = [&](const char* name, std::int64_t c) -> Features {
        return Eigen::Map<const Features>(
            static_cast<const double*>(file.tensor(name, DType::f64, {n, c}).data), n, c);
    };
    model->neutral_statistics_.mean = statistics("neutral_mean", 3);
    model->neutral_statistics_.deviation = statistics("neutral_deviation", 3);
    model->deformation_statistics_.least = statistics("deformation_least", 9);
    model->deformation_statistics_.greatest = statistics("deformation_greatest", 9);
    const TensorView& first = file.tensor("spatial_input", DType::f32, {-1, 3 * n});
    const auto s = static_cast<std::int64_t>(first.shape[0]);
    if (s < 2) fail(Status::bad_format, "a blendshape model with fewer than two samples");
    const auto samples = [&](const char* name, std::int64_t columns) -> Samples {
        return Eigen::Map<const Samples>(
            static_cast<const float*>(file.tensor(name, DType::f32, {s, columns}).data), s,
            columns);
    };
    model->spatial_input_ = samples("spatial_input", 3 * n);
    model->spatial_output_ = samples("spatial_output", 3 * n);
    model->differential_input_ = samples("differential_input", 9 * n);
    model->differential_output_ = samples("differential_output", 9 * n);
    const auto* ridges = static_cast<const double*>(file.tensor("ridges", DType::f64, {2}).data);
    if (!(ridges[0] > 0) || !(ridges[1] > 0))
        fail(Status::bad_format, "a ridge that is not positive");
    model->deformation_ = std::make_shared<DeformationRepresentation>(model->mean_, context);
    model->finish(ridges[0], ridges[1], context);
    return model;
}

void mark_front(std::vector<BandChoice>& choices) {
    if (choices.empty()) return;
    BandChoice low = choices[0], high = choices[0];
    for (const BandChoice& c : choices) {
        low.l1_mm = std::min(low.l1_mm, c.l1_mm);
        low.fmpd = std::min(low.fmpd, c.fmpd);
        high.l1_mm = std::max(high.l1_mm, c.l1_mm);
        high.fmpd = std::max(high.fmpd, c.fmpd);
    }
    BandChoice* best = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (BandChoice& c : choices) {
        c.chosen = false;
        c.on_front = std::none_of(choices.begin(), choices.end(), [&](const BandChoice& o) {
            return o.l1_mm <= c.l1_mm && o.fmpd <= c.fmpd && (o.l1_mm < c.l1_mm || o.fmpd < c.fmpd);
        });
        if (!c.on_front) continue;
        const double x = (c.l1_mm - low.l1_mm) / std::max(high.l1_mm - low.l1_mm, 1e-300);
        const double y = (c.fmpd - low.fmpd) / std::max(high.fmpd - low.fmpd, 1e-300);
        if (const double distance = std::hypot(x, y); distance < nearest) {
            nearest = distance;
            best = &c;
        }
    }
    if (best != nullptr) best->chosen = true;
}

std::vector<BandChoice> search_band_limit(const BlendshapeModel& model, const SpectralBasis& basis,
                                          const FacePairs& validation,
                                          const std::vector<Index>& candidates,
                                          const Context& context) {
    const PredictBands predict = [&](const Points& neutral, Points& spatial, Points& differential) {
        BlendshapeModel::Prediction prediction = model.predict(neutral, context);
        spatial = std::move(prediction.spatial);
        differential = std::move(prediction.differential);
    };
    return search_band_limit(predict, model.mean().triangles, basis, validation, candidates,
                             context);
}

std::vector<BandChoice> search_band_limit(const PredictBands& predict, const Triangles& triangles,
                                          const SpectralBasis& basis, const FacePairs& validation,
                                          const std::vector<Index>& candidates,
                                          const Context& context) {
    if (validation.count < 1 || candidates.empty())
        fail(Status::invalid_argument, "a search over k without faces or without candidates");
    std::vector<BandChoice> choices(candidates.size());
    Points neutral, expression, spatial, differential;
    TriMesh truth, guess;
    truth.triangles = guess.triangles = triangles;
    for (Index i = 0; i < validation.count; ++i) {
        validation.pair(i, neutral, expression);
        predict(neutral, spatial, differential);
        truth.vertices = expression;
        for (std::size_t c = 0; c < candidates.size(); ++c) {
            context.progress(Stage::fitting,
                             (static_cast<double>(i) +
                              static_cast<double>(c) / static_cast<double>(candidates.size())) /
                                 static_cast<double>(validation.count));
            const Index k =
                candidates[c] > basis.num_modes() ? basis.num_vertices() : candidates[c];
            guess.vertices = assemble(basis, spatial, differential, k, context);
            choices[c].k = candidates[c];
            choices[c].l1_mm +=
                l1_distance(truth.vertices, guess.vertices) / static_cast<double>(validation.count);
            choices[c].dame += dame(truth, guess, context) / static_cast<double>(validation.count);
            choices[c].fmpd += fmpd(truth, guess, context) / static_cast<double>(validation.count);
        }
    }
    mark_front(choices);
    context.progress(Stage::fitting, 1.0);
    return choices;
}

}  // namespace mien
