#include "base/file.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

#include "base/error.hpp"
#include "base/file_system.hpp"
#include "base/memory_budget.hpp"

#if !defined(_WIN32)
#include <sys/mman.h>
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

namespace file_system {

void check_path(const std::string& path) {
    if (path.empty()) fail(Status::invalid_argument, "the path of the file is empty");
    if (path.find('\0') != std::string::npos)
        fail(Status::invalid_argument, "the path '%s' contains a zero byte",
             shown_path(path).c_str());
}

#if defined(_WIN32)

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

#endif

}  // namespace file_system

namespace {

using namespace file_system;

#if defined(_WIN32)

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
    std::shared_ptr<char> copy = counted_block(file.size);
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

}  // namespace mien
