#include "learning/band_features.hpp"

#include "base/error.hpp"

namespace mien {
namespace {

bool gives_place(FeatureKind kind) {
    return kind < FeatureKind::deformation;
}

void check_kinds(FeatureKind low, FeatureKind high, Status status) {
    if (!gives_place(low) || gives_place(high))
        fail(status,
             "the low band is %s and the high one %s; coordinates below and deformations "
             "above are possible",
             feature_kind_name(low), feature_kind_name(high));
}

}  // namespace

std::shared_ptr<const BandFeatures> BandFeatures::make(std::shared_ptr<const FaceFeatures> low,
                                                       std::shared_ptr<const FaceFeatures> high,
                                                       std::shared_ptr<const SpectralBasis> basis,
                                                       Index band_limit) {
    check_kinds(low->kind(), high->kind(), Status::bad_format);
    const TriMesh &mean = low->mean(), &other = high->mean();
    if (mean.vertices.rows() != other.vertices.rows() || mean.triangles != other.triangles ||
        basis->num_vertices() != mean.vertices.rows())
        fail(Status::bad_format, "the bands are of different templates");
    if (band_limit < 1 || band_limit > basis->num_modes())
        fail(Status::bad_format, "a low band of %lld modes over a basis of %lld",
             static_cast<long long>(band_limit), static_cast<long long>(basis->num_modes()));
    auto bands = std::make_shared<BandFeatures>();
    bands->low_ = std::move(low);
    bands->high_ = std::move(high);
    bands->basis_ = std::move(basis);
    bands->band_limit_ = band_limit;
    return bands;
}

std::shared_ptr<const BandFeatures> BandFeatures::train(const TrianglesRef& triangles,
                                                        const FaceSource& source,
                                                        const BandFeatureOptions& options,
                                                        const Context& context) {
    check_kinds(options.low_kind, options.high_kind, Status::invalid_argument);
    const Index k = options.band_limit;
    const auto whole = FaceFeatures::train(triangles, source, FeatureKind::euclidean, context);
    const TriMesh& mean = whole->mean();
    SpectralBasisOptions basis_options;
    basis_options.num_modes = k;
    const auto basis = build_spectral_basis(mean, basis_options, context);
    const DeformationRepresentation deformation(mean, context);
    Points face;
    const auto aligned = [&](Index sample) {
        context.progress(Stage::training,
                         static_cast<double>(sample) / static_cast<double>(source.count));
        source.face(sample, face);
        return onto_mean_shape(face, mean, nullptr);
    };
    auto low = FaceFeatures::around(mean, whole->scale_mm(), options.low_kind, options.spread,
                                    source.count, [&](Index sample) -> Features {
                                        return low_band(*basis, aligned(sample), k, context) /
                                               whole->scale_mm();
                                    });
    auto high = FaceFeatures::around(
        mean, whole->scale_mm(), options.high_kind, options.spread, source.count,
        [&](Index sample) {
            return deformation.encode(high_band(*basis, aligned(sample), k, context), context);
        });
    return make(std::move(low), std::move(high), basis, k);
}

BandFeatures::Pair BandFeatures::encode(const PointsRef& face, Similarity* motion,
                                        const Context& context) const {
    const Points aligned = onto_mean_shape(face, mean(), motion);
    const Points low = low_band(*basis_, aligned, band_limit_, context);
    // The rest: what the low band did not take, exactly (4.11).
    const Points high = mean().vertices + (aligned - low);
    return {low_->encode_aligned(low, context), high_->encode_aligned(high, context)};
}

Points BandFeatures::decode(const Eigen::Ref<const Features>& low,
                            const Eigen::Ref<const Features>& high, const Similarity* motion,
                            const Context& context) const {
    const Points face = assemble(*basis_, low_->decode(low, nullptr, context),
                                 high_->decode(high, nullptr, context), band_limit_, context);
    return motion != nullptr ? motion->inverse().apply(face) : face;
}

std::shared_ptr<const SpectralBasis> read_basis_part(const SafetensorsFile& file,
                                                     const TriMesh& mean) {
    const std::int64_t n = mean.vertices.rows();
    const TensorView& vectors = file.tensor("basis.vectors", DType::f64, {n, -1});
    const auto modes = static_cast<std::int64_t>(vectors.shape[1]);
    if (modes < 1 || modes >= n)
        fail(Status::bad_format, "a basis of %lld modes over %lld vertices",
             static_cast<long long>(modes), static_cast<long long>(n));
    const auto column = [&](const char* name, std::int64_t size) -> Vector {
        return Eigen::Map<const Vector>(
            static_cast<const double*>(file.tensor(name, DType::f64, {size}).data), size);
    };
    auto basis = std::make_shared<SpectralBasis>();
    basis->mean_mesh = mean;
    basis->values = column("basis.values", modes);
    basis->mass = column("basis.mass", n);
    if (!(basis->mass.array() > 0).all())
        fail(Status::bad_format, "a basis with a mass that is not positive");
    basis->vectors = static_cast<const double*>(vectors.data);
    basis->storage = file.storage();
    basis->mass_kind = file.metadata("basis.mass");
    basis->negative_kind = file.metadata("basis.cotangents");
    return basis;
}

void append_basis(const SpectralBasis& basis, std::vector<TensorToWrite>& tensors,
                  std::map<std::string, std::string>& metadata) {
    const auto n = static_cast<std::uint64_t>(basis.num_vertices());
    const auto modes = static_cast<std::uint64_t>(basis.num_modes());
    tensors.push_back({"basis.values", DType::f64, {modes}, basis.values.data()});
    tensors.push_back({"basis.mass", DType::f64, {n}, basis.mass.data()});
    tensors.push_back({"basis.vectors", DType::f64, {n, modes}, basis.vectors});
    metadata["basis.mass"] = basis.mass_kind;
    metadata["basis.cotangents"] = basis.negative_kind;
}

}  // namespace mien
