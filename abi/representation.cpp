// Faces as numbers for learning.
#include "arrays.hpp"
#include "guard.hpp"
#include "learning/face_features.hpp"
#include "mesh/dataset.hpp"
#include "motion.hpp"
#include "options.hpp"
#include "session.hpp"
#include "spectral.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_representation : Object {
    static constexpr Tag kTag = Tag::representation;
    static constexpr const char* kName = "representation";
    explicit mien_representation(std::shared_ptr<const FaceFeatures> features)
        : Object(kTag), data(std::move(features)) {}
    const std::shared_ptr<const FaceFeatures> data;
};

namespace {

mien_representation* train(const char* dataset_path, std::int32_t kind, bool neutral_only,
                           const Context& context) {
    check_choice(kind, MIEN_FEATURES_EUCLIDEAN, MIEN_FEATURES_DEFORMATION_STANDARDISED, "kind");
    const FaceDataset data =
        FaceDataset::open(checked_text(dataset_path, "dataset_path"), {}, context);
    std::vector<Index> chosen;
    for (Index k = 0; k < data.num_faces(); ++k)
        if (!neutral_only || data.expression(k) == data.neutral_expression()) chosen.push_back(k);
    if (chosen.empty()) fail(Status::not_found, "the dataset has no neutral face");
    FaceSource source;
    source.count = static_cast<Index>(chosen.size());
    source.face = [&](Index k, Points& face) {
        data.face(chosen[static_cast<std::size_t>(k)], face);
    };
    return new mien_representation(
        FaceFeatures::train(data.triangles(), source, static_cast<FeatureKind>(kind), context));
}

}  // namespace

extern "C" {

void MIEN_CALL mien_representation_options_init(mien_representation_options* options,
                                                size_t struct_size) {
    write_defaults(options, struct_size, mien_representation_options{});
}

mien_status MIEN_CALL mien_representation_train_with_options(
    mien_session* session, const char* dataset_path, int32_t kind,
    const mien_representation_options* options, mien_representation** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_representation_options given =
            read_options(options, mien_representation_options{},
                         MIEN_FIRST_SIZE(mien_representation_options, cancel), "options");
        const bool neutral_only = read_switch(given.neutral_only, "options.neutral_only");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        return train(dataset_path, kind, neutral_only, call.context());
    });
}

mien_status MIEN_CALL mien_representation_train(mien_session* session, const char* dataset_path,
                                                int32_t kind, int32_t neutral_only,
                                                mien_representation** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return train(dataset_path, kind, read_switch(neutral_only, "neutral_only"), call.context());
    });
}

mien_status MIEN_CALL mien_representation_load(mien_session* session, const char* path,
                                               mien_representation** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_representation(
            FaceFeatures::load(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_representation_save(mien_session* session,
                                               const mien_representation* representation,
                                               const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        checked(representation, "representation")
            .data->save(checked_text(path, "path"), call.context());
    });
}

mien_status MIEN_CALL mien_representation_get_counts(const mien_representation* representation,
                                                     uint64_t* vertex_count,
                                                     uint64_t* channel_count, mien_error* error) {
    return guarded(error, [&] {
        const FaceFeatures& data = *checked(representation, "representation").data;
        store(vertex_count, data.num_vertices());
        store(channel_count, data.num_channels());
    });
}

mien_status MIEN_CALL mien_representation_encode(mien_session* session,
                                                 const mien_representation* representation,
                                                 const mien_mesh* face, double* motion, double* dst,
                                                 uint64_t capacity, uint64_t* count,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const FaceFeatures& data = *checked(representation, "representation").data;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const Call call(session);
        const auto rows = static_cast<uint64_t>(data.num_vertices());
        const std::size_t row_bytes =
            static_cast<std::size_t>(data.num_channels()) * sizeof(double);
        if (dst == nullptr || capacity < rows) {  // the count needs no work
            wants_copy(rows, dst, capacity, count);
            return;
        }
        check_output(motion, "motion");
        Similarity onto_mean;
        const Features features = data.encode(mesh.vertices, &onto_mean, call.context());
        copy_rows(features.data(), rows, row_bytes, dst, capacity, count);
        write_motion(onto_mean, motion);
    });
}

mien_status MIEN_CALL mien_representation_decode(mien_session* session,
                                                 const mien_representation* representation,
                                                 const double* features, uint64_t row_count,
                                                 const double* motion, mien_mesh** out,
                                                 mien_error* error) {
    return guarded_create(out, error, [&] {
        const FaceFeatures& data = *checked(representation, "representation").data;
        const Call call(session);
        if (row_count != static_cast<uint64_t>(data.num_vertices()))
            fail(Status::mismatch, "row_count is %llu, the representation has %lld vertices",
                 static_cast<unsigned long long>(row_count),
                 static_cast<long long>(data.num_vertices()));
        if (features == nullptr) fail(Status::invalid_argument, "features is null");
        if (reinterpret_cast<std::uintptr_t>(features) % alignof(double) != 0)
            fail(Status::invalid_argument, "features is misaligned");
        const Features given =
            Eigen::Map<const Features>(features, data.num_vertices(), data.num_channels());
        const std::optional<Similarity> onto_mean = read_motion(motion);
        return make_mesh(data.decode(given, onto_mean ? &*onto_mean : nullptr, call.context()),
                         data.mean().triangles);
    });
}

void MIEN_CALL mien_representation_retain(mien_representation* representation) {
    retain(representation);
}
void MIEN_CALL mien_representation_release(mien_representation* representation) {
    release(representation);
}

}  // extern "C"
