#include "learning/network.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "base/json_tree.hpp"
#include "geometry/alignment.hpp"
#include "learning/displacement_features.hpp"

namespace mien {
namespace {

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
                                             NetworkOrigin origin, const Context& context,
                                             NetworkTask task, CodeDistribution codes) {
    check_layers(layers);
    auto network = std::make_shared<Network>();
    network->layers_ = std::move(layers);
    network->input_ = std::move(input);
    network->output_ = std::move(output);
    network->origin_ = std::move(origin);
    network->task_ = task;
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
    network->set_codes(std::move(codes), network->code_size_);
    return network;
}

std::shared_ptr<const Network> Network::load(const std::string& path,
                                             const SafetensorsReadOptions& options,
                                             const Context& context) {
    const auto any = FaceNetwork::load(path, options, context);
    auto single = std::dynamic_pointer_cast<const Network>(any);
    if (!single)
        fail(Status::bad_format, "%.150s: holds two networks over the bands of a face, not one",
             path.c_str());
    return single;
}

std::shared_ptr<const Network> Network::read(const SafetensorsFile& file, const Context& context) {
    const auto network = std::const_pointer_cast<Network>(read_part(file, "", context));
    if (network->layers_.condition != 0)
        fail(Status::bad_format,
             "a network that decodes with the code of another, which is not in "
             "the file");
    network->read_codes(file);
    return network;
}

std::shared_ptr<const Network> Network::read_part(const SafetensorsFile& file,
                                                  const std::string& prefix,
                                                  const Context& context) {
    NetworkLayers layers;
    read_layers_json(file.metadata(prefix + "layers"), layers);
    for (const auto* list : {&layers.encoder, &layers.decoder, &layers.variance})
        for (const NetworkLayer& layer : *list)
            for (const auto& entry : layer.tensors) {
                const auto found = file.tensors().find(prefix + entry.second);
                if (found == file.tensors().end()) continue;  // check_layers() says which
                NetworkTensor tensor;
                tensor.dtype = found->second.dtype;
                tensor.shape = found->second.shape;
                tensor.data = found->second.data;
                tensor.owner = file.storage();
                layers.tensors[entry.second] = tensor;
            }
    auto input = FaceFeatures::read(file, prefix + "input.");
    std::shared_ptr<const FaceFeatures> output;
    if (file.has(prefix + "output.mean_shape"))
        output = FaceFeatures::read(file, prefix + "output.");
    NetworkTask task = NetworkTask::face;
    if (const auto entry = file.metadata().find(prefix + "task"); entry != file.metadata().end()) {
        if (entry->second != "displacement" || output == nullptr)
            fail(Status::bad_format,
                 "a network of a task that this library does not know, or "
                 "without the features of its displacements");
        task = NetworkTask::displacement;
    }
    return make(std::move(layers), std::move(input), std::move(output), read_origin(file, prefix),
                context, task);
}

void Network::append_to(const std::string& prefix, std::vector<TensorToWrite>& tensors,
                        std::map<std::string, std::string>& metadata) const {
    metadata[prefix + "layers"] = layers_json(layers_);
    metadata[prefix + "name"] = origin_.name;
    if (!origin_.training.empty()) metadata[prefix + "training"] = origin_.training;
    if (task_ == NetworkTask::displacement) metadata[prefix + "task"] = "displacement";
    input_->append_to(prefix + "input.", tensors, metadata);
    if (output_) output_->append_to(prefix + "output.", tensors, metadata);
    for (const auto& [name, tensor] : layers_.tensors)
        tensors.push_back({prefix + name, tensor.dtype, tensor.shape, tensor.data});
}

void Network::save(const std::string& path, const Context& context) const {
    if (layers_.condition != 0)
        fail(Status::invalid_argument,
             "a network that decodes with the code of another is saved together with that");
    std::vector<TensorToWrite> tensors;
    std::map<std::string, std::string> metadata;
    append_to("", tensors, metadata);
    append_codes(tensors);
    write_network_file(path, std::move(tensors), std::move(metadata), context);
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

Eigen::VectorXf Network::code_of(const Features& features, const Context& context) const {
    const Eigen::VectorXf in =
        Eigen::Map<const Vector>(features.data(), features.size()).cast<float>();
    Eigen::VectorXf code(code_size_);
    encode_features(in.data(), code.data(), context);
    return code;
}

Features Network::features_of(const Eigen::Ref<const Eigen::VectorXf>& code,
                              const Context& context) const {
    needed(decoder_, "decoder");
    if (code.size() != static_cast<Index>(decoder_->inputs()))
        fail(Status::mismatch, "a code of %lld numbers for a network of %lld",
             static_cast<long long>(code.size()), static_cast<long long>(decoder_->inputs()));
    if (!code.allFinite()) fail(Status::invalid_argument, "a code that is not finite");
    Eigen::VectorXf out(static_cast<Index>(decoder_->outputs()));
    decode_features(code.data(), out.data(), context);
    const Vector values = out.cast<double>();
    return Eigen::Map<const Features>(values.data(), decoder_->rows_out(),
                                      decoder_->channels_out());
}

Eigen::VectorXf Network::encode(const PointsRef& face, Similarity* motion,
                                const Context& context) const {
    needed(encoder_, "encoder");
    return code_of(input_->encode(face, motion, context), context);
}

Points Network::decode(const Eigen::Ref<const Eigen::VectorXf>& code, const Similarity* motion,
                       const Context& context) const {
    if (task_ == NetworkTask::displacement)
        fail(Status::unsupported_option,
             "this network's codes are of what an expression adds to a neutral face; apply it to "
             "one");
    return output().decode(features_of(code, context), motion, context);
}

Points Network::apply(const PointsRef& face, Index, const Context& context) const {
    Similarity motion;
    const Eigen::VectorXf code = encode(face, &motion, context);
    if (task_ == NetworkTask::displacement)
        return motion.inverse().apply(
            add_displacement(output(), motion.apply(face), features_of(code, context), context));
    const Points out = decode(code, &motion, context);
    return is_deformation(output()) ? align_points(out, face, {}, false).apply(out) : out;
}

std::string Network::json() const {
    const Network& network = *this;
    JsonText json;
    json.begin_object().field("name", network.origin().name);
    json.field("vertices", network.num_vertices())
        .field("triangles", network.input().mean().triangles.rows())
        .field("code", network.code_size())
        .field("encodes", network.encodes())
        .field("decodes", network.decodes())
        .field("task", task_ == NetworkTask::face ? "face" : "displacement")
        .field("samples", codes() != nullptr)
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
