#include "spatial/tree_order.hpp"

#include <algorithm>
#include <cstring>
#include <Eigen/Core>
#include <limits>
#include <utility>

#include "base/parallel.hpp"

namespace mien {
namespace {

constexpr std::size_t kTaskRange = 4096;  // below this a task sorts a range to the end by itself
constexpr std::size_t kFewItems = 32;     // ranges that are cut by counting
constexpr std::size_t kBoxItems = 256;    // of larger ranges a sample tells the widest axis
constexpr std::ptrdiff_t kSampleFrom = 1024;  // items whose pivots come from a sample

struct ComesBefore {
    int axis;
    bool operator()(const TreeItem& x, const TreeItem& y) const {
        return x.centroid[axis] < y.centroid[axis] ||
               (x.centroid[axis] == y.centroid[axis] && x.id < y.id);
    }
};

// Near the middle of the range.
TreeItem middle_of_nine(const TreeItem* begin, const TreeItem* end, const ComesBefore& before) {
    const auto middle_of_three = [&](const TreeItem* a, const TreeItem* b, const TreeItem* c) {
        if (before(*b, *a)) std::swap(a, b);
        if (before(*c, *b)) std::swap(b, c);
        return before(*b, *a) ? a : b;
    };
    const std::ptrdiff_t eighth = (end - begin) / 8;
    return *middle_of_three(
        middle_of_three(begin, begin + eighth, begin + 2 * eighth),
        middle_of_three(begin + 3 * eighth, begin + 4 * eighth, begin + 5 * eighth),
        middle_of_three(begin + 6 * eighth, begin + 7 * eighth, end - 1));
}

// A little beyond the wanted place, seen from the range's middle: what is left to look at is all of
// the smaller side, and soon little (Floyd and Rivest, Expected time bounds for selection, 1975).
TreeItem pivot_beyond(const TreeItem* begin, const TreeItem* nth, const TreeItem* end,
                      const ComesBefore& before) {
    constexpr int kMost = 255;
    TreeItem sample[kMost];
    const std::ptrdiff_t count = end - begin;
    const int size = count > 16 * kSampleFrom ? kMost : 63;
    for (int k = 0; k < size; ++k) sample[k] = begin[(2 * k + 1) * count / (2 * size)];
    const double share = static_cast<double>(nth - begin) / static_cast<double>(count);
    const double beyond = 1 + 1.2 * std::sqrt(size * share * (1 - share));
    const double wanted = size * share + (share > 0.5 ? -beyond : beyond);
    const int place = std::min(size - 1, std::max(0, static_cast<int>(wanted)));
    std::nth_element(sample, sample + place, sample + size, before);
    return sample[place];
}

// std::nth_element without a branch on the comparisons, which no processor can foresee: each round
// swaps every item with the one at a border and moves the border past those before the pivot.
void select_nth(TreeItem* begin, TreeItem* nth, TreeItem* end, int axis) {
    constexpr std::ptrdiff_t kFew = 8;  // the library's is as fast then
    constexpr int kMostRounds = 64;     // far more than good pivots need; then the library's, which
                                        // is never quadratic
    const ComesBefore before{axis};
    for (int round = 0; end - begin > kFew && round < kMostRounds; ++round) {
        const TreeItem pivot = end - begin >= kSampleFrom ? pivot_beyond(begin, nth, end, before)
                                                          : middle_of_nine(begin, end, before);
        const float value = pivot.centroid[axis];
        TreeItem* border = begin;
        for (TreeItem* item = begin; item != end; ++item) {
            const TreeItem here = *item;
            const float x = here.centroid[axis];
            *item = *border;
            *border = here;
            border += static_cast<int>(x < value) |
                      (static_cast<int>(x == value) & static_cast<int>(here.id < pivot.id));
        }
        // [begin, border) lies before the pivot, which is in [border, end).
        if (nth < border) {
            end = border;
            continue;
        }
        if (border == begin) {  // nothing lies before the pivot: it is the first
            TreeItem* first = begin;
            while (first->id != pivot.id) ++first;
            std::swap(*begin, *first);
            if (nth == begin++) return;
            continue;
        }
        begin = border;
    }
    std::nth_element(begin, nth, end, before);
}

// The same for at most kMost items, by counting for each how many lie before it; equal ones by
// their place.
template <int kMost>
void select_few(TreeItem* begin, int half, int count, int axis) {
    float values[kMost];
    int before[kMost];
    for (int i = 0; i < kMost; ++i) {
        values[i] = i < count ? begin[i].centroid[axis] : std::numeric_limits<float>::infinity();
        before[i] = 0;
    }
    for (int j = 0; j < kMost; ++j)
        for (int i = 0; i < kMost; ++i) before[i] += values[j] < values[i];
    float last = -std::numeric_limits<float>::infinity();  // of the first half
    for (int i = 0; i < count; ++i) last = before[i] < half ? std::max(last, values[i]) : last;
    int equal = half;  // so many of those equal to `last` go first
    for (int i = 0; i < count; ++i) equal -= values[i] < last;
    TreeItem sorted[kMost];
    int first = 0, second = half;
    for (int i = 0; i < count; ++i) {
        const int is_last = values[i] == last;
        const int goes_first = static_cast<int>(values[i] < last) | (is_last & (equal > 0));
        equal -= is_last & goes_first;
        sorted[goes_first ? first : second] = begin[i];
        first += goes_first;
        second += 1 - goes_first;
    }
    std::memcpy(begin, sorted, static_cast<std::size_t>(count) * sizeof(TreeItem));
}

// The widest axis of the items' box; for many, of a sample's.
int widest_axis(const TreeItem* begin, const TreeItem* end) {
    static_assert(sizeof(TreeItem) == sizeof(Eigen::Array4f), "loaded as one");
    const std::ptrdiff_t count = end - begin,
                         stride = std::max<std::ptrdiff_t>(1, count / kBoxItems);
    Eigen::Array4f lower, upper, here;
    std::memcpy(lower.data(), begin, sizeof(TreeItem));
    upper = lower;
    for (const TreeItem* item = begin; item < end - (stride - 1); item += stride) {
        std::memcpy(here.data(), item, sizeof(TreeItem));  // the id as a fourth that is not read
        lower = lower.min(here);
        upper = upper.max(here);
    }
    const Eigen::Array4f sides = upper - lower;
    int axis = 0;
    for (int k = 1; k < 3; ++k) axis = sides[k] > sides[axis] ? k : axis;
    return axis;
}

// Partitions items[begin, end) so that the first `half` have the smaller centroids along the widest
// axis. Ties fall by index or place, so that the order does not depend on the library's partition.
void split(TreeItem* begin, TreeItem* end, std::size_t half) {
    const std::size_t count = static_cast<std::size_t>(end - begin);
    if (count <= half) return;
    const int axis = widest_axis(begin, end);
    if (count <= kFewItems / 2)
        select_few<kFewItems / 2>(begin, static_cast<int>(half), static_cast<int>(count), axis);
    else if (count <= kFewItems)
        select_few<kFewItems>(begin, static_cast<int>(half), static_cast<int>(count), axis);
    else
        select_nth(begin, begin + half, end, axis);
}

}  // namespace

void order_for_tree(RawVector<TreeItem>& items, std::size_t leaf_size, const Context& context) {
    TreeItem* const all = items.data();
    const std::size_t count = items.size();
    std::size_t half = leaf_size;
    while (2 * half < count) half *= 2;
    for (; half >= kTaskRange; half /= 2)
        parallel_for(
            context, (count + 2 * half - 1) / (2 * half), 1, [&](std::size_t range, std::size_t) {
                split(all + range * 2 * half, all + std::min(count, (range + 1) * 2 * half), half);
            });
    parallel_for(context, count, 2 * half, [&](std::size_t begin, std::size_t end) {
        for (std::size_t h = half; h >= leaf_size; h /= 2)
            for (std::size_t b = begin; b < end; b += 2 * h)
                split(all + b, all + std::min(end, b + 2 * h), h);
    });
}

}  // namespace mien
