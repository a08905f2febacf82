#include "registration/scan_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>

#include "base/parallel.hpp"

namespace mien {
namespace {

// The points sorted by cells as wide as the radius, so that a point's neighbours lie in 27 cells.
class CellList {
  public:
    CellList(const Points& points, double cell_mm)
        : points_(points), low_(points.colwise().minCoeff()), cell_mm_(cell_mm) {
        const Index n = points.rows();
        entries_.resize(static_cast<std::size_t>(n));
        for (Index i = 0; i < n; ++i)
            entries_[static_cast<std::size_t>(i)] = {
                key_of(points(i, 0) - low_[0], points(i, 1) - low_[1], points(i, 2) - low_[2]),
                static_cast<std::uint32_t>(i)};
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return a.key < b.key || (a.key == b.key && a.point < b.point);
        });
    }

    // Calls visit(offset) with the offsets from `centre` of the points within a cell's width, until
    // `most` have been visited.
    template <typename Visit>
    void around(const Eigen::RowVector3d& centre, int most, const Visit& visit) const {
        int count = 0;
        for (int a = -1; a <= 1; ++a)
            for (int b = -1; b <= 1; ++b)
                for (int c = -1; c <= 1; ++c) {
                    const Eigen::RowVector3d at =
                        centre - low_ + cell_mm_ * Eigen::RowVector3d(a, b, c);
                    const std::int64_t key = key_of(at[0], at[1], at[2]);
                    auto entry =
                        std::lower_bound(entries_.begin(), entries_.end(), key,
                                         [](const Entry& e, std::int64_t v) { return e.key < v; });
                    for (; entry != entries_.end() && entry->key == key && count < most; ++entry) {
                        const Eigen::RowVector3d d = points_.row(entry->point) - centre;
                        if (d.squaredNorm() > cell_mm_ * cell_mm_) continue;
                        visit(d);
                        ++count;
                    }
                }
    }

  private:
    struct Entry {
        std::int64_t key;
        std::uint32_t point;
    };
    // 21 bits an axis.
    std::int64_t key_of(double x, double y, double z) const {
        const auto cell = [&](double v) {
            return static_cast<std::int64_t>(std::floor(v / cell_mm_)) & 0x1fffff;
        };
        return cell(x) << 42 | cell(y) << 21 | cell(z);
    }

    const Points& points_;
    const Eigen::RowVector3d low_;
    const double cell_mm_;
    std::vector<Entry> entries_;
};

}  // namespace

double cloud_spacing(const Points& points, const ScanSurfaceSettings& settings) {
    const Index n = points.rows(), stride = std::max<Index>(1, n / settings.spacing_sample);
    std::vector<double> nearest;
    for (Index i = 0; i < n; i += stride) {
        double best = std::numeric_limits<double>::infinity();
        for (Index j = 0; j < n; ++j)
            if (j != i) best = std::min(best, (points.row(i) - points.row(j)).squaredNorm());
        nearest.push_back(std::sqrt(best));
    }
    std::nth_element(nearest.begin(),
                     nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2),
                     nearest.end());
    return nearest[nearest.size() / 2];
}

Points cloud_normals(const Points& points, double radius_mm, const ScanSurfaceSettings& settings,
                     const Context& context) {
    const Index n = points.rows();
    const Eigen::RowVector3d middle = points.colwise().mean();
    const CellList cells(points, radius_mm);
    Points normals = Points::Zero(n, 3);
    parallel_for(
        context, static_cast<std::size_t>(n), 512, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const Eigen::RowVector3d centre = points.row(static_cast<Index>(k));
                Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
                Matrix3 squares = Matrix3::Zero();
                int count = 0;
                cells.around(centre, settings.most_neighbours, [&](const Eigen::RowVector3d& d) {
                    sum += d;
                    squares += d.transpose() * d;
                    ++count;
                });
                if (count < settings.fewest_neighbours) continue;
                Eigen::SelfAdjointEigenSolver<Matrix3> eigen;
                eigen.computeDirect(
                    Matrix3(squares / count - sum.transpose() * sum / (count * count)));
                if (eigen.info() != Eigen::Success) continue;  // stays unknown
                Vector3 normal = eigen.eigenvectors().col(0);
                if (normal.dot((centre - middle).transpose()) < 0) normal = -normal;
                normals.row(static_cast<Index>(k)) = normal.transpose();
            }
        });
    return normals;
}

}  // namespace mien
