// Departures from kosk-2024: (3.9) and (3.10) are not inverses of each other; (3.8) with a = -1, b
// = 1 and its inverse are used. (3.3) names the factors the wrong way round; align_points() solves
// what (3.2) asks for. The scale (3.7) takes the greatest magnitude, not the greatest signed value.
#include "learning/face_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "geometry/alignment.hpp"

namespace mien {
namespace {

constexpr double kConstant = 1e-12;  // of the largest spread of any feature

Features spread_or_one(const Features& spread) {
    const double bound = kConstant * std::max(spread.maxCoeff(), 1e-300);
    return (spread.array() > bound).select(spread, 1.0);
}

Points centred(const Points& points) {
    const Eigen::RowVector3d middle =
        0.5 * (points.colwise().minCoeff() + points.colwise().maxCoeff());
    return points.rowwise() - middle;
}

}  // namespace

const char* feature_kind_name(FeatureKind kind) {
    switch (kind) {
        case FeatureKind::euclidean:
            return "euclidean";
        case FeatureKind::euclidean_standardised:
            return "euclidean_standardised";
        case FeatureKind::euclidean_normalised:
            return "euclidean_normalised";
        case FeatureKind::deformation:
            return "deformation";
        case FeatureKind::deformation_normalised:
            return "deformation_normalised";
        case FeatureKind::deformation_standardised:
            return "deformation_standardised";
    }
    fail(Status::invalid_argument, "feature kind %d is unknown", static_cast<int>(kind));
}

FeatureKind feature_kind(const std::string& name) {
    for (int k = 1; k <= 6; ++k)
        if (name == feature_kind_name(static_cast<FeatureKind>(k)))
            return static_cast<FeatureKind>(k);
    fail(Status::bad_format, "features of an unknown kind");
}

FeatureStatistics feature_statistics(Index count, const std::function<Features(Index)>& features) {
    if (count < 1) fail(Status::invalid_argument, "statistics of no face");
    FeatureStatistics s;
    for (Index k = 0; k < count; ++k) {
        const Features f = features(k);
        if (k == 0) {
            s.mean = f;
            s.least = s.greatest = f;
            s.deviation = Features::Zero(f.rows(), f.cols());
            continue;
        }
        // Welford: stable whatever the offset.
        const Features from_old = f - s.mean;
        s.mean += from_old / static_cast<double>(k + 1);
        s.deviation += from_old.cwiseProduct(f - s.mean);
        s.least = s.least.cwiseMin(f);
        s.greatest = s.greatest.cwiseMax(f);
    }
    s.deviation = (s.deviation / static_cast<double>(count)).cwiseMax(0.0).cwiseSqrt();
    return s;
}

void standardise(const FeatureStatistics& s, Features& f) {
    f = (f - s.mean).cwiseQuotient(spread_or_one(s.deviation));
}
void destandardise(const FeatureStatistics& s, Features& f) {
    f = f.cwiseProduct(spread_or_one(s.deviation)) + s.mean;
}
void normalise(const FeatureStatistics& s, Features& f) {
    f = ((f - s.least).cwiseQuotient(spread_or_one(s.greatest - s.least)) * 2.0).array() - 1.0;
}
void denormalise(const FeatureStatistics& s, Features& f) {
    const Features unit = (f.array() + 1.0) * 0.5;
    f = unit.cwiseProduct(spread_or_one(s.greatest - s.least)) + s.least;
}

namespace {

/// One deviation (around the vertices' own means) and one range per channel. The middle of the
/// range stays each vertex' own.
void share_spread(FeatureStatistics& s) {
    for (Index c = 0; c < s.mean.cols(); ++c) {
        s.deviation.col(c).setConstant(std::sqrt(s.deviation.col(c).array().square().mean()));
        const double half = 0.5 * (s.greatest.col(c) - s.least.col(c)).maxCoeff();
        const Vector middle = 0.5 * (s.greatest.col(c) + s.least.col(c));
        s.least.col(c) = middle.array() - half;
        s.greatest.col(c) = middle.array() + half;
    }
}

}  // namespace

const DeformationRepresentation* FaceFeatures::deformation(const Context& context) const {
    if (kind_ < FeatureKind::deformation) return nullptr;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!deformation_) deformation_ = std::make_shared<DeformationRepresentation>(mean_, context);
    return deformation_.get();
}

