// Coefficients of models and bases, fields and maps through the C++ face and the C functions
// beneath it: each result against something that says what it must be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mien/mien.hpp>

namespace {

using namespace mien;

constexpr int kCells = 14;

std::vector<Position> bump(double height, double shift = 0) {
    std::vector<Position> points;
    for (int j = 0; j <= kCells; ++j)
        for (int i = 0; i <= kCells; ++i) {
            const double x = 5.0 * i - 35, y = 5.0 * j - 35;
            points.push_back({x, y, height * std::exp(-(x * x + y * y) / 400) + shift * x * y});
        }
    return points;
}
std::vector<Triangle> cells() {
    std::vector<Triangle> triangles;
    for (std::uint32_t j = 0; j < kCells; ++j)
        for (std::uint32_t i = 0; i < kCells; ++i) {
            const std::uint32_t a = j * (kCells + 1) + i, b = a + 1, c = a + kCells + 1, d = c + 1;
            triangles.push_back({a, b, d});
            triangles.push_back({a, d, c});
        }
    return triangles;
}
double distance(const Position& a, const Position& b) {
    return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}
double largest_difference(const Mesh& a, const Mesh& b) {
    const auto x = a.positions(), y = b.positions();
    double worst = x.size() == y.size() ? 0 : HUGE_VAL;
    for (std::size_t v = 0; v < x.size() && std::isfinite(worst); ++v)
        worst = std::max(worst, distance(x[v], y[v]));
    return worst;
}
template <typename Body>
mien_status status_of(Body&& body) {
    try {
        body();
    } catch (const Exception& e) {
        return e.status();
    }
    return MIEN_OK;
}

class Coefficients : public ::testing::Test {
  protected:
    Model model() const {
        ModelSettings settings;
        settings.kernel = MIEN_KERNEL_EUCLIDEAN_SE;
        settings.sigma_mm = 25;
        settings.num_modes = 60;
        return Model::build(session_, sheet_, settings);
    }
    Session session_{2};
    Mesh sheet_{session_, bump(10), cells()};
};

TEST_F(Coefficients, OfAModelMakeAFaceAndAreReadFromItAgain) {
    const Model model = this->model();
    std::vector<double> given(3 * model.scalar_modes() + model.vector_modes());
    for (std::size_t i = 0; i < given.size(); ++i) given[i] = std::sin(1.0 + 3.0 * double(i));
    const Mesh face = synthesize(session_, model, given);
    ModelFitSettings settings;
    settings.ridge_mm2 = 0;
    const std::vector<double> found = fit_model(session_, model, face, settings);
    ASSERT_EQ(found.size(), given.size());
    for (std::size_t i = 0; i < 30; ++i) EXPECT_NEAR(found[i], given[i], 1e-3) << i;
    EXPECT_LT(largest_difference(synthesize(session_, model, found), face), 1e-4);
    // None is the mean; the first ones alone leave the others at zero.
    EXPECT_LT(largest_difference(synthesize(session_, model, {}), model.mesh()), 1e-12);
    EXPECT_EQ(status_of([&] { synthesize(session_, model, {1, 2}); }), MIEN_E_MISMATCH);
    EXPECT_EQ(status_of([&] {
                  synthesize(session_, model, {1, NAN, 2});
              }),
              MIEN_E_INVALID_ARGUMENT);
}

TEST_F(Coefficients, OfOneModeMoveOneAxis) {
    const Model model = this->model();
    std::vector<double> one(9, 0.0);
    one[3 * 2 + 1] = 2;  // scalar mode 2, y
    const auto moved = synthesize(session_, model, one).positions(), rest = sheet_.positions();
    double most = 0;
    for (std::size_t v = 0; v < rest.size(); ++v) {
        EXPECT_EQ(moved[v][0], rest[v][0]);
        EXPECT_EQ(moved[v][2], rest[v][2]);
        most = std::max(most, std::abs(moved[v][1] - rest[v][1]));
    }
    EXPECT_GT(most, 0.1);
}

TEST_F(Coefficients, OfAFitHearRidgeWeightsAndNumbersOfModes) {
    const Model model = this->model();
    const Mesh target(session_, bump(16, 0.002), cells());
    const auto norm = [](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value * value;
        return std::sqrt(sum);
    };
    ModelFitSettings settings;
    const double loose = norm(fit_model(session_, model, target, settings));
    settings.ridge_mm2 = 50;
    EXPECT_LT(norm(fit_model(session_, model, target, settings)), loose);
    settings = {};
    settings.scalar_modes = 3;
    const std::vector<double> few = fit_model(session_, model, target, settings);
    for (std::size_t i = 9; i < few.size(); ++i) EXPECT_EQ(few[i], 0.0);
    settings = {};
    settings.weights.assign(sheet_.vertex_count(), 1.0);
    settings.weights[7] = 0;
    auto broken = bump(16, 0.002);
    broken[7] = {900, 900, 900};
    EXPECT_EQ(fit_model(session_, model, target, settings),
              fit_model(session_, model, Mesh(session_, broken, cells()), settings));
    settings.weights.resize(3);
    EXPECT_EQ(status_of([&] { fit_model(session_, model, target, settings); }), MIEN_E_MISMATCH);
}

TEST_F(Coefficients, OfARegistrationGiveItsFaceBackInTheModelsFrame) {
    const Model model = this->model();
    std::vector<double> given(3 * model.scalar_modes(), 0.0);
    given[0] = 1.5;
    given[5] = -1;
    const Registration kept(session_, synthesize(session_, model, given), {}, {}, {},
                            MIEN_QUALITY_GOOD);
    const std::vector<double> found = coefficients_of(session_, kept, model);
    for (std::size_t i = 0; i < 15; ++i) EXPECT_NEAR(found[i], given[i], 1e-3) << i;

    // A fit of a moved scan: what comes back lies in the model's frame, where the scan does not.
    auto away = bump(14);
    for (Position& p : away) p = {p[1] + 200, -p[0], p[2] + 30};
    RegisterOptions options;
    options.c.start = MIEN_START_POSE;
    options.c.iterations = 5;
    const double quarter[9] = {0, 1, 0, -1, 0, 0, 0, 0, 1}, away_mm[3] = {200, 0, 30};
    std::copy(quarter, quarter + 9, options.c.start_rotation);
    std::copy(away_mm, away_mm + 3, options.c.start_translation);
    const Registration fitted(session_, model, Mesh(session_, away, cells()), options);
    const Mesh face = synthesize(session_, model, coefficients_of(session_, fitted, model));
    const auto motion = fitted.motion();
    const auto there = fitted.mesh().positions(), here = face.positions();
    double sum = 0;
    for (std::size_t v = 0; v < here.size(); ++v) {
        Position moved{};
        for (std::size_t k = 0; k < 3; ++k)
            moved[k] = motion[4 * k] * here[v][0] + motion[4 * k + 1] * here[v][1] +
                       motion[4 * k + 2] * here[v][2] + motion[4 * k + 3];
        sum += distance(moved, there[v]);
    }
    EXPECT_LT(sum / double(here.size()), 0.5);
    ModelSettings other;
    other.num_modes = 30;
    const Model small = Model::build(
        session_, Mesh(session_, {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}}), other);
    EXPECT_EQ(status_of([&] { coefficients_of(session_, fitted, small); }), MIEN_E_MISMATCH);
}

