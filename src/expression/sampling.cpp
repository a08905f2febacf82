#include "expression/sampling.hpp"

#include <cmath>
#include <Eigen/Cholesky>

#include "base/error.hpp"
#include "base/json.hpp"
#include "expression/fit.hpp"
#include "expression/neutralize.hpp"
#include "expression/neutralize_mesh.hpp"

namespace mien {
namespace {

/// Counter-based: splitmix64 and Box-Muller, so that no library's generator enters the result.
class Normal {
  public:
    explicit Normal(std::uint64_t seed)
        : state_(seed * 0x9e3779b97f4a7c15ull + 0x632be59bd9b4e019ull) {}
    double operator()() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    }
    Vector vector(Index size) {
        Vector values(size);
        for (Index k = 0; k < size; ++k) values[k] = (*this)();
        return values;
    }

  private:
    double uniform() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        z ^= z >> 31;
        return static_cast<double>(z >> 11) * 0x1p-53;
    }
    std::uint64_t state_;
};

}  // namespace

SampledCoordinates sample_coordinates(const ExpressionModel& model, std::uint64_t seed,
                                      const std::string& expression) {
    Normal normal(seed);
    SampledCoordinates sample;
    // Smooth modes say what a fit must reckon with, not what people look like.
    const Index people = model.num_people_modes();
    sample.identity = Vector::Zero(model.num_identity_modes());
    sample.identity.head(people) =
        model.identity_deviations.head(people).cwiseProduct(normal.vector(people));
    sample.expression = Vector::Zero(model.num_expression_modes());
    if (expression.empty()) return sample;
    for (const ExpressionComponent& component : model.components)
        if (component.name == expression) {
            const Eigen::LLT<Matrix> factor(component.covariance);
            if (factor.info() != Eigen::Success)
                fail(Status::no_solution, "the covariance of the expression '%s' is damaged",
                     shown_name(expression).c_str());
            sample.expression =
                component.mean + factor.matrixL() * normal.vector(model.num_expression_modes());
            if (component.follows.size() != 0)
                sample.expression +=
                    component.follows * sample.identity.head(component.follows.cols());
            return sample;
        }
    fail(Status::not_found, "the model has no expression '%s'", shown_name(expression).c_str());
}

Points sample_face(const Context& context, const ExpressionModel& model, std::uint64_t seed,
                   const std::string& expression) {
    const SampledCoordinates sample = sample_coordinates(model, seed, expression);
    return synthesize_face(context, model, sample.identity, sample.expression);
}

Points transfer_expression(const Context& context, const ExpressionModel& model,
                           const TriMesh& neutral, const Similarity& pose,
                           const Vector& expression) {
    const TopologyMatch match = match_topology(model, neutral.vertices.rows(), neutral.triangles);
    if (match == TopologyMatch::none || expression.size() != model.num_expression_modes())
        fail(Status::mismatch, "the face or the expression belongs to another expression model");
    const Vector moved = expression_displacement(context, model, expression);
    const Points displacement =
        Eigen::Map<const Points>(moved.data(), model.num_vertices(), 3) * pose.rotation.transpose();
    if (match == TopologyMatch::same) return neutral.vertices + displacement;
    const NeutralizeMeshOptions defaults;
    return neutral.vertices + extend_displacement(neutral.vertices, neutral.triangles, displacement,
                                                  defaults.decay_mm);
}

}  // namespace mien
