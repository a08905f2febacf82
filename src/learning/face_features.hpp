// The representations that learning works on (kosk-2024, 3.2-3.19): faces aligned to the training
// set's mean, centred and scaled, as coordinates or as deformations, standardised or normalised;
// each with its exact inverse. What was learned from the training set is one file.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/safetensors.hpp"
#include "spectral/deformation_representation.hpp"

namespace mien {

enum class FeatureKind : std::int32_t {
    euclidean = 1,                ///< (3.14)
    euclidean_standardised = 2,   ///< (3.15)
    euclidean_normalised = 3,     ///< (3.16)
    deformation = 4,              ///< (3.17)
    deformation_normalised = 5,   ///< (3.18)
    deformation_standardised = 6  ///< (3.19)
};

/// Faces of a training set, asked for one by one, several times.
struct FaceSource {
    Index count = 0;
    std::function<void(Index, Points&)> face;
};

/// Least and greatest, mean and deviation of every feature (#V x c).
struct FeatureStatistics {
    Features mean, deviation, least, greatest;
};
FeatureStatistics feature_statistics(Index count, const std::function<Features(Index)>& features);

/// (3.11), (3.12): (f - mean) / deviation and back. A feature that never varied keeps its offset
/// from the mean (deviation 1), so that the inverse stays exact.
void standardise(const FeatureStatistics& statistics, Features& features);
void destandardise(const FeatureStatistics& statistics, Features& features);
/// (3.8) onto [-1, 1] and back; constant features as above.
void normalise(const FeatureStatistics& statistics, Features& features);
void denormalise(const FeatureStatistics& statistics, Features& features);

/// Immutable; shared freely between threads.
class FaceFeatures {
  public:
    /// Learns mean shape (generalised Procrustes, rigid), centre (3.6), scale (3.7) and statistics.
    static std::shared_ptr<const FaceFeatures> train(const TrianglesRef& triangles,
                                                     const FaceSource& source, FeatureKind kind,
                                                     const Context& context);
    /// safetensors, kind "mien-face-features", format 1.
    static std::shared_ptr<const FaceFeatures> load(const std::string& path,
                                                    const SafetensorsReadOptions& options,
                                                    const Context& context);
    void save(const std::string& path, const Context& context) const;

    FeatureKind kind() const { return kind_; }
    Index num_vertices() const { return mean_.vertices.rows(); }
    int num_channels() const { return kind_ < FeatureKind::deformation ? 3 : kDeformationChannels; }
    const TriMesh& mean() const { return mean_; }  ///< centred mean shape, mm
    double scale_mm() const { return scale_mm_; }
    const FeatureStatistics& statistics() const { return statistics_; }

    /// Features of a face; `motion` (optional) receives the rigid motion onto the mean, which
    /// decode() undoes when it is given back.
    Features encode(const PointsRef& face, Similarity* motion, const Context& context) const;
    /// The face in the mean's frame, mm, or where `motion` took it from. Deformations are free of
    /// translation: their faces keep the mean's centre.
    Points decode(const Eigen::Ref<const Features>& features, const Similarity* motion,
                  const Context& context) const;

  private:
    Features raw(const PointsRef& face, Similarity* motion, const Context& context) const;

    FeatureKind kind_ = FeatureKind::euclidean;
    TriMesh mean_;
    double scale_mm_ = 1;
    FeatureStatistics statistics_;
    std::shared_ptr<const DeformationRepresentation> deformation_;
};

}  // namespace mien
