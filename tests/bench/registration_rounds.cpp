// How many rounds, on how many vertices, a fit needs: the error by round, or what other numbers of
// the loop change in error and processor time.
//
//   registration_rounds MODEL.safetensors [--free] [--by-round] [--try "NAME=VALUE ..."]
//                       SCAN_FOLDER ...
//
// --by-round: the error of the modes' shape against the truth after each round, before the gap is
// closed, with the round's mean movement. --try (again and again): the same scans with other
// numbers (kNumbers below), compared with the defaults. Folders as for registration_ablation.
#include <cstdio>
#include <cstring>
#include <functional>
#include <sstream>

#include "registration/ready_scan.hpp"
#include "registration_case.hpp"
#include "registration_clock.hpp"

using namespace mien;

namespace {

struct Number {
    const char* name;
    std::function<void(RegistrationSettings&, double)> set;
};

const Number kNumbers[] = {
    {"rounds", [](auto& s, double v) { s.fit.loop.rounds = static_cast<int>(v); }},
    {"sigma_start_mm", [](auto& s, double v) { s.fit.loop.sigma_start_mm = v; }},
    {"sigma_end_mm", [](auto& s, double v) { s.fit.loop.sigma_end_mm = v; }},
    {"sparse_share", [](auto& s, double v) { s.fit.loop.sparse_share = v; }},
    {"sparse_stride", [](auto& s, double v) { s.fit.loop.sparse_stride = static_cast<Index>(v); }},
    {"tolerance", [](auto& s, double v) { s.fit.loop.tolerance = v; }},
    {"last_tolerance", [](auto& s, double v) { s.fit.loop.last_tolerance = v; }},
    {"gram_life", [](auto& s, double v) { s.fit.loop.solver.gram_life = static_cast<int>(v); }},
    {"most_iterations",
     [](auto& s, double v) { s.fit.loop.solver.most_iterations = static_cast<int>(v); }},
    {"pin_rounds", [](auto& s, double v) { s.start.pin_fit.rounds = static_cast<int>(v); }},
    {"pin_others",
     [](auto& s, double v) { s.start.pin_fit.other_vertices = static_cast<Index>(v); }},
    {"approach_rounds", [](auto& s, double v) { s.start.approach.rounds = static_cast<int>(v); }},
    {"approach_stride", [](auto& s, double v) { s.start.approach.stride = static_cast<Index>(v); }},
    {"opening_rounds", [](auto& s, double v) { s.start.openings.rounds = static_cast<int>(v); }},
    {"gap_rounds", [](auto& s, double v) { s.gap.rounds = static_cast<int>(v); }},
    {"gap_tolerance", [](auto& s, double v) { s.gap.field.tolerance = v; }},
    {"gap_iterations",
     [](auto& s, double v) { s.gap.field.most_iterations = static_cast<int>(v); }},
    {"confidence_rows", [](auto& s, double v) { s.confidence.rows = static_cast<Index>(v); }},
    {"confidence_modes",
     [](auto& s, double v) { s.confidence.kernel_modes_alone = static_cast<Index>(v); }},
};

RegistrationSettings changed(const std::string& words) {
    RegistrationSettings settings;
    std::istringstream stream(words);
    for (std::string word; stream >> word;) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        bool known = false;
        for (const Number& number : kNumbers)
            if (name == number.name && equals != std::string::npos) {
                number.set(settings, std::stod(word.substr(equals + 1)));
                known = true;
            }
        if (!known) fail(Status::invalid_argument, "'%.60s' is no number", word.c_str());
    }
    return settings;
}

std::vector<LandmarkPoint> landmarks_of(const Case& one, bool free) {
    return free ? std::vector<LandmarkPoint>() : one.landmarks;
}

// Mean over the visible vertices of the zone "face".
double face_error_mm(const DeformationModel& model, const Case& one, const Points& places) {
    const Zone* face = find_zone(model.zones, "face");
    double sum = 0, count = 0;
    for (const std::uint32_t v : face->vertices)
        if (one.visible[v]) sum += (places.row(v) - one.truth.row(v)).norm(), ++count;
    return sum / count;
}

