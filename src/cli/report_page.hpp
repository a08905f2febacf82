// The longitudinal report as one HTML page that stands alone: no request to any network, readable
// on a phone, A4 when it is printed.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "image.hpp"
#include "report_patient.hpp"
#include "report_words.hpp"

namespace mien::cli {

/// One zone of one visit against the first.
struct ReportVolume {
    double signed_ml = 0, sd_ml = std::numeric_limits<double>::quiet_NaN();
    double low95_ml = 0, high95_ml = 0, absolute_ml = 0;
    double limit_ml = 0;  ///< of detection
    bool below_limit = false;
    bool detected = false;
    std::string unknown;  ///< why there is no interval, as the library says it; empty: there is one
};

struct ReportVisit {
    std::string name;     ///< as people call it: date and label, or the file's name
    std::string date;     ///< YYYY-MM-DD, or empty
    std::string verdict;  ///< of the registration and alignment, in words
    bool good = true;
    std::vector<std::string> reasons;  ///< of the verdict, and what else to know of the fit
    std::vector<std::string> doubts;   ///< whether it can be compared with the first visit at all
    ReportFields fields;
    Image scan, face;                   ///< at one scale; scan: empty when it was not given
    Image change;                       ///< against the first visit; empty for the first
    std::vector<ReportVolume> volumes;  ///< one per zone; empty for the first visit
};

struct ReportPage {
    explicit ReportPage(const std::string& language) : words(language) {}
    Words words;
    std::string title;
    ReportFields patient;
    std::vector<std::string> treated;  ///< zones in words
    bool outlined = false;             ///< the pictures show the treated zones' rims
    std::vector<std::string> zones;    ///< in words
    std::vector<ReportVisit> visits;
    std::string view;                ///< the turnable view's HTML; empty: none
    double range_mm = 0.5;           ///< of the colours of change
    bool errors_known = true;        ///< of the faces: what is within them is white
    std::vector<std::string> notes;  ///< how the numbers came about
    ReportFields made_with;          ///< software, models and their hashes
};

std::string report_html(const ReportPage& page);

/// One zone over the visits as SVG: dots with 95 % bars before the limit of detection as a grey
/// block, along the dates where every visit has one.
std::string zone_plot(const ReportPage& page, std::size_t zone);
/// True when every visit has a date, so that plots have real time along them.
bool has_dates(const ReportPage& page);

}  // namespace mien::cli
