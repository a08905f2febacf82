// Products of a tall float matrix with three columns. A general product packs the tall side first, which
// costs as much as the work itself; here each block of rows is streamed once.
#pragma once

#include "base/context.hpp"
#include "base/parallel.hpp"
#include "base/types.hpp"

namespace mien {

constexpr std::size_t kThinBlock = 512;

/// out (m x 3) = a (m x r) * x (r x 3).
template <typename Tall, typename Out>
void thin_multiply(const Tall& a, const Eigen::Ref<const Eigen::MatrixXf>& x, Out& out, const Context& context) {
    parallel_for(context, static_cast<std::size_t>(a.rows()), kThinBlock, [&](std::size_t begin, std::size_t end) {
        const Index first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
        Eigen::Array<float, Eigen::Dynamic, 3> sum = Eigen::Array<float, Eigen::Dynamic, 3>::Zero(count, 3);
        Index j = 0;
        for (; j + 1 < a.cols(); j += 2) {
            const auto left = a.col(j).segment(first, count).array();
            const auto right = a.col(j + 1).segment(first, count).array();
            for (int k = 0; k < 3; ++k) sum.col(k) += left * x(j, k) + right * x(j + 1, k);
        }
        for (; j < a.cols(); ++j)
            for (int k = 0; k < 3; ++k) sum.col(k) += a.col(j).segment(first, count).array() * x(j, k);
        out.middleRows(first, count) = sum.matrix();
    });
}

/// out (r x 3) = a' (r x m) * y (m x 3), added in block order.
template <typename Tall, typename In>
void thin_project(const Tall& a, const In& y, Eigen::MatrixXf& out, const Context& context) {
    const std::size_t m = static_cast<std::size_t>(a.rows());
    std::vector<Eigen::MatrixXf> parts((m + kThinBlock - 1) / kThinBlock);
    parallel_for(context, m, kThinBlock, [&](std::size_t begin, std::size_t end) {
        const Index first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
        Eigen::MatrixXf& part = parts[begin / kThinBlock];
        part.resize(a.cols(), 3);
        for (Index j = 0; j < a.cols(); ++j)
            for (int k = 0; k < 3; ++k)
                part(j, k) = a.col(j).segment(first, count).dot(y.col(k).segment(first, count));
    });
    out.setZero(a.cols(), 3);
    for (const Eigen::MatrixXf& part : parts) out += part;
}

}  // namespace mien
