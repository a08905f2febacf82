// The longitudinal report as one HTML page that stands alone: no script, no request, readable on a
// phone.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "image.hpp"

namespace mien::cli {

/// One zone of one visit against the first.
struct ReportVolume {
    double signed_ml = 0, sd_ml = std::numeric_limits<double>::quiet_NaN();
    double low95_ml = 0, high95_ml = 0, absolute_ml = 0;
    double limit_ml = 0;  ///< of detection
    bool below_limit = false;
    std::string unknown;  ///< why there is no interval; empty: there is one
};

struct ReportVisit {
    std::string name;
    std::string verdict;  ///< of the registration and alignment, in words
    bool good = true;
    Image face, difference;             ///< difference: empty for the first visit
    std::vector<ReportVolume> volumes;  ///< one per zone; empty for the first visit
};

struct ReportPage {
    std::string title;
    std::vector<std::string> notes;  ///< how the numbers came about
    std::vector<std::string> zones;
    std::vector<ReportVisit> visits;
};

std::string report_html(const ReportPage& page);
/// Text as it may stand in HTML.
std::string html_text(const std::string& text);

}  // namespace mien::cli
