/* The files of format 2 (format-2), read by the present library: what the frozen program of release
 * 0.1 (golden_files.c) has no functions for. The kinds that it knows it reads from that folder too.
 *
 *   golden_format_2 FOLDER              check
 *   golden_format_2 FOLDER print        print the expected values anew (for a file that is added)
 *   golden_format_2 FOLDER write FROM   make the folder from that of format 1 (README.md)
 */
#include <math.h>
#include <mien/mien.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK_CALL(call) check_call((call), #call)

enum { VERTICES = 191, FACES = 16, PERSONS_FOR_NORMS = 12, CODE = 24, TEXT = 20000 };

static mien_error error;
static mien_session* session;
static const char *folder, *source;
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

static void expect(const char* what, double value, double expected, double tolerance) {
    char why[120];
    if (printing) {
        printf("%-40s %.17g\n", what, value);
        return;
    }
    if (fabs(value - expected) <= tolerance) return;
    snprintf(why, sizeof why, "%.17g, expected %.17g", value, expected);
    fail_text(what, why);
}

static void expect_word(const char* what, const char* text, const char* word) {
    if (strstr(text, word) == NULL) fail_text(what, word);
}

static const char* join(const char* place, const char* name) {
    static char paths[4][1024];
    static int next;
    char* path = paths[next = (next + 1) % 4];
    snprintf(path, sizeof paths[0], "%s/%s", place, name);
    return path;
}

