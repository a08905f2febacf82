// The evaluator against the layers' equations in double, and what a call promises: the same bits
// for any number of threads, no allocation, an end after a cancel, no number that is none.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "unit/learning/network_reference.hpp"
#include "unit/learning/network_support.hpp"

namespace {
std::atomic<std::size_t> num_allocations{0};
}

// Not inlined: GCC would take malloc() for the wrong partner of operator delete.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++num_allocations;
    if (void* block = std::malloc(size)) return block;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
    ++num_allocations;
    const auto unit = static_cast<std::size_t>(alignment);
    if (void* block = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return block;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* block) noexcept {
    std::free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::align_val_t) noexcept {
    std::free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    std::free(block);
}

namespace mien {
namespace {

using namespace test;

/// Largest difference over the largest magnitude.
double relative_error(const std::vector<float>& found, const Numbers& right) {
    double error = 0, size = 0;
    for (std::size_t k = 0; k < right.size(); ++k) {
        error = std::max(error, std::fabs(static_cast<double>(found[k]) - right[k]));
        size = std::max(size, std::fabs(right[k]));
    }
    return error / size;
}

void expect_as_written(const NetworkLayers& network, const std::vector<NetworkLayer>& layers,
                       std::uint64_t seed, const std::string& what) {
    check_layers(network);
    const NetworkProgram program(network, layers, {});
    const std::vector<float> in = random_input(program.inputs(), seed);
    const Numbers right = reference_run(network, layers, Numbers(in.begin(), in.end()));
    std::vector<float> out(program.outputs());
    for (const bool portable : {false, true}) {
        dense::use_portable_loops(portable);
        program.run(in.data(), out.data(), {});
        EXPECT_LT(relative_error(out, right), 1e-5) << what << (portable ? ", portable" : "");
    }
    dense::use_portable_loops(false);
}

TEST(NetworkLayer, EveryKindIsWhatItsEquationSays) {
    std::uint64_t seed = 1;
    for (const LayerKind kind :
         {LayerKind::gather, LayerKind::steered, LayerKind::basis, LayerKind::permuted,
          LayerKind::dense, LayerKind::pick, LayerKind::sparse, LayerKind::elu, LayerKind::affine})
        for (int variant = 0; variant < 3; ++variant)
            // Channels below, at and beside the lanes' width; few rows and more than one panel.
            for (const Index channels : {3, 9, 16, 20}) {
                const bool fixed = kind == LayerKind::pick || kind == LayerKind::sparse ||
                                   kind == LayerKind::elu || kind == LayerKind::affine;
                const bool same = variant == 1 && kind == LayerKind::basis;
                const Index rows = kind == LayerKind::dense ? 12 : 230;
                const Index rows_out =
                    kind == LayerKind::elu || kind == LayerKind::affine || same ? rows : rows / 2;
                const Index out = fixed || same ? channels : 19 - channels / 2;
                const NetworkLayers network = random_layer(kind, rows, channels, rows_out, out,
                                                           variant != 2, variant, ++seed);
                expect_as_written(network, network.encoder, seed,
                                  std::string(layer_kind_name(kind)) + " of " +
                                      std::to_string(channels) + " channels, variant " +
                                      std::to_string(variant));
            }
}

TEST(NetworkLayer, BasisIsTheSameInBothOrders) {
    // Few rows to many: the inputs are projected first; many to few: they are contracted first.
    for (const Index rows : {20, 600}) {
        const NetworkLayers network =
            random_layer(LayerKind::basis, rows, 16, 620 - rows, 12, true, 0, 5);
        expect_as_written(network, network.encoder, 3, std::to_string(rows) + " rows");
    }
}

TEST(NetworkLayer, EluKeepsSmallNumbers) {
    const NetworkLayers network = random_layer(LayerKind::elu, 1, 6, 1, 6, true, 0, 1);
    const NetworkProgram program(network, network.encoder, {});
    const std::vector<float> in{-1e-6f, -3e-3f, -0.4f, -5.0f, -300.0f, 2.5f};
    std::vector<float> out(6);
    program.run(in.data(), out.data(), {});
    for (std::size_t k = 0; k < in.size(); ++k) {
        const double right = in[k] > 0 ? in[k] : std::expm1(static_cast<double>(in[k]));
        EXPECT_NEAR(out[k], right, 2e-7 * std::fabs(right)) << in[k];
    }
}

TEST(Network, TheFiveOperatorsAgreeWithADoubleEvaluation) {
    const TriMesh mesh = face_like(24);  // 625 vertices
    for (const NetworkOperator op : kAllOperators)
        for (const Index channels : {3, 9}) {
            NetworkOptions options;
            options.op = op;
            options.channels_in = options.channels_out = channels;
            options.mixing_bases = channels == 9 ? 8 : 0;
            const NetworkLayers network = build_network(mesh, options, {});
            const std::string name = network_operator_name(op);
            expect_as_written(network, network.encoder, 1, name + " encoder");
            expect_as_written(network, network.decoder, 2, name + " decoder");
        }
}

TEST(Network, GivesTheSameBitsForAnyNumberOfThreadsWithoutAllocating) {
    const TriMesh mesh = face_like(24);
    for (const NetworkOperator op : kAllOperators) {
        NetworkOptions options;
        options.op = op;
        const NetworkLayers network = build_network(mesh, options, {});
        const NetworkProgram program(network, network.decoder, {});
        const std::vector<float> code = random_input(program.inputs(), 4);
        std::vector<float> one(program.outputs()), four(program.outputs());
        program.run(code.data(), one.data(), {});
        ThreadPool pool(4);
        Context context;
        context.pool = &pool;
        program.run(code.data(), four.data(), context);
        EXPECT_EQ(one, four) << network_operator_name(op);
        const std::size_t before = num_allocations;
        program.run(code.data(), four.data(), context);
        program.run(code.data(), one.data(), {});
        EXPECT_EQ(num_allocations, before) << network_operator_name(op);
    }
}

TEST(Network, EndsAfterACancel) {
    const NetworkLayers network = build_network(face_like(12), {}, {});
    const NetworkProgram program(network, network.encoder, {});
    CancelToken token;
    Context context;
    context.cancel = &token;
    token.request();
    const std::vector<float> in = random_input(program.inputs(), 4);
    std::vector<float> out(program.outputs());
    try {
        program.run(in.data(), out.data(), context);
        ADD_FAILURE() << "was not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::cancelled);
    }
    program.run(in.data(), out.data(), {});  // the work space came back
}

TEST(Network, NeverGivesNumbersThatAreNone) {
    NetworkLayers network = random_layer(LayerKind::gather, 40, 3, 20, 8, true, 0, 3);
    const NetworkProgram program(network, network.encoder, {});
    for (const float bad : {3e38f, std::numeric_limits<float>::quiet_NaN()}) {
        const std::vector<float> in(program.inputs(), bad);
        std::vector<float> out(program.outputs());
        try {
            program.run(in.data(), out.data(), {});
            ADD_FAILURE() << bad << " went through";
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::no_solution);
        }
    }
}

TEST(Network, CodeOfTheMeshAutoencoderFitsItsCoarsestLevel) {
    NetworkOptions options;
    options.op = NetworkOperator::mesh_autoencoder;
    const NetworkLayers network = build_network(face_like(24), options, {});
    const NetworkLayer& last = network.encoder.back();
    EXPECT_GE(last.rows_out, 8);
    EXPECT_LE(last.rows_out, 24);
    EXPECT_NEAR(static_cast<double>(last.rows_out * last.channels_out), 64,
                static_cast<double>(last.rows_out) / 2);
    ASSERT_EQ(network.variance.size(), 1u);
    EXPECT_EQ(network.variance[0].rows_out, last.rows_out);
}

TEST(Network, WeightsDependOnTheSeedAlone) {
    const TriMesh mesh = face_like(12);
    NetworkOptions options;
    const NetworkLayers first = build_network(mesh, options, {});
    const NetworkLayers again = build_network(mesh, options, {});
    options.seed = 2;
    const NetworkLayers other = build_network(mesh, options, {});
    const auto value = [](const NetworkLayers& n) {
        return n.tensors.at("encoder.1.weight").floats()[5];
    };
    EXPECT_EQ(value(first), value(again));
    EXPECT_NE(value(first), value(other));
}

}  // namespace
}  // namespace mien
