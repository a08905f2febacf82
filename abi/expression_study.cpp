// Shards: expression models trained over more than one machine.
#include "arrays.hpp"
#include "expression.hpp"
#include "expression/report_json.hpp"
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

}  // namespace

extern "C" {

void MIEN_CALL mien_shard_options_init(mien_shard_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_shard_options());
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
            checked_text(dataset_path, "dataset_path"), digest_alone(), call.context()));
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

}  // extern "C"
