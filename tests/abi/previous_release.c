/* A program of release 0.1, built against that release's headers (tests/golden/abi-0.1) and run
 * with the present library: the whole job from arrays to a volume, with the structs as that release
 * knew them. What later releases add must not show here. Change it only when a new ABI number says
 * so. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "mien-0.1.h"

enum { SIDE = 14, VERTICES = SIDE * SIDE, SUBJECTS = 8 };

static double positions[3 * VERTICES];
static uint32_t triangles[6 * (SIDE - 1) * (SIDE - 1)];
static int reports;

static int32_t MIEN_CALL on_progress(void* user, int32_t stage, double fraction) {
    (void)user;
    (void)stage;
    (void)fraction;
    ++reports;
    return 0;
}

/* A sheet that bulges with the person and lifts at one edge with the expression. */
static const double* face(int subject, int expression) {
    int x, y, k;
    for (y = 0; y < SIDE; ++y)
        for (x = 0; x < SIDE; ++x) {
            double* p = positions + 3 * (y * SIDE + x);
            p[0] = 8.0 * x;
            p[1] = 8.0 * y + (expression ? (5 + sin(3.1 * subject)) * exp(-0.3 * y) : 0);
            p[2] = 10 * sin(0.4 * x) * cos(0.3 * y);
            for (k = 1; k < 5; ++k)
                p[2] += 2 * sin(7.3 * subject + k) * sin(0.2 * k * x + 0.1 * k * y);
        }
    return positions;
}

static int must(mien_status status, const mien_error* error, const char* what) {
    if (status == MIEN_OK && error->status == MIEN_OK) return 0;
    printf("FAILED: %s: %s: %s\n", what, mien_status_name(status), error->message);
    return 1;
}
#define MUST(call)                                 \
    do {                                           \
        if (must((call), &error, #call)) return 1; \
    } while (0)

int main(void) {
    static const char* const names[] = {"neutral", "lifted"};
    const char *data = "previous_release_faces.safetensors",
               *file = "previous_release_model.safetensors";
    const uint32_t corner[] = {0, 1, 2, SIDE, SIDE + 1, SIDE + 2};
    uint32_t* out = triangles;
    mien_error error = {.struct_size = sizeof error};
    mien_session_options settings;
    mien_mesh_arrays arrays;
    mien_array_view view = {positions, VERTICES, 0, MIEN_DTYPE_F64, 0};
    mien_model_options building;
    mien_register_options fitting;
    mien_train_options training;
    mien_neutralize_options neutralizing;
    mien_measure_options measuring;
    mien_fit_verdict verdict = {.struct_size = sizeof verdict};
    mien_zone_volume volume = {.struct_size = sizeof volume};
    mien_zone zone = {"corner", corner, 6};
    mien_session* session = NULL;
    mien_mesh *mean = NULL, *scan = NULL;
    mien_dataset_writer* writer = NULL;
    mien_model *built = NULL, *model = NULL;
    mien_expression_model* expressions = NULL;
    mien_registration* fitted = NULL;
    mien_neutralization* neutral = NULL;
    mien_measurement* measured = NULL;
    uint64_t count = 0;
    double moved[3 * VERTICES];
    int x, y, k;

    for (y = 0; y + 1 < SIDE; ++y)
        for (x = 0; x + 1 < SIDE; ++x) {
            const uint32_t a = (uint32_t)(y * SIDE + x),
                           quad[6] = {a, a + 1, a + SIDE + 1, a, a + SIDE + 1, a + SIDE};
            memcpy(out, quad, sizeof quad);
            out += 6;
        }
    mien_session_options_init(&settings, sizeof settings);
    settings.num_threads = 2;
    MUST(mien_session_create_with_options(MIEN_ABI_VERSION, &settings, &session, &error));
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    face(0, 0);
    arrays.positions = view;
    arrays.triangles = triangles;
    arrays.triangle_count = 2 * (SIDE - 1) * (SIDE - 1);
    MUST(mien_mesh_create(session, &arrays, &mean, &error));
    face(2, 1);
    MUST(mien_mesh_create(session, &arrays, &scan, &error));

    MUST(mien_dataset_writer_create(session, mean, names, 2, &writer, &error));
    for (k = 0; k < 2 * SUBJECTS; ++k) {
        face(k / 2, k % 2);
        MUST(mien_dataset_writer_add(writer, &view, k / 2, k % 2, &error));
    }
    MUST(mien_dataset_writer_save(session, writer, data, &error));

    mien_model_options_init(&building, sizeof building);
    building.num_modes = 90;
    building.zones = &zone;
    building.zone_count = 1;
    building.progress = on_progress;
    MUST(mien_model_build(session, mean, &building, &built, &error));
    MUST(mien_model_save(session, built, file, &error));
    MUST(mien_model_load(session, file, &model, &error));
    if (reports == 0) return printf("FAILED: no progress was reported\n"), 1;

    mien_register_options_init(&fitting, sizeof fitting);
    fitting.start = MIEN_START_POSE;
    fitting.units = MIEN_UNITS_MILLIMETRES;
    MUST(mien_register(session, model, scan, &fitting, &fitted, &error));
    MUST(mien_registration_get_verdict(fitted, &verdict, &error));
    if (!(verdict.mean_residual_mm < 1))
        return printf("FAILED: the fit is %g mm away\n", verdict.mean_residual_mm), 1;

    mien_train_options_init(&training, sizeof training);
    training.identity_modes = 3;
    training.expression_modes = 2;
    MUST(mien_expression_model_train(session, data, &training, &expressions, &error));
    mien_neutralize_options_init(&neutralizing, sizeof neutralizing);
    MUST(mien_neutralize_mesh(session, expressions, scan, &neutralizing, &neutral, &error));
    MUST(mien_mesh_get_positions(mien_neutralization_mesh(neutral), MIEN_DTYPE_F64, moved, VERTICES,
                                 &count, &error));
    if (count != VERTICES) return printf("FAILED: the neutral face has another size\n"), 1;

    mien_measure_options_init(&measuring, sizeof measuring);
    measuring.zones = &zone;
    measuring.zone_count = 1;
    MUST(mien_measure_volume(session, scan, mien_neutralization_mesh(neutral), &measuring,
                             &measured, &error));
    MUST(mien_measurement_get_volume(measured, 0, &volume, &error));
    if (!(volume.absolute_ml >= fabs(volume.signed_ml)))
        return printf("FAILED: volumes disagree\n"), 1;
    if (mien_measurement_get_volume(measured, 1, &volume, &error) != MIEN_E_NOT_FOUND ||
        error.message[0] == '\0')
        return printf("FAILED: a zone that is not there is found\n"), 1;

    mien_measurement_release(measured);
    mien_neutralization_release(neutral);
    mien_registration_release(fitted);
    mien_expression_model_release(expressions);
    mien_model_release(model);
    mien_model_release(built);
    mien_dataset_writer_release(writer);
    mien_mesh_release(scan);
    mien_mesh_release(mean);
    mien_session_release(session);
    remove(data);
    remove(file);
    printf("a program of 0.1 works with %s\n", mien_version_string());
    return 0;
}
