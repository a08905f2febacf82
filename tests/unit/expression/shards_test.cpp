#include "expression/shards.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "expression/neutralize.hpp"
#include "expression/training.hpp"
#include "study.hpp"

namespace mien {
namespace {

using test::mean_distance;
using test::Study;

TrainOptions shard_options() {
    TrainOptions options;
    options.subspaces.identity_modes = 10;
    options.subspaces.expression_modes = 8;
    return options;
}

std::vector<std::string> write_parts(const std::shared_ptr<const FaceDataset>& data, int count,
                                     const std::string& tag,
                                     const std::vector<std::uint32_t>& stable = {}) {
    std::vector<std::string> paths;
    for (int part = 0; part < count; ++part) {
        paths.push_back(Study::path(tag + std::to_string(part)));
        const auto source = dataset_columns(data, subjects_of_part(*data, part, count), stable);
        const ShardReport report =
            write_expression_shard(paths.back(), *source, ShardOptions(), Context());
        EXPECT_LT(report.cut, 1e-12);
    }
    return paths;
}

void remove_all(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) std::remove(path.c_str());
}

TEST(Shards, MergedModelEqualsTheSingleRun) {
    const Study study;
    const auto data = study.dataset(0, study.subjects, "whole");
    for (TrainMethod method : {TrainMethod::joint_pca, TrainMethod::quasi_orthogonal}) {
        TrainOptions options = shard_options();
        options.subspaces.method = method;
        const auto whole = train_expression_model(data, options, Context());
        const auto paths = write_parts(data, 3, "part");
        const auto merged =
            train_expression_model(*shard_columns(paths, {}, Context()), options, Context());
        remove_all(paths);
        EXPECT_LT((whole->mean - merged->mean).cwiseAbs().maxCoeff(), 1e-9);
        // Not the smooth ones: directions of nearly equal strength, turned by rounding.
        EXPECT_LT((people_of(*whole).identity_modes.map() - people_of(*merged).identity_modes.map())
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-6);
        EXPECT_EQ(whole->smooth_modes, merged->smooth_modes);
        EXPECT_LT(
            (whole->expression_modes.map() - merged->expression_modes.map()).cwiseAbs().maxCoeff(),
            1e-6);
        EXPECT_EQ(whole->mixture_noise_mm2, merged->mixture_noise_mm2);
        ASSERT_EQ(whole->components.size(), merged->components.size());
        const Points face = study.face(70, 2);
        EXPECT_LT(
            mean_distance(neutralize(Context(), *whole, face, Vector(), {}).neutral_vertices,
                          neutralize(Context(), *merged, face, Vector(), {}).neutral_vertices),
            2e-5);
        EXPECT_LT(
            mean_distance(
                neutralize(Context(), people_of(*whole), face, Vector(), {}).neutral_vertices,
                neutralize(Context(), people_of(*merged), face, Vector(), {}).neutral_vertices),
            1e-6);
    }
}

TEST(Shards, RefuseASubjectInTwoShardsAndOtherTopologies) {
    const Study study;
    const auto data = study.dataset(0, 6, "twice");
    const auto paths = write_parts(data, 2, "twice");
    auto status_of = [](const std::vector<std::string>& list) {
        try {
            shard_columns(list, {}, Context());
        } catch (const Error& error) {
            return error.status();
        }
        return Status::ok;
    };
    EXPECT_EQ(status_of({paths[0], paths[0]}), Status::invalid_argument);
    EXPECT_EQ(status_of({}), Status::invalid_argument);
    Study other;
    other.names.push_back("more");
    const auto foreign = write_parts(other.dataset(10, 14, "foreign"), 1, "foreign");
    EXPECT_EQ(status_of({paths[0], foreign[0]}), Status::mismatch);
    EXPECT_EQ(status_of(paths), Status::ok);
    remove_all(paths);
    remove_all(foreign);
}

TEST(Shards, PartsOfOneSetAreAlignedAlikeAndOthersAreRefused) {
    const Study study;
    const auto data = study.dataset(0, study.subjects, "aligned");
    TrainOptions options = shard_options();
    for (Index i = 0; i < study.rest.rows(); ++i)
        if (study.rest(i, 1) > 70) options.stable_vertices.push_back(static_cast<std::uint32_t>(i));
    const auto whole = train_expression_model(data, options, Context());
    const auto paths = write_parts(data, 3, "aligned", options.stable_vertices);
    const auto merged =
        train_expression_model(*shard_columns(paths, {}, Context()), options, Context());
    EXPECT_EQ(merged->stable_vertices, options.stable_vertices);
    EXPECT_LT((whole->mean - merged->mean).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((people_of(*whole).identity_modes.map() - people_of(*merged).identity_modes.map())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-6);
    EXPECT_LT(
        (whole->expression_modes.map() - merged->expression_modes.map()).cwiseAbs().maxCoeff(),
        1e-6);
    const auto elsewhere =
        write_parts(study.dataset(30, 34, "elsewhere"), 1, "elsewhere", options.stable_vertices);
    const auto loose = write_parts(study.dataset(30, 34, "loose"), 1, "loose");
    EXPECT_THROW(shard_columns({paths[0], elsewhere[0]}, {}, Context()), Error);
    EXPECT_THROW(shard_columns({paths[0], loose[0]}, {}, Context()), Error);
    remove_all(paths);
    remove_all(elsewhere);
    remove_all(loose);
}

TEST(Shards, PartsCoverEverySubjectOnce) {
    const Study study;
    const auto data = study.dataset(0, 7, "cover");
    std::vector<int> all;
    for (int part = 0; part < 3; ++part)
        for (int subject : subjects_of_part(*data, part, 3)) all.push_back(subject);
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, (std::vector<int>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_THROW(subjects_of_part(*data, 3, 3), Error);
}

}  // namespace
}  // namespace mien
