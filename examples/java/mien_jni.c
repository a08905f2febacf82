/* The JNI library: raw functions with numbers for addresses and handles (mien/Raw.java); what is
 * done with them stands in the Java classes. It holds no state but the virtual machine. */
#include <jni.h>
#include <mien/mien.h>

#define STATIC_CHECK(condition, name) typedef char name[(condition) ? 1 : -1]

static JavaVM* machine;

JNIEXPORT jint JNICALL JNI_OnLoad(JavaVM* vm, void* reserved) {
    (void)reserved;
    machine = vm;
    return JNI_VERSION_1_8;
}

/* Callbacks come on the calling thread, which is Java's. */
static JNIEnv* environment(void) {
    void* env = NULL;
    return (*machine)->GetEnv(machine, &env, JNI_VERSION_1_8) == JNI_OK ? (JNIEnv*)env : NULL;
}

static int32_t MIEN_CALL on_progress(void* user, int32_t stage, double fraction) {
    JNIEnv* env = environment();
    jclass callbacks = env == NULL ? NULL : (*env)->FindClass(env, "mien/Callbacks");
    jmethodID method =
        callbacks == NULL ? NULL : (*env)->GetStaticMethodID(env, callbacks, "progress", "(JID)I");
    jint answer = 1;
    if (method != NULL) {
        answer = (*env)->CallStaticIntMethod(env, callbacks, method, (jlong)(intptr_t)user,
                                             (jint)stage, (jdouble)fraction);
        if ((*env)->ExceptionCheck(env)) answer = 1;
    }
    if (callbacks != NULL) (*env)->DeleteLocalRef(env, callbacks);
    return answer;
}

static void MIEN_CALL on_log(void* user, int32_t level, const char* message) {
    JNIEnv* env = environment();
    jclass callbacks = env == NULL ? NULL : (*env)->FindClass(env, "mien/Callbacks");
    jmethodID method =
        callbacks == NULL ? NULL : (*env)->GetStaticMethodID(env, callbacks, "log", "(JIJ)V");
    if (method != NULL) {
        (*env)->CallStaticVoidMethod(env, callbacks, method, (jlong)(intptr_t)user, (jint)level,
                                     (jlong)(intptr_t)message);
        if ((*env)->ExceptionCheck(env)) (*env)->ExceptionClear(env);
    }
    if (callbacks != NULL) (*env)->DeleteLocalRef(env, callbacks);
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_address(JNIEnv* env, jobject self, jobject memory) {
    (void)self;
    return (jlong)(intptr_t)(*env)->GetDirectBufferAddress(env, memory);
}

JNIEXPORT jobject JNICALL Java_mien_RawJni_memory(JNIEnv* env, jobject self, jlong address,
                                                  jlong bytes) {
    (void)self;
    return (*env)->NewDirectByteBuffer(env, (void*)(intptr_t)address, bytes);
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_progressFunction(JNIEnv* env, jobject self) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)&on_progress;
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_logFunction(JNIEnv* env, jobject self) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)&on_log;
}

#include "mien_jni_functions.h"
