#include "registration/jaw_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/scalar_math.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

// 0 to 1, and what the colours add.
double agreement(const FitProblem& problem, const OpeningSettings& settings,
                 const CorrespondenceSettings& match, const FitState& state,
                 const Context& context) {
    const Points& rest = problem.model.template_mesh.vertices;
    std::vector<SurfaceHit> hits;
    problem.scan.tree().closest(state.places, settings.reach * settings.scale_mm, hits, context);
    const Points normals = vertex_normals(state.places, problem.model.template_mesh.triangles);
    Index tip;
    rest.col(2).maxCoeff(&tip);
    double sum = 0;
    Index counted = 0;
    for (Index i = 0; i < rest.rows(); ++i) {
        const std::size_t v = static_cast<std::size_t>(i);
        if (problem.inner[v] || (rest.row(i) - rest.row(tip)).norm() > settings.radius_mm) continue;
        ++counted;
        if (!hits[v].valid() || problem.scan.surface().at_border(hits[v])) continue;
        const double cosine = normals.row(i).dot(problem.scan.normal_at(hits[v]).transpose());
        if (cosine > 0)
            sum += std::pow(cosine, 4) * std::exp(-0.5 * hits[v].squared_distance /
                                                  (settings.scale_mm * settings.scale_mm));
    }
    if (counted == 0) return 0;
    const std::vector<ColorAgreement> features =
        problem.colors.agreements(problem.scan, state.places, normals, match, context);
    double colors = 0;
    for (const ColorAgreement& feature : features)
        colors += feature.correlation / static_cast<double>(features.size());
    return sum / static_cast<double>(counted) + settings.color_share * colors;
}

// One over the prior's variance of each mode and axis; models without a preference have ones.
Eigen::MatrixXf precision_of_modes(const DeformationModel& model, Index modes,
                                   double least_variance) {
    const Matrix& variance = model.prior_variance;
    if (variance.rows() < modes || variance.cols() != 3) return Eigen::MatrixXf::Ones(modes, 3);
    return variance.topRows(modes).cwiseMax(least_variance).cwiseInverse().cast<float>();
}

// A jaw as the prior's mean, and what the scan makes of it.
struct JawTrial {
    FitState state;
    double opening_rad = 0;
    double score = 0;  // log of the posterior's density but for a constant: more is better
};

// Tries jaws: each opening is what the prior expects, and the scan says how far it is from that.
class JawSearch {
  public:
    JawSearch(const FitProblem& problem, const PriorState& prior, const LoopSettings& loop,
              const OpeningSettings& settings, const FitState& start, const Context& context,
              const Context& quiet)
        : problem_(problem),
          prior_(prior),
          loop_(loop),
          settings_(settings),
          start_(start),
          context_(context),
          quiet_(quiet),
          modes_(std::min<Index>(start.coefficients.kernel.rows(), settings.scalar_modes)),
          precision_(precision_of_modes(problem.model, modes_, loop.solver.least_variance)),
          shut_(jaw_at(0)) {}

    // From the jaw itself, or from `found`, whose opening may be another.
    JawTrial attempt(double opening_rad, const FitState* found = nullptr) const {
        JawTrial trial;
        trial.opening_rad = opening_rad;
        trial.state = found != nullptr ? *found : at_rest();
        trial.state.coefficients.kernel.conservativeResizeLike(Eigen::MatrixXf::Zero(modes_, 3));
        trial.state.kernel_amplitude = start_.kernel_amplitude;
        trial.state.kernel_mean = Eigen::MatrixXf();
        if (opening_rad > 0) {
            trial.state.kernel_mean = jaw_at(opening_rad) - shut_;
            if (found == nullptr) trial.state.coefficients.kernel = trial.state.kernel_mean;
        }
        run_fit(problem_, prior_.freedom, loop_, trial.state, quiet_);
        const double agrees = agreement(problem_, settings_, loop_.match, trial.state, context_);
        trial.score = settings_.hits * agrees - 0.5 * off_mean(trial);
        context_.log(LogLevel::debug, "jaw opened by %.1f degrees: agreement %.4f, score %.1f",
                     opening_rad / kRadiansPerDegree, agrees, trial.score);
        return trial;
    }

    // The opening at which the trial's deformation is likeliest, by one step of Gauss-Newton.
    double likeliest_opening(const JawTrial& trial) const {
        const double step_rad = settings_.slope_deg * kRadiansPerDegree;
        const Eigen::MatrixXf here = jaw_at(trial.opening_rad);
        const Eigen::MatrixXf slope = jaw_at(trial.opening_rad + step_rad) - here;
        const Eigen::MatrixXf off = trial.state.coefficients.kernel - (here - shut_);
        const double length2 = product(slope, slope);
        const double move = length2 > 0 ? product(off, slope) / length2 : 0;
        return std::clamp(trial.opening_rad + settings_.overshoot * move * step_rad, 0.0,
                          settings_.most_deg * kRadiansPerDegree);
    }

  private:
    FitState at_rest() const {
        FitState state;
        state.motion = start_.motion;
        state.kernel_amplitude = start_.kernel_amplitude;
        state.coefficients.kernel.setZero(modes_, 3);
        return state;
    }

    Eigen::MatrixXf jaw_at(double opening_rad) const {
        FitState state = at_rest();
        state.kernel_amplitude *= settings_.amplitude;
        fit_pins(problem_.model, open_jaw(problem_.model, state, opening_rad, settings_.jaw),
                 prior_.freedom, settings_.pins, state, quiet_);
        return state.coefficients.kernel;
    }

    // Over the prior's variances.
    double product(const Eigen::MatrixXf& a, const Eigen::MatrixXf& b) const {
        return a.cwiseProduct(b).cwiseProduct(precision_).cast<double>().sum();
    }

    double off_mean(const JawTrial& trial) const {
        const Eigen::MatrixXf off = trial.state.kernel_off();
        return product(off, off) / (trial.state.kernel_amplitude * trial.state.kernel_amplitude);
    }

    const FitProblem& problem_;
    const PriorState& prior_;
    const LoopSettings& loop_;
    const OpeningSettings& settings_;
    const FitState& start_;
    const Context& context_;
    const Context& quiet_;
    const Index modes_;
    const Eigen::MatrixXf precision_;  // modes x 3
    const Eigen::MatrixXf shut_;
};

}  // namespace

void search_jaw(const FitProblem& problem, const PriorState& prior, const LoopSettings& loop,
                const OpeningSettings& settings, const FitState& start, FitState& rough,
                const Context& context) {
    if (open_jaw(problem.model, start, 0, settings.jaw).empty()) return;
    Context quiet = context;  // fits report a stage that is still to come
    quiet.progress_function = nullptr;
    const JawSearch jaws(problem, prior, loop, settings, start, context, quiet);
    JawTrial best = jaws.attempt(0, &rough);
    double done = 0;
    for (const double opening_deg : settings.openings_deg) {
        JawTrial trial = jaws.attempt(opening_deg * kRadiansPerDegree);
        context.progress(Stage::alignment, 0.94 + 0.05 * ++done / settings.openings_deg.size());
        if (trial.score > best.score) best = std::move(trial);
    }
    for (int step = 0; step < settings.steps; ++step) {
        const double opening_rad = jaws.likeliest_opening(best);
        if (std::abs(opening_rad - best.opening_rad) < settings.settled_deg * kRadiansPerDegree)
            break;
        best = jaws.attempt(opening_rad, &best.state);
    }
    rough = std::move(best.state);
    if (best.opening_rad < settings.least_deg * kRadiansPerDegree)
        rough.kernel_mean = Eigen::MatrixXf();
}

}  // namespace mien
