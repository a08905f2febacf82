#include "model/kernel.hpp"

#include <cmath>

#include "base/error.hpp"

namespace mien {
namespace {

struct Name {
    KernelKind kind;
    const char* name;
};
constexpr Name kNames[] = {{KernelKind::euclidean_se, "euclidean-se"},
                           {KernelKind::geodesic_se, "geodesic-se"},
                           {KernelKind::bspline, "bspline"},
                           {KernelKind::surface_matern, "surface-matern"}};

}  // namespace

const char* kernel_name(KernelKind kind) {
    for (const Name& entry : kNames)
        if (entry.kind == kind) return entry.name;
    fail(Status::internal, "kernel number %d has no name", static_cast<int>(kind));
}

KernelKind kernel_from_name(const std::string& name) {
    for (const Name& entry : kNames)
        if (name == entry.name) return entry.kind;
    fail(Status::invalid_argument,
         "kernel \"%.40s\" is unknown; choose geodesic-se, euclidean-se, bspline or surface-matern",
         name.c_str());
}

void check_kernels(const std::vector<KernelTerm>& terms) {
    if (terms.empty()) fail(Status::invalid_argument, "a deformation model needs a kernel");
    if (terms.size() > 64) fail(Status::invalid_argument, "a kernel of more than 64 terms");
    for (const KernelTerm& term : terms) {
        if (!(term.sigma_mm > 0) || !std::isfinite(term.sigma_mm))
            fail(Status::invalid_argument, "kernel sigma %g mm must be a positive number",
                 term.sigma_mm);
        if (!(term.scale_mm > 0) || !std::isfinite(term.scale_mm))
            fail(Status::invalid_argument, "kernel scale %g mm must be a positive number",
                 term.scale_mm);
        if (term.kind == KernelKind::surface_matern && !(term.nu >= 0.1 && term.nu <= 20))
            fail(Status::invalid_argument, "Matern smoothness %g is outside 0.1 .. 20", term.nu);
        bool known = false;
        for (const Name& entry : kNames) known = known || entry.kind == term.kind;
        if (!known)
            fail(Status::invalid_argument, "kernel number %d is unknown",
                 static_cast<int>(term.kind));
    }
}

std::vector<KernelTerm> multiscale(const KernelTerm& finest, int levels) {
    if (levels < 1 || levels > 12)
        fail(Status::invalid_argument, "%d kernel levels; choose 1 .. 12", levels);
    const double total = std::ldexp(1.0, levels) - 1;
    std::vector<KernelTerm> terms;
    for (int l = 0; l < levels; ++l) {
        KernelTerm term = finest;
        term.sigma_mm = std::ldexp(finest.sigma_mm, l);
        term.scale_mm = finest.scale_mm * std::sqrt(std::ldexp(1.0, l) / total);
        terms.push_back(term);
    }
    return terms;
}

double cubic_bspline(double x) {
    x = std::abs(x);
    if (x < 1) return 2.0 / 3.0 - x * x + 0.5 * x * x * x;
    if (x < 2) return (2 - x) * (2 - x) * (2 - x) / 6;
    return 0;
}

}  // namespace mien
