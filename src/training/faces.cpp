#include "training/faces.hpp"

#include <algorithm>
#include <Eigen/Eigenvalues>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json_text.hpp"
#include "base/json_tree.hpp"
#include "base/random.hpp"
#include "learning/network_evaluation.hpp"
#include "mesh/decimation.hpp"

namespace mien::training {
namespace {

std::vector<std::int32_t> read_people(const JsonTree::Value& list, const std::string& path,
                                      const char* name, std::set<std::int32_t>& seen) {
    std::vector<std::int32_t> people;
    for (const JsonTree::Value& item : list.items()) {
        const double number = item.number("a subject");
        if (number != static_cast<double>(static_cast<std::int32_t>(number)))
            fail(Status::bad_format, "%.120s: '%s' holds a number that is no subject's",
                 path.c_str(), name);
        people.push_back(static_cast<std::int32_t>(number));
        if (!seen.insert(people.back()).second)
            fail(Status::bad_format, "%.120s: subject %d is listed twice", path.c_str(),
                 people.back());
    }
    return people;
}

TrainingData data_of(const FaceDataset& data, const std::vector<Index>& faces,
                     const FaceFeatures& features, const Context& context) {
    TrainingData out;
    out.faces = static_cast<Index>(faces.size());
    out.rows = features.num_vertices();
    out.channels = features.num_channels();
    out.input.reserve(static_cast<std::size_t>(out.faces * out.rows * out.channels));
    Points face;
    for (const Index k : faces) {
        data.face(k, face);
        const Features f = features.encode(face, nullptr, context);
        for (Index i = 0; i < f.size(); ++i) out.input.push_back(static_cast<float>(f.data()[i]));
    }
    // restore() is affine in every feature: what one unit is worth.
    const Features zero = Features::Zero(out.rows, out.channels);
    const Features unit =
        features.restore(Features::Ones(out.rows, out.channels)) - features.restore(zero);
    for (Index i = 0; i < unit.size(); ++i) out.scale.push_back(static_cast<float>(unit.data()[i]));
    return out;
}

}  // namespace

SubjectSplit make_split(const FaceDataset& data, std::uint64_t seed) {
    std::set<std::int32_t> people;
    for (Index k = 0; k < data.num_faces(); ++k) people.insert(data.subject(k));
    if (people.size() < 3)
        fail(Status::invalid_argument, "the dataset has %zu people; a split needs three",
             people.size());
    const CounterRandom chance(seed, 0x73706c6974);
    std::vector<std::pair<double, std::int32_t>> order;
    for (const std::int32_t person : people)
        order.emplace_back(chance.uniform(static_cast<std::uint64_t>(person)), person);
    std::sort(order.begin(), order.end());
    const std::size_t count = order.size();
    const std::size_t test = std::max<std::size_t>(1, (count + 5) / 10);
    const std::size_t validation = std::max<std::size_t>(1, (count + 10) / 20);
    SubjectSplit split;
    for (std::size_t k = 0; k < count; ++k) {
        auto& list = k < test                ? split.test
                     : k < test + validation ? split.validation
                                             : split.training;
        list.push_back(order[k].second);
    }
    for (auto* list : {&split.training, &split.validation, &split.test})
        std::sort(list->begin(), list->end());
    return split;
}

SubjectSplit read_split(const std::string& path) {
    const FileBytes bytes = read_whole_file(path, {});
    const JsonTree tree(bytes.data, bytes.size, "the split");
    SubjectSplit split;
    std::set<std::int32_t> seen;
    split.training = read_people(tree.root()["training"], path, "training", seen);
    split.validation = read_people(tree.root()["validation"], path, "validation", seen);
    split.test = read_people(tree.root()["test"], path, "test", seen);
    if (split.training.empty() || split.test.empty())
        fail(Status::bad_format,
             "%.120s: expected {\"training\": [...], \"validation\": [...], \"test\": [...]} with "
             "people in the first and the last",
             path.c_str());
    return split;
}

void write_split(const std::string& path, const SubjectSplit& split) {
    JsonText json;
    json.begin_object()
        .field("training", split.training)
        .field("validation", split.validation)
        .field("test", split.test)
        .end_object();
    AtomicFile file(path);
    file.write(json.take() + "\n");
    file.commit();
}

PreparedFaces prepare_faces(const FaceDataset& data, const SubjectSplit& split, bool neutral_only,
                            FeatureKind kind, FeatureSpread spread, const Context& context) {
    const std::vector<Index> training = chosen_faces(data, split.training, neutral_only);
    if (training.empty()) fail(Status::not_found, "the dataset has no face of the training people");
    FaceSource source;
    source.count = static_cast<Index>(training.size());
    source.face = [&](Index k, Points& face) {
        data.face(training[static_cast<std::size_t>(k)], face);
    };
    PreparedFaces faces;
    faces.features = FaceFeatures::train(data.triangles(), source, kind, spread, context);
    faces.training = data_of(data, training, *faces.features, context);
    std::vector<Index> validation;  // an empty list of people means nobody here
    if (!split.validation.empty()) validation = chosen_faces(data, split.validation, neutral_only);
    faces.validation = data_of(data, validation, *faces.features, context);
    return faces;
}

void decimate_dataset(const FaceDataset& data, Index vertices, const std::string& path,
                      const Context& context) {
    TriMesh mean;
    Points face;
    for (Index k = 0; k < data.num_faces(); ++k) {
        data.face(k, face);
        if (k == 0)
            mean.vertices = face;
        else
            mean.vertices += face;
    }
    mean.vertices /= static_cast<double>(data.num_faces());
    mean.triangles = data.triangles();
    const DecimatedMesh coarse = decimate(mean, vertices, context);
    FaceDatasetWriter writer(coarse.mesh.triangles, coarse.mesh.vertices.rows(),
                             data.expression_names());
    for (Index k = 0; k < data.num_faces(); ++k) {
        data.face(k, face);
        Points kept(coarse.mesh.vertices.rows(), 3);
        for (std::size_t v = 0; v < coarse.kept.size(); ++v)
            kept.row(static_cast<Index>(v)) = face.row(coarse.kept[v]);
        writer.add(kept, data.subject(k), data.expression(k));
    }
    writer.save(path, context);
}

NetworkLayers pca_network(const TrainingData& training, Index latent) {
    const Index size = training.rows * training.channels, faces = training.faces;
    const Index kept = std::min(latent, faces - 1);
    if (kept < 1) fail(Status::invalid_argument, "principal components of one face");
    Matrix x = Eigen::Map<const Eigen::MatrixXf>(training.input.data(), size, faces).cast<double>();
    const Vector mean = x.rowwise().mean();
    x.colwise() -= mean;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(x.transpose() * x);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the faces have no principal components");
    Matrix basis(size, kept);
    Index used = 0;
    for (; used < kept; ++used) {
        const Index column = faces - 1 - used;
        const double value = solver.eigenvalues()[column];
        if (!(value > 1e-12 * solver.eigenvalues()[faces - 1])) break;
        basis.col(used) = x * solver.eigenvectors().col(column) / std::sqrt(value);
    }
    basis.conservativeResize(size, used);
    NetworkLayers network;
    const auto floats = [](const Matrix& m) {  // row-major
        std::vector<float> values;
        for (Index r = 0; r < m.rows(); ++r)
            for (Index c = 0; c < m.cols(); ++c) values.push_back(static_cast<float>(m(r, c)));
        return values;
    };
    const auto n = static_cast<std::uint64_t>(size), k = static_cast<std::uint64_t>(used);
    network.tensors["encoder.weight"] = make_tensor({n, k}, floats(basis));
    network.tensors["encoder.bias"] = make_tensor({k}, floats(-basis.transpose() * mean));
    network.tensors["decoder.weight"] = make_tensor({k, n}, floats(basis.transpose()));
    network.tensors["decoder.bias"] = make_tensor({n}, floats(mean));
    NetworkLayer layer;
    layer.kind = LayerKind::dense;
    layer.rows_in = training.rows;
    layer.channels_in = training.channels;
    layer.rows_out = 1;
    layer.channels_out = used;
    layer.tensors = {{"weight", "encoder.weight"}, {"bias", "encoder.bias"}};
    network.encoder.push_back(layer);
    std::swap(layer.rows_in, layer.rows_out);
    std::swap(layer.channels_in, layer.channels_out);
    layer.tensors = {{"weight", "decoder.weight"}, {"bias", "decoder.bias"}};
    network.decoder.push_back(layer);
    return network;
}

}  // namespace mien::training
