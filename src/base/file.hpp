// Files by UTF-8 path: mapped or read whole, and written so that a full disk, an error or a crash
// leaves the old file as it was. Everything that differs between operating systems lives here.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "base/context.hpp"

namespace mien {

/// Read-only bytes that live as long as someone holds them. `data` is null when `size` is 0.
struct FileBytes {
    const char* data = nullptr;
    std::size_t size = 0;
    std::shared_ptr<const void> storage;
};

/// Maps a regular file read-only. Throws Status::io when it cannot be opened, is a directory, a
/// pipe or a device. A file that another program shortens while it is mapped may end the process
/// (as with any mapping); one that is replaced by renaming, as AtomicFile does, is safe.
FileBytes map_file(const std::string& path);

/// Tells the system that this part of a mapped file is not needed soon: its whole pages leave the
/// process's memory and come back from the file when they are read again. `data` must lie in bytes
/// of map_file(). Does nothing where the system has no such call.
void release_pages(const void* data, std::size_t size);

/// Reads a regular file into memory: safe against a file that changes. Same errors as map_file();
/// Status::memory_budget when it does not fit the context's budget.
FileBytes read_whole_file(const std::string& path, const Context& context);

/// A file under construction: a temporary file beside the target, which takes the target's name in
/// commit() after its bytes have reached the disk, and is removed when it is destroyed before that.
/// An existing target keeps its permissions; a symbolic link is followed. Every failure throws
/// Status::io and leaves an existing target untouched. Writes are buffered here.
class AtomicFile {
  public:
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(const void* data, std::size_t size);
    void write(const std::string& text) { write(text.data(), text.size()); }
    void commit();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A path as it may stand in a message: its end when it is long, control characters replaced.
std::string shown_path(const std::string& path);

}  // namespace mien
