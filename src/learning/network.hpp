// A trained network on registered faces: features in, code, features out (kosk-2024, chapters 3 to
// 5), evaluated without any training library. In one file: the list of layers, weights, neighbour
// lists and the statistics of the features, all of which belong to one template.
#pragma once

#include <memory>
#include <string>

#include "learning/face_features.hpp"
#include "learning/network_program.hpp"

namespace mien {

/// What a network was made as; for reports, no computation depends on it.
struct NetworkOrigin {
    std::string name;      ///< e.g. "spiralnet++"; may be empty
    std::string training;  ///< JSON of the trainer's settings and results; may be empty
};

/// Immutable; shared freely between threads.
class Network {
  public:
    /// `output` null: the same features as the input. Checks everything (check_layers()); sizes
    /// that do not fit throw Status::bad_format.
    static std::shared_ptr<const Network> make(NetworkLayers layers,
                                               std::shared_ptr<const FaceFeatures> input,
                                               std::shared_ptr<const FaceFeatures> output,
                                               NetworkOrigin origin, const Context& context);
    /// safetensors, kind "mien-network", format 1. Treated as hostile.
    static std::shared_ptr<const Network> load(const std::string& path,
                                               const SafetensorsReadOptions& options,
                                               const Context& context);
    static std::shared_ptr<const Network> read(const SafetensorsFile& file, const Context& context);
    void save(const std::string& path, const Context& context) const;

    bool encodes() const { return encoder_ != nullptr; }
    bool decodes() const { return decoder_ != nullptr; }
    Index num_vertices() const { return input_->num_vertices(); }
    Index code_size() const { return code_size_; }
    const NetworkLayers& layers() const { return layers_; }
    const NetworkOrigin& origin() const { return origin_; }
    const FaceFeatures& input() const { return *input_; }
    const FaceFeatures& output() const { return output_ ? *output_ : *input_; }
    std::uint64_t num_weights() const;  ///< trained numbers
    double encoder_products() const;    ///< multiply-adds of one face
    double decoder_products() const;

    /// The code of a face (#V x 3, mm, anywhere in space). `motion` (optional) receives the rigid
    /// motion onto the training's mean. Throws Status::mismatch for another number of vertices and
    /// Status::unsupported_option for a network without encoder.
    Eigen::VectorXf encode(const PointsRef& face, Similarity* motion, const Context& context) const;
    /// The face of a code, in the mean's frame, mm; with `motion` where that came from.
    Points decode(const Eigen::Ref<const Eigen::VectorXf>& code, const Similarity* motion,
                  const Context& context) const;
    /// decode(encode(face)) in the frame of `face`; deformations, which know no place, are put onto
    /// it rigidly.
    Points apply(const PointsRef& face, const Context& context) const;

    /// The parts alone, in float: features (#V x channels, row-major) and code.
    void encode_features(const float* features, float* code, const Context& context) const;
    void decode_features(const float* code, float* features, const Context& context) const;

  private:
    NetworkLayers layers_;
    std::shared_ptr<const FaceFeatures> input_, output_;
    NetworkOrigin origin_;
    std::unique_ptr<const NetworkProgram> encoder_, decoder_;
    Index code_size_ = 0;
};

/// What a network is, as JSON: origin, sizes, layers, costs.
std::string network_json(const Network& network);

}  // namespace mien
