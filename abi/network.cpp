// Trained networks: face to code and back.
#include "learning/face_network.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "learning/network_evaluation.hpp"
#include "memory_file.hpp"
#include "motion.hpp"
#include "options.hpp"
#include "session.hpp"
#include "spectral.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_network : Object {
    static constexpr Tag kTag = Tag::network;
    static constexpr const char* kName = "network";
    explicit mien_network(std::shared_ptr<const FaceNetwork> network,
                          std::shared_ptr<const void> host_bytes = nullptr)
        : Object(kTag),
          bytes(std::move(host_bytes)),
          data(std::move(network)),
          json(data->json()) {}
    const std::shared_ptr<const void> bytes;  // of a file in memory, which data borrows
    const std::shared_ptr<const FaceNetwork> data;
    const std::string json;
};

namespace {

mien_network_options read_network_options(const mien_network_options* options) {
    const mien_network_options given = read_options(
        options, mien_network_options{}, MIEN_FIRST_SIZE(mien_network_options, cancel), "options");
    if (given.reserved != 0)
        fail(Status::unsupported_option, "options.reserved is %u, it must be 0", given.reserved);
    return given;
}

/// Zero in an appended field is what the first release did: the file's own limit.
Index read_band_limit(const mien_network_options& options) {
    if (options.band_limit == 0) return -1;
    return options.band_limit < 0 ? 0 : as_index(static_cast<std::uint64_t>(options.band_limit));
}

mien_network_evaluation_options default_evaluation_options() {
    mien_network_evaluation_options options{};
    options.perceptual = 1;
    return options;
}

std::string evaluated(mien_session* session, const mien_network* network, const char* dataset_path,
                      const mien_network_evaluation_options* options) {
    const FaceNetwork& data = *checked(network, "network").data;
    const mien_network_evaluation_options given =
        read_options(options, default_evaluation_options(),
                     MIEN_FIRST_SIZE(mien_network_evaluation_options, cancel), "options");
    const bool neutral_only = read_switch(given.neutral_only, "options.neutral_only");
    const bool perceptual = read_switch(given.perceptual, "options.perceptual");
    if (given.reserved != 0)
        fail(Status::unsupported_option, "options.reserved is %u, it must be 0", given.reserved);
    if (!data.gives_faces_back())
        fail(Status::unsupported_option,
             "the network adds an expression; what it gives back is no face of the dataset");
    const Call call(session, given.progress, given.progress_user, given.cancel);
    const FaceDataset faces =
        FaceDataset::open(checked_text(dataset_path, "dataset_path"), {}, call.context());
    const std::vector<std::int32_t> subjects =
        read_array(given.subjects, given.subject_count,
                   static_cast<std::uint64_t>(faces.num_faces()), "options.subjects");
    return reconstruction_json(reconstruction_errors(
        faces, chosen_faces(faces, subjects, neutral_only),
        [&](const Points& face) { return data.apply(face, call.context()); }, perceptual,
        call.context()));
}

}  // namespace

