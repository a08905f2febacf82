// A face as the features of its two bands (kosk-2024, 4.11 to 4.15): low frequencies as
// coordinates, high ones as deformations of the mean face, and back by assembly. The matrix
// X = U U' M is never formed.
#pragma once

#include "learning/face_features.hpp"
#include "spectral/spectral_basis.hpp"

namespace mien {

struct BandFeatureOptions {
    Index band_limit = 500;  ///< k, modes of the low band; 1 to #V - 1
    FeatureKind low_kind = FeatureKind::euclidean_standardised;   ///< coordinates
    FeatureKind high_kind = FeatureKind::deformation_normalised;  ///< deformations
    FeatureSpread spread = FeatureSpread::per_vertex;
};

/// Immutable; shared freely between threads.
class BandFeatures {
  public:
    /// Learns mean shape and scale as FaceFeatures::train(), the basis of the mean shape, and the
    /// statistics of both bands. Throws Status::invalid_argument for a k or kinds that do not fit.
    static std::shared_ptr<const BandFeatures> train(const TrianglesRef& triangles,
                                                     const FaceSource& source,
                                                     const BandFeatureOptions& options,
                                                     const Context& context);
    /// Of parts that belong together (from a file): one template, `low` coordinates, `high`
    /// deformations. Throws Status::bad_format otherwise.
    static std::shared_ptr<const BandFeatures> make(std::shared_ptr<const FaceFeatures> low,
                                                    std::shared_ptr<const FaceFeatures> high,
                                                    std::shared_ptr<const SpectralBasis> basis,
                                                    Index band_limit);

    const FaceFeatures& low() const { return *low_; }
    const FaceFeatures& high() const { return *high_; }
    const std::shared_ptr<const FaceFeatures>& shared_low() const { return low_; }
    const std::shared_ptr<const FaceFeatures>& shared_high() const { return high_; }
    const std::shared_ptr<const SpectralBasis>& basis() const { return basis_; }
    Index band_limit() const { return band_limit_; }
    const TriMesh& mean() const { return low_->mean(); }

    struct Pair {
        Features low, high;
    };
    /// `motion` (optional) receives the rigid motion onto the mean. O(#V k).
    Pair encode(const PointsRef& face, Similarity* motion, const Context& context) const;
    /// (4.15), in the mean's frame or where `motion` took it from. The low band gives the place.
    Points decode(const Eigen::Ref<const Features>& low, const Eigen::Ref<const Features>& high,
                  const Similarity* motion, const Context& context) const;

  private:
    std::shared_ptr<const FaceFeatures> low_, high_;
    std::shared_ptr<const SpectralBasis> basis_;
    Index band_limit_ = 0;
};

/// The basis as a part of another file (tensors and metadata whose names begin with "basis."),
/// borrowing from it; `mean` is its mean shape. The file is treated as hostile.
std::shared_ptr<const SpectralBasis> read_basis_part(const SafetensorsFile& file,
                                                     const TriMesh& mean);
void append_basis(const SpectralBasis& basis, std::vector<TensorToWrite>& tensors,
                  std::map<std::string, std::string>& metadata);

}  // namespace mien
