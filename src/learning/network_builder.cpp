#include "learning/network_builder.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/random.hpp"
#include "learning/hierarchy.hpp"
#include "learning/spirals.hpp"

namespace mien {
namespace {

/// A tensor's stream of chance is its name's: adding a layer leaves the others' weights alone.
std::uint64_t stream_of(const std::string& name) {
    std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

struct RowLists {  // of a sparse matrix
    std::vector<std::uint32_t> begin{0}, neighbour;
    std::vector<float> value;
};

class NetworkBuilder {
  public:
    NetworkBuilder(const NetworkOptions& options, const Context& context)
        : options_(options), context_(context) {}

    NetworkLayers pooled(const TriMesh& mean);
    NetworkLayers convolutional(const TriMesh& mean);

  private:
    std::string list(const std::string& name, std::vector<std::uint64_t> shape,
                     std::vector<std::uint32_t> values) {
        network_.tensors[name] = make_tensor(std::move(shape), std::move(values));
        return name;
    }
    std::string constant(const std::string& name, std::vector<std::uint64_t> shape, float value) {
        std::uint64_t count = 1;
        for (const std::uint64_t size : shape) count *= size;
        network_.tensors[name] = make_tensor(
            std::move(shape), std::vector<float>(static_cast<std::size_t>(count), value));
        return name;
    }
    template <typename Draw>  // (chance, number)
    std::string random(const std::string& name, std::vector<std::uint64_t> shape,
                       const Draw& draw) {
        std::uint64_t count = 1;
        for (const std::uint64_t size : shape) count *= size;
        const CounterRandom chance(options_.seed, stream_of(name));
        std::vector<float> values(static_cast<std::size_t>(count));
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = static_cast<float>(draw(chance, k));
        network_.tensors[name] = make_tensor(std::move(shape), std::move(values));
        return name;
    }
    std::string normal(const std::string& name, std::vector<std::uint64_t> shape,
                       double deviation) {
        return random(name, std::move(shape),
                      [deviation](const CounterRandom& chance, std::size_t k) {
                          return deviation * chance.normal(k);
                      });
    }
    /// Uniform in +-sqrt(6 / (fan in + fan out)) (Glorot and Bengio 2010).
    std::string xavier(const std::string& name, Index rows, Index columns, Index fan_in,
                       double gain = 1) {
        const double bound = gain * std::sqrt(6.0 / static_cast<double>(fan_in + columns));
        return random(name, {u(rows), u(columns)},
                      [bound](const CounterRandom& chance, std::size_t k) {
                          return bound * (2 * chance.uniform(k) - 1);
                      });
    }
    static std::uint64_t u(Index size) { return static_cast<std::uint64_t>(size); }

    NetworkLayer sized(LayerKind kind, Index rows_in, Index in, Index rows_out, Index out) const {
        NetworkLayer layer;
        layer.kind = kind;
        layer.rows_in = rows_in;
        layer.channels_in = in;
        layer.rows_out = rows_out;
        layer.channels_out = out;
        return layer;
    }
    NetworkLayer dense(const std::string& name, Index rows_in, Index in, Index rows_out, Index out);
    NetworkLayer up(const MeshLevel& level, std::size_t number, Index channels);
    void prepare_lists(const TriMesh& mesh, std::size_t level, std::uint32_t reference);
    std::map<std::string, std::string> rows_of(std::size_t level, const MeshLevel* coarser);
    NetworkLayer local(const std::string& name, std::size_t level, const MeshLevel* coarser,
                       Index in, Index out, bool elu);
    NetworkLayer basis(const std::string& name, const RowLists& rows, const std::string& lists,
                       Index rows_in, Index in, Index out, bool elu, bool same_rows);

    /// Channels of the decoder's input whose own code has `channels` in each of `rows`.
    Index with_condition(Index channels, Index rows) {
        if (!options_.conditioned) return channels;
        network_.condition = channels * rows;
        return 2 * channels;
    }

    const NetworkOptions& options_;
    const Context& context_;
    NetworkLayers network_;

    struct LevelLists {  // of one level of a quadric hierarchy
        Index vertices = 0, places = 0;
        std::vector<std::uint32_t> index;  // vertices x places
        std::vector<std::vector<std::uint32_t>>
            rings;  // feastnet: neighbours with the vertex itself
    };
    std::vector<LevelLists> levels_;
};

NetworkLayer NetworkBuilder::dense(const std::string& name, Index rows_in, Index in, Index rows_out,
                                   Index out) {
    NetworkLayer layer = sized(LayerKind::dense, rows_in, in, rows_out, out);
    layer.tensors["weight"] = xavier(name + ".weight", rows_in * in, rows_out * out, rows_in * in);
    layer.tensors["bias"] = constant(name + ".bias", {u(rows_out * out)}, 0);
    return layer;
}

RowLists rows_of_matrix(const RowSparse& matrix) {
    RowLists rows;
    for (Index r = 0; r < matrix.rows(); ++r) {
        for (RowSparse::InnerIterator entry(matrix, r); entry; ++entry) {
            rows.neighbour.push_back(static_cast<std::uint32_t>(entry.col()));
            rows.value.push_back(static_cast<float>(entry.value()));
        }
        rows.begin.push_back(static_cast<std::uint32_t>(rows.neighbour.size()));
    }
    return rows;
}

NetworkLayer NetworkBuilder::up(const MeshLevel& level, std::size_t number, Index channels) {
    NetworkLayer layer =
        sized(LayerKind::sparse, level.up.cols(), channels, level.up.rows(), channels);
    const std::string name = "up." + std::to_string(number);
    RowLists rows = rows_of_matrix(level.up);
    const std::uint64_t entries = rows.neighbour.size();
    layer.tensors["begin"] = list(name + ".begin", {u(level.up.rows()) + 1}, std::move(rows.begin));
    layer.tensors["neighbour"] = list(name + ".neighbour", {entries}, std::move(rows.neighbour));
    network_.tensors[name + ".value"] = make_tensor({entries}, std::move(rows.value));
    layer.tensors["value"] = name + ".value";
    return layer;
}

void NetworkBuilder::prepare_lists(const TriMesh& mesh, std::size_t level,
                                   std::uint32_t reference) {
    LevelLists lists;
    lists.vertices = mesh.vertices.rows();
    switch (options_.op) {
        case NetworkOperator::spiralnet:
            lists.places = options_.spiral_length;
            lists.index = spirals(mesh, lists.places);
            break;
        case NetworkOperator::neural3dmm: {
            const bool fine = level < 2;
            lists.index =
                reference_spirals(mesh, fine ? 2 : 1, fine ? 2 : 1, reference, lists.places);
            break;
        }
        case NetworkOperator::lsa3dmm:
            lists.places = options_.places;
            lists.index = padded_rings(mesh, lists.places);
            break;
        case NetworkOperator::feastnet:
            lists.rings = ordered_rings(mesh);
            for (std::size_t v = 0; v < lists.rings.size(); ++v)
                lists.rings[v].insert(lists.rings[v].begin(), static_cast<std::uint32_t>(v));
            break;
        case NetworkOperator::mesh_autoencoder:
            fail(Status::internal, "the mesh autoencoder has no quadric levels");
    }
    levels_.push_back(std::move(lists));
}

/// The lists of the rows that are computed: all of the level, or, where picking follows, those that
/// the coarser level keeps. The names of the tensors by role.
std::map<std::string, std::string> NetworkBuilder::rows_of(std::size_t level,
                                                           const MeshLevel* coarser) {
    const LevelLists& lists = levels_[level];
    const std::string name =
        std::string(coarser != nullptr ? "kept." : "all.") + std::to_string(level);
    std::vector<std::uint32_t> rows;
    if (coarser != nullptr)
        rows = coarser->kept;
    else
        for (Index v = 0; v < lists.vertices; ++v) rows.push_back(static_cast<std::uint32_t>(v));
    if (options_.op != NetworkOperator::feastnet) {
        const std::string index = name + ".index";
        if (network_.tensors.count(index) == 0) {
            std::vector<std::uint32_t> values;
            for (const std::uint32_t v : rows)
                values.insert(values.end(),
                              lists.index.begin() + static_cast<Index>(v) * lists.places,
                              lists.index.begin() + static_cast<Index>(v + 1) * lists.places);
            list(index, {rows.size(), u(lists.places)}, std::move(values));
        }
        return {{"index", index}};
    }
    if (network_.tensors.count(name + ".begin") == 0) {
        RowLists entries;
        for (const std::uint32_t v : rows) {
            entries.neighbour.insert(entries.neighbour.end(), lists.rings[v].begin(),
                                     lists.rings[v].end());
            entries.begin.push_back(static_cast<std::uint32_t>(entries.neighbour.size()));
        }
        const std::uint64_t count = entries.neighbour.size();
        const std::uint64_t size = rows.size();
        list(name + ".begin", {size + 1}, std::move(entries.begin));
        list(name + ".neighbour", {count}, std::move(entries.neighbour));
        list(name + ".centre", {size}, std::move(rows));
    }
    return {{"begin", name + ".begin"},
            {"neighbour", name + ".neighbour"},
            {"centre", name + ".centre"}};
}

NetworkLayer NetworkBuilder::local(const std::string& name, std::size_t level,
                                   const MeshLevel* coarser, Index in, Index out, bool elu) {
    const LevelLists& lists = levels_[level];
    const Index rows =
        coarser != nullptr ? static_cast<Index>(coarser->kept.size()) : lists.vertices;
    NetworkLayer layer = sized(LayerKind::gather, lists.vertices, in, rows, out);
    layer.elu = elu;
    layer.tensors = rows_of(level, coarser);
    layer.tensors["bias"] = constant(name + ".bias", {u(out)}, 0);
    const Index k = lists.places, m = options_.matrices;
    if (options_.op == NetworkOperator::feastnet) {
        layer.kind = LayerKind::steered;
        layer.tensors["steer"] = normal(name + ".steer", {u(in), u(m)}, 0.1);
        layer.tensors["offset"] = constant(name + ".offset", {u(m)}, 0);
        // The output is the mean over the M matrices, which at first are as good as unrelated:
        // their variance is M times a single matrix', or every layer would shrink its signal by
        // sqrt(M).
        layer.tensors["weight"] =
            xavier(name + ".weight", m * in, out, in, std::sqrt(static_cast<double>(m)));
        return layer;
    }
    layer.tensors["weight"] = xavier(name + ".weight", k * in, out, k * in);
    if (options_.op != NetworkOperator::lsa3dmm) return layer;
    layer.kind = LayerKind::permuted;
    layer.tensors["shortcut"] = xavier(name + ".shortcut", in, out, in);
    layer.tensors["shortcut_bias"] = constant(name + ".shortcut_bias", {u(out)}, 0);
    const Index s = options_.mixing_bases;
    // The identity at first, alone or as the mean of the bases, which a little noise tells apart.
    const auto identity = [k](std::size_t entry) {
        const Index place = static_cast<Index>(entry) % (k * k);
        return place / k == place % k ? 1.0 : 0.0;
    };
    if (s == 0) {
        layer.tensors["mixing"] =
            random(name + ".mixing", {u(rows), u(k), u(k)},
                   [&](const CounterRandom&, std::size_t entry) { return identity(entry); });
        return layer;
    }
    layer.tensors["mixing_weight"] =
        constant(name + ".mixing_weight", {u(rows), u(s)}, 1.0f / static_cast<float>(s));
    layer.tensors["mixing_basis"] = random(name + ".mixing_basis", {u(s), u(k), u(k)},
                                           [&](const CounterRandom& chance, std::size_t entry) {
                                               return identity(entry) + 0.01 * chance.normal(entry);
                                           });
    return layer;
}

NetworkLayers NetworkBuilder::pooled(const TriMesh& mean) {
    const auto hierarchy = quadric_hierarchy(mean, static_cast<Index>(options_.widths.size()),
                                             options_.factor, context_);
    const auto& levels = hierarchy->levels;
    const std::size_t depth = levels.size() - 1;
    if (depth == 0)
        fail(Status::invalid_mesh, "the template is too small for a network with levels");
    auto reference = static_cast<std::uint32_t>(options_.reference_vertex);
    if (options_.reference_vertex < 0) {
        Index foremost = 0;
        mean.vertices.col(2).maxCoeff(&foremost);
        reference = static_cast<std::uint32_t>(foremost);
    }
    if (static_cast<Index>(reference) >= mean.vertices.rows())
        fail(Status::invalid_argument, "reference vertex %lld of a template of %lld vertices",
             static_cast<long long>(options_.reference_vertex),
             static_cast<long long>(mean.vertices.rows()));
    const Vector3 place = mean.vertices.row(reference);
    for (std::size_t l = 0; l < depth; ++l) {
        Index nearest = 0;
        (levels[l].mesh.vertices.rowwise() - place.transpose())
            .rowwise()
            .squaredNorm()
            .minCoeff(&nearest);
        prepare_lists(levels[l].mesh, l, static_cast<std::uint32_t>(nearest));
    }
    Index channels = options_.channels_in;
    for (std::size_t l = 0; l < depth; ++l) {
        network_.encoder.push_back(local("encoder." + std::to_string(l), l, &levels[l + 1],
                                         channels, options_.widths[l], true));
        channels = options_.widths[l];
    }
    const Index coarsest = levels[depth].mesh.vertices.rows();
    network_.encoder.push_back(dense("encoder.code", coarsest, channels, 1, options_.latent));
    network_.decoder.push_back(
        dense("decoder.code", 1, with_condition(options_.latent, 1), coarsest, channels));
    for (std::size_t l = depth; l-- > 0;) {
        network_.decoder.push_back(up(levels[l + 1], l, channels));
        // 128 -> 128, 64, 32, 16: the first layer up keeps its width, then the encoder's mirrored.
        const Index width = options_.widths[l];
        network_.decoder.push_back(
            local("decoder." + std::to_string(l), l, nullptr, channels, width, true));
        channels = width;
    }
    network_.decoder.push_back(
        local("decoder.last", 0, nullptr, channels, options_.channels_out, false));
    return std::move(network_);
}

NetworkLayer NetworkBuilder::basis(const std::string& name, const RowLists& rows,
                                   const std::string& lists, Index rows_in, Index in, Index out,
                                   bool elu, bool same_rows) {
    const auto rows_out = static_cast<Index>(rows.begin.size()) - 1;
    const std::uint64_t entries = rows.neighbour.size();
    NetworkLayer layer = sized(LayerKind::basis, rows_in, in, rows_out, out);
    layer.elu = elu;
    layer.residual_rate = options_.residual_rate;
    if (network_.tensors.count(lists + ".begin") == 0) {
        list(lists + ".begin", {u(rows_out) + 1}, rows.begin);
        list(lists + ".neighbour", {entries}, rows.neighbour);
    }
    layer.tensors["begin"] = lists + ".begin";
    layer.tensors["neighbour"] = lists + ".neighbour";
    const double mean_size = static_cast<double>(entries) / static_cast<double>(rows_out);
    const Index bases = options_.bases;
    layer.tensors["coefficient"] = normal(name + ".coefficient", {entries, u(bases)},
                                          1 / (mean_size * static_cast<double>(bases)));
    layer.tensors["weight"] = normal(name + ".weight", {u(bases * in), u(out)}, 1);
    layer.tensors["bias"] = constant(name + ".bias", {u(out)}, 0);
    if (!same_rows) layer.tensors["density"] = normal(name + ".density", {entries}, 1 / mean_size);
    if (in != out)
        layer.tensors["shortcut"] =
            normal(name + ".shortcut", {u(in), u(out)}, 1 / static_cast<double>(out));
    return layer;
}

NetworkLayers NetworkBuilder::convolutional(const TriMesh& mean) {
    const auto hierarchy = connectivity_hierarchy(
        mean, static_cast<Index>(options_.mesh_widths.size()), 2, 2, context_);
    const auto& levels = hierarchy->levels;
    // Down to 8 to 24 vertices: more would leave too few channels for the code, fewer no places.
    std::size_t depth = levels.size() - 1;
    while (depth > 1 && levels[depth - 1].mesh.vertices.rows() <= 24) --depth;
    if (depth > 1 && levels[depth].mesh.vertices.rows() < 8) --depth;
    if (depth == 0)
        fail(Status::invalid_mesh, "the template is too small for a network with levels");
    const Index coarsest = levels[depth].mesh.vertices.rows();
    const Index code =
        std::max<Index>(1, static_cast<Index>(std::lround(static_cast<double>(options_.latent) /
                                                          static_cast<double>(coarsest))));
    // Its own ring and the ring after it, as radius 2 means on the other levels.
    RowLists flat;
    RingWalker ball(levels[depth].graph);
    for (Index v = 0; v < coarsest; ++v) {
        std::vector<std::uint32_t> near = ball.within(static_cast<std::uint32_t>(v), 2);
        std::sort(near.begin(), near.end());
        flat.neighbour.insert(flat.neighbour.end(), near.begin(), near.end());
        flat.begin.push_back(static_cast<std::uint32_t>(flat.neighbour.size()));
    }
    Index channels = options_.channels_in;
    for (std::size_t l = 0; l < depth; ++l) {
        const Index width = options_.mesh_widths[l];
        network_.encoder.push_back(
            basis("encoder." + std::to_string(l), rows_of_matrix(levels[l + 1].down),
                  "down." + std::to_string(l), levels[l].mesh.vertices.rows(), channels, width,
                  true, false));
        channels = width;
    }
    network_.encoder.push_back(
        basis("encoder.code", flat, "flat", coarsest, channels, code, false, true));
    if (options_.variational)
        network_.variance.push_back(
            basis("variance", flat, "flat", coarsest, channels, code, false, true));
    network_.decoder.push_back(basis("decoder.code", flat, "flat", coarsest,
                                     with_condition(code, coarsest), channels, true, true));
    for (std::size_t l = depth; l-- > 0;) {
        const Index width = l > 0 ? options_.mesh_widths[l - 1] : options_.channels_out;
        network_.decoder.push_back(
            basis("decoder." + std::to_string(l), rows_of_matrix(levels[l + 1].up),
                  "up." + std::to_string(l), levels[l + 1].mesh.vertices.rows(), channels, width,
                  l > 0, false));
        channels = width;
    }
    return std::move(network_);
}

void check_network_options(const NetworkOptions& options) {
    const auto between = [](Index value, Index low, Index high, const char* what) {
        if (value < low || value > high)
            fail(Status::invalid_argument, "%s is %lld, allowed are %lld to %lld", what,
                 static_cast<long long>(value), static_cast<long long>(low),
                 static_cast<long long>(high));
    };
    between(options.channels_in, 1, 64, "channels_in");
    between(options.channels_out, 1, 64, "channels_out");
    between(options.latent, 1, 4096, "latent");
    between(options.spiral_length, 1, 256, "spiral_length");
    between(options.matrices, 1, 64, "matrices");
    between(options.places, 2, 64, "places");
    between(options.mixing_bases, 0, 64, "mixing_bases");
    between(options.bases, 1, 1024, "bases");
    for (const auto* widths : {&options.widths, &options.mesh_widths}) {
        between(static_cast<Index>(widths->size()), 1, 16, "the number of widths");
        for (const Index width : *widths) between(width, 1, 4096, "a width");
    }
    if (!(options.residual_rate >= 0 && options.residual_rate <= 1))
        fail(Status::invalid_argument, "residual_rate is %g, allowed are 0 to 1",
             options.residual_rate);
}

constexpr const char* kOperatorNames[] = {"feastnet", "neural3dmm", "spiralnet++",
                                          "mesh-autoencoder", "lsa-3dmm"};

}  // namespace

const char* network_operator_name(NetworkOperator op) {
    return kOperatorNames[static_cast<std::size_t>(op)];
}

NetworkOperator network_operator(const std::string& name) {
    for (std::size_t k = 0; k < std::size(kOperatorNames); ++k)
        if (name == kOperatorNames[k]) return static_cast<NetworkOperator>(k);
    fail(Status::invalid_argument,
         "there is no network '%.40s'; known are feastnet, neural3dmm, spiralnet++, "
         "mesh-autoencoder and lsa-3dmm",
         name.c_str());
}

NetworkLayers build_network(const TriMesh& mean, const NetworkOptions& options,
                            const Context& context) {
    check_network_options(options);
    check_mesh(mean, "the template");
    NetworkBuilder builder(options, context);
    NetworkLayers network = options.op == NetworkOperator::mesh_autoencoder
                                ? builder.convolutional(mean)
                                : builder.pooled(mean);
    check_layers(network);
    return network;
}

}  // namespace mien
