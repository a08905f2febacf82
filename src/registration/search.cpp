// Search of the pose without landmarks. The tip of the nose is what stands out along the viewing
// direction: for each rotation of a grid, the scan's local summits along that direction are tried
// as the tip; a coarse score picks candidates, trimmed ICP sharpens them, a finer score decides.
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/alignment.hpp"
#include "geometry/normals.hpp"
#include "registration/start.hpp"

namespace mien {
namespace {

struct Probe {
    Points places, normals;  // of the template's inner face
    Vector3 tip;
};

Points rest_shape(const DeformationModel& model) {
    Points shape = model.template_mesh.vertices;
    if (model.mean_displacement.rows() > 0) shape += model.mean_displacement;
    return shape;
}

Probe make_probe(const DeformationModel& model, Index count, double radius_mm) {
    const Points shape = rest_shape(model);
    const Points normals = vertex_normals(shape, model.template_mesh.triangles);
    Probe probe;
    Index tip;
    shape.col(2).maxCoeff(&tip);
    probe.tip = shape.row(tip).transpose();
    std::vector<Index> inside;
    for (Index i = 0; i < shape.rows(); ++i)
        if ((shape.row(i).transpose() - probe.tip).norm() < radius_mm && normals(i, 2) > 0.2)
            inside.push_back(i);
    // Vertices crowd at lids and lips; keep at most one per cell of a coarse grid.
    std::vector<Index> taken;
    double cell =
        std::sqrt(3.0 * radius_mm * radius_mm / static_cast<double>(std::max<Index>(1, count)));
    std::vector<std::pair<long long, Index>> keyed;
    for (Index i : inside) {
        const long long a = std::llround((shape(i, 0) - probe.tip[0]) / cell),
                        b = std::llround((shape(i, 1) - probe.tip[1]) / cell);
        keyed.push_back({(a + 1000) * 4000 + b + 1000, i});
    }
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t k = 0; k < keyed.size(); ++k)
        if (k == 0 || keyed[k].first != keyed[k - 1].first) taken.push_back(keyed[k].second);
    probe.places.resize(static_cast<Index>(taken.size()), 3);
    probe.normals.resize(static_cast<Index>(taken.size()), 3);
    for (std::size_t k = 0; k < taken.size(); ++k) {
        probe.places.row(static_cast<Index>(k)) = shape.row(taken[k]);
        probe.normals.row(static_cast<Index>(k)) = normals.row(taken[k]);
    }
    return probe;
}

// Mean over the probe of exp(-d^2 / 2 s^2) times the agreement of the normals.
double score(const Probe& probe, const ScanSurface& scan, const Similarity& motion, double s) {
    double sum = 0;
    for (Index i = 0; i < probe.places.rows(); ++i) {
        const SurfaceHit hit = scan.tree.closest(motion.apply(Vector3(probe.places.row(i))), 3 * s);
        if (!hit.valid()) continue;
        const double agreement =
            scan.normal_at(hit).dot(motion.rotation * probe.normals.row(i).transpose());
        if (agreement <= 0) continue;
        sum += std::exp(-0.5 * hit.squared_distance / (s * s)) * agreement;
    }
    return sum / static_cast<double>(std::max<Index>(1, probe.places.rows()));
}

// Point-to-point with robust weights; the far part of the probe has no say.
Similarity sharpen(const Probe& probe, const ScanSurface& scan, Similarity motion, int rounds,
                   double s0, double s1, bool with_scale) {
    for (int round = 0; round < rounds; ++round) {
        const double s =
            s0 * std::pow(s1 / s0, rounds > 1 ? static_cast<double>(round) / (rounds - 1) : 1);
        Points target(probe.places.rows(), 3);
        Vector weight = Vector::Zero(probe.places.rows());
        for (Index i = 0; i < probe.places.rows(); ++i) {
            const Vector3 place = motion.apply(Vector3(probe.places.row(i)));
            const SurfaceHit hit = scan.tree.closest(place, 3 * s);
            target.row(i) = place.transpose();
            if (!hit.valid() || scan.at_border(hit)) continue;
            const Vector3 normal = scan.normal_at(hit);
            const double agreement = normal.dot(motion.rotation * probe.normals.row(i).transpose());
            if (agreement <= 0.2) continue;
            // Overshoot along the normal: point-to-point alone crawls.
            target.row(i) = (place + 1.5 * (hit.point - place)).transpose();
            weight[i] = agreement * std::exp(-0.5 * hit.squared_distance / (s * s));
        }
        if (weight.sum() < 5) return motion;
        try {
            motion = align_points(probe.places, target, weight, with_scale);
        } catch (const Error&) {
            return motion;
        }
    }
    return motion;
}

std::vector<Matrix3> rotation_grid(double max_rad, double step_rad) {
    std::vector<Matrix3> grid;
    const int n = static_cast<int>(std::ceil(max_rad / step_rad));
    for (int a = -n; a <= n; ++a)
        for (int b = -n; b <= n; ++b)
            for (int c = -n; c <= n; ++c) {
                const Vector3 w = step_rad * Vector3(a, b, c);
                if (w.norm() > max_rad + 1e-9) continue;
                grid.push_back(w.norm() > 0
                                   ? Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix()
                                   : Matrix3(Matrix3::Identity()));
            }
    return grid;
}

}  // namespace

