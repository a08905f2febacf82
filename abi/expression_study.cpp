// Shards and series: expression models over more than one machine, more than one scan.
#include "arrays.hpp"
#include "expression.hpp"
#include "expression/neutralize_mesh.hpp"
#include "expression/report_json.hpp"
#include "expression/series.hpp"
#include "expression/shards.hpp"
#include "expression_options.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_shard_options default_shard_options() {
    mien_shard_options options{};
    options.part_count = 1;
    options.max_rank = static_cast<std::int32_t>(ShardOptions().max_rank);
    return options;
}

mien_series_options default_series_options() {
    const SeriesOptions core;
    mien_series_options options{};
    options.method = MIEN_FIT_MIXTURE;
    options.scan_noise_share = core.scan_noise_share;
    options.expected_change_mm = core.expected_change_mm;
    return options;
}

SeriesOptions read_series_options(const mien_series_options& given, Index num_vertices) {
    check_fit(given.method, "options.method");
    check_pose(given.pose);
    check_numbers({{"scan_noise_share", given.scan_noise_share},
                   {"noise_mm2", given.noise_mm2},
                   {"expected_change_mm", given.expected_change_mm}});
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    SeriesOptions options;
    options.method = static_cast<FitMethod>(given.method);
    options.pose = static_cast<Pose>(given.pose);
    options.scan_noise_share = given.scan_noise_share;
    options.noise_mm2 = given.noise_mm2;
    options.changing_zone = read_vertices(given.changing_vertices, given.changing_count,
                                          num_vertices, "options.changing_vertices");
    options.expected_change_mm = given.expected_change_mm;
    return options;
}

/// The host's one list, cut into one per face.
std::vector<Vector> read_series_weights(const mien_array_view& view, std::uint32_t face_count,
                                        Index num_vertices) {
    if (view.count == 0) return {};
    if (view.count != face_count * static_cast<std::uint64_t>(num_vertices))
        fail(Status::mismatch,
             "options.weights holds %llu numbers, not one per vertex of %u faces of %lld vertices",
             static_cast<unsigned long long>(view.count), face_count,
             static_cast<long long>(num_vertices));
    const Vector all = read_values(view, "options.weights");
    std::vector<Vector> weights;
    for (std::uint32_t k = 0; k < face_count; ++k)
        weights.push_back(all.segment(static_cast<Index>(k) * num_vertices, num_vertices));
    return weights;
}

std::shared_ptr<const TriMesh> with_vertices(const TriMesh& mesh, const Points& vertices) {
    auto copy = std::make_shared<TriMesh>(mesh);
    copy->vertices = vertices;
    return copy;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_shard_options_init(mien_shard_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_shard_options());
}

void MIEN_CALL mien_series_options_init(mien_series_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_series_options());
}

mien_status MIEN_CALL mien_expression_shard_create(mien_session* session, const char* dataset_path,
                                                   const mien_shard_options* options,
                                                   const char* shard_path, mien_error* error) {
    return guarded(error, [&] {
        const mien_shard_options given =
            read_options(options, default_shard_options(),
                         MIEN_FIRST_SIZE(mien_shard_options, cancel), "options");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const char* target = checked_text(shard_path, "shard_path");
        auto dataset = std::make_shared<FaceDataset>(FaceDataset::open(
            checked_text(dataset_path, "dataset_path"), unverified(), call.context()));
        const std::vector<int> subjects = subjects_of_part(*dataset, given.part, given.part_count);
        const std::vector<std::uint32_t> stable =
            read_vertices(given.stable_vertices, given.stable_count, dataset->num_vertices(),
                          "options.stable_vertices");
        ShardOptions settings;
        settings.max_rank = given.max_rank;
        write_expression_shard(target, *dataset_columns(std::move(dataset), subjects, stable),
                               settings, call.context());
    });
}

mien_status MIEN_CALL mien_expression_model_merge(mien_session* session,
                                                  const char* const* shard_paths,
                                                  uint32_t shard_count,
                                                  const mien_train_options* options,
                                                  mien_expression_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_train_options given = given_train_options(options);
        const TrainOptions settings = read_train_options(given);
        if (given.stable_count != 0)
            fail(Status::invalid_argument,
                 "options.stable_vertices: the faces were aligned when the shards were made");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        if (shard_count == 0) fail(Status::invalid_argument, "shard_count is 0");
        check_array(shard_paths, shard_count, alignof(const char*), 1000000, "shard_paths");
        std::vector<std::string> paths;
        for (uint32_t k = 0; k < shard_count; ++k)
            paths.emplace_back(checked_text(shard_paths[k], "a shard's path"));
        const auto source = shard_columns(paths, {}, call.context());
        TrainReport report;
        auto model = train_expression_model(*source, settings, call.context(), &report);
        std::string json = training_json(*model, report);
        return new mien_expression_model(std::move(model), std::move(json));
    });
}

mien_status MIEN_CALL mien_neutralize_series(mien_session* session,
                                             const mien_expression_model* model,
                                             const mien_mesh* const* faces, uint32_t face_count,
                                             const mien_series_options* options, mien_series** out,
                                             mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_series_options given =
            read_options(options, default_series_options(),
                         MIEN_FIRST_SIZE(mien_series_options, cancel), "options");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const ExpressionModel& data = *checked(model, "model").model;
        if (face_count == 0) fail(Status::invalid_argument, "face_count is 0");
        check_array(faces, face_count, alignof(const mien_mesh*), 1000, "faces");
        std::vector<std::shared_ptr<const TriMesh>> meshes;
        for (uint32_t k = 0; k < face_count; ++k)
            meshes.push_back(checked(faces[k], "a face").mesh);
        const Index num_vertices = meshes[0]->vertices.rows();
        const SeriesOptions settings = read_series_options(given, num_vertices);
        const SeriesResult result = neutralize_series_meshes(
            call.context(), data, meshes,
            read_series_weights(given.weights, face_count, num_vertices), settings);
        auto series = std::make_unique<mien_series>();
        series->identity = with_vertices(*faces[0]->mesh, result.identity_vertices);
        for (uint32_t k = 0; k < face_count; ++k)
            series->neutrals.push_back(with_vertices(*faces[k]->mesh, result.neutral_vertices[k]));
        series->json = series_json(data, result);
        return series.release();
    });
}

mien_status MIEN_CALL mien_series_get_mesh(const mien_series* series, int32_t index,
                                           mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_series& data = checked(series, "series");
        if (index < -1 || index >= static_cast<std::int32_t>(data.neutrals.size()))
            fail(Status::not_found, "face %d of a series of %zu", index, data.neutrals.size());
        return new mien_mesh(index == -1 ? data.identity
                                         : data.neutrals[static_cast<std::size_t>(index)]);
    });
}

mien_status MIEN_CALL mien_series_get_json(const mien_series* series, char* dst, uint64_t capacity,
                                           uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(series, "series").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_series_release(mien_series* series) {
    release(series);
}

}  // extern "C"
