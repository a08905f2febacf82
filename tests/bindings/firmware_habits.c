/* What an embedded host asks of a library: it can be loaded and unloaded for ever, works on small
 * stacks, under a foreign decimal point and with an empty environment, prints nothing, starts no
 * thread that was not asked for, writes no file, needs no disk, and keeps its memory budget. */
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <locale.h>
#include <mien/mien.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static int faults = 0;
static int report; /* where this program itself prints */

static void check(int good, const char* what) {
    if (good) return;
    ++faults;
    dprintf(report, "FAILED: %s\n", what);
}

/* The few functions that this host uses, looked up by name as a plug-in host does. */
typedef struct {
    mien_status(MIEN_CALL* session_create)(uint32_t, const mien_session_options*, mien_session**,
                                           mien_error*);
    void(MIEN_CALL* session_options_init)(mien_session_options*, size_t);
    void(MIEN_CALL* session_release)(mien_session*);
    void(MIEN_CALL* arrays_init)(mien_mesh_arrays*, size_t);
    mien_status(MIEN_CALL* mesh_create)(mien_session*, const mien_mesh_arrays*, mien_mesh**,
                                        mien_error*);
    void(MIEN_CALL* mesh_release)(mien_mesh*);
    void(MIEN_CALL* model_options_init)(mien_model_options*, size_t);
    mien_status(MIEN_CALL* model_build)(mien_session*, const mien_mesh*, const mien_model_options*,
                                        mien_model**, mien_error*);
    mien_status(MIEN_CALL* model_json)(const mien_model*, char*, uint64_t, uint64_t*, mien_error*);
    void(MIEN_CALL* model_release)(mien_model*);
} api;

#define FIND(field, name) \
    (*(void**)& found.field = dlsym(library, name), check(found.field != NULL, name))

static api functions_of(void* library) {
    api found;
    memset(&found, 0, sizeof found);
    FIND(session_create, "mien_session_create_with_options");
    FIND(session_options_init, "mien_session_options_init");
    FIND(session_release, "mien_session_release");
    FIND(arrays_init, "mien_mesh_arrays_init");
    FIND(mesh_create, "mien_mesh_create");
    FIND(mesh_release, "mien_mesh_release");
    FIND(model_options_init, "mien_model_options_init");
    FIND(model_build, "mien_model_build");
    FIND(model_json, "mien_model_get_json");
    FIND(model_release, "mien_model_release");
    return found;
}

enum { SIDE = 24 };

static int entries(const char* folder) {
    int count = 0;
    DIR* listing = opendir(folder);
    if (listing == NULL) return -1;
    while (readdir(listing) != NULL) ++count;
    closedir(listing);
    return count;
}

/* Builds a small model: meshes, sparse factors, dense products, JSON. Returns the status. */
static mien_status work(const api* mien, uint64_t max_bytes, char* json, size_t room) {
    static float positions[3 * SIDE * SIDE];
    static uint32_t triangles[6 * (SIDE - 1) * (SIDE - 1)];
    mien_session* session = NULL;
    mien_mesh* mesh = NULL;
    mien_model* model = NULL;
    mien_error error;
    mien_session_options settings;
    mien_mesh_arrays arrays;
    mien_model_options options;
    uint32_t* corner = triangles;
    int x, y;
    memset(&error, 0, sizeof error);
    error.struct_size = sizeof error;
    for (y = 0; y < SIDE; ++y)
        for (x = 0; x < SIDE; ++x) {
            float* p = positions + 3 * (y * SIDE + x);
            p[0] = 5.0f * (float)x;
            p[1] = 5.0f * (float)y;
            p[2] = 0.05f * (float)(x * y);
        }
    for (y = 0; y + 1 < SIDE; ++y)
        for (x = 0; x + 1 < SIDE; ++x) {
            const uint32_t a = (uint32_t)(y * SIDE + x),
                           quad[6] = {a, a + 1, a + SIDE + 1, a, a + SIDE + 1, a + SIDE};
            memcpy(corner, quad, sizeof quad);
            corner += 6;
        }
    mien->session_options_init(&settings, sizeof settings);
    settings.max_bytes = max_bytes;
    mien->arrays_init(&arrays, sizeof arrays);
    arrays.positions.data = positions;
    arrays.positions.count = SIDE * SIDE;
    arrays.positions.dtype = MIEN_DTYPE_F32;
    arrays.triangles = triangles;
    arrays.triangle_count = 2 * (SIDE - 1) * (SIDE - 1);
    mien->model_options_init(&options, sizeof options);
    options.num_modes = 30;
    if (mien->session_create(MIEN_ABI_VERSION, &settings, &session, &error) == MIEN_OK &&
        mien->mesh_create(session, &arrays, &mesh, &error) == MIEN_OK &&
        mien->model_build(session, mesh, &options, &model, &error) == MIEN_OK && json != NULL) {
        uint64_t size = 0;
        check(entries("/proc/self/task") == 3,
              "a thread was started that nobody asked for"); /* ., .. and one */
        mien->model_json(model, json, room, &size, &error);
    }
    mien->model_release(model);
    mien->mesh_release(mesh);
    mien->session_release(session);
    return error.status;
}

