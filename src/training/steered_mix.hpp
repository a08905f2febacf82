// The middle of a steered layer (FeaStNet) in libtorch: what its matrices are applied to.
#pragma once

#include <torch/torch.h>

namespace mien::training {

/// For every output row i and matrix m, sum over the row's entries k of steer[i, k, m]
/// x[neighbour]. steer: [batch, rows, places, matrices]; x: [batch, rows_in, channels]; neighbour:
/// [rows * places], int64; entries: [rows], int64, of which places count. Gives [batch, rows,
/// matrices * channels], with gradients for steer and x. On a processor one pass over the lists,
/// where libtorch would call a product of tiny matrices for each row; on an accelerator those
/// products.
torch::Tensor steered_mix(const torch::Tensor& steer, const torch::Tensor& x,
                          const torch::Tensor& neighbour, const torch::Tensor& entries);

/// The same by libtorch's own products, for accelerators: steer must be 0 in places without entry.
torch::Tensor steered_mix_by_products(const torch::Tensor& steer, const torch::Tensor& x,
                                      const torch::Tensor& neighbour);

}  // namespace mien::training
