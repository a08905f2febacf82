// What colour tells of the place along the skin, where the form tells little: lips are redder than
// the skin around them, brows darker. The template has no colours; its landmarks and zones say
// where the features lie.
//
// With m the feature on the template (0 skin, 1 feature) and s what the scan shows under it, scaled
// to the same 0 and 1 by the scan's own contrast, a vertex that moves by p along the skin should
// see s + grad s . p = m: one more linear term per vertex, as in optical flow. Both are blurred
// alike, much in early rounds, so that a feature is felt from afar; the gradient is the mean of
// both sides', which converges from farther than either. Their mean squared difference is the
// term's noise: brows of another shape, shade and make-up weigh less by themselves.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "model/deformation_model.hpp"
#include "registration/correspondence.hpp"
#include "registration/refine.hpp"

namespace mien {

/// A vertex should move so that gradient . movement = difference, scan frame, mm.
struct ColorPull {
    Index vertex = 0;
    Vector3 gradient = Vector3::Zero();
    double difference = 0;
    double weight =
        0;  ///< inverse of the difference's variance, times how much the feature is trusted
};

/// How well a feature is seen where the template says.
struct ColorAgreement {
    std::string name;  ///< brow_right, brow_left, lips
    double correlation =
        0;  ///< of what is expected and what is seen, -1 to 1; 0 where the scan shows no contrast
};

class ColorFeatures {
  public:
    /// Knows nothing: no pull ever.
    ColorFeatures() = default;

    /// Brows along the landmarks brow_right_0 .. 4 and brow_left_0 .. 4; lips by the zone "lips"
    /// (the vermilion), else within mouth_outer_00 .. 11 (68-point scheme). What the model does not
    /// name is left out. `inner`: vertices without a say (inner.hpp). `scan` and `scan_weight` (per
    /// scan vertex or empty) must outlive this; `colors`: one row per vertex of the scan, or empty:
    /// then there are no features.
    ColorFeatures(const DeformationModel& model, const std::vector<std::uint8_t>& inner,
                  const ScanSurface& scan, const Vector& scan_weight, const Colors& colors,
                  const Context& context);

    bool empty() const { return features_.empty(); }

    /// `places` and `normals`: of all vertices of the template, scan frame. A feature that the scan
    /// shows too faintly, or quite elsewhere, does not pull. `matches`: of the round before, or
    /// empty; hints for the search.
    std::vector<ColorPull> pulls(const Points& places, const Points& normals,
                                 const CorrespondenceOptions& match, double blur_mm,
                                 std::vector<Correspondences>& matches,
                                 const Context& context) const;

    /// One per feature.
    std::vector<ColorAgreement> agreements(const Points& places, const Points& normals,
                                           const CorrespondenceOptions& match,
                                           const Context& context) const;

    /// Redness log(R / G) and darkness -log(luminance) of the scan at a hit.
    Eigen::Vector2d signals_at(const SurfaceHit& hit) const;

  private:
    enum Signal { redness, darkness };
    struct Feature {
        const char* name = "";
        Signal signal = redness;
        std::vector<Index> vertices;  // the feature and the skin around it
        Triangles triangles;          // among them
        VertexRings rings;
        Vector expected;     // 0 to 1
        double edge_mm = 1;  // mean length
    };
    struct View {  // of a feature, one row per vertex of it
        Points places;
        Vector seen, expected, weight;
        double trust = 0, correlation = 0;
    };
    void add(const char* name, Signal signal, const DeformationModel& model,
             const std::vector<std::uint8_t>& inner, const std::vector<double>& inside_mm,
             double ramp_mm, double around_mm);
    // False when the scan shows nothing of the feature.
    bool look(const Feature& feature, const Points& places, const Points& normals,
              const CorrespondenceOptions& match, double blur_mm, Correspondences& found,
              View& view, const Context& context) const;

    const ScanSurface* scan_ = nullptr;
    const Vector* scan_weight_ = nullptr;
    Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor> signals_;
    std::vector<Feature> features_;
};

}  // namespace mien
