// The scan as a search over thousands of poses sees it: near any place, one of a few thousand
// points and its normal, found by one look at a table of cells. Cells lie in the scan's own frame,
// so that a turned scan has the same ones.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "registration/scan_surface.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct SearchFieldSettings {
    double cell_mm = 10;  ///< mm, > 0: side of a cell [J]
    int layers = 4;       ///< >= 0: cells around the scan that know of it too [J]
};

class SearchField {
  public:
    /// `numbers`: vertices of the scan that stand for it. O(#numbers layers) time and memory.
    SearchField(const ScanView& scan, const std::vector<Index>& numbers, const Matrix3& frame,
                const SearchFieldSettings& settings);

    struct Near {
        const double* place;   ///< mm, three, own frame; null: nothing is near
        const double* normal;  ///< unit, three, own frame
    };
    /// `place` in the own frame. Of the points the one that is nearest to the middle of the place's
    /// cell, or nearly so.
    Near near(const Vector3& place) const;

    /// Own frame -> scan.
    const Matrix3& frame() const { return frame_; }

  private:
    std::int64_t key_of(const Vector3& place) const;

    Matrix3 frame_;
    double cell_mm_;
    Points places_, normals_;                                 ///< own frame
    std::unordered_map<std::int64_t, std::int32_t> nearest_;  ///< of a cell's middle
};

}  // namespace mien