TEST_F(Coefficients, OfAnyThreadCountAreTheSameBits) {
    const Session one(1), four(4);
    const Model model = this->model();
    const Mesh target(session_, bump(16, 0.002), cells());
    EXPECT_EQ(fit_model(one, model, target), fit_model(four, model, target));
    EXPECT_EQ(geodesic_distances(one, sheet_, {3, 100, 7}),
              geodesic_distances(four, sheet_, {3, 100, 7}));
}

TEST_F(Coefficients, GeodesicsAreTheNearestSourcesAndGoAroundHoles) {
    const Mesh flat(session_, bump(0), cells());
    const std::vector<std::uint32_t> sources{0, 7 * (kCells + 1) + 7};
    const auto field = geodesic_distances(session_, flat, sources);
    const auto places = flat.positions();
    for (std::size_t v = 0; v < field.size(); ++v) {
        const double straight = std::min(distance(places[v], places[sources[0]]),
                                         distance(places[v], places[sources[1]]));
        EXPECT_NEAR(field[v], straight, 0.05 * straight + 2.0) << v;
    }
    EXPECT_EQ(field[0], 0.0);
    EXPECT_EQ(field[sources[1]], 0.0);
    // A slit from one border to the middle: beside each other, and far along the surface.
    std::vector<Triangle> slit;
    for (const Triangle& t : cells()) {
        bool across = true;
        for (const std::uint32_t v : t) {
            const std::uint32_t i = v % (kCells + 1), j = v / (kCells + 1);
            across = across && (i == 7 || i == 8) && j < 8;
        }
        if (!across) slit.push_back(t);
    }
    const auto around = geodesic_distances(session_, Mesh(session_, bump(0), slit), {7});
    EXPECT_GT(around[8], 50);  // 5 mm away through the slit
    EXPECT_EQ(status_of([&] { geodesic_distances(session_, flat, {}); }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { geodesic_distances(session_, flat, {100000}); }),
              MIEN_E_INVALID_ARGUMENT);
}

