/* The files that release 0.1 wrote (format-1), read by the present library through the headers of
 * release 0.1 (abi-0.1): names, sizes, the exact numbers that were stored, and what a result made
 * of them comes to. A later version that reads one of them otherwise breaks users' models.
 *
 *   golden_files FOLDER           check
 *   golden_files FOLDER print     print the expected table anew (only for a table that is being
 * added)
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mien-0.1.h"

#define CHECK_CALL(call) check_call((call), #call)

static mien_error error;
static mien_session* session;
static const char* folder;
static int printing, failures;

static void fail_text(const char* what, const char* why) {
    printf("FAILED: %s: %s\n", what, why);
    ++failures;
}

static int check_call(mien_status status, const char* call) {
    if (status == MIEN_OK) return 1;
    fail_text(call, error.message);
    return 0;
}

/* A value that was stored, or one of its results: equal up to `tolerance`. */
static void expect(const char* what, double value, double expected, double tolerance) {
    char why[120];
    if (printing) {
        printf("%-40s %.17g\n", what, value);
        return;
    }
    if (fabs(value - expected) <= tolerance) return;
    snprintf(why, sizeof why, "%.17g, release 0.1 had %.17g", value, expected);
    fail_text(what, why);
}

/* FNV-1a of bytes that were stored: equal to the bit. */
static void expect_bytes(const char* what, const void* data, size_t size,
                         unsigned long long expected) {
    const unsigned char* bytes = (const unsigned char*)data;
    unsigned long long hash = 14695981039346656037ull;
    char why[120];
    size_t k;
    for (k = 0; k < size; ++k) hash = (hash ^ bytes[k]) * 1099511628211ull;
    if (printing) {
        printf("%-40s 0x%016llxull\n", what, hash);
        return;
    }
    if (hash == expected) return;
    snprintf(why, sizeof why, "the stored numbers are other ones (0x%016llx)", hash);
    fail_text(what, why);
}

static void expect_words(const char* what, const char* text, const char* const* words) {
    for (; *words != NULL; ++words)
        if (strstr(text, *words) == NULL) fail_text(what, *words);
}

