// T_i minimises sum_j c_ij |e'_ij - T_i e_ij|^2 + a_i |n'_i - T_i n_i|^2 over the one-ring; the
// second term, with the unit normals scaled like the ring, decides what a flat ring leaves open.
// The inverse minimises sum_ij c_ij |x_i - x_j - T_i e_ij|^2, that is
//     L x = b(T),  b_i = sum_j c_ij (T_i + T_j) e_ij / 2.
// Departures. (1) The thesis' fit and inverse are not inverses of each other: the x that belongs to
// T(x) is not x, since b(T(x)) is not L x. So the change of T with b(T) = L x that costs the fits
// least, in the metric of their moments M, is added: T += M^-1 B'(B M^-1 B')^-1 (L x - b(T)), B the
// matrix of b; one more prefactored solve, and the round trip is exact. (2) Rotation vectors are
// unwound over the surface, neighbours that agree first, as ACAP does by optimisation, so that
// rotations near pi neither jump nor lose a turn. (3) Cotangent weights are clamped to 0.5..2 of
// their mean. In the thin triangles at the corners of the mouth they differ a hundredfold, and the
// change (1) then turns neighbours against each other by radians, which shows in what lies half-way
// between two faces.
#include "spectral/deformation_representation.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SVD>
#include <tuple>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "geometry/laplacian.hpp"
#include "geometry/normals.hpp"
#include "mesh/adjacency.hpp"

