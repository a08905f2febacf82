#include "learning/face_network.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

#include "base/error.hpp"
#include "base/json_tree.hpp"
#include "base/random.hpp"
#include "learning/band_network.hpp"
#include "learning/network.hpp"

namespace mien {
namespace {

constexpr const char* kNetworkKind = "mien-network";
constexpr std::uint64_t kSampleStream = 0x73616d706c65;

}  // namespace

CodeDistribution code_distribution(const Matrix& codes) {
    if (codes.cols() < 2)
        fail(Status::invalid_argument, "a distribution of %lld codes; give two or more",
             static_cast<long long>(codes.cols()));
    CodeDistribution d;
    d.mean = codes.rowwise().mean();
    const Matrix centred = codes.colwise() - d.mean;
    const Matrix covariance = centred * centred.transpose() / static_cast<double>(codes.cols() - 1);
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(covariance);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the covariance of the codes has no spectrum");
    const Vector& values = solver.eigenvalues();
    const double least = 1e-12 * std::max(values[values.size() - 1], 0.0);
    Index first = 0;
    while (first < values.size() && !(values[first] > least)) ++first;
    const Index kept = values.size() - first;
    if (kept == 0) {  // all codes are the same
        d.factor = Matrix::Zero(codes.rows(), 1);
        return d;
    }
    d.factor = solver.eigenvectors().rightCols(kept) * values.tail(kept).cwiseSqrt().asDiagonal();
    return d;
}

FaceNetwork::~FaceNetwork() = default;

std::shared_ptr<const FaceNetwork> FaceNetwork::load(const std::string& path,
                                                     const SafetensorsReadOptions& options,
                                                     const Context& context) {
    return read(SafetensorsFile::open(path, options, context), context);
}

std::shared_ptr<const FaceNetwork> FaceNetwork::read(const SafetensorsFile& file,
                                                     const Context& context) {
    file.require_kind(kNetworkKind);
    if (file.metadata().count("bands") != 0) return BandNetwork::read(file, context);
    return Network::read(file, context);
}

Points FaceNetwork::mix(const PointsRef& a, const PointsRef& b, double low_weight,
                        double high_weight, const Context& context) const {
    if (!std::isfinite(low_weight) || !std::isfinite(high_weight))
        fail(Status::invalid_argument, "weights of bands that are not finite");
    Similarity motion;
    Eigen::VectorXf code = encode(a, &motion, context);
    const Eigen::VectorXf towards = encode(b, nullptr, context) - code;
    const Index low = low_code_size(), high = code_size() - low;
    code.head(low) += static_cast<float>(low_weight) * towards.head(low);
    code.tail(high) += static_cast<float>(high_weight) * towards.tail(high);
    return decode(code, &motion, context);
}

Eigen::VectorXf FaceNetwork::sample(std::uint64_t seed, std::uint64_t number, double spread) const {
    if (codes() == nullptr)
        fail(Status::unsupported_option,
             "the network holds no distribution of codes; make it with today's mien-train");
    if (!std::isfinite(spread) || spread < 0)
        fail(Status::invalid_argument, "a spread of %g; 0 gives the mean code, 1 the training's",
             spread);
    const CounterRandom chance(seed ^ kSampleStream, number);
    Vector normal(codes_.factor.cols());
    for (Index k = 0; k < normal.size(); ++k)
        normal[k] = chance.normal(static_cast<std::uint64_t>(k));
    return (codes_.mean + spread * (codes_.factor * normal)).cast<float>();
}

void FaceNetwork::set_codes(CodeDistribution codes, Index code_size) {
    if (codes.mean.size() == 0) return;
    if (codes.mean.size() != code_size || codes.factor.rows() != code_size)
        fail(Status::mismatch, "a distribution of codes of %lld numbers for a network of %lld",
             static_cast<long long>(codes.mean.size()), static_cast<long long>(code_size));
    codes_ = std::move(codes);
}

void FaceNetwork::read_codes(const SafetensorsFile& file) {
    if (!file.has("codes.mean")) return;
    const std::int64_t size = code_size();
    const TensorView& mean = file.tensor("codes.mean", DType::f64, {size});
    const TensorView& factor = file.tensor("codes.factor", DType::f64, {-1, size});
    CodeDistribution codes;
    codes.mean = Eigen::Map<const Vector>(static_cast<const double*>(mean.data), size);
    codes.factor = Eigen::Map<const Matrix>(static_cast<const double*>(factor.data), size,
                                            static_cast<Index>(factor.shape[0]));
    set_codes(std::move(codes), size);
}

void FaceNetwork::append_codes(std::vector<TensorToWrite>& tensors) const {
    if (codes() == nullptr) return;
    const auto size = static_cast<std::uint64_t>(codes_.mean.size());
    tensors.push_back({"codes.mean", DType::f64, {size}, codes_.mean.data()});
    tensors.push_back({"codes.factor",  // columns of the factor one after the other
                       DType::f64,
                       {static_cast<std::uint64_t>(codes_.factor.cols()), size},
                       codes_.factor.data()});
}

NetworkOrigin read_origin(const SafetensorsFile& file, const std::string& prefix) {
    const auto text = [&](const char* key) {
        const auto entry = file.metadata().find(prefix + key);
        return entry == file.metadata().end() ? std::string() : entry->second;
    };
    NetworkOrigin origin{text("name"), text("training")};
    if (!origin.training.empty())  // it becomes a part of json()
        JsonTree(origin.training.data(), origin.training.size(), "the network's training");
    return origin;
}

void write_network_file(const std::string& path, std::vector<TensorToWrite> tensors,
                        std::map<std::string, std::string> metadata, const Context& context) {
    metadata["kind"] = kNetworkKind;
    metadata["units"] = "millimetres";
    std::stable_sort(tensors.begin(), tensors.end(),
                     [](const TensorToWrite& a, const TensorToWrite& b) {
                         return dtype_bytes(a.dtype) > dtype_bytes(b.dtype);
                     });
    write_safetensors(path, tensors, std::move(metadata), context);
}

}  // namespace mien
