#include "report_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mien::cli {
namespace {

const char* const kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;margin:0 "
    "auto;max-width:60rem;padding:1rem;color:#222;background:#fff}"
    "h1{font-size:1.5rem}h2{font-size:1.2rem;margin-top:2rem;border-bottom:1px solid #ddd}"
    "img,svg{max-width:100%;height:auto;display:block}"
    "table{border-collapse:collapse;font-size:.9rem;width:100%}td,th{padding:.3rem "
    ".5rem;text-align:right;"
    "border-bottom:1px solid #eee}td:first-child,th:first-child{text-align:left}"
    ".wide{overflow-x:auto}.below{color:#888}.bad{color:#a00}.good{color:#060}"
    ".plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(17rem,1fr));gap:1rem}"
    "figure{margin:0}figcaption{font-size:.85rem;color:#555}";

std::string fixed(double value, int digits) {
    if (!std::isfinite(value)) return "&ndash;";
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string inline_png(const Image& image, const std::string& alt) {
    return "<img alt=\"" + html_text(alt) + "\" src=\"" + png_data_uri(image) + "\">";
}

/// One zone over the visits: dots with 95 % bars before the limit of detection as a grey block.
std::string zone_plot(const ReportPage& page, std::size_t zone) {
    const double left = 48, right = 290, top = 14, bottom = 168;
    double low = 0, high = 0;
    for (const ReportVisit& visit : page.visits)
        if (zone < visit.volumes.size()) {
            const ReportVolume& v = visit.volumes[zone];
            const double limit = std::isfinite(v.limit_ml) ? v.limit_ml : 0;
            low = std::min(
                {low, -limit, v.signed_ml, std::isfinite(v.low95_ml) ? v.low95_ml : v.signed_ml});
            high = std::max(
                {high, limit, v.signed_ml, std::isfinite(v.high95_ml) ? v.high95_ml : v.signed_ml});
        }
    const double pad = std::max(0.08 * (high - low), 0.05);
    low -= pad;
    high += pad;
    const double steps = std::max<double>(1.0, static_cast<double>(page.visits.size()) - 1.0);
    auto x = [&](std::size_t visit) {
        return left + 12 + (right - left - 24) * static_cast<double>(visit) / steps;
    };
    auto y = [&](double ml) { return bottom - (bottom - top) * (ml - low) / (high - low); };
    auto line = [](double x0, double y0, double x1, double y1, const char* style) {
        char text[200];
        std::snprintf(text, sizeof text,
                      "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" %s/>", x0, y0, x1, y1,
                      style);
        return std::string(text);
    };
    char text[300];
    std::string svg = "<svg viewBox=\"0 0 320 200\" role=\"img\" aria-label=\"" +
                      html_text(page.zones[zone]) +
                      " over the visits\" font-size=\"11\" fill=\"#444\">";
    for (std::size_t k = 1; k < page.visits.size(); ++k) {
        if (zone >= page.visits[k].volumes.size()) continue;
        const double limit = page.visits[k].volumes[zone].limit_ml;
        if (!std::isfinite(limit)) continue;
        std::snprintf(text, sizeof text,
                      "<rect x=\"%.1f\" y=\"%.1f\" width=\"24\" height=\"%.1f\" fill=\"#e6e6e6\"/>",
                      x(k) - 12, y(limit), y(-limit) - y(limit));
        svg += text;
    }
    for (double tick : round_ticks(low, high, 5)) {
        svg += line(left, y(tick), right, y(tick),
                    tick == 0 ? "stroke=\"#888\"" : "stroke=\"#e4e4e4\"");
        std::snprintf(text, sizeof text,
                      "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">%s</text>", left - 5,
                      y(tick) + 4, short_number(tick).c_str());
        svg += text;
    }
    std::string path;
    for (std::size_t k = 0; k < page.visits.size(); ++k) {
        const bool first = k == 0;
        if (!first && zone >= page.visits[k].volumes.size()) continue;
        const ReportVolume zero;
        const ReportVolume& v = first ? zero : page.visits[k].volumes[zone];
        if (!first && std::isfinite(v.low95_ml)) {
            svg += line(x(k), y(v.low95_ml), x(k), y(v.high95_ml),
                        "stroke=\"#2166ac\" stroke-width=\"1.5\"");
            for (double end : {v.low95_ml, v.high95_ml})
                svg += line(x(k) - 4, y(end), x(k) + 4, y(end),
                            "stroke=\"#2166ac\" stroke-width=\"1.5\"");
        }
        std::snprintf(text, sizeof text, "%s%.1f %.1f", path.empty() ? "M" : " L", x(k),
                      y(v.signed_ml));
        path += text;
        std::snprintf(text, sizeof text,
                      "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\" stroke=\"#2166ac\"/>",
                      x(k), y(v.signed_ml), v.below_limit || first ? "#fff" : "#2166ac");
        svg += text;
        std::snprintf(text, sizeof text,
                      "<text x=\"%.1f\" y=\"186\" text-anchor=\"middle\">%s</text>", x(k),
                      html_text(page.visits[k].name.substr(0, 10)).c_str());
        svg += text;
    }
    svg +=
        "<path d=\"" + path + "\" fill=\"none\" stroke=\"#2166ac\" stroke-opacity=\".4\"/></svg>";
    return "<figure><b>" + html_text(page.zones[zone]) + "</b>, mL" + svg + "</figure>";
}

std::string volume_table(const ReportPage& page) {
    std::string html = "<div class=\"wide\"><table><tr><th>Zone</th>";
    for (std::size_t k = 1; k < page.visits.size(); ++k)
        html += "<th>" + html_text(page.visits[k].name) + "</th>";
    html += "</tr>";
    for (std::size_t z = 0; z < page.zones.size(); ++z) {
        html += "<tr><td>" + html_text(page.zones[z]) + "</td>";
        for (std::size_t k = 1; k < page.visits.size(); ++k) {
            if (z >= page.visits[k].volumes.size()) {
                html += "<td>&ndash;</td>";
                continue;
            }
            const ReportVolume& v = page.visits[k].volumes[z];
            html += v.below_limit ? "<td class=\"below\">" : "<td>";
            html += "<b>" + fixed(v.signed_ml, 2) + "</b>";
            if (std::isfinite(v.low95_ml))
                html += "<br>" + fixed(v.low95_ml, 2) + " to " + fixed(v.high95_ml, 2);
            if (std::isfinite(v.limit_ml))
                html +=
                    (v.below_limit ? "<br>below the limit " : "<br>limit ") + fixed(v.limit_ml, 2);
            if (!v.unknown.empty()) html += "<br>no interval: " + html_text(v.unknown);
            html += "</td>";
        }
        html += "</tr>";
    }
    return html + "</table></div>";
}

}  // namespace

std::string html_text(const std::string& text) {
    std::string out;
    for (char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

std::string report_html(const ReportPage& page) {
    std::string html =
        "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"><title>" +
        html_text(page.title) + "</title><style>" + kStyle + "</style></head><body><h1>" +
        html_text(page.title) + "</h1>";
    html += "<h2>Volume against " + html_text(page.visits.front().name) +
            "</h2><p>Millilitres, positive: gained. "
            "Second line: 95 % interval. Third: limit of detection; what is grey lies below it and "
            "cannot be told from "
            "no change.</p>" +
            volume_table(page) + "<h2>Over time</h2><div class=\"plots\">";
    for (std::size_t z = 0; z < page.zones.size(); ++z) html += zone_plot(page, z);
    html +=
        "</div><p>Bars: 95 % interval. Grey: below the limit of detection. Hollow dots lie within "
        "it.</p><h2>Visits</h2>";
    for (const ReportVisit& visit : page.visits) {
        html += "<h3>" + html_text(visit.name) + "</h3><p class=\"" +
                (visit.good ? "good" : "bad") + "\">" + html_text(visit.verdict) + "</p>" +
                inline_png(visit.face, visit.name + ", the face");
        if (visit.difference.width > 0)
            html += inline_png(visit.difference,
                               visit.name + ", difference to " + page.visits.front().name);
    }
    html += "<h2>How it was measured</h2><ul>";
    for (const std::string& note : page.notes) html += "<li>" + html_text(note) + "</li>";
    return html + "</ul></body></html>\n";
}

}  // namespace mien::cli
