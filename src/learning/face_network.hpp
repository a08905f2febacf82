// What one file of kind "mien-network" holds, whatever is inside: one network (network.hpp) or two
// over the bands of a face (band_network.hpp). Faces become codes, codes faces.
#pragma once

#include <memory>
#include <string>

#include "learning/face_features.hpp"

namespace mien {

/// What a network was made as; for reports, no computation depends on it.
struct NetworkOrigin {
    std::string name;      ///< e.g. "spiralnet++"; may be empty
    std::string training;  ///< JSON of the trainer's settings and results; may be empty
};

/// A Gaussian over the codes of the training faces. Networks whose divergence weighs as little as
/// kosk-2024 has it (1e-6) are far from N(0, I).
struct CodeDistribution {
    Vector mean;
    Matrix factor;  ///< code x directions: the covariance is factor factor'
};
/// Of codes (one a column); at most faces - 1 directions. Throws Status::invalid_argument for fewer
/// than two.
CodeDistribution code_distribution(const Matrix& codes);

/// "All frequencies of the low band": more than any basis has.
constexpr Index kWholeBand = Index(1) << 30;

/// Immutable; shared freely between threads.
class FaceNetwork {
  public:
    virtual ~FaceNetwork();
    FaceNetwork(const FaceNetwork&) = delete;
    FaceNetwork& operator=(const FaceNetwork&) = delete;

    /// safetensors, kind "mien-network", format 2. Treated as hostile.
    static std::shared_ptr<const FaceNetwork> load(const std::string& path,
                                                   const SafetensorsReadOptions& options,
                                                   const Context& context);
    static std::shared_ptr<const FaceNetwork> read(const SafetensorsFile& file,
                                                   const Context& context);
    virtual void save(const std::string& path, const Context& context) const = 0;

    virtual const TriMesh& mean() const = 0;  ///< in whose frame codes are decoded, mm
    Index num_vertices() const { return mean().vertices.rows(); }
    virtual Index code_size() const = 0;
    /// Numbers of the code that belong to the low band; they come first. code_size() for a single
    /// network.
    virtual Index low_code_size() const { return code_size(); }
    /// Modes of the low band; -1 for a single network.
    virtual Index band_limit() const { return -1; }
    virtual double scale_mm() const = 0;
    /// false: its result is the input, a neutral face, with an expression.
    virtual bool gives_faces_back() const = 0;

    /// The code of a face (#V x 3, mm, anywhere in space). `motion` (optional) receives the rigid
    /// motion onto the training's mean. Throws Status::mismatch for another number of vertices and
    /// Status::unsupported_option for a network without encoder.
    virtual Eigen::VectorXf encode(const PointsRef& face, Similarity* motion,
                                   const Context& context) const = 0;
    /// The face of a code, in the mean's frame, mm; with `motion` where that came from. Throws
    /// Status::unsupported_option for a network without decoder, or whose result is no face but
    /// what an expression adds to one.
    virtual Points decode(const Eigen::Ref<const Eigen::VectorXf>& code, const Similarity* motion,
                          const Context& context) const = 0;
    /// The face given back, or with the expression that the network was trained on, in the frame of
    /// `face`. `band_limit`: of expressions from two networks, in the place of the file's own
    /// (negative: that one); a larger one than the basis has means all of it.
    virtual Points apply(const PointsRef& face, Index band_limit, const Context& context) const = 0;
    Points apply(const PointsRef& face, const Context& context) const {
        return apply(face, -1, context);
    }
    virtual std::string json() const = 0;

    /// (4.16): each band's code moved from a's towards b's by its own weight (any real number; 0
    /// and 1 exchange the bands of two faces, 4.19), decoded in a's frame.
    Points mix(const PointsRef& a, const PointsRef& b, double low_weight, double high_weight,
               const Context& context) const;

    const NetworkOrigin& origin() const { return origin_; }
    const CodeDistribution* codes() const { return codes_.mean.size() > 0 ? &codes_ : nullptr; }
    /// Code number `number` of the stream of `seed`: the training codes' Gaussian, `spread` times
    /// its deviation. Throws Status::unsupported_option for a network that was saved without one.
    Eigen::VectorXf sample(std::uint64_t seed, std::uint64_t number, double spread) const;

  protected:
    FaceNetwork() = default;
    void read_codes(const SafetensorsFile& file);
    /// Throws Status::mismatch when the distribution is of other codes.
    void set_codes(CodeDistribution codes, Index code_size);
    void append_codes(std::vector<TensorToWrite>& tensors) const;
    NetworkOrigin origin_;

  private:
    CodeDistribution codes_;
};

/// The name and training of a file, with a prefix.
NetworkOrigin read_origin(const SafetensorsFile& file, const std::string& prefix);
/// Wide tensors first, then as write_safetensors().
void write_network_file(const std::string& path, std::vector<TensorToWrite> tensors,
                        std::map<std::string, std::string> metadata, const Context& context);

}  // namespace mien
