// The visits of a folder as registrations: scans are registered, records and fitted meshes are
// read.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "report_patient.hpp"

namespace mien::cli {

struct Capture {
    std::string mesh;       ///< or a record that `mien register --record` wrote
    std::string landmarks;  ///< or what `mien register --json` wrote; empty: nothing lies beside it
};
struct Visit {
    std::string name;  ///< of the file or folder; UTF-8 whatever the file system holds
    std::vector<Capture> captures;
    VisitFile file;  ///< of visit.json in the folder or NAME.visit.json beside the mesh; its date
                     ///< may be that of the name
    /// As people call it: date and label, or the name.
    std::string shown() const;
};

/// One visit per entry of the folder, in the order of their names; throws unless there are two,
/// and when their dates do not ascend.
std::vector<Visit> find_visits(const std::string& folder);
/// patient.json in the folder of visits; empty: there is none.
std::string patient_file(const std::string& folder);

struct Fitted {
    Registration fit;
    bool judged = true;                 ///< false: fitted beforehand, without a verdict
    nlohmann::json report;              ///< null for meshes that were fitted beforehand
    std::string scan;                   ///< the scan's file where it is known
    std::vector<std::string> warnings;  ///< of reading and registering it, as they were printed
    /// Judged, and good; or nothing was said against it.
    bool good() const;
    /// Why it is not good, and what was settled before it, as the library says it.
    std::vector<std::string> reasons() const;
};

/// Registers a scan, as `mien register` does.
Fitted fit_scan(const Session& session, const Model& model, const Capture& capture,
                const VisitFile& visit);

/// A fit that is there already: a record, or a mesh with what `mien register --json` wrote beside
/// it. A bare mesh lies within sd_mm of the skin; without sd_mm nothing is known of its errors.
Fitted read_fitted(const Session& session, const Capture& capture, const VisitFile& visit,
                   std::optional<double> sd_mm);

/// True for files that `mien register --record` writes, by their name.
bool is_record(const std::string& path);

}  // namespace mien::cli
