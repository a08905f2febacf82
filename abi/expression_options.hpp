// What the files of expression functions share: reading options.
#pragma once

#include <cstdint>

#include "base/safetensors.hpp"
#include "expression/training.hpp"
#include "mien/mien.h"

namespace mien::abi {

void check_fit(std::int32_t method, const char* name);
void check_pose(std::int32_t pose);
/// The host's options over the defaults, and as the core takes them.
mien_train_options given_train_options(const mien_train_options* options);
/// Without the stable vertices: how many there can be is known once the dataset is open.
TrainOptions read_train_options(const mien_train_options& given);
/// Training looks at every face itself, so only the digest is compared: a damaged dataset would
/// train another model.
inline SafetensorsReadOptions digest_alone() {
    SafetensorsReadOptions options;
    options.verify_finite = false;
    return options;
}

}  // namespace mien::abi
