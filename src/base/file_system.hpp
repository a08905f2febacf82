// What reading and writing share: the system's headers, paths, and its errors in our own words,
// because the system's depend on the locale. Included by file.cpp and atomic_file.cpp alone.
#pragma once

#include <cerrno>
#include <cstddef>
#include <string>

#if defined(_WIN32)
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#else
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace mien::file_system {

/// One system call moves at most this much: some systems fail beyond 2 GB.
constexpr std::size_t kLargestCall = std::size_t(1) << 26;

/// Throws Status::invalid_argument for a path that is empty or holds a zero byte.
void check_path(const std::string& path);

#if defined(_WIN32)
using NativePath = std::wstring;
/// Throws Status::invalid_argument for a path that is not UTF-8.
NativePath native(const std::string& path);
[[noreturn]] void fail_io(const char* action, const std::string& path, DWORD code);
#else
[[noreturn]] void fail_io(const char* action, const std::string& path, int code);
#endif

}  // namespace mien::file_system