std::shared_ptr<const FaceFeatures> FaceFeatures::train(const TrianglesRef& triangles,
                                                        const FaceSource& source, FeatureKind kind,
                                                        FeatureSpread spread,
                                                        const Context& context) {
    (void)feature_kind_name(kind);
    if (source.count < 1) fail(Status::invalid_argument, "features of no face");
    Points face;
    source.face(0, face);
    Points mean = face;
    const Index n = mean.rows();
    for (int round = 0; round < 3; ++round) {
        Points sum = Points::Zero(n, 3);
        for (Index k = 0; k < source.count; ++k) {
            context.progress(
                Stage::alignment,
                (round + static_cast<double>(k) / static_cast<double>(source.count)) / 3);
            source.face(k, face);
            if (face.rows() != n)
                fail(Status::mismatch, "face %lld has %lld vertices, the first one %lld",
                     static_cast<long long>(k), static_cast<long long>(face.rows()),
                     static_cast<long long>(n));
            sum += align_points(face, mean, {}, false).apply(face);
        }
        sum /= static_cast<double>(source.count);
        // The mean drifts in no direction: it is put back onto the first one.
        mean = align_points(sum, mean, {}, false).apply(sum);
    }
    auto features = std::make_shared<FaceFeatures>();
    features->kind_ = kind;
    features->mean_.vertices = centred(mean);
    features->mean_.triangles = triangles;
    check_mesh(features->mean_, "the mean shape");
    double largest = 0;
    for (Index k = 0; k < source.count; ++k) {
        context.check_cancelled();
        source.face(k, face);
        const Points moved = align_points(face, features->mean_.vertices, {}, false).apply(face);
        largest = std::max(largest, moved.cwiseAbs().maxCoeff());
    }
    if (!(largest > 0)) fail(Status::invalid_mesh, "faces without extent");
    features->scale_mm_ = largest;
    features->statistics_ = feature_statistics(source.count, [&](Index k) {
        context.progress(Stage::training,
                         static_cast<double>(k) / static_cast<double>(source.count));
        source.face(k, face);
        return features->raw(face, nullptr, context);
    });
    if (spread == FeatureSpread::per_channel) share_spread(features->statistics_);
    context.progress(Stage::training, 1.0);
    return features;
}

std::shared_ptr<const FaceFeatures> FaceFeatures::around(
    const TriMesh& mean, double scale_mm, FeatureKind kind, FeatureSpread spread, Index count,
    const std::function<Features(Index)>& raw) {
    check_mesh(mean, "the features' mean shape");
    if (!(scale_mm > 0)) fail(Status::invalid_argument, "features of a scale of %g mm", scale_mm);
    auto features = std::make_shared<FaceFeatures>();
    features->kind_ = kind;
    features->mean_ = mean;
    features->scale_mm_ = scale_mm;
    features->statistics_ = feature_statistics(count, raw);
    const Features& first = features->statistics_.mean;
    if (first.rows() != features->num_vertices() || first.cols() != features->num_channels())
        fail(Status::mismatch, "%lld x %lld features instead of %lld x %d",
             static_cast<long long>(first.rows()), static_cast<long long>(first.cols()),
             static_cast<long long>(features->num_vertices()), features->num_channels());
    if (spread == FeatureSpread::per_channel) share_spread(features->statistics_);
    return features;
}

Points onto_mean_shape(const PointsRef& face, const TriMesh& mean, Similarity* motion) {
    if (face.rows() != mean.vertices.rows())
        fail(Status::mismatch, "a face with %lld vertices for features of %lld",
             static_cast<long long>(face.rows()), static_cast<long long>(mean.vertices.rows()));
    if (!face.allFinite()) fail(Status::invalid_mesh, "a face with a vertex that is not finite");
    const Similarity onto_mean = align_points(face, mean.vertices, {}, false);
    if (motion != nullptr) *motion = onto_mean;
    return onto_mean.apply(face);
}

Features FaceFeatures::raw(const PointsRef& face, Similarity* motion,
                           const Context& context) const {
    return raw_aligned(onto_mean_shape(face, mean_, motion), context);
}

Features FaceFeatures::raw_aligned(const PointsRef& aligned, const Context& context) const {
    // Deformations have no unit: a common scale of face and template cancels.
    if (const auto* deformation = this->deformation(context))
        return deformation->encode(aligned, context);
    return aligned / scale_mm_;
}

Features FaceFeatures::encode(const PointsRef& face, Similarity* motion,
                              const Context& context) const {
    return prepare(raw(face, motion, context));
}

Features FaceFeatures::encode_aligned(const PointsRef& aligned, const Context& context) const {
    return prepare(raw_aligned(aligned, context));
}

Features FaceFeatures::prepare(Features f) const {
    if (kind_ == FeatureKind::euclidean_standardised ||
        kind_ == FeatureKind::deformation_standardised)
        standardise(statistics_, f);
    if (kind_ == FeatureKind::euclidean_normalised || kind_ == FeatureKind::deformation_normalised)
        normalise(statistics_, f);
    return f;
}

