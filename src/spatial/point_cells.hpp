// Points sorted by cubic cells, so that all within a cell's width of a place are found in 27 cells.
#pragma once

#include <cstdint>
#include <vector>

#include "base/types.hpp"

namespace mien {

class PointCells {
  public:
    /// Some of `points` (#V x 3, any unit), by their numbers, in cells `width` wide (> 0, the same
    /// unit). Borrows `points`. O(n log n), 16 bytes a point.
    PointCells(const Points& points, const std::vector<std::uint32_t>& members, double width);

    /// The members closer to `centre` than a width, ascending; `found` is overwritten. O(27 log n +
    /// those in the cells around).
    void around(const Eigen::RowVector3d& centre, std::vector<std::uint32_t>& found) const;

  private:
    struct Entry {
        std::uint64_t cell;
        std::uint32_t point;
    };
    std::uint64_t cell_along(double offset) const;

    const Points& points_;
    Eigen::RowVector3d low_ = Eigen::RowVector3d::Zero();
    const double width_;
    std::vector<Entry> entries_;
};

}  // namespace mien
