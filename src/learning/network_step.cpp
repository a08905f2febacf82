#include "learning/network_step.hpp"

#include <algorithm>
#include <cstring>
#include <new>

#include "base/dense.hpp"
#include "base/error.hpp"

namespace mien {

const network_loops::Loops& network_kernels() {
#if defined(MIEN_AVX2)
    if (dense::uses_avx2()) return network_loops::avx2_loops();
#endif
    return network_loops::portable_loops();
}

void AlignedFloats::resize(std::size_t count) {
    if (count <= size_) return;
    // Eigen's, which count towards the memory of the call.
    auto* block =
        static_cast<float*>(Eigen::internal::handmade_aligned_malloc(count * sizeof(float), 64));
    if (block == nullptr) throw std::bad_alloc();
    std::memset(block, 0, count * sizeof(float));
    data_.reset(block);
    size_ = count;
}

void AlignedFloats::Free::operator()(float* block) const {
    Eigen::internal::handmade_aligned_free(block);
}

void PackedMatrix::pack(const float* weights, Index depth, Index columns) {
    using network_loops::kBlock;
    using network_loops::kWidth;
    columns_ = columns;
    const Index last = columns % kBlock;
    const Index padded = columns - last + (last == 0 ? 0 : last <= kWidth ? kWidth : kBlock);
    packed_.resize(static_cast<std::size_t>(padded * depth));
    float* to = packed_.data();
    for (Index column = 0; column < columns; column += kBlock) {
        const Index used = std::min<Index>(kBlock, columns - column);
        const Index width = used <= kWidth ? kWidth : kBlock;
        for (Index k = 0; k < depth; ++k, to += width)
            std::copy_n(weights + k * columns + column, used, to);
    }
}

PanelLoop::Taken::Taken(NetworkWorkspace& workspace) {
    for (const auto& candidate : workspace.panels)
        if (!candidate->taken.exchange(true, std::memory_order_acquire)) {
            scratch = candidate.get();
            return;
        }
    fail(Status::internal, "a network runs on more threads than its work space has room for");
}

Index panel_rows(Index depth) {
    constexpr Index kFloats = 32768;  // 128 KiB
    constexpr Index kTile = 12, kMost = 96;
    return std::max(kTile, std::min(kMost, kFloats / std::max<Index>(depth, 1) / kTile * kTile));
}

}  // namespace mien
