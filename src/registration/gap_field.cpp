#include "registration/gap_field.hpp"

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"

namespace mien {
namespace {

constexpr Index kChunk = 2048;

// The sum over a vertex' neighbours of `field`, for `count` vertices.
template <int kDegree>
void add_up(const std::uint32_t* neighbours, Index count, const float* field, float* sums) {
    for (Index i = 0; i < count; ++i) {
        float sum = field[neighbours[i]];
        for (int k = 1; k < kDegree; ++k) sum += field[neighbours[k * count + i]];
        sums[i] = sum;
    }
}

void add_up_any(int degree, const std::uint32_t* neighbours, Index count, const float* field,
                float* sums) {
    for (Index i = 0; i < count; ++i) sums[i] = 0;
    for (int k = 0; k < degree; ++k)
        for (Index i = 0; i < count; ++i) sums[i] += field[neighbours[k * count + i]];
}

void add_neighbours(int degree, const std::uint32_t* neighbours, Index count, const float* field,
                    float* sums) {
    switch (degree) {
        case 2:
            return add_up<2>(neighbours, count, field, sums);
        case 3:
            return add_up<3>(neighbours, count, field, sums);
        case 4:
            return add_up<4>(neighbours, count, field, sums);
        case 5:
            return add_up<5>(neighbours, count, field, sums);
        case 6:
            return add_up<6>(neighbours, count, field, sums);
        case 7:
            return add_up<7>(neighbours, count, field, sums);
        case 8:
            return add_up<8>(neighbours, count, field, sums);
        default:
            return add_up_any(degree, neighbours, count, field, sums);
    }
}

}  // namespace

GapField::GapField(const VertexRings& rings) : n_(rings.num_vertices()) {
    const std::size_t n = static_cast<std::size_t>(n_);
    vertex_of_.resize(n);
    std::iota(vertex_of_.begin(), vertex_of_.end(), 0u);
    std::stable_sort(vertex_of_.begin(), vertex_of_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return rings.of(a).size() < rings.of(b).size();
    });
    std::vector<std::uint32_t> place_of(n);
    for (std::size_t i = 0; i < n; ++i) place_of[vertex_of_[i]] = static_cast<std::uint32_t>(i);
    neighbours_.reserve(rings.neighbours.size());
    for (std::size_t first = 0; first < n;) {
        const std::size_t degree = rings.of(vertex_of_[first]).size();
        std::size_t last = first;
        while (last < n && last - first < static_cast<std::size_t>(kChunk) &&
               rings.of(vertex_of_[last]).size() == degree)
            ++last;
        runs_.push_back({static_cast<Index>(first), static_cast<Index>(last - first),
                         static_cast<int>(degree), neighbours_.size()});
        for (std::size_t k = 0; k < degree; ++k)
            for (std::size_t i = first; i < last; ++i)
                neighbours_.push_back(place_of[*(rings.of(vertex_of_[i]).begin() + k)]);
        first = last;
    }
    for (Eigen::ArrayXf* field :
         {&diagonal_, &delta_, &residual_, &direction_, &image_, &bent_, &shared_})
        field->setZero(n_);
}

double GapField::sum_of_products(const Eigen::ArrayXf& a, const Eigen::ArrayXf& b) const {
    constexpr Index kStrip = 1024;  // floats within, doubles over the strips
    double sum = 0;
    for (Index first = 0; first < n_; first += kStrip) {
        const Index count = std::min(kStrip, n_ - first);
        sum += static_cast<double>(
            a.segment(first, count).matrix().dot(b.segment(first, count).matrix()));
    }
    return sum;
}

// image = (W + alpha L'L + e) direction.
void GapField::apply(const Context& context) {
    parallel_for(context, runs_.size(), 1, [&](std::size_t r, std::size_t) {
        const Run& run = runs_[r];
        auto bent = bent_.segment(run.first, run.count);
        if (run.degree == 0) {
            bent.setZero();
            shared_.segment(run.first, run.count).setZero();
            return;
        }
        const float share = 1 / static_cast<float>(run.degree);
        add_neighbours(run.degree, neighbours_.data() + run.neighbours, run.count,
                       direction_.data(), bent.data());
        bent = direction_.segment(run.first, run.count) - share * bent;
        shared_.segment(run.first, run.count) = share * bent;
    });
    parallel_for(context, runs_.size(), 1, [&](std::size_t r, std::size_t) {
        const Run& run = runs_[r];
        auto image = image_.segment(run.first, run.count);
        image.setZero();
        if (run.degree > 0)
            add_neighbours(run.degree, neighbours_.data() + run.neighbours, run.count,
                           shared_.data(), image.data());
        image = smoothness_ * (bent_.segment(run.first, run.count) - image) +
                diagonal_.segment(run.first, run.count) * direction_.segment(run.first, run.count);
    });
}

Vector GapField::solve(const Vector& weight, const Vector& gap, const GapFieldSettings& settings,
                       const Context& context) {
    constexpr double kNothing = 1e-30;  // a field without any gap needs no step
    const Context alone;
    const Context& inside = n_ >= settings.threads_from ? context : alone;
    smoothness_ = static_cast<float>(settings.smoothness);
    for (Index i = 0; i < n_; ++i) {
        const Index v = static_cast<Index>(vertex_of_[static_cast<std::size_t>(i)]);
        diagonal_[i] = static_cast<float>(weight[v] + settings.ground);
        residual_[i] = static_cast<float>(weight[v] * gap[v]);
    }
    delta_.setZero();
    direction_ = residual_;
    double rr = sum_of_products(residual_, residual_);
    const double limit = settings.tolerance * std::max(rr, kNothing);
    for (int k = 0; k < settings.most_iterations && rr > limit; ++k) {
        apply(inside);
        const float step = static_cast<float>(rr / sum_of_products(direction_, image_));
        delta_ += step * direction_;
        residual_ -= step * image_;
        const double next = sum_of_products(residual_, residual_);
        direction_ = residual_ + static_cast<float>(next / rr) * direction_;
        rr = next;
    }
    Vector delta(n_);
    for (Index i = 0; i < n_; ++i)
        delta[static_cast<Index>(vertex_of_[static_cast<std::size_t>(i)])] =
            static_cast<double>(delta_[i]);
    return delta;
}

}  // namespace mien
