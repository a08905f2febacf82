/* From a raw scan to a neutral face: first_program FACE.safetensors EXPRESSIONS.safetensors
 * SCAN.ply NEUTRAL.ply */
#include <mien/mien.h>
#include <stdio.h>

static int32_t on_progress(void* user, int32_t stage, double fraction) {
    (void)user;
    printf("\rstage %d  %3.0f%%", (int)stage, 100.0 * fraction);
    return 0; /* non-zero cancels */
}

int main(int argc, char** argv) {
    mien_error error = {.struct_size = sizeof error};
    mien_session* session = NULL;
    mien_mesh* scan = NULL;
    mien_model* face = NULL;
    mien_expression_model* expressions = NULL;
    mien_registration* fitted = NULL;
    mien_neutralization* neutral = NULL;
    mien_register_options options;

    if (argc != 5) return 2; /* face.model expressions.model scan.ply neutral.ply */
    mien_register_options_init(&options, sizeof options);
    options.progress = on_progress;

    if (mien_session_create(MIEN_ABI_VERSION, &session, &error) ||
        mien_model_load(session, argv[1], &face, &error) ||
        mien_expression_model_load(session, argv[2], &expressions, &error) ||
        mien_mesh_load(session, argv[3], &scan, &error) ||
        mien_register(session, face, scan, &options, &fitted, &error) ||
        mien_neutralize(session, expressions, fitted, NULL, &neutral, &error) ||
        mien_mesh_save(session, mien_neutralization_mesh(neutral), argv[4], &error))
        fprintf(stderr, "mien: %s\n", error.message);

    mien_neutralization_release(neutral);
    mien_registration_release(fitted);
    mien_mesh_release(scan);
    mien_expression_model_release(expressions);
    mien_model_release(face);
    mien_session_release(session);
    return error.status != MIEN_OK;
}
