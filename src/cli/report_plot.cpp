// The report's plots: one zone over the visits.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "report_page.hpp"

namespace mien::cli {
namespace {

constexpr double kLeft = 48, kRight = 300, kTop = 14, kBottom = 168, kInside = 16;
constexpr double kDateWidth = 56;  // of a printed date, in the plot's units
constexpr double kBand = 9;        // half width of the grey block at a visit

std::string line(double x0, double y0, double x1, double y1, const char* style) {
    char text[200];
    std::snprintf(text, sizeof text, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" %s/>",
                  x0, y0, x1, y1, style);
    return text;
}

/// Where the visits stand, and the millilitres.
class Axes {
  public:
    Axes(const ReportPage& page, std::size_t zone) {
        std::vector<double> time;
        for (std::size_t k = 0; k < page.visits.size(); ++k)
            time.push_back(has_dates(page) ? static_cast<double>(*day_number(page.visits[k].date))
                                           : static_cast<double>(k));
        const double first = time.front(), span = std::max(time.back() - first, 1.0);
        for (const double t : time)
            x.push_back(kLeft + kInside + (kRight - kLeft - 2 * kInside) * (t - first) / span);
        for (const ReportVisit& visit : page.visits)
            if (zone < visit.volumes.size()) include(visit.volumes[zone]);
        const double pad = std::max(0.08 * (high - low), 0.05);
        low -= pad;
        high += pad;
    }
    double y(double ml) const { return kBottom - (kBottom - kTop) * (ml - low) / (high - low); }
    std::vector<double> x;
    double low = 0, high = 0;

  private:
    void include(const ReportVolume& v) {
        for (const double value : {v.signed_ml, v.low95_ml, v.high95_ml, v.limit_ml, -v.limit_ml})
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
    }
};

std::string limits(const ReportPage& page, const Axes& axes, std::size_t zone) {
    std::string svg;
    char text[200];
    for (std::size_t k = 1; k < page.visits.size(); ++k) {
        if (zone >= page.visits[k].volumes.size()) continue;
        const double limit = page.visits[k].volumes[zone].limit_ml;
        if (!std::isfinite(limit)) continue;
        std::snprintf(
            text, sizeof text,
            "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.0f\" height=\"%.1f\" fill=\"#e3e3e3\"/>",
            axes.x[k] - kBand, axes.y(limit), 2 * kBand, axes.y(-limit) - axes.y(limit));
        svg += text;
    }
    return svg;
}

std::string ticks(const ReportPage& page, const Axes& axes) {
    std::string svg;
    char text[200];
    for (const double tick : round_ticks(axes.low, axes.high, 5)) {
        svg += line(kLeft, axes.y(tick), kRight, axes.y(tick),
                    tick == 0 ? "stroke=\"#888\"" : "stroke=\"#e4e4e4\"");
        std::snprintf(text, sizeof text,
                      "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">%s</text>", kLeft - 5,
                      axes.y(tick) + 4, page.words.number(short_number(tick)).c_str());
        svg += text;
    }
    return svg;
}

/// Below the axis: the dates or names, where there is room; the first and the last always.
std::string names(const ReportPage& page, const Axes& axes) {
    std::string svg;
    char at[120];
    const std::size_t last = page.visits.size() - 1;
    double taken = -1e9;
    for (std::size_t k = 0; k <= last; ++k) {
        svg += line(axes.x[k], kBottom, axes.x[k], kBottom + 4, "stroke=\"#888\"");
        const bool room = axes.x[k] - taken >= kDateWidth &&
                          (k == last || axes.x[last] - axes.x[k] >= kDateWidth);
        if (k != 0 && k != last && !room) continue;
        taken = axes.x[k];
        const char* anchor = k == 0 ? "start" : k == last ? "end" : "middle";
        const double x = k == 0 ? axes.x[k] - kInside : k == last ? axes.x[k] + kInside : axes.x[k];
        std::snprintf(at, sizeof at, "<text x=\"%.1f\" y=\"186\" text-anchor=\"%s\">", x, anchor);
        const std::string& date = page.visits[k].date;
        svg +=
            at + html_text(has_dates(page) ? date : shortened(page.visits[k].name, 10)) + "</text>";
    }
    return svg;
}

std::string dots(const ReportPage& page, const Axes& axes, std::size_t zone) {
    std::string path, svg;
    char text[300];
    const char* const bar = "stroke=\"#2166ac\" stroke-width=\"1.5\"";
    for (std::size_t k = 0; k < page.visits.size(); ++k) {
        const bool first = k == 0;
        if (!first && zone >= page.visits[k].volumes.size()) continue;
        const ReportVolume zero;
        const ReportVolume& v = first ? zero : page.visits[k].volumes[zone];
        if (!std::isfinite(v.signed_ml)) continue;  // too little was seen
        if (!first && std::isfinite(v.low95_ml)) {
            svg += line(axes.x[k], axes.y(v.low95_ml), axes.x[k], axes.y(v.high95_ml), bar);
            for (const double end : {v.low95_ml, v.high95_ml})
                svg += line(axes.x[k] - 4, axes.y(end), axes.x[k] + 4, axes.y(end), bar);
        }
        std::snprintf(text, sizeof text, "%s%.1f %.1f", path.empty() ? "M" : " L", axes.x[k],
                      axes.y(v.signed_ml));
        path += text;
        std::snprintf(text, sizeof text,
                      "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\" stroke=\"#2166ac\"/>",
                      axes.x[k], axes.y(v.signed_ml),
                      first || v.below_limit ? "#fff"
                      : v.detected           ? "#2166ac"
                                             : "#999");
        svg += text;
    }
    return "<path d=\"" + path + "\" fill=\"none\" stroke=\"#2166ac\" stroke-opacity=\".4\"/>" +
           svg;
}

}  // namespace

bool has_dates(const ReportPage& page) {
    return std::all_of(page.visits.begin(), page.visits.end(),
                       [](const ReportVisit& visit) { return !visit.date.empty(); });
}

std::string zone_plot(const ReportPage& page, std::size_t zone) {
    const Axes axes(page, zone);
    const std::string name = html_text(page.zones[zone]);
    return "<figure><b>" + name +
           "</b>, mL<svg viewBox=\"0 0 320 194\" role=\"img\" aria-label=\"" +
           page.words("plot_of", {name}) + "\" font-size=\"11\" fill=\"#444\">" +
           limits(page, axes, zone) + ticks(page, axes) + names(page, axes) +
           dots(page, axes, zone) + "</svg></figure>";
}

}  // namespace mien::cli
