#include "report_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render.hpp"

namespace mien::cli {
namespace {

// The page may run its own script and show its own pictures, and reach nothing else.
const char* const kPolicy =
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
    "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">";

const char* const kStyle =
    "body{font:16px/1.5 system-ui,'Noto Sans',sans-serif;margin:0 "
    "auto;max-width:60rem;padding:1rem;"
    "color:#222;background:#fff;-webkit-print-color-adjust:exact;print-color-adjust:exact}"
    "h1{font-size:1.5rem;overflow-wrap:anywhere}"
    "h2{font-size:1.2rem;margin-top:2rem;border-bottom:1px solid #ddd}h3{margin-bottom:.3rem}"
    "h2,h3{break-after:avoid}img,svg{max-width:100%;height:auto;display:block}"
    "table{border-collapse:collapse;font-size:.9rem;width:100%}thead{display:table-header-group}"
    "tr,figure,dl{break-inside:avoid}"
    "td,th{padding:.3rem .5rem;text-align:right;vertical-align:top;border-bottom:1px solid #eee}"
    "td:first-child,th:first-child{text-align:left}"
    ".wide{overflow-x:auto}.below{color:#777}.bad{color:#a00}.good{color:#060}.hash{font:.75rem/"
    "1.4 "
    "ui-monospace,monospace;overflow-wrap:anywhere}"
    ".plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(17rem,1fr));gap:1rem}"
    ".pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(17rem,1fr));gap:.5rem}"
    "figure{margin:0 0 .5rem}figcaption{font-size:.85rem;color:#555}"
    "dl{display:grid;grid-template-columns:max-content 1fr;gap:.1rem .8rem;margin:.5rem 0}"
    "dt{color:#555}dd{margin:0;overflow-wrap:anywhere}"
    ".scale{display:flex;align-items:center;gap:.4rem;flex-wrap:wrap;font-size:.85rem;color:#444}"
    ".bar{display:inline-block;width:9rem;height:.8rem;border:1px solid #999}"
    ".swatch{display:inline-block;width:.9rem;height:.8rem;border:1px solid #999;margin-left:.6rem}"
    ".sign{margin-top:2.5rem;border-top:1px solid "
    "#444;padding-top:.2rem;max-width:30rem;color:#555;"
    "font-size:.85rem;break-inside:avoid}"
    "#view canvas{width:100%;max-width:34rem;aspect-ratio:1;touch-action:none;border:1px solid "
    "#ddd;"
    "display:block}#view button{font:inherit;padding:.3rem .8rem;margin:.3rem .3rem .3rem 0}"
    "#view button[aria-pressed=true]{background:#2166ac;color:#fff}"
    "@page{size:A4;margin:14mm}"
    "@media print{body{max-width:none;padding:0;font-size:10pt}#view{display:none}"
    ".plots{grid-template-columns:repeat(3,1fr)}.pair{grid-template-columns:1fr 1fr}"
    ".wide{overflow:visible}section{break-inside:avoid}}";

std::string inline_png(const Image& image, const std::string& alt) {
    return "<img alt=\"" + html_text(alt) + "\" src=\"" + png_data_uri(image) + "\">";
}

std::string field_list(const ReportPage& page, const ReportFields& fields) {
    if (fields.empty()) return "";
    std::string html = "<dl>";
    for (const auto& [key, value] : fields)
        html +=
            "<dt>" + html_text(page.words.field(key)) + "</dt><dd>" + html_text(value) + "</dd>";
    return html + "</dl>";
}

std::string volume_cell(const ReportPage& page, const ReportVolume& v) {
    const Words& words = page.words;
    std::string html = v.below_limit ? "<td class=\"below\">" : "<td>";
    html += "<b>" + words.number(v.signed_ml, 2) + "</b>";
    if (std::isfinite(v.low95_ml))
        html += "<br>" + words("to", {words.number(v.low95_ml, 2), words.number(v.high95_ml, 2)});
    if (std::isfinite(v.limit_ml))
        html +=
            "<br>" + words(v.below_limit ? "below_limit" : "limit", {words.number(v.limit_ml, 2)});
    if (!v.unknown.empty())
        html += "<br>" + words("no_interval", {html_text(words.sentence(v.unknown))});
    return html + "</td>";
}

std::string volume_table(const ReportPage& page) {
    std::string html =
        "<div class=\"wide\"><table><thead><tr><th>" + page.words("zone") + ", mL</th>";
    for (std::size_t k = 1; k < page.visits.size(); ++k)
        html += "<th>" + html_text(page.visits[k].name) + "</th>";
    html += "</tr></thead><tbody>";
    for (std::size_t z = 0; z < page.zones.size(); ++z) {
        html += "<tr><td>" + html_text(page.zones[z]) + "</td>";
        for (std::size_t k = 1; k < page.visits.size(); ++k)
            html += z < page.visits[k].volumes.size() ? volume_cell(page, page.visits[k].volumes[z])
                                                      : std::string("<td>&ndash;</td>");
        html += "</tr>";
    }
    return html + "</tbody></table></div>";
}

std::string doubt(const ReportVisit& visit, const std::string& text) {
    return "<p class=\"bad\"><strong>" + html_text(visit.name + ": " + text) + "</strong></p>";
}

/// The last visit in a few lines: what changed for sure, and of what nothing is known.
std::string summary(const ReportPage& page) {
    const ReportVisit& last = page.visits.back();
    const Words& words = page.words;
    std::string changed, unknown;
    for (std::size_t z = 0; z < std::min(page.zones.size(), last.volumes.size()); ++z) {
        const ReportVolume& v = last.volumes[z];
        const std::string name = html_text(page.zones[z]);
        if (v.detected)
            changed += "<li>" +
                       words("summary_change",
                             {name, words.number(v.signed_ml, 2), words.number(v.low95_ml, 2),
                              words.number(v.high95_ml, 2), html_text(last.name)}) +
                       "</li>";
        else if (!v.below_limit)
            unknown += (unknown.empty() ? "" : ", ") + name;
    }
    std::string html = "<h2>" + words("summary") + "</h2>";
    // What makes all of the numbers doubtful stands before them.
    if (!last.good) html += doubt(last, last.verdict);
    for (const std::string& reason : last.doubts) html += doubt(last, words.sentence(reason));
    if (!changed.empty())
        html += "<ul>" + changed + "</ul>";
    else if (unknown.empty())
        html += "<p>" + words("summary_none") + "</p>";
    if (!unknown.empty())
        html += "<p class=\"bad\">" + words("summary_unknown", {unknown}) + "</p>";
    return html;
}

/// The colours of change and what is none.
std::string color_scale(const ReportPage& page) {
    std::string stops;
    for (int k = 0; k <= 8; ++k) {
        const Rgb c = map_color(ColorMap::diverging, k / 8.0);
        char text[24];
        std::snprintf(text, sizeof text, ",#%02x%02x%02x", c[0], c[1], c[2]);
        stops += text;
    }
    const Words& words = page.words;
    const std::string range = words.number(short_number(page.range_mm));
    return "<div class=\"scale\"><span>" + words("lost") + " &minus;" + range +
           " mm</span><span class=\"bar\" style=\"background:linear-gradient(90deg" + stops +
           ")\"></span><span>+" + range + " mm " + words("gained") +
           "</span><span class=\"swatch\" style=\"background:#828282\"></span><span>" +
           words("unseen") + "</span><span>" +
           words(page.errors_known ? "within_error" : "without_error") + "</span></div>";
}

std::string visit_section(const ReportPage& page, const ReportVisit& visit) {
    const Words& words = page.words;
    std::string html = "<section><h3>" + html_text(visit.name) + "</h3><p class=\"" +
                       (visit.good ? "good" : "bad") + "\">" + html_text(visit.verdict) + "</p>";
    if (!visit.reasons.empty()) {
        html += "<ul aria-label=\"" + words("reasons") + "\">";
        for (const std::string& reason : visit.reasons)
            html += "<li>" + html_text(words.sentence(reason)) + "</li>";
        html += "</ul>";
    }
    html += field_list(page, visit.fields) + "<div class=\"pair\">";
    if (visit.scan.width > 0)
        html += "<figure>" + inline_png(visit.scan, visit.name + ", " + words("scan")) +
                "<figcaption>" + words("scan") + "</figcaption></figure>";
    html += "<figure>" + inline_png(visit.face, visit.name + ", " + words("fit")) + "<figcaption>" +
            words("fit") + "</figcaption></figure></div><p><small>" +
            (visit.scan.width > 0 ? words(page.outlined ? "one_scale" : "one_scale_untreated")
                                  : words("no_scan")) +
            "</small></p>";
    if (visit.change.width > 0) {
        const std::string of = words("change_against", {page.visits.front().name});
        html += "<figure>" + inline_png(visit.change, visit.name + ", " + of) + "<figcaption>" +
                html_text(of) + "</figcaption>" + color_scale(page) + "</figure>";
    }
    return html + "</section>";
}

std::string head(const ReportPage& page) {
    return "<!DOCTYPE html><html lang=\"" + page.words.language() +
           "\"><head><meta charset=\"utf-8\">" + kPolicy +
           "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"><title>" +
           html_text(page.title) + "</title><style>" + kStyle + "</style></head><body><h1>" +
           html_text(page.title) + "</h1>";
}

std::string treated_line(const ReportPage& page) {
    if (page.treated.empty()) return "";
    std::string names;
    for (const std::string& name : page.treated) names += (names.empty() ? "" : ", ") + name;
    return "<p>" + page.words("how_treated", {html_text(names)}) + "</p>";
}

}  // namespace

std::string report_html(const ReportPage& page) {
    const Words& words = page.words;
    std::string html = head(page) + field_list(page, page.patient) + treated_line(page) +
                       summary(page) + "<h2>" +
                       words("against", {html_text(page.visits.front().name)}) + "</h2><p>" +
                       words("table_text", {"95"}) + "</p>" + volume_table(page) + "<h2>" +
                       words("over_time") + "</h2><div class=\"plots\">";
    for (std::size_t z = 0; z < page.zones.size(); ++z) html += zone_plot(page, z);
    html += "</div><p>" + words("plot_text", {"95"}) +
            (has_dates(page) ? "" : " " + words("no_dates")) + "</p>";
    if (!page.view.empty())
        html += "<div id=\"view\"><h2>" + words("turn_heading") + "</h2>" + page.view +
                color_scale(page) + "</div>";
    html += "<h2>" + words("visits") + "</h2>";
    for (const ReportVisit& visit : page.visits) html += visit_section(page, visit);
    html += "<h2>" + words("how") + "</h2><ul>";
    for (const std::string& note : page.notes) html += "<li>" + html_text(note) + "</li>";
    html += "</ul><h2>" + words("made_with") + "</h2><dl>";
    for (const auto& [name, value] : page.made_with)
        html += "<dt>" + html_text(name) + "</dt><dd class=\"hash\">" + html_text(value) + "</dd>";
    return html + "</dl><p class=\"sign\">" + words("reviewed") + "</p></body></html>\n";
}

}  // namespace mien::cli
