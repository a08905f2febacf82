/* Mien: what every header needs. C99 (and C89 with <stdint.h>), any C++. */
#ifndef MIEN_CONFIG_H
#define MIEN_CONFIG_H

#include <stddef.h>
#include <stdint.h>

#define MIEN_VERSION_MAJOR 0
#define MIEN_VERSION_MINOR 2
#define MIEN_VERSION_PATCH 0
#define MIEN_VERSION_STRING "0.2.0"

/** The ABI that these headers describe; mien_session_create() refuses a library of another one. */
#define MIEN_ABI_VERSION 0u

/* MIEN_STATIC: linked statically. MIEN_BUILD: set while the library itself is built. */
#if defined(_WIN32) && !defined(MIEN_STATIC)
#if defined(MIEN_BUILD)
#define MIEN_API __declspec(dllexport)
#else
#define MIEN_API __declspec(dllimport)
#endif
#elif defined(__GNUC__) && !defined(MIEN_STATIC)
#define MIEN_API __attribute__((visibility("default")))
#else
#define MIEN_API
#endif

#if defined(_WIN32)
#define MIEN_CALL __cdecl
#else
#define MIEN_CALL
#endif

#endif
