#include "learning/network.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "base/json_tree.hpp"
#include "geometry/alignment.hpp"

namespace mien {
namespace {

constexpr const char* kNetworkKind = "mien-network";

bool is_deformation(const FaceFeatures& features) {
    return features.kind() >= FeatureKind::deformation;
}

const NetworkProgram& needed(const std::unique_ptr<const NetworkProgram>& program,
                             const char* what) {
    if (program == nullptr)
        fail(Status::unsupported_option, "this network has no %s; use one that was saved with it",
             what);
    return *program;
}

void check_sides(const std::vector<NetworkLayer>& layers, bool at_input,
                 const FaceFeatures& features, const char* what) {
    if (layers.empty()) return;
    const Index rows = at_input ? layers.front().rows_in : layers.back().rows_out;
    const Index channels = at_input ? layers.front().channels_in : layers.back().channels_out;
    if (rows != features.num_vertices() || channels != features.num_channels())
        fail(Status::bad_format,
             "the network's %s has %lld x %lld features, its statistics %lld x %d", what,
             static_cast<long long>(rows), static_cast<long long>(channels),
             static_cast<long long>(features.num_vertices()), features.num_channels());
}

double sum_of_products(const NetworkLayers& layers, const std::vector<NetworkLayer>& list) {
    double sum = 0;
    for (const NetworkLayer& layer : list) sum += layer_products(layers, layer);
    return sum;
}

void add_layers(JsonText& json, const char* name, const NetworkLayers& network,
                const std::vector<NetworkLayer>& list) {
    json.key(name).begin_array();
    for (const NetworkLayer& layer : list)
        json.begin_object()
            .field("kind", layer_kind_name(layer.kind))
            .field("rows", layer.rows_out)
            .field("channels", layer.channels_out)
            .field("elu", layer.elu)
            .field("multiply_adds", layer_products(network, layer))
            .end_object();
    json.end_array();
}

}  // namespace

std::shared_ptr<const Network> Network::make(NetworkLayers layers,
                                             std::shared_ptr<const FaceFeatures> input,
                                             std::shared_ptr<const FaceFeatures> output,
                                             NetworkOrigin origin, const Context& context) {
    check_layers(layers);
    auto network = std::make_shared<Network>();
    network->layers_ = std::move(layers);
    network->input_ = std::move(input);
    network->output_ = std::move(output);
    network->origin_ = std::move(origin);
    const NetworkLayers& list = network->layers_;
    // Before anything is allocated for its sizes.
    check_sides(list.encoder, true, network->input(), "encoder");
    check_sides(list.decoder, false, network->output(), "decoder");
    if (!list.encoder.empty())
        network->encoder_ = std::make_unique<NetworkProgram>(list, list.encoder, context);
    if (!list.decoder.empty())
        network->decoder_ = std::make_unique<NetworkProgram>(list, list.decoder, context);
    if (network->output().num_vertices() != network->input().num_vertices())
        fail(Status::bad_format, "the network's input and output are of different templates");
    network->code_size_ = static_cast<Index>(network->encoder_ ? network->encoder_->outputs()
                                                               : network->decoder_->inputs());
    return network;
}

std::shared_ptr<const Network> Network::load(const std::string& path,
                                             const SafetensorsReadOptions& options,
                                             const Context& context) {
    return read(SafetensorsFile::open(path, options, context), context);
}

std::shared_ptr<const Network> Network::read(const SafetensorsFile& file, const Context& context) {
    file.require_kind(kNetworkKind);
    NetworkLayers layers;
    read_layers_json(file.metadata("layers"), layers);
    for (const auto* list : {&layers.encoder, &layers.decoder, &layers.variance})
        for (const NetworkLayer& layer : *list)
            for (const auto& entry : layer.tensors) {
                const auto found = file.tensors().find(entry.second);
                if (found == file.tensors().end()) continue;  // check_layers() says which
                NetworkTensor tensor;
                tensor.dtype = found->second.dtype;
                tensor.shape = found->second.shape;
                tensor.data = found->second.data;
                tensor.owner = file.storage();
                layers.tensors[entry.second] = tensor;
            }
    auto input = FaceFeatures::read(file, "input.");
    std::shared_ptr<const FaceFeatures> output;
    if (file.has("output.mean_shape")) output = FaceFeatures::read(file, "output.");
    NetworkOrigin origin;
    const auto text = [&](const char* key) {
        const auto entry = file.metadata().find(key);
        return entry == file.metadata().end() ? std::string() : entry->second;
    };
    origin.name = text("name");
    origin.training = text("training");
    if (!origin.training.empty())  // it becomes a part of network_json()
        JsonTree(origin.training.data(), origin.training.size(), "the network's training");
    return make(std::move(layers), std::move(input), std::move(output), std::move(origin), context);
}

void Network::save(const std::string& path, const Context& context) const {
    std::vector<TensorToWrite> tensors;
    std::map<std::string, std::string> metadata{{"kind", kNetworkKind},
                                                {"units", "millimetres"},
                                                {"layers", layers_json(layers_)},
                                                {"name", origin_.name}};
    if (!origin_.training.empty()) metadata["training"] = origin_.training;
    input_->append_to("input.", tensors, metadata);
    if (output_) output_->append_to("output.", tensors, metadata);
    for (const auto& [name, tensor] : layers_.tensors)
        tensors.push_back({name, tensor.dtype, tensor.shape, tensor.data});
    std::stable_sort(tensors.begin(), tensors.end(),
                     [](const TensorToWrite& a, const TensorToWrite& b) {
                         return dtype_bytes(a.dtype) > dtype_bytes(b.dtype);
                     });
    write_safetensors(path, tensors, std::move(metadata), context);
}

std::uint64_t Network::num_weights() const {
    std::set<std::string> names;
    std::uint64_t count = 0;
    for (const auto* list : {&layers_.encoder, &layers_.decoder})
        for (const NetworkLayer& layer : *list)
            for (const auto& [role, name] : layer.tensors)
                if (is_trained_role(layer.kind, role) && names.insert(name).second)
                    count += layers_.tensors.at(name).count();
    return count;
}

double Network::encoder_products() const {
    return sum_of_products(layers_, layers_.encoder);
}
double Network::decoder_products() const {
    return sum_of_products(layers_, layers_.decoder);
}

void Network::encode_features(const float* features, float* code, const Context& context) const {
    needed(encoder_, "encoder").run(features, code, context);
}

void Network::decode_features(const float* code, float* features, const Context& context) const {
    needed(decoder_, "decoder").run(code, features, context);
}

Eigen::VectorXf Network::encode(const PointsRef& face, Similarity* motion,
                                const Context& context) const {
    needed(encoder_, "encoder");
    const Features features = input_->encode(face, motion, context);
    const Eigen::VectorXf in =
        Eigen::Map<const Vector>(features.data(), features.size()).cast<float>();
    Eigen::VectorXf code(code_size_);
    encode_features(in.data(), code.data(), context);
    return code;
}

Points Network::decode(const Eigen::Ref<const Eigen::VectorXf>& code, const Similarity* motion,
                       const Context& context) const {
    needed(decoder_, "decoder");
    if (code.size() != code_size_)
        fail(Status::mismatch, "a code of %lld numbers for a network of %lld",
             static_cast<long long>(code.size()), static_cast<long long>(code_size_));
    if (!code.allFinite()) fail(Status::invalid_argument, "a code that is not finite");
    Eigen::VectorXf out(static_cast<Index>(decoder_->outputs()));
    decode_features(code.data(), out.data(), context);
    const Vector values = out.cast<double>();
    return output().decode(
        Eigen::Map<const Features>(values.data(), decoder_->rows_out(), decoder_->channels_out()),
        motion, context);
}

Points Network::apply(const PointsRef& face, const Context& context) const {
    Similarity motion;
    const Eigen::VectorXf code = encode(face, &motion, context);
    const Points out = decode(code, &motion, context);
    return is_deformation(output()) ? align_points(out, face, {}, false).apply(out) : out;
}

std::string network_json(const Network& network) {
    JsonText json;
    json.begin_object().field("name", network.origin().name);
    json.field("vertices", network.num_vertices())
        .field("triangles", network.input().mean().triangles.rows())
        .field("code", network.code_size())
        .field("encodes", network.encodes())
        .field("decodes", network.decodes())
        .field("input_features", feature_kind_name(network.input().kind()))
        .field("output_features", feature_kind_name(network.output().kind()))
        .field("weights", static_cast<std::int64_t>(network.num_weights()))
        .field("encoder_multiply_adds", network.encoder_products())
        .field("decoder_multiply_adds", network.decoder_products());
    add_layers(json, "encoder", network.layers(), network.layers().encoder);
    add_layers(json, "decoder", network.layers(), network.layers().decoder);
    if (!network.origin().training.empty()) json.key("training").raw(network.origin().training);
    json.end_object();
    return json.take();
}

}  // namespace mien
