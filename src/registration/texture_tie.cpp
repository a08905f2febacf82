#include "registration/texture_tie.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <Eigen/Eigenvalues>
#include <limits>

#include "base/error.hpp"
#include "base/scalar_math.hpp"
#include "geometry/normals.hpp"
#include "mesh/shortest_paths.hpp"
#include "mesh/topology.hpp"

namespace mien {
namespace {

using Projection = Eigen::Matrix<double, 2, 3>;

// Both pictures of one view, at the view's resolution and below.
struct ViewPair {
    std::vector<SkinImage> first, second;  // by halvings; logarithms of the colours
};

// What a vertex was last measured at.
struct Measurement {
    Projection to_view = Projection::Zero();
    Eigen::Matrix2d trust = Eigen::Matrix2d::Zero();  // eigenvalues 0 to 1
    Eigen::Vector2d target = Eigen::Vector2d::Zero();
    bool counts = false;
};

class Tie {
  public:
    Tie(const DeformationModel& model, const FittedVisit& reference, const FittedVisit& visit,
        const TextureTieSettings& settings, const Context& context)
        : mesh_(model.template_mesh),
          reference_(reference),
          visit_(visit),
          settings_(settings),
          context_(context),
          rings_(build_rings(model.num_vertices(), mesh_.triangles)),
          open_(open_skin(model)),
          seen_(seen_twice()),
          field_(mesh_, rings_, open_),
          normals_(vertex_normals(mesh_.vertices, mesh_.triangles)),
          slide_(Points::Zero(model.num_vertices(), 3)) {}

    TextureTie run();

  private:
    std::vector<std::uint8_t> open_skin(const DeformationModel& model) const;
    std::vector<std::uint8_t> seen_twice() const;
    void find_measurable();
    void sample();
    std::vector<SkinMatch> compare(std::size_t view, const TieRound& round) const;
    void measure(const TieRound& round, std::vector<Measurement>& found);
    void smooth(const TieRound& round, const std::vector<Measurement>& found);
    void judge(TextureTie& tie);
    void place(TextureTie& tie);
    std::string reason_against(const TextureTie& tie) const;
    Points carried() const;
    void flow_of(const SkinView& view, int halvings, SkinImage::Plane& across,
                 SkinImage::Plane& up) const;

