#include "registration/color_features.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "registration/feature_places.hpp"

namespace mien {
namespace {

// Half of a brow's height, the slope of its edge and of the lips', and how much skin around them is
// looked at, mm.
constexpr double kBrow_mm = 3.5, kBrowEdge_mm = 3, kBrowSkin_mm = 14, kLipEdge_mm = 2,
                 kLipSkin_mm = 9;
// In logarithms, as the signals; below half of it nothing is seen.
constexpr double kContrast_red = 0.1, kContrast_dark = 0.2;
constexpr double kNoise = 0.15;  // of what is seen, at the least, of a contrast of 1
constexpr double kShared =
    2;  // factor on the mean square seen: a brow of another shape errs along whole edges
constexpr double kSharpest_mm = 1;   // blur of a look that does not have to feel from afar
constexpr std::size_t kFewest = 10;  // vertices that see the scan

// Rounds of averaging with the neighbours, each value by its weight.
void blur(const VertexRings& rings, int rounds, Vector& values, Vector& weights) {
    values = values.cwiseProduct(weights);
    Vector next_values = values, next_weights = weights;
    for (int round = 0; round < rounds; ++round) {
        for (Index i = 0; i < values.size(); ++i) {
            double value = values[i], weight = weights[i];
            const std::uint32_t begin = rings.begin[static_cast<std::size_t>(i)];
            const std::uint32_t end = rings.begin[static_cast<std::size_t>(i) + 1];
            for (std::uint32_t k = begin; k < end; ++k) {
                value += values[rings.neighbours[k]];
                weight += weights[rings.neighbours[k]];
            }
            next_values[i] = value / (1 + end - begin);
            next_weights[i] = weight / (1 + end - begin);
        }
        values.swap(next_values);
        weights.swap(next_weights);
    }
    for (Index i = 0; i < values.size(); ++i)
        values[i] = weights[i] > 1e-9 ? values[i] / weights[i] : 0;
}

// Of a field that is linear over each triangle: the mean by area over the triangles around a
// vertex.
Points vertex_gradients(const Points& places, const Triangles& triangles, const Vector& field) {
    Points gradient = Points::Zero(places.rows(), 3);
    Vector area = Vector::Zero(places.rows());
    for (Index t = 0; t < triangles.rows(); ++t) {
        Vector3 x[3];
        for (int k = 0; k < 3; ++k) x[k] = places.row(triangles(t, k)).transpose();
        const Vector3 cross = (x[1] - x[0]).cross(x[2] - x[0]);
        const double twice = cross.norm();
        if (!(twice > 1e-9)) continue;
        Vector3 sum = Vector3::Zero();  // twice the area times the gradient
        for (int k = 0; k < 3; ++k)
            sum += field[triangles(t, k)] * cross.cross(x[(k + 2) % 3] - x[(k + 1) % 3]) / twice;
        for (int k = 0; k < 3; ++k) {
            gradient.row(triangles(t, k)) += sum.transpose();
            area[triangles(t, k)] += twice;
        }
    }
    for (Index i = 0; i < area.size(); ++i)
        if (area[i] > 0) gradient.row(i) /= area[i];
    return gradient;
}

struct Shade {
    double signal, weight;
};

// The mean of sorted tones between two sums of their weights: a middle that changes smoothly with
// all of them.
double mean_between(const std::vector<Shade>& tones, double from, double to) {
    double sum = 0, before = 0;
    for (const Shade& tone : tones) {
        const double after = before + tone.weight;
        sum += std::max(0.0, std::min(after, to) - std::max(before, from)) * tone.signal;
        before = after;
    }
    return sum / std::max(1e-9, to - from);
}

double weighted_correlation(const Vector& weight, const Vector& a, const Vector& b) {
    const double sum = weight.sum();
    if (!(sum > 0)) return 0;
    const Vector da = a.array() - weight.dot(a) / sum, db = b.array() - weight.dot(b) / sum;
    const double spread = std::sqrt(weight.dot(da.cwiseAbs2()) * weight.dot(db.cwiseAbs2()));
    return spread > 0 ? weight.dot(da.cwiseProduct(db)) / spread : 0;
}

}  // namespace

ColorFeatures::ColorFeatures(const DeformationModel& model, const std::vector<std::uint8_t>& inner,
                             const ScanSurface& scan, const Vector& scan_weight,
                             const Colors& colors, const Context& context)
    : scan_(&scan), scan_weight_(&scan_weight) {
    if (colors.rows() == 0) return;
    // Black has a logarithm too; near it the camera's noise is all there is.
    const Eigen::ArrayX3f light = colors.cast<float>().array() + 8;
    signals_.resize(colors.rows(), 2);
    signals_.col(redness) = (light.col(0) / light.col(1)).log();
    signals_.col(darkness) =
        -(0.299f * light.col(0) + 0.587f * light.col(1) + 0.114f * light.col(2)).log();
    add("brow_right", darkness, model, inner, inside_brow_mm(model, "right", kBrow_mm),
        kBrowEdge_mm, kBrowSkin_mm);
    add("brow_left", darkness, model, inner, inside_brow_mm(model, "left", kBrow_mm), kBrowEdge_mm,
        kBrowSkin_mm);
    add("lips", redness, model, inner, inside_lips_mm(model, context), kLipEdge_mm, kLipSkin_mm);
}

void ColorFeatures::add(const char* name, Signal signal, const DeformationModel& model,
                        const std::vector<std::uint8_t>& inner,
                        const std::vector<double>& inside_mm, double ramp_mm, double around_mm) {
    Feature feature;
    feature.name = name;
    feature.signal = signal;
    std::vector<Index> row_of(inside_mm.size(), -1);
    for (std::size_t i = 0; i < inside_mm.size(); ++i) {
        if (inside_mm[i] < -around_mm || inner[i]) continue;
        row_of[i] = static_cast<Index>(feature.vertices.size());
        feature.vertices.push_back(static_cast<Index>(i));
    }
    if (feature.vertices.size() < kFewest) return;
    const Index n = static_cast<Index>(feature.vertices.size());
    feature.expected.resize(n);
    for (Index k = 0; k < n; ++k)
        feature.expected[k] = fade(
            0.5 +
            inside_mm[static_cast<std::size_t>(feature.vertices[static_cast<std::size_t>(k)])] /
                ramp_mm);
    const Triangles& triangles = model.template_mesh.triangles;
    const Points& rest = model.template_mesh.vertices;
    std::vector<std::uint32_t> corners;
    double length = 0;
    for (Index t = 0; t < triangles.rows(); ++t) {
        const Index rows[3] = {row_of[triangles(t, 0)], row_of[triangles(t, 1)],
                               row_of[triangles(t, 2)]};
        if (std::min({rows[0], rows[1], rows[2]}) < 0) continue;
        for (const Index row : rows) corners.push_back(static_cast<std::uint32_t>(row));
        for (int k = 0; k < 3; ++k)
            length += (rest.row(triangles(t, k)) - rest.row(triangles(t, (k + 1) % 3))).norm();
    }
    feature.triangles =
        Eigen::Map<const Triangles>(corners.data(), static_cast<Index>(corners.size() / 3), 3);
    feature.edge_mm = std::max(
        0.1, length / std::max<double>(1, static_cast<double>(3 * feature.triangles.rows())));
    feature.rings = build_rings(n, feature.triangles);
    features_.push_back(std::move(feature));
}

Eigen::Vector2d ColorFeatures::signals_at(const SurfaceHit& hit) const {
    const Index t = static_cast<Index>(hit.triangle);
    if (scan_->tree.is_point_cloud()) return signals_.row(t).transpose().cast<double>();
    Eigen::Vector2d signals = Eigen::Vector2d::Zero();
    for (int c = 0; c < 3; ++c)
        signals +=
            hit.barycentric[c] * signals_.row(scan_->triangles(t, c)).transpose().cast<double>();
    return signals;
}

bool ColorFeatures::look(const Feature& feature, const Points& places, const Points& normals,
                         const CorrespondenceOptions& match, double blur_mm, Correspondences& found,
                         View& view, const Context& context) const {
    const Index n = static_cast<Index>(feature.vertices.size());
    Points turned(n, 3);
    view.places.resize(n, 3);
    for (Index k = 0; k < n; ++k) {
        view.places.row(k) = places.row(feature.vertices[static_cast<std::size_t>(k)]);
        turned.row(k) = normals.row(feature.vertices[static_cast<std::size_t>(k)]);
    }
    find_correspondences(*scan_, view.places, turned, *scan_weight_, match, found, context);
    view.seen.setZero(n);
    view.weight = found.weight;
    view.expected = feature.expected;
    std::vector<Shade> tones;
    double whole = 0, share = 0;
    for (Index k = 0; k < n; ++k) {
        if (!(view.weight[k] > 0)) continue;
        view.seen[k] = signals_at(found.hits[static_cast<std::size_t>(k)])[feature.signal];
        tones.push_back({view.seen[k], view.weight[k]});
        whole += view.weight[k];
        share += view.weight[k] * view.expected[k];
    }
    if (tones.size() < kFewest) return false;
    // The feature's share of the places is known, so its colour is the middle of as many at the one
    // end, and the skin's the middle of the rest, wherever they lie.
    std::sort(tones.begin(), tones.end(),
              [](const Shade& x, const Shade& y) { return x.signal < y.signal; });
    const double skin = whole - share;
    const double low = mean_between(tones, 0.25 * skin, 0.75 * skin);
    const double contrast = mean_between(tones, skin + 0.25 * share, skin + 0.75 * share) - low;
    const double least = feature.signal == redness ? kContrast_red : kContrast_dark;
    view.trust = fade((contrast - 0.5 * least) / (0.5 * least));
    if (!(view.trust > 0)) return false;
    view.seen = ((view.seen.array() - low) / contrast).max(-0.5).min(1.5);
    // A round of averaging over the ring spreads a value by about two thirds of an edge.
    const double edges = blur_mm / feature.edge_mm;
    const int rounds = static_cast<int>(std::lround(2.3 * edges * edges));
    Vector again = view.weight;
    blur(feature.rings, rounds, view.expected, again);
    blur(feature.rings, rounds, view.seen, view.weight);
    view.correlation = weighted_correlation(view.weight, view.seen, view.expected);
    return true;
}

std::vector<ColorPull> ColorFeatures::pulls(const Points& places, const Points& normals,
                                            const CorrespondenceOptions& match, double blur_mm,
                                            std::vector<Correspondences>& matches,
                                            const Context& context) const {
    std::vector<ColorPull> pulls;
    View view;
    matches.resize(features_.size());
    for (std::size_t f = 0; f < features_.size(); ++f) {
        const Feature& feature = features_[f];
        if (!look(feature, places, normals, match, blur_mm, matches[f], view, context)) continue;
        const double trust = view.trust * fade((view.correlation - 0.1) / 0.4);
        if (!(trust > 0)) continue;
        const double variance =
            kNoise * kNoise +
            kShared * view.weight.dot((view.expected - view.seen).cwiseAbs2()) / view.weight.sum();
        const Points gradient =
            vertex_gradients(view.places, feature.triangles, 0.5 * (view.seen + view.expected));
        for (Index k = 0; k < view.weight.size(); ++k)
            if (view.weight[k] > 0)
                pulls.push_back({feature.vertices[static_cast<std::size_t>(k)],
                                 gradient.row(k).transpose(), view.expected[k] - view.seen[k],
                                 trust * view.weight[k] / variance});
    }
    return pulls;
}

std::vector<ColorAgreement> ColorFeatures::agreements(const Points& places, const Points& normals,
                                                      const CorrespondenceOptions& match,
                                                      const Context& context) const {
    std::vector<ColorAgreement> agreements;
    View view;
    for (const Feature& feature : features_) {
        Correspondences found;
        const bool seen = look(feature, places, normals, match, kSharpest_mm, found, view, context);
        agreements.push_back({feature.name, seen ? view.trust * view.correlation : 0});
    }
    return agreements;
}

}  // namespace mien
