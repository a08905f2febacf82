// Made-up people for demonstrations and tests: a parametric head with named identity directions, 20
// expressions whose shapes depend on the person, and simulated scans. No file is read, nothing is
// downloaded; the same seed gives the same bits everywhere.
//
//     const mien::demo::DemoFaces faces;                       // about a second: meshes the
//     template const auto person = faces.person(1, 7);                  // seed, subject
//     std::vector<double> grin = faces.face(person, faces.expression_index("grin"));
//
// Lengths are millimetres; +x the subject's left, +y up, +z out of the face. Arrays are flat:
// vertices x0 y0 z0 x1 ..., triangles three indices each, counter-clockwise seen from outside.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace mien::demo {

struct FaceMesh {
    std::vector<double> vertices;          ///< 3 #V
    std::vector<std::uint32_t> triangles;  ///< 3 #F
    std::vector<std::uint8_t> colors;      ///< 3 #V, or empty
};

/// All that makes one person, a function of (seed, subject) alone.
struct Person {
    std::uint64_t seed = 0;
    int subject = 0;
    std::vector<double> weights;  ///< one per identity direction, unit variance, within +-2.5
    double liveliness = 1;        ///< scales every expression
    double detail_mm = 0.25;      ///< soft shape that no identity direction explains
    /// Of a person of nonlinear_person(): what moves the features about. Empty: the linear family.
    std::vector<double> places;
    /// Standard deviation of what an expression's strength has beyond its function of the person
    /// (of nonlinear_person(); 1 would be the whole strength).
    double strength_noise = 0;
};

struct ScanOptions {
    std::uint64_t seed = 0;       ///< another scan of the same face
    bool cylindrical = true;      ///< from ear to ear; otherwise from the front only
    double step_mm = 1.0;         ///< distance of scan points
    double noise_mm = 0.15;       ///< standard deviation along the ray
    double spike_share = 0.0004;  ///< share of points that are off by 3 to 25 mm
    int holes = 3;
    bool hair = true;
    double pose_deg = 14, pose_mm = 80;  ///< turned and moved by half to all of this
    double pick_mm = 1.0;                ///< standard deviation of the picked landmarks, per axis
};

/// A scan as a scanner makes it, in its own frame and connectivity, with the truth in that frame.
struct SimulatedScan {
    FaceMesh mesh;
    std::vector<std::pair<std::string, std::array<double, 3>>> landmarks;  ///< picked, with error
    std::vector<double> truth;          ///< template topology, 3 #V, scan frame
    std::vector<double> truth_neutral;  ///< the same person without expression, scan frame
    std::vector<std::uint8_t> visible;  ///< per template vertex: the scan has its surface
    std::array<double, 9> rotation{};   ///< row-major; scan = rotation * head + translation
    std::array<double, 3> translation{};
};

class DemoFaces {
  public:
    DemoFaces();
    ~DemoFaces();
    DemoFaces(const DemoFaces&) = delete;
    DemoFaces& operator=(const DemoFaces&) = delete;

    /// About 10,000 vertices, mirror-symmetric; borders: two eyes, mouth slit, neck.
    const FaceMesh& template_mesh() const;
    /// 68 landmarks, Multi-PIE order.
    const std::vector<std::pair<std::string, std::uint32_t>>& landmarks() const;
    /// "face" contains all others; the others are disjoint.
    const std::vector<std::pair<std::string, std::vector<std::uint32_t>>>& zones() const;
    const std::vector<std::uint32_t>& lips() const;    ///< the vermilion
    const std::vector<std::uint32_t>& mirror() const;  ///< each vertex's partner

    static const std::vector<std::string>& expression_names();  ///< 20; "neutral" first
    static int expression_index(const std::string& name);       ///< -1: unknown
    const std::vector<std::string>& identity_names() const;
    /// Displacement of identity direction k at weight 1, 3 #V.
    const std::vector<double>& identity_direction(int k) const;

    Person person(std::uint64_t seed, int subject) const;
    /// A person of another family, in which shapes are no sums of fixed directions: twelve soft
    /// features (ridges, hollows, bulges) sit at places, in heights and widths of the person's own,
    /// the identity directions end softly at two deviations, and strength, asymmetry and pulls of
    /// an expression are smooth functions of the person. 48 numbers make the neutral face but for
    /// its detail; as a span of directions the family has several times as many.
    Person nonlinear_person(std::uint64_t seed, int subject) const;
    /// The same person without chance: no detail, expressions as the function of the person says.
    /// The difference to the person is what no predictor can know.
    static Person without_chance(Person person);
    /// Vertices, 3 #V. The expression 0 is neutral.
    std::vector<double> face(const Person& person, int expression) const;
    /// All expressions of one person, in the order of expression_names(); cheaper than one by one.
    std::vector<std::vector<double>> all_faces(const Person& person) const;
    SimulatedScan scan(const Person& person, int expression, const ScanOptions& options) const;

  private:
    struct Parts;
    std::unique_ptr<const Parts> parts_;
};

}  // namespace mien::demo
