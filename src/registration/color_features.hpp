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
#include "mesh/adjacency.hpp"
#include "model/deformation_model.hpp"
#include "registration/correspondence.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct ColorFeatureSettings {
    bool enabled = true;  ///< [A]
    // Where the features lie on the template, mm, > 0: half of a brow's height, the slope of its
    // edge and of the lips', how much skin around them is looked at, and how far from the mouth's
    // ring lips reach in depth. [J]
    double brow_half_mm = 3.5, brow_edge_mm = 3, brow_skin_mm = 14;
    double lip_edge_mm = 2, lip_skin_mm = 9, lip_depth_mm = 20;
    /// Logarithms, > 0, as the signals: full trust in a feature of this contrast or more, none
    /// below half of it. [J]
    double contrast_red = 0.1, contrast_dark = 0.2;
    double noise = 0.15;  ///< > 0, of a contrast of 1: least deviation of what is seen [J]
    double shared = 2;    ///< >= 1, on the mean square seen: a brow of another shape errs along
                          ///< whole edges [J]
    double clip = 0.5;    ///< >= 0: how far beyond 0 and 1 a scaled signal may lie [J]
    double core = 0.5;    ///< 0 to 1: the middle share of the sorted tones that is averaged [J]
    /// Correlations of what is expected and what is seen: no pull below, full pull above. [J]
    double no_pull = 0.1, full_pull = 0.5;
    /// A finished fit that sees less of a feature was led by something else: redrawn brows,
    /// make-up, light from the side, a mask. [T] "Colours that lie"
    double least_agreement = 0.8;
    double least_trust = 0.05;   ///< 0 to 1: features of less contrast have not led it anywhere [J]
    double sharpest_mm = 1;      ///< blur of a look that does not have to feel from afar [J]
    double spread_rounds = 2.3;  ///< rounds of averaging over the ring per squared edge of blur: a
                                 ///< round spreads a value by about two thirds of an edge
    std::size_t fewest = 10;     ///< vertices of a feature that must see the scan [J]
};

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
    double trust = 0;   ///< 0 to 1, by the contrast that the scan shows there
    Index centre = -1;  ///< the feature's middle vertex on the template
};

/// What a model's template says of brows and lips; scans are asked with each call. Immutable.
class ColorFeatures {
  public:
    /// Knows nothing: no pull ever.
    ColorFeatures() = default;

    /// Brows along the landmarks brow_right_0 .. 4 and brow_left_0 .. 4; lips by the zone "lips"
    /// (the vermilion), else within mouth_outer_00 .. 11 (68-point scheme). What the model does not
    /// name is left out. `inner`: vertices excluded from correspondence (inner.hpp).
    ColorFeatures(const DeformationModel& model, const std::vector<std::uint8_t>& inner,
                  const ColorFeatureSettings& settings, const Context& context);

    bool empty() const { return features_.empty(); }

    /// The features without those named.
    ColorFeatures without(const std::vector<std::string>& names) const;

    /// Names of the features that led a finished fit astray: the scan shows a contrast there that
    /// does not lie as the feature does.
    std::vector<std::string> lying(const std::vector<ColorAgreement>& agreements) const;

    /// `places` and `normals`: of all vertices of the template, scan frame. A feature that the scan
    /// shows too faintly, or quite elsewhere, does not pull; nor does any on a scan without
    /// colours. `matches`: of the round before, or empty; hints for the search.
    std::vector<ColorPull> pulls(const ScanView& scan, const Points& places, const Points& normals,
                                 const CorrespondenceSettings& match, double blur_mm,
                                 std::vector<Correspondences>& matches,
                                 const Context& context) const;

    /// One per feature; none on a scan without colours.
    std::vector<ColorAgreement> agreements(const ScanView& scan, const Points& places,
                                           const Points& normals,
                                           const CorrespondenceSettings& match,
                                           const Context& context) const;

  private:
    struct Feature {
        const char* name = "";
        ColorSignal signal = ColorSignal::redness;
        std::vector<Index> vertices;  // the feature and the skin around it
        Triangles triangles;          // among them
        VertexRings rings;
        Vector expected;     // 0 to 1
        double edge_mm = 1;  // mean length
        Index centre = -1;   // vertex nearest to the middle of what is expected
    };
    struct View {  // of a feature, one row per vertex of it
        Points places;
        Vector seen, expected, weight;
        double trust = 0, correlation = 0;
    };
    void add(const char* name, ColorSignal signal, const DeformationModel& model,
             const std::vector<std::uint8_t>& inner, const std::vector<double>& inside_mm,
             double ramp_mm, double around_mm);
    // False when the scan shows nothing of the feature.
    bool look(const Feature& feature, const ScanView& scan, const Points& places,
              const Points& normals, const CorrespondenceSettings& match, double blur_mm,
              Correspondences& found, View& view, const Context& context) const;
    bool scale_tones(const Feature& feature, const ScanView& scan, const Correspondences& found,
                     View& view) const;

    ColorFeatureSettings settings_;
    std::vector<Feature> features_;
};

}  // namespace mien
