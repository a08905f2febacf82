// A registration tied to an earlier visit's, along the skin by texture.
#include "guard.hpp"
#include "model.hpp"
#include "options.hpp"
#include "registration.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

/// Allocates nothing: it runs in a function that can report nothing.
mien_tie_options default_tie_options() {
    const TextureTieSettings settings;
    mien_tie_options options{};
    options.struct_size = sizeof options;
    options.max_slide_mm = settings.most_slide_mm;
    options.least_share = settings.least_share;
    return options;
}

KeptVisit visit_of(const mien_registration& registration, const mien_mesh& scan) {
    return {*registration.mesh->mesh, registration.data, *scan.mesh};
}

}  // namespace

extern "C" {

void MIEN_CALL mien_tie_options_init(mien_tie_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_tie_options());
}

mien_status MIEN_CALL mien_registration_tie(mien_session* session, const mien_model* model,
                                            const mien_registration* reference,
                                            const mien_mesh* reference_scan,
                                            const mien_registration* registration,
                                            const mien_mesh* scan, const mien_tie_options* options,
                                            mien_registration** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_tie_options given = read_options(
            options, default_tie_options(), MIEN_FIRST_SIZE(mien_tie_options, cancel), "options");
        if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
        ReferenceSettings settings;
        settings.tie.most_slide_mm = given.max_slide_mm;
        settings.tie.least_share = given.least_share;
        const mien_registration& fit = checked(registration, "registration");
        const KeptVisit before =
            visit_of(checked(reference, "reference"), checked(reference_scan, "reference_scan"));
        const KeptVisit now = visit_of(fit, checked(scan, "scan"));
        const Call call(session, given.progress, given.progress_user, given.cancel);
        return new mien_registration(
            tie_to_reference(*checked(model, "model").model, before, now, settings, call.context()),
            fit);
    });
}

}  // extern "C"