void print_by_round(const DeformationModel& model, const Case& one, bool free,
                    const RegistrationSettings& settings, const Context& context) {
    const PreparedScan scan = prepare_scan(one.scan, settings.intake, context);
    const PriorState prior =
        choose_prior(model, settings.prior, settings.inner, settings.colors, context);
    const StartState start = find_start(model, scan, prior, landmarks_of(one, free), settings.start,
                                        settings.fit.loop, context);
    const FitProblem problem{model, start.scan, prior.inner, prior.colors, start.held};
    const LoopSettings loop = loop_for(settings.fit, start.is_free());
    FitState state = start.state;
    if (state.places.rows() > 0)
        std::printf("%s: started at %.3f mm\n", one.name.c_str(),
                    face_error_mm(model, one, state.places));
    for (int round = 0; round < loop.rounds; ++round) {
        // One round of the whole way, as a fit of its own.
        const double f = loop.rounds > 1 ? static_cast<double>(round) / (loop.rounds - 1) : 1;
        LoopSettings single = loop;
        single.rounds = 1;
        single.sigma_end_mm =
            loop.sigma_start_mm * std::pow(loop.sigma_end_mm / loop.sigma_start_mm, f);
        single.sparse_share = f < loop.sparse_share ? 2 : 0;
        if (f < 1) single.last_tolerance = 1;
        const Points before = state.places;
        const FitTrace trace = run_fit(problem, prior.freedom, single, state, context);
        const double moved = before.rows() == state.places.rows()
                                 ? (state.places - before).rowwise().norm().mean()
                                 : 0;
        std::printf("%s round %2d: sigma %.3f mm, energy %.4f mm2, moved %.4f mm, face %.4f mm\n",
                    one.name.c_str(), round, trace.sigma_mm, trace.energy.back(), moved,
                    face_error_mm(model, one, state.places));
    }
    std::fflush(stdout);
}

struct Outcome {
    std::vector<Errors> errors;
    std::vector<FitQuality> quality;
    double seconds[StageClock::kStages] = {}, all_seconds = 0;
};

Outcome fit_all(const DeformationModel& model, const std::vector<Case>& cases, bool free,
                const RegistrationSettings& settings) {
    Outcome outcome;
    for (const Case& one : cases) {
        Context context;
        StageClock clock;
        clock.listen_to(context);
        const RegistrationResult result =
            register_scan(model, one.scan, landmarks_of(one, free), settings, context);
        outcome.all_seconds += clock.finish();
        for (int s = 0; s < StageClock::kStages; ++s) outcome.seconds[s] += clock.seconds[s];
        outcome.errors.push_back(errors_of(model, {}, one, result));
        outcome.quality.push_back(result.verdict.quality);
    }
    return outcome;
}

void print(const std::string& name, const Outcome& now, const Outcome& base) {
    const double n = static_cast<double>(now.errors.size());
    double face = 0, face95 = 0, all = 0, before = 0, before95 = 0, all_before = 0;
    int flipped = 0, calls = 0;
    for (std::size_t k = 0; k < now.errors.size(); ++k) {
        face += now.errors[k].face_mm / n, before += base.errors[k].face_mm / n;
        face95 += now.errors[k].face95_mm / n, before95 += base.errors[k].face95_mm / n;
        all += now.errors[k].all_mm / n, all_before += base.errors[k].all_mm / n;
        flipped += now.errors[k].flipped - base.errors[k].flipped;
        calls += now.quality[k] != base.quality[k];
    }
    std::printf("| %s | %.4f (%+.2f %%) | %.3f (%+.2f %%) | %.3f (%+.2f %%) | %+d | %d |",
                name.c_str(), face, 100 * (face / before - 1), face95,
                100 * (face95 / before95 - 1), all, 100 * (all / all_before - 1), flipped, calls);
    for (const double seconds : now.seconds) std::printf(" %.3f |", seconds / n);
    std::printf(" %.3f (%.3f) |", now.all_seconds / n, now.all_seconds / base.all_seconds);
    for (std::size_t k = 0; k < now.errors.size(); ++k)
        std::printf(" %+.3f", now.errors[k].face_mm - base.errors[k].face_mm);
    std::printf(" |\n");
    std::fflush(stdout);
}

void run(const DeformationModel& model, const std::vector<Case>& cases, bool free, bool by_round,
         const std::vector<std::string>& trials, const Context& context) {
    if (by_round) {
        for (const Case& one : cases) print_by_round(model, one, free, {}, context);
        return;
    }
    std::printf(
        "| numbers | face | p95 | all vertices | flipped | calls changed | scan, s | start | fit "
        "| gap | rest | all | face, each scan |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n");
    const Outcome base = fit_all(model, cases, free, {});
    print("defaults", base, base);
    for (const std::string& words : trials)
        print(words, fit_all(model, cases, free, changed(words)), base);
}

}  // namespace

int main(int argc, char** argv) {
    bool free = false, by_round = false;
    std::vector<std::string> trials, folders;
    for (int k = 2; k < argc; ++k) {
        if (std::strcmp(argv[k], "--free") == 0)
            free = true;
        else if (std::strcmp(argv[k], "--by-round") == 0)
            by_round = true;
        else if (std::strcmp(argv[k], "--try") == 0 && k + 1 < argc)
            trials.emplace_back(argv[++k]);
        else
            folders.push_back(argv[k]);
    }
    if (folders.empty()) {
        std::fprintf(stderr,
                     "usage: registration_rounds MODEL.safetensors [--free] [--by-round] [--try "
                     "\"NAME=VALUE ...\"] SCAN_FOLDER ...\n");
        return 2;
    }
    try {
        Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        std::vector<Case> cases;
        for (const std::string& folder : folders) cases.push_back(read_case(folder, context));
        run(*model, cases, free, by_round, trials, context);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "registration_rounds: %s\n", error.what());
        return 1;
    }
    return 0;
}
