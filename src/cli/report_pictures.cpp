#include "report_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace mien::cli {
namespace {

// Below this weight a place of the scan had too little say to show a change there.
constexpr double kSeen = 0.5;
// The colours reach what 95 of 100 known places do, between these, mm.
constexpr double kLeastRange = 0.5, kMostRange = 10;
// So many visits fit with large pictures into a page below 5 MB.
constexpr double kLargeVisits = 5;
constexpr int kLargeSize = 360, kLeastSize = 96;

using Turn = std::array<std::array<double, 3>, 3>;

Position turned(const Turn& turn, const Position& p) {
    Position q{};
    for (std::size_t i = 0; i < 3; ++i)
        q[i] = turn[i][0] * p[0] + turn[i][1] * p[1] + turn[i][2] * p[2];
    return q;
}

void turn_all(const Turn& turn, std::vector<Position>& positions) {
    for (Position& p : positions) p = turned(turn, p);
}

/// Back into the template's upright pose: the transpose of the motion's rotation.
Turn upright(const Registration& fit) {
    const std::array<double, 16> motion = fit.motion();
    Turn turn{};
    for (std::size_t i = 0; i < 3; ++i) {
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k) length = std::hypot(length, motion[4 * k + i]);
        for (std::size_t k = 0; k < 3; ++k)
            turn[i][k] = length > 0 ? motion[4 * k + i] / length : i == k ? 1.0 : 0.0;
    }
    return turn;
}

Position middle_of(const MeshArrays& mesh) {
    Position least = mesh.positions.front(), most = least;
    for (const Position& p : mesh.positions)
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    for (std::size_t k = 0; k < 3; ++k) least[k] = 0.5 * (least[k] + most[k]);
    return least;
}

}  // namespace

std::vector<double> field_or_none(const Study& study, std::int32_t visit, std::int32_t field) {
    try {
        return study.field(visit, field);
    } catch (const mien::Exception& failure) {
        if (failure.status() == MIEN_E_NOT_FOUND) return {};
        throw;
    }
}

std::vector<std::array<std::uint32_t, 2>> zone_rims(
    const std::vector<Triangle>& triangles, const std::vector<std::vector<std::uint32_t>>& zones) {
    std::vector<std::array<std::uint32_t, 2>> rims;
    for (const std::vector<std::uint32_t>& zone : zones) {
        const std::vector<std::uint32_t> inside = [&] {
            std::vector<std::uint32_t> sorted = zone;
            std::sort(sorted.begin(), sorted.end());
            return sorted;
        }();
        const auto is_inside = [&](std::uint32_t v) {
            return std::binary_search(inside.begin(), inside.end(), v);
        };
        std::map<std::array<std::uint32_t, 2>, int> edges;
        for (const Triangle& t : triangles)
            if (is_inside(t[0]) && is_inside(t[1]) && is_inside(t[2]))
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                    ++edges[{std::min(a, b), std::max(a, b)}];
                }
        for (const auto& [edge, count] : edges)
            if (count == 1) rims.push_back(edge);
    }
    return rims;
}

ReportPictures::ReportPictures(const Study& study, const std::vector<const Fitted*>& fits,
                               std::vector<std::array<std::uint32_t, 2>> rims)
    : fits_(fits), rims_(std::move(rims)) {
    const double share = kLargeVisits / static_cast<double>(fits.size());
    if (share < 1)
        size_ = std::max(kLeastSize, static_cast<int>(kLargeSize * std::sqrt(share)));
    else
        size_ = kLargeSize;
    const Turn turn = upright(fits.front()->fit);
    for (std::size_t k = 0; k < fits.size(); ++k) {
        fitted_.push_back(arrays_of(fits[k]->fit.mesh()));
        turn_all(upright(fits[k]->fit), fitted_.back().positions);
        aligned_.push_back(arrays_of(study.neutral(static_cast<std::int32_t>(k), 0)));
        turn_all(turn, aligned_.back().positions);
    }
    find_changes(study);
}

