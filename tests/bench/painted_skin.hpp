// A person's skin as a solid texture over the template at rest: tone, blotches, freckles, moles and
// pores that go with the skin whatever the face does, and the light and camera of a visit.
#pragma once

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "base/random.hpp"
#include "geometry/normals.hpp"
#include "model/deformation_model.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {

struct SkinPaintSettings {
    double freckles_per_cm2 = 1.5, pores_per_cm2 = 40;
    double blotches = 1;                ///< factor on the contrast of tones over 5 mm and more
    double contrast = 1;                ///< factor on freckles and pores
    Vector3 treated = Vector3::Zero();  ///< at rest: no freckle within treated_mm, and redder
    double treated_mm = 0;
};

/// A person: a function of the seed.
class PaintedSkin {
  public:
    PaintedSkin(const DeformationModel& model, std::uint64_t seed,
                const SkinPaintSettings& settings)
        : settings_(settings), random_(seed, 1) {
        const TriMesh& mesh = model.template_mesh;
        const Points normals = triangle_normals(mesh.vertices, mesh.triangles);
        std::uint64_t n = 1000;
        const double light = random_.uniform(0);
        tone_ = (1 - light) * Vector3(120, 82, 62) + light * Vector3(226, 184, 160);
        for (int wave = 0; wave < kWaves; ++wave) {
            Vector3 k;
            for (int c = 0; c < 3; ++c) k[c] = random_.normal(n++);
            const double length_mm = (wave % 2 == 0 ? 35 : 9) * (0.7 + 0.8 * random_.uniform(n++));
            wave_.push_back(2 * kPi / length_mm * k.normalized());
            phase_.push_back(2 * kPi * random_.uniform(n++));
        }
        for (Index t = 0; t < mesh.triangles.rows(); ++t) {
            const double cm2 = normals.row(t).norm() / 200;
            const auto spread = [&](double per_cm2, bool pore) {
                double left = per_cm2 * cm2;
                for (left += random_.uniform(n++); left >= 1; --left) {
                    double b = random_.uniform(n++), c = random_.uniform(n++);
                    if (b + c > 1) {
                        b = 1 - b;
                        c = 1 - c;
                    }
                    Spot spot;
                    spot.at = (1 - b - c) * mesh.vertices.row(mesh.triangles(t, 0)) +
                              b * mesh.vertices.row(mesh.triangles(t, 1)) +
                              c * mesh.vertices.row(mesh.triangles(t, 2));
                    const double size = random_.uniform(n++), dark = random_.uniform(n++);
                    spot.radius_mm = pore ? 0.15 + 0.2 * size : 0.4 + 0.8 * size * size;
                    spot.dark =
                        settings.contrast * (pore ? 0.04 + 0.08 * dark : 0.06 + 0.25 * dark * dark);
                    spot.freckle = !pore;
                    spots_[cell_of(spot.at)].push_back(spot);
                }
            };
            spread(settings.freckles_per_cm2, false);
            spread(settings.pores_per_cm2, true);
        }
        lips_.assign(static_cast<std::size_t>(mesh.vertices.rows()), 0);
        for (const Zone& zone : model.zones)
            if (zone.name == "lips")
                for (const std::uint32_t v : zone.vertices) lips_[v] = 1;
        for (const Landmark& mark : model.landmarks)
            if (mark.name.rfind("brow_", 0) == 0)
                brows_.push_back(mesh.vertices.row(static_cast<Index>(mark.vertex)));
    }

