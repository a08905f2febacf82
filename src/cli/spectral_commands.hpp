// What the files of spectral commands share.
#pragma once

#include <cstdint>
#include <string>

#include "commands.hpp"

namespace mien::cli {

/// Values on vertices through the maps between the finest level and another.
struct HierarchyApplication {
    std::string file, direction = "down", in, field, out;
    std::uint32_t level = 1;
    int num_threads = 1;
};
void apply_hierarchy(const HierarchyApplication& application);

/// encode, decode, coefficients, synthesize, mode of `mien spectral`.
void add_coding_commands(CLI::App& group);

}  // namespace mien::cli
