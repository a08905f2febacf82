// Prepared scans and batches of the C++ face.
#ifndef MIEN_DETAIL_BATCH_HPP
#define MIEN_DETAIL_BATCH_HPP

#include "registration.hpp"

namespace mien {

/// A scan that is prepared once for many fits; copies share it.
class ReadyScan {
  public:
    /// Of the settings: units, weights, progress, cancel.
    ReadyScan(const Session& session, const Mesh& scan, const RegisterOptions& settings = {}) {
        detail::RegisterCall options(settings);
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options.c);
        mien_ready_scan* ready = nullptr;
        bridge.call(mien_ready_scan_create, session.get(), scan.get(), &options.c, &ready);
        handle_ = std::shared_ptr<mien_ready_scan>(ready, mien_ready_scan_release);
    }
    Registration fit(const Session& session, const Model& model,
                     const RegisterOptions& settings = {}) const {
        detail::RegisterCall options(settings);
        options.c.scan_weights = {};  // read when the scan was prepared
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options.c);
        mien_registration* registration = nullptr;
        bridge.call(mien_ready_scan_register, session.get(), model.get(), get(), &options.c,
                    &registration);
        return Registration(registration);
    }
    const mien_ready_scan* get() const noexcept { return handle_.get(); }

  private:
    std::shared_ptr<mien_ready_scan> handle_;
};

/// Scans side by side with one model.
class Batch {
  public:
    Batch(const Session& session, const Model& model) {
        mien_batch* batch = nullptr;
        detail::call(mien_batch_create, session.get(), model.get(), &batch);
        handle_.reset(batch);
    }
    void add(const Session& session, const Mesh& scan, const RegisterOptions& settings = {}) {
        const detail::RegisterCall options(settings);
        detail::call(mien_batch_add, session.get(), handle_.get(), scan.get(), &options.c);
    }
    /// Fits what was added and not yet fitted.
    void run(const Session& session, const Progress& progress = {}, mien_cancel* cancel = nullptr) {
        mien_batch_options options;
        mien_batch_options_init(&options, sizeof options);
        options.cancel = cancel;
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        bridge.call(mien_batch_run, session.get(), handle_.get(), &options);
    }
    /// Scans that were run.
    std::uint32_t size() const {
        std::uint32_t run = 0;
        detail::call(mien_batch_get_counts, handle_.get(), nullptr, &run);
        return run;
    }
    /// Throws what the fit of that scan ended with.
    Registration registration(std::int32_t index) const {
        mien_registration* registration = nullptr;
        detail::call(mien_batch_get_registration, handle_.get(), index, &registration);
        return Registration(registration);
    }
    const mien_batch* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<mien_batch, mien_batch_release> handle_;
};

}  // namespace mien

#endif
