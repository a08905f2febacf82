// Training in parts (B10): a shard is the joint span of a part of a data set with the coordinates
// of its faces, a linear summary of its columns. The merged training reads columns from shards as
// it would from a data set, and its iteration depends on XX' and YY' alone (joint_span.hpp), so the
// merged model equals that of one run to rounding as long as no shard had to cut its rank.
//
// Parts are made by subject: a subject's neutral face and expressions belong into one part.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "expression/column_source.hpp"
#include "expression/joint_span.hpp"

namespace mien {

struct ShardOptions {
    Index max_rank =
        512;         ///< of identities and of expressions each; smaller files, but no longer exact
    int passes = 4;  ///< of subspace iteration where the rank is cut
};

struct ShardReport {
    Index subjects = 0, faces = 0, rank = 0;
    double cut = 0;  ///< share of the part's variance that the shard does not hold
};

/// Writes a shard: safetensors, kind "mien-expression-shard", format 1. Throws as
/// find_joint_span().
ShardReport write_expression_shard(const std::string& path, const ColumnSource& source,
                                   const ShardOptions& options, const Context& context);

/// Columns of all shards together, in the order given. Throws Status::mismatch when vertex counts,
/// triangles, expression names or the alignment differ, Status::invalid_argument for no shard or a
/// subject that is in two shards.
std::unique_ptr<ColumnSource> shard_columns(const std::vector<std::string>& paths,
                                            const SafetensorsReadOptions& options,
                                            const Context& context);

/// Subject ids of part `part` of `count` parts: every count-th of the sorted ids.
std::vector<int> subjects_of_part(const FaceDataset& dataset, int part, int count);

}  // namespace mien
