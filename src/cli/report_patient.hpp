// Who was scanned, and when: patient.json beside the visits, visit.json in a visit, dates in the
// names of visits.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mien::cli {

/// Names and values of a file's fields, in its order.
using ReportFields = std::vector<std::pair<std::string, std::string>>;

/// What visit.json (or NAME.visit.json) says of one visit.
struct VisitFile {
    std::string date;     ///< YYYY-MM-DD, or empty
    std::string label;    ///< beside the date, e.g. "3 weeks after"
    std::string scan;     ///< path of the scan that the visit's face was fitted to, or empty
    ReportFields fields;  ///< all others
};

/// {"name": ..., ...}: text, numbers and truth values; throws std::runtime_error naming the file.
ReportFields read_patient(const std::string& path);
/// The same with "date", "label" and "scan", which is relative to the file's folder.
VisitFile read_visit(const std::string& path);

/// The date that a visit's name begins with, as YYYY-MM-DD or YYYYMMDD, and the rest of the name.
std::pair<std::string, std::string> date_of_name(const std::string& name);

/// Days since 1970-01-01 of YYYY-MM-DD; none: no such day.
std::optional<long> day_number(const std::string& date);
/// YYYY-MM-DD of such a day.
std::string date_text(long day);

}  // namespace mien::cli
