// Checks of a list of layers that may come from anybody.
#include <cmath>

#include "base/error.hpp"
#include "base/json.hpp"
#include "learning/network_layers.hpp"

namespace mien {
namespace {

// A face of 2 million vertices with 32 channels, or 11,248 with thousands: more is no network of
// faces. With the limits of the sums below one evaluation ends within minutes, whatever a file
// says.
constexpr Index kMostRows = Index(1) << 24, kMostChannels = 1 << 16;
constexpr Index kMostValues = Index(1) << 26;
constexpr double kMostProducts = 1e12;
constexpr std::uint64_t kMostPlaces = 4096;  // of one row's list
constexpr std::uint64_t kMostBases = 1024;   // of a basis layer
constexpr std::uint64_t kMostMatrices =
    64;  // of a steered layer, bases and places of a permuted one

class LayerCheck {
  public:
    LayerCheck(const NetworkLayers& network, const NetworkLayer& layer, const char* list,
               std::size_t number)
        : network_(network), layer_(layer), list_(list), number_(number) {}

    void run() const {
        check_sizes();
        switch (layer_.kind) {
            case LayerKind::gather:
                gather();
                break;
            case LayerKind::steered:
                steered();
                break;
            case LayerKind::basis:
                basis();
                break;
            case LayerKind::permuted:
                permuted();
                break;
            case LayerKind::dense:
                shaped("weight", {layer_.rows_in * in(), layer_.rows_out * out()});
                shaped("bias", {layer_.rows_out * out()});
                roles({"weight", "bias"});
                break;
            case LayerKind::pick:
                indices(shaped("index", {rows()}, DType::u32), false);
                same_channels();
                roles({"index"});
                break;
            case LayerKind::sparse:
                shaped("value", {entries()});
                same_channels();
                roles({"begin", "neighbour", "value"});
                break;
            case LayerKind::elu:
                same_channels();
                same_rows();
                roles({});
                break;
            case LayerKind::affine:
                affine();
                break;
        }
        if (layer_products(network_, layer_) > kMostProducts)
            wrong("takes more than 1e12 products; no network of faces does");
    }

  private:
    [[noreturn]] void wrong(const char* what) const {
        fail_at(Status::bad_format, static_cast<std::int64_t>(number_),
                "layer %zu of the network's %s (%s): %s", number_, list_,
                layer_kind_name(layer_.kind), what);
    }
    Index in() const { return layer_.channels_in; }
    Index out() const { return layer_.channels_out; }
    Index rows() const { return layer_.rows_out; }

