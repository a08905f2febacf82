/* The JNI library: one C function per method of mien.Native. It holds no state. A failed call
 * throws and returns at once; after an upcall the pending exception is checked before anything else
 * is done. */
#include <jni.h>
#include <mien/mien.h>

#include <stdlib.h>
#include <string.h>

#define NATIVE(type, name) JNIEXPORT type JNICALL Java_mien_Native_##name
#define HANDLE(type, number) ((type*)(intptr_t)(number))

static mien_error fresh(void) {
    mien_error error;
    memset(&error, 0, sizeof error);
    error.struct_size = sizeof error;
    return error;
}

static jbyteArray bytes_of(JNIEnv* env, const char* text) {
    const jsize length = (jsize)strlen(text);
    jbyteArray bytes = (*env)->NewByteArray(env, length);
    if (bytes != NULL) (*env)->SetByteArrayRegion(env, bytes, 0, length, (const jbyte*)text);
    return bytes;
}

/* Throws what the record says, unless a callback's exception is on its way already. */
static void throw_error(JNIEnv* env, const mien_error* error) {
    jclass kind;
    jbyteArray message;
    jobject exception;
    if ((*env)->ExceptionCheck(env)) return;
    if (error->status == MIEN_E_CANCELLED) {
        kind = (*env)->FindClass(env, "java/util/concurrent/CancellationException");
        if (kind != NULL) (*env)->ThrowNew(env, kind, "cancelled");
        return;
    }
    kind = (*env)->FindClass(env, "mien/MienException");
    if (kind == NULL) return;
    message = bytes_of(env, error->message);
    if (message == NULL) return;
    exception = (*env)->NewObject(env, kind, (*env)->GetMethodID(env, kind, "<init>", "(IJ[B)V"),
                                  (jint)error->status, (jlong)error->detail_index, message);
    if (exception != NULL) (*env)->Throw(env, (jthrowable)exception);
}

static void throw_argument(JNIEnv* env, const char* message) {
    jclass kind = (*env)->FindClass(env, "java/lang/IllegalArgumentException");
    if (kind != NULL) (*env)->ThrowNew(env, kind, message);
}

/* A copy of zero-terminated UTF-8 bytes, or null with an exception pending. */
static char* text_of(JNIEnv* env, jbyteArray bytes) {
    jsize length = bytes == NULL ? 0 : (*env)->GetArrayLength(env, bytes);
    char* text = (char*)malloc((size_t)length + 1);
    if (text == NULL) {
        throw_argument(env, "out of memory");
        return NULL;
    }
    if (length > 0) (*env)->GetByteArrayRegion(env, bytes, 0, length, (jbyte*)text);
    text[length] = '\0';
    return text;
}

/* The memory of a direct buffer that holds at least `size` bytes, or null with an exception
 * pending. */
static void* memory_of(JNIEnv* env, jobject buffer, jlong size) {
    void* memory = buffer == NULL ? NULL : (*env)->GetDirectBufferAddress(env, buffer);
    if (memory == NULL || size < 0 || (*env)->GetDirectBufferCapacity(env, buffer) < size) {
        throw_argument(env, "a direct buffer with enough room is needed");
        return NULL;
    }
    return memory;
}

typedef struct {
    JNIEnv* env; /* callbacks come on the calling thread only */
    jobject progress;
    jmethodID report;
} upcall;

static int32_t MIEN_CALL on_progress(void* user, int32_t stage, double fraction) {
    upcall* call = (upcall*)user;
    jboolean go_on = (*call->env)
                         ->CallBooleanMethod(call->env, call->progress, call->report, (jint)stage,
                                             (jdouble)fraction);
    return (*call->env)->ExceptionCheck(call->env) || !go_on;
}

static upcall upcall_to(JNIEnv* env, jobject progress) {
    upcall call;
    call.env = env;
    call.progress = progress;
    call.report = progress == NULL ? NULL
                                   : (*env)->GetMethodID(env, (*env)->GetObjectClass(env, progress),
                                                         "report", "(ID)Z");
    return call;
}

NATIVE(void, release)(JNIEnv* env, jclass self, jint kind, jlong handle) {
    (void)env;
    (void)self;
    switch (kind) {
        case 0:
            mien_session_release(HANDLE(mien_session, handle));
            break;
        case 1:
            mien_cancel_release(HANDLE(mien_cancel, handle));
            break;
        case 2:
            mien_mesh_release(HANDLE(mien_mesh, handle));
            break;
        case 3:
            mien_model_release(HANDLE(mien_model, handle));
            break;
        case 4:
            mien_expression_model_release(HANDLE(mien_expression_model, handle));
            break;
        case 5:
            mien_registration_release(HANDLE(mien_registration, handle));
            break;
        case 6:
            mien_neutralization_release(HANDLE(mien_neutralization, handle));
            break;
        default:
            break;
    }
}

