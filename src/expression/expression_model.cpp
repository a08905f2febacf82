#include "expression/expression_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <Eigen/Cholesky>

#include "base/error.hpp"
#include "base/json.hpp"
#include "base/sha256.hpp"
#include "expression/fit.hpp"

namespace mien {
namespace {

constexpr const char* kKind = "mien-expression-model";
constexpr std::size_t kMostIntensities = 16;
/// Metadata that the file format itself owns; the rest is the model's `info`.
const char* const kOwnKeys[] = {"kind",    "format",  "units",           "sha256",
                                "digest",  "creator", "component_names", "expression_names",
                                "topology"};

const TensorView& read_tensor(const SafetensorsFile& file, const char* name, DType dtype,
                              const std::vector<std::int64_t>& shape) {
    return file.tensor(name, dtype, shape);
}

void check_positive(const Vector& values, const char* what) {
    for (Index k = 0; k < values.size(); ++k)
        if (!(values[k] > 0.0) || !std::isfinite(values[k]))
            fail_at(Status::corrupt, k, "%s %lld of the expression model is not positive", what,
                    static_cast<long long>(k));
}

void read_components(const SafetensorsFile& file, ExpressionModel& model) {
    const Index q = model.num_expression_modes();
    const std::vector<std::string> names =
        parse_json_string_list(file.metadata("component_names"), "component_names");
    const Index count = static_cast<Index>(names.size());
    const auto doubles = [&](const char* name, const std::vector<std::int64_t>& shape) {
        return static_cast<const double*>(read_tensor(file, name, DType::f64, shape).data);
    };
    const double* weights = doubles("component_weights", {count});
    const double* means = doubles("component_means", {count, q});
    const double* covariances = doubles("component_covariances", {count, q, q});
    const double* follows = nullptr;  // files of before 0.2 have none
    Index directions = 0;
    if (file.has("component_follows")) {
        const TensorView& view = read_tensor(file, "component_follows", DType::f64, {count, -1, q});
        follows = static_cast<const double*>(view.data);
        directions = static_cast<Index>(view.shape[1]);
    }
    for (Index k = 0; k < count; ++k) {
        ExpressionComponent component;
        component.name = names[static_cast<std::size_t>(k)];
        component.weight = weights[k];
        component.mean = Eigen::Map<const Vector>(means + k * q, q);
        component.covariance = Eigen::Map<const Matrix>(covariances + k * q * q, q, q);
        if (follows != nullptr)
            component.follows =
                Eigen::Map<const Matrix>(follows + k * directions * q, q, directions);
        model.components.push_back(std::move(component));
    }
}

std::shared_ptr<const FitPlan> make_plan(const ExpressionModel& model) {
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    auto plan = std::make_shared<FitPlan>();
    const Matrix gram = model.spill.pull_gram(model.gram);
    plan->expression_gram = gram.bottomRightCorner(q, q);
    const Vector variances = model.expression_deviations.array().square();
    plan->map = plan_part(model, gram, model.map_noise_mm2,
                          precision_given_person(p, variances.cwiseInverse().asDiagonal(), {}),
                          model.identity_precision(), Vector::Zero(q), 0.0);
    for (const ExpressionComponent& component : model.components) {
        if (component.mean.size() != q || component.covariance.rows() != q ||
            component.covariance.cols() != q || !component.mean.allFinite() ||
            !component.covariance.allFinite() || !(component.weight > 0.0) ||
            !std::isfinite(component.weight) ||
            (component.follows.size() != 0 &&
             (component.follows.rows() != q || component.follows.cols() > p ||
              !component.follows.allFinite())))
            fail(Status::corrupt, "the component '%s' of the expression model is damaged",
                 shown_name(component.name).c_str());
    }
    plan->components = component_parts(model, gram, model.mixture_noise_mm2);
    return plan;
}

}  // namespace

std::string topology_hash(Index num_vertices, const TrianglesRef& triangles) {
    Sha256 hash;
    const std::int64_t count = num_vertices;
    hash.update(reinterpret_cast<const char*>(&count), sizeof count);
    for (Index row = 0; row < triangles.rows(); ++row) {
        const std::uint32_t corners[3] = {triangles(row, 0), triangles(row, 1), triangles(row, 2)};
        hash.update(reinterpret_cast<const char*>(corners), sizeof corners);
    }
    return hash.hex_digest().substr(0, 16);
}

Matrix ExpressionModel::identity_precision() const {
    if (identity_covariance.size() == 0)
        return identity_deviations.array().square().inverse().matrix().asDiagonal();
    const Eigen::LLT<Matrix> factor(identity_covariance);
    if (factor.info() != Eigen::Success)
        fail(Status::corrupt,
             "the covariance of the expression model's identity is not positive definite");
    const Matrix inverse =
        factor.solve(Matrix::Identity(identity_covariance.rows(), identity_covariance.cols()));
    return 0.5 * (inverse + inverse.transpose());
}

void put_people(ExpressionModel& model, const PeopleLevels& levels) {
    const Index people = model.num_people_modes(), q = model.num_expression_modes();
    auto part = std::make_shared<ExpressionModel>(model);
    part->identity_modes.cols = people;
    part->identity_deviations.conservativeResize(people);
    part->identity_covariance.resize(0, 0);
    part->smooth_modes = 0;
    part->gram.resize(people + q, people + q);
    part->gram << model.gram.topLeftCorner(people, people), model.gram.topRightCorner(people, q),
        model.gram.bottomLeftCorner(q, people), model.gram.bottomRightCorner(q, q);
    if (!model.spill.empty()) {
        part->spill.identity = model.spill.identity.leftCols(people);
        part->spill.expression = model.spill.expression.topRows(people);
    }
    part->map_noise_mm2 = levels.map_noise_mm2;
    part->mixture_noise_mm2 = levels.mixture_noise_mm2;
    part->expected_residual_mm = levels.residual_mm;
    finish_expression_model(*part);
    model.people = std::move(part);
}

void finish_expression_model(ExpressionModel& model) {
    const Index n = model.num_vertices(), p = model.num_identity_modes();
    const Index q = model.num_expression_modes();
    if (n < 1 || p < 1 || q < 1)
        fail(Status::corrupt, "the expression model is empty: %lld vertices, %lld + %lld modes",
             static_cast<long long>(n), static_cast<long long>(p), static_cast<long long>(q));
    if (model.identity_modes.rows != 3 * n || model.expression_modes.rows != 3 * n ||
        model.identity_deviations.size() != p || model.expression_deviations.size() != q ||
        model.gram.rows() != p + q || model.gram.cols() != p + q)
        fail(Status::corrupt, "the parts of the expression model have different sizes");
    if (!model.spill.empty() &&
        (model.spill.identity.rows() != q || model.spill.identity.cols() != p ||
         model.spill.expression.rows() != p || model.spill.expression.cols() != q ||
         !model.spill.identity.allFinite() || !model.spill.expression.allFinite()))
        fail(Status::corrupt, "the spill between the expression model's modes is damaged");
    if (model.triangles.size() != 0 && model.triangles.maxCoeff() >= n)
        fail(Status::corrupt,
             "a triangle of the expression model names a vertex that is not there");
    for (std::uint32_t vertex : model.stable_vertices)
        if (vertex >= static_cast<std::uint64_t>(n))
            fail(Status::corrupt, "the expression model's stable zone names vertex %u of %lld",
                 vertex, static_cast<long long>(n));
    check_positive(Eigen::Map<const Vector>(model.intensities.data(),
                                            static_cast<Index>(model.intensities.size())),
                   "intensity");
    if (model.intensities.empty() || model.intensities.size() > kMostIntensities)
        fail(Status::corrupt, "the expression model has %zu intensities; 1 to %zu are allowed",
             model.intensities.size(), kMostIntensities);
    check_positive(model.identity_deviations, "identity deviation");
    if (model.smooth_modes < 0 || model.smooth_modes >= p)
        fail(Status::corrupt, "%lld of the expression model's %lld identity modes are smooth ones",
             static_cast<long long>(model.smooth_modes), static_cast<long long>(p));
    if (model.identity_covariance.size() != 0 &&
        (model.identity_covariance.rows() != p || model.identity_covariance.cols() != p ||
         !model.identity_covariance.allFinite()))
        fail(Status::corrupt, "the covariance of the expression model's identity is damaged");
    check_positive(model.expression_deviations, "expression deviation");
    if (!(model.expected_residual_mm >= 0.0) || !std::isfinite(model.expected_residual_mm))
        fail(Status::corrupt, "the expression model's expected residual is damaged");
    check_positive(Vector::Constant(1, model.map_noise_mm2), "map noise");
    check_positive(Vector::Constant(1, model.mixture_noise_mm2), "mixture noise");
    if (!model.gram.allFinite() || !model.mean.allFinite())
        fail(Status::corrupt, "the expression model holds a value that is not finite");

    model.plan = make_plan(model);
}

std::shared_ptr<const ExpressionModel> load_expression_model(const std::string& path,
                                                             const SafetensorsReadOptions& options,
                                                             const Context& context) {
    return read_expression_model(SafetensorsFile::open(path, options, context));
}

std::shared_ptr<const ExpressionModel> read_expression_model(const SafetensorsFile& file) {
    file.require_kind(kKind);
    auto model = std::make_shared<ExpressionModel>();

    const TensorView& mean = read_tensor(file, "mean", DType::f64, {-1, 3});
    const Index n = static_cast<Index>(mean.shape[0]);
    model->mean = Eigen::Map<const Points>(static_cast<const double*>(mean.data), n, 3);
    const TensorView& triangles = read_tensor(file, "triangles", DType::u32, {-1, 3});
    model->triangles =
        Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(triangles.data),
                                    static_cast<Index>(triangles.shape[0]), 3);
    auto modes = [&](const char* name) {
        const TensorView& view = read_tensor(file, name, DType::f32, {-1, n, 3});
        return ModesView{static_cast<const float*>(view.data), 3 * n,
                         static_cast<Index>(view.shape[0])};
    };
    model->identity_modes = modes("identity_modes");
    model->expression_modes = modes("expression_modes");
    const Index p = model->num_identity_modes(), q = model->num_expression_modes();
    auto vector = [&](const char* name, Index size) {
        const TensorView& view = read_tensor(file, name, DType::f64, {size});
        return Vector(Eigen::Map<const Vector>(static_cast<const double*>(view.data), size));
    };
    model->identity_deviations = vector("identity_deviations", p);
    model->expression_deviations = vector("expression_deviations", q);
    const Vector noise = vector("noise_mm2", 2);
    model->map_noise_mm2 = noise[0];
    model->mixture_noise_mm2 = noise[1];
    const TensorView& gram = read_tensor(file, "gram", DType::f64, {p + q, p + q});
    model->gram = Eigen::Map<const Matrix>(static_cast<const double*>(gram.data), p + q, p + q);

