#include "registration/skin_match.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

#include "base/parallel.hpp"

namespace mien {
namespace {

constexpr float kNoScore = -2;  // below every correlation

// What is summed over a window: the product, and the energies of either picture where the other
// one is seen.
struct Sums {
    std::vector<float> product, first, second, seen;

    explicit Sums(std::size_t width)
        : product(width, 0), first(width, 0), second(width, 0), seen(width, 0) {}
};

class Correlator {
  public:
    Correlator(const SkinImage& first, const SkinImage& second,
               const std::vector<std::uint32_t>& places, const SkinMatchSettings& settings)
        : first_(first),
          second_(second),
          places_(places),
          radius_(std::max<Index>(
              1, static_cast<Index>(std::lround(settings.window_mm / first.pixel_mm / 2)))),
          least_seen_(settings.least_seen *
                      static_cast<double>((2 * radius_ + 1) * (2 * radius_ + 1))) {}

    Index radius() const { return radius_; }

    /// r of every place at one move, into row `out` of as many floats.
    void correlate(Index across, Index up, float* out) const {
        Sums sums(static_cast<std::size_t>(first_.width));
        Index row = 0;  // the sums are over rows row - radius to row + radius
        for (Index y = 0; y < std::min(radius_, first_.height); ++y) add(y, across, up, 1, sums);
        if (radius_ < first_.height) add(radius_, across, up, 1, sums);
        for (std::size_t k = 0; k < places_.size(); ++k) {
            const Index y = static_cast<Index>(places_[k]) / first_.width,
                        x = static_cast<Index>(places_[k]) % first_.width;
            for (; row < y; ++row) {
                if (row + radius_ + 1 < first_.height) add(row + radius_ + 1, across, up, 1, sums);
                if (row >= radius_) add(row - radius_, across, up, -1, sums);
            }
            out[k] = window(x, sums);
        }
    }

  private:
    // Adds or takes a row of the first picture and what lies over it.
    void add(Index y, Index across, Index up, float sign, Sums& sums) const {
        const Index over = y + up;
        if (over < 0 || over >= second_.height) return;
        const Index x0 = std::max<Index>(0, -across),
                    x1 = std::min(first_.width, second_.width - across);
        const std::size_t a = static_cast<std::size_t>(y * first_.width),
                          b = static_cast<std::size_t>(over * second_.width + across);
        const float* mask_a = first_.mask.data() + a;
        const float* mask_b = second_.mask.data() + static_cast<std::ptrdiff_t>(b);
        for (Index x = x0; x < x1; ++x)
            sums.seen[static_cast<std::size_t>(x)] += sign * mask_a[x] * mask_b[x];
        for (std::size_t c = 0; c < SkinImage::kChannels; ++c) {
            const float* s = first_.channel[c].data() + a;
            const float* t = second_.channel[c].data() + static_cast<std::ptrdiff_t>(b);
            for (Index x = x0; x < x1; ++x) {
                const std::size_t at = static_cast<std::size_t>(x);
                sums.product[at] += sign * s[x] * t[x];
                sums.first[at] += sign * s[x] * s[x] * mask_b[x];
                sums.second[at] += sign * t[x] * t[x] * mask_a[x];
            }
        }
    }

    float window(Index x, const Sums& sums) const {
        float product = 0, first = 0, second = 0, seen = 0;
        const Index x1 = std::min(first_.width - 1, x + radius_);
        for (Index i = std::max<Index>(0, x - radius_); i <= x1; ++i) {
            const std::size_t at = static_cast<std::size_t>(i);
            product += sums.product[at];
            first += sums.first[at];
            second += sums.second[at];
            seen += sums.seen[at];
        }
        if (!(static_cast<double>(seen) >= least_seen_) || !(first > 0) || !(second > 0))
            return kNoScore;
        return std::clamp(product / std::sqrt(first * second), -1.f, 1.f);
    }

    const SkinImage& first_;
    const SkinImage& second_;
    const std::vector<std::uint32_t>& places_;
    Index radius_;
    double least_seen_;
};

// r over the moves of one place.
class Peak {
  public:
    Peak(const float* score, int reach) : score_(score), reach_(reach), side_(2 * reach + 1) {}