static const char* path_of(const char* name) {
    static char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

/* What release 0.1 read and computed from its own files. */
enum { VERTICES = 191, TRIANGLES = 318, HIERARCHY_LEVEL_1 = 48, HIERARCHY_LEVEL_2 = 12 };
#define MODEL_VERTICES 0x1aac8fe86a49a1f8ull
#define TRIANGLES_HASH 0x1140d9f604974ffcull
#define BASIS_VALUES 0x49a3a2595c3af630ull
static const double MODEL_VARIANCE = 81.058023693510336, MODEL_SAMPLE = 24.537732067518039,
                    EXPRESSION_REMOVED = 0.23156024198274547, EXPRESSION_SAMPLE = 25.49245196680894,
                    SCORE = 1.3362713466276357, SCORE_HALF_INTERVAL = 1.7665579249568766,
                    BASIS_HIGH = 0.757117033881614, REPRESENTATION_MEAN = 1.157522978781627;

static void check_mesh(const char* what, const mien_mesh* mesh, unsigned long long vertices_hash,
                       unsigned long long triangles_hash) {
    static uint32_t triangles[3 * TRIANGLES];
    const double* positions = NULL;
    uint64_t vertex_count = 0, triangle_count = 0, count = 0;
    if (mesh == NULL ||
        !CHECK_CALL(mien_mesh_get_counts(mesh, &vertex_count, &triangle_count, &error)))
        return;
    expect(what, (double)vertex_count, VERTICES, 0);
    expect(what, (double)triangle_count, TRIANGLES, 0);
    if (vertex_count != VERTICES || triangle_count != TRIANGLES) return;
    if (CHECK_CALL(mien_mesh_positions_view(mesh, &positions, &count, &error)))
        expect_bytes(what, positions, 3 * VERTICES * sizeof *positions, vertices_hash);
    if (CHECK_CALL(mien_mesh_get_triangles(mesh, triangles, 3 * TRIANGLES, &count, &error)))
        expect_bytes(what, triangles, sizeof triangles, triangles_hash);
}

/* Root mean square distance of the vertices of two meshes, mm. */
static double distance_mm(const mien_mesh* a, const mien_mesh* b) {
    const double *p = NULL, *q = NULL;
    double sum = 0;
    uint64_t k, n = 0, m = 0;
    if (!CHECK_CALL(mien_mesh_positions_view(a, &p, &n, &error)) ||
        !CHECK_CALL(mien_mesh_positions_view(b, &q, &m, &error)) || n != m || n == 0)
        return NAN;
    for (k = 0; k < 3 * n; ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
    return sqrt(sum / (double)n);
}

static void check_model(mien_mesh** face) {
    static const char* const words[] = {"surface-matern", "\"jaw_07\"", "\"jaw_08\"", "\"jaw_09\"",
                                        "\"front\"",      "\"all\"",    NULL};
    static char json[20000];
    static double variance[3 * VERTICES];
    mien_model* model = NULL;
    uint64_t vertices = 0, scalar_modes = 0, vector_modes = 0, count = 0;
    double sum = 0;
    int k;
    if (!CHECK_CALL(mien_model_load(session, path_of("model.safetensors"), &model, &error))) return;
    if (CHECK_CALL(mien_model_get_counts(model, &vertices, &scalar_modes, &vector_modes, &error))) {
        expect("model vertices", (double)vertices, VERTICES, 0);
        expect("model scalar modes", (double)scalar_modes, 6, 0);
        expect("model vector modes", (double)vector_modes, 3, 0);
    }
    check_mesh("model template", mien_model_mesh(model), MODEL_VERTICES, TRIANGLES_HASH);
    if (CHECK_CALL(mien_model_get_json(model, json, sizeof json, &count, &error)))
        expect_words("model JSON", json, words);
    if (CHECK_CALL(mien_model_get_variance(model, variance, 3 * VERTICES, &count, &error))) {
        for (k = 0; k < 3 * VERTICES; ++k) sum += variance[k];
        expect("model variance, mean mm2", sum / (3 * VERTICES), MODEL_VARIANCE, 1e-9);
    }
    if (CHECK_CALL(mien_model_sample(session, model, 7, 0, 1.0, face, &error)))
        expect("model sample, mm off the template", distance_mm(*face, mien_model_mesh(model)),
               MODEL_SAMPLE, 1e-6);
    mien_model_release(model);
}

static void check_expressions(const mien_mesh* face) {
    static const char* const words[] = {"\"neutral\"", "\"smile\"", "\"mouth_stretch\"", "\"grin\"",
                                        NULL};
    static const char* const counts[] = {"\"subjects\":\"4\"", "\"faces\":\"16\"", NULL};
    static char json[20000];
    mien_expression_model *model = NULL, *trained = NULL;
    mien_neutralization* neutral = NULL;
    mien_mesh* grin = NULL;
    mien_train_options options;
    uint64_t vertices = 0, count = 0;
    uint32_t identities = 0, expressions = 0;
    if (!CHECK_CALL(
            mien_expression_model_load(session, path_of("expression.safetensors"), &model, &error)))
        return;
    if (CHECK_CALL(mien_expression_model_get_counts(model, &vertices, &identities, &expressions,
                                                    &error))) {
        expect("expression vertices", (double)vertices, VERTICES, 0);
        expect("identity modes", identities, 2, 0);
        expect("expression modes", expressions, 3, 0);
    }
    if (CHECK_CALL(mien_expression_model_get_json(model, json, sizeof json, &count, &error)))
        expect_words("expression JSON", json, words);
    if (CHECK_CALL(mien_expression_model_sample(session, model, 3, "grin", &grin, &error)) &&
        CHECK_CALL(mien_neutralize_mesh(session, model, grin, NULL, &neutral, &error)))
        expect("grin taken off, mm", distance_mm(grin, mien_neutralization_mesh(neutral)),
               EXPRESSION_REMOVED, 1e-4);
    expect("the sampled grin, mm off a face", distance_mm(grin, face), EXPRESSION_SAMPLE, 1e-6);
    /* The dataset can still be trained on; training may have learned something since, so that only
     * the faces and the order of magnitude are held. */
    mien_train_options_init(&options, sizeof options);
    options.identity_modes = 2;
    options.expression_modes = 3;
    if (CHECK_CALL(mien_expression_model_train(session, path_of("dataset.safetensors"), &options,
                                               &trained, &error))) {
        mien_neutralization* again = NULL;
        if (CHECK_CALL(mien_expression_model_get_json(trained, json, sizeof json, &count, &error)))
            expect_words("JSON of the model trained anew", json, counts);
        if (CHECK_CALL(mien_neutralize_mesh(session, trained, grin, NULL, &again, &error)))
            expect("model trained anew, mm off",
                   distance_mm(mien_neutralization_mesh(again), mien_neutralization_mesh(neutral)),
                   0, 0.5);
        mien_neutralization_release(again);
    }
    mien_expression_model_release(trained);
    mien_neutralization_release(neutral);
    mien_mesh_release(grin);
    mien_expression_model_release(model);
}

static void check_score(const mien_mesh* face) {
    mien_score_model* model = NULL;
    mien_score_prediction prediction;
    memset(&prediction, 0, sizeof prediction);
    prediction.struct_size = sizeof prediction;
    if (!CHECK_CALL(mien_score_model_load(session, path_of("score.safetensors"), &model, &error)))
        return;
    if (CHECK_CALL(mien_score_model_predict(session, model, face, &prediction, &error))) {
        expect("score", prediction.score, SCORE, 1e-6);
        expect("score, half interval", 0.5 * (prediction.high95 - prediction.low95),
               SCORE_HALF_INTERVAL, 1e-6);
    }
    mien_score_model_release(model);
}

static void check_spectral(const mien_mesh* face) {
    mien_spectral_basis* basis = NULL;
    mien_mesh *low = NULL, *high = NULL;
    double values[12];
    uint64_t vertices = 0, modes = 0, count = 0;
    if (!CHECK_CALL(mien_spectral_basis_load(session, path_of("spectral_basis.safetensors"), &basis,
                                             &error)))
        return;
    if (CHECK_CALL(mien_spectral_basis_get_counts(basis, &vertices, &modes, &error))) {
        expect("basis vertices", (double)vertices, VERTICES, 0);
        expect("basis modes", (double)modes, 12, 0);
    }
    if (CHECK_CALL(mien_spectral_basis_get_eigenvalues(basis, values, 12, &count, &error)))
        expect_bytes("basis eigenvalues", values, sizeof values, BASIS_VALUES);
    if (CHECK_CALL(mien_spectral_split(session, basis, face, 12, &low, &high, &error)))
        expect("high band of a face, mm", distance_mm(low, face), BASIS_HIGH, 1e-9);
    mien_mesh_release(low);
    mien_mesh_release(high);
    mien_spectral_basis_release(basis);
}

static void check_learning(const mien_mesh* face) {
    static double features[9 * VERTICES];
    mien_representation* representation = NULL;
    mien_hierarchy* hierarchy = NULL;
    mien_mesh* back = NULL;
    uint64_t vertices = 0, channels = 0, triangles = 0, count = 0;
    uint32_t levels = 0;
    double motion[16], sum = 0;
    int k;
    if (CHECK_CALL(mien_representation_load(session, path_of("representation.safetensors"),
                                            &representation, &error))) {
        if (CHECK_CALL(
                mien_representation_get_counts(representation, &vertices, &channels, &error)))
            expect("representation channels", (double)channels, 9, 0);
        if (CHECK_CALL(mien_representation_encode(session, representation, face, motion, features,
                                                  9 * VERTICES, &count, &error))) {
            for (k = 0; k < 9 * VERTICES; ++k) sum += fabs(features[k]);
            expect("representation, mean feature", sum / (9 * VERTICES), REPRESENTATION_MEAN, 1e-6);
            if (CHECK_CALL(mien_representation_decode(session, representation, features, VERTICES,
                                                      motion, &back, &error)))
                expect("representation and back, mm", distance_mm(back, face), 0, 1e-3);
        }
        mien_mesh_release(back);
        mien_representation_release(representation);
    }
    if (CHECK_CALL(
            mien_hierarchy_load(session, path_of("hierarchy.safetensors"), &hierarchy, &error))) {
        const double expected[] = {VERTICES, HIERARCHY_LEVEL_1, HIERARCHY_LEVEL_2};
        if (CHECK_CALL(mien_hierarchy_get_level_count(hierarchy, &levels, &error)))
            expect("hierarchy levels", levels, 3, 0);
        for (k = 0; k < 3 && k < (int)levels; ++k) {
            mien_mesh* level = NULL;
            if (CHECK_CALL(mien_hierarchy_get_level(hierarchy, (uint32_t)k, &level, &error)) &&
                CHECK_CALL(mien_mesh_get_counts(level, &vertices, &triangles, &error)))
                expect("hierarchy vertices", (double)vertices, expected[k], 0);
            mien_mesh_release(level);
        }
        mien_hierarchy_release(hierarchy);
    }
}

int main(int argc, char** argv) {
    mien_mesh* face = NULL;
    folder = argc > 1 ? argv[1] : ".";
    printing = argc > 2;
    error.struct_size = sizeof error;
    if (!CHECK_CALL(mien_session_create(MIEN_ABI_VERSION, &session, &error))) return 1;
    check_model(&face);
    if (face != NULL) {
        check_expressions(face);
        check_score(face);
        check_spectral(face);
        check_learning(face);
    }
    mien_mesh_release(face);
    mien_session_release(session);
    printf("%d failures\n", failures);
    return failures != 0;
}
