// Landmark and zone lists, mesh tools and the template check through the shared library.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "handles.hpp"
#include "sheets.hpp"

namespace {

using mien_test::fresh_error;
using mien_test::positions_of;
using mien_test::Session;
using mien_test::temporary_path;

/// A sheet of 12 x 12 vertices, 110 mm wide, bulging towards +z.
mien::Mesh sheet(const mien::Session& session) {
    std::vector<mien::Position> positions;
    std::vector<mien::Triangle> triangles;
    for (std::uint32_t y = 0; y < 12; ++y)
        for (std::uint32_t x = 0; x < 12; ++x) {
            const double u = 10.0 * x - 55, v = 10.0 * y - 55;
            positions.push_back({{u, v, -(u * u + v * v) / 80}});
            if (x == 11 || y == 11) continue;
            const std::uint32_t a = 12 * y + x;
            triangles.push_back({{a, a + 1, a + 13}});
            triangles.push_back({{a, a + 13, a + 12}});
        }
    return mien::Mesh(session, positions, triangles);
}

mien::Model small_model(const mien::Session& session) {
    mien::ModelSettings settings;
    settings.kernel = MIEN_KERNEL_EUCLIDEAN_SE;
    settings.num_modes = 30;
    settings.landmarks = {{"nose", 66}, {"Chin", 5}};
    settings.zones = {{"cheek", {1, 2, 3}}, {"brow", {}}};
    return mien::Model::build(session, sheet(session), settings);
}

TEST(Landmarks, OfAModelAreReadBackWithNamesAndVertices) {
    const mien::Session session;
    const mien::Model model = small_model(session);
    const mien::Landmarks landmarks = mien::Landmarks::of(model);
    ASSERT_EQ(landmarks.size(), 2u);
    EXPECT_EQ(landmarks[0].name, "nose");
    EXPECT_EQ(landmarks[0].vertex, 66u);
    EXPECT_EQ(landmarks[1].where, MIEN_MARK_VERTEX);
    const mien::Zones zones = mien::Zones::of(model);
    ASSERT_EQ(zones.size(), 2u);
    EXPECT_EQ(zones[0].vertices, (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_TRUE(zones[1].vertices.empty());
    const mien::LandmarkMark on = landmarks.on(model.mesh())[0];
    EXPECT_EQ(on.where, MIEN_MARK_PLACE);
    EXPECT_EQ(on.position, model.mesh().positions()[66]);
}

TEST(Landmarks, OfAFileAreMatchedAndSavedAsAnotherKind) {
    const mien::Session session;
    const mien::Model model = small_model(session);
    const std::string path = temporary_path("marks.csv");
    std::ofstream(path) << "name,x,y,z\nNOSE,1,2,3\nchin,,,\ntail,4,5,6\n";
    const mien::Landmarks read(session, path);
    EXPECT_EQ(read.size(), 3u);
    EXPECT_EQ(read.picked_count(), 2u);
    const mien::Landmarks matched = read.match(model);
    ASSERT_EQ(matched.size(), 2u);
    EXPECT_EQ(matched[0].name, "nose");
    EXPECT_EQ(matched[1].where, MIEN_MARK_NOT_PICKED);
    EXPECT_NE(matched.json().find("\"unknown\":[\"tail\"]"), std::string::npos) << matched.json();
    const std::string saved = temporary_path("marks.mrk.json");
    matched.save(session, saved);
    const mien::Landmarks back(session, saved);
    EXPECT_EQ(back[0].position, (mien::Position{{1, 2, 3}}));
    EXPECT_EQ(back[1].where, MIEN_MARK_NOT_PICKED);
}

TEST(Zones, OfAHostAreSavedAndReadBack) {
    const mien::Session session;
    const std::uint32_t lips[] = {5, 2, 9}, brow[] = {7};
    const mien_zone zones[] = {{"lips", lips, 3}, {"brow", brow, 1}};
    mien_zones *made = nullptr, *read = nullptr;
    ASSERT_EQ(MIEN_OK, mien_zones_create(zones, 2, &made, nullptr));
    mien_zones_retain(made);
    mien_zones_release(made);
    const std::string path = temporary_path("zones.json");
    ASSERT_EQ(MIEN_OK, mien_zones_save(session.get(), made, path.c_str(), nullptr));
    ASSERT_EQ(MIEN_OK, mien_zones_load(session.get(), path.c_str(), &read, nullptr));
    for (const mien_zones* list : {made, read}) {
        std::uint64_t count = 0;
        EXPECT_EQ(MIEN_OK, mien_zones_get_count(list, &count, nullptr));
        EXPECT_EQ(2u, count);
        char name[8];
        EXPECT_EQ(MIEN_OK, mien_zones_get_name(list, 0, name, sizeof name, &count, nullptr));
        EXPECT_STREQ("lips", name);
        std::uint32_t vertices[3] = {};
        EXPECT_EQ(MIEN_OK, mien_zones_get_vertices(list, 0, vertices, 3, &count, nullptr));
        EXPECT_EQ(3u, count);
        EXPECT_EQ(2u, *std::min_element(vertices, vertices + 3));
        EXPECT_EQ(16u, vertices[0] + vertices[1] + vertices[2]);
    }
    mien_zones_release(made);
    mien_zones_release(read);
    const std::uint32_t vertex = 1;
    const mien_zone nameless = {nullptr, &vertex, 1};
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_zones_create(&nameless, 1, &made, nullptr));
    EXPECT_EQ(nullptr, made);
}

TEST(Landmarks, AReferenceKeepsTheList) {
    const mien::Session session;
    mien_landmarks* list = nullptr;
    {
        const mien::Model model = small_model(session);
        ASSERT_EQ(MIEN_OK, mien_model_get_landmarks(model.get(), &list, nullptr));
    }
    mien_landmarks_retain(list);
    mien_landmarks_release(list);
    std::uint64_t count = 0;
    char name[8];
    EXPECT_EQ(MIEN_OK, mien_landmarks_get_name(list, 0, name, sizeof name, &count, nullptr));
    EXPECT_STREQ("nose", name);
    mien_landmarks_release(list);
}

TEST(Landmarks, NoKnownNameIsNotFoundWithExamples) {
    const mien::Session session;
    const mien::Model model = small_model(session);
    try {
        mien::Landmarks({{"P1", 1, {{1, 2, 3}}, 0}}).match(model);
        FAIL();
    } catch (const mien::Exception& failure) {
        EXPECT_EQ(failure.status(), MIEN_E_NOT_FOUND);
        EXPECT_NE(std::string(failure.what()).find("'nose'"), std::string::npos);
    }
    mien::RegisterOptions options;
    options.landmarks = {{"P1", {{1, 2, 3}}}};
    EXPECT_THROW(mien::Registration(session, model, sheet(session), options), mien::Exception);
}

TEST(RegisterOptions, AnUnknownChoiceIsUnsupportedAndANumberOutOfRangeInvalid) {
    const mien::Session session;
    const mien::Model model = small_model(session);
    const mien::Mesh scan = sheet(session);
    const auto status = [&](std::int32_t mien_register_options::*member, std::int32_t value) {
        mien_register_options options;
        mien_register_options_init(&options, sizeof options);
        options.*member = value;
        mien_registration* made = nullptr;
        const mien_status got =
            mien_register(session.get(), model.get(), scan.get(), &options, &made, nullptr);
        mien_registration_release(made);
        return got;
    };
    for (const auto member :
         {&mien_register_options::growth, &mien_register_options::start,
          &mien_register_options::units, &mien_register_options::skin_weights,
          &mien_register_options::close_gap, &mien_register_options::reject_border,
          &mien_register_options::color_features, &mien_register_options::landmark_sides})
        for (const std::int32_t value : {-1, 4})
            EXPECT_EQ(status(member, value), MIEN_E_UNSUPPORTED_OPTION) << value;
    for (const std::int32_t value : {-1, 10001})
        EXPECT_EQ(status(&mien_register_options::iterations, value), MIEN_E_INVALID_ARGUMENT);
}

TEST(RegisterOptions, WaysToCorrespondAreHeardAndBadOnesRefused) {
    const mien::Session session;
    const mien::Model model = small_model(session);
    const mien::Mesh scan = sheet(session);
    const auto fit = [&](double mien_register_options::*member, double value,
                         std::vector<double>& places) {
        mien_register_options options;
        mien_register_options_init(&options, sizeof options);
        options.start = MIEN_START_POSE;
        options.units = MIEN_UNITS_MILLIMETRES;
        options.start_translation[0] = 25;  // past the scan's rim, which pulls too
        options.reject_border = 0;
        if (member != nullptr) options.*member = value;
        mien_registration* made = nullptr;
        const mien_status got =
            mien_register(session.get(), model.get(), scan.get(), &options, &made, nullptr);
        if (got == MIEN_OK) places = positions_of(mien_registration_mesh(made));
        mien_registration_release(made);
        return got;
    };
    std::vector<double> plain, other;
    ASSERT_EQ(fit(nullptr, 0, plain), MIEN_OK);
    for (const auto member : {&mien_register_options::max_distance_mm,
                              &mien_register_options::mutual_mm, &mien_register_options::soft_mm}) {
        ASSERT_EQ(fit(member, 0, other), MIEN_OK);
        EXPECT_EQ(other, plain);
        for (const double value : {-1.0, std::nan(""), HUGE_VAL})
            EXPECT_EQ(fit(member, value, other), MIEN_E_INVALID_ARGUMENT) << value;
    }
    ASSERT_EQ(fit(&mien_register_options::soft_mm, 2, other), MIEN_OK);
    EXPECT_NE(other, plain);
    ASSERT_EQ(fit(&mien_register_options::mutual_mm, 15, other), MIEN_OK);
    EXPECT_NE(other, plain);
}

TEST(Landmarks, IndicesAndNullsAreRefused) {
    const Session session;
    const mien_scan_landmark marks[] = {{"a", {1, 2, 3}}, {"a", {4, 5, 6}}};
    mien_landmarks* list = nullptr;
    EXPECT_EQ(mien_landmarks_create(marks, 2, &list, nullptr), MIEN_E_INVALID_ARGUMENT);
    ASSERT_EQ(mien_landmarks_create(marks, 1, &list, nullptr), MIEN_OK);
    mien_error error = fresh_error();
    EXPECT_EQ(mien_landmarks_get_mark(list, 1, nullptr, nullptr, nullptr, &error),
              MIEN_E_NOT_FOUND);
    EXPECT_EQ(mien_landmarks_get_counts(nullptr, nullptr, nullptr, nullptr), MIEN_E_INVALID_HANDLE);
    EXPECT_EQ(mien_landmarks_save(session, list, temporary_path("a.doc").c_str(), nullptr),
              MIEN_E_BAD_FORMAT);
    mien_landmarks_release(list);
}

/// A sheet about x = 0, 13 x 161 vertices, whose middle bulges at y = 5 (nose), 58 (brow), -35
/// (lip) and -65 (chin).
mien::Mesh profile_sheet(const mien::Session& session) {
    const auto bump = [](double y, double centre, double width) {
        return std::exp(-(y - centre) * (y - centre) / (2 * width * width));
    };
    std::vector<mien::Position> positions;
    std::vector<mien::Triangle> triangles;
    for (std::uint32_t j = 0; j < 161; ++j)
        for (std::uint32_t i = 0; i < 13; ++i) {
            const double x = 3.0 * i - 18, y = j - 80.0;
            const double under_chin = y < -65 ? 0.02 * (y + 65) * (y + 65) : 0;
            positions.push_back({{x, y,
                                  100 - under_chin + 30 * bump(y, 5, 9) + 4 * bump(y, 58, 8) +
                                      9 * bump(y, -35, 8) + 6 * bump(y, -65, 6) - x * x / 180}});
            if (j == 160 || i == 12) continue;
            const std::uint32_t a = 13 * j + i;
            triangles.push_back({{a, a + 1, a + 14}});
            triangles.push_back({{a, a + 14, a + 13}});
        }
    return mien::Mesh(session, positions, triangles);
}

TEST(Landmarks, OfAProfileLieAtItsBulgesAndHollows) {
    const mien::Session session;
    const mien::Mesh mesh = profile_sheet(session);
    const auto at = [](int y, int column) { return std::to_string((y + 80) * 13 + column + 6); };
    const std::string path = temporary_path("profile.json");
    std::ofstream(path) << "{\"vertices\": {\"nose_bridge_3\": " << at(5, 0)
                        << ", \"nose_base_2\": " << at(-12, 0)
                        << ", \"mouth_outer_09\": " << at(-40, 0) << ", \"jaw_08\": " << at(-75, 0)
                        << ", \"eye_right_3\": " << at(33, -4) << ", \"eye_left_0\": " << at(33, 4)
                        << "}}";
    mien_landmarks *given = nullptr, *all = nullptr;
    ASSERT_EQ(MIEN_OK, mien_landmarks_load(session.get(), path.c_str(), &given, nullptr));
    mien_error error = fresh_error();
    ASSERT_EQ(MIEN_OK, mien_landmarks_add_profile(given, mesh.get(), &all, &error))
        << error.message;
    std::uint64_t before = 0, count = 0;
    ASSERT_EQ(MIEN_OK, mien_landmarks_get_counts(given, &before, nullptr, nullptr));
    ASSERT_EQ(MIEN_OK, mien_landmarks_get_counts(all, &count, nullptr, nullptr));
    EXPECT_EQ(6u, before);
    EXPECT_EQ(11u, count);
    std::map<std::string, double> height;
    const std::vector<mien::Position> positions = mesh.positions();
    for (std::uint64_t k = 0; k < count; ++k) {
        char name[64];
        std::uint32_t vertex = 0;
        ASSERT_EQ(MIEN_OK, mien_landmarks_get_name(all, k, name, sizeof name, nullptr, nullptr));
        ASSERT_EQ(MIEN_OK, mien_landmarks_get_mark(all, k, nullptr, nullptr, &vertex, nullptr));
        ASSERT_LT(vertex, positions.size()) << name;
        if (k >= before) {
            EXPECT_EQ(0, positions[vertex][0]) << name;
        }
        height[name] = positions[vertex][1];
    }
    EXPECT_EQ(58, height.at("glabella"));
    EXPECT_NEAR(-65, height.at("pogonion"), 1);
    EXPECT_TRUE(height.at("nasion") > 20 && height.at("nasion") < 58) << height["nasion"];
    EXPECT_TRUE(height.at("columella") > -12 && height.at("columella") < 5);
    EXPECT_TRUE(height.at("sublabiale") > -65 && height.at("sublabiale") < -40);
    mien_landmarks_release(all);
    // Once more: they are there already.
    ASSERT_EQ(MIEN_OK, mien_landmarks_add_profile(given, mesh.get(), &all, nullptr));
    mien_landmarks* twice = nullptr;
    ASSERT_EQ(MIEN_OK, mien_landmarks_add_profile(all, mesh.get(), &twice, nullptr));
    EXPECT_EQ(MIEN_OK, mien_landmarks_get_counts(twice, &count, nullptr, nullptr));
    EXPECT_EQ(11u, count);
    mien_landmarks_release(twice);
    mien_landmarks_release(all);
    const mien_scan_landmark none[] = {{"a", {1, 2, 3}}};
    mien_landmarks_release(given);
    ASSERT_EQ(MIEN_OK, mien_landmarks_create(none, 1, &given, nullptr));
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_landmarks_add_profile(given, mesh.get(), &all, nullptr));
    EXPECT_EQ(nullptr, all);
    mien_landmarks_release(given);
}

TEST(MeshTools, ScaleMirrorCleanAndDecimate) {
    const mien::Session session;
    const mien::Mesh mesh = sheet(session);
    const mien::Mesh scaled =
        mien::transform_mesh(session, mesh, {2, 0, 0, 1, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1});
    EXPECT_EQ(scaled.positions()[0][0], 2 * mesh.positions()[0][0] + 1);
    EXPECT_EQ(scaled.triangles(), mesh.triangles());
    const mien::Mesh mirrored =
        mien::transform_mesh(session, mesh, {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    EXPECT_EQ(mirrored.triangles()[0][1], mesh.triangles()[0][2]);
    EXPECT_EQ(mien::turn_mesh_over(session, mirrored).triangles(), mesh.triangles());
    EXPECT_THROW(mien::transform_mesh(session, mesh, {}), mien::Exception);
    EXPECT_EQ(mien::clean_mesh(session, mesh).vertex_count(), mesh.vertex_count());
    const std::size_t fewer = mien::decimate_mesh(session, mesh, 60).vertex_count();
    EXPECT_LE(fewer, 70u);
    EXPECT_GE(fewer, 60u);
    EXPECT_THROW(mien::decimate_mesh(session, mesh, 1000), mien::Exception);
    EXPECT_NO_THROW(mien::check_same_unit(mesh, scaled));
    const mien::Mesh metres = mien::transform_mesh(
        session, mesh, {.001, 0, 0, 0, 0, .001, 0, 0, 0, 0, .001, 0, 0, 0, 0, 1});
    EXPECT_THROW(mien::check_same_unit(mesh, metres), mien::Exception);
    EXPECT_NE(mien::inspect_mesh(session, metres).find("it seems to be in m"), std::string::npos);
}

TEST(TemplateCheck, SaysWhatIsWrong) {
    const mien::Session session;
    const mien::Mesh mesh = sheet(session);
    EXPECT_NE(mien::check_template(session, mesh, nullptr, false).find("\"errors\":0"),
              std::string::npos);
    EXPECT_NE(mien::check_template(session, mien::turn_mesh_over(session, mesh), nullptr, false)
                  .find("inside-out"),
              std::string::npos);
    const mien::Landmarks landmarks = mien::Landmarks::of(small_model(session));
    EXPECT_NE(mien::check_template(session, mesh, &landmarks, true).find("\"findings\""),
              std::string::npos);
}

}  // namespace
