// What the endurance programs share: faults, a folder of their own, sessions, whole files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "abi/abuse/abuse.hpp"
#include "fuzz/mutate.hpp"

namespace endurance {

using namespace abuse;
using mien::fuzz::Random;

/// Counts a fault; the first twenty are printed.
void fault(const std::string& what);
long num_faults();

/// A folder of this run, which is the working folder while it lives.
class OwnFolder {
  public:
    OwnFolder() {
        std::random_device chance;
        folder_ =
            std::filesystem::temp_directory_path() / ("mien_endure_" + std::to_string(chance()));
        std::filesystem::create_directory(folder_);
        std::filesystem::current_path(folder_);
    }
    ~OwnFolder() {
        std::error_code ignored;
        std::filesystem::current_path(folder_.parent_path(), ignored);
        std::filesystem::remove_all(folder_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

  private:
    std::filesystem::path folder_;
};

inline std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void write_file(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

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
