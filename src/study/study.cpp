#include "study/study.hpp"

#include <array>
#include <cmath>

#include "base/error.hpp"
#include "measure/distance.hpp"
#include "measure/pair_check.hpp"
#include "measure/repeatability.hpp"
#include "model/template_walls.hpp"

namespace mien {
namespace {

constexpr std::size_t kFewestBlanks = 2;  ///< that a deviation can be had of

std::array<StudyValue*, 6> values_of(ZoneChange& change) {
    return {&change.signed_ml,   &change.gained_ml, &change.lost_ml,
            &change.absolute_ml, &change.area_mm2,  &change.mean_distance_mm};
}

/// 1 where every face tells a weight below the least.
std::vector<std::uint8_t> seen_by_none(const std::vector<StudyFace>& faces, double least) {
    std::vector<std::uint8_t> none(static_cast<std::size_t>(faces.front().mesh->vertices.rows()),
                                   1);
    for (const StudyFace& face : faces)
        for (std::size_t v = 0; v < none.size(); ++v)
            if (face.weights.size() == 0 || face.weights[static_cast<Index>(v)] >= least)
                none[v] = 0;
    return none;
}

}  // namespace

Study::Study(const Context& context, std::shared_ptr<const ExpressionModel> model,
             std::vector<StudyFace> faces, StudySettings settings) {
    check_study_settings(settings);
    check_study_faces(faces);
    check_patches(settings.zones.zones, faces.front().mesh->triangles,
                  faces.front().mesh->vertices.rows());
    data_.zones = resolve_zones(settings.zones, faces.front().mesh->vertices, model != nullptr);
    if (!settings.zones.unseen && !data_.zones.named.empty())
        leave_out(data_.zones.named, find_walls(*faces.front().mesh, WallSettings(), context));
    data_.zones.measured = data_.zones.named;
    if (!settings.zones.unseen)
        leave_out(data_.zones.measured, seen_by_none(faces, settings.reporting.least_seen_weight));
    data_.settings = std::move(settings);
    data_.faces = std::move(faces);
    data_.model = std::move(model);
    data_.neutral = neutral_faces(context, data_.model.get(), data_.faces, data_.zones.treated);
    if (data_.model && data_.faces.size() > 1) data_.expression_map = expression_map(*data_.model);
    for (std::size_t k = 0; k < data_.faces.size(); ++k)
        if (k == 0 || data_.faces[k].visit != data_.faces[k - 1].visit) first_of_.push_back(k);
    measure_blanks(context);
    for (std::size_t k = 1; k < num_visits(); ++k) {
        context.progress(Stage::measuring,
                         static_cast<double>(k) / static_cast<double>(num_visits()));
        pairs_.emplace(std::make_pair(std::size_t{0}, k), measured(context, 0, first_of_[k]));
    }
    context.progress(Stage::measuring, 1.0);
}

void Study::measure_blanks(const Context& context) {
    const std::size_t num_zones = zones().size();
    std::vector<std::array<std::vector<double>, 6>> blanks(num_zones);
    for (std::size_t k = 0; k < num_visits(); ++k)
        for (std::size_t a = first_of_[k]; a < first_of_[k] + num_captures(k); ++a)
            for (std::size_t b = a + 1; b < first_of_[k] + num_captures(k); ++b) {
                if (data_.faces[a].failed || data_.faces[b].failed) continue;
                PairChange pair = compare_faces(context, data_, a, b);
                ++num_blanks_;
                for (std::size_t z = 0; z < num_zones; ++z) {
                    const auto values = values_of(pair.zones[z]);
                    for (std::size_t i = 0; i < values.size(); ++i)
                        if (std::isfinite(values[i]->value))
                            blanks[z][i].push_back(values[i]->value);
                }
            }
    limits_.resize(num_zones);
    for (std::size_t z = 0; z < num_zones; ++z)
        if (blanks[z][0].size() >= kFewestBlanks)
            for (const std::vector<double>& values : blanks[z])
                limits_[z].push_back(detection_limit(values).minimal_detectable_change);
}

PairChange Study::measured(const Context& context, std::size_t first, std::size_t second) const {
    PairChange pair = compare_faces(context, data_, first, second);
    for (std::size_t z = 0; z < pair.zones.size(); ++z) {
        ZoneChange& change = pair.zones[z];
        if (limits_[z].empty() || change.reason == WhyUnknown::unseen) continue;
        const auto values = values_of(change);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i]->limit_of_detection = limits_[z][i];
        change.detected =
            compare_with_limit(change.signed_ml.value, limits_[z][0]) == Detection::detected ? 1
                                                                                             : 0;
    }
    return pair;
}

std::size_t Study::face_of(std::size_t visit) const {
    if (visit >= num_visits())
        fail(Status::not_found, "visit %zu, but the study has %zu", visit, num_visits());
    return first_of_[visit];
}

std::size_t Study::num_captures(std::size_t visit) const {
    const std::size_t begin = face_of(visit);
    return (visit + 1 < num_visits() ? first_of_[visit + 1] : data_.faces.size()) - begin;
}

const PairChange& Study::change(std::size_t first, std::size_t second) const {
    const std::size_t a = face_of(first), b = face_of(second);
    if (first == second)
        fail(Status::invalid_argument, "visit %zu against itself: name two visits", first);
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto key = std::make_pair(first, second);
    const auto found = pairs_.find(key);
    if (found != pairs_.end()) return found->second;
    return pairs_.emplace(key, measured(Context(), a, b)).first->second;
}

TriMesh Study::neutral(std::size_t visit, std::size_t frame) const {
    const std::size_t face = face_of(visit);
    if (visit == frame) return *data_.neutral.meshes[face];
    return aligned_face(data_, face, change(frame, visit).alignment);
}

Vector Study::distances_mm(std::size_t first, std::size_t second) const {
    const TriMesh& before = *data_.neutral.meshes[face_of(first)];
    const TriMesh after = neutral(second, first);
    return measure_distance(before.vertices, after.vertices, before.triangles, {}, Context())
        .signed_mm;
}

}  // namespace mien