namespace mien {
namespace {

constexpr std::size_t kChunk = 1024;
constexpr double kLeastWeight = 0.5;      // of the mean weight
constexpr double kMostWeight = 2;         // of the mean weight
constexpr double kNormalWeight = 0.25;    // of the one-ring's moment
constexpr double kIdentityWeight = 1e-9;  // for rings that are lines or points
constexpr double kRegular = 1e-10;        // for modes that no one-ring sees (regular grids)

using RowMatrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

double ring_area(const Points& normals, const IncidentTriangles& incident, Index v) {
    double area = 0;
    for (const std::uint32_t f : incident.of(static_cast<std::size_t>(v)))
        area += normals.row(f).norm();
    return area;
}

}  // namespace

void polar_decomposition(const Matrix3& t, Matrix3& rotation, Matrix3& stretch) {
    const Eigen::JacobiSVD<Matrix3> svd(t, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (svd.info() != Eigen::Success)
        fail(Status::no_solution, "a deformation gradient is not finite");
    Matrix3 u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
    rotation = u * svd.matrixV().transpose();
    stretch = rotation.transpose() * t;
    stretch = 0.5 * (stretch + stretch.transpose()).eval();
}

Vector3 rotation_logarithm(const Matrix3& rotation) {
    // By the quaternion: the axis keeps all its digits at pi, where R - R' vanishes.
    Eigen::Quaterniond q(rotation);
    q.normalize();
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    const double sine = q.vec().norm();
    if (sine < 1e-300) return Vector3::Zero();
    return q.vec() * (2.0 * std::atan2(sine, q.w()) / sine);
}

Matrix3 rotation_exponential(const Vector3& vector) {
    const double angle = vector.norm();
    if (angle < 1e-300) return Matrix3::Identity();
    return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

struct DeformationRepresentation::State {
    TriMesh mesh;
    std::vector<int> ring_begin, ring;  // neighbours of each vertex
    std::vector<double> weight;         // c_ij by entry of `ring`, symmetric
    IncidentTriangles incident;
    Points unit_normals;
    Vector root_area;  // square root of the ring's area
    std::vector<Matrix3> inverse_moment;
    Vector normal_weight, identity_weight;
    std::vector<int> component;
    std::vector<int> starts;                 // lowest vertex of each component
    std::vector<Eigen::RowVector3d> centre;  // of each component's vertices
    std::vector<int> component_size;
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower>
        laplace;                                             // with one vertex of each piece pinned
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> dual;  // B M^-1 B'
    std::vector<char> pinned;

    void build_rings();
    void walk();
    void factorise();
    Points right_side(const Eigen::Ref<const Features>& t) const;
    Points laplace_times(const PointsRef& x) const;
    void unwind(Features& t) const;
    void add_transposed(const Points& y, Features& t) const;
    void centre_pieces(Points& x, const std::vector<Eigen::RowVector3d>& wanted) const;
};

void DeformationRepresentation::State::build_rings() {
    const Index n = mesh.vertices.rows();
    LaplacianOptions options;
    options.negative = NegativeCotangents::clamp;
    const SparseMatrix stiffness =
        build_laplacian(mesh.vertices, mesh.triangles, options).stiffness;
    double sum = 0;
    Index count = 0;
    for (Index j = 0; j < n; ++j)
        for (SparseMatrix::InnerIterator it(stiffness, j); it; ++it)
            if (it.row() != j) {
                sum -= it.value();
                ++count;
            }
    const double floor =
        count > 0 ? std::max(kLeastWeight * sum / static_cast<double>(count), 1e-12) : 1;
    ring_begin.assign(static_cast<std::size_t>(n) + 1, 0);
    for (Index j = 0; j < n; ++j) {
        for (SparseMatrix::InnerIterator it(stiffness, j); it; ++it)
            if (it.row() != j) {
                ring.push_back(static_cast<int>(it.row()));
                weight.push_back(std::min(kMostWeight * sum / static_cast<double>(count),
                                          std::max(floor, -it.value())));
            }
        ring_begin[static_cast<std::size_t>(j) + 1] = static_cast<int>(ring.size());
    }
    incident = incident_triangles(n, mesh.triangles);

    const Points normals = triangle_normals(mesh.vertices, mesh.triangles);
    unit_normals = vertex_normals(mesh.vertices, mesh.triangles);
    root_area.resize(n);
    normal_weight.resize(n);
    identity_weight.resize(n);
    inverse_moment.resize(static_cast<std::size_t>(n));
    for (Index v = 0; v < n; ++v) {
        root_area[v] = std::sqrt(ring_area(normals, incident, v));
        Matrix3 moment = Matrix3::Zero();
        for (int p = ring_begin[v]; p < ring_begin[v + 1]; ++p) {
            const Vector3 edge = mesh.vertices.row(v) - mesh.vertices.row(ring[p]);
            moment += weight[p] * edge * edge.transpose();
        }
        const double trace = moment.trace();
        // A loose vertex or a ring in one place: its gradient is the identity.
        normal_weight[v] = root_area[v] > 0 ? kNormalWeight * trace : 0.0;
        identity_weight[v] = trace > 0 ? kIdentityWeight * trace : 1.0;
        const Vector3 normal = unit_normals.row(v);
        moment += normal_weight[v] * normal * normal.transpose() +
                  identity_weight[v] * Matrix3::Identity();
        inverse_moment[v] = moment.inverse();
    }
}

void DeformationRepresentation::State::walk() {
    const Index n = mesh.vertices.rows();
    component.assign(static_cast<std::size_t>(n), -1);
    pinned.assign(static_cast<std::size_t>(n), 0);
    std::vector<int> queue;
    for (Index start = 0; start < n; ++start) {
        if (component[start] >= 0) continue;
        const int number = static_cast<int>(starts.size());
        starts.push_back(static_cast<int>(start));
        pinned[start] = 1;
        queue.assign(1, static_cast<int>(start));
        component[start] = number;
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (std::size_t next = 0; next < queue.size(); ++next) {
            const int v = queue[next];
            sum += mesh.vertices.row(v);
            for (int p = ring_begin[v]; p < ring_begin[v + 1]; ++p)
                if (component[ring[p]] < 0) {
                    component[ring[p]] = number;
                    queue.push_back(ring[p]);
                }
        }
        component_size.push_back(static_cast<int>(queue.size()));
        centre.push_back(sum / static_cast<double>(queue.size()));
    }
}

void DeformationRepresentation::State::factorise() {
    const Index n = mesh.vertices.rows();
    std::vector<Eigen::Triplet<double, int>> entries;
    for (Index v = 0; v < n; ++v) {
        double sum = 0;
        for (int p = ring_begin[v]; p < ring_begin[v + 1]; ++p) {
            sum += weight[p];
            if (ring[p] < v && !pinned[v] && !pinned[ring[p]])
                entries.emplace_back(static_cast<int>(v), ring[p], -weight[p]);
        }
        entries.emplace_back(static_cast<int>(v), static_cast<int>(v), pinned[v] ? 1.0 : sum);
    }
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    laplace.compute(matrix);
    if (laplace.info() != Eigen::Success || !(laplace.vectorD().minCoeff() > 0))
        fail(Status::no_solution, "the template's Laplacian cannot be factorised");

    // Row i of B acts on one row of the gradients of i and its neighbours.
    entries.clear();
    for (Index v = 0; v < n; ++v) {
        Vector3 own = Vector3::Zero();
        for (int p = ring_begin[v]; p < ring_begin[v + 1]; ++p) {
            const Vector3 half =
                0.5 * weight[p] * (mesh.vertices.row(v) - mesh.vertices.row(ring[p]));
            own += half;
            for (int d = 0; d < 3; ++d)
                entries.emplace_back(static_cast<int>(v), 3 * ring[p] + d, half[d]);
        }
        for (int d = 0; d < 3; ++d)
            entries.emplace_back(static_cast<int>(v), static_cast<int>(3 * v) + d, own[d]);
    }
    SparseMatrix b(n, 3 * n);
    b.setFromTriplets(entries.begin(), entries.end());
    entries.clear();
    for (Index v = 0; v < n; ++v)
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                entries.emplace_back(static_cast<int>(3 * v) + r, static_cast<int>(3 * v) + c,
                                     inverse_moment[v](r, c));
    SparseMatrix inverse_moments(3 * n, 3 * n);
    inverse_moments.setFromTriplets(entries.begin(), entries.end());
    SparseMatrix product = b * inverse_moments * SparseMatrix(b.transpose());
    double largest = 0;
    for (Index v = 0; v < n; ++v) largest = std::max(largest, product.coeff(v, v));
    for (Index v = 0; v < n; ++v) product.coeffRef(v, v) += kRegular * largest + 1e-300;
    dual.compute(product);
    if (dual.info() != Eigen::Success)
        fail(Status::no_solution, "the template's deformation operator cannot be factorised");
}

Points DeformationRepresentation::State::right_side(const Eigen::Ref<const Features>& t) const {
    const Index n = mesh.vertices.rows();
    Points b = Points::Zero(n, 3);
    for (Index v = 0; v < n; ++v) {
        const Eigen::Map<const RowMatrix3> own(&t.coeffRef(v, 0));
        for (int p = ring_begin[v]; p < ring_begin[v + 1]; ++p) {
            const Eigen::Map<const RowMatrix3> other(&t.coeffRef(ring[p], 0));
            const Vector3 edge = mesh.vertices.row(v) - mesh.vertices.row(ring[p]);
            b.row(v) += 0.5 * weight[p] * ((own + other) * edge).transpose();
        }
    }
    return b;
}

Points DeformationRepresentation::State::laplace_times(const PointsRef& x) const {
    Points product = Points::Zero(x.rows(), 3);
    for (Index v = 0; v < x.rows(); ++v)
        for (int p = ring_begin[v]; p < ring_begin[v + 1]; ++p)
            product.row(v) += weight[p] * (x.row(v) - x.row(ring[p]));
    return product;
}

void DeformationRepresentation::State::add_transposed(const Points& y, Features& t) const {
    for (Index v = 0; v < y.rows(); ++v) {
        Matrix3 change = Matrix3::Zero();
        for (int p = ring_begin[v]; p < ring_begin[v + 1]; ++p) {
            const Eigen::RowVector3d edge = mesh.vertices.row(v) - mesh.vertices.row(ring[p]);
            change += 0.5 * weight[p] * (y.row(v) - y.row(ring[p])).transpose() * edge;
        }
        Eigen::Map<RowMatrix3>(&t.coeffRef(v, 0)) += change * inverse_moment[v];
    }
}

void DeformationRepresentation::State::unwind(Features& t) const {
    // Turns whose neighbours agree come first, so that one vertex at odds with its neighbours does
    // not hand a wrong full turn to those behind it.
    struct Step {
        double jump_rad;
        int from, to;
        bool operator<(const Step& other) const {  // for a heap with the smallest jump on top
            return std::tie(jump_rad, to, from) > std::tie(other.jump_rad, other.to, other.from);
        }
    };
    const auto turn = [&](int v) { return Vector3(t.row(v).head<3>()); };
    std::vector<char> done(ring_begin.size() - 1, 0);
    std::vector<Step> heap;
    const auto leave = [&](int v) {
        done[static_cast<std::size_t>(v)] = 1;
        const Eigen::Quaterniond own(rotation_exponential(turn(v)));
        for (int p = ring_begin[v]; p < ring_begin[v + 1]; ++p)
            if (!done[static_cast<std::size_t>(ring[p])]) {
                const Eigen::Quaterniond other(rotation_exponential(turn(ring[p])));
                heap.push_back({own.angularDistance(other), v, ring[p]});
                std::push_heap(heap.begin(), heap.end());
            }
    };
    for (const int start : starts) {
        leave(start);
        while (!heap.empty()) {
            std::pop_heap(heap.begin(), heap.end());
            const Step step = heap.back();
            heap.pop_back();
            if (done[static_cast<std::size_t>(step.to)]) continue;
            const Vector3 before = turn(step.from), own = turn(step.to);
            const double angle = own.norm();
            if (angle > 1e-9 || before.norm() > kPi) {
                const Vector3 axis =
                    angle > 1e-9 ? Vector3(own / angle) : Vector3(before.normalized());
                const double turns = std::round((before.dot(axis) - angle) / (2 * kPi));
                if (turns != 0)
                    t.row(step.to).head<3>() = ((angle + 2 * kPi * turns) * axis).transpose();
            }
            leave(step.to);
        }
    }
}

void DeformationRepresentation::State::centre_pieces(
    Points& x, const std::vector<Eigen::RowVector3d>& wanted) const {
    std::vector<Eigen::RowVector3d> shift(centre.size(), Eigen::RowVector3d::Zero());
    for (Index v = 0; v < x.rows(); ++v) shift[component[v]] += x.row(v);
    for (std::size_t c = 0; c < shift.size(); ++c)
        shift[c] = wanted[c] - shift[c] / static_cast<double>(component_size[c]);
    for (Index v = 0; v < x.rows(); ++v) x.row(v) += shift[component[v]];
}

DeformationRepresentation::DeformationRepresentation(const TriMesh& template_mesh,
                                                     const Context& context)
    : state_(std::make_unique<State>()) {
    check_mesh(template_mesh, "the template");
    context.check_cancelled();
    context.require_memory(static_cast<std::size_t>(template_mesh.vertices.rows()) * 3000,
                           "a deformation representation");
    state_->mesh.vertices = template_mesh.vertices;
    state_->mesh.triangles = template_mesh.triangles;
    state_->build_rings();
    state_->walk();
    state_->factorise();
}

DeformationRepresentation::~DeformationRepresentation() = default;
Index DeformationRepresentation::num_vertices() const {
    return state_->mesh.vertices.rows();
}
const TriMesh& DeformationRepresentation::template_mesh() const {
    return state_->mesh;
}

Features DeformationRepresentation::gradients(const PointsRef& vertices,
                                              const Context& context) const {
    const State& s = *state_;
    const Index n = num_vertices();
    if (vertices.rows() != n)
        fail(Status::mismatch, "a face with %lld vertices for a template with %lld",
             static_cast<long long>(vertices.rows()), static_cast<long long>(n));
    for (Index v = 0; v < n; ++v)
        if (!vertices.row(v).allFinite())
            fail_at(Status::invalid_mesh, v, "vertex %lld of the face is not finite",
                    static_cast<long long>(v));
    const Points face_normals = triangle_normals(vertices, s.mesh.triangles);
    const Points normals = vertex_normals(vertices, s.mesh.triangles);
    Features t(n, kDeformationChannels);
    parallel_for(
        context, static_cast<std::size_t>(n), kChunk, [&](std::size_t begin, std::size_t end) {
            for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
                Matrix3 cross = s.identity_weight[v] * Matrix3::Identity();
                for (int p = s.ring_begin[v]; p < s.ring_begin[v + 1]; ++p) {
                    const Vector3 before = s.mesh.vertices.row(v) - s.mesh.vertices.row(s.ring[p]);
                    const Vector3 after = vertices.row(v) - vertices.row(s.ring[p]);
                    cross += s.weight[p] * after * before.transpose();
                }
                if (s.normal_weight[v] > 0) {
                    const double growth =
                        std::sqrt(ring_area(face_normals, s.incident, v)) / s.root_area[v];
                    cross += s.normal_weight[v] * growth * normals.row(v).transpose() *
                             s.unit_normals.row(v);
                }
                Eigen::Map<RowMatrix3>(&t.coeffRef(v, 0)) = cross * s.inverse_moment[v];
            }
        });
    // The smallest change that makes the inverse exact; once more, against the regularisation.
    const Points wanted = s.laplace_times(vertices);
    for (int pass = 0; pass < 3; ++pass) {
        context.check_cancelled();
        const Points missing = wanted - s.right_side(t);
        const Points dual = s.dual.solve(missing);
        if (!dual.allFinite())
            fail(Status::no_solution, "the deformation of the face is not finite");
        s.add_transposed(dual, t);
    }
    return t;
}

Points DeformationRepresentation::from_gradients(const Eigen::Ref<const Features>& gradients,
                                                 const Context& context) const {
    const State& s = *state_;
    const Index n = num_vertices();
    if (gradients.rows() != n || gradients.cols() != kDeformationChannels)
        fail(Status::mismatch, "%lld x %lld deformation features for a template with %lld vertices",
             static_cast<long long>(gradients.rows()), static_cast<long long>(gradients.cols()),
             static_cast<long long>(n));
    if (!gradients.allFinite())
        fail(Status::invalid_argument, "deformation features that are not finite");
    context.check_cancelled();
    Points right = s.right_side(gradients);
    for (Index v = 0; v < n; ++v)
        if (s.pinned[v]) right.row(v).setZero();
    Points x = s.laplace.solve(right);
    if (!x.allFinite()) fail(Status::no_solution, "the decoded face is not finite");
    s.centre_pieces(x, s.centre);
    return x;
}

Features DeformationRepresentation::encode(const PointsRef& vertices,
                                           const Context& context) const {
    const State& s = *state_;
    Features t = gradients(vertices, context);
    parallel_for(context, static_cast<std::size_t>(t.rows()), kChunk,
                 [&](std::size_t begin, std::size_t end) {
                     for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
                         Matrix3 rotation, stretch;
                         const Matrix3 gradient = Eigen::Map<const RowMatrix3>(&t.coeffRef(v, 0));
                         polar_decomposition(gradient, rotation, stretch);
                         t.row(v).head<3>() = rotation_logarithm(rotation).transpose();
                         t.row(v).tail<6>() << stretch(0, 0) - 1, stretch(1, 1) - 1,
                             stretch(2, 2) - 1, stretch(0, 1), stretch(0, 2), stretch(1, 2);
                     }
                 });
    s.unwind(t);
    return t;
}

Points DeformationRepresentation::decode(const Eigen::Ref<const Features>& features,
                                         const Context& context) const {
    if (features.cols() != kDeformationChannels)
        fail(Status::mismatch, "%lld channels instead of 9",
             static_cast<long long>(features.cols()));
    Features t(features.rows(), kDeformationChannels);
    parallel_for(context, static_cast<std::size_t>(t.rows()), kChunk,
                 [&](std::size_t begin, std::size_t end) {
                     for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
                         const auto f = features.row(v);
                         Matrix3 stretch;
                         stretch << f[3] + 1, f[6], f[7], f[6], f[4] + 1, f[8], f[7], f[8],
                             f[5] + 1;
                         Eigen::Map<RowMatrix3>(&t.coeffRef(v, 0)) =
                             rotation_exponential(Vector3(f[0], f[1], f[2])) * stretch;
                     }
                 });
    return from_gradients(t, context);
}