/// What changed since the first visit, mm; zero within its own standard deviation, and not a number
/// where a visit did not see the skin or nothing is known of it.
std::vector<double> ReportPictures::change_of(const Study& study, std::int32_t visit,
                                              const std::vector<double>& first_sd) const {
    const auto number = static_cast<std::size_t>(visit);
    std::vector<double> change = study.distances_mm(0, visit);
    const std::vector<double> sd = field_or_none(study, visit, MIEN_STUDY_FIELD_NORMAL_SD_MM);
    const bool failed = fits_[0]->fit.verdict().quality == MIEN_QUALITY_FAILED ||
                        fits_[number]->fit.verdict().quality == MIEN_QUALITY_FAILED;
    std::vector<std::vector<double>> weights, expressions;
    for (const std::int32_t of : {0, visit}) {
        weights.push_back(field_or_none(study, of, MIEN_STUDY_FIELD_WEIGHT));
        expressions.push_back(field_or_none(study, of, MIEN_STUDY_FIELD_EXPRESSION_SD_MM));
    }
    for (std::size_t v = 0; v < change.size(); ++v) {
        bool known = !failed;
        for (const std::vector<double>& weight : weights)
            known = known && (weight.empty() || weight[v] >= kSeen);
        double variance = 0;
        if (!first_sd.empty() && !sd.empty()) variance += first_sd[v] * first_sd[v] + sd[v] * sd[v];
        // The root of the summed variance of three coordinates; along the normal a third of it.
        for (const std::vector<double>& expression : expressions)
            if (!expression.empty()) variance += expression[v] * expression[v] / 3;
        if (!known || !std::isfinite(variance))
            change[v] = std::nan("");
        else if (std::fabs(change[v]) < std::sqrt(variance))
            change[v] = 0;
    }
    return change;
}

void ReportPictures::find_changes(const Study& study) {
    const std::vector<double> first_sd = field_or_none(study, 0, MIEN_STUDY_FIELD_NORMAL_SD_MM);
    changes_.emplace_back();
    errors_known_ = !first_sd.empty();
    std::vector<double> sizes;
    for (std::int32_t k = 1; k < study.visit_count(); ++k) {
        changes_.push_back(change_of(study, k, first_sd));
        errors_known_ =
            errors_known_ && !field_or_none(study, k, MIEN_STUDY_FIELD_NORMAL_SD_MM).empty();
        for (const double change : changes_.back())
            if (std::isfinite(change) && change != 0) sizes.push_back(std::fabs(change));
    }
    if (sizes.empty()) return;
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.95 * double(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    for (const double range : {kLeastRange, 1.0, 2.0, 3.0, 5.0, kMostRange}) {
        range_mm_ = range;
        if (*at <= range) break;
    }
}

/// With the treated zones' rims, seen by the first visit's camera that was moved to this face.
Image ReportPictures::draw(const MeshArrays& face, std::size_t visit, RenderOptions options) const {
    MeshArrays framing = fitted_.front();
    const Position from = middle_of(framing), to = middle_of(fitted_[visit]);
    const bool is_own = options.framing == nullptr;
    for (Position& p : framing.positions)
        for (std::size_t k = 0; k < 3 && is_own; ++k) p[k] += to[k] - from[k];
    options.framing = &framing;
    options.views = {"front", "left45"};
    options.size = size_;
    options.color_bar = false;
    return render_mesh(face, options);
}

Image ReportPictures::face(std::size_t visit) const {
    RenderOptions options;
    options.lines = rims_;
    return draw(fitted_[visit], visit, options);
}

Image ReportPictures::change(std::size_t visit) const {
    RenderOptions options;
    options.lines = rims_;
    options.framing = &fitted_.front();  // all aligned faces lie in its frame
    options.scalar = changes_[visit];
    options.color_map = ColorMap::diverging;
    options.low = -range_mm_;
    options.high = range_mm_;
    return draw(aligned_[visit], visit, options);
}

Image ReportPictures::scan(const Session& session, std::size_t visit) const {
    const Fitted& fit = *fits_[visit];
    if (fit.scan.empty()) return {};
    MeshArrays scan = arrays_of(Mesh(session, fit.scan));
    const double unit = fit.report.is_object() ? fit.report.value("unit_to_mm", 1.0) : 1.0;
    for (Position& p : scan.positions)
        for (double& x : p) x *= unit;
    turn_all(upright(fit.fit), scan.positions);
    return draw(scan, visit, {});
}

}  // namespace mien::cli
