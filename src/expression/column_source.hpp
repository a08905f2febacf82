// Training data as columns, read in blocks: X, the neutral faces of the subjects, and Y, the
// displacements from a subject's neutral face to its other faces (J 4.2.1). Training only ever asks
// for blocks of columns, so it runs on a data set larger than memory and on merged shards alike.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"
#include "mesh/dataset.hpp"

namespace mien {

/// Labels come in source order; blocks are deterministic and may be asked for in any order.
class ColumnSource {
  public:
    virtual ~ColumnSource() = default;

    Index num_rows() const { return 3 * num_vertices; }
    Index num_neutrals() const { return static_cast<Index>(neutral_subject.size()); }
    Index num_displacements() const { return static_cast<Index>(displacement_subject.size()); }

    /// Columns [begin, begin + block.cols()) of X (not centred) or of Y, double. `block` has
    /// num_rows() rows. Throws Status::corrupt at values that are not finite.
    virtual void neutrals(Index begin, Eigen::Ref<Matrix> block) const = 0;
    virtual void displacements(Index begin, Eigen::Ref<Matrix> block) const = 0;

    Index num_vertices = 0;
    Triangles triangles;
    std::vector<std::string> expression_names;
    std::vector<int> neutral_subject;            ///< subject of each X column
    std::vector<int> displacement_subject;       ///< subject of each Y column
    std::vector<int> displacement_expression;    ///< index into expression_names
    std::vector<std::uint32_t> stable_vertices;  ///< the faces are aligned on these; may be empty
    Points stable_reference;  ///< a row per stable vertex: where they are aligned to, mm
    Index num_skipped = 0;    ///< faces whose subject has no neutral face
};

/// Columns of a data set. Several neutral captures of a subject are averaged into one column of X;
/// several captures of an expression are columns of their own. `keep_subject`, where not empty,
/// says which subject ids take part. With stable vertices every face is first aligned rigidly on
/// them to the mean of the neutral faces of the whole set, also of subjects that take no part:
/// every part of a set is aligned alike. Throws Status::invalid_argument when the set has no entry
/// "neutral" or nothing remains.
std::unique_ptr<ColumnSource> dataset_columns(
    std::shared_ptr<const FaceDataset> dataset, const std::vector<int>& keep_subject,
    const std::vector<std::uint32_t>& stable_vertices = {});

}  // namespace mien
