/* What changed in a face between three visits, with intervals:
 * visits FACE.safetensors EXPRESSIONS.safetensors FIRST.ply SECOND.ply THIRD.ply
 * The numbers are those of `mien report --visits FOLDER --model FACE --expressions EXPRESSIONS`. */
#include <mien/mien.h>
#include <stdio.h>

static int print_table(const mien_study* study, mien_error* error) {
    uint32_t visits, zones, visit, zone;
    if (mien_study_get_counts(study, &visits, &zones, error)) return 1;
    for (visit = 1; visit < visits; ++visit)
        for (zone = 0; zone < zones; ++zone) {
            mien_study_change change = {.struct_size = sizeof change};
            const mien_study_value* ml = &change.signed_ml;
            char name[64];
            if (mien_study_get_zone_name(study, (int32_t)zone, name, sizeof name, NULL, error) ||
                mien_study_get_change(study, 0, (int32_t)visit, (int32_t)zone, &change, error))
                return 1;
            printf("%u %-24s %11.6f %11.6f %11.6f %11.6f\n", (unsigned)visit, name, ml->value,
                   ml->low, ml->high, ml->limit_of_detection);
        }
    return 0;
}

int main(int argc, char** argv) {
    enum { kVisits = 3 };
    mien_error error = {.struct_size = sizeof error};
    mien_session* session = NULL;
    mien_model* face = NULL;
    mien_expression_model* expressions = NULL;
    mien_mesh* scans[kVisits] = {NULL};
    mien_registration* fits[kVisits] = {NULL};
    mien_study* study = NULL;
    int k, failed;

    if (argc != 3 + kVisits) return 2; /* face.model expressions.model and the scans */
    failed = mien_session_create(MIEN_ABI_VERSION, &session, &error) ||
             mien_model_load(session, argv[1], &face, &error) ||
             mien_expression_model_load(session, argv[2], &expressions, &error);
    for (k = 0; k < kVisits && !failed; ++k)
        failed = mien_mesh_load(session, argv[3 + k], &scans[k], &error) ||
                 mien_register(session, face, scans[k], NULL, &fits[k], &error);
    failed = failed ||
             mien_study_create(session, (const mien_registration* const*)fits, kVisits, expressions,
                               NULL, &study, &error) ||
             print_table(study, &error);
    if (failed) fprintf(stderr, "mien: %s\n", error.message);

    mien_study_release(study);
    for (k = 0; k < kVisits; ++k) mien_registration_release(fits[k]);
    for (k = 0; k < kVisits; ++k) mien_mesh_release(scans[k]);
    mien_expression_model_release(expressions);
    mien_model_release(face);
    mien_session_release(session);
    return failed;
}
