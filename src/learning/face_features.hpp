// The representations that learning works on (kosk-2024, 3.2-3.19): faces aligned to the training
// set's mean, centred and scaled, as coordinates or as deformations, standardised or normalised;
// each with its exact inverse. What was learned from the training set is one file.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

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

const char* feature_kind_name(FeatureKind kind);
/// Throws Status::bad_format for a name that is none.
FeatureKind feature_kind(const std::string& name);

/// How the spread of the features is taken.
enum class FeatureSpread {
    per_vertex,  ///< of every vertex and channel
    /// Of every channel over all vertices: vertices that hardly move are not blown up, and what
    /// operators with weights shared over the vertices rely on stays.
    per_channel
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

/// A face moved rigidly onto a mean shape (`motion`, optional, receives how). Throws
/// Status::mismatch for another number of vertices, invalid_mesh for one that is not finite.
Points onto_mean_shape(const PointsRef& face, const TriMesh& mean, Similarity* motion);

/// Immutable; shared freely between threads.
class FaceFeatures {
  public:
    /// Learns mean shape (generalised Procrustes, rigid), centre (3.6), scale (3.7) and statistics.
    static std::shared_ptr<const FaceFeatures> train(const TrianglesRef& triangles,
                                                     const FaceSource& source, FeatureKind kind,
                                                     const Context& context) {
        return train(triangles, source, kind, FeatureSpread::per_vertex, context);
    }
    static std::shared_ptr<const FaceFeatures> train(const TrianglesRef& triangles,
                                                     const FaceSource& source, FeatureKind kind,
                                                     FeatureSpread spread, const Context& context);
    /// The same around a mean shape and a scale that are given: `raw` gives the features of
    /// training sample k (#V x channels of `kind`) before standardisation or normalisation. For
    /// features of something that is not aligned again: bands of aligned faces, displacements.
    static std::shared_ptr<const FaceFeatures> around(const TriMesh& mean, double scale_mm,
                                                      FeatureKind kind, FeatureSpread spread,
                                                      Index count,
                                                      const std::function<Features(Index)>& raw);
    /// safetensors, kind "mien-face-features", format 1.
    static std::shared_ptr<const FaceFeatures> load(const std::string& path,
                                                    const SafetensorsReadOptions& options,
                                                    const Context& context);
    void save(const std::string& path, const Context& context) const;
    /// The same as a part of another file: tensors whose names begin with `prefix`, and the
    /// metadata entry `prefix` + "features". The tensors borrow from this object.
    static std::shared_ptr<const FaceFeatures> read(const SafetensorsFile& file,
                                                    const std::string& prefix);
    void append_to(const std::string& prefix, std::vector<TensorToWrite>& tensors,
                   std::map<std::string, std::string>& metadata) const;

    FeatureKind kind() const { return kind_; }
    Index num_vertices() const { return mean_.vertices.rows(); }
    int num_channels() const { return kind_ < FeatureKind::deformation ? 3 : kDeformationChannels; }
    const TriMesh& mean() const { return mean_; }  ///< centred mean shape, mm
    double scale_mm() const { return scale_mm_; }
    const FeatureStatistics& statistics() const { return statistics_; }

    /// Features of a face; `motion` (optional) receives the rigid motion onto the mean, which
    /// decode() undoes when it is given back.
    Features encode(const PointsRef& face, Similarity* motion, const Context& context) const;
    /// The same of a face that stands in the mean's frame already.
    Features encode_aligned(const PointsRef& aligned, const Context& context) const;
    /// Standardisation or normalisation alone: the inverse of restore().
    Features prepare(Features raw) const;
    /// The face in the mean's frame, mm, or where `motion` took it from. Deformations are free of
    /// translation: their faces keep the mean's centre.
    Points decode(const Eigen::Ref<const Features>& features, const Similarity* motion,
                  const Context& context) const;

    /// Undoes standardisation or normalisation: coordinates over scale_mm(), or deformations.
    Features restore(const Eigen::Ref<const Features>& features) const;

  private:
    /// Null for coordinates. Factorised when it is first needed: reading a file does not wait.
    const DeformationRepresentation* deformation(const Context& context) const;
    Features raw(const PointsRef& face, Similarity* motion, const Context& context) const;
    Features raw_aligned(const PointsRef& aligned, const Context& context) const;

    FeatureKind kind_ = FeatureKind::euclidean;
    TriMesh mean_;
    double scale_mm_ = 1;
    FeatureStatistics statistics_;
    mutable std::mutex mutex_;
    mutable std::shared_ptr<const DeformationRepresentation> deformation_;
};

}  // namespace mien
