// One layer made ready to run: weights packed for the inner loops, sizes of its work space known.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <new>
#include <vector>

#include "base/context.hpp"
#include "learning/network_layers.hpp"
#include "learning/network_loops.hpp"

namespace mien {

/// The loops of this processor (dense::uses_avx2()).
const network_loops::Loops& network_kernels();

/// Floats on a 64-byte boundary, zero at first.
class AlignedFloats {
  public:
    void resize(std::size_t count);
    float* data() { return data_.get(); }
    const float* data() const { return data_.get(); }
    std::size_t size() const { return size_; }

  private:
    struct Free {
        void operator()(float* block) const;
    };
    std::unique_ptr<float, Free> data_;
    std::size_t size_ = 0;
};

/// A weight matrix in the order in which the product reads it.
class PackedMatrix {
  public:
    /// W is depth x columns, row-major. O(size).
    void pack(const float* weights, Index depth, Index columns);
    const float* data() const { return packed_.data(); }
    Index columns() const { return columns_; }

  private:
    AlignedFloats packed_;
    Index columns_ = 0;
};

/// What one thread works in, sized for the greediest layer.
struct PanelScratch {
    AlignedFloats floats;
    std::vector<const float*> pointers;
    std::atomic<bool> taken{false};
};

/// What one evaluation works in: no layer allocates.
struct NetworkWorkspace {
    AlignedFloats activations[2], shared;
    std::vector<std::unique_ptr<PanelScratch>> panels;  ///< at least one per thread
};

/// The parallel unit is the panel, a fixed number of rows of a layer.
class PanelLoop {
  public:
    PanelLoop(const Context& context, NetworkWorkspace& workspace)
        : context_(context), workspace_(workspace) {}

    float* shared() const { return workspace_.shared.data(); }

    /// body(first row, number of rows, scratch) for every panel; cancellation is checked before
    /// each.
    template <typename Body>
    void run(Index rows, Index panel, const Body& body) const {
        const auto count = static_cast<std::size_t>((rows + panel - 1) / panel);
        const auto one = [&](std::size_t chunk) {
            context_.check_cancelled();
            const Taken scratch(workspace_);
            const Index first = static_cast<Index>(chunk) * panel;
            body(first, std::min(panel, rows - first), *scratch.scratch);
        };
        // By reference: a function object that holds the closure itself would allocate.
        if (context_.pool != nullptr)
            context_.pool->run(count, std::ref(one));
        else
            for (std::size_t chunk = 0; chunk < count; ++chunk) one(chunk);
    }

  private:
    /// A scratch that no other thread holds; there is one for each that can run.
    struct Taken {
        explicit Taken(NetworkWorkspace& workspace);
        ~Taken() { scratch->taken.store(false, std::memory_order_release); }
        Taken(const Taken&) = delete;
        Taken& operator=(const Taken&) = delete;
        PanelScratch* scratch = nullptr;
    };
    const Context& context_;
    NetworkWorkspace& workspace_;
};

/// A pure function of its input. Immutable; runs on several threads at once, each with its own
/// work space.
class NetworkStep {
  public:
    virtual ~NetworkStep() = default;
    virtual void run(const float* in, float* out, const PanelLoop& panels) const = 0;

    /// Sizes of the work space: of the whole step, and of one panel.
    std::size_t shared_floats = 0, panel_floats = 0, panel_pointers = 0;
};

/// Rows of a panel whose packed input has `depth` floats a row: a share of the second-level cache,
/// in whole tiles of every instruction set.
Index panel_rows(Index depth);

// One maker per kind; the layer has passed check_layers(). They copy what they need in another
// order and keep the rest of the tensors alive.
using StepMaker = std::unique_ptr<NetworkStep> (*)(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_gather_step(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_steered_step(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_basis_step(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_permuted_step(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_dense_step(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_pick_step(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_sparse_step(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_elu_step(const NetworkLayers&, const NetworkLayer&);
std::unique_ptr<NetworkStep> make_affine_step(const NetworkLayers&, const NetworkLayer&);

}  // namespace mien
