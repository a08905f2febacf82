#include "registration/color_features.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "base/scalar_math.hpp"
#include "registration/feature_places.hpp"

namespace mien {
namespace {

constexpr double kNoWeight = 1e-9;    // sums of weights below are nothing
constexpr double kNoArea_mm2 = 1e-9;  // twice an area below has no gradient

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
        values[i] = weights[i] > kNoWeight ? values[i] / weights[i] : 0;
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
        if (!(twice > kNoArea_mm2)) continue;
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
    return sum / std::max(kNoWeight, to - from);
}

// The vertex nearest to the weighted middle.
Index middle_of(const std::vector<Index>& vertices, const Vector& weight, const Points& rest) {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (std::size_t k = 0; k < vertices.size(); ++k)
        middle += weight[static_cast<Index>(k)] * rest.row(vertices[k]);
    middle /= std::max(kNoWeight, weight.sum());
    return *std::min_element(vertices.begin(), vertices.end(), [&](Index a, Index b) {
        return (rest.row(a) - middle).squaredNorm() < (rest.row(b) - middle).squaredNorm();
    });
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
                             const ColorFeatureSettings& settings, const Context& context)
    : settings_(settings) {
    if (!settings.enabled) return;
    for (const char* side : {"right", "left"})
        add(side[0] == 'r' ? "brow_right" : "brow_left", ColorSignal::darkness, model, inner,
            inside_brow_mm(model, side, settings.brow_half_mm), settings.brow_edge_mm,
            settings.brow_skin_mm);
    add("lips", ColorSignal::redness, model, inner,
        inside_lips_mm(model, settings.lip_depth_mm, context), settings.lip_edge_mm,
        settings.lip_skin_mm);
}

void ColorFeatures::add(const char* name, ColorSignal signal, const DeformationModel& model,
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
    if (feature.vertices.size() < settings_.fewest) return;
    const Index n = static_cast<Index>(feature.vertices.size());
    feature.expected.resize(n);
    for (Index k = 0; k < n; ++k)
        feature.expected[k] = fade(
            0.5 +
            inside_mm[static_cast<std::size_t>(feature.vertices[static_cast<std::size_t>(k)])] /
                ramp_mm);
    const Triangles& triangles = model.template_mesh.triangles;
    const Points& rest = model.template_mesh.vertices;
    feature.centre = middle_of(feature.vertices, feature.expected, rest);
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
    constexpr double kShortest_mm = 0.1;  // edges of a template in another unit bound the blur
    feature.edge_mm =
        std::max(kShortest_mm,
                 length / std::max<double>(1, static_cast<double>(3 * feature.triangles.rows())));
    feature.rings = build_rings(n, feature.triangles);
    features_.push_back(std::move(feature));
}

// Fills `seen` with the signals under the vertices, scaled so that 0 is the skin's middle tone and
// 1 the feature's. The feature's share of the places is known, so its colour is the middle of as
// many at the one end, and the skin's the middle of the rest, wherever they lie.
bool ColorFeatures::scale_tones(const Feature& feature, const ScanView& scan,
                                const Correspondences& found, View& view) const {
    std::vector<Shade> tones;
    double whole = 0, share = 0;
    for (Index k = 0; k < view.weight.size(); ++k) {
        if (!(view.weight[k] > 0)) continue;
        view.seen[k] = scan.surface().colors_at(
            found.hits[static_cast<std::size_t>(k)])[static_cast<int>(feature.signal)];
        tones.push_back({view.seen[k], view.weight[k]});
        whole += view.weight[k];
        share += view.weight[k] * view.expected[k];
    }
    if (tones.size() < settings_.fewest) return false;
    std::sort(tones.begin(), tones.end(),
              [](const Shade& x, const Shade& y) { return x.signal < y.signal; });
    const double skin = whole - share;
    const double from = 0.5 - 0.5 * settings_.core, to = 0.5 + 0.5 * settings_.core;
    const double low = mean_between(tones, from * skin, to * skin);
    const double contrast = mean_between(tones, skin + from * share, skin + to * share) - low;
    const double least =
        feature.signal == ColorSignal::redness ? settings_.contrast_red : settings_.contrast_dark;
    view.trust = fade((contrast - 0.5 * least) / (0.5 * least));
    if (!(view.trust > 0)) return false;
    view.seen = ((view.seen.array() - low) / contrast).max(-settings_.clip).min(1 + settings_.clip);
    return true;
}

bool ColorFeatures::look(const Feature& feature, const ScanView& scan, const Points& places,
                         const Points& normals, const CorrespondenceSettings& match, double blur_mm,
                         Correspondences& found, View& view, const Context& context) const {
    const Index n = static_cast<Index>(feature.vertices.size());
    Points turned(n, 3);
    view.places.resize(n, 3);
    for (Index k = 0; k < n; ++k) {
        view.places.row(k) = places.row(feature.vertices[static_cast<std::size_t>(k)]);
        turned.row(k) = normals.row(feature.vertices[static_cast<std::size_t>(k)]);
    }
    CorrespondenceSettings here = match;  // the colours of the hit itself
    here.soft_mm = 0;
    here.mutual_mm = std::numeric_limits<double>::infinity();
    find_correspondences(scan, view.places, turned, here, found, context);
    view.seen.setZero(n);
    view.weight = found.weight;
    view.expected = feature.expected;
    if (!scale_tones(feature, scan, found, view)) return false;
    const double edges = blur_mm / feature.edge_mm;
    const int rounds = static_cast<int>(std::lround(settings_.spread_rounds * edges * edges));
    Vector again = view.weight;
    blur(feature.rings, rounds, view.expected, again);
    blur(feature.rings, rounds, view.seen, view.weight);
    view.correlation = weighted_correlation(view.weight, view.seen, view.expected);
    return true;
}

std::vector<ColorPull> ColorFeatures::pulls(const ScanView& scan, const Points& places,
                                            const Points& normals,
                                            const CorrespondenceSettings& match, double blur_mm,
                                            std::vector<Correspondences>& matches,
                                            const Context& context) const {
    std::vector<ColorPull> pulls;
    if (!scan.surface().has_colors()) return pulls;
    View view;
    matches.resize(features_.size());
    for (std::size_t f = 0; f < features_.size(); ++f) {
        const Feature& feature = features_[f];
        if (!look(feature, scan, places, normals, match, blur_mm, matches[f], view, context))
            continue;
        const double trust = view.trust * fade((view.correlation - settings_.no_pull) /
                                               (settings_.full_pull - settings_.no_pull));
        if (!(trust > 0)) continue;
        const double variance = settings_.noise * settings_.noise +
                                settings_.shared *
                                    view.weight.dot((view.expected - view.seen).cwiseAbs2()) /
                                    view.weight.sum();
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

std::vector<ColorAgreement> ColorFeatures::agreements(const ScanView& scan, const Points& places,
                                                      const Points& normals,
                                                      const CorrespondenceSettings& match,
                                                      const Context& context) const {
    std::vector<ColorAgreement> agreements;
    if (!scan.surface().has_colors()) return agreements;
    View view;
    for (const Feature& feature : features_) {
        Correspondences found;
        const bool seen = look(feature, scan, places, normals, match, settings_.sharpest_mm, found,
                               view, context);
        agreements.push_back(
            {feature.name, seen ? view.trust * view.correlation : 0, view.trust, feature.centre});
        if (!seen) agreements.back().trust = 0;
    }
    return agreements;
}

ColorFeatures ColorFeatures::without(const std::vector<std::string>& names) const {
    ColorFeatures others = *this;
    const auto named = [&](const Feature& feature) {
        return std::find(names.begin(), names.end(), feature.name) != names.end();
    };
    std::vector<Feature>& f = others.features_;
    f.erase(std::remove_if(f.begin(), f.end(), named), f.end());
    return others;
}

std::vector<std::string> ColorFeatures::lying(const std::vector<ColorAgreement>& agreements) const {
    std::vector<std::string> names;
    for (const ColorAgreement& feature : agreements)
        if (feature.trust > settings_.least_trust &&
            feature.correlation < settings_.least_agreement * feature.trust)
            names.push_back(feature.name);
    return names;
}

}  // namespace mien