    auto matrix = [&](const char* name, Index rows, Index cols) {
        const TensorView& view = read_tensor(file, name, DType::f64, {cols, rows});
        return Matrix(Eigen::Map<const Matrix>(static_cast<const double*>(view.data), rows, cols));
    };
    if (file.has("identity_spill")) {
        model->spill.identity = matrix("identity_spill", q, p);
        model->spill.expression = matrix("expression_spill", p, q);
    }
    Vector people;
    if (file.has("identity_covariance")) {
        model->identity_covariance = matrix("identity_covariance", p, p);
        const TensorView& view = read_tensor(file, "smooth_modes", DType::i32, {1});
        model->smooth_modes = *static_cast<const std::int32_t*>(view.data);
        people = vector("people_levels", 3);
    }
    if (file.has("expected_residual_mm"))
        model->expected_residual_mm = vector("expected_residual_mm", 1)[0];
    if (file.has("stable_vertices")) {
        const TensorView& view = read_tensor(file, "stable_vertices", DType::u32, {-1});
        const auto* first = static_cast<const std::uint32_t*>(view.data);
        model->stable_vertices.assign(first, first + view.count);
    }
    read_components(file, *model);
    if (file.has("expression_intensities")) {
        const TensorView& view = read_tensor(file, "expression_intensities", DType::f64, {-1});
        const auto* first = static_cast<const double*>(view.data);
        model->intensities.assign(first, first + view.count);
    }
    model->expression_names =
        parse_json_string_list(file.metadata("expression_names"), "expression_names");
    model->info = file.metadata();
    for (const char* key : kOwnKeys) model->info.erase(key);
    if (!file.warning().empty()) model->info[kFileWarning] = file.warning();
    model->storage = file.storage();
    finish_expression_model(*model);
    if (model->smooth_modes > 0) put_people(*model, {people[0], people[1], people[2]});
    return model;
}

