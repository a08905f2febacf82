#include "learning/displacement_features.hpp"

#include "base/error.hpp"

namespace mien {
namespace {

bool of_deformations(FeatureKind kind) {
    return kind >= FeatureKind::deformation;
}

Features raw_of(FeatureKind kind, double scale_mm, const Triangles& triangles,
                const Points& neutral, const Points& expression, const Context& context) {
    if (!of_deformations(kind)) return (expression - neutral) / scale_mm;
    TriMesh own;
    own.vertices = neutral;
    own.triangles = triangles;
    return DeformationRepresentation(own, context).encode(expression, context);
}

}  // namespace

Features raw_displacement(const FaceFeatures& output, const Points& neutral,
                          const Points& expression, const Context& context) {
    return raw_of(output.kind(), output.scale_mm(), output.mean().triangles, neutral, expression,
                  context);
}

std::shared_ptr<const FaceFeatures> train_displacements(const FaceFeatures& neutral,
                                                        const FacePairs& pairs, FeatureKind kind,
                                                        FeatureSpread spread,
                                                        const Context& context) {
    Points own, face;
    const TriMesh& mean = neutral.mean();
    return FaceFeatures::around(
        mean, neutral.scale_mm(), kind, spread, pairs.count, [&](Index k) -> Features {
            context.progress(Stage::training,
                             static_cast<double>(k) / static_cast<double>(pairs.count));
            pairs.pair(k, own, face);
            Similarity motion;
            const Points aligned = onto_mean_shape(own, mean, &motion);
            return raw_of(kind, neutral.scale_mm(), mean.triangles, aligned, motion.apply(face),
                          context);
        });
}

Points add_displacement(const FaceFeatures& output, const Points& neutral,
                        const Eigen::Ref<const Features>& features, const Context& context) {
    if (features.rows() != neutral.rows() || features.cols() != output.num_channels())
        fail(Status::mismatch, "%lld x %lld features of a displacement instead of %lld x %d",
             static_cast<long long>(features.rows()), static_cast<long long>(features.cols()),
             static_cast<long long>(neutral.rows()), output.num_channels());
    const Features f = output.restore(features);
    if (!of_deformations(output.kind())) return neutral + f * output.scale_mm();
    TriMesh own;
    own.vertices = neutral;
    own.triangles = output.mean().triangles;
    return DeformationRepresentation(own, context).decode(f, context);
}

}  // namespace mien
