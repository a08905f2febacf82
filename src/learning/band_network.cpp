#include "learning/band_network.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "base/json_tree.hpp"

namespace mien {
namespace {

bool is_in_coordinates(const FaceFeatures& features) {
    return features.kind() < FeatureKind::deformation;
}

void check_autoencoders(const Network& low, const Network& high) {
    for (const Network* part : {&low, &high})
        if (!part->encodes() || !part->decodes() || part->task() != NetworkTask::face)
            fail(Status::bad_format, "a band of faces is no autoencoder");
    if (low.layers().condition != high.code_size() || high.layers().condition != low.code_size() ||
        low.layers().decoder.front().rows_in != high.layers().decoder.front().rows_in)
        fail(Status::bad_format, "the bands' decoders do not take each other's codes");
    if (low.input().kind() != low.output().kind() || high.input().kind() != high.output().kind())
        fail(Status::bad_format, "a band that is given back in other features");
}

void check_expressions(const BandNetwork::Parts& parts) {
    const Network &low = *parts.low, &high = *parts.high;
    for (const Network* part : {&low, &high})
        if (!part->encodes() || !part->decodes() || part->task() != NetworkTask::displacement ||
            part->layers().condition != 0)
            fail(Status::bad_format, "a band of an expression is no network to displacements");
    if (!is_in_coordinates(low.output()) || is_in_coordinates(high.output()))
        fail(Status::bad_format,
             "an expression's low band is not in coordinates, or its high one not in deformations");
    if (low.mean().triangles != high.mean().triangles ||
        low.num_vertices() != high.num_vertices() ||
        parts.basis->num_vertices() != low.num_vertices() || parts.band_limit < 0)
        fail(Status::bad_format, "the bands are of different templates, or their limit is below 0");
}

}  // namespace

Eigen::VectorXf joined_codes(const Eigen::Ref<const Eigen::VectorXf>& own,
                             const Eigen::Ref<const Eigen::VectorXf>& other, Index rows) {
    const Index a = own.size() / rows, b = other.size() / rows;
    Eigen::VectorXf joined(own.size() + other.size());
    for (Index r = 0; r < rows; ++r) {
        joined.segment(r * (a + b), a) = own.segment(r * a, a);
        joined.segment(r * (a + b) + a, b) = other.segment(r * b, b);
    }
    return joined;
}

std::shared_ptr<const BandNetwork> BandNetwork::make(Parts parts, NetworkOrigin origin,
                                                     CodeDistribution codes) {
    if (!(parts.conditioning >= 0 && parts.conditioning <= 1))
        fail(Status::bad_format, "a conditioning factor of %g; it is 0 to 1", parts.conditioning);
    auto network = std::make_shared<BandNetwork>();
    if (parts.task == BandTask::faces) {
        check_autoencoders(*parts.low, *parts.high);
        network->features_ = BandFeatures::make(
            parts.low->shared_input(), parts.high->shared_input(), parts.basis, parts.band_limit);
    } else {
        check_expressions(parts);
    }
    network->parts_ = std::move(parts);
    network->origin_ = std::move(origin);
    network->set_codes(std::move(codes), network->code_size());
    return network;
}

std::shared_ptr<const BandNetwork> BandNetwork::read(const SafetensorsFile& file,
                                                     const Context& context) {
    const std::string& text = file.metadata("bands");
    const JsonTree tree(text.data(), text.size(), "the network's bands");
    const std::string task = tree.root()["task"].text("task");
    Parts parts;
    if (task != "faces" && task != "expression")
        fail(Status::bad_format, "bands of the task '%s', which this library does not know",
             shown_name(task).c_str());
    parts.task = task == "faces" ? BandTask::faces : BandTask::expression;
    parts.band_limit = static_cast<Index>(
        std::min<std::uint64_t>(tree.root()["band_limit"].count("band_limit"), kWholeBand));
    parts.conditioning = tree.root()["conditioning"].number("conditioning", 1);
    parts.low = Network::read_part(file, "low.", context);
    parts.high = Network::read_part(file, "high.", context);
    parts.basis = read_basis_part(file, parts.low->mean());
    auto network =
        std::const_pointer_cast<BandNetwork>(make(std::move(parts), read_origin(file, "")));
    network->read_codes(file);
    return network;
}

void BandNetwork::save(const std::string& path, const Context& context) const {
    std::vector<TensorToWrite> tensors;
    std::map<std::string, std::string> metadata{{"name", origin_.name}};
    if (!origin_.training.empty()) metadata["training"] = origin_.training;
    JsonText json;
    json.begin_object()
        .field("task", task() == BandTask::faces ? "faces" : "expression")
        .field("band_limit", band_limit())
        .field("conditioning", conditioning())
        .end_object();
    metadata["bands"] = json.take();
    low().append_to("low.", tensors, metadata);
    high().append_to("high.", tensors, metadata);
    append_basis(basis(), tensors, metadata);
    append_codes(tensors);
    write_network_file(path, std::move(tensors), std::move(metadata), context);
}

Eigen::VectorXf BandNetwork::encode(const PointsRef& face, Similarity* motion,
                                    const Context& context) const {
    Eigen::VectorXf code(code_size());
    if (task() == BandTask::expression) {
        code << low().encode(face, motion, context), high().encode(face, nullptr, context);
        return code;
    }
    const BandFeatures::Pair features = features_->encode(face, motion, context);
    code << low().code_of(features.low, context), high().code_of(features.high, context);
    return code;
}

Points BandNetwork::decode(const Eigen::Ref<const Eigen::VectorXf>& code, const Similarity* motion,
                           const Context& context) const {
    if (task() == BandTask::expression)
        fail(Status::unsupported_option,
             "this network's codes are of what an expression adds to a neutral face; apply it to "
             "one");
    if (code.size() != code_size())
        fail(Status::mismatch, "a code of %lld numbers for a network of %lld",
             static_cast<long long>(code.size()), static_cast<long long>(code_size()));
    const Index rows = low().layers().decoder.front().rows_in;
    const Eigen::VectorXf of_low = code.head(low_code_size());
    const Eigen::VectorXf of_high = code.tail(high().code_size());
    // Decoders that saw nothing of the other band in training take nothing now.
    const float share = conditioning() > 0 ? 1.0f : 0.0f;
    return features_->decode(
        low().features_of(joined_codes(of_low, share * of_high, rows), context),
        high().features_of(joined_codes(of_high, share * of_low, rows), context), motion, context);
}

BandNetwork::Prediction BandNetwork::predict(const PointsRef& neutral,
                                             const Context& context) const {
    if (task() != BandTask::expression)
        fail(Status::unsupported_option, "this network gives faces back; it adds no expression");
    Prediction prediction{low().apply(neutral, context), high().apply(neutral, context)};
    const Eigen::RowVector3d shift =
        prediction.spatial.colwise().mean() - prediction.differential.colwise().mean();
    prediction.differential.rowwise() += shift;
    return prediction;
}

Points BandNetwork::apply(const PointsRef& face, Index limit, const Context& context) const {
    if (task() == BandTask::expression) {
        const Prediction prediction = predict(face, context);
        const Index k = limit < 0 ? band_limit() : limit;
        return assemble(basis(), prediction.spatial, prediction.differential,
                        k > basis().num_modes() ? num_vertices() : k, context);
    }
    Similarity motion;
    const Eigen::VectorXf code = encode(face, &motion, context);
    return decode(code, &motion, context);
}

std::string BandNetwork::json() const {
    JsonText json;
    json.begin_object().field("name", origin().name);
    json.field("vertices", num_vertices())
        .field("triangles", mean().triangles.rows())
        .field("code", code_size())
        .field("low_code", low_code_size())
        .field("encodes", true)
        .field("decodes", task() == BandTask::faces)
        .field("task", task() == BandTask::faces ? "face" : "displacement")
        .field("samples", codes() != nullptr)
        .field("band_limit", band_limit())
        .field("modes", basis().num_modes())
        .field("conditioning", conditioning())
        .field("input_features", "bands")
        .field("output_features", "bands")
        .field("weights", static_cast<std::int64_t>(low().num_weights() + high().num_weights()))
        .field("encoder_multiply_adds", low().encoder_products() + high().encoder_products())
        .field("decoder_multiply_adds", low().decoder_products() + high().decoder_products());
    json.key("bands").begin_array().raw(low().json()).raw(high().json()).end_array();
    if (!origin().training.empty()) json.key("training").raw(origin().training);
    json.end_object();
    return json.take();
}

}  // namespace mien