static mien_status small_stack_status;

static void* on_small_stack(void* mien) {
    small_stack_status = work((const api*)mien, 0, NULL, 0);
    return NULL;
}

static long mapped_kilobytes(void) {
    long size = 0, resident = 0;
    FILE* file = fopen("/proc/self/statm", "r");
    if (file != NULL && fscanf(file, "%ld %ld", &size, &resident) != 2) size = 0;
    if (file != NULL) fclose(file);
    return size * 4;
}

int main(int argc, char** argv) {
    char name[] = "firmware-heard-XXXXXX", json[2][65536] = {"", ""}, folder[4096];
    int heard, round, files;
    long before = 0;
    pthread_attr_t attributes;
    pthread_t thread;
    struct rlimit disk, no_disk;
    void* library;
    api mien;
    if (argc < 2 || realpath(argv[1], folder) == NULL) return 2;
    report = dup(1);
    heard = mkstemp(name);
    if (heard < 0) return 2; /* the working folder is the test's own */
    unlink(name);
    dup2(heard, 1);
    dup2(heard, 2);
    clearenv();

    /* Loaded and unloaded a hundred times: gone each time, and nothing is left behind. */
    for (round = 0; round < 100; ++round) {
        library = dlopen(folder, RTLD_NOW | RTLD_LOCAL);
        if (library == NULL) {
            dprintf(report, "FAILED: %s\n", dlerror());
            return 1;
        }
        mien = functions_of(library);
        if (faults != 0) return 1;
        if (round % 20 == 0)
            check(work(&mien, 0, NULL, 0) == MIEN_OK, "a model cannot be built after a reload");
        dlclose(library);
        if (round == 19) before = mapped_kilobytes();
    }
    check(dlopen(folder, RTLD_NOW | RTLD_NOLOAD) == NULL, "the library stays mapped after dlclose");
    /* The C++ runtime, when it goes with the library, leaves its 72 kB pool for exceptions behind
     * each time. */
    check(mapped_kilobytes() < before + 80 * 100, "reloading leaks memory");

    library = dlopen(folder, RTLD_NOW | RTLD_LOCAL);
    mien = functions_of(library);
    files = entries(".");
    check(work(&mien, 0, json[0], sizeof json[0]) == MIEN_OK, "a model cannot be built");

    /* A decimal comma must change nothing. The second argument is where the locale was made. */
    if (argc > 2) setenv("LOCPATH", argv[2], 1);
    if (setlocale(LC_ALL, "de_DE.UTF-8") != NULL || setlocale(LC_ALL, "de_DE.utf8") != NULL) {
        char comma[8];
        snprintf(comma, sizeof comma, "%.1f", 0.5);
        check(strcmp(comma, "0,5") == 0, "the test's own locale has no comma");
        check(work(&mien, 0, json[1], sizeof json[1]) == MIEN_OK,
              "a model cannot be built under de_DE");
        check(strcmp(json[0], json[1]) == 0, "the report differs under de_DE");
        setlocale(LC_ALL, "C");
    } else
        dprintf(report, "skipped: no locale de_DE.UTF-8 here\n");

    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, 256 * 1024);
    check(pthread_create(&thread, &attributes, on_small_stack, &mien) == 0,
          "cannot start a thread");
    pthread_join(thread, NULL);
    check(small_stack_status == MIEN_OK, "a model cannot be built on a stack of 256 KiB");

    /* No disk: every write to a file fails. */
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &disk);
    no_disk = disk;
    no_disk.rlim_cur = 0;
    setrlimit(RLIMIT_FSIZE, &no_disk);
    check(work(&mien, 0, NULL, 0) == MIEN_OK, "a model cannot be built without a disk to write to");
    setrlimit(RLIMIT_FSIZE, &disk);

    check(work(&mien, 20000, NULL, 0) == MIEN_E_MEMORY_BUDGET, "a budget of 20 kB is not kept");
    check(work(&mien, 0, NULL, 0) == MIEN_OK, "a model cannot be built after a refused one");
    check(entries(".") == files, "a file was left in the working folder");
    dlclose(library);

    fflush(NULL);
    check(lseek(heard, 0, SEEK_END) == 0, "the library printed something");
    dprintf(report, "%s\n",
            faults == 0 ? "loads, unloads, works in small places, keeps quiet" : "see above");
    return faults != 0;
}