void save_expression_model(const std::string& path, const ExpressionModel& model,
                           const Context& context) {
    const std::uint64_t n = static_cast<std::uint64_t>(model.num_vertices());
    const std::uint64_t p = static_cast<std::uint64_t>(model.num_identity_modes());
    const std::uint64_t q = static_cast<std::uint64_t>(model.num_expression_modes());
    const std::uint64_t count = model.components.size();
    const Vector noise = (Vector(2) << model.map_noise_mm2, model.mixture_noise_mm2).finished();
    Vector weights(static_cast<Index>(count));
    std::vector<double> means, covariances, follows;
    std::vector<std::string> names;
    Index directions = 0;  // components without any are written as zeros beside others
    for (const ExpressionComponent& component : model.components)
        directions = std::max(directions, component.follows.cols());
    for (std::size_t k = 0; k < model.components.size(); ++k) {
        const ExpressionComponent& component = model.components[k];
        names.push_back(component.name);
        weights[static_cast<Index>(k)] = component.weight;
        means.insert(means.end(), component.mean.data(),
                     component.mean.data() + component.mean.size());
        covariances.insert(covariances.end(), component.covariance.data(),
                           component.covariance.data() + component.covariance.size());
        Matrix own = Matrix::Zero(model.num_expression_modes(), directions);
        if (component.follows.cols() > 0)
            own.leftCols(component.follows.cols()) = component.follows;
        follows.insert(follows.end(), own.data(), own.data() + own.size());
    }
    std::map<std::string, std::string> metadata = model.info;
    metadata.erase(kFileWarning);  // the new file is a better one
    metadata["kind"] = kKind;
    metadata["units"] = "millimetres";
    metadata["component_names"] = json_string_list(names);
    metadata["expression_names"] = json_string_list(model.expression_names);
    metadata["topology"] = topology_hash(model.num_vertices(), model.triangles);
    std::vector<TensorToWrite> tensors = {
        {"mean", DType::f64, {n, 3}, model.mean.data()},
        {"identity_deviations", DType::f64, {p}, model.identity_deviations.data()},
        {"expression_deviations", DType::f64, {q}, model.expression_deviations.data()},
        {"noise_mm2", DType::f64, {2}, noise.data()},
        {"expected_residual_mm", DType::f64, {1}, &model.expected_residual_mm},
        {"gram", DType::f64, {p + q, p + q}, model.gram.data()},
        {"component_weights", DType::f64, {count}, weights.data()},
        {"component_means", DType::f64, {count, q}, means.data()},
        {"component_covariances", DType::f64, {count, q, q}, covariances.data()},
        {"identity_modes", DType::f32, {p, n, 3}, model.identity_modes.data},
        {"expression_modes", DType::f32, {q, n, 3}, model.expression_modes.data},
        {"triangles",
         DType::u32,
         {static_cast<std::uint64_t>(model.triangles.rows()), 3},
         model.triangles.data()}};
    if (!model.spill.empty()) {
        tensors.push_back({"identity_spill", DType::f64, {p, q}, model.spill.identity.data()});
        tensors.push_back({"expression_spill", DType::f64, {q, p}, model.spill.expression.data()});
    }
    const auto smooth_modes = static_cast<std::int32_t>(model.smooth_modes);
    const ExpressionModel& people = people_of(model);
    const Vector3 people_levels(people.map_noise_mm2, people.mixture_noise_mm2,
                                people.expected_residual_mm);
    if (model.identity_covariance.size() != 0) {
        tensors.push_back(
            {"identity_covariance", DType::f64, {p, p}, model.identity_covariance.data()});
        tensors.push_back({"smooth_modes", DType::i32, {1}, &smooth_modes});
        tensors.push_back({"people_levels", DType::f64, {3}, people_levels.data()});
    }
    tensors.push_back({"expression_intensities",
                       DType::f64,
                       {model.intensities.size()},
                       model.intensities.data()});
    if (directions > 0)
        tensors.push_back({"component_follows",
                           DType::f64,
                           {count, static_cast<std::uint64_t>(directions), q},
                           follows.data()});
    if (!model.stable_vertices.empty())
        tensors.push_back({"stable_vertices",
                           DType::u32,
                           {model.stable_vertices.size()},
                           model.stable_vertices.data()});
    write_safetensors(path, tensors, std::move(metadata), context);
}

}  // namespace mien
