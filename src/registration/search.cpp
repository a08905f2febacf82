#include "registration/search.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/progress_part.hpp"
#include "base/scalar_math.hpp"
#include "geometry/alignment.hpp"
#include "geometry/normals.hpp"
#include "geometry/principal_frame.hpp"

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

// The same of points that stand for the scan; `motion` leads to the field's own frame.
double scout_score(const Probe& probe, const SearchField& field, const Similarity& motion,
                   double s) {
    double sum = 0;
    for (Index i = 0; i < probe.places.rows(); ++i) {
        const Vector3 place = motion.apply(Vector3(probe.places.row(i)));
        const SearchField::Near near = field.near(place);
        if (near.place == nullptr) continue;
        const Eigen::Map<const Vector3> there(near.place), normal(near.normal);
        const double agreement = normal.dot(motion.rotation * probe.normals.row(i).transpose());
        if (agreement <= 0) continue;
        sum += std::exp(-0.5 * (there - place).squaredNorm() / (s * s)) * agreement;
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

// Directions that are spread evenly over the sphere: the golden spiral.
std::vector<Vector3> even_directions(int count) {
    const double golden_rad = kPi * (3 - std::sqrt(5.0));
    std::vector<Vector3> directions;
    for (int k = 0; k < count; ++k) {
        const double height = 1 - (2 * k + 1) / static_cast<double>(count);
        const double radius = std::sqrt(1 - height * height);
        directions.push_back(
            {radius * std::cos(golden_rad * k), radius * std::sin(golden_rad * k), height});
    }
    return directions;
}

// Turns +z into `view`, by the shortest way.
Matrix3 towards(const Vector3& view) {
    return Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), view).toRotationMatrix();
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
    std::vector<std::pair<double, Index>> heights;
    for (const Index i : thin)
        if (scan.vertex_normal(i).dot(view) >= settings.summit_facing)
            heights.push_back({-vertices.row(i).dot(view), i});
    std::sort(heights.begin(), heights.end());
    std::vector<Vector3> summits;
    for (const auto& [height, i] : heights) {
        const Vector3 place = vertices.row(i).transpose();
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
};

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

// Each rotation with the template's tip at each of the scan's summits, scored roughly. Directions
// and rolls are those of the scan's own frame.
std::vector<Candidate> scout(const Probes& probes, const ScanView& scan,
                             const SearchSettings& settings, const Context& context) {
    const Matrix3 frame = principal_frame(scan.surface().vertices, scan.surface().triangles);
    const std::vector<Index> thin = thin_out(scan, settings.scan_vertices);
    const SearchField field(scan, thin, frame, settings.field);
    const std::vector<Vector3> views = even_directions(settings.views);
    std::vector<std::vector<Candidate>> found(views.size());
    parallel_for(context, views.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::vector<Vector3> summits =
                find_summits(scan, thin, frame * views[k], settings);
            for (int roll = 0; roll < settings.rolls; ++roll) {
                const double roll_rad = 2 * kPi * roll / settings.rolls;
                Similarity own;
                own.rotation = towards(views[k]) *
                               Eigen::AngleAxisd(roll_rad, Vector3::UnitZ()).toRotationMatrix();
                Candidate candidate;
                candidate.motion.rotation = frame * own.rotation;
                for (const Vector3& summit : summits) {
                    own.translation = frame.transpose() * summit - own.rotation * probes.coarse.tip;
                    candidate.motion.translation = frame * own.translation;
                    candidate.score =
                        scout_score(probes.coarse, field, own, settings.scout_scale_mm);
                    found[k].push_back(candidate);
                }
            }
        }
    });
    std::vector<Candidate> candidates;
    for (const std::vector<Candidate>& of_view : found)
        candidates.insert(candidates.end(), of_view.begin(), of_view.end());
    return candidates;
}

// Best first, and no more than `most`; equal ones in their order.
void keep_best(std::vector<Candidate>& candidates, std::size_t most) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    candidates.resize(std::min(candidates.size(), most));
}

template <typename Improve>
void improve_all(std::vector<Candidate>& candidates, std::size_t chunk, const Context& context,
                 const Improve& improve) {
    parallel_for(context, candidates.size(), chunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) improve(candidates[k]);
    });
}

}  // namespace

SearchResult search_pose(const DeformationModel& model, const ScanView& scan,
                         const SearchSettings& settings, const Context& context) {
    const Probes probes = make_probes(model, settings);
    std::vector<Candidate> candidates = scout(probes, scan, settings, context);
    keep_best(candidates, settings.sharpened);
    context.progress(Stage::alignment, 0.2);
    improve_all(candidates, 16, context, [&](Candidate& one) {
        one.motion = sharpen(probes.coarse, scan, one.motion, settings.first, settings);
        one.score = score(probes.coarse, scan, one.motion, settings.coarse_scale_mm, settings);
    });
    keep_best(candidates, settings.candidates);
    context.progress(Stage::alignment, 0.3);
    improve_all(candidates, 1, context, [&](Candidate& one) {
        one.motion = sharpen(probes.coarse, scan, one.motion, settings.second, settings);
        one.motion = sharpen(probes.fine, scan, one.motion, settings.third, settings);
        one.score = score(probes.fine, scan, one.motion, settings.fine_scale_mm, settings);
    });
    keep_best(candidates, 1);
    context.progress(Stage::alignment, 0.45);
    if (candidates.empty()) return {};
    return {candidates.front().motion, candidates.front().score};
}

SearchResult search_pose_and_side(const DeformationModel& model, ScanView& scan,
                                  const SearchSettings& settings, const Context& context) {
    SearchResult found = search_pose(model, scan, settings, context);
    if (found.score >= settings.good) return found;
    // A further search goes on in what the start as a whole reports.
    const ProgressPart further(context, 0.45, 0.85);
    scan.turn_over();
    SearchResult turned = search_pose(model, scan, settings, further.context());
    if (turned.score > found.score + settings.turned_by) return turned;
    scan.turn_over();
    return found;
}

}  // namespace mien
