#include "expression/treated_readings.hpp"

#include <cmath>

#include "trained_study.hpp"

namespace mien {
namespace {

/// Subjects as they are, with a change of the person that looks like "frown".
struct Treated {
    TriMesh face;
    Points truth;  ///< neutral, with the treatment
    NeutralizeMeshOptions options;
    explicit Treated(int subject) {
        const test::Study& study = test::study();
        face.triangles = study.triangles;
        truth = study.neutral(subject) + study.bump(60, 110, 20, Vector3(0, -5, -3));
        face.vertices = truth;
        for (Index v = 0; v < truth.rows(); ++v)
            if ((truth.row(v) - study.neutral(subject).row(v)).norm() > 0.02)
                options.neutralize.treated.push_back(static_cast<std::uint32_t>(v));
    }
};

TEST(TreatedReadings, TreatmentLikeAnExpressionStaysAndBothReadingsAreTold) {
    const ExpressionModel& model = test::trained_model<8>();
    int told = 0;
    for (const int subject : {30, 31, 32, 33}) {
        const Treated treated(subject);
        const NeutralizationResult result =
            neutralize_mesh(Context(), model, treated.face, Vector(), treated.options);
        const TreatedReadings readings =
            read_treated_zone(Context(), model, treated.face, Vector(), treated.options, result);
        EXPECT_EQ(readings.treated.expression, "neutral") << subject;
        EXPECT_LT(readings.treated.removed_mm, 0.25 * readings.as_expression.removed_mm) << subject;
        EXPECT_LT(std::fabs(readings.treated.removed_ml),
                  0.25 * std::fabs(readings.as_expression.removed_ml))
            << subject;
        if (readings.differ) {
            ++told;
            EXPECT_EQ(readings.as_expression.expression, "frown") << subject;
            EXPECT_NE(treated_warning(readings).find("frown"), std::string::npos);
        }
    }
    EXPECT_GE(told, 3);
}

TEST(TreatedReadings, RealExpressionIsReadAlikeBothWays) {
    const ExpressionModel& model = test::trained_model<8>();
    Treated treated(34);
    treated.face.vertices = test::study().face(34, 1);  // far from the zone
    const NeutralizationResult result =
        neutralize_mesh(Context(), model, treated.face, Vector(), treated.options);
    const TreatedReadings readings =
        read_treated_zone(Context(), model, treated.face, Vector(), treated.options, result);
    EXPECT_EQ(readings.treated.expression, "open");
    EXPECT_EQ(readings.as_expression.expression, "open");
    EXPECT_FALSE(readings.differ);
    EXPECT_EQ(treated_warning(readings), "");
}

}  // namespace
}  // namespace mien
