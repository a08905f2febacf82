#include "band_choice.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "plot.hpp"
#include "render.hpp"

namespace mien::cli {
namespace {

/// Of the kernel's mean diagonal: so great a ridge leaves nothing of a person but the mean that
/// every prediction is centred on (what is left of a person's own part is below 1e-11 of it).
constexpr double kRidgeOfTheMean = 1e12;
/// Above every basis: coordinates alone.
constexpr std::uint64_t kCoordinatesAlone = 1000000000;

nlohmann::json values_of(const mien_band_choice& c) {
    return {{"l1_mm", c.l1_mm}, {"dame", c.dame}, {"fmpd", c.fmpd}};
}

/// Points that no other one is better than in both L1 and `metric`, by L1.
Curve front_of(std::vector<mien_band_choice> choices, double mien_band_choice::*metric) {
    std::sort(choices.begin(), choices.end(), [&](const auto& a, const auto& b) {
        return a.l1_mm != b.l1_mm ? a.l1_mm < b.l1_mm : a.*metric < b.*metric;
    });
    Curve front;
    front.label = "Pareto front";
    front.markers = true;
    double least = std::numeric_limits<double>::infinity();
    for (const mien_band_choice& choice : choices) {
        if (choice.*metric >= least) continue;
        least = choice.*metric;
        front.x.push_back(choice.l1_mm);
        front.y.push_back(least);
    }
    return front;
}

Curve dots(const char* label) {
    Curve curve;
    curve.label = label;
    curve.line = false;
    curve.markers = true;
    return curve;
}

Image draw_metric(const BandSearch& search, const std::string& expression,
                  double mien_band_choice::*metric, const char* name) {
    Curve all = dots("every k"), chosen = dots("chosen k"), mean = dots("mean displacement");
    for (const mien_band_choice& choice : search.choices) {
        Curve& curve = choice.chosen != 0 ? chosen : all;
        curve.x.push_back(choice.l1_mm);
        curve.y.push_back(choice.*metric);
    }
    std::vector<Curve> curves{front_of(search.choices, metric)};
    if (!all.x.empty()) curves.push_back(all);
    if (!chosen.x.empty()) curves.push_back(chosen);
    if (search.has_mean) {
        mean.x.push_back(search.mean.l1_mm);
        mean.y.push_back(search.mean.*metric);
        curves.push_back(mean);
    }
    PlotOptions options;
    options.title = "band limit k for " + expression;
    options.x_label = "L1, mm";
    options.y_label = name;
    return draw_plot(curves, options);
}

}  // namespace

BandSearch search_bands(const Session& session, const BlendshapeModel& model,
                        const SpectralBasis& basis, const std::string& data,
                        const std::string& validate, const std::string& expression,
                        const std::vector<std::uint64_t>& candidates,
                        const BlendshapeOptions& options) {
    BandSearch search;
    search.choices = model.search(session, basis, validate, expression, candidates, options);
    if (data.empty()) return search;
    BlendshapeOptions of_mean = options;
    of_mean.ridge = kRidgeOfTheMean;
    search.mean = BlendshapeModel::train(session, data, expression, of_mean)
                      .search(session, basis, validate, expression, {kCoordinatesAlone}, of_mean)
                      .front();
    search.has_mean = true;
    return search;
}

void print_bands(const BandSearch& search) {
    const auto line = [](const char* name, const mien_band_choice& c, const char* note) {
        std::printf("%-18s L1 %.4f mm  DAME %.5f  FMPD %.5f%s\n", name, c.l1_mm, c.dame, c.fmpd,
                    note);
    };
    for (const mien_band_choice& choice : search.choices)
        line(("k " + std::to_string(choice.k)).c_str(), choice,
             choice.chosen != 0 ? "  chosen" : (choice.on_front != 0 ? "  front" : ""));
    if (search.has_mean) line("mean displacement", search.mean, "");
}

nlohmann::json bands_json(const BandSearch& search) {
    nlohmann::json list = nlohmann::json::array();
    for (const mien_band_choice& choice : search.choices) {
        nlohmann::json row = values_of(choice);
        row["k"] = choice.k;
        row["on_front"] = choice.on_front != 0;
        row["chosen"] = choice.chosen != 0;
        list.push_back(std::move(row));
    }
    nlohmann::json report{{"search", std::move(list)}, {"mean_displacement", nullptr}};
    if (search.has_mean) report["mean_displacement"] = values_of(search.mean);
    return report;
}

void draw_bands(const std::string& path, const BandSearch& search, const std::string& expression) {
    write_png(path, stack_images({draw_metric(search, expression, &mien_band_choice::fmpd, "FMPD"),
                                  draw_metric(search, expression, &mien_band_choice::dame, "DAME")},
                                 true));
}

}  // namespace mien::cli
