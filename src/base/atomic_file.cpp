// Writing so that a full disk, an error, a kill or a crash leaves the old file as it was, and
// nothing beside it.
//
// Where the system has files without a name (O_TMPFILE), the new bytes have one only from commit()
// on: a killed writer leaves nothing. Elsewhere, and for the moment between the two names of a
// replacement, the file is called .mien-HASH-K.tmp after its target and locked by its writer; what
// no one holds locked was left behind by a kill, and the next writer of the same target removes it.
#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/file_system.hpp"
#include "base/memory_budget.hpp"

#if !defined(_WIN32)
#include <pthread.h>
#include <sys/file.h>

#include <csignal>
#include <cstdlib>
#include <ctime>
#endif

namespace mien {

using namespace file_system;

namespace {

constexpr std::size_t kBufferBytes = std::size_t(1) << 18;
/// Writers of one target at a time whose leftovers are looked for.
constexpr unsigned kSlots = 8;
/// More writers of one target at a time are refused.
constexpr unsigned kMostSlots = 1000;

/// FNV-1a of the target's own name: two targets of a folder do not share their temporaries.
template <typename Text>
std::uint64_t hash_of(const Text& name) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const auto c : name) hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x100000001b3u;
    return hash;
}

template <typename Text>
Text slot_name(const Text& folder, const Text& target_name, unsigned slot) {
    char name[64];
    std::snprintf(name, sizeof name, ".mien-%016" PRIx64 "-%u.tmp", hash_of(target_name), slot);
    return folder + Text(name, name + std::strlen(name));
}

}  // namespace

#if defined(_WIN32)

struct AtomicFile::State {
    std::string path;
    NativePath target, temporary;
    HANDLE handle = INVALID_HANDLE_VALUE;
    std::shared_ptr<char> buffer;
    std::size_t filled = 0;

    explicit State(const std::string& p) : path(p), target(native(p)) {
        const DWORD attributes = GetFileAttributesW(target.c_str());
        if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY))
            fail(Status::io, "cannot write '%s': it is a folder", shown_path(path).c_str());
        const std::size_t slash = target.find_last_of(L"/\\:");
        const NativePath folder =
                             slash == NativePath::npos ? NativePath() : target.substr(0, slash + 1),
                         name = slash == NativePath::npos ? target : target.substr(slash + 1);
        // A file that its writer holds open cannot be deleted; one that can was left behind.
        for (unsigned slot = 0; slot < kSlots; ++slot)
            DeleteFileW(slot_name(folder, name, slot).c_str());
        for (unsigned slot = 0; slot < kMostSlots; ++slot) {
            NativePath tried = slot_name(folder, name, slot);
            handle = CreateFileW(tried.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW,
                                 FILE_ATTRIBUTE_NORMAL, nullptr);
            if (handle != INVALID_HANDLE_VALUE) {
                temporary = std::move(tried);
                return;
            }
            const DWORD code = GetLastError();
            if (code != ERROR_FILE_EXISTS && code != ERROR_SHARING_VIOLATION)
                fail_io("create", path, code);
        }
        fail(Status::io, "cannot write '%s': too many others write it", shown_path(path).c_str());
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

namespace {

bool same_file(int descriptor, const char* path) {
    struct stat open, named;
    return ::fstat(descriptor, &open) == 0 && ::lstat(path, &named) == 0 &&
           open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

/// Unlinks a temporary that nobody holds locked. Where files cannot be locked, none is removed.
void remove_abandoned(const char* name) {
    const int descriptor = ::open(name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && same_file(descriptor, name)) ::unlink(name);
    ::close(descriptor);
}

/// Holds off SIGXFSZ, which would end the host, while a file is written beyond the process's limit:
/// the write fails with EFBIG instead. What the write itself has raised is taken away again.
class NoSizeSignal {
  public:
    NoSizeSignal() {
        sigset_t pending;
        sigemptyset(&signal_);
        sigaddset(&signal_, SIGXFSZ);
        sigpending(&pending);
        was_pending_ = sigismember(&pending, SIGXFSZ) == 1;
        blocked_ = pthread_sigmask(SIG_BLOCK, &signal_, &before_) == 0;
    }
    ~NoSizeSignal() {
        if (!blocked_) return;
        const int kept = errno;
#if !defined(__APPLE__)
        const timespec now = {0, 0};
        if (!was_pending_)
            while (sigtimedwait(&signal_, nullptr, &now) < 0 && errno == EINTR) {
            }
#endif
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
        errno = kept;
    }
    NoSizeSignal(const NoSizeSignal&) = delete;
    NoSizeSignal& operator=(const NoSizeSignal&) = delete;

  private:
    sigset_t signal_, before_;
    bool was_pending_ = false, blocked_ = false;
};

}  // namespace

struct AtomicFile::State {
    std::string path, target, folder, prefix, name, temporary;
    int descriptor = -1;
    bool unnamed = false;
    std::shared_ptr<char> buffer;
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
        prefix = slash == std::string::npos ? "" : target.substr(0, slash + 1);
        folder = slash == std::string::npos ? "." : prefix;
        name = slash == std::string::npos ? target : target.substr(slash + 1);
        for (unsigned slot = 0; slot < kSlots; ++slot)
            remove_abandoned(slot_name(prefix, name, slot).c_str());
        if (!open_unnamed()) open_named();
        // A file system without permissions refuses, and the file is fine all the same.
        if (exists && ::fchmod(descriptor, info.st_mode & 07777) != 0) errno = 0;
    }
    ~State() {
        if (!temporary.empty()) ::unlink(temporary.c_str());
        if (descriptor >= 0) ::close(descriptor);
    }

