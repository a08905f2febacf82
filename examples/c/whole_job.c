#include <mien/mien.h>
#include <stdio.h>
int main(int argc, char** argv) { /* FACE.safetensors EXPRESSIONS.safetensors NEUTRAL and 3 SCANS */
    static char text[1 << 16];
    mien_error e = {.struct_size = sizeof e};
    mien_session* s = NULL;
    mien_model* face = NULL;
    mien_expression_model* model = NULL;
    mien_mesh* scan[4] = {NULL};
    mien_registration* fit[4] = {NULL};
    mien_neutralization* neutral = NULL;
    mien_study* study = NULL;
    mien_study_change c = {.struct_size = sizeof c};
    mien_register_options stop;
    mien_register_options_init(&stop, sizeof stop);
    int k, bad = argc != 7 || mien_session_create(MIEN_ABI_VERSION, &s, &e) ||
                 mien_model_load(s, argv[1], &face, &e) ||
                 mien_expression_model_load(s, argv[2], &model, &e) ||
                 mien_cancel_create(&stop.cancel, &e);
    for (k = 0; k < 3 && !bad; ++k)
        bad = mien_mesh_load(s, argv[4 + k], &scan[k], &e) ||
              mien_register(s, face, scan[k], NULL, &fit[k], &e) ||
              mien_registration_get_json(fit[k], text, sizeof text, NULL, &e) || puts(text) < 0;
    bad = bad || mien_neutralize(s, model, fit[1], NULL, &neutral, &e) ||
          mien_mesh_save(s, mien_neutralization_mesh(neutral), argv[3], &e) ||
          mien_study_create(s, (const mien_registration* const*)fit, 3, model, NULL, &study, &e);
    for (k = 0; !bad && !mien_study_get_zone_name(study, k, text, sizeof text, NULL, NULL) &&
                !(bad = mien_study_get_change(study, 0, 2, k, &c, &e));
         ++k)
        printf("%s %.6f [%.6f, %.6f]\n", text, c.signed_ml.value, c.signed_ml.low,
               c.signed_ml.high);
    mien_cancel_request(stop.cancel);
    bad = bad || mien_register(s, face, scan[0], &stop, &fit[3], &e) != MIEN_E_CANCELLED;
    fprintf(bad ? stderr : stdout, "%s\n", e.message);
    for (k = 0; k < 4; ++k) mien_registration_release(fit[k]), mien_mesh_release(scan[k]);
    mien_study_release(study), mien_neutralization_release(neutral),
        mien_expression_model_release(model), mien_model_release(face),
        mien_cancel_release(stop.cancel), mien_session_release(s);
    return bad;
}