TEST_F(Coefficients, GeodesicsOfAPieceWithoutSourceAreInfinite) {
    auto points = bump(10);
    auto triangles = cells();
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Position& corner : {Position{200, 0, 0}, Position{209, 0, 0}, Position{200, 9, 0}})
        points.push_back(corner);
    triangles.push_back({first, first + 1, first + 2});
    const auto field = geodesic_distances(session_, Mesh(session_, points, triangles), {0});
    for (std::size_t v = 0; v < field.size(); ++v) EXPECT_EQ(std::isinf(field[v]), v >= first) << v;
}

TEST_F(Coefficients, OfASpectralBasisAreItsVectorsProducts) {
    SpectralBasisOptions options;
    options.mode_count = 30;
    const SpectralBasis basis = SpectralBasis::build(session_, sheet_, options);
    const Mesh face(session_, bump(13, 0.001), cells());
    const auto rows = basis.project(session_, face, 20);
    ASSERT_EQ(rows.size(), 20u);
    const auto mass = basis.mass(), vector = basis.vector(6), again = basis.vector(7);
    const auto here = face.positions(), mean = basis.mean().positions();
    double norm = 0, mixed = 0;
    Position expected{};
    for (std::size_t v = 0; v < mass.size(); ++v) {
        norm += mass[v] * vector[v] * vector[v];
        mixed += mass[v] * vector[v] * again[v];
        for (std::size_t c = 0; c < 3; ++c)
            expected[c] += mass[v] * vector[v] * (here[v][c] - mean[v][c]);
    }
    EXPECT_NEAR(norm, 1, 1e-9);
    EXPECT_NEAR(mixed, 0, 1e-9);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rows[6][c], expected[c], 1e-9);
    EXPECT_EQ(status_of([&] { basis.vector(30); }), MIEN_E_INVALID_ARGUMENT);
}

TEST_F(Coefficients, OfASpectralBasisMakeTheLowBand) {
    SpectralBasisOptions options;
    options.mode_count = 30;
    const SpectralBasis basis = SpectralBasis::build(session_, sheet_, options);
    const Mesh face(session_, bump(13, 0.001), cells());
    const auto rows = basis.project(session_, face, 20);
    EXPECT_LT(largest_difference(basis.synthesize(session_, rows), basis.low(session_, face, 20)),
              1e-9);
    // A part that begins later is a band of its own.
    const std::vector<Position> tail(rows.begin() + 12, rows.end());
    const auto whole = basis.synthesize(session_, rows).positions();
    const auto low = basis.low(session_, face, 12).positions(), mean = basis.mean().positions();
    const auto band = basis.synthesize(session_, tail, 12).positions();
    for (std::size_t v = 0; v < whole.size(); ++v)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(low[v][c] + band[v][c] - mean[v][c], whole[v][c], 1e-9);
    EXPECT_EQ(basis.project(session_, face, 1000000).size(), 30u);
    EXPECT_EQ(status_of([&] { basis.synthesize(session_, rows, 11); }), MIEN_E_INVALID_ARGUMENT);
}

