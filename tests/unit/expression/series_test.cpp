#include "expression/series.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "expression/training.hpp"
#include "trained_study.hpp"

namespace mien {
namespace {

using test::mean_distance;
using test::study;
using test::trained_model;

TEST(Series, SharesOneIdentityAndBeatsEachScanAlone) {
    double alone = 0, together = 0;
    for (int subject = 60; subject < 68; ++subject) {
        std::vector<SeriesScan> scans;
        for (int expression = 1; expression < 5; ++expression) {
            scans.push_back({study().face(subject, expression), Vector()});
            alone += 0.25 * mean_distance(
                                neutralize(Context(), trained_model<8>(), scans.back().vertices, Vector(), {})
                                    .neutral_vertices,
                                study().neutral(subject));
        }
        const SeriesResult result = neutralize_series(Context(), trained_model<8>(), scans, {});
        together += mean_distance(result.identity_vertices, study().neutral(subject));
        ASSERT_EQ(result.neutral_vertices.size(), 4u);
        ASSERT_EQ(result.components.size(), 4u);
    }
    EXPECT_LT(together, 0.8 * alone);
}

TEST(Series, WeightsOfOneEqualNoWeights) {
    std::vector<SeriesScan> plain, weighted;
    for (int expression = 1; expression < 4; ++expression) {
        plain.push_back({study().face(61, expression), Vector()});
        weighted.push_back({study().face(61, expression), Vector::Ones(study().rest.rows())});
    }
    const SeriesResult a = neutralize_series(Context(), trained_model<8>(), plain, {});
    const SeriesResult b = neutralize_series(Context(), trained_model<8>(), weighted, {});
    EXPECT_LT(mean_distance(a.identity_vertices, b.identity_vertices), 1e-3);
}

TEST(Series, AChangeInTheTreatedZoneIsKept) {
    const Points before = study().face(62, 2);
    // A swelling that resembles an expression: where "open" moves the face.
    const Points swelling = study().bump(60, 20, 18, Vector3(0, -6, 2));
    std::vector<SeriesScan> scans = {{before, Vector()}, {study().face(62, 3), Vector()},
                                     {study().neutral(62) + swelling, Vector()}};
    SeriesOptions options;
    const SeriesResult plain = neutralize_series(Context(), trained_model<8>(), scans, options);
    for (Index i = 0; i < study().rest.rows(); ++i)
        if (swelling.row(i).norm() > 0.3)
            options.changing_zone.push_back(static_cast<std::uint32_t>(i));
    const SeriesResult kept = neutralize_series(Context(), trained_model<8>(), scans, options);
    const Points truth = study().neutral(62) + swelling;
    EXPECT_LT(mean_distance(kept.neutral_vertices[2], truth),
              0.5 * mean_distance(plain.neutral_vertices[2], truth) + 0.02);
}

TEST(Series, RefusesNothingAndFitsWithoutAPrior) {
    EXPECT_THROW(neutralize_series(Context(), trained_model<8>(), {}, {}), Error);
    SeriesOptions options;
    options.method = FitMethod::exact;
    EXPECT_THROW(neutralize_series(Context(), trained_model<8>(), {{study().face(60, 1), Vector()}}, options), Error);
}

}  // namespace
}  // namespace mien
