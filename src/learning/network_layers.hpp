// A network on registered faces as data: an ordered list of layers over named tensors. One list
// serves the file, the evaluator and the trainer, so that these cannot drift apart.
//
// A layer maps X (rows_in x channels_in) to Y (rows_out x channels_out), both row-major. Where a
// list names row number rows_in, the row is zero (padding). act() is ELU with alpha 1, or nothing.
//
// gather    y_i = act(W [x_S(i,1); ...; x_S(i,L)] + b)                              SpiralNet++,
// Neural3DMM steered   y_i = act(b + sum_m W_m 1/|N| sum_j q_m(i,j) x_j), q = softmax_m(u_m (x_j -
// x_c(i)) + c_m)
//                                                                                    FeaStNet
// basis     y_i = sqrt(1 - rate) act(b + sum_j sum_k a_jk G_k x_j) + sqrt(rate) C sum_j rho_j x_j,
//           rho_j = |p_j| / sum |p_j| over i's entries                               Mesh
//           Autoencoder
// permuted  z_i = ELU(A_i' [x_j]), y_i = act(W vec(z_i) + b) + R x_i + s              LSA-3DMM
// dense     y = act(W vec(X) + b), over all rows
// pick      y_i = x_k(i)
// sparse    y_i = sum_j v_j x_j
// elu       y = ELU(x)
// affine    y = scale x + shift, per row and channel or per channel
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/safetensors.hpp"
#include "base/types.hpp"

namespace mien {

enum class LayerKind : std::int32_t {
    gather,
    steered,
    basis,
    permuted,
    dense,
    pick,
    sparse,
    elu,
    affine,
};
const char* layer_kind_name(LayerKind kind);

/// f32 (weights) or u32 (lists); the data live as long as `owner`.
struct NetworkTensor {
    DType dtype = DType::f32;
    std::vector<std::uint64_t> shape;
    const void* data = nullptr;
    std::shared_ptr<const void> owner;

    std::uint64_t count() const;
    const float* floats() const { return static_cast<const float*>(data); }
    const std::uint32_t* numbers() const { return static_cast<const std::uint32_t*>(data); }
};
NetworkTensor make_tensor(std::vector<std::uint64_t> shape, std::vector<float> values);
NetworkTensor make_tensor(std::vector<std::uint64_t> shape, std::vector<std::uint32_t> values);
using NetworkTensors = std::map<std::string, NetworkTensor>;

/// Tensors by role (I = channels_in, O = channels_out, n = rows_out, E = entries of all rows):
///   gather    index u32 [n, L], weight [L I, O], bias [O]
///   steered   begin u32 [n + 1], neighbour u32 [E], centre u32 [n], steer [I, M], offset [M],
///             weight [M I, O], bias [O]
///   basis     begin, neighbour, coefficient [E, B], weight [B I, O], bias [O]; density [E] (p;
///             absent: the rows stay the same), shortcut [I, O] (C; absent: I = O)
///   permuted  index u32 [n, K], mixing [n, K, K] or mixing_weight [n, S] with mixing_basis
///             [S, K, K], weight [K I, O], bias [O], shortcut [I, O], shortcut_bias [O]
///   dense     weight [rows_in I, rows_out O], bias [rows_out O]
///   pick      index u32 [n]
///   sparse    begin, neighbour, value [E]
///   affine    scale and shift, [n, O] or [1, O]
struct NetworkLayer {
    LayerKind kind = LayerKind::elu;
    Index rows_in = 0, channels_in = 0, rows_out = 0, channels_out = 0;
    bool elu = false;                            ///< act() is ELU
    double residual_rate = 0;                    ///< of basis, 0 to 1
    std::map<std::string, std::string> tensors;  ///< name by role
};

struct NetworkLayers {
    std::vector<NetworkLayer> encoder;  ///< features -> code; empty: the network only decodes
    std::vector<NetworkLayer> decoder;  ///< code -> features; empty: it only encodes
    /// Of a variational network in training: the log-variance, from the input of the encoder's last
    /// layer. Empty otherwise; files of finished networks have none.
    std::vector<NetworkLayer> variance;
    /// Numbers of another network's code that the decoder takes beside its own: in each of its
    /// input rows first the own channels, then the other's. 0: it decodes its own code alone.
    Index condition = 0;
    NetworkTensors tensors;

    /// The tensor of a role; it must be there (check_layers()).
    const NetworkTensor& tensor(const NetworkLayer& layer, const char* role) const;
    bool has(const NetworkLayer& layer, const char* role) const {
        return layer.tensors.count(role) != 0;
    }
};

/// Roles that training changes: everything in f32 but the values of sparse and affine layers.
bool is_trained_role(LayerKind kind, const std::string& role);

/// Multiply-adds of one evaluation, in the order that the evaluator takes.
double layer_products(const NetworkLayers& network, const NetworkLayer& layer);

/// What a list from a file must be before anything runs on it: tensors of the right dtype and
/// shape, every index in range, rows that ascend, layers that fit each other, sizes below the
/// limits. Throws Status::bad_format naming the layer. O(size of the lists).
void check_layers(const NetworkLayers& network);

/// {"encoder": [...], "decoder": [...]} and back (without tensors).
std::string layers_json(const NetworkLayers& network);
void read_layers_json(const std::string& json, NetworkLayers& network);

}  // namespace mien
