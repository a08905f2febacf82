#include "spatial/point_cells.hpp"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

// Bits of a cell's number along one axis. What lies beyond falls into the last cell, which holds
// more than it need.
constexpr int kBits = 21;
constexpr std::uint64_t kLast = (std::uint64_t{1} << kBits) - 1;

std::uint64_t key_of(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    return x << (2 * kBits) | y << kBits | z;
}

}  // namespace

PointCells::PointCells(const Points& points, const std::vector<std::uint32_t>& members,
                       double width)
    : points_(points), width_(width) {
    if (members.empty()) return;
    low_ = points.row(members.front());
    for (const std::uint32_t i : members) low_ = low_.cwiseMin(points.row(i));
    entries_.reserve(members.size());
    for (const std::uint32_t i : members) {
        const Eigen::RowVector3d offset = points.row(i) - low_;
        entries_.push_back(
            {key_of(cell_along(offset[0]), cell_along(offset[1]), cell_along(offset[2])), i});
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return a.cell != b.cell ? a.cell < b.cell : a.point < b.point;
    });
}

std::uint64_t PointCells::cell_along(double offset) const {
    const double cell = std::floor(offset / width_);
    if (!(cell > 0)) return 0;
    return cell < static_cast<double>(kLast) ? static_cast<std::uint64_t>(cell) : kLast;
}

void PointCells::around(const Eigen::RowVector3d& centre, std::vector<std::uint32_t>& found) const {
    found.clear();
    const Eigen::RowVector3d offset = centre - low_;
    std::uint64_t first[3], last[3];
    for (int k = 0; k < 3; ++k) {
        first[k] = cell_along(offset[k] - width_);
        last[k] = cell_along(offset[k] + width_);
    }
    for (std::uint64_t x = first[0]; x <= last[0]; ++x)
        for (std::uint64_t y = first[1]; y <= last[1]; ++y) {
            const std::uint64_t end = key_of(x, y, last[2]);
            auto entry =
                std::lower_bound(entries_.begin(), entries_.end(), key_of(x, y, first[2]),
                                 [](const Entry& e, std::uint64_t cell) { return e.cell < cell; });
            for (; entry != entries_.end() && entry->cell <= end; ++entry)
                if ((points_.row(entry->point) - centre).squaredNorm() < width_ * width_)
                    found.push_back(entry->point);
        }
    std::sort(found.begin(), found.end());
}

}  // namespace mien
