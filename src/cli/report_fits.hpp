// What a longitudinal report is made from: the visits of a folder, their faces fitted to the scans,
// the faces without their expressions.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"

namespace mien::cli {

struct ReportSettings {
    Common common;
    std::string visits, model, expressions, zones, stable, out, title = "Volume over time";
    std::vector<std::string> shown, treated;
    bool fitted = false;
    double sd = 0.08, correlation = 4, bias = 0.01, share = 0.06, posterior = 1, margin = 10;
};

struct Capture {
    std::string mesh, landmarks;
};
struct Visit {
    std::string name;
    std::vector<Capture> captures;
};

/// One visit per entry of the folder, in the order of their names; throws unless there are two.
std::vector<Visit> find_visits(const std::string& folder);

struct Fitted {
    Mesh mesh;
    std::vector<double> sd;      ///< along the normal, per vertex, mm
    std::vector<double> weight;  ///< per vertex: how far the scan was seen there, 0 to 1
    std::string verdict;
    bool good = true;
    nlohmann::json report;
};

/// model: may be null when settings say that the meshes are fitted already.
Fitted fit_capture(const Session& session, const ReportSettings& settings, const Model* model,
                   const Capture& capture);

/// The vertices within `margin_mm` of given ones on a face, those among them; ascending.
std::vector<std::uint32_t> with_margin(const Mesh& face, const std::vector<std::uint32_t>& vertices,
                                       double margin_mm);

/// Takes the expressions off all captures together; the faces become neutral ones.
std::unique_ptr<Visits> neutralize_all(const Session& session, const ExpressionModel& expressions,
                                       const std::vector<std::uint32_t>& treated,
                                       std::vector<Fitted>& fits);

}  // namespace mien::cli
