#include "learning/network_program.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace mien {
namespace {

StepMaker step_maker(LayerKind kind) {
    switch (kind) {
        case LayerKind::gather:
            return make_gather_step;
        case LayerKind::steered:
            return make_steered_step;
        case LayerKind::basis:
            return make_basis_step;
        case LayerKind::permuted:
            return make_permuted_step;
        case LayerKind::dense:
            return make_dense_step;
        case LayerKind::pick:
            return make_pick_step;
        case LayerKind::sparse:
            return make_sparse_step;
        case LayerKind::elu:
            return make_elu_step;
        case LayerKind::affine:
            return make_affine_step;
    }
    fail(Status::internal, "layer kind %d is unknown", static_cast<int>(kind));
}

}  // namespace

NetworkProgram::NetworkProgram(const NetworkLayers& network,
                               const std::vector<NetworkLayer>& layers, const Context& context) {
    if (layers.empty()) fail(Status::internal, "a program of no layers");
    rows_in_ = layers.front().rows_in;
    channels_in_ = layers.front().channels_in;
    rows_out_ = layers.back().rows_out;
    channels_out_ = layers.back().channels_out;
    for (const NetworkLayer& layer : layers) {
        context.check_cancelled();
        steps_.push_back(step_maker(layer.kind)(network, layer));
        const NetworkStep& step = *steps_.back();
        activation_floats_ = std::max(
            activation_floats_, static_cast<std::size_t>(layer.rows_out * layer.channels_out));
        shared_floats_ = std::max(shared_floats_, step.shared_floats);
        panel_floats_ = std::max(panel_floats_, step.panel_floats);
        panel_pointers_ = std::max(panel_pointers_, step.panel_pointers);
    }
    const std::size_t threads =
        context.pool != nullptr ? static_cast<std::size_t>(context.pool->num_threads()) : 1;
    context.require_memory(
        sizeof(float) * (2 * activation_floats_ + shared_floats_ + threads * panel_floats_) +
            sizeof(float*) * threads * panel_pointers_,
        "the work space of a network");
    idle_.push_back(take_workspace(threads));
}

NetworkProgram::~NetworkProgram() = default;

std::unique_ptr<NetworkWorkspace> NetworkProgram::take_workspace(std::size_t num_threads) const {
    std::unique_ptr<NetworkWorkspace> workspace;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!idle_.empty()) {
            workspace = std::move(idle_.back());
            idle_.pop_back();
        }
    }
    if (!workspace) {
        workspace = std::make_unique<NetworkWorkspace>();
        for (AlignedFloats& floats : workspace->activations) floats.resize(activation_floats_);
        workspace->shared.resize(shared_floats_);
    }
    while (workspace->panels.size() < num_threads) {
        auto scratch = std::make_unique<PanelScratch>();
        scratch->floats.resize(panel_floats_);
        scratch->pointers.resize(panel_pointers_);
        workspace->panels.push_back(std::move(scratch));
    }
    return workspace;
}

void NetworkProgram::run(const float* in, float* out, const Context& context) const {
    // Gives the work space back whatever happens; the list of idle ones had room for it before.
    struct Loan {
        const NetworkProgram& owner;
        std::unique_ptr<NetworkWorkspace> workspace;
        ~Loan() {
            const std::lock_guard<std::mutex> lock(owner.mutex_);
            try {
                owner.idle_.push_back(std::move(workspace));
            } catch (const std::bad_alloc&) {  // then it is freed
            }
        }
    };
    const std::size_t threads =
        context.pool != nullptr ? static_cast<std::size_t>(context.pool->num_threads()) : 1;
    Loan loan{*this, take_workspace(threads)};
    const PanelLoop panels(context, *loan.workspace);
    const float* from = in;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        context.check_cancelled();
        float* to = k + 1 == steps_.size() ? out : loan.workspace->activations[k % 2].data();
        steps_[k]->run(from, to, panels);
        from = to;
    }
    const std::size_t count = outputs();
    for (std::size_t k = 0; k < count; ++k)
        if (!std::isfinite(out[k]))
            fail_at(Status::no_solution, static_cast<std::int64_t>(k),
                    "the network's result holds a number that is not finite; its input is unlike "
                    "anything that it was trained on, or its weights are not usable");
}

}  // namespace mien
