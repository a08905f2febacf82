#include "model/sampling.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"

namespace mien {
namespace {

constexpr std::size_t kVertexChunk = 1024;

}  // namespace

Points displacement(const DeformationModel& model, const ModelCoefficients& coefficients,
                    const Context& context) {
    const Index n = model.num_vertices(), r = coefficients.kernel.rows(),
                p = coefficients.pca.size();
    if (r > model.basis.cols || (r != 0 && coefficients.kernel.cols() != 3))
        fail(Status::mismatch, "%lld x %lld kernel coefficients for a model of %lld scalar modes",
             static_cast<long long>(r), static_cast<long long>(coefficients.kernel.cols()),
             static_cast<long long>(model.basis.cols));
    if (p > model.pca_modes.cols)
        fail(Status::mismatch, "%lld vector coefficients for a model of %lld vector modes",
             static_cast<long long>(p), static_cast<long long>(model.pca_modes.cols));
    Points result =
        model.mean_displacement.rows() != 0 ? model.mean_displacement : Points::Zero(n, 3);
    const auto basis = model.basis.map();
    const auto modes = model.pca_modes.map();
    parallel_for(context, static_cast<std::size_t>(n), kVertexChunk,
                 [&](std::size_t begin, std::size_t end) {
                     const Index first = static_cast<Index>(begin),
                                 size = static_cast<Index>(end - begin);
                     for (Index j = 0; j < r; ++j) {
                         const Eigen::RowVector3d a = coefficients.kernel.row(j);
                         result.middleRows(first, size).noalias() +=
                             basis.col(j).segment(first, size).cast<double>() * a;
                     }
                     for (Index j = 0; j < p; ++j)
                         for (Index v = first; v < first + size; ++v)
                             for (int c = 0; c < 3; ++c)
                                 result(v, c) +=
                                     static_cast<double>(modes(3 * v + c, j)) * coefficients.pca[j];
                 });
    return result;
}

TriMesh sample_face(const DeformationModel& model, std::uint64_t seed, std::uint64_t index,
                    double strength, const Context& context) {
    if (!(strength >= 0) || !std::isfinite(strength))
        fail(Status::invalid_argument, "sampling strength %g must be a number >= 0", strength);
    const CounterRandom random(seed, index);
    ModelCoefficients coefficients;
    coefficients.kernel.resize(model.basis.cols, 3);
    std::uint64_t drawn = 0;
    for (Index j = 0; j < model.basis.cols; ++j)
        for (int c = 0; c < 3; ++c) {
            const double deviation =
                model.prior_variance.rows() != 0 ? std::sqrt(model.prior_variance(j, c)) : 1.0;
            coefficients.kernel(j, c) = strength * deviation * random.normal(drawn++);
        }
    coefficients.pca.resize(model.pca_modes.cols);
    for (Index j = 0; j < model.pca_modes.cols; ++j)
        coefficients.pca[j] = strength * random.normal(drawn++);
    TriMesh face = model.template_mesh;
    face.vertices += displacement(model, coefficients, context);
    return face;
}

Points pointwise_variance(const DeformationModel& model, const Context& context) {
    const Index n = model.num_vertices();
    Points variance = Points::Zero(n, 3);
    const auto basis = model.basis.map();
    const auto modes = model.pca_modes.map();
    parallel_for(
        context, static_cast<std::size_t>(n), kVertexChunk,
        [&](std::size_t begin, std::size_t end) {
            const Index first = static_cast<Index>(begin), size = static_cast<Index>(end - begin);
            for (Index j = 0; j < basis.cols(); ++j) {
                const Vector squared = basis.col(j).segment(first, size).cast<double>().cwiseAbs2();
                for (int c = 0; c < 3; ++c) {
                    const double prior =
                        model.prior_variance.rows() != 0 ? model.prior_variance(j, c) : 1.0;
                    variance.col(c).segment(first, size) += prior * squared;
                }
            }
            for (Index j = 0; j < modes.cols(); ++j)
                for (Index v = first; v < first + size; ++v)
                    for (int c = 0; c < 3; ++c) {
                        const double value = modes(3 * v + c, j);
                        variance(v, c) += value * value;
                    }
        });
    return variance;
}

}  // namespace mien
