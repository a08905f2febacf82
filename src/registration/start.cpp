#include "registration/start.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/normals.hpp"
#include "model/landmarks.hpp"

namespace mien {
namespace {

// Pins with the names that the host gave them.
struct NamedPins {
    std::vector<Pin> pins;
    std::vector<std::string> names;
};

// In the order given; names that the model does not know are returned aside.
NamedPins match_landmarks(const DeformationModel& model,
                          const std::vector<LandmarkPoint>& landmarks, double unit_to_mm,
                          double sigma_mm, std::vector<std::string>& unknown) {
    NamedPins matched;
    for (const LandmarkPoint& point : landmarks) {
        if (!point.point.allFinite())
            fail(Status::invalid_argument, "landmark '%.60s' is not finite", point.name.c_str());
        const Landmark* known = find_landmark(model.landmarks, point.name);
        if (known == nullptr) {
            unknown.push_back(point.name);
            continue;
        }
        matched.pins.push_back(
            {static_cast<Index>(known->vertex), unit_to_mm * point.point, sigma_mm});
        matched.names.push_back(point.name);
    }
    return matched;
}

StartKind choose_kind(StartKind asked, std::size_t num_pins, std::size_t num_landmarks) {
    if (asked == StartKind::automatic)
        return num_pins >= StartState::kFewestPins ? StartKind::landmarks : StartKind::search;
    if (asked == StartKind::landmarks && num_pins < StartState::kFewestPins)
        fail(Status::not_found,
             "%zu of %zu landmarks are known to the model, at least 3 are needed", num_pins,
             num_landmarks);
    return asked;
}

// The motion of the chosen kind; a search may turn the scan over.
void find_motion(const DeformationModel& model, StartKind kind, const std::vector<Pin>& pins,
                 bool with_scale, const StartSettings& settings, StartState& start,
                 const Context& context) {
    switch (kind) {
        case StartKind::landmarks:
            start.motion = align_pins(model, pins, with_scale, settings.alignment);
            break;
        case StartKind::pose:
            start.motion = settings.pose;
            break;
        case StartKind::automatic:
        case StartKind::search: {
            const SearchResult found =
                search_pose_and_side(model, start.scan, settings.search, context);
            start.search_score = found.score;
            start.searched = true;
            start.motion = found.motion;
            break;
        }
    }
    start.state.motion = start.motion;
}

// Landmarks of exchanged sides are refused, or mended when the host asked for that.
void settle_sides(const DeformationModel& model, bool with_scale, const StartSettings& settings,
                  NamedPins& matched, StartState& start) {
    if (settings.sides.rule == SideRule::ignore) return;
    const ExchangedSides sides =
        find_exchanged_sides(model, matched.pins, with_scale, settings.sides, settings.alignment);
    if (sides.pins.empty()) return;
    const std::string text = describe(sides, matched.names);
    if (settings.sides.rule == SideRule::refuse)
        fail(Status::mismatch, "%s; exchange them, or ask for mended landmark sides", text.c_str());
    for (const std::size_t k : sides.pins) matched.pins[k].vertex = sides.partner_vertex[k];
    start.notes.push_back(text + "; they were exchanged back");
}

void reject(const std::vector<std::size_t>& ascending, NamedPins& matched, StartState& start) {
    for (auto k = ascending.rbegin(); k != ascending.rend(); ++k) {
        start.rejected.push_back(matched.names[*k]);
        matched.pins.erase(matched.pins.begin() + static_cast<std::ptrdiff_t>(*k));
        matched.names.erase(matched.names.begin() + static_cast<std::ptrdiff_t>(*k));
    }
}

// Weighs the pins and the kernel against each other, leaves contradicted pins out, and deforms
// towards the rest.
void use_pins(const DeformationModel& model, const PriorState& prior, StartKind kind,
              NamedPins matched, const StartSettings& settings, StartState& start,
              const Context& context) {
    std::vector<Pin>& pins = matched.pins;
    if (pins.empty()) return;
    FitState& state = start.state;
    const auto align_again = [&] {
        if (kind == StartKind::landmarks && pins.size() >= StartState::kFewestPins)
            state.motion = align_pins(model, pins, prior.freedom.scale, settings.alignment);
    };
    const std::vector<std::size_t> gross = gross_pins(model, pins, state.motion, settings.gross);
    if (!gross.empty()) {
        reject(gross, matched, start);
        align_again();
    }
    // What is estimated from a wrong landmark is wrong: after each rejection all begins anew, as if
    // the rejected had never been given.
    const double amplitude_before = state.kernel_amplitude;
    const std::size_t most =
        std::max<std::size_t>(1, pins.size() / settings.pin_prior.reject_one_in);
    std::size_t num_contradicted = 0;
    const double pca_amplitude = prior.pin_pca_amplitude();
    for (;;) {
        std::vector<Pin> weighed = pins;
        state.kernel_amplitude = amplitude_before;
        if (!prior.amplitude_given) {
            const PinFactors likeliest =
                weigh_pins(model, weighed, state.motion, state.kernel_amplitude, pca_amplitude,
                           settings.pin_prior, context);
            state.kernel_amplitude *= likeliest.amplitude;
            for (Pin& pin : weighed) pin.sigma_mm *= likeliest.noise;
            start.pin_factors = likeliest;
            context.log(LogLevel::debug, "kernel amplitude %.3f, picking error times %.2f",
                        state.kernel_amplitude, likeliest.noise);
        }
        std::vector<std::size_t> rejected =
            contradicting_pins(model, weighed, state.motion, state.kernel_amplitude, pca_amplitude,
                               settings.pin_prior, context);
        num_contradicted += rejected.size();
        if (rejected.empty() || num_contradicted > most) {
            start.pins = std::move(weighed);
            break;
        }
        std::sort(rejected.begin(), rejected.end());
        reject(rejected, matched, start);
        align_again();
        if (pins.empty()) break;
    }
    if (start.is_free()) return;
    fit_pins(model, start.pins, prior.freedom, settings.pin_fit, state, context);
}

// Share of places near the scan whose normals oppose it.
double opposed_share(const DeformationModel& model, const ScanView& scan, const Points& places,
                     const FacingSettings& settings, const Context& context) {
    const Points normals = vertex_normals(places, model.template_mesh.triangles);
    std::vector<SurfaceHit> hits;
    scan.tree().closest(places, settings.reach_mm, hits, context);
    Index near = 0, opposed = 0;
    for (Index i = 0; i < places.rows(); ++i) {
        const SurfaceHit& hit = hits[static_cast<std::size_t>(i)];
        if (!hit.valid()) continue;
        const double cosine = normals.row(i).dot(scan.normal_at(hit).transpose());
        if (std::abs(cosine) < settings.least_cosine) continue;
        ++near;
        opposed += cosine < 0;
    }
    return near > 0 ? static_cast<double>(opposed) / static_cast<double>(near) : 0;
}

// Turns the scan over when the shape of a start without a search faces its inside, unless the scan
// plainly faces outwards: then it is the landmarks that lie.
void face_outwards(const DeformationModel& model, const FacingSettings& settings, double outward,
                   bool from_landmarks, StartState& start, const Context& context) {
    const Points& rest = model.template_mesh.vertices;
    const Points shaped = start.state.places.rows() == rest.rows()
                              ? start.state.places
                              : Points(start.state.motion.apply(PointsRef(rest)));
    if (!(opposed_share(model, start.scan, shaped, settings, context) > settings.opposed)) return;
    if (from_landmarks && outward > settings.outward)
        fail(Status::mismatch,
             "by its landmarks the face would look into the head: the landmarks are mirrored (left "
             "and right are exchanged in their names), or the scan is mirrored");
    start.scan.turn_over();
}

// Whether brows or lips stand out at all: a grey scan tells nothing of lids either.
bool colors_vary(const DeformationModel& model, const PriorState& prior, const StartState& start,
                 const LoopSettings& fit, const Context& context) {
    const Points normals = vertex_normals(start.state.places, model.template_mesh.triangles);
    for (const ColorAgreement& feature :
         prior.colors.agreements(start.scan, start.state.places, normals, fit.match, context))
        if (feature.trust > 0) return true;
    return false;
}

}  // namespace

StartState find_start(const DeformationModel& model, const PreparedScan& scan,
                      const PriorState& prior, const std::vector<LandmarkPoint>& landmarks,
                      const StartSettings& settings, const LoopSettings& fit,
                      const Context& context) {
    StartState start{
        ScanView(scan.surface), prior.state_at_rest(), {}, {}, {}, {}, {}, 0, false, {}, {}, {}};
    NamedPins matched = match_landmarks(model, landmarks, scan.unit_to_mm,
                                        settings.landmark_sigma_mm, start.unknown);
    if (const PointsRef places(scan.surface.vertices); places.rows() > 0)
        reject(far_pins(matched.pins, places.colwise().minCoeff(), places.colwise().maxCoeff(),
                        settings.gross),
               matched, start);
    const StartKind kind = choose_kind(settings.kind, matched.pins.size(), landmarks.size());
    if (kind == StartKind::landmarks)
        settle_sides(model, prior.freedom.scale, settings, matched, start);
    find_motion(model, kind, matched.pins, prior.freedom.scale, settings, start, context);
    use_pins(model, prior, kind, std::move(matched), settings, start, context);
    context.progress(Stage::alignment, 0.9);
    if (kind != StartKind::search)
        face_outwards(model, settings.facing, scan.outward, kind == StartKind::landmarks, start,
                      context);
    start.held = start.pins;
    if (start.is_free()) {
        const std::vector<Pin> no_pins;
        const FitProblem problem{model, start.scan, prior.inner, prior.colors, no_pins};
        start_freely(problem, prior, fit, settings.approach, settings.openings, start.state,
                     context);
        if (colors_vary(model, prior, start, fit, context)) {
            const std::vector<Pin> lids = shut_lids(
                model, start.scan, start.state, settings.landmark_sigma_mm, settings.lids, context);
            start.held.insert(start.held.end(), lids.begin(), lids.end());
        }
    }
    context.progress(Stage::alignment, 1);
    return start;
}

}  // namespace mien