Points FaceFeatures::decode(const Eigen::Ref<const Features>& features, const Similarity* motion,
                            const Context& context) const {
    if (features.rows() != num_vertices() || features.cols() != num_channels())
        fail(Status::mismatch, "%lld x %lld features instead of %lld x %d",
             static_cast<long long>(features.rows()), static_cast<long long>(features.cols()),
             static_cast<long long>(num_vertices()), num_channels());
    if (!features.allFinite()) fail(Status::invalid_argument, "features that are not finite");
    const Features f = restore(features);
    const auto* deformation = this->deformation(context);
    const Points face =
        deformation != nullptr ? deformation->decode(f, context) : Points(f * scale_mm_);
    return motion != nullptr ? motion->inverse().apply(face) : face;
}

Features FaceFeatures::restore(const Eigen::Ref<const Features>& features) const {
    Features f = features;
    if (kind_ == FeatureKind::euclidean_standardised ||
        kind_ == FeatureKind::deformation_standardised)
        destandardise(statistics_, f);
    if (kind_ == FeatureKind::euclidean_normalised || kind_ == FeatureKind::deformation_normalised)
        denormalise(statistics_, f);
    return f;
}

void FaceFeatures::append_to(const std::string& prefix, std::vector<TensorToWrite>& tensors,
                             std::map<std::string, std::string>& metadata) const {
    const auto n = static_cast<std::uint64_t>(num_vertices());
    const auto c = static_cast<std::uint64_t>(num_channels());
    tensors.push_back({prefix + "mean_shape", DType::f64, {n, 3}, mean_.vertices.data()});
    tensors.push_back({prefix + "scale_mm", DType::f64, {1}, &scale_mm_});
    tensors.push_back({prefix + "mean", DType::f64, {n, c}, statistics_.mean.data()});
    tensors.push_back({prefix + "deviation", DType::f64, {n, c}, statistics_.deviation.data()});
    tensors.push_back({prefix + "least", DType::f64, {n, c}, statistics_.least.data()});
    tensors.push_back({prefix + "greatest", DType::f64, {n, c}, statistics_.greatest.data()});
    tensors.push_back({prefix + "triangles",
                       DType::u32,
                       {static_cast<std::uint64_t>(mean_.triangles.rows()), 3},
                       mean_.triangles.data()});
    metadata[prefix + "features"] = feature_kind_name(kind_);
}

void FaceFeatures::save(const std::string& path, const Context& context) const {
    std::vector<TensorToWrite> tensors;
    std::map<std::string, std::string> metadata{{"kind", "mien-face-features"},
                                                {"units", "millimetres"}};
    append_to("", tensors, metadata);
    write_safetensors(path, tensors, std::move(metadata), context);
}

std::shared_ptr<const FaceFeatures> FaceFeatures::load(const std::string& path,
                                                       const SafetensorsReadOptions& options,
                                                       const Context& context) {
    const SafetensorsFile file = SafetensorsFile::open(path, options, context);
    file.require_kind("mien-face-features");
    return read(file, "");
}

std::shared_ptr<const FaceFeatures> FaceFeatures::read(const SafetensorsFile& file,
                                                       const std::string& prefix) {
    auto features = std::make_shared<FaceFeatures>();
    features->kind_ = feature_kind(file.metadata(prefix + "features"));
    const TensorView& mean = file.tensor(prefix + "mean_shape", DType::f64, {-1, 3});
    const auto n = static_cast<std::int64_t>(mean.shape[0]);
    const std::int64_t c = features->num_channels();
    features->mean_.vertices =
        Eigen::Map<const Points>(static_cast<const double*>(mean.data), n, 3);
    const TensorView& triangles = file.tensor(prefix + "triangles", DType::u32, {-1, 3});
    features->mean_.triangles =
        Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(triangles.data),
                                    static_cast<Index>(triangles.shape[0]), 3);
    check_mesh(features->mean_, "the features' mean shape");
    features->scale_mm_ =
        *static_cast<const double*>(file.tensor(prefix + "scale_mm", DType::f64, {1}).data);
    if (!(features->scale_mm_ > 0))
        fail(Status::bad_format, "features with a scale that is not positive");
    const auto matrix = [&](const char* name) -> Features {
        return Eigen::Map<const Features>(
            static_cast<const double*>(file.tensor(prefix + name, DType::f64, {n, c}).data), n, c);
    };
    features->statistics_ = {matrix("mean"), matrix("deviation"), matrix("least"),
                             matrix("greatest")};
    return features;
}

}  // namespace mien
