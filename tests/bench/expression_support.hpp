// What the programs on expressions share.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "expression/column_source.hpp"

namespace mien {

/// A source without one expression.
class Without final : public ColumnSource {
  public:
    Without(std::unique_ptr<ColumnSource> all, int expression) : all_(std::move(all)) {
        num_vertices = all_->num_vertices;
        triangles = all_->triangles;
        expression_names = all_->expression_names;
        neutral_subject = all_->neutral_subject;
        for (Index k = 0; k < all_->num_displacements(); ++k) {
            const auto place = static_cast<std::size_t>(k);
            if (all_->displacement_expression[place] == expression) continue;
            kept_.push_back(k);
            displacement_subject.push_back(all_->displacement_subject[place]);
            displacement_expression.push_back(all_->displacement_expression[place]);
        }
    }
    void neutrals(Index begin, Eigen::Ref<Matrix> block) const override {
        all_->neutrals(begin, block);
    }
    void displacements(Index begin, Eigen::Ref<Matrix> block) const override {
        for (Index k = 0; k < block.cols(); ++k)
            all_->displacements(kept_[static_cast<std::size_t>(begin + k)], block.middleCols(k, 1));
    }

  private:
    std::unique_ptr<ColumnSource> all_;
    std::vector<Index> kept_;
};

inline double mean_distance(const Points& a, const Points& b) {
    return (a - b).rowwise().norm().mean();
}

}  // namespace mien
