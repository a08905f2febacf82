// A trained network on registered faces: features in, code, features out (kosk-2024, chapters 3 to
// 5), evaluated without any training library. In one file: the list of layers, weights, neighbour
// lists and the statistics of the features, all of which belong to one template.
#pragma once

#include <memory>
#include <string>

#include "learning/face_network.hpp"
#include "learning/network_program.hpp"

namespace mien {

enum class NetworkTask {
    face,         ///< the output is a face: the input's, or another of the same person
    displacement  ///< the output is what an expression adds to the input, a neutral face
};

class Network final : public FaceNetwork {
  public:
    /// `output` null: the same features as the input. Checks everything (check_layers()); sizes
    /// that do not fit throw Status::bad_format.
    static std::shared_ptr<const Network> make(NetworkLayers layers,
                                               std::shared_ptr<const FaceFeatures> input,
                                               std::shared_ptr<const FaceFeatures> output,
                                               NetworkOrigin origin, const Context& context,
                                               NetworkTask task = NetworkTask::face,
                                               CodeDistribution codes = {});
    /// A single network; Status::bad_format for a file of two.
    static std::shared_ptr<const Network> load(const std::string& path,
                                               const SafetensorsReadOptions& options,
                                               const Context& context);
    static std::shared_ptr<const Network> read(const SafetensorsFile& file, const Context& context);
    void save(const std::string& path, const Context& context) const override;
    /// The same as a part of another file: tensors and metadata whose names begin with `prefix`.
    static std::shared_ptr<const Network> read_part(const SafetensorsFile& file,
                                                    const std::string& prefix,
                                                    const Context& context);
    void append_to(const std::string& prefix, std::vector<TensorToWrite>& tensors,
                   std::map<std::string, std::string>& metadata) const;

    bool encodes() const { return encoder_ != nullptr; }
    bool decodes() const { return decoder_ != nullptr; }
    const TriMesh& mean() const override { return output().mean(); }
    double scale_mm() const override { return input_->scale_mm(); }
    bool gives_faces_back() const override { return task_ == NetworkTask::face; }
    Index code_size() const override { return code_size_; }
    NetworkTask task() const { return task_; }
    const NetworkLayers& layers() const { return layers_; }
    const FaceFeatures& input() const { return *input_; }
    const FaceFeatures& output() const { return output_ ? *output_ : *input_; }
    std::shared_ptr<const FaceFeatures> shared_input() const { return input_; }
    std::uint64_t num_weights() const;  ///< trained numbers
    double encoder_products() const;    ///< multiply-adds of one face
    double decoder_products() const;

    Eigen::VectorXf encode(const PointsRef& face, Similarity* motion,
                           const Context& context) const override;
    Points decode(const Eigen::Ref<const Eigen::VectorXf>& code, const Similarity* motion,
                  const Context& context) const override;
    /// decode(encode(face)) in the frame of `face`; deformations, which know no place, are put onto
    /// it rigidly. Of a displacement: the face with it; a deformed face keeps the face's centre.
    using FaceNetwork::apply;
    Points apply(const PointsRef& face, Index band_limit, const Context& context) const override;
    std::string json() const override;

    // The parts alone, in float: features (#V x channels, row-major) and code.

    void encode_features(const float* features, float* code, const Context& context) const;
    /// Of a network with a condition, `code` is the decoder's whole input.
    void decode_features(const float* code, float* features, const Context& context) const;
    /// The code of features as FaceFeatures gives them, and features of the decoder's input.
    Eigen::VectorXf code_of(const Features& features, const Context& context) const;
    Features features_of(const Eigen::Ref<const Eigen::VectorXf>& code,
                         const Context& context) const;

  private:
    NetworkLayers layers_;
    std::shared_ptr<const FaceFeatures> input_, output_;
    NetworkTask task_ = NetworkTask::face;
    std::unique_ptr<const NetworkProgram> encoder_, decoder_;
    Index code_size_ = 0;
};

}  // namespace mien
