// A registration that is tied to an earlier one, through the shared library alone.
#include <cstdio>
#include <cstring>

#include "sheets.hpp"

namespace {

using namespace mien_test;

constexpr int kSide = 44;  // vertices along an edge: small enough for a build with sanitizers

/// A sheet with a fine pattern of brightness; `phase`: another one.
Mesh colored_sheet(mien_session* session, std::uint32_t phase) {
    const SheetArrays sheet = sheet_arrays(kSide, 1.5, 8, 0.3);
    std::vector<std::uint8_t> colors;
    for (std::uint32_t v = 0; v < kSide * kSide; ++v) {
        std::uint32_t x = v * 2654435761u + phase;
        x = (x ^ (x >> 15)) * 2246822519u;
        const auto shade = static_cast<std::uint8_t>(120 + (x >> 24) / 3);
        colors.insert(colors.end(), {shade, static_cast<std::uint8_t>(shade - 30), 90});
    }
    mien_mesh_arrays arrays;
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    arrays.positions = {sheet.positions.data(), sheet.positions.size() / 3, 0, MIEN_DTYPE_F64, 0};
    arrays.triangles = sheet.triangles.data();
    arrays.triangle_count = sheet.triangles.size() / 3;
    arrays.colors = colors.data();
    mien_mesh* mesh = nullptr;
    EXPECT_EQ(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, nullptr));
    return Mesh(mesh, mien_mesh_release);
}

class Tie : public testing::Test {
  protected:
    void SetUp() override {
        mien_model_options options;
        mien_model_options_init(&options, sizeof options);
        options.num_modes = 10;
        options.num_control_points = 40;
        options.sigma_mm = 30;
        ASSERT_EQ(MIEN_OK, mien_model_build(session_, form_.get(), &options, &model_, nullptr));
        ASSERT_EQ(MIEN_OK, mien_registration_create(session_, form_.get(), nullptr, nullptr,
                                                    nullptr, MIEN_QUALITY_GOOD, &fit_, nullptr));
    }
    void TearDown() override {
        mien_registration_release(fit_);
        mien_model_release(model_);
    }

    mien_status tie(const mien_mesh* before, const mien_mesh* now, mien_registration** out,
                    const mien_tie_options* options = nullptr, mien_error* error = nullptr) const {
        return mien_registration_tie(session_, model_, fit_, before, fit_, now, options, out,
                                     error);
    }
    std::vector<double> field(const mien_registration* fit, std::int32_t which) const {
        std::vector<double> values(kSide * kSide);
        std::uint64_t count = 0;
        EXPECT_EQ(MIEN_OK, mien_registration_get_field(fit, which, values.data(), values.size(),
                                                       &count, nullptr));
        EXPECT_EQ(values.size(), count);
        return values;
    }
    static std::string json(const mien_registration* fit) {
        std::uint64_t count = 0;
        EXPECT_EQ(MIEN_OK, mien_registration_get_json(fit, nullptr, 0, &count, nullptr));
        std::string text(count, '\0');
        EXPECT_EQ(MIEN_OK, mien_registration_get_json(fit, text.data(), count, &count, nullptr));
        return text;
    }

    const Session session_;
    Mesh form_ = make_mesh(session_, sheet_arrays(kSide, 1.5, 8, 0.3));
    mien_model* model_ = nullptr;
    mien_registration* fit_ = nullptr;
};

TEST_F(Tie, AVisitTiedToItselfStaysAndIsHeld) {
    const Mesh scan = colored_sheet(session_, 1);
    mien_registration* tied = nullptr;
    ASSERT_EQ(MIEN_OK, tie(scan.get(), scan.get(), &tied));
    EXPECT_NE(json(tied).find("\"reference\":{\"tied\":true"), std::string::npos) << json(tied);
    double slid = 0, held = 0;
    for (const double slide : field(tied, MIEN_REGISTRATION_SLIDE_MM)) slid = std::max(slid, slide);
    for (const double share : field(tied, MIEN_REGISTRATION_TIE_SHARE))
        held += share / (kSide * kSide);
    EXPECT_LT(slid, 0.2);
    EXPECT_GT(held, 0.5);
    EXPECT_EQ(std::size_t{kSide * kSide}, field(tied, MIEN_REGISTRATION_TIE_AGREEMENT).size());
    EXPECT_EQ(std::size_t{kSide * kSide}, field(tied, MIEN_REGISTRATION_TIE_DEVIATION_MM).size());

    const std::string path = testing::TempDir() + "mien_tied.safetensors";
    mien_registration* read = nullptr;
    ASSERT_EQ(MIEN_OK, mien_registration_save(session_, tied, path.c_str(), nullptr));
    ASSERT_EQ(MIEN_OK, mien_registration_load(session_, path.c_str(), &read, nullptr));
    EXPECT_EQ(json(tied), json(read));
    for (const std::int32_t which : {MIEN_REGISTRATION_SLIDE_MM, MIEN_REGISTRATION_TIE_SHARE})
        EXPECT_EQ(field(tied, which), field(read, which));
    mien_registration_release(read);
    std::remove(path.c_str());
    mien_registration_release(tied);
}

TEST_F(Tie, SkinThatIsNotTheSameMovesNothingAndSaysSo) {
    const Mesh before = colored_sheet(session_, 1), now = colored_sheet(session_, 77);
    mien_registration* tied = nullptr;
    ASSERT_EQ(MIEN_OK, tie(before.get(), now.get(), &tied));
    EXPECT_NE(json(tied).find("\"reference\":{\"tied\":false"), std::string::npos);
    EXPECT_EQ(positions_of(mien_registration_mesh(tied)), positions_of(form_.get()));
    mien_registration_release(tied);
}

TEST_F(Tie, WrongArgumentsAreTold) {
    const Mesh scan = colored_sheet(session_, 1);
    mien_registration* tied = nullptr;
    mien_error error{};
    error.struct_size = sizeof error;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, tie(form_.get(), scan.get(), &tied, nullptr, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "no colours")) << error.message;
    EXPECT_EQ(nullptr, tied);
    EXPECT_EQ(MIEN_E_INVALID_HANDLE, tie(nullptr, scan.get(), &tied));
    mien_tie_options options;
    mien_tie_options_init(&options, sizeof options);
    EXPECT_EQ(6, options.max_slide_mm);
    options.max_slide_mm = -1;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, tie(scan.get(), scan.get(), &tied, &options));
    mien_tie_options_init(&options, sizeof options);
    options.progress = [](void*, std::int32_t, double) -> std::int32_t { return 1; };
    EXPECT_EQ(MIEN_E_CANCELLED, tie(scan.get(), scan.get(), &tied, &options));
    double none = 0;
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_registration_get_field(fit_, MIEN_REGISTRATION_SLIDE_MM, &none,
                                                            1, nullptr, nullptr));
}

}  // namespace