NATIVE(jbyteArray, version)(JNIEnv* env, jclass self) {
    (void)self;
    return bytes_of(env, mien_version_string());
}
NATIVE(jbyteArray, statusName)(JNIEnv* env, jclass self, jint status) {
    (void)self;
    return bytes_of(env, mien_status_name(status));
}

NATIVE(jlong, sessionCreate)(JNIEnv* env, jclass self, jint threads, jlong max_bytes) {
    mien_error error = fresh();
    mien_session_options options;
    mien_session* session = NULL;
    (void)self;
    mien_session_options_init(&options, sizeof options);
    options.num_threads = threads;
    options.max_bytes = (uint64_t)max_bytes;
    if (mien_session_create_with_options(MIEN_ABI_VERSION, &options, &session, &error))
        throw_error(env, &error);
    return (jlong)(intptr_t)session;
}

NATIVE(jlong, cancelCreate)(JNIEnv* env, jclass self) {
    mien_error error = fresh();
    mien_cancel* cancel = NULL;
    (void)self;
    if (mien_cancel_create(&cancel, &error)) throw_error(env, &error);
    return (jlong)(intptr_t)cancel;
}

NATIVE(void, cancelRequest)(JNIEnv* env, jclass self, jlong cancel) {
    (void)env;
    (void)self;
    mien_cancel_request(HANDLE(mien_cancel, cancel));
}

NATIVE(jlong, meshCreate)
(JNIEnv* env, jclass self, jlong session, jobject positions, jint vertices, jobject triangles,
 jint triangle_count) {
    mien_error error = fresh();
    mien_mesh_arrays arrays;
    mien_mesh* mesh = NULL;
    (void)self;
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    arrays.positions.data = memory_of(env, positions, 12 * (jlong)vertices);
    if (arrays.positions.data == NULL) return 0;
    arrays.positions.count = (uint64_t)vertices;
    arrays.positions.dtype = MIEN_DTYPE_F32;
    if (triangles != NULL) {
        arrays.triangles = (const uint32_t*)memory_of(env, triangles, 12 * (jlong)triangle_count);
        if (arrays.triangles == NULL) return 0;
        arrays.triangle_count = (uint64_t)triangle_count;
    }
    if (mien_mesh_create(HANDLE(mien_session, session), &arrays, &mesh, &error))
        throw_error(env, &error);
    return (jlong)(intptr_t)mesh;
}

/* The three loaders differ in nothing but their type. */
#define LOADER(method, type, function)                                                             \
    NATIVE(jlong, method)(JNIEnv * env, jclass self, jlong session, jbyteArray path) {             \
        mien_error error = fresh();                                                                \
        type* out = NULL;                                                                          \
        char* text = text_of(env, path);                                                           \
        (void)self;                                                                                \
        if (text == NULL) return 0;                                                                \
        if (function(HANDLE(mien_session, session), text, &out, &error)) throw_error(env, &error); \
        free(text);                                                                                \
        return (jlong)(intptr_t)out;                                                               \
    }
LOADER(meshLoad, mien_mesh, mien_mesh_load)
LOADER(modelLoad, mien_model, mien_model_load)
LOADER(expressionModelLoad, mien_expression_model, mien_expression_model_load)

NATIVE(void, meshSave)(JNIEnv* env, jclass self, jlong session, jlong mesh, jbyteArray path) {
    mien_error error = fresh();
    char* text = text_of(env, path);
    (void)self;
    if (text == NULL) return;
    if (mien_mesh_save(HANDLE(mien_session, session), HANDLE(mien_mesh, mesh), text, &error))
        throw_error(env, &error);
    free(text);
}

NATIVE(jlong, meshVertices)(JNIEnv* env, jclass self, jlong mesh) {
    mien_error error = fresh();
    uint64_t count = 0;
    (void)self;
    if (mien_mesh_get_counts(HANDLE(mien_mesh, mesh), &count, NULL, &error))
        throw_error(env, &error);
    return (jlong)count;
}

NATIVE(void, meshPositions)(JNIEnv* env, jclass self, jlong mesh, jobject floats, jint vertices) {
    mien_error error = fresh();
    void* memory = memory_of(env, floats, 12 * (jlong)vertices);
    (void)self;
    if (memory == NULL) return;
    if (mien_mesh_get_positions(HANDLE(mien_mesh, mesh), MIEN_DTYPE_F32, memory, (uint64_t)vertices,
                                NULL, &error))
        throw_error(env, &error);
}

