// Errors, handles, sessions and meshes of the C++ face. Header-only; keeps no state of its own.
#ifndef MIEN_DETAIL_CORE_HPP
#define MIEN_DETAIL_CORE_HPP

#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../mien.h"

namespace mien {

/// A failed call: the status, the text and the first offending index of the error record.
class Exception : public std::runtime_error {
  public:
    explicit Exception(const mien_error& error)
        : std::runtime_error(error.message),
          status_(error.status),
          detail_index_(error.detail_index) {}
    mien_status status() const noexcept { return status_; }
    std::int64_t detail_index() const noexcept { return detail_index_; }

  private:
    mien_status status_;
    std::int64_t detail_index_;
};

namespace detail {

/// Calls f(arguments..., &error) and throws what it reports.
template <typename Function, typename... Arguments>
void call(Function function, Arguments&&... arguments) {
    mien_error error{};
    error.struct_size = sizeof error;
    if (function(std::forward<Arguments>(arguments)..., &error) != MIEN_OK) throw Exception(error);
}

/// Reads a text by the two-call protocol: f(handle, dst, capacity, count, error).
template <typename Function, typename Handle>
std::string read_text(Function function, const Handle* handle) {
    std::uint64_t size = 0;
    call(function, handle, nullptr, std::uint64_t{0}, &size);
    std::string text(static_cast<std::size_t>(size), '\0');
    call(function, handle, &text[0], size, &size);
    text.resize(static_cast<std::size_t>(size) - 1);
    return text;
}

template <typename T, void (*Release)(T*)>
struct Deleter {
    void operator()(T* handle) const noexcept { Release(handle); }
};

/// Owns one reference to a handle.
template <typename T, void (*Release)(T*)>
using Handle = std::unique_ptr<T, Deleter<T, Release>>;

}  // namespace detail

/// Progress as a std::function: return true to go on, false to cancel. An exception that it throws
/// is rethrown by the call that was running.
using Progress = std::function<bool(int stage, double fraction)>;

namespace detail {

/// Carries a Progress across the C boundary and its exceptions back.
class ProgressBridge {
  public:
    explicit ProgressBridge(const Progress& progress) : progress_(progress) {}

    template <typename Options>
    void install(Options& options) {
        if (!progress_) return;
        options.progress = &ProgressBridge::forward;
        options.progress_user = this;
    }

    template <typename Function, typename... Arguments>
    void call(Function function, Arguments&&... arguments) {
        try {
            detail::call(function, std::forward<Arguments>(arguments)...);
        } catch (const Exception&) {
            if (thrown_) std::rethrow_exception(thrown_);
            throw;
        }
    }

  private:
    static std::int32_t MIEN_CALL forward(void* user, std::int32_t stage, double fraction) {
        auto* self = static_cast<ProgressBridge*>(user);
        try {
            return self->progress_(stage, fraction) ? 0 : 1;
        } catch (...) {
            self->thrown_ = std::current_exception();
            return 1;
        }
    }

    const Progress& progress_;
    std::exception_ptr thrown_;
};

}  // namespace detail

/// Threads, limits of memory and time. One call at a time.
class Session {
  public:
    /// `log` gets what a call has to say beside its result, such as a missing texture image; it
    /// must not throw.
    explicit Session(int num_threads = 1, std::uint64_t max_bytes = 0, mien_log_fn log = nullptr,
                     void* log_user = nullptr) {
        mien_session_options options;
        mien_session_options_init(&options, sizeof options);
        options.num_threads = num_threads;
        options.max_bytes = max_bytes;
        options.log = log;
        options.log_user = log_user;
        open(options);
    }
    /// With all there is to choose, e.g. max_seconds and copy_files.
    explicit Session(const mien_session_options& options) { open(options); }
    /// SHA-256 of a file's bytes, in hexadecimal digits.
    std::string hash_file(const std::string& path) const {
        std::string digest(65, '\0');
        std::uint64_t size = 0;
        detail::call(mien_session_hash_file, get(), path.c_str(), &digest[0],
                     std::uint64_t{digest.size()}, &size);
        digest.resize(static_cast<std::size_t>(size) - 1);
        return digest;
    }
    mien_session* get() const noexcept { return handle_.get(); }

  private:
    void open(const mien_session_options& options) {
        mien_session* session = nullptr;
        detail::call(mien_session_create_with_options, MIEN_ABI_VERSION, &options, &session);
        handle_.reset(session);
    }