    /// Red green blue, 0 to 255, in white light; `lips`: 0 to 1.
    Vector3 color(const Vector3& rest, double lips) const {
        double coarse = 0;
        for (std::size_t k = 0; k < wave_.size(); ++k)
            coarse += std::cos(wave_[k].dot(rest) + phase_[k]);
        coarse *= settings_.blotches * 0.025 * std::sqrt(2.0 / kWaves);
        Vector3 shade = Vector3::Constant(1 + coarse);
        const bool treated = (rest - settings_.treated).norm() < settings_.treated_mm;
        const Eigen::Array3i home = (rest.array() / kCell_mm).floor().cast<int>();
        for (int i = 0; i < 27; ++i) {
            const auto found =
                spots_.find(key_of(home + Eigen::Array3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
            if (found == spots_.end()) continue;
            for (const Spot& spot : found->second) {
                if (treated && spot.freckle) continue;
                const double d = (rest - spot.at).norm() / spot.radius_mm;
                if (d < 1.5)
                    shade -= spot.dark * fade(2 - 1.4 * d) *
                             (spot.freckle ? Vector3(0.8, 1, 1.15) : Vector3(1, 1, 1));
            }
        }
        if (treated) shade = shade.cwiseProduct(Vector3(1.08, 0.9, 0.92));
        for (std::size_t k = 0; k + 1 < brows_.size(); ++k) {
            if ((brows_[k] - brows_[k + 1]).norm() > 25) continue;  // from one brow to the other
            const Vector3 along = brows_[k + 1] - brows_[k];
            const double share =
                std::clamp((rest - brows_[k]).dot(along) / along.squaredNorm(), 0.0, 1.0);
            const double d = (rest - brows_[k] - share * along).norm();
            const double hairs = 0.8 + 0.2 * std::cos(3 * rest.x() + 1.3 * rest.y());
            shade *= 1 - 0.6 * fade((5 - d) / 3) * hairs;
        }
        const Vector3 red(0.95, 0.6, 0.62);
        shade = shade.cwiseProduct((1 - lips) * Vector3::Ones() + lips * red);
        return tone_.cwiseProduct(shade.cwiseMax(0.02));
    }

    double lips(std::uint32_t vertex) const { return lips_[vertex]; }
    const Vector3& tone() const { return tone_; }

  private:
    struct Spot {
        Vector3 at;
        double radius_mm, dark;
        bool freckle;
    };
    static constexpr int kWaves = 40;
    static constexpr double kCell_mm = 2;

    static std::uint64_t key_of(const Eigen::Array3i& cell) {
        std::uint64_t key = 0;
        for (int k = 0; k < 3; ++k)
            key = (key << 20) | (static_cast<std::uint64_t>(cell[k] + 500000) & 0xfffff);
        return key;
    }
    static std::uint64_t cell_of(const Vector3& at) {
        return key_of((at.array() / kCell_mm).floor().cast<int>());
    }

    SkinPaintSettings settings_;
    CounterRandom random_;
    Vector3 tone_;
    std::vector<Vector3> wave_, brows_;
    std::vector<double> phase_, lips_;
    std::unordered_map<std::uint64_t, std::vector<Spot>> spots_;
};

/// Light and camera of a visit, in the face's own frame; a function of the seed. `tone`: for which
/// the exposure is set.
class VisitLight {
  public:
    VisitLight(std::uint64_t seed, double noise, const Vector3& tone)
        : random_(seed, 2), noise_(noise) {
        const double turn_rad = 2 * (random_.uniform(1) - 0.5),
                     rise_rad = 1.2 * random_.uniform(2) - 0.4;
        towards_ = Vector3(std::sin(turn_rad), std::sin(rise_rad), std::cos(turn_rad)).normalized();
        ambient_ = 0.45 + 0.3 * random_.uniform(3);
        exposure_ = 0.5 + 0.2 * random_.uniform(12);
        gain_ = Vector3(0.85 + 0.3 * random_.uniform(4), 0.85 + 0.2 * random_.uniform(5),
                        0.8 + 0.35 * random_.uniform(6));
        gain_ *= exposure_ / (tone.mean() / 255);
        gamma_ = 0.85 + 0.3 * random_.uniform(7);
        shadow_ =
            Vector3(random_.normal(8), random_.normal(9), 0.3 * random_.normal(10)).normalized();
        shadow_at_mm_ = 25 + 25 * random_.uniform(11);
    }

    /// `place`: from the middle of the face.
    Vector3 photograph(const Vector3& color, const Vector3& normal, const Vector3& place,
                       std::uint64_t number) const {
        const double lit = ambient_ + (1 - ambient_) * 1.3 * std::max(0.0, normal.dot(towards_));
        const double shade = 1 - 0.3 * fade((shadow_.dot(place) - shadow_at_mm_) / 6);
        Vector3 light = color.cwiseProduct(gain_) * (lit * shade) / 255;
        for (int k = 0; k < 3; ++k)
            light[k] = 255 * std::pow(std::clamp(light[k], 0.0, 1.0), gamma_) +
                       noise_ * random_.normal(1000 + 3 * number + static_cast<std::uint64_t>(k));
        return light;
    }

  private:
    CounterRandom random_;
    double noise_;
    Vector3 towards_, gain_, shadow_;
    double ambient_ = 0.5, exposure_ = 0.6, gamma_ = 1, shadow_at_mm_ = 0;
};

/// Paints a scan of a face that is known: `truth`, template topology, in the scan's frame. What
/// lies farther than hair_mm from it is hair.
class ScanPainter {
  public:
    ScanPainter(const DeformationModel& model, const PaintedSkin& skin, const VisitLight& light,
                const Points& truth, const TriMesh& scan, const Context& context)
        : mesh_(model.template_mesh),
          skin_(skin),
          light_(light),
          truth_(truth),
          tree_(truth, mesh_.triangles, context),
          normals_(vertex_normals(truth, mesh_.triangles)),
          hair_(static_cast<std::size_t>(scan.triangles.rows()), 0),
          hint_(hair_.size(), SurfaceHit::kNone) {
        // The frame of the face at rest, for the light.
        motion_ = align_points(truth, mesh_.vertices, {}, false);
        for (Index t = 0; t < scan.triangles.rows(); ++t) {
            Vector3 middle = Vector3::Zero();
            for (int k = 0; k < 3; ++k)
                middle += scan.vertices.row(scan.triangles(t, k)).transpose() / 3;
            const SurfaceHit hit = tree_.closest(middle);
            hint_[static_cast<std::size_t>(t)] = hit.triangle;
            hair_[static_cast<std::size_t>(t)] = hit.distance() > kHair_mm;
        }
    }

    Vector3 operator()(Index triangle, const Vector3& place) const {
        const std::size_t t = static_cast<std::size_t>(triangle);
        const std::uint64_t number = counter_++;
        const SurfaceHit hit = tree_.closest(place, 1e30, hint_[t]);
        if (hair_[t])
            return light_.photograph(Vector3(60, 44, 34), motion_.rotation.row(2), place, number);
        Vector3 rest = Vector3::Zero(), normal = rest;
        double lips = 0;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh_.triangles(hit.triangle, k);
            rest += hit.barycentric[k] * mesh_.vertices.row(v).transpose();
            normal += hit.barycentric[k] * normals_.row(v).transpose();
            lips += hit.barycentric[k] * skin_.lips(v);
        }
        const Vector3 color = skin_.color(rest, lips);
        return light_.photograph(color, motion_.rotation * normal.normalized(),
                                 motion_.apply(hit.point), number);
    }

  private:
    static constexpr double kHair_mm = 1.2;
    const TriMesh& mesh_;
    const PaintedSkin& skin_;
    const VisitLight& light_;
    const Points& truth_;
    TriangleTree tree_;
    Points normals_;
    Similarity motion_;
    std::vector<std::uint8_t> hair_;
    std::vector<std::uint32_t> hint_;
    mutable std::uint64_t counter_ = 0;
};

}  // namespace mien
