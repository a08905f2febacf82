// Writes the network of the golden files: an untrained one over the template of their model, by the
// program's own writer. Made once (README.md), not by the tests.
//
//   write_network FOLDER     FOLDER/model.safetensors -> FOLDER/network.safetensors
#include <cstdio>
#include <string>

#include "base/safetensors.hpp"
#include "model/deformation_model.hpp"
#include "unit/learning/network_support.hpp"

int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    const mien::Context context;
    const auto model = mien::load_deformation_model(folder + "/model.safetensors", {}, context);
    mien::test::small_network(model->template_mesh, mien::NetworkOperator::spiralnet,
                              mien::FeatureKind::euclidean_standardised)
        ->save(folder + "/network.safetensors", context);
    std::puts("written");
    return 0;
}