TEST_F(Coefficients, FieldsOfAMetricAddUpToIt) {
    auto points = bump(10);
    points[112][2] += 1;
    const Mesh other(session_, points, cells());
    for (const std::int32_t kind : {MIEN_METRIC_L1, MIEN_METRIC_L2, MIEN_METRIC_HAUSDORFF}) {
        const auto field = metric_field(session_, kind, sheet_, other);
        double sum = 0, most = 0;
        for (const double value : field) sum += value, most = std::max(most, value);
        const double value = metric(session_, kind, sheet_, other);
        if (kind == MIEN_METRIC_HAUSDORFF)
            EXPECT_LE(most, value);
        else
            EXPECT_NEAR(sum / double(field.size()), value, 1e-12);
        EXPECT_EQ(field[0], 0.0);
        EXPECT_GT(most, 0.5);
    }
    for (const std::int32_t kind : {MIEN_METRIC_DAME, MIEN_METRIC_FMPD}) {
        const auto field = metric_field(session_, kind, sheet_, other);
        EXPECT_GT(field[112], 0.001);
        EXPECT_EQ(field[0], 0.0);
        for (const double value : metric_field(session_, kind, sheet_, sheet_))
            EXPECT_EQ(value, 0.0);
    }
    const auto rough = roughness(session_, other);
    EXPECT_GT(rough[112], roughness(session_, sheet_)[112]);
    EXPECT_EQ(status_of([&] { metric_field(session_, 9, sheet_, other); }),
              MIEN_E_UNSUPPORTED_OPTION);
}

TEST_F(Coefficients, MapsOfAHierarchyAreWhatApplyApplies) {
    for (const Hierarchy& levels : {Hierarchy::quadric(session_, sheet_, 2, 3),
                                    Hierarchy::connectivity(session_, sheet_, 2, 2, 2)})
        for (const std::int32_t direction : {MIEN_MAP_DOWN, MIEN_MAP_UP}) {
            const Hierarchy::Map map = levels.map(2, direction);
            std::vector<double> values(static_cast<std::size_t>(map.column_count));
            for (std::size_t v = 0; v < values.size(); ++v) values[v] = std::cos(double(v));
            std::vector<double> product(static_cast<std::size_t>(map.row_count), 0.0),
                sums(product.size(), 0.0);
            for (std::size_t i = 0; i < map.rows.size(); ++i) {
                product[map.rows[i]] += map.values[i] * values[map.columns[i]];
                sums[map.rows[i]] += map.values[i];
            }
            const auto applied = levels.apply(2, direction, values, 1);
            ASSERT_EQ(applied.size(), product.size());
            for (std::size_t v = 0; v < product.size(); ++v) {
                EXPECT_NEAR(applied[v], product[v], 1e-12);
                EXPECT_NEAR(sums[v], 1, 1e-12);
            }
        }
    EXPECT_EQ(status_of([&] { Hierarchy::quadric(session_, sheet_, 1, 2).map(0, MIEN_MAP_UP); }),
              MIEN_E_INVALID_ARGUMENT);
}

TEST_F(Coefficients, TuningSearchesScalesAndLevelsToo) {
    const std::string path = ::testing::TempDir() + "coefficients_faces.safetensors";
    DatasetWriter writer(session_, sheet_, {"neutral"});
    writer.add(bump(12), 0, 0);
    writer.add(bump(9, 0.001), 1, 0);
    writer.save(session_, path);
    TuneSettings settings;
    settings.kernel = MIEN_KERNEL_EUCLIDEAN_SE;
    settings.sigmas_mm = {15, 30};
    settings.num_modes = 30;
    const std::string plain = tune_kernel(session_, sheet_, path, settings);
    settings.scales_mm = {1, 4};
    settings.level_counts = {1, 3};
    const std::string grid = tune_kernel(session_, sheet_, path, settings);
    const auto occurrences = [](const std::string& text, const std::string& part) {
        int count = 0;
        for (std::size_t at = text.find(part); at != std::string::npos;
             at = text.find(part, at + 1))
            ++count;
        return count;
    };
    EXPECT_EQ(occurrences(plain, "\"residuals_mm\""), 2);
    EXPECT_EQ(occurrences(grid, "\"residuals_mm\""), 8);
    EXPECT_EQ(occurrences(grid, "\"levels\":3,"), 4);
    settings.level_counts = {13};
    EXPECT_EQ(status_of([&] { tune_kernel(session_, sheet_, path, settings); }),
              MIEN_E_INVALID_ARGUMENT);
}

}  // namespace