    const TriMesh& mesh_;
    const FittedVisit& reference_;
    const FittedVisit& visit_;
    const TextureTieSettings& settings_;
    const Context& context_;
    const VertexRings rings_;
    const std::vector<std::uint8_t> open_, seen_;
    const SlideField field_;
    const Points normals_;
    std::vector<std::uint8_t> measurable_;
    std::vector<SkinView> views_;
    std::vector<ViewPair> pairs_;
    Points slide_;  // over the template at rest
};

std::vector<std::uint8_t> Tie::open_skin(const DeformationModel& model) const {
    std::vector<std::uint8_t> walls = model.walls;
    if (walls.empty()) walls = find_inner_vertices(mesh_, InnerSettings(), context_);
    for (std::uint8_t& wall : walls) wall = !wall;
    return walls;
}

std::vector<std::uint8_t> Tie::seen_twice() const {
    std::vector<std::uint8_t> seen = open_;
    for (const Vector* weight : {&reference_.weight, &visit_.weight})
        for (Index v = 0; v < weight->size(); ++v)
            if ((*weight)[v] < settings_.sample.least_weight) seen[static_cast<std::size_t>(v)] = 0;
    return seen;
}

// Not about the rims of lids, lips and nostrils: there either side of a slit may be seen.
void Tie::find_measurable() {
    const std::vector<std::uint8_t> border =
        border_vertices(mesh_.triangles, mesh_.vertices.rows(), context_);
    std::vector<std::uint32_t> rims;
    for (std::size_t v = 0; v < open_.size(); ++v)
        if (!open_[v] || border[v]) rims.push_back(static_cast<std::uint32_t>(v));
    measurable_ = seen_;
    std::vector<double> distance(open_.size(), std::numeric_limits<double>::infinity());
    walk_paths(build_path_graph(mesh_.vertices, rings_), rims, settings_.near_border_mm, distance,
               [&](const ReachedVertex& at) { measurable_[at.vertex] = 0; });
}

void Tie::sample() {
    views_ = look_at_skin(mesh_, seen_, settings_.views, context_);
    int halvings = 0;
    for (const TieRound& round : settings_.rounds) halvings = std::max(halvings, round.halvings);
    double done = 0;
    for (SkinView& view : views_) {
        context_.progress(Stage::refining, 0.5 * done++ / static_cast<double>(views_.size()));
        view.vertices.erase(std::remove_if(view.vertices.begin(), view.vertices.end(),
                                           [&](std::uint32_t v) { return !measurable_[v]; }),
                            view.vertices.end());
        ViewPair pair;
        const auto add = [&](const FittedVisit& visit, std::vector<SkinImage>& images) {
            context_.require_memory(static_cast<std::size_t>(view.num_pixels()) * 64,
                                    "pictures of the skin");
            images.push_back(sample_skin(view, mesh_.triangles,
                                         {visit.places, visit.scan.surface, visit.weight},
                                         settings_.sample, context_));
            for (int k = 0; k < halvings; ++k) images.push_back(halve(images.back()));
        };
        add(reference_, pair.first);
        add(visit_, pair.second);
        pairs_.push_back(std::move(pair));
    }
}

// The slide as a move between pixels of the view.
void Tie::flow_of(const SkinView& view, int halvings, SkinImage::Plane& across,
                  SkinImage::Plane& up) const {
    const Index step = Index(1) << halvings, width = view.width / step, height = view.height / step;
    const double pixel = view.pixel_mm * static_cast<double>(step);
    across.assign(static_cast<std::size_t>(width * height), 0);
    up = across;
    for (Index y = 0; y < height; ++y)
        for (Index x = 0; x < width; ++x) {
            const std::size_t from =
                static_cast<std::size_t>((y * step + step / 2) * view.width + x * step + step / 2);
            if (view.triangle[from] == SkinView::kNone) continue;
            const Vector3 slide = view.at(from, mesh_.triangles, slide_);
            const std::size_t to = static_cast<std::size_t>(y * width + x);
            across[to] = static_cast<float>(view.axes.row(0).dot(slide) / pixel);
            up[to] = static_cast<float>(view.axes.row(1).dot(slide) / pixel);
        }
}

// Pixel numbers of the view's vertices in a picture of it.
std::vector<std::uint32_t> pixels_of(const SkinView& view, const Points& places,
                                     const SkinImage& image) {
    std::vector<std::uint32_t> pixels;
    pixels.reserve(view.vertices.size());
    const double ratio = view.pixel_mm / image.pixel_mm;
    for (const std::uint32_t v : view.vertices) {
        const Eigen::Vector2d at = (view.pixel_of(places.row(v)).array() + 0.5) * ratio - 0.5;
        const auto within = [](double value, Index size) {
            return static_cast<Index>(
                std::clamp<double>(std::lround(value), 0, static_cast<double>(size - 1)));
        };
        pixels.push_back(static_cast<std::uint32_t>(within(at[1], image.height) * image.width +
                                                    within(at[0], image.width)));
    }
    return pixels;
}

// Directions that are surer than sd count in full, others less.
Eigen::Matrix2d trust_of(const Eigen::Matrix2d& precision, double sd_mm) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(precision);
    if (eigen.info() != Eigen::Success) return Eigen::Matrix2d::Zero();
    const Eigen::Array2d value = eigen.eigenvalues().array().max(0.0);
    return eigen.eigenvectors() * (value / (value + 1 / (sd_mm * sd_mm))).matrix().asDiagonal() *
           eigen.eigenvectors().transpose();
}

// Both pictures of a view at every vertex, the second seen through the slide.
std::vector<SkinMatch> Tie::compare(std::size_t view, const TieRound& round) const {
    SkinDetailSettings detail = settings_.detail;
    detail.coarse_mm = round.coarse_mm;
    SkinMatchSettings match = settings_.match;
    match.window_mm = round.window_mm;
    match.reach = round.reach;
    const std::size_t level = static_cast<std::size_t>(round.halvings);
    SkinImage::Plane across, up;
    flow_of(views_[view], round.halvings, across, up);
    const SkinImage first = detail_of(pairs_[view].first[level], detail);
    const SkinImage second = detail_of(moved(pairs_[view].second[level], across, up), detail);
    return match_skin(first, second, pixels_of(views_[view], mesh_.vertices, first), match,
                      context_);
}

void Tie::measure(const TieRound& round, std::vector<Measurement>& found) {
    for (std::size_t k = 0; k < views_.size(); ++k) {
        const SkinView& view = views_[k];
        const std::vector<SkinMatch> matches = compare(k, round);
        for (std::size_t i = 0; i < matches.size(); ++i) {
            const SkinMatch& one = matches[i];
            Measurement& here = found[view.vertices[i]];
            here.counts = one.found && one.agreement > settings_.least_agreement;
            if (!here.counts) continue;
            here.to_view = view.axes.topRows<2>();
            const double agrees = fade((one.agreement - settings_.least_agreement) /
                                       (settings_.full_agreement - settings_.least_agreement));
            const double alone = round.reach > 2 ? fade(one.lead / settings_.full_lead) : 1;
            here.trust = agrees * alone * trust_of(one.precision, settings_.full_sd_mm);
            here.target = here.to_view * slide_.row(view.vertices[i]).transpose() + one.move_mm;
        }
    }
}

void Tie::smooth(const TieRound& round, const std::vector<Measurement>& found) {
    SlideFieldSettings settings = settings_.field;
    settings.smooth_mm = round.smooth_mm;
    std::vector<SlidePull> pulls(found.size());
    for (int pass = 0; pass < settings_.reweighings; ++pass) {
        // From wide to the round's own, so that few far outliers never draw the field.
        const double scale_mm =
            round.robust_mm *
            std::pow(2.0, 1 - static_cast<double>(pass) / std::max(1, settings_.reweighings - 1));
        for (std::size_t v = 0; v < found.size(); ++v) {
            const Measurement& one = found[v];
            const Vector3 normal = normals_.row(static_cast<Index>(v));
            pulls[v].trust = settings_.normal_trust * normal * normal.transpose();
            pulls[v].pull.setZero();
            if (!one.counts) continue;
            double weight = 1;
            if (pass > 0) {
                const double off =
                    (one.to_view * slide_.row(static_cast<Index>(v)).transpose() - one.target)
                        .norm() /
                    scale_mm;
                weight = std::exp(-off * off / 2);
            }
            const Eigen::Matrix2d trust = weight * one.trust;
            pulls[v].trust += one.to_view.transpose() * trust * one.to_view;
            pulls[v].pull += one.to_view.transpose() * (trust * one.target);
        }
        field_.solve(pulls, settings, slide_, context_);
    }
    for (Index v = 0; v < slide_.rows(); ++v) {
        const double length = slide_.row(v).norm();
        if (length > settings_.most_slide_mm) slide_.row(v) *= settings_.most_slide_mm / length;
    }
}

// How far both pictures agree where the field has brought them.
void Tie::judge(TextureTie& tie) {
    const Index n = slide_.rows();
    tie.agreement = tie.share = tie.sd_mm = Vector::Zero(n);
    double open = 0, compared = 0, agreeing = 0;
    for (std::size_t v = 0; v < open_.size(); ++v)
        if (open_[v]) open += field_.area_mm2()[static_cast<Index>(v)];
    for (std::size_t k = 0; k < views_.size(); ++k) {
        const SkinView& view = views_[k];
        const std::vector<SkinMatch> matches = compare(k, settings_.rounds.back());
        for (std::size_t i = 0; i < matches.size(); ++i) {
            const Index v = static_cast<Index>(view.vertices[i]);
            const SkinMatch& one = matches[i];
            if (one.at_rest <= -1) continue;  // not seen in both
            compared += field_.area_mm2()[v];
            tie.agreement[v] = one.at_rest;
            if (one.at_rest > settings_.tied_agreement && one.found &&
                one.move_mm.norm() < settings_.tied_off_mm)
                agreeing += field_.area_mm2()[v];
            else
                continue;
            const double off = one.move_mm.norm() / settings_.tied_off_mm;
            tie.share[v] =
                fade((one.at_rest - settings_.tied_agreement) / settings_.full_tied_agreement) *
                fade(2 - 2 * off);
            const double determinant = one.precision.determinant();
            if (determinant > 0) tie.sd_mm[v] = std::sqrt(one.precision.trace() / determinant / 2);
        }
    }
    tie.compared = open > 0 ? compared / open : 0;
    tie.agreeing = compared > 0 ? agreeing / compared : 0;
}

// Where the visit's fit carries the places that the field leads to.
Points Tie::carried() const {
    Points moves = Points::Zero(slide_.rows(), 3);
    std::vector<std::uint8_t> known(open_.size(), 0);
    for (const SkinView& view : views_)
        for (const std::uint32_t v : view.vertices) {
            const Index row = static_cast<Index>(v);
            const Vector3 slide = slide_.row(row);
            // From the same pixels before and after: what they cut of the surface's curve goes out.
            const auto look = [&](const Vector3& place, Vector3& out) {
                const Eigen::Vector2d at = view.pixel_of(place), low = at.array().floor();
                if (!(low[0] >= 0) || !(low[1] >= 0) ||
                    !(low[0] + 1 < static_cast<double>(view.width)) ||
                    !(low[1] + 1 < static_cast<double>(view.height)))
                    return false;
                out.setZero();
                for (int k = 0; k < 4; ++k) {
                    const double x = at[0] - low[0], y = at[1] - low[1];
                    const double share = (k % 2 == 0 ? 1 - x : x) * (k < 2 ? 1 - y : y);
                    const std::size_t pixel =
                        static_cast<std::size_t>((static_cast<Index>(low[1]) + k / 2) * view.width +
                                                 static_cast<Index>(low[0]) + k % 2);
                    if (view.triangle[pixel] == SkinView::kNone) return false;
                    out += share * view.at(pixel, mesh_.triangles, visit_.places);
                }
                return true;
            };
            Vector3 before, after;
            const Vector3 here = mesh_.vertices.row(row);
            if (!look(here, before) || !look(here + slide, after)) continue;
            moves.row(row) = (after - before).transpose();
            known[v] = 1;
        }
    // Walls, rims and what no view shows go with the skin around them.
    const std::vector<std::uint8_t> all(open_.size(), 1);
    const SlideField around(mesh_, rings_, all);
    std::vector<SlidePull> pulls(open_.size());
    for (std::size_t v = 0; v < pulls.size(); ++v)
        if (known[v]) {
            pulls[v].trust = Matrix3::Identity();
            pulls[v].pull = moves.row(static_cast<Index>(v));
        }
    Points filled = moves;
    SlideFieldSettings settings = settings_.field;
    settings.smooth_mm = settings_.fill_mm;
    around.solve(pulls, settings, filled, context_);
    for (std::size_t v = 0; v < known.size(); ++v)
        if (!known[v]) moves.row(static_cast<Index>(v)) = filled.row(static_cast<Index>(v));
    return moves;
}

void Tie::place(TextureTie& tie) {
    const Points moves = carried();
    Points places = visit_.places + moves;
    // A chord between two pixels lies beside the surface: back onto it, as the fit was.
    ScanView scan(visit_.scan.surface);
    double facing = 0;
    const Points normals = vertex_normals(visit_.places, mesh_.triangles);
    std::vector<SurfaceHit> hits;
    visit_.scan.surface.tree.closest(visit_.places, settings_.sample.reach_mm, hits, context_);
    for (std::size_t v = 0; v < hits.size(); ++v)
        if (hits[v].valid() && open_[v])
            facing += normals.row(static_cast<Index>(v)).dot(scan.normal_at(hits[v]).transpose());
    if (facing < 0) scan.turn_over();
    Vector trust(places.rows());
    for (Index v = 0; v < trust.size(); ++v)
        trust[v] = open_[static_cast<std::size_t>(v)]
                       ? fade(moves.row(v).norm() / settings_.raised_slide_mm)
                       : 0;
    Points raised = places;
    Context quiet = context_;
    quiet.progress_function = nullptr;
    raise_field(scan, mesh_.triangles, rings_, trust, {}, settings_.raise_mm, settings_.gap, raised,
                quiet);
    for (Index v = 0; v < trust.size(); ++v)
        places.row(v) += trust[v] * (raised.row(v) - places.row(v));
    tie.undone = undo_turns(visit_.places, mesh_.triangles, rings_, settings_.gap, places);
    tie.places = places;
}

std::string Tie::reason_against(const TextureTie& tie) const {
    char text[300];
    if (tie.compared < settings_.least_compared) {
        std::snprintf(text, sizeof text,
                      "too little of the skin (a share of %.2f) is seen in colour and near the fit "
                      "at both visits: give scans of the same part of the face",
                      tie.compared);
        return text;
    }
    if (tie.agreeing >= settings_.least_share) return {};
    std::snprintf(
        text, sizeof text,
        "the two pictures agree on a share of only %.2f of the skin: another person, skin "
        "without detail, blurred pictures or very unlike light",
        tie.agreeing);
    return text;
}

TextureTie Tie::run() {
    find_measurable();
    sample();
    std::vector<Measurement> found(open_.size());
    double done = 0;
    for (const TieRound& round : settings_.rounds) {
        context_.progress(Stage::refining, 0.5 + 0.1 * done++);
        measure(round, found);
        smooth(round, found);
    }
    TextureTie tie;
    judge(tie);
    tie.places = visit_.places;
    tie.slide_mm = Vector::Zero(slide_.rows());
    tie.why_not = reason_against(tie);
    tie.tied = tie.why_not.empty();
    if (tie.tied) {
        place(tie);
        tie.slide_mm = (tie.places - visit_.places).rowwise().norm();
        std::vector<double> slides;
        for (Index v = 0; v < slide_.rows(); ++v)
            if (tie.share[v] > 0.5) slides.push_back(tie.slide_mm[v]);
        if (!slides.empty()) {
            std::nth_element(slides.begin(),
                             slides.begin() + static_cast<std::ptrdiff_t>(slides.size() / 2),
                             slides.end());
            tie.median_slide_mm = slides[slides.size() / 2];
        }
    } else
        tie.share = tie.sd_mm = tie.slide_mm;
    context_.progress(Stage::refining, 1);
    return tie;
}

}  // namespace

TextureTie tie_by_texture(const DeformationModel& model, const FittedVisit& reference,
                          const FittedVisit& visit, const TextureTieSettings& settings,
                          const Context& context) {
    return Tie(model, reference, visit, settings, context).run();
}

}  // namespace mien
