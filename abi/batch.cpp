// Scans that are fitted more than once, and many scans at a time.
#include "registration/batch.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "model.hpp"
#include "options.hpp"
#include "register_options.hpp"
#include "registration.hpp"
#include "registration/ready_scan.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_ready_scan : Object {
    static constexpr Tag kTag = Tag::ready_scan;
    static constexpr const char* kName = "prepared scan";
    explicit mien_ready_scan(ReadyScan&& made) : Object(kTag), ready(std::move(made)) {}
    const ReadyScan ready;
};

namespace {

/// A fit as the host gets it, or why there is none.
struct Fitted {
    mien_registration* registration = nullptr;  // one reference of our own
    Status status = Status::ok;
    std::string message;
};

}  // namespace

struct mien_batch : Object {
    static constexpr Tag kTag = Tag::batch;
    static constexpr const char* kName = "batch";
    explicit mien_batch(std::shared_ptr<const DeformationModel> of)
        : Object(kTag), model(std::move(of)) {}
    ~mien_batch() {
        for (const Fitted& one : fitted) release(one.registration);
    }
    const std::shared_ptr<const DeformationModel> model;
    std::vector<BatchJob> waiting;
    std::vector<Fitted> fitted;
};

namespace {

mien_register_options read_register_options(const mien_register_options* options) {
    return read_options(options, default_register_options(),
                        MIEN_FIRST_SIZE(mien_register_options, cancel), "options");
}

void take_outcomes(std::vector<BatchOutcome>&& outcomes, mien_batch& batch) {
    std::vector<Fitted> made(outcomes.size());
    try {
        for (std::size_t k = 0; k < outcomes.size(); ++k) {
            made[k].status = outcomes[k].status;
            made[k].message = std::move(outcomes[k].message);
            if (outcomes[k].fit)
                made[k].registration =
                    new mien_registration(std::move(*outcomes[k].fit), batch.model->zones);
            outcomes[k].fit.reset();
        }
        batch.fitted.reserve(batch.fitted.size() + made.size());
    } catch (...) {
        for (const Fitted& one : made) release(one.registration);
        throw;
    }
    for (Fitted& one : made) batch.fitted.push_back(std::move(one));
    batch.waiting.clear();
}

}  // namespace

extern "C" {

mien_status MIEN_CALL mien_ready_scan_create(mien_session* session, const mien_mesh* scan,
                                             const mien_register_options* options,
                                             mien_ready_scan** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_register_options given = read_register_options(options);
        const TriMesh& data = *checked(scan, "scan").mesh;
        const RegistrationSettings settings = register_settings(given);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        return new mien_ready_scan(make_ready(data, settings.intake, settings.far, call.context()));
    });
}

mien_status MIEN_CALL mien_ready_scan_register(mien_session* session, const mien_model* model,
                                               const mien_ready_scan* scan,
                                               const mien_register_options* options,
                                               mien_registration** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_register_options given = read_register_options(options);
        const DeformationModel& face = *checked(model, "model").model;
        const ReadyScan& ready = checked(scan, "scan").ready;
        const RegistrationSettings settings = register_settings(given);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        return new mien_registration(
            register_ready(face, ready, read_landmarks(given, face), settings, call.context()),
            face.zones);
    });
}

void MIEN_CALL mien_ready_scan_retain(mien_ready_scan* scan) {
    retain(scan);
}

void MIEN_CALL mien_ready_scan_release(mien_ready_scan* scan) {
    release(scan);
}

mien_status MIEN_CALL mien_batch_create(mien_session* session, const mien_model* model,
                                        mien_batch** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const std::shared_ptr<const DeformationModel> face = checked(model, "model").model;
        const Call call(session);
        return new mien_batch(face);
    });
}

mien_status MIEN_CALL mien_batch_add(mien_session* session, mien_batch* batch,
                                     const mien_mesh* scan, const mien_register_options* options,
                                     mien_error* error) {
    return guarded(error, [&] {
        mien_batch& target = checked(batch, "batch");
        const mien_register_options given = read_register_options(options);
        const std::shared_ptr<const TriMesh> data = checked(scan, "scan").mesh;
        const Call call(session);
        if (target.waiting.size() + target.fitted.size() >= kMostNames)
            fail(Status::invalid_argument, "a batch holds %llu scans at most",
                 static_cast<unsigned long long>(kMostNames));
        target.waiting.push_back(
            {data, read_landmarks(given, *target.model), register_settings(given)});
    });
}

void MIEN_CALL mien_batch_options_init(mien_batch_options* options, size_t struct_size) {
    write_defaults(options, struct_size, mien_batch_options{});
}

mien_status MIEN_CALL mien_batch_run(mien_session* session, mien_batch* batch,
                                     const mien_batch_options* options, mien_error* error) {
    return guarded(error, [&] {
        mien_batch& target = checked(batch, "batch");
        const mien_batch_options given = read_options(
            options, mien_batch_options{}, MIEN_FIRST_SIZE(mien_batch_options, cancel), "options");
        if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        take_outcomes(register_batch(*target.model, target.waiting, call.context()), target);
    });
}

mien_status MIEN_CALL mien_batch_get_counts(const mien_batch* batch, uint32_t* scan_count,
                                            uint32_t* run_count, mien_error* error) {
    return guarded(error, [&] {
        const mien_batch& source = checked(batch, "batch");
        store(scan_count, source.waiting.size() + source.fitted.size());
        store(run_count, source.fitted.size());
    });
}

mien_status MIEN_CALL mien_batch_get_registration(const mien_batch* batch, int32_t index,
                                                  mien_registration** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_batch& source = checked(batch, "batch");
        if (index < 0 || static_cast<std::size_t>(index) >= source.fitted.size())
            fail(Status::not_found, "scan %d of a batch of which %zu were run", index,
                 source.fitted.size());
        const Fitted& one = source.fitted[static_cast<std::size_t>(index)];
        if (one.registration == nullptr) fail(one.status, "%s", one.message.c_str());
        retain(one.registration);
        return one.registration;
    });
}

void MIEN_CALL mien_batch_retain(mien_batch* batch) {
    retain(batch);
}

void MIEN_CALL mien_batch_release(mien_batch* batch) {
    release(batch);
}

}  // extern "C"
