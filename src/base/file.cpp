#include "base/file.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <new>

#include "base/error.hpp"

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
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#endif

namespace mien {

std::string shown_path(const std::string& path) {
    constexpr std::size_t kLongest = 110;
    std::string shown = path;
    if (shown.size() > kLongest) {
        std::size_t cut = shown.size() - kLongest;
        while (cut < shown.size() && (static_cast<unsigned char>(shown[cut]) & 0xc0) == 0x80) ++cut;
        shown = "..." + shown.substr(cut);
    }
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return shown;
}

namespace {

constexpr std::size_t kBufferBytes = std::size_t(1) << 18;
/// One system call moves at most this much: some systems fail beyond 2 GB.
constexpr std::size_t kLargestCall = std::size_t(1) << 26;

void check_path(const std::string& path) {
    if (path.empty()) fail(Status::invalid_argument, "the path of the file is empty");
    if (path.find('\0') != std::string::npos)
        fail(Status::invalid_argument, "the path '%s' contains a zero byte",
             shown_path(path).c_str());
}

std::atomic<unsigned> temporary_counter{0};

std::string temporary_name(unsigned long process) {
    char name[64];
    std::snprintf(name, sizeof name, ".mien-%lu-%u.tmp", process, temporary_counter++);
    return name;
}

#if defined(_WIN32)

using NativePath = std::wstring;

NativePath native(const std::string& path) {
    check_path(path);
    const int size = static_cast<int>(path.size());
    const int wide =
        MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path.data(), size, nullptr, 0);
    if (wide <= 0)
        fail(Status::invalid_argument, "the path '%s' is not UTF-8", shown_path(path).c_str());
    NativePath result(static_cast<std::size_t>(wide), L'\0');
    MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path.data(), size, &result[0], wide);
    return result;
}

[[noreturn]] void fail_io(const char* action, const std::string& path, DWORD code) {
    const char* reason = nullptr;
    switch (code) {
        case ERROR_FILE_NOT_FOUND:
        case ERROR_PATH_NOT_FOUND:
            reason = "no such file or folder";
            break;
        case ERROR_ACCESS_DENIED:
            reason = "permission denied, or it is a folder";
            break;
        case ERROR_SHARING_VIOLATION:
            reason = "another program holds it open";
            break;
        case ERROR_DISK_FULL:
        case ERROR_HANDLE_DISK_FULL:
            reason = "the disk is full";
            break;
        case ERROR_INVALID_NAME:
            reason = "not a valid file name";
            break;
        default:
            break;
    }
    if (reason != nullptr)
        fail(Status::io, "cannot %s '%s': %s", action, shown_path(path).c_str(), reason);
    fail(Status::io, "cannot %s '%s': system error %lu", action, shown_path(path).c_str(), code);
}

