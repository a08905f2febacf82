#include "registration/search.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "geometry/alignment.hpp"
#include "geometry/normals.hpp"

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

Probe make_probe(const DeformationModel& model, const ProbeSettings& settings, double facing) {
    const Index count = settings.vertices;
    const double radius_mm = settings.radius_mm;
    const Points shape = rest_shape(model);
    const Points normals = vertex_normals(shape, model.template_mesh.triangles);
    Probe probe;
    Index tip;
    shape.col(2).maxCoeff(&tip);
    probe.tip = shape.row(tip).transpose();
    std::vector<Index> inside;
    for (Index i = 0; i < shape.rows(); ++i)
        if ((shape.row(i).transpose() - probe.tip).norm() < radius_mm && normals(i, 2) > facing)
            inside.push_back(i);
    // Vertices crowd at lids and lips; keep at most one per cell of a coarse grid.
    std::vector<Index> taken;
    const double cell =
        std::sqrt(3.0 * radius_mm * radius_mm / static_cast<double>(std::max<Index>(1, count)));
    constexpr long long kMiddle = 1000;  // more cells than a head has to a side
    std::vector<std::pair<long long, Index>> keyed;
    for (Index i : inside) {
        const long long a = std::llround((shape(i, 0) - probe.tip[0]) / cell),
                        b = std::llround((shape(i, 1) - probe.tip[1]) / cell);
        keyed.push_back({(a + kMiddle) * 4 * kMiddle + b + kMiddle, i});
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

// The score at scale `s`, mm.
double score(const Probe& probe, const ScanView& scan, const Similarity& motion, double s,
             const SearchSettings& settings) {
    double sum = 0;
    for (Index i = 0; i < probe.places.rows(); ++i) {
        const SurfaceHit hit =
            scan.tree().closest(motion.apply(Vector3(probe.places.row(i))), settings.reach * s);
        if (!hit.valid()) continue;
        const double agreement =
            scan.normal_at(hit).dot(motion.rotation * probe.normals.row(i).transpose());
        if (agreement <= 0) continue;
        sum += std::exp(-0.5 * hit.squared_distance / (s * s)) * agreement;
    }
    return sum / static_cast<double>(std::max<Index>(1, probe.places.rows()));
}

// Point-to-point with robust weights; the far part of the probe gets none.
Similarity sharpen(const Probe& probe, const ScanView& scan, Similarity motion,
                   const SharpenSettings& schedule, const SearchSettings& settings) {
    const int rounds = schedule.rounds;
    for (int round = 0; round < rounds; ++round) {
        const double s = schedule.start_mm *
                         std::pow(schedule.end_mm / schedule.start_mm,
                                  rounds > 1 ? static_cast<double>(round) / (rounds - 1) : 1);
        Points target(probe.places.rows(), 3);
        Vector weight = Vector::Zero(probe.places.rows());
        for (Index i = 0; i < probe.places.rows(); ++i) {
            const Vector3 place = motion.apply(Vector3(probe.places.row(i)));
            const SurfaceHit hit = scan.tree().closest(place, settings.reach * s);
            target.row(i) = place.transpose();
            if (!hit.valid() || scan.surface().at_border(hit)) continue;
            const Vector3 normal = scan.normal_at(hit);
            const double agreement = normal.dot(motion.rotation * probe.normals.row(i).transpose());
            if (agreement <= settings.sharpen_facing) continue;
            target.row(i) = (place + settings.overshoot * (hit.point - place)).transpose();
            weight[i] = agreement * std::exp(-0.5 * hit.squared_distance / (s * s));
        }
        if (weight.sum() < settings.least_weight) return motion;
        try {
            motion = align_points(probe.places, target, weight, false);
        } catch (const Error& error) {
            if (error.status() != Status::no_solution) throw;
            return motion;  // what is near lies on a line
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

// A thinned scan for the summits: every k-th vertex that has a normal.
std::vector<Index> thin_out(const ScanView& scan, Index about) {
    const Index count = scan.surface().vertices.rows();
    const Index stride = std::max<Index>(1, count / about);
    std::vector<Index> thin;
    for (Index i = 0; i < count; i += stride)
        if (!scan.vertex_normal(i).isZero(0)) thin.push_back(i);
    return thin;
}

// The scan's highest places along `view` that face it, highest first.
std::vector<Vector3> find_summits(const ScanView& scan, const std::vector<Index>& thin,
                                  const Vector3& view, const SearchSettings& settings) {
    const Points& vertices = scan.surface().vertices;
    std::vector<std::pair<double, Index>> heights(thin.size());
    for (std::size_t j = 0; j < thin.size(); ++j)
        heights[j] = {-vertices.row(thin[j]).dot(view), thin[j]};
    std::sort(heights.begin(), heights.end());
    std::vector<Vector3> summits;
    for (const auto& [height, i] : heights) {
        const Vector3 place = vertices.row(i).transpose();
        if (scan.vertex_normal(i).dot(view) < settings.summit_facing) continue;
        bool apart = true;
        for (const Vector3& other : summits)
            apart = apart && (place - other).norm() > settings.summit_distance_mm;
        if (!apart) continue;
        summits.push_back(place);
        if (summits.size() == static_cast<std::size_t>(settings.summits)) break;
    }
    return summits;
}

struct Candidate {
    Similarity motion;
    double score = 0;
    bool exists = false;  // the rotation has so many summits
};

// Best first; equal ones in their order.
void rank(std::vector<Candidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
}

struct Probes {
    Probe coarse, fine;
};

Probes make_probes(const DeformationModel& model, const SearchSettings& settings) {
    Probes probes{make_probe(model, settings.coarse, settings.probe_facing),
                  make_probe(model, settings.fine, settings.probe_facing)};
    if (probes.coarse.places.rows() < settings.fewest_probes)
        fail(Status::no_solution,
             "the template shows no face towards +z; give landmarks or a pose");
    return probes;
}

// Each rotation with the template's tip at each of the scan's summits.
std::vector<Candidate> start_candidates(const Probes& probes, const ScanView& scan,
                                        const std::vector<Matrix3>& rotations,
                                        const SearchSettings& settings, const Context& context) {
    const std::vector<Index> thin = thin_out(scan, settings.scan_vertices);
    const std::size_t most = static_cast<std::size_t>(settings.summits);
    std::vector<std::vector<Vector3>> summits(rotations.size());
    parallel_for(context, rotations.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            summits[k] = find_summits(scan, thin, rotations[k] * Vector3::UnitZ(), settings);
    });
    std::vector<Candidate> candidates(rotations.size() * most);
    for (std::size_t k = 0; k < rotations.size(); ++k)
        for (std::size_t s = 0; s < summits[k].size(); ++s) {
            Candidate& candidate = candidates[k * most + s];
            candidate.motion.rotation = rotations[k];
            candidate.motion.translation = summits[k][s] - rotations[k] * probes.coarse.tip;
            candidate.exists = true;
        }
    return candidates;
}

void sharpen_all(const Probes& probes, const ScanView& scan, const SearchSettings& settings,
                 std::vector<Candidate>& candidates, const Context& context) {
    const std::size_t chunk = 16;
    parallel_for(context, candidates.size(), chunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Candidate& candidate = candidates[k];
            if (!candidate.exists) continue;
            candidate.motion =
                sharpen(probes.coarse, scan, candidate.motion, settings.first, settings);
            candidate.score =
                score(probes.coarse, scan, candidate.motion, settings.coarse_scale_mm, settings);
        }
    });
}

SearchResult refine_best(const Probes& probes, const ScanView& scan, const SearchSettings& settings,
                         std::vector<Candidate> candidates, const Context& context) {
    rank(candidates);
    candidates.resize(std::min(candidates.size(), settings.candidates));
    parallel_for(context, candidates.size(), 1, [&](std::size_t k, std::size_t) {
        Candidate& candidate = candidates[k];
        candidate.motion =
            sharpen(probes.coarse, scan, candidate.motion, settings.second, settings);
        candidate.motion = sharpen(probes.fine, scan, candidate.motion, settings.third, settings);
        candidate.score =
            score(probes.fine, scan, candidate.motion, settings.fine_scale_mm, settings);
    });
    rank(candidates);
    return {candidates.front().motion, candidates.front().score};
}

// The 24 turns of the cube: every rotation lies within 63 degrees of one.
std::vector<Matrix3> cube_rotations() {
    std::vector<Matrix3> turns;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            for (int signs = 0; signs < 4 && x != y; ++signs) {
                Matrix3 turn = Matrix3::Zero();
                turn(x, 0) = signs % 2 == 0 ? 1 : -1;
                turn(y, 1) = signs / 2 == 0 ? 1 : -1;
                turn.col(2) = Vector3(turn.col(0)).cross(Vector3(turn.col(1)));
                turns.push_back(turn);
            }
    return turns;
}

}  // namespace

SearchResult search_pose(const DeformationModel& model, const ScanView& scan,
                         const SearchSettings& settings, const Context& context) {
    const Probes probes = make_probes(model, settings);
    std::vector<Candidate> candidates =
        start_candidates(probes, scan,
                         rotation_grid(settings.range_deg * kRadiansPerDegree,
                                       settings.step_deg * kRadiansPerDegree),
                         settings, context);
    sharpen_all(probes, scan, settings, candidates, context);
    context.progress(Stage::alignment, 0.3);
    const SearchResult found = refine_best(probes, scan, settings, std::move(candidates), context);
    context.progress(Stage::alignment, 0.45);
    return found;
}

SearchResult search_all_poses(const DeformationModel& model, const ScanView& scan,
                              const SearchSettings& settings, const Context& context) {
    const Probes probes = make_probes(model, settings);
    const std::vector<Matrix3> near = rotation_grid(settings.range_deg * kRadiansPerDegree,
                                                    settings.all_step_deg * kRadiansPerDegree);
    std::vector<Matrix3> rotations;
    for (const Matrix3& turn : cube_rotations())
        for (const Matrix3& rotation : near) rotations.push_back(turn * rotation);
    std::vector<Candidate> candidates =
        start_candidates(probes, scan, rotations, settings, context);
    const std::size_t chunk = 64;
    parallel_for(context, candidates.size(), chunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            if (candidates[k].exists)
                candidates[k].score = score(probes.coarse, scan, candidates[k].motion,
                                            settings.all_scale_mm, settings);
    });
    rank(candidates);
    candidates.resize(std::min(candidates.size(), settings.all_candidates));
    sharpen_all(probes, scan, settings, candidates, context);
    return refine_best(probes, scan, settings, std::move(candidates), context);
}

SearchResult search_pose_and_side(const DeformationModel& model, ScanView& scan,
                                  const SearchSettings& settings, const Context& context) {
    SearchResult found = search_pose(model, scan, settings, context);
    if (found.score >= settings.sure) return found;
    Context quiet = context;  // further searches would report the first one's fractions again
    quiet.progress_function = nullptr;
    const auto better = [&](const SearchResult& other) {
        return other.score > found.score + settings.turned_by;
    };
    const SearchResult anywhere = search_all_poses(model, scan, settings, quiet);
    if (better(anywhere)) found = anywhere;
    if (found.score >= settings.good) return found;
    scan.turn_over();
    SearchResult turned = search_pose(model, scan, settings, quiet);
    if (turned.score < settings.sure) {
        const SearchResult turned_anywhere = search_all_poses(model, scan, settings, quiet);
        if (turned_anywhere.score > turned.score + settings.turned_by) turned = turned_anywhere;
    }
    if (better(turned)) return turned;
    scan.turn_over();
    return found;
}

}  // namespace mien
