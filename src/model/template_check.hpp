// Is a mesh fit to be a template? What is wrong with one shows months later, in measurements: a
// template that is inside out turns every volume's sign round, one in decimetres has kernels a
// hundred times too long. Errors are what no model should be built from; warnings are for a look.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

enum class FindingKind : std::int32_t { warning = 0, error = 1 };

struct TemplateFinding {
    FindingKind kind = FindingKind::warning;
    std::string code;                     ///< one word: unit, body, winding, pieces, ...
    std::string text;                     ///< what, where, what to do
    std::vector<std::uint32_t> vertices;  ///< concerned, ascending; empty: all
};

struct TemplateCheckOptions {
    std::vector<Landmark> landmarks;  ///< may be empty: then poses and openings are not looked at
    bool mirror = false;              ///< the model is to prefer mirror symmetry
    // By judgement, clear of the two templates that the tests use and of their faults.
    double face_mm = 110, bust_mm = 900;  ///< mm: extents of a face alone and of a bust
    double inwards = -0.3;  ///< -1 to 1: below this share of outward area it is inside out
    double needle = 1e-4;   ///< area over squared longest side, below which one is no triangle
    Index helper_triangles = 64;  ///< a piece of at most so many beside the face is a helper
    double opening_mm = 15;  ///< mm: a border so near to an eye's or mouth's landmarks opens it
};

/// All findings, errors first. `mesh` must have passed check_mesh(). Throws
/// Status::invalid_argument for a landmark that is no vertex. O(V log V + F log F).
std::vector<TemplateFinding> check_template(const TriMesh& mesh,
                                            const TemplateCheckOptions& options,
                                            const Context& context);

/// {"errors": n, "warnings": n, "findings": [{"kind", "code", "text", "vertices"}]}
std::string template_findings_json(const std::vector<TemplateFinding>& findings);

}  // namespace mien