class OpenFile {
  public:
    explicit OpenFile(const std::string& path) : path_(path) {
        handle_ =
            CreateFileW(native(path).c_str(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_DELETE,
                        nullptr, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
        if (handle_ == INVALID_HANDLE_VALUE) fail_io("open", path, GetLastError());
        LARGE_INTEGER bytes;
        if (GetFileType(handle_) != FILE_TYPE_DISK || !GetFileSizeEx(handle_, &bytes)) {
            CloseHandle(handle_);
            fail(Status::io, "'%s' is not a regular file", shown_path(path).c_str());
        }
        if (static_cast<unsigned long long>(bytes.QuadPart) >
            std::numeric_limits<std::size_t>::max() / 2) {
            CloseHandle(handle_);
            fail(Status::io, "'%s' is too large for this machine", shown_path(path).c_str());
        }
        size = static_cast<std::size_t>(bytes.QuadPart);
    }
    ~OpenFile() { CloseHandle(handle_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    std::size_t read(char* target, std::size_t bytes) {
        DWORD got = 0;
        if (!ReadFile(handle_, target, static_cast<DWORD>(bytes), &got, nullptr))
            fail_io("read", path_, GetLastError());
        return got;
    }
    std::shared_ptr<const void> map() {
        HANDLE mapping = CreateFileMappingW(handle_, nullptr, PAGE_READONLY, 0, 0, nullptr);
        if (mapping == nullptr) fail_io("map", path_, GetLastError());
        void* address = MapViewOfFile(mapping, FILE_MAP_READ, 0, 0, 0);
        const DWORD code = GetLastError();
        CloseHandle(mapping);
        if (address == nullptr) fail_io("map", path_, code);
        return std::shared_ptr<const void>(address, [](const void* p) { UnmapViewOfFile(p); });
    }

    std::size_t size = 0;

  private:
    const std::string& path_;
    HANDLE handle_;
};

#else

/// Own words: the system's depend on the locale.
[[noreturn]] void fail_io(const char* action, const std::string& path, int code) {
    const char* reason = nullptr;
    switch (code) {
        case ENOENT:
            reason = "no such file or folder";
            break;
        case EACCES:
        case EPERM:
            reason = "permission denied";
            break;
        case EROFS:
            reason = "the disk is read-only";
            break;
        case ENOSPC:
        case EDQUOT:
            reason = "the disk is full";
            break;
        case EFBIG:
            reason = "larger than the system allows";
            break;
        case EISDIR:
            reason = "it is a folder";
            break;
        case ENOTDIR:
            reason = "a part of the path is not a folder";
            break;
        case ENAMETOOLONG:
            reason = "the name is too long";
            break;
        case ELOOP:
            reason = "too many symbolic links";
            break;
        case EMFILE:
        case ENFILE:
            reason = "too many open files";
            break;
        case EIO:
            reason = "the disk reports an error";
            break;
        case ENOMEM:
            fail(Status::no_memory, "no memory to %s '%s'", action, shown_path(path).c_str());
        default:
            break;
    }
    if (reason != nullptr)
        fail(Status::io, "cannot %s '%s': %s", action, shown_path(path).c_str(), reason);
    fail(Status::io, "cannot %s '%s': system error %d", action, shown_path(path).c_str(), code);
}

class OpenFile {
  public:
    explicit OpenFile(const std::string& path) : path_(path) {
        check_path(path);
        // Without O_NONBLOCK, opening a pipe would wait for its other end.
        do descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        while (descriptor_ < 0 && errno == EINTR);
        if (descriptor_ < 0) fail_io("open", path, errno);
        struct stat info;
        const bool known = ::fstat(descriptor_, &info) == 0;
        if (!known || !S_ISREG(info.st_mode)) {
            ::close(descriptor_);
            if (known && S_ISDIR(info.st_mode)) fail_io("open", path, EISDIR);
            fail(Status::io, "'%s' is not a regular file", shown_path(path).c_str());
        }
        if (static_cast<unsigned long long>(info.st_size) >
            std::numeric_limits<std::size_t>::max() / 2) {
            ::close(descriptor_);
            fail(Status::io, "'%s' is too large for this machine", shown_path(path).c_str());
        }
        size = static_cast<std::size_t>(info.st_size);
    }
    ~OpenFile() { ::close(descriptor_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    std::size_t read(char* target, std::size_t bytes) {
        for (;;) {
            const ssize_t got = ::read(descriptor_, target, bytes);
            if (got >= 0) return static_cast<std::size_t>(got);
            if (errno != EINTR) fail_io("read", path_, errno);
        }
    }
    std::shared_ptr<const void> map() {
        const std::size_t bytes = size;
        void* address = ::mmap(nullptr, bytes, PROT_READ, MAP_SHARED, descriptor_, 0);
        if (address == MAP_FAILED) fail_io("map", path_, errno);
        return std::shared_ptr<const void>(
            address, [bytes](const void* p) { ::munmap(const_cast<void*>(p), bytes); });
    }

    std::size_t size = 0;

  private:
    const std::string& path_;
    int descriptor_ = -1;
};

#endif

}  // namespace

FileBytes map_file(const std::string& path) {
    OpenFile file(path);
    FileBytes bytes;
    if (file.size == 0) return bytes;
    bytes.storage = file.map();
    bytes.data = static_cast<const char*>(bytes.storage.get());
    bytes.size = file.size;
    return bytes;
}

void release_pages(const void* data, std::size_t size) {
#if defined(_WIN32)
    (void)data;
    (void)size;
#else
    const std::uintptr_t page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(data);
    const std::uintptr_t first = (begin + page - 1) / page * page,
                         last = (begin + size) / page * page;
    // The mapping is read-only and backed by its file: dropping its pages loses nothing.
    if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED);
#endif
}

FileBytes read_whole_file(const std::string& path, const Context& context) {
    OpenFile file(path);
    context.require_memory(file.size, "reading a file");
    FileBytes bytes;
    if (file.size == 0) return bytes;
    std::shared_ptr<char> copy(new char[file.size], std::default_delete<char[]>());
    while (bytes.size < file.size) {
        context.check_cancelled();
        const std::size_t got =
            file.read(copy.get() + bytes.size, std::min(kLargestCall, file.size - bytes.size));
        if (got == 0) break;  // it became shorter: what is left is judged by its reader
        bytes.size += got;
    }
    bytes.data = copy.get();
    bytes.storage = std::move(copy);
    return bytes;
}

#if defined(_WIN32)

struct AtomicFile::State {
    std::string path;
    NativePath target, temporary;
    HANDLE handle = INVALID_HANDLE_VALUE;
    std::unique_ptr<char[]> buffer;
    std::size_t filled = 0;

    explicit State(const std::string& p) : path(p), target(native(p)) {
        const DWORD attributes = GetFileAttributesW(target.c_str());
        if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY))
            fail(Status::io, "cannot write '%s': it is a folder", shown_path(path).c_str());
        const std::size_t slash = target.find_last_of(L"/\\:");
        const NativePath folder =
            slash == NativePath::npos ? NativePath() : target.substr(0, slash + 1);
        for (;;) {
            const std::string name = temporary_name(GetCurrentProcessId());
            temporary = folder + NativePath(name.begin(), name.end());
            handle = CreateFileW(temporary.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW,
                                 FILE_ATTRIBUTE_NORMAL, nullptr);
            if (handle != INVALID_HANDLE_VALUE) return;
            if (GetLastError() != ERROR_FILE_EXISTS) fail_io("create", path, GetLastError());
        }
    }
    ~State() {
        if (handle != INVALID_HANDLE_VALUE) CloseHandle(handle);
        if (!temporary.empty()) DeleteFileW(temporary.c_str());
    }
    void put(const char* data, std::size_t size) {
        while (size != 0) {
            DWORD done = 0;
            if (!WriteFile(handle, data, static_cast<DWORD>(std::min(size, kLargestCall)), &done,
                           nullptr))
                fail_io("write", path, GetLastError());
            data += done;
            size -= done;
        }
    }
    void finish() {
        if (!FlushFileBuffers(handle)) fail_io("write", path, GetLastError());
        const bool closed = CloseHandle(handle) != 0;
        handle = INVALID_HANDLE_VALUE;
        if (!closed || !MoveFileExW(temporary.c_str(), target.c_str(),
                                    MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH))
            fail_io("replace", path, GetLastError());
        temporary.clear();
    }
};

#else

struct AtomicFile::State {
    std::string path, target, temporary, folder;
    int descriptor = -1;
    std::unique_ptr<char[]> buffer;
    std::size_t filled = 0;

    explicit State(const std::string& p) : path(p), target(p) {
        check_path(path);
        struct stat info;
        const bool exists = ::stat(path.c_str(), &info) == 0;
        if (exists && S_ISDIR(info.st_mode)) fail_io("write", path, EISDIR);
        if (exists && !S_ISREG(info.st_mode))
            fail(Status::io, "cannot write '%s': it is not a regular file",
                 shown_path(path).c_str());
        if (exists) {
            std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr),
                                                        std::free);
            if (real != nullptr) target = real.get();
        }
        const std::size_t slash = target.rfind('/');
        folder = slash == std::string::npos ? "." : target.substr(0, slash + 1);
        const std::string prefix = slash == std::string::npos ? "" : folder;
        do {
            temporary = prefix + temporary_name(static_cast<unsigned long>(::getpid()));
            descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        } while (descriptor < 0 && (errno == EEXIST || errno == EINTR));
        if (descriptor < 0) {
            const int code = errno;
            temporary.clear();
            fail_io("create", path, code);
        }
        // A file system without permissions refuses, and the file is fine all the same.
        if (exists && ::fchmod(descriptor, info.st_mode & 07777) != 0) errno = 0;
    }
    ~State() {
        if (descriptor >= 0) ::close(descriptor);
        if (!temporary.empty()) ::unlink(temporary.c_str());
    }
    void put(const char* data, std::size_t size) {
        while (size != 0) {
            const ssize_t done = ::write(descriptor, data, std::min(size, kLargestCall));
            if (done < 0 && errno == EINTR) continue;
            if (done < 0) fail_io("write", path, errno);
            data += done;
            size -= static_cast<std::size_t>(done);
        }
    }
    void finish() {
        // Some network file systems cannot flush (EINVAL); a failed flush of data they can is real.
        if (::fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP)
            fail_io("write", path, errno);
        const int closed = ::close(descriptor);
        const int code = errno;
        descriptor = -1;
        if (closed != 0 && code != EINTR) fail_io("write", path, code);
        if (::rename(temporary.c_str(), target.c_str()) != 0) fail_io("replace", path, errno);
        temporary.clear();
        // The new name itself reaches the disk with its folder; a folder that refuses is no error.
        const int folder_descriptor = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
        if (folder_descriptor >= 0) {
            (void)::fsync(folder_descriptor);
            ::close(folder_descriptor);
        }
    }
};

#endif

// The destructor of a half-built State does not run, so the buffer comes before the file exists.
AtomicFile::AtomicFile(const std::string& path) {
    std::unique_ptr<char[]> buffer(new char[kBufferBytes]);
    state_ = std::make_unique<State>(path);
    state_->buffer = std::move(buffer);
}

AtomicFile::~AtomicFile() = default;

void AtomicFile::write(const void* data, std::size_t size) {
    State& s = *state_;
    if (size >= kBufferBytes - s.filled) {
        s.put(s.buffer.get(), s.filled);
        s.filled = 0;
    }
    if (size >= kBufferBytes) {
        s.put(static_cast<const char*>(data), size);
    } else if (size != 0) {
        std::memcpy(s.buffer.get() + s.filled, data, size);
        s.filled += size;
    }
}

void AtomicFile::commit() {
    State& s = *state_;
    s.put(s.buffer.get(), s.filled);
    s.filled = 0;
    s.finish();
}

}  // namespace mien
