// A list of layers made ready to run, one face at a time, in float.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "learning/network_step.hpp"

namespace mien {

/// Immutable; runs on several threads at once. Work spaces are kept: after the first run with some
/// number of threads no run allocates.
class NetworkProgram {
  public:
    /// The layers have passed check_layers(). Asks `context` for the memory.
    NetworkProgram(const NetworkLayers& network, const std::vector<NetworkLayer>& layers,
                   const Context& context);
    ~NetworkProgram();

    Index rows_in() const { return rows_in_; }
    Index channels_in() const { return channels_in_; }
    Index rows_out() const { return rows_out_; }
    Index channels_out() const { return channels_out_; }
    std::size_t inputs() const { return static_cast<std::size_t>(rows_in_ * channels_in_); }
    std::size_t outputs() const { return static_cast<std::size_t>(rows_out_ * channels_out_); }

    /// out (rows_out x channels_out) of in (rows_in x channels_in), row-major. Cancellation is
    /// checked between layers and panels. Throws Status::no_solution when a number of the result is
    /// not finite.
    void run(const float* in, float* out, const Context& context) const;

  private:
    std::unique_ptr<NetworkWorkspace> take_workspace(std::size_t num_threads) const;

    std::vector<std::unique_ptr<NetworkStep>> steps_;
    Index rows_in_ = 0, channels_in_ = 0, rows_out_ = 0, channels_out_ = 0;
    std::size_t activation_floats_ = 0, shared_floats_ = 0, panel_floats_ = 0, panel_pointers_ = 0;
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<NetworkWorkspace>> idle_;
};

}  // namespace mien
