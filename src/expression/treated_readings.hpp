// A face with a treated zone, read in two ways. Filler in a lip can look like a rolled lip: inside
// the zone nothing tells the two apart. So the zone is no witness, and what it shows stays on the
// face; and it is also said what a fit that believes the zone would have taken off there.
#pragma once

#include <string>
#include <vector>

#include "expression/neutralize_mesh.hpp"

namespace mien {

/// One reading of the zone.
struct ZoneReading {
    std::string expression;    ///< the likeliest component; empty: the fit has none
    double probability = 1.0;  ///< of it
    double removed_mm = 0.0;   ///< root mean square over the zone of what was taken off
    double removed_ml =
        0.0;  ///< by which the zone stood out through the expression, to first order
};

struct TreatedReadings {
    ZoneReading treated;        ///< the zone is no witness: the result's
    ZoneReading as_expression;  ///< all of the face is a witness
    /// Another expression, and the zone's volume differs by what can matter (kTellingMl).
    bool differ = false;
};

/// Of what a clinic injects into the smallest zones (a lip: 0.5 mL, a tear trough: 0.25 mL) the
/// fifth part: below it both readings say the same.
constexpr double kTellingMl = 0.05;

/// result: neutralize_mesh() with these options, of which `neutralize.treated` is the zone. A
/// second fit; throws and costs as neutralize_mesh().
TreatedReadings read_treated_zone(const Context& context, const ExpressionModel& model,
                                  const TriMesh& face, const Vector& weights_per_vertex,
                                  const NeutralizeMeshOptions& options,
                                  const NeutralizationResult& result);

/// What a host should know, in a sentence; empty unless the readings differ.
std::string treated_warning(const TreatedReadings& readings);

}  // namespace mien
