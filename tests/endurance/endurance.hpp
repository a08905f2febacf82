// What the endurance programs share: faults, a folder of their own, sessions, whole files.
#pragma once

#include <cstdint>
#include <string>

#include "abi/abuse/abuse.hpp"
#include "fuzz/mutate.hpp"
#include "fuzz/own_folder.hpp"

namespace endurance {

using namespace abuse;
using mien::fuzz::OwnFolder;
using mien::fuzz::Random;
using mien::fuzz::read_file;
using mien::fuzz::write_file;

/// Counts a fault; the first twenty are printed.
void fault(const std::string& what);
long num_faults();

/// A session of one thread.
mien_session* new_session(double max_seconds = 0);

// files.cpp
void run_flips(long count, std::uint64_t seed);
void run_truncations(long count, std::uint64_t seed);
void run_full_disk(long count, std::uint64_t seed);
void run_kills(long count, std::uint64_t seed);
// calls.cpp
void run_cancels(long count, std::uint64_t seed);
void run_soak(long count);
// latency.cpp
void run_latency(long count);
// meshes.cpp
void run_crafted(bool whole);
void run_corpus(const std::string& folder);

}  // namespace endurance
