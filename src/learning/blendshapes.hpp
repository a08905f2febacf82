// A person's expression predicted from the neutral face alone, by kernel ridge regression in two
// frequency bands (kosk-2024, 5.3 without the networks).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "learning/face_features.hpp"
#include "spectral/spectral_basis.hpp"

namespace mien {

struct BlendshapeOptions {
    double ridge = 0;  ///< of the kernel's mean diagonal; 0: by leave-one-out error
    Index max_samples = 4096;
};

/// Pairs of a neutral face and the same person with one expression.
struct FacePairs {
    Index count = 0;
    std::function<void(Index, Points& neutral, Points& expression)> pair;
};

/// Immutable; shared freely between threads.
class BlendshapeModel {
  public:
    static std::shared_ptr<const BlendshapeModel> train(const TrianglesRef& triangles,
                                                        const FacePairs& pairs,
                                                        const BlendshapeOptions& options,
                                                        const Context& context);
    /// safetensors, kind "mien-blendshape-model", format 1, float32 samples.
    static std::shared_ptr<const BlendshapeModel> load(const std::string& path,
                                                       const SafetensorsReadOptions& options,
                                                       const Context& context);
    void save(const std::string& path, const Context& context) const;

    Index num_vertices() const { return mean_.vertices.rows(); }
    Index num_samples() const { return spatial_input_.rows(); }
    const TriMesh& mean() const { return mean_; }
    double spatial_ridge() const { return spatial_.ridge; }
    double differential_ridge() const { return differential_.ridge; }

    struct Prediction {
        Points spatial;       ///< neutral + predicted displacement (standardised Euclidean), mm
        Points differential;  ///< neutral deformed by predicted deformations (normalised DR), mm
    };
    /// Both in the frame of `neutral`.
    Prediction predict(const PointsRef& neutral, const Context& context) const;
    /// (5.10): low frequencies of the spatial, high ones of the differential prediction.
    Points predict(const PointsRef& neutral, const SpectralBasis& basis, Index k,
                   const Context& context) const;

  private:
    using Samples = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    struct Band {
        Vector mean_weight;  ///< of the centred kernel: row means
        double grand_mean = 0, ridge = 0;
        Matrix inverse;  ///< (centred kernel + ridge)^-1
    };
    static void fit(const Samples& inputs, const Samples& outputs, double ridge, Band& band,
                    const Context& context);
    static Vector weights(const Samples& inputs, const Eigen::VectorXf& input, const Band& band);
    void finish(double spatial_ridge, double differential_ridge, const Context& context);

    TriMesh mean_;                                      ///< of the neutral faces, centred
    FeatureStatistics neutral_statistics_;              ///< of the neutral faces' coordinates
    Samples spatial_input_, spatial_output_;            ///< samples x 3 #V
    Samples differential_input_, differential_output_;  ///< samples x 9 #V
    FeatureStatistics deformation_statistics_;
    std::shared_ptr<const DeformationRepresentation> deformation_;
    Band spatial_, differential_;
};

struct BandChoice {
    Index k = 0;
    double l1_mm = 0, dame = 0, fmpd = 0;
    bool on_front = false;  ///< no other k is better in both L1 and FMPD
    bool chosen = false;    ///< the front's knee: nearest to the best of both
};
/// Both predictions of a person's expression, in the frame of `neutral`.
using PredictBands =
    std::function<void(const Points& neutral, Points& spatial, Points& differential)>;
std::vector<BandChoice> search_band_limit(const PredictBands& predict, const Triangles& triangles,
                                          const SpectralBasis& basis, const FacePairs& validation,
                                          const std::vector<Index>& candidates,
                                          const Context& context);
/// Tries every k on given pairs (5.3.4); ascending k, values beyond the basis mean "spatial alone".
std::vector<BandChoice> search_band_limit(const BlendshapeModel& model, const SpectralBasis& basis,
                                          const FacePairs& validation,
                                          const std::vector<Index>& candidates,
                                          const Context& context);
/// Marks the Pareto front of (l1, fmpd) and its knee.
void mark_front(std::vector<BandChoice>& choices);

}  // namespace mien