    double at(int across, int up) const {
        return static_cast<double>(score_[(up + reach_) * side_ + across + reach_]);
    }

    SkinMatch find(const SkinMatchSettings& settings, double pixel_mm, double num_pixels) const {
        SkinMatch match;
        int best_x = 0, best_y = 0;
        double best = -2;
        for (int y = -reach_; y <= reach_; ++y)
            for (int x = -reach_; x <= reach_; ++x)
                if (at(x, y) > best) {
                    best = at(x, y);
                    best_x = x;
                    best_y = y;
                }
        match.at_rest = std::max(at(0, 0), -1.0);
        match.agreement = std::max(best, -1.0);
        if (!(best > 0) || std::max(std::abs(best_x), std::abs(best_y)) == reach_) return match;
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (at(best_x + x, best_y + y) < -1) return match;
        // The parabola through the nine.
        const auto r = [&](int x, int y) { return at(best_x + x, best_y + y); };
        Eigen::Vector2d slope((r(1, 0) - r(-1, 0)) / 2, (r(0, 1) - r(0, -1)) / 2);
        Eigen::Matrix2d bend;
        bend(0, 0) = r(1, 0) - 2 * best + r(-1, 0);
        bend(1, 1) = r(0, 1) - 2 * best + r(0, -1);
        bend(0, 1) = bend(1, 0) = (r(1, 1) - r(-1, 1) - r(1, -1) + r(-1, -1)) / 4;
        const double determinant = bend.determinant();
        if (!(determinant > 0) || !(bend(0, 0) < 0)) return match;
        Eigen::Vector2d between;
        between << -(bend(1, 1) * slope[0] - bend(0, 1) * slope[1]) / determinant,
            -(bend(0, 0) * slope[1] - bend(0, 1) * slope[0]) / determinant;
        between = between.cwiseMax(-1.0).cwiseMin(1.0);
        match.found = true;
        match.move_mm = pixel_mm * (Eigen::Vector2d(best_x, best_y) + between);
        match.lead = best - second_best(best_x, best_y, settings.apart_mm / pixel_mm);
        const double noise = std::max(1 - best * best, 1e-3);
        match.precision =
            -(num_pixels / settings.pixels_each) * best / noise / (pixel_mm * pixel_mm) * bend;
        return match;
    }

  private:
    double second_best(int best_x, int best_y, double apart) const {
        double second = 0;
        for (int y = -reach_; y <= reach_; ++y)
            for (int x = -reach_; x <= reach_; ++x)
                if (std::hypot(x - best_x, y - best_y) >= apart)
                    second = std::max(second, at(x, y));
        return second;
    }

    const float* score_;
    int reach_, side_;
};

}  // namespace

std::vector<SkinMatch> match_skin(const SkinImage& first, const SkinImage& second,
                                  const std::vector<std::uint32_t>& places,
                                  const SkinMatchSettings& settings, const Context& context) {
    std::vector<std::uint32_t> sorted = places;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    const std::size_t side = 2 * static_cast<std::size_t>(settings.reach) + 1, moves = side * side,
                      count = sorted.size();
    context.require_memory(2 * moves * count * sizeof(float), "moves of the skin");
    std::vector<float> by_move(moves * count, kNoScore), by_place(moves * count);
    const Correlator correlator(first, second, sorted, settings);
    parallel_for(context, moves, 1, [&](std::size_t move, std::size_t) {
        correlator.correlate(static_cast<Index>(move % side) - settings.reach,
                             static_cast<Index>(move / side) - settings.reach,
                             by_move.data() + move * count);
    });
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t move = 0; move < moves; ++move)
            by_place[k * moves + move] = by_move[move * count + k];
    const double window = static_cast<double>(2 * correlator.radius() + 1);
    std::vector<SkinMatch> found(count);
    for (std::size_t k = 0; k < count; ++k)
        found[k] = Peak(by_place.data() + k * moves, settings.reach)
                       .find(settings, first.pixel_mm, window * window);
    std::vector<SkinMatch> matches(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        matches[i] = found[static_cast<std::size_t>(
            std::lower_bound(sorted.begin(), sorted.end(), places[i]) - sorted.begin())];
    return matches;
}

}  // namespace mien
