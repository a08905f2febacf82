// The triangles around each vertex: for fields that are averaged over them many times, and for what
// they tell of the surface's sides.
//
// A round gives a vertex the mean of its triangles' means: with d triangles around v, which name
// its neighbours n_k and p_k as the next and the previous corner,
//
//   sum over the triangles of (f_a + f_b + f_c) = d f_v + sum_k f(n_k) + sum_k f(p_k).
//
// Where the surface is whole around v, both lists hold the same vertices, and one is read.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/raw_vector.hpp"
#include "base/types.hpp"

namespace mien {

class TriangleFans {
  public:
    /// Triangles name no vertex twice (clean_mesh()). 24 bytes a triangle. O(V + F
    /// log degree).
    TriangleFans(Index num_vertices, const TrianglesRef& triangles, const Context& context);

    Index num_vertices() const { return static_cast<Index>(begin_.size()) - 1; }
    /// Of triangles at the vertex.
    std::uint32_t count(std::size_t vertex) const { return begin_[vertex + 1] - begin_[vertex]; }
    /// #V, 1 where an edge at the vertex has one triangle alone.
    std::vector<std::uint8_t> border(const Context& context) const;
    /// No two triangles run along an edge in the same direction: no edge has more than two, and all
    /// that meet at one are wound alike.
    bool wound_alike() const { return wound_alike_; }
    /// Ascending: vertices whose triangles may form more than one fan, joined across edges; all
    /// such vertices are among them when wound_alike().
    const std::vector<std::uint32_t>& pinched() const { return pinched_; }

    /// averaged = the sum above, of fields with kWidth floats a vertex (a multiple of 4), for the
    /// vertices from `begin` to before `end`. To be called in chunks, on any thread.
    template <int kWidth>
    void add_up(const Eigen::Matrix<float, Eigen::Dynamic, kWidth, Eigen::RowMajor>& field,
                std::size_t begin, std::size_t end,
                Eigen::Matrix<float, Eigen::Dynamic, kWidth, Eigen::RowMajor>& sums) const {
        using Row = Eigen::Array<float, 1, kWidth>;
        const auto at = [&](std::size_t vertex) {
            return Eigen::Map<const Row>(field.data() + static_cast<Index>(vertex) * kWidth);
        };
        for (std::size_t v = begin; v < end; ++v) {
            Row sum = Row::Zero();
            for (std::uint32_t k = begin_[v]; k < begin_[v + 1]; ++k) sum += at(next_[k]);
            if (whole_[v])
                sum += sum;
            else
                for (std::uint32_t k = begin_[v]; k < begin_[v + 1]; ++k) sum += at(previous_[k]);
            Eigen::Map<Row>(sums.data() + static_cast<Index>(v) * kWidth) =
                sum + static_cast<float>(count(v)) * at(v);
        }
    }

  private:
    void inspect(std::size_t vertex, bool& alike, std::vector<std::uint32_t>& pinched);

    std::vector<std::uint32_t> begin_;          // #V + 1 offsets
    RawVector<std::uint32_t> next_, previous_;  // by triangle, ascending within a vertex
    RawVector<std::uint8_t> whole_;             // #V: both lists hold the same vertices
    bool wound_alike_ = true;
    std::vector<std::uint32_t> pinched_;
};

}  // namespace mien
