#include "learning/network_layers.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "base/json_tree.hpp"

namespace mien {
namespace {

constexpr LayerKind kKinds[] = {LayerKind::gather,   LayerKind::steered, LayerKind::basis,
                                LayerKind::permuted, LayerKind::dense,   LayerKind::pick,
                                LayerKind::sparse,   LayerKind::elu,     LayerKind::affine};

template <typename T>
NetworkTensor owning(DType dtype, std::vector<std::uint64_t> shape, std::vector<T>&& values) {
    NetworkTensor tensor;
    tensor.dtype = dtype;
    tensor.shape = std::move(shape);
    if (tensor.count() != values.size())
        fail(Status::internal, "a tensor of %zu values for %llu places", values.size(),
             static_cast<unsigned long long>(tensor.count()));
    const auto owner = std::make_shared<const std::vector<T>>(std::move(values));
    tensor.data = owner->data();
    tensor.owner = owner;
    return tensor;
}

void write_list(JsonText& json, const char* name, const std::vector<NetworkLayer>& layers) {
    json.key(name).begin_array();
    for (const NetworkLayer& layer : layers) {
        json.begin_object().field("kind", layer_kind_name(layer.kind));
        json.field("rows_in", layer.rows_in).field("channels_in", layer.channels_in);
        json.field("rows_out", layer.rows_out).field("channels_out", layer.channels_out);
        json.field("elu", layer.elu);
        if (layer.kind == LayerKind::basis) json.field("residual_rate", layer.residual_rate);
        json.key("tensors").begin_object();
        for (const auto& [role, tensor] : layer.tensors) json.field(role, tensor);
        json.end_object().end_object();
    }
    json.end_array();
}

constexpr std::size_t kMostLayers = 256;

std::vector<NetworkLayer> read_list(const JsonTree::Value& list, const char* name) {
    std::vector<NetworkLayer> layers;
    if (!list.exists()) return layers;
    if (!list.is(JsonTree::Kind::array))
        fail(Status::bad_format, "the network's '%s' is no list of layers", name);
    const std::vector<JsonTree::Value> items = list.items();
    if (items.size() > kMostLayers)
        fail(Status::bad_format, "the network's '%s' has %zu layers, more than %zu", name,
             items.size(), kMostLayers);
    for (const JsonTree::Value& item : items) {
        NetworkLayer layer;
        const std::string kind = item["kind"].text("kind");
        const auto* known = std::find_if(std::begin(kKinds), std::end(kKinds),
                                         [&](LayerKind k) { return kind == layer_kind_name(k); });
        if (known == std::end(kKinds))
            fail(Status::bad_format,
                 "the network has a layer of kind '%s', which this library does not know",
                 shown_name(kind).c_str());
        layer.kind = *known;
        layer.rows_in = static_cast<Index>(item["rows_in"].count("rows_in"));
        layer.channels_in = static_cast<Index>(item["channels_in"].count("channels_in"));
        layer.rows_out = static_cast<Index>(item["rows_out"].count("rows_out"));
        layer.channels_out = static_cast<Index>(item["channels_out"].count("channels_out"));
        layer.elu = item["elu"].boolean("elu", false);
        layer.residual_rate = item["residual_rate"].number("residual_rate", 0);
        for (const JsonTree::Value& entry : item["tensors"].items())
            layer.tensors[entry.key()] = entry.text("a tensor's name");
        layers.push_back(std::move(layer));
    }
    return layers;
}

}  // namespace

const char* layer_kind_name(LayerKind kind) {
    switch (kind) {
        case LayerKind::gather:
            return "gather";
        case LayerKind::steered:
            return "steered";
        case LayerKind::basis:
            return "basis";
        case LayerKind::permuted:
            return "permuted";
        case LayerKind::dense:
            return "dense";
        case LayerKind::pick:
            return "pick";
        case LayerKind::sparse:
            return "sparse";
        case LayerKind::elu:
            return "elu";
        case LayerKind::affine:
            return "affine";
    }
    fail(Status::internal, "layer kind %d is unknown", static_cast<int>(kind));
}

std::uint64_t NetworkTensor::count() const {
    std::uint64_t product = 1;
    for (const std::uint64_t size : shape) product *= size;
    return product;
}

NetworkTensor make_tensor(std::vector<std::uint64_t> shape, std::vector<float> values) {
    return owning(DType::f32, std::move(shape), std::move(values));
}

NetworkTensor make_tensor(std::vector<std::uint64_t> shape, std::vector<std::uint32_t> values) {
    return owning(DType::u32, std::move(shape), std::move(values));
}

const NetworkTensor& NetworkLayers::tensor(const NetworkLayer& layer, const char* role) const {
    const auto name = layer.tensors.find(role);
    if (name == layer.tensors.end())
        fail(Status::bad_format, "a %s layer names no tensor '%s'", layer_kind_name(layer.kind),
             role);
    const auto found = tensors.find(name->second);
    if (found == tensors.end())
        fail(Status::bad_format, "the network has no tensor '%s', which a %s layer names",
             shown_name(name->second).c_str(), layer_kind_name(layer.kind));
    return found->second;
}

bool is_trained_role(LayerKind kind, const std::string& role) {
    if (kind == LayerKind::sparse || kind == LayerKind::affine) return false;
    return role != "index" && role != "begin" && role != "neighbour" && role != "centre";
}

double layer_products(const NetworkLayers& network, const NetworkLayer& layer) {
    const auto rows = static_cast<double>(layer.rows_out);
    const auto in = static_cast<double>(layer.channels_in);
    const auto out = static_cast<double>(layer.channels_out);
    const auto size = [&](const char* role, std::size_t axis) {
        return static_cast<double>(network.tensor(layer, role).shape[axis]);
    };
    switch (layer.kind) {
        case LayerKind::gather:
            return rows * size("weight", 0) * out;
        case LayerKind::steered:
            return rows * size("weight", 0) * out + size("neighbour", 0) * size("offset", 0) * in +
                   static_cast<double>(layer.rows_in) * in * size("offset", 0);
        case LayerKind::basis: {
            const double bases = size("coefficient", 1), entries = size("coefficient", 0);
            const double contract = entries * bases * in + rows * bases * in * out;
            const double project =
                static_cast<double>(layer.rows_in) * in * bases * out + entries * bases * out;
            return std::min(contract, project) + rows * in * out;
        }
        case LayerKind::permuted: {
            const double places = size("index", 1);
            return rows * (places * places * in + places * in * out + in * out);
        }
        case LayerKind::dense:
            return size("weight", 0) * size("weight", 1);
        case LayerKind::sparse:
            return size("neighbour", 0) * in;
        case LayerKind::affine:
        case LayerKind::elu:
            return rows * out;
        case LayerKind::pick:
            return 0;
    }
    return 0;
}

std::string layers_json(const NetworkLayers& network) {
    JsonText json;
    json.begin_object();
    write_list(json, "encoder", network.encoder);
    write_list(json, "decoder", network.decoder);
    if (!network.variance.empty()) write_list(json, "variance", network.variance);
    if (network.condition != 0) json.field("condition", network.condition);
    json.end_object();
    return json.take();
}

void read_layers_json(const std::string& json, NetworkLayers& network) {
    const JsonTree tree(json.data(), json.size(), "the network's layers");
    network.encoder = read_list(tree.root()["encoder"], "encoder");
    network.decoder = read_list(tree.root()["decoder"], "decoder");
    network.variance = read_list(tree.root()["variance"], "variance");
    network.condition = static_cast<Index>(tree.root()["condition"].count("condition", 0));
}

}  // namespace mien