extern "C" {

void MIEN_CALL mien_network_options_init(mien_network_options* options, size_t struct_size) {
    write_defaults(options, struct_size, mien_network_options{});
}

mien_status MIEN_CALL mien_network_load(mien_session* session, const char* path, mien_network** out,
                                        mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_network(FaceNetwork::load(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_network_load_memory(mien_session* session, const void* data,
                                               uint64_t size, mien_network** out,
                                               mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const MemoryFile from = copy_memory_file(data, size, call.context());
        return new mien_network(FaceNetwork::read(from.file, call.context()), from.bytes);
    });
}

mien_status MIEN_CALL mien_network_get_counts(const mien_network* network, uint64_t* vertex_count,
                                              uint64_t* code_count, mien_error* error) {
    return guarded(error, [&] {
        const FaceNetwork& data = *checked(network, "network").data;
        store(vertex_count, data.num_vertices());
        store(code_count, data.code_size());
    });
}

mien_status MIEN_CALL mien_network_get_json(const mien_network* network, char* dst,
                                            uint64_t capacity, uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(network, "network").json;
        copy_text(json.c_str(), json.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_network_get_mean(const mien_network* network, mien_mesh** out,
                                            mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& mean = checked(network, "network").data->mean();
        return make_mesh(Points(mean.vertices), mean.triangles);
    });
}

mien_status MIEN_CALL mien_network_encode(mien_session* session, const mien_network* network,
                                          const mien_mesh* face,
                                          const mien_network_options* options, double* motion,
                                          double* dst, uint64_t capacity, uint64_t* count,
                                          mien_error* error) {
    return guarded(error, [&] {
        const FaceNetwork& data = *checked(network, "network").data;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const mien_network_options given = read_network_options(options);
        const Call call(session, nullptr, nullptr, given.cancel);
        const auto size = static_cast<uint64_t>(data.code_size());
        if (dst == nullptr || capacity < size) {  // the count needs no work
            wants_copy(size, dst, capacity, count);
            return;
        }
        check_output(motion, "motion");
        Similarity onto_mean;
        const Vector code = data.encode(mesh.vertices, &onto_mean, call.context()).cast<double>();
        copy_rows(code.data(), size, sizeof(double), dst, capacity, count);
        write_motion(onto_mean, motion);
    });
}

mien_status MIEN_CALL mien_network_decode(mien_session* session, const mien_network* network,
                                          const double* code, uint64_t code_count,
                                          const double* motion, const mien_network_options* options,
                                          mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const FaceNetwork& data = *checked(network, "network").data;
        const mien_network_options given = read_network_options(options);
        const Call call(session, nullptr, nullptr, given.cancel);
        if (code_count != static_cast<uint64_t>(data.code_size()))
            fail(Status::mismatch, "code_count is %llu, the network's codes have %lld numbers",
                 static_cast<unsigned long long>(code_count),
                 static_cast<long long>(data.code_size()));
        if (code == nullptr) fail(Status::invalid_argument, "code is null");
        if (reinterpret_cast<std::uintptr_t>(code) % alignof(double) != 0)
            fail(Status::invalid_argument, "code is misaligned");
        const Eigen::VectorXf values =
            Eigen::Map<const Vector>(code, data.code_size()).cast<float>();
        const std::optional<Similarity> onto_mean = read_motion(motion);
        return make_mesh(data.decode(values, onto_mean ? &*onto_mean : nullptr, call.context()),
                         data.mean().triangles);
    });
}

mien_status MIEN_CALL mien_network_apply(mien_session* session, const mien_network* network,
                                         const mien_mesh* face, const mien_network_options* options,
                                         mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const FaceNetwork& data = *checked(network, "network").data;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const mien_network_options given = read_network_options(options);
        const Call call(session, nullptr, nullptr, given.cancel);
        return make_mesh(data.apply(mesh.vertices, read_band_limit(given), call.context()),
                         data.mean().triangles);
    });
}

mien_status MIEN_CALL mien_network_get_bands(const mien_network* network, uint64_t* low_code_count,
                                             int64_t* band_limit, mien_error* error) {
    return guarded(error, [&] {
        const FaceNetwork& data = *checked(network, "network").data;
        store(low_code_count, data.low_code_size());
        store(band_limit, data.band_limit());
    });
}

mien_status MIEN_CALL mien_network_mix(mien_session* session, const mien_network* network,
                                       const mien_mesh* a, const mien_mesh* b, double low_weight,
                                       double high_weight, const mien_network_options* options,
                                       mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const FaceNetwork& data = *checked(network, "network").data;
        const TriMesh &first = *checked(a, "a").mesh, &second = *checked(b, "b").mesh;
        const mien_network_options given = read_network_options(options);
        const Call call(session, nullptr, nullptr, given.cancel);
        return make_mesh(
            data.mix(first.vertices, second.vertices, low_weight, high_weight, call.context()),
            data.mean().triangles);
    });
}

mien_status MIEN_CALL mien_network_sample(const mien_network* network, uint64_t seed,
                                          uint64_t number, double spread, double* dst,
                                          uint64_t capacity, uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const FaceNetwork& data = *checked(network, "network").data;
        const Vector code = data.sample(seed, number, spread).cast<double>();
        copy_rows(code.data(), static_cast<uint64_t>(code.size()), sizeof(double), dst, capacity,
                  count);
    });
}

void MIEN_CALL mien_network_evaluation_options_init(mien_network_evaluation_options* options,
                                                    size_t struct_size) {
    write_defaults(options, struct_size, default_evaluation_options());
}

mien_status MIEN_CALL mien_network_evaluate(mien_session* session, const mien_network* network,
                                            const char* dataset_path,
                                            const mien_network_evaluation_options* options,
                                            char* dst, uint64_t capacity, uint64_t* count,
                                            mien_error* error) {
    return guarded(error, [&] {
        const std::string json = evaluated(session, network, dataset_path, options);
        copy_text(json.c_str(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_network_retain(mien_network* network) {
    retain(network);
}
void MIEN_CALL mien_network_release(mien_network* network) {
    release(network);
}

}  // extern "C"
