// Confusion matrices as pictures: how often one rater (rows) gave which grade while the other
// (columns) gave which.
#pragma once

#include <string>
#include <vector>

#include "image.hpp"

namespace mien::cli {

struct Confusion {
    std::vector<std::vector<double>> counts;  ///< [row grade][column grade], square, whole, >= 0
    std::string title, row_label, column_label;
};

/// Counts of pairs of whole grades; pairs with a negative one (missing) are left out. The matrix
/// has `grades` rows, or as many as the highest grade needs when that is more.
std::vector<std::vector<double>> confusion_counts(const std::vector<int>& rows,
                                                  const std::vector<int>& columns, int grades);

/// A cell's colour is its share of its row, so that rare grades are read as well as frequent ones;
/// the number is the count. Cells on the diagonal are framed. Throws std::invalid_argument when the
/// matrix is empty or not square.
Image draw_confusion(const Confusion& confusion);

/// Several matrices, three a line.
Image draw_confusions(const std::vector<Confusion>& matrices);

}  // namespace mien::cli
