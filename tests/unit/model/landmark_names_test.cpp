// Which of a model's landmarks the names of a file mean.
#include "model/landmark_names.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace {

using namespace mien;

constexpr int kParts[] = {17, 5, 5, 4, 5, 6, 6, 12, 8};
constexpr const char* kNames[] = {"jaw_",         "brow_right_",  "brow_left_",
                                  "nose_bridge_", "nose_base_",   "eye_right_",
                                  "eye_left_",    "mouth_outer_", "mouth_inner_"};

/// A model of nothing but the 68 landmarks, each at a place of its own.
DeformationModel scheme_model() {
    DeformationModel model;
    model.template_mesh.vertices.resize(68, 3);
    std::uint32_t v = 0;
    for (int part = 0; part < 9; ++part)
        for (int i = 0; i < kParts[part]; ++i, ++v) {
            const bool padded = kParts[part] > 10 && i < 10;
            model.landmarks.push_back(
                {kNames[part] + std::string(padded ? "0" : "") + std::to_string(i), v});
            model.template_mesh.vertices.row(v) << 40 * std::sin(1.7 * v), 50 * std::cos(2.3 * v),
                30 * std::sin(0.9 * v + 1);
        }
    return model;
}

std::vector<Mark> marks_of(const std::vector<std::string>& names) {
    std::vector<Mark> marks;
    for (const std::string& name : names) marks.push_back({name, Mark::Where::not_picked, {}, 0});
    return marks;
}

/// Marks with these numbers as names, at the template's places of the given landmarks.
std::vector<Mark> numbered(const DeformationModel& model, int first, int begin, int end) {
    std::vector<Mark> marks;
    for (int k = begin; k < end; ++k)
        marks.push_back({std::to_string(k + first), Mark::Where::place,
                         3 * model.template_mesh.vertices.row(k).transpose() + Vector3(5, 6, 7),
                         0});
    return marks;
}

TEST(LandmarkNames, CaseSeparatorsAndZerosDoNotCount) {
    const DeformationModel model = scheme_model();
    const NameMatch match = match_landmark_names(
        model, marks_of({"JAW_00", "Jaw-1", "mouth outer 3", "MouthOuter10", "chin"}));
    EXPECT_EQ(match.landmark, (std::vector<int>{0, 1, 51, 58, -1}));
    EXPECT_EQ(match.scheme, "names");
    EXPECT_EQ(match.matched, 4u);
}

TEST(LandmarkNames, IbugNumbersAreReadFromOneAndFromZero) {
    const DeformationModel model = scheme_model();
    const NameMatch one = match_landmark_names(model, numbered(model, 1, 0, 68));
    EXPECT_EQ(one.scheme, "iBUG-68 from 1");
    EXPECT_EQ(one.landmark[67], 67);
    const NameMatch zero = match_landmark_names(model, numbered(model, 0, 0, 68));
    EXPECT_EQ(zero.scheme, "iBUG-68 from 0");
    EXPECT_EQ(zero.landmark[0], 0);
    // Neither 0 nor 68 among them: the places tell.
    EXPECT_EQ(match_landmark_names(model, numbered(model, 1, 17, 60)).scheme, "iBUG-68 from 1");
    EXPECT_EQ(match_landmark_names(model, numbered(model, 0, 17, 60)).scheme, "iBUG-68 from 0");
}

TEST(LandmarkNames, NumbersThatFitTwoSchemesAreRefused) {
    const DeformationModel model = scheme_model();
    std::vector<Mark> marks = numbered(model, 0, 1, 40);
    for (Mark& mark : marks) mark.where = Mark::Where::not_picked;
    EXPECT_THROW(match_landmark_names(model, marks), Error);
}

TEST(LandmarkNames, MediaPipeGivesThoseThatHaveACounterpart) {
    const DeformationModel model = scheme_model();
    std::vector<std::string> names;
    for (int k = 0; k < 468; ++k) names.push_back(std::to_string(k));
    const NameMatch match = match_landmark_names(model, marks_of(names));
    EXPECT_EQ(match.scheme, "MediaPipe");
    EXPECT_EQ(match.matched, 52u);
    EXPECT_EQ(match.landmark[33], 36);   // outer corner of the right eye
    EXPECT_EQ(match.landmark[263], 45);  // and of the left
    EXPECT_EQ(match.landmark[152], 8);   // chin
    EXPECT_EQ(match.landmark[234], -1);  // outline of the picture
}

TEST(LandmarkNames, NoKnownNameIsAnErrorWithExamples) {
    const DeformationModel model = scheme_model();
    const std::vector<Mark> marks = marks_of({"P1", "P2"});
    const NameMatch match = match_landmark_names(model, marks);
    EXPECT_EQ(match.matched, 0u);
    try {
        require_known_landmark(model, match, marks);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::not_found);
        EXPECT_NE(std::string(error.what()).find("'jaw_00'"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("'P1'"), std::string::npos) << error.what();
    }
}

TEST(LandmarkNames, TwoNamesForOneLandmarkAreRefused) {
    const DeformationModel model = scheme_model();
    EXPECT_THROW(match_landmark_names(model, marks_of({"jaw_01", "JAW-1"})), Error);
}

}  // namespace