    detail::Handle<mien_session, mien_session_release> handle_;
};

/// Tells a running call to stop; request() may be called from any thread.
class Cancel {
  public:
    Cancel() {
        mien_cancel* cancel = nullptr;
        detail::call(mien_cancel_create, &cancel);
        handle_.reset(cancel);
    }
    void request() noexcept { mien_cancel_request(handle_.get()); }
    mien_cancel* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<mien_cancel, mien_cancel_release> handle_;
};

using Position = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;
using Color = std::array<std::uint8_t, 3>;

/// A checked, immutable triangle mesh; copies share it.
class Mesh {
  public:
    Mesh(const Session& session, const std::string& path) {
        mien_mesh* mesh = nullptr;
        detail::call(mien_mesh_load, session.get(), path.c_str(), &mesh);
        adopt(mesh);
    }
    Mesh(const Session& session, const std::vector<Position>& positions,
         const std::vector<Triangle>& triangles, const std::vector<Color>& colors = {}) {
        if (!colors.empty() && colors.size() != positions.size())
            throw std::invalid_argument("colors and positions differ in number");
        mien_mesh_arrays arrays;
        mien_mesh_arrays_init(&arrays, sizeof arrays);
        arrays.positions = {positions.data(), positions.size(), sizeof(Position), MIEN_DTYPE_F64,
                            0};
        arrays.triangles = triangles.empty() ? nullptr : triangles.front().data();
        arrays.triangle_count = triangles.size();
        arrays.colors = colors.empty() ? nullptr : colors.front().data();
        mien_mesh* mesh = nullptr;
        detail::call(mien_mesh_create, session.get(), &arrays, &mesh);
        adopt(mesh);
    }
    /// Takes over one reference.
    explicit Mesh(mien_mesh* owned) { adopt(owned); }
    /// Adds a reference of its own to a mesh that something else owns.
    static Mesh share(const mien_mesh* borrowed) { return Mesh(mien_mesh_retain(borrowed)); }

    void save(const Session& session, const std::string& path) const {
        detail::call(mien_mesh_save, session.get(), get(), path.c_str());
    }
    std::vector<Position> positions() const {
        std::vector<Position> out(vertex_count());
        std::uint64_t count = 0;
        detail::call(mien_mesh_get_positions, get(), MIEN_DTYPE_F64, static_cast<void*>(out.data()),
                     std::uint64_t{out.size()}, &count);
        return out;
    }
    std::vector<Triangle> triangles() const {
        std::uint64_t vertices = 0, count = 0;
        detail::call(mien_mesh_get_counts, get(), &vertices, &count);
        std::vector<Triangle> out(static_cast<std::size_t>(count));
        if (count != 0)
            detail::call(mien_mesh_get_triangles, get(), out.front().data(), count, &count);
        return out;
    }
    std::vector<Color> colors() const {
        std::uint64_t count = 0;
        detail::call(mien_mesh_get_colors, get(), nullptr, std::uint64_t{0}, &count);
        std::vector<Color> out(static_cast<std::size_t>(count));
        if (count != 0)
            detail::call(mien_mesh_get_colors, get(), out.front().data(), count, &count);
        return out;
    }
    std::size_t vertex_count() const {
        std::uint64_t vertices = 0;
        detail::call(mien_mesh_get_counts, get(), &vertices, nullptr);
        return static_cast<std::size_t>(vertices);
    }
    const mien_mesh* get() const noexcept { return handle_.get(); }

  private:
    void adopt(mien_mesh* mesh) { handle_ = std::shared_ptr<mien_mesh>(mesh, mien_mesh_release); }
    std::shared_ptr<mien_mesh> handle_;
};

/// Collects faces in correspondence into a dataset file.
class DatasetWriter {
  public:
    DatasetWriter(const Session& session, const Mesh& topology,
                  const std::vector<std::string>& expression_names) {
        std::vector<const char*> names;
        names.reserve(expression_names.size());
        for (const std::string& name : expression_names) names.push_back(name.c_str());
        mien_dataset_writer* writer = nullptr;
        detail::call(mien_dataset_writer_create, session.get(), topology.get(), names.data(),
                     static_cast<std::uint32_t>(names.size()), &writer);
        handle_.reset(writer);
    }
    void add(const std::vector<Position>& positions, int subject, int expression) {
        const mien_array_view view{positions.data(), positions.size(), sizeof(Position),
                                   MIEN_DTYPE_F64, 0};
        detail::call(mien_dataset_writer_add, handle_.get(), &view, subject, expression);
    }
    void save(const Session& session, const std::string& path) const {
        detail::call(mien_dataset_writer_save, session.get(), handle_.get(), path.c_str());
    }

  private:
    detail::Handle<mien_dataset_writer, mien_dataset_writer_release> handle_;
};

}  // namespace mien

#endif
