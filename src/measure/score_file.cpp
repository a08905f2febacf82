// Score models as safetensors files, kind "mien-score-model".
#include <cmath>

#include "base/error.hpp"
#include "measure/score_features.hpp"
#include "measure/score_model.hpp"

namespace mien {
namespace {

Vector read_vector(const SafetensorsFile& file, const char* name, std::int64_t length) {
    const TensorView& view = file.tensor(name, DType::f64, {length});
    return Eigen::Map<const Vector>(static_cast<const double*>(view.data),
                                    static_cast<Index>(view.count));
}

Points read_points(const SafetensorsFile& file, const char* name, std::int64_t rows) {
    const TensorView& view = file.tensor(name, DType::f64, {rows, 3});
    return Eigen::Map<const Points>(static_cast<const double*>(view.data),
                                    static_cast<Index>(view.shape[0]), 3);
}

// Stored as columns, one after the other: shape [columns, rows].
Matrix read_columns(const SafetensorsFile& file, const char* name, std::int64_t columns,
                    std::int64_t rows) {
    const TensorView& view = file.tensor(name, DType::f64, {columns, rows});
    return Eigen::Map<const Matrix>(static_cast<const double*>(view.data),
                                    static_cast<Index>(view.shape[1]),
                                    static_cast<Index>(view.shape[0]));
}

}  // namespace

void save_score_model(const std::string& path, const ScoreModel& m, const Context& context) {
    const std::uint64_t v = static_cast<std::uint64_t>(m.mean_face.rows());
    const std::uint64_t p = static_cast<std::uint64_t>(m.feature_mean.size());
    const std::uint64_t a = static_cast<std::uint64_t>(m.num_components());
    const std::uint64_t c = static_cast<std::uint64_t>(m.cv_error.size());
    const std::vector<double> numbers{m.y_mean,
                                      m.rmse,
                                      m.q2,
                                      static_cast<double>(m.num_samples),
                                      m.curvature_radius_mm,
                                      m.lowest,
                                      m.highest,
                                      static_cast<double>(m.best_components),
                                      static_cast<double>(m.one_se_components)};
    std::vector<TensorToWrite> tensors{
        {"mean_face", DType::f64, {v, 3}, m.mean_face.data()},
        {"displacement_scale", DType::f64, {v}, m.displacement_scale.data()},
        {"curvature_scale", DType::f64, {v}, m.curvature_scale.data()},
        {"feature_mean", DType::f64, {p}, m.feature_mean.data()},
        {"rotations", DType::f64, {a, p}, m.rotations.data()},
        {"y_loadings", DType::f64, {a}, m.y_loadings.data()},
        {"score_squares", DType::f64, {a}, m.score_squares.data()},
        {"unit_displacement", DType::f64, {v, 3}, m.unit_displacement.data()},
        {"latent_pictures", DType::f64, {a, v}, m.latent_pictures.data()},
        {"cv_error", DType::f64, {c}, m.cv_error.data()},
        {"cv_standard_error", DType::f64, {c}, m.cv_standard_error.data()},
        {"numbers", DType::f64, {numbers.size()}, numbers.data()},
        {"triangles",
         DType::u32,
         {static_cast<std::uint64_t>(m.triangles.rows()), 3},
         m.triangles.data()},
    };
    if (!m.stable_zone.empty())
        tensors.push_back(
            {"stable_zone", DType::u32, {m.stable_zone.size()}, m.stable_zone.data()});
    if (m.shape_scale.size() != 0)
        tensors.push_back({"shape_scale",
                           DType::f64,
                           {static_cast<std::uint64_t>(kShapeFeatures)},
                           m.shape_scale.data()});
    write_safetensors(path, tensors, {{"kind", "mien-score-model"}, {"units", "mm"}}, context);
}

ScoreModel load_score_model(const std::string& path, const SafetensorsReadOptions& options,
                            const Context& context) {
    const SafetensorsFile file = SafetensorsFile::open(path, options, context);
    file.require_kind("mien-score-model");
    ScoreModel m;
    m.mean_face = read_points(file, "mean_face", -1);
    const std::int64_t v = m.mean_face.rows();
    m.displacement_scale = read_vector(file, "displacement_scale", v);
    m.curvature_scale = read_vector(file, "curvature_scale", v);
    const TensorView& triangles = file.tensor("triangles", DType::u32, {-1, 3});
    m.triangles = Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(triangles.data),
                                              static_cast<Index>(triangles.shape[0]), 3);
    if (v == 0 || m.triangles.rows() == 0 || static_cast<std::int64_t>(m.triangles.maxCoeff()) >= v)
        fail(Status::bad_format, "%.100s: no vertices, no triangles, or a vertex out of range",
             path.c_str());
    if (!(m.displacement_scale.minCoeff() >= 0) || !(m.curvature_scale.minCoeff() >= 0))
        fail(Status::bad_format, "%.100s: a negative feature scale", path.c_str());
    const Index used = (m.displacement_scale.array() > 0).count();
    if (file.has("shape_scale")) m.shape_scale = read_vector(file, "shape_scale", kShapeFeatures);
    const std::int64_t p =
        feature_count({m.displacement_scale, m.curvature_scale, 0.0, m.shape_scale});
    m.feature_mean = read_vector(file, "feature_mean", p);
    m.rotations = read_columns(file, "rotations", -1, p);
    const std::int64_t a = m.rotations.cols();
    m.y_loadings = read_vector(file, "y_loadings", a);
    m.score_squares = read_vector(file, "score_squares", a);
    m.unit_displacement = read_points(file, "unit_displacement", v);
    m.latent_pictures = read_columns(file, "latent_pictures", a, v);
    m.cv_error = read_vector(file, "cv_error", -1);
    m.cv_standard_error = read_vector(file, "cv_standard_error", m.cv_error.size());
    const Vector numbers = read_vector(file, "numbers", 9);
    m.y_mean = numbers[0];
    m.rmse = numbers[1];
    m.q2 = numbers[2];
    m.num_samples = static_cast<Index>(numbers[3]);
    m.curvature_radius_mm = numbers[4];
    m.lowest = numbers[5];
    m.highest = numbers[6];
    m.best_components = static_cast<int>(numbers[7]);
    m.one_se_components = static_cast<int>(numbers[8]);
    if (a < 1 || !(m.score_squares.minCoeff() > 0) || !(numbers[3] >= 2 && numbers[3] < 1e9) ||
        !(m.rmse >= 0) || !(m.curvature_radius_mm > 0) || used == 0)
        fail(Status::bad_format, "%.100s: not a usable score model; train it again", path.c_str());
    if (file.has("stable_zone")) {
        const TensorView& zone = file.tensor("stable_zone", DType::u32, {-1});
        const auto* data = static_cast<const std::uint32_t*>(zone.data);
        m.stable_zone.assign(data, data + zone.count);
        for (std::uint32_t vertex : m.stable_zone)
            if (static_cast<std::int64_t>(vertex) >= v)
                fail(Status::bad_format, "%.100s: the stable zone names vertex %u of %lld",
                     path.c_str(), vertex, static_cast<long long>(v));
    }
    return m;
}

}  // namespace mien