NATIVE(jlong, register)
(JNIEnv* env, jclass self, jlong session, jlong model, jlong scan, jobjectArray names,
 jdoubleArray positions, jobject progress, jlong cancel) {
    mien_error error = fresh();
    mien_register_options options;
    mien_registration* out = NULL;
    const jsize count = (*env)->GetArrayLength(env, names);
    mien_scan_landmark* landmarks =
        (mien_scan_landmark*)calloc((size_t)count + 1, sizeof *landmarks);
    upcall call = upcall_to(env, progress);
    jsize i;
    (void)self;
    if (landmarks == NULL) {
        throw_argument(env, "out of memory");
        return 0;
    }
    for (i = 0; i < count && !(*env)->ExceptionCheck(env); ++i) {
        jbyteArray name = (jbyteArray)(*env)->GetObjectArrayElement(env, names, i);
        landmarks[i].name = text_of(env, name);
        (*env)->DeleteLocalRef(env, name);
        (*env)->GetDoubleArrayRegion(env, positions, 3 * i, 3, landmarks[i].position);
    }
    if (!(*env)->ExceptionCheck(env)) {
        mien_register_options_init(&options, sizeof options);
        options.landmarks = count == 0 ? NULL : landmarks;
        options.landmark_count = (uint64_t)count;
        options.progress = progress == NULL ? NULL : on_progress;
        options.progress_user = &call;
        options.cancel = HANDLE(mien_cancel, cancel);
        if (mien_register(HANDLE(mien_session, session), HANDLE(mien_model, model),
                          HANDLE(mien_mesh, scan), &options, &out, &error))
            throw_error(env, &error);
    }
    for (i = 0; i < count; ++i) free((void*)(intptr_t)landmarks[i].name);
    free(landmarks);
    return (jlong)(intptr_t)out;
}

static void fill(mien_neutralize_options* options, upcall* call, jlong cancel) {
    mien_neutralize_options_init(options, sizeof *options);
    options->progress = call->progress == NULL ? NULL : on_progress;
    options->progress_user = call;
    options->cancel = HANDLE(mien_cancel, cancel);
}

NATIVE(jlong, neutralize)
(JNIEnv* env, jclass self, jlong session, jlong model, jlong registration, jobject progress,
 jlong cancel) {
    mien_error error = fresh();
    mien_neutralize_options options;
    mien_neutralization* out = NULL;
    upcall call = upcall_to(env, progress);
    (void)self;
    fill(&options, &call, cancel);
    if (mien_neutralize(HANDLE(mien_session, session), HANDLE(mien_expression_model, model),
                        HANDLE(mien_registration, registration), &options, &out, &error))
        throw_error(env, &error);
    return (jlong)(intptr_t)out;
}

NATIVE(jlong, neutralizeMesh)
(JNIEnv* env, jclass self, jlong session, jlong model, jlong mesh, jobject progress, jlong cancel) {
    mien_error error = fresh();
    mien_neutralize_options options;
    mien_neutralization* out = NULL;
    upcall call = upcall_to(env, progress);
    (void)self;
    fill(&options, &call, cancel);
    if (mien_neutralize_mesh(HANDLE(mien_session, session), HANDLE(mien_expression_model, model),
                             HANDLE(mien_mesh, mesh), &options, &out, &error))
        throw_error(env, &error);
    return (jlong)(intptr_t)out;
}

/* A mesh that something else owns, with one more reference for the Java object. */
static jlong shared(const mien_mesh* mesh) {
    mien_mesh_retain((mien_mesh*)(intptr_t)mesh);
    return (jlong)(intptr_t)mesh;
}

NATIVE(jlong, registrationMesh)(JNIEnv* env, jclass self, jlong registration) {
    (void)env;
    (void)self;
    return shared(mien_registration_mesh(HANDLE(mien_registration, registration)));
}

NATIVE(jlong, neutralizationMesh)(JNIEnv* env, jclass self, jlong neutralization) {
    (void)env;
    (void)self;
    return shared(mien_neutralization_mesh(HANDLE(mien_neutralization, neutralization)));
}

NATIVE(jdouble, absoluteVolume)
(JNIEnv* env, jclass self, jlong session, jlong before, jlong after) {
    mien_error error = fresh();
    mien_measurement* measurement = NULL;
    mien_zone_volume volume;
    (void)self;
    memset(&volume, 0, sizeof volume);
    volume.struct_size = sizeof volume;
    if (mien_measure_volume(HANDLE(mien_session, session), HANDLE(mien_mesh, before),
                            HANDLE(mien_mesh, after), NULL, &measurement, &error) ||
        mien_measurement_get_volume(measurement, MIEN_ZONE_WHOLE, &volume, &error))
        throw_error(env, &error);
    mien_measurement_release(measurement);
    return volume.absolute_ml;
}