    void check_sizes() const {
        for (const Index r : {layer_.rows_in, layer_.rows_out})
            if (r < 1 || r > kMostRows) wrong("its rows are not 1 to 16777216");
        for (const Index c : {layer_.channels_in, layer_.channels_out})
            if (c < 1 || c > kMostChannels) wrong("its channels are not 1 to 65536");
        if (layer_.rows_in * in() > kMostValues || rows() * out() > kMostValues)
            wrong("rows times channels is more than 67108864");
        if (!(layer_.residual_rate >= 0 && layer_.residual_rate <= 1))
            wrong("its residual rate is not 0 to 1");
    }
    void same_channels() const {
        if (in() != out()) wrong("it cannot change the number of channels");
    }
    void same_rows() const {
        if (layer_.rows_in != layer_.rows_out) wrong("it cannot change the number of rows");
    }
    /// A role that is not known would be ignored, and the network be another than its maker meant.
    void roles(std::initializer_list<const char*> known) const {
        for (const auto& entry : layer_.tensors) {
            bool found = false;
            for (const char* role : known) found = found || entry.first == role;
            if (!found) wrong("it names a tensor for a role that it does not have");
        }
    }
    /// -1 in a shape: any size from 1.
    const NetworkTensor& shaped(const char* role, std::initializer_list<Index> shape,
                                DType dtype = DType::f32) const {
        const NetworkTensor& tensor = network_.tensor(layer_, role);
        bool good = tensor.dtype == dtype && tensor.shape.size() == shape.size();
        std::size_t axis = 0;
        for (const Index size : shape) {
            if (!good) break;
            const std::uint64_t found = tensor.shape[axis++];
            good = size < 0 ? found >= 1 : found == static_cast<std::uint64_t>(size);
        }
        if (!good)
            fail_at(Status::bad_format, static_cast<std::int64_t>(number_),
                    "layer %zu of the network's %s (%s): tensor '%s' has another type or shape",
                    number_, list_, layer_kind_name(layer_.kind), role);
        return tensor;
    }
    void indices(const NetworkTensor& tensor, bool padded) const {
        const auto limit = static_cast<std::uint32_t>(layer_.rows_in - (padded ? 0 : 1));
        const std::uint32_t* numbers = tensor.numbers();
        const std::uint64_t count = tensor.count();
        std::uint32_t largest = 0;
        for (std::uint64_t k = 0; k < count; ++k) largest = std::max(largest, numbers[k]);
        if (largest > limit) wrong("a list names a row that is not there");
    }
    /// The last axis is at most `most` long.
    void narrow(const NetworkTensor& tensor, std::uint64_t most) const {
        if (tensor.shape.back() <= most) return;
        fail_at(Status::bad_format, static_cast<std::int64_t>(number_),
                "layer %zu of the network's %s (%s): %llu places, bases or matrices; at most %llu "
                "are possible",
                number_, list_, layer_kind_name(layer_.kind),
                static_cast<unsigned long long>(tensor.shape.back()),
                static_cast<unsigned long long>(most));
    }
    /// Checks "begin" and "neighbour"; gives E.
    Index entries() const {
        const NetworkTensor& begin = shaped("begin", {rows() + 1}, DType::u32);
        const NetworkTensor& neighbour = shaped("neighbour", {-1}, DType::u32);
        const std::uint32_t* start = begin.numbers();
        if (start[0] != 0 || start[rows()] != neighbour.count())
            wrong("its rows do not cover its entries");
        for (Index i = 0; i < rows(); ++i) {
            if (start[i + 1] < start[i] || start[i + 1] - start[i] > kMostPlaces)
                wrong("its rows do not ascend, or one has more than 4096 entries");
            if (start[i + 1] == start[i] && layer_.kind != LayerKind::sparse)
                wrong("one of its rows has no entry");
        }
        indices(neighbour, false);
        return static_cast<Index>(neighbour.count());
    }
    void gather() const {
        const NetworkTensor& index = shaped("index", {rows(), -1}, DType::u32);
        narrow(index, kMostPlaces);
        indices(index, true);
        shaped("weight", {static_cast<Index>(index.shape[1]) * in(), out()});
        shaped("bias", {out()});
        roles({"index", "weight", "bias"});
    }
    void steered() const {
        entries();
        indices(shaped("centre", {rows()}, DType::u32), false);
        const NetworkTensor& offset = shaped("offset", {-1});
        narrow(offset, kMostMatrices);
        const auto matrices = static_cast<Index>(offset.shape[0]);
        // Each row of the input is projected on all matrices: a small file must not ask for much.
        if (layer_.rows_in * matrices > kMostValues)
            wrong("rows times matrices is more than 67108864");
        shaped("steer", {in(), matrices});
        shaped("weight", {matrices * in(), out()});
        shaped("bias", {out()});
        roles({"begin", "neighbour", "centre", "steer", "offset", "weight", "bias"});
    }
    void basis() const {
        const Index count = entries();
        const NetworkTensor& coefficient = shaped("coefficient", {count, -1});
        narrow(coefficient, kMostBases);
        shaped("weight", {static_cast<Index>(coefficient.shape[1]) * in(), out()});
        shaped("bias", {out()});
        if (network_.has(layer_, "density"))
            shaped("density", {count});
        else
            same_rows();
        if (network_.has(layer_, "shortcut"))
            shaped("shortcut", {in(), out()});
        else
            same_channels();
        roles({"begin", "neighbour", "coefficient", "weight", "bias", "density", "shortcut"});
    }
    void permuted() const {
        const NetworkTensor& index = shaped("index", {rows(), -1}, DType::u32);
        narrow(index, kMostMatrices);
        indices(index, true);
        const auto k = static_cast<Index>(index.shape[1]);
        const bool factorised = network_.has(layer_, "mixing_weight");
        if (factorised == network_.has(layer_, "mixing"))
            wrong("it needs either 'mixing' or 'mixing_weight' with 'mixing_basis'");
        if (factorised) {
            const NetworkTensor& weight = shaped("mixing_weight", {rows(), -1});
            narrow(weight, kMostMatrices);
            shaped("mixing_basis", {static_cast<Index>(weight.shape[1]), k, k});
        } else {
            shaped("mixing", {rows(), k, k});
        }
        shaped("weight", {k * in(), out()});
        shaped("bias", {out()});
        shaped("shortcut", {in(), out()});
        shaped("shortcut_bias", {out()});
        roles({"index", "mixing", "mixing_weight", "mixing_basis", "weight", "bias", "shortcut",
               "shortcut_bias"});
    }
    void affine() const {
        same_channels();
        same_rows();
        const NetworkTensor& scale = network_.tensor(layer_, "scale");
        const Index n = !scale.shape.empty() && scale.shape[0] == 1 ? 1 : rows();
        shaped("scale", {n, out()});
        shaped("shift", {n, out()});
        roles({"scale", "shift"});
    }

