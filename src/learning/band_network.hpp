// Two networks over the bands of a face, joined by spectral assembly.
//
// faces (Deep Spectral Meshes, kosk-2024 chapter 4): two autoencoders, of the low band's
// coordinates and of the high band's deformations. The code is [low | high]; each decoder takes the
// other band's code beside its own. expression (personalised blendshapes, 5.3): two networks from a
// neutral face to what an expression adds, one in coordinates, one in deformations; the low
// frequencies of the first face and the high ones of the second (5.10).
#pragma once

#include "learning/band_features.hpp"
#include "learning/network.hpp"

namespace mien {

enum class BandTask { faces, expression };

class BandNetwork final : public FaceNetwork {
  public:
    struct Parts {
        std::shared_ptr<const Network> low, high;
        std::shared_ptr<const SpectralBasis> basis;
        BandTask task = BandTask::faces;
        /// k; of expressions 0 to any number: more modes than the basis has mean coordinates alone.
        Index band_limit = 0;
        /// gamma, 0 to 1: how much of the other band's code a decoder saw in training. At 0 it
        /// takes zeros, else the whole code.
        double conditioning = 1;
    };
    /// Throws Status::bad_format when the parts do not belong together.
    static std::shared_ptr<const BandNetwork> make(Parts parts, NetworkOrigin origin,
                                                   CodeDistribution codes = {});
    static std::shared_ptr<const BandNetwork> read(const SafetensorsFile& file,
                                                   const Context& context);
    void save(const std::string& path, const Context& context) const override;

    const Parts& parts() const { return parts_; }
    const Network& low() const { return *parts_.low; }
    const Network& high() const { return *parts_.high; }
    const SpectralBasis& basis() const { return *parts_.basis; }
    BandTask task() const { return parts_.task; }
    double conditioning() const { return parts_.conditioning; }
    const TriMesh& mean() const override { return low().mean(); }
    double scale_mm() const override { return low().scale_mm(); }
    bool gives_faces_back() const override { return task() == BandTask::faces; }
    Index code_size() const override { return low().code_size() + high().code_size(); }
    Index low_code_size() const override { return low().code_size(); }
    Index band_limit() const override { return parts_.band_limit; }

    Eigen::VectorXf encode(const PointsRef& face, Similarity* motion,
                           const Context& context) const override;
    Points decode(const Eigen::Ref<const Eigen::VectorXf>& code, const Similarity* motion,
                  const Context& context) const override;
    using FaceNetwork::apply;
    Points apply(const PointsRef& face, Index band_limit, const Context& context) const override;
    std::string json() const override;

    /// Of an expression, before assembly; both in the frame of `neutral`, the second placed by the
    /// first.
    struct Prediction {
        Points spatial, differential;
    };
    Prediction predict(const PointsRef& neutral, const Context& context) const;

  private:
    Parts parts_;
    std::shared_ptr<const BandFeatures> features_;  ///< of faces
};

/// The input of a decoder: in each row first the own code's channels, then the other's.
Eigen::VectorXf joined_codes(const Eigen::Ref<const Eigen::VectorXf>& own,
                             const Eigen::Ref<const Eigen::VectorXf>& other, Index rows);

}  // namespace mien