static const char* path_of(const char* name) {
    return join(folder, name);
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

/* The template of the model file, which all the other kinds know. */
static mien_mesh* read_template(void) {
    mien_model* model = NULL;
    mien_mesh* mesh = NULL;
    if (!CHECK_CALL(mien_model_load(session, path_of("model.safetensors"), &model, &error)))
        return NULL;
    mesh = mien_mesh_retain(mien_model_mesh(model));
    mien_model_release(model);
    return mesh;
}

static void check_registration(const mien_mesh* face) {
    static double residual[VERTICES];
    mien_registration* fit = NULL;
    mien_fit_verdict verdict;
    uint64_t count = 0;
    double sum = 0;
    int k;
    memset(&verdict, 0, sizeof verdict);
    verdict.struct_size = sizeof verdict;
    if (!CHECK_CALL(
            mien_registration_load(session, path_of("registration.safetensors"), &fit, &error)))
        return;
    if (CHECK_CALL(mien_registration_get_verdict(fit, &verdict, &error)))
        expect("registration quality", verdict.quality, MIEN_QUALITY_DOUBTFUL, 0);
    if (CHECK_CALL(mien_registration_get_field(fit, MIEN_REGISTRATION_RESIDUAL_MM, residual,
                                               VERTICES, &count, &error))) {
        for (k = 0; k < VERTICES; ++k) sum += residual[k];
        expect("registration, sum of residuals", sum, 0.001 * (VERTICES - 1) * VERTICES / 2, 1e-4);
    }
    expect("registration, mm off the template", distance_mm(mien_registration_mesh(fit), face), 0,
           1e-4);
    mien_registration_release(fit);
}

static void check_blendshapes(const mien_mesh* face) {
    mien_blendshape_model* model = NULL;
    mien_spectral_basis* basis = NULL;
    mien_mesh *mean = NULL, *grin = NULL;
    if (!CHECK_CALL(mien_blendshape_model_load(session, path_of("blendshapes.safetensors"), &model,
                                               &error)))
        return;
    if (CHECK_CALL(mien_blendshape_model_get_mean(model, &mean, &error)))
        expect("blendshape mean, mm off the template", distance_mm(mean, face), 107.151023813574,
               1e-6);
    if (CHECK_CALL(mien_spectral_basis_load(session, path_of("spectral_basis.safetensors"), &basis,
                                            &error)) &&
        CHECK_CALL(mien_blendshape_model_predict(session, model, basis, 12, mean, &grin, &error)))
        expect("predicted grin, mm off the mean", distance_mm(grin, mean), 0.95668612965075417,
               1e-4);
    mien_spectral_basis_release(basis);
    mien_mesh_release(grin);
    mien_mesh_release(mean);
    mien_blendshape_model_release(model);
}

static void check_shards(void) {
    static char json[TEXT];
    const char* shards[2];
    char first[1024], second[1024];
    mien_expression_model* model = NULL;
    mien_mesh *grin = NULL, *neutral = NULL;
    mien_train_options options;
    uint64_t count = 0;
    snprintf(first, sizeof first, "%s", path_of("shard_0.safetensors"));
    snprintf(second, sizeof second, "%s", path_of("shard_1.safetensors"));
    shards[0] = first;
    shards[1] = second;
    mien_train_options_init(&options, sizeof options);
    options.identity_modes = 2;
    options.expression_modes = 3;
    if (!CHECK_CALL(mien_expression_model_merge(session, shards, 2, &options, &model, &error)))
        return;
    if (CHECK_CALL(mien_expression_model_get_json(model, json, sizeof json, &count, &error))) {
        expect_word("merged shards", json, "\"faces\":\"16\"");
        expect_word("merged shards", json, "\"mouth_stretch\"");
    }
    /* Training may have learned something since: the size of an expression, not its digits. */
    if (CHECK_CALL(mien_expression_model_sample(session, model, 3, "grin", &grin, &error)) &&
        CHECK_CALL(mien_expression_model_sample(session, model, 3, "neutral", &neutral, &error)))
        expect("grin of the merged model, mm", distance_mm(grin, neutral), 1.1535868470714343, 0.5);
    mien_mesh_release(neutral);
    mien_mesh_release(grin);
    mien_expression_model_release(model);
}

static void check_texts(const mien_mesh* face) {
    static char json[TEXT];
    mien_landmarks* marks = NULL;
    mien_zones* zones = NULL;
    mien_norms* norms = NULL;
    mien_anthropometry* list = NULL;
    mien_anthropometry_options options;
    mien_anthropometric_value value;
    uint32_t vertices[8];
    uint64_t count = 0, known = 0, k;
    if (CHECK_CALL(mien_zones_load(session, path_of("zones.json"), &zones, &error)) &&
        CHECK_CALL(mien_zones_get_vertices(zones, 0, vertices, 8, &count, &error))) {
        expect("zone size", (double)count, 3, 0);
        expect("zone, sum of vertices", vertices[0] + vertices[1] + vertices[2], 16, 0);
    }
    mien_zones_release(zones);
    if (!CHECK_CALL(mien_landmarks_load(session, path_of("landmarks.json"), &marks, &error)))
        return;
    if (CHECK_CALL(mien_landmarks_get_mark(marks, 1, NULL, NULL, vertices, &error)))
        expect("landmark's vertex", vertices[0], 190, 0);
    if (CHECK_CALL(mien_norms_load(session, path_of("norms.json"), &norms, &error)) &&
        CHECK_CALL(mien_norms_get_json(norms, json, sizeof json, &count, &error)))
        expect_word("norms", json, "\"ch-ch\"");
    mien_anthropometry_options_init(&options, sizeof options);
    options.norms = norms;
    memset(&value, 0, sizeof value);
    value.struct_size = sizeof value;
    if (CHECK_CALL(mien_measure_anthropometry(session, face, marks, &options, &list, &error)) &&
        CHECK_CALL(mien_anthropometry_get_counts(list, &count, &known, &error)))
        for (k = 0; k < count; ++k) {
            if (!CHECK_CALL(mien_anthropometry_get_name(list, k, json, 64, NULL, &error)) ||
                strcmp(json, "ch-ch") != 0)
                continue;
            if (!CHECK_CALL(mien_anthropometry_get_value(list, k, &value, &error))) continue;
            expect("norm, mean", value.norm_mean, 43.485611840800736, 1e-9);
            expect("norm, people", value.norm_people, PERSONS_FOR_NORMS, 0);
            expect("breadth against the norm", value.z, 0.087086297528549753, 1e-6);
        }
    mien_anthropometry_release(list);
    mien_norms_release(norms);
    mien_landmarks_release(marks);
}

static void check_network(const mien_mesh* face) {
    static double code[CODE];
    mien_network* network = NULL;
    mien_mesh* made = NULL;
    double motion[12], sum = 0;
    uint64_t count = 0;
    int k;
    if (!CHECK_CALL(mien_network_load(session, path_of("network.safetensors"), &network, &error)))
        return;
    if (CHECK_CALL(mien_network_encode(session, network, face, NULL, motion, code, CODE, &count,
                                       &error))) {
        expect("numbers of the code", (double)count, CODE, 0);
        for (k = 0; k < CODE; ++k) sum += fabs(code[k]);
        expect("code, mean size", sum / CODE, 0.61847279562304414, 1e-5);
        if (CHECK_CALL(
                mien_network_decode(session, network, code, CODE, motion, NULL, &made, &error)))
            expect("decoded face, mm off", distance_mm(made, face), 0.49675074884863452, 1e-3);
    }
    mien_mesh_release(made);
    mien_network_release(network);
}

/* ---- the folder, made once ---- */

#define COPY(kind, Type)                                                           \
    do {                                                                           \
        Type* copied = NULL;                                                       \
        if (CHECK_CALL(Type##_load(session, join(source, kind), &copied, &error))) \
            CHECK_CALL(Type##_save(session, copied, join(folder, kind), &error));  \
        Type##_release(copied);                                                    \
    } while (0)

/* The faces of the dataset of format 1: float32 behind the header, then person and expression. */
static void copy_dataset(const mien_mesh* topology) {
    static const char* const names[] = {"neutral", "smile", "mouth_stretch", "grin"};
    static float faces[FACES][3 * VERTICES];
    int32_t person[FACES], expression[FACES];
    mien_dataset_writer* writer = NULL;
    FILE* file = fopen(join(source, "dataset.safetensors"), "rb");
    uint64_t header = 0;
    int k;
    if (file == NULL || fread(&header, sizeof header, 1, file) != 1 ||
        fseek(file, (long)header, SEEK_CUR) != 0 || fread(faces, sizeof faces, 1, file) != 1 ||
        fread(person, sizeof person, 1, file) != 1 ||
        fread(expression, sizeof expression, 1, file) != 1) {
        fail_text("dataset", "cannot be read");
        return;
    }
    fclose(file);
    if (!CHECK_CALL(mien_dataset_writer_create(session, topology, names, 4, &writer, &error)))
        return;
    for (k = 0; k < FACES; ++k) {
        mien_array_view view = {NULL, VERTICES, 0, MIEN_DTYPE_F32, 0};
        view.data = faces[k];
        CHECK_CALL(mien_dataset_writer_add(writer, &view, person[k], expression[k], &error));
    }
    CHECK_CALL(mien_dataset_writer_save(session, writer, path_of("dataset.safetensors"), &error));
    mien_dataset_writer_release(writer);
}

/* Norms over faces of the model's: they are of no use but to be read. */
static void write_norms(const mien_mesh* topology, const mien_landmarks* marks) {
    static const char* const names[] = {"neutral"};
    const char* path = "golden_people.safetensors";
    mien_dataset_writer* writer = NULL;
    mien_norms* norms = NULL;
    mien_model* model = NULL;
    int k;
    CHECK_CALL(mien_model_load(session, path_of("model.safetensors"), &model, &error));
    CHECK_CALL(mien_dataset_writer_create(session, topology, names, 1, &writer, &error));
    for (k = 0; k < PERSONS_FOR_NORMS; ++k) {
        mien_array_view view = {NULL, 0, 0, MIEN_DTYPE_F64, 0};
        mien_mesh* face = NULL;
        const double* positions = NULL;
        CHECK_CALL(mien_model_sample(session, model, (uint64_t)k, 0, 1.0, &face, &error));
        if (CHECK_CALL(mien_mesh_positions_view(face, &positions, &view.count, &error))) {
            view.data = positions;
            CHECK_CALL(mien_dataset_writer_add(writer, &view, k, 0, &error));
        }
        mien_mesh_release(face);
    }
    CHECK_CALL(mien_dataset_writer_save(session, writer, path, &error));
    if (CHECK_CALL(mien_norms_create(session, path, marks, NULL, &norms, &error)))
        CHECK_CALL(mien_norms_save(session, norms, path_of("norms.json"), &error));
    remove(path);
    mien_norms_release(norms);
    mien_dataset_writer_release(writer);
    mien_model_release(model);
}

static void write_texts(const mien_mesh* topology) {
    static const uint32_t vertices[] = {5, 2, 9};
    const mien_zone zone = {"chin", vertices, 3};
    mien_zones* zones = NULL;
    mien_landmarks* marks = NULL;
    FILE* file = fopen("golden_marks.json", "w");
    if (file == NULL) return;
    fputs("{\"vertices\": {\"ch_right\": 0, \"ch_left\": 190}}", file);
    fclose(file);
    if (CHECK_CALL(mien_zones_create(&zone, 1, &zones, &error)))
        CHECK_CALL(mien_zones_save(session, zones, path_of("zones.json"), &error));
    if (CHECK_CALL(mien_landmarks_load(session, "golden_marks.json", &marks, &error))) {
        CHECK_CALL(mien_landmarks_save(session, marks, path_of("landmarks.json"), &error));
        write_norms(topology, marks);
    }
    remove("golden_marks.json");
    mien_zones_release(zones);
    mien_landmarks_release(marks);
}

static void write_folder(void) {
    static double weight[VERTICES], residual[VERTICES];
    mien_array_view weights = {weight, VERTICES, 0, MIEN_DTYPE_F64, 0},
                    residuals = {residual, VERTICES, 0, MIEN_DTYPE_F64, 0};
    mien_registration* fit = NULL;
    mien_blendshape_model* shapes = NULL;
    mien_shard_options part;
    mien_mesh* topology;
    int k;
    COPY("model.safetensors", mien_model);
    COPY("expression.safetensors", mien_expression_model);
    COPY("score.safetensors", mien_score_model);
    COPY("spectral_basis.safetensors", mien_spectral_basis);
    COPY("representation.safetensors", mien_representation);
    COPY("hierarchy.safetensors", mien_hierarchy);
    topology = read_template();
    copy_dataset(topology);
    for (k = 0; k < VERTICES; ++k) {
        weight[k] = 1;
        residual[k] = 0.001 * k;
    }
    if (CHECK_CALL(mien_registration_create(session, topology, &weights, &residuals, NULL,
                                            MIEN_QUALITY_DOUBTFUL, &fit, &error)))
        CHECK_CALL(
            mien_registration_save(session, fit, path_of("registration.safetensors"), &error));
    if (CHECK_CALL(mien_blendshape_model_train(session, path_of("dataset.safetensors"), "grin",
                                               NULL, &shapes, &error)))
        CHECK_CALL(mien_blendshape_model_save(session, shapes, path_of("blendshapes.safetensors"),
                                              &error));
    mien_shard_options_init(&part, sizeof part);
    part.part_count = 2;
    for (part.part = 0; part.part < 2; ++part.part)
        CHECK_CALL(mien_expression_shard_create(
            session, path_of("dataset.safetensors"), &part,
            path_of(part.part == 0 ? "shard_0.safetensors" : "shard_1.safetensors"), &error));
    write_texts(topology);
    mien_blendshape_model_release(shapes);
    mien_registration_release(fit);
    mien_mesh_release(topology);
}

int main(int argc, char** argv) {
    mien_mesh* face;
    folder = argc > 1 ? argv[1] : ".";
    printing = argc > 2 && strcmp(argv[2], "print") == 0;
    memset(&error, 0, sizeof error);
    error.struct_size = sizeof error;
    if (!CHECK_CALL(mien_session_create(MIEN_ABI_VERSION, &session, &error))) return 1;
    if (argc > 3 && strcmp(argv[2], "write") == 0) {
        source = argv[3];
        write_folder();
    } else if ((face = read_template()) != NULL) {
        check_registration(face);
        check_blendshapes(face);
        check_shards();
        check_texts(face);
        check_network(face);
        mien_mesh_release(face);
    }
    mien_session_release(session);
    printf("%d failures\n", failures);
    return failures != 0;
}