    const NetworkLayers& network_;
    const NetworkLayer& layer_;
    const char* list_;
    std::size_t number_;
};

void check_list(const NetworkLayers& network, const std::vector<NetworkLayer>& list,
                const char* name) {
    for (std::size_t k = 0; k < list.size(); ++k) {
        LayerCheck(network, list[k], name, k).run();
        if (k > 0 && (list[k].rows_in != list[k - 1].rows_out ||
                      list[k].channels_in != list[k - 1].channels_out))
            fail_at(Status::bad_format, static_cast<std::int64_t>(k),
                    "layer %zu of the network's %s does not take what the layer before it gives", k,
                    name);
    }
}

void check_codes(const NetworkLayers& network) {
    if (network.condition != 0 && (network.encoder.empty() || network.decoder.empty()))
        fail(Status::bad_format, "a network with a condition needs an encoder and a decoder");
    if (network.encoder.empty() || network.decoder.empty()) return;
    const NetworkLayer &code = network.encoder.back(), &from = network.decoder.front();
    const Index given = code.rows_out * code.channels_out, taken = from.rows_in * from.channels_in;
    if (network.condition < 0 || network.condition > kMostValues ||
        given + network.condition != taken)
        fail(Status::bad_format,
             "the network's decoder takes %lld numbers, its encoder gives %lld, another code %lld",
             static_cast<long long>(taken), static_cast<long long>(given),
             static_cast<long long>(network.condition));
    // Two codes are joined row by row.
    if (network.condition != 0 && (given % from.rows_in != 0 || taken % from.rows_in != 0))
        fail(Status::bad_format, "the network's codes do not fill the rows of its decoder");
}

}  // namespace

void check_layers(const NetworkLayers& network) {
    if (network.encoder.empty() && network.decoder.empty())
        fail(Status::bad_format, "a network without layers");
    check_list(network, network.encoder, "encoder");
    check_list(network, network.decoder, "decoder");
    check_list(network, network.variance, "variance");
    check_codes(network);
    if (!network.variance.empty() &&
        (network.encoder.empty() ||
         network.variance.front().rows_in != network.encoder.back().rows_in ||
         network.variance.front().channels_in != network.encoder.back().channels_in ||
         network.variance.back().rows_out != network.encoder.back().rows_out ||
         network.variance.back().channels_out != network.encoder.back().channels_out))
        fail(Status::bad_format, "the network's variance does not fit its encoder's last layer");
}

}  // namespace mien
