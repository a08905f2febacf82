#include "training/faces.hpp"

#include <algorithm>
#include <Eigen/Eigenvalues>
#include <map>
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

void append(std::vector<float>& values, const Features& f) {
    for (Index i = 0; i < f.size(); ++i) values.push_back(static_cast<float>(f.data()[i]));
}

/// No faces yet, whose errors are weighed by what one unit of `output` is worth: restore() is
/// affine in every feature.
TrainingData no_faces(Index faces, const FaceFeatures& input, const FaceFeatures& output) {
    TrainingData out;
    out.faces = faces;
    out.rows = input.num_vertices();
    out.channels = input.num_channels();
    out.input.reserve(static_cast<std::size_t>(out.faces * out.rows * out.channels));
    append(out.scale, output.restore(Features::Ones(out.rows, output.num_channels())) -
                          output.restore(Features::Zero(out.rows, output.num_channels())));
    return out;
}

TrainingData data_of(const FaceDataset& data, const std::vector<Index>& faces,
                     const FaceFeatures& features, const Context& context) {
    TrainingData out = no_faces(static_cast<Index>(faces.size()), features, features);
    Points face;
    for (const Index k : faces) {
        data.face(k, face);
        append(out.input, features.encode(face, nullptr, context));
    }
    return out;
}

/// Both lists of faces; the second may be empty (an empty list of people means nobody here).
std::pair<std::vector<Index>, std::vector<Index>> faces_of_split(const FaceDataset& data,
                                                                 const SubjectSplit& split,
                                                                 bool neutral_only) {
    std::pair<std::vector<Index>, std::vector<Index>> faces;
    faces.first = chosen_faces(data, split.training, neutral_only);
    if (faces.first.empty())
        fail(Status::not_found, "the dataset has no face of the training people");
    if (!split.validation.empty())
        faces.second = chosen_faces(data, split.validation, neutral_only);
    return faces;
}

FaceSource source_of(const FaceDataset& data, const std::vector<Index>& faces) {
    FaceSource source;
    source.count = static_cast<Index>(faces.size());
    source.face = [&](Index k, Points& face) {
        data.face(faces[static_cast<std::size_t>(k)], face);
    };
    return source;
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
    const auto [training, validation] = faces_of_split(data, split, neutral_only);
    PreparedFaces faces;
    faces.features =
        FaceFeatures::train(data.triangles(), source_of(data, training), kind, spread, context);
    faces.training = data_of(data, training, *faces.features, context);
    faces.validation = data_of(data, validation, *faces.features, context);
    return faces;
}

PreparedBands prepare_bands(const FaceDataset& data, const SubjectSplit& split, bool neutral_only,
                            const BandFeatureOptions& options, const Context& context) {
    const auto [training, validation] = faces_of_split(data, split, neutral_only);
    PreparedBands bands;
    bands.features =
        BandFeatures::train(data.triangles(), source_of(data, training), options, context);
    const FaceFeatures &low = bands.features->low(), &high = bands.features->high();
    Points face;
    const auto fill = [&](const std::vector<Index>& faces, TrainingData& of_low,
                          TrainingData& of_high) {
        of_low = no_faces(static_cast<Index>(faces.size()), low, low);
        of_high = no_faces(static_cast<Index>(faces.size()), high, high);
        for (const Index k : faces) {
            data.face(k, face);
            const BandFeatures::Pair pair = bands.features->encode(face, nullptr, context);
            append(of_low.input, pair.low);
            append(of_high.input, pair.high);
        }
    };
    fill(training, bands.low_training, bands.high_training);
    fill(validation, bands.low_validation, bands.high_validation);
    return bands;
}

FacePairs expression_pairs(const FaceDataset& data, const std::vector<std::int32_t>& people,
                           const std::string& expression) {
    const std::vector<std::string>& names = data.expression_names();
    const auto name = std::find(names.begin(), names.end(), expression);
    if (name == names.end())
        fail(Status::not_found, "the dataset has no expression '%.60s'", expression.c_str());
    const auto wanted = static_cast<std::int32_t>(name - names.begin());
    std::map<std::int32_t, std::pair<Index, Index>> places;  // of the neutral face, of the other
    for (Index k = 0; k < data.num_faces(); ++k) {
        if (std::find(people.begin(), people.end(), data.subject(k)) == people.end()) continue;
        auto& place = places.try_emplace(data.subject(k), -1, -1).first->second;
        if (data.expression(k) == data.neutral_expression()) place.first = k;
        if (data.expression(k) == wanted) place.second = k;
    }
    std::vector<std::pair<Index, Index>> found;
    for (const auto& entry : places)
        if (entry.second.first >= 0 && entry.second.second >= 0) found.push_back(entry.second);
    if (found.empty())
        fail(Status::not_found, "nobody listed has a neutral face and '%.60s'", expression.c_str());
    FacePairs pairs;
    pairs.count = static_cast<Index>(found.size());
    pairs.pair = [&data, found](Index k, Points& neutral, Points& face) {
        data.face(found[static_cast<std::size_t>(k)].first, neutral);
        data.face(found[static_cast<std::size_t>(k)].second, face);
    };
    return pairs;
}

PreparedExpression prepare_expression(const FaceDataset& data, const SubjectSplit& split,
                                      const std::string& expression, FeatureKind kind,
                                      FeatureSpread spread, const Context& context) {
    const FacePairs training = expression_pairs(data, split.training, expression);
    FaceSource neutrals;
    neutrals.count = training.count;
    Points neutral, face;
    neutrals.face = [&](Index k, Points& into) { training.pair(k, into, face); };
    PreparedExpression prepared;
    prepared.input = FaceFeatures::train(data.triangles(), neutrals, kind, spread, context);
    prepared.output = train_displacements(*prepared.input, training, kind, spread, context);
    const auto fill = [&](const FacePairs& pairs, TrainingData& out) {
        out = no_faces(pairs.count, *prepared.input, *prepared.output);
        for (Index k = 0; k < pairs.count; ++k) {
            pairs.pair(k, neutral, face);
            Similarity motion;
            append(out.input, prepared.input->encode(neutral, &motion, context));
            append(out.output,
                   prepared.output->prepare(raw_displacement(
                       *prepared.output, motion.apply(neutral), motion.apply(face), context)));
        }
    };
    fill(training, prepared.training);
    prepared.validation = no_faces(0, *prepared.input, *prepared.output);
    if (!split.validation.empty())
        fill(expression_pairs(data, split.validation, expression), prepared.validation);
    return prepared;
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