    /// False where the system or the file system has no such files, or no way to name one later.
    bool open_unnamed() {
#if defined(O_TMPFILE)
        if (::access("/proc/self/fd", X_OK) != 0) return false;
        do descriptor = ::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
        while (descriptor < 0 && errno == EINTR);
        if (descriptor < 0) return false;
        (void)::flock(descriptor, LOCK_EX | LOCK_NB);  // so that it is locked once it has a name
        unnamed = true;
        return true;
#else
        return false;
#endif
    }
    void open_named() {
        int code = EEXIST;
        for (unsigned slot = 0; slot < kMostSlots && code == EEXIST; ++slot) {
            std::string tried = slot_name(prefix, name, slot);
            do {
                descriptor = ::open(tried.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
                code = errno;
            } while (descriptor < 0 && code == EINTR);
            if (descriptor < 0) continue;
            (void)::flock(descriptor, LOCK_EX | LOCK_NB);
            if (same_file(descriptor, tried.c_str())) {
                temporary = std::move(tried);
                return;
            }
            ::close(descriptor);  // another writer took it for abandoned before it was locked
            descriptor = -1;
            code = EEXIST;
        }
        fail_io("create", path, code);
    }

    void put(const char* data, std::size_t size) {
        if (size == 0) return;
        const NoSizeSignal no_signal;
        while (size != 0) {
            const ssize_t done = ::write(descriptor, data, std::min(size, kLargestCall));
            if (done < 0 && errno == EINTR) continue;
            if (done < 0) fail_io("write", path, errno);
            data += done;
            size -= static_cast<std::size_t>(done);
        }
    }

    /// Gives an unnamed file its temporary name, or its last one at once where there is no old
    /// file.
    void give_name() {
        char own[64];
        std::snprintf(own, sizeof own, "/proc/self/fd/%d", descriptor);
        const auto link = [&](const std::string& as) {
            return ::linkat(AT_FDCWD, own, AT_FDCWD, as.c_str(), AT_SYMLINK_FOLLOW) == 0;
        };
        unnamed = false;
        if (link(target)) return;
        int code = errno;
        for (unsigned slot = 0; slot < kMostSlots && code == EEXIST; ++slot) {
            std::string tried = slot_name(prefix, name, slot);
            if (link(tried)) {
                temporary = std::move(tried);
                return;
            }
            code = errno;
        }
        fail_io("write", path, code);
    }

    void finish() {
        // Some network file systems cannot flush (EINVAL), and tell what went wrong when a file is
        // closed; a failed flush of data they can is real.
        bool flushed = ::fsync(descriptor) == 0;
        if (!flushed && errno != EINVAL && errno != ENOTSUP) fail_io("write", path, errno);
        if (unnamed) give_name();
        if (!flushed) close_checked();
        if (!temporary.empty()) {
            if (descriptor >= 0 && !same_file(descriptor, temporary.c_str()))
                fail(Status::io, "cannot write '%s': its temporary file was removed",
                     shown_path(path).c_str());
            if (::rename(temporary.c_str(), target.c_str()) != 0) fail_io("replace", path, errno);
            temporary.clear();
        }
        if (descriptor >= 0) close_checked();
        // The new name itself reaches the disk with its folder; a folder that refuses is no error.
        const int folder_descriptor = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
        if (folder_descriptor >= 0) {
            (void)::fsync(folder_descriptor);
            ::close(folder_descriptor);
        }
    }

    void close_checked() {
        const int closed = ::close(descriptor), code = errno;
        descriptor = -1;
        if (closed != 0 && code != EINTR) fail_io("write", path, code);
    }
};

#endif

// The destructor of a half-built State does not run, so the buffer comes before the file exists.
AtomicFile::AtomicFile(const std::string& path) {
    std::shared_ptr<char> buffer = counted_block(kBufferBytes);
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