SearchResult search_pose(const DeformationModel& model, const ScanSurface& scan,
                         const Context& context) {
    constexpr double kDegree = 3.14159265358979323846 / 180;
    const Probe coarse = make_probe(model, 70, 75), fine = make_probe(model, 400, 85);
    if (coarse.places.rows() < 10)
        fail(Status::no_solution,
             "the template shows no face towards +z; give landmarks or a pose");

    // A thinned scan for the summits: every k-th vertex that has a normal.
    const Index stride = std::max<Index>(1, scan.vertices.rows() / 4000);
    std::vector<Index> thin;
    for (Index i = 0; i < scan.vertices.rows(); i += stride)
        if (!scan.normals.row(i).isZero(0)) thin.push_back(i);

    struct Candidate {
        Similarity motion;
        double score = 0;
    };
    const std::vector<Matrix3> rotations = rotation_grid(66 * kDegree, 22 * kDegree);
    constexpr int kSummits = 4;
    std::vector<Candidate> candidates(rotations.size() * kSummits);
    parallel_for(context, rotations.size(), 4, [&](std::size_t begin, std::size_t end) {
        std::vector<std::pair<double, Index>> heights(thin.size());
        for (std::size_t k = begin; k < end; ++k) {
            const Vector3 view = rotations[k] * Vector3::UnitZ();
            for (std::size_t j = 0; j < thin.size(); ++j)
                heights[j] = {-scan.vertices.row(thin[j]).dot(view), thin[j]};
            std::sort(heights.begin(), heights.end());
            std::vector<Vector3> summits;
            for (const auto& [height, i] : heights) {
                const Vector3 place = scan.vertices.row(i).transpose();
                if (scan.normals.row(i).dot(view) < 0.6) continue;  // a tip faces the viewer
                bool apart = true;
                for (const Vector3& other : summits) apart = apart && (place - other).norm() > 30;
                if (!apart) continue;
                summits.push_back(place);
                if (summits.size() == kSummits) break;
            }
            for (std::size_t s = 0; s < summits.size(); ++s) {
                Candidate& candidate = candidates[k * kSummits + s];
                candidate.motion.rotation = rotations[k];
                candidate.motion.translation = summits[s] - rotations[k] * coarse.tip;
                candidate.motion = sharpen(coarse, scan, candidate.motion, 3, 15, 10, false);
                candidate.score = score(coarse, scan, candidate.motion, 6);
            }
        }
    });
    context.progress(Stage::alignment, 0.3);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    candidates.resize(std::min<std::size_t>(candidates.size(), 12));
    parallel_for(context, candidates.size(), 1, [&](std::size_t k, std::size_t) {
        Candidate& candidate = candidates[k];
        candidate.motion = sharpen(coarse, scan, candidate.motion, 15, 12, 3, false);
        candidate.motion = sharpen(fine, scan, candidate.motion, 8, 5, 3, false);
        candidate.score = score(fine, scan, candidate.motion, 3);
    });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    context.progress(Stage::alignment, 0.45);
    SearchResult result;
    result.motion = candidates.front().motion;
    result.score = candidates.front().score;
    return result;
}

}  // namespace mien
