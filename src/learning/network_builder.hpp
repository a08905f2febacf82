// The autoencoders of kosk-2024, chapter 3, as lists of layers with their initial weights. The
// lists (hierarchy, spirals, neighbourhoods) are computed here once per template and belong to the
// file from then on.
#pragma once

#include <string>

#include "learning/network_layers.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

enum class NetworkOperator { feastnet, neural3dmm, spiralnet, mesh_autoencoder, lsa3dmm };
const char* network_operator_name(NetworkOperator op);
/// Throws Status::invalid_argument, listing the names, for one that is none.
NetworkOperator network_operator(const std::string& name);

struct NetworkOptions {
    NetworkOperator op = NetworkOperator::spiralnet;
    Index channels_in = 3, channels_out = 3;  ///< of the features
    Index latent = 64;  ///< numbers of the code; mesh_autoencoder takes the nearest multiple of its
                        ///< coarsest level
    bool conditioned = false;  ///< the decoder takes a second code of the same size beside its own
    std::vector<Index> widths{16, 32, 64, 128};        ///< channels by level, finest first
    std::vector<Index> mesh_widths{32, 64, 128, 128};  ///< the same of mesh_autoencoder
    double factor = 4;                                 ///< of vertices from level to level; > 1
    Index spiral_length = 9;                           ///< spiralnet
    Index matrices = 9;                                ///< feastnet, 1 to 64
    Index places = 9;                                  ///< lsa3dmm, 2 to 64
    Index mixing_bases = 0;      ///< lsa3dmm: 0: a matrix of its own for each vertex; else 1 to 64
    Index bases = 35;            ///< mesh_autoencoder, 1 to 1024
    double residual_rate = 0.5;  ///< mesh_autoencoder, 0 to 1
    std::int64_t reference_vertex = -1;  ///< neural3dmm; -1: the foremost (+z), the tip of the nose
    bool variational = true;             ///< mesh_autoencoder: with a log-variance for training
    std::uint64_t seed = 1;              ///< of the weights
};

/// Encoder and decoder over `mean` (the features' mean shape). Fewer levels than widths where the
/// template is small. O(#V log #V).
NetworkLayers build_network(const TriMesh& mean, const NetworkOptions& options,
                            const Context& context);

}  // namespace mien