Points DeformationRepresentation::decode(const Eigen::Ref<const Features>& features,
                                         const std::vector<std::uint32_t>& anchors,
                                         const PointsRef& anchor_places,
                                         const Context& context) const {
    const State& s = *state_;
    if (static_cast<Index>(anchors.size()) != anchor_places.rows())
        fail(Status::mismatch, "%zu anchors with %lld places", anchors.size(),
             static_cast<long long>(anchor_places.rows()));
    for (const std::uint32_t anchor : anchors)
        if (anchor >= static_cast<std::uint64_t>(num_vertices()))
            fail(Status::invalid_argument, "anchor %u of a template with %lld vertices", anchor,
                 static_cast<long long>(num_vertices()));
    if (!anchor_places.allFinite()) fail(Status::invalid_argument, "an anchor that is not finite");
    Points x = decode(features, context);
    std::vector<Eigen::RowVector3d> shift(s.centre.size(), Eigen::RowVector3d::Zero());
    std::vector<int> count(s.centre.size(), 0);
    for (std::size_t a = 0; a < anchors.size(); ++a) {
        const int piece = s.component[anchors[a]];
        shift[piece] += anchor_places.row(static_cast<Index>(a)) - x.row(anchors[a]);
        ++count[piece];
    }
    for (Index v = 0; v < x.rows(); ++v)
        if (const int piece = s.component[v]; count[piece] > 0)
            x.row(v) += shift[piece] / count[piece];
    return x;
}

}  // namespace mien
