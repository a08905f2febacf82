#include "registration/fit_record.hpp"
#include "registration/reference_visit.hpp"
#include "registration/texture_tie.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "registration/report.hpp"

namespace mien {
namespace {

FitRecord made() {
    TriMesh mesh;
    mesh.vertices.resize(4, 3);
    mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0.1, 1, 1, 1.0 / 3;
    mesh.triangles.resize(2, 3);
    mesh.triangles << 0, 1, 2, 1, 3, 2;
    Vector weights(4), residual(4), sd(4);
    weights << 0, 0.25, 1, 1.0 / 3;
    residual << -0.1, 0.2, 0, 1e-17;
    sd << 0.5, 0, 1e9, 0.7;
    FitRecord record = fit_record_of(mesh, weights, residual, sd, FitQuality::doubtful,
                                     {{"nose", {0, 2}}, {"chin", {3}}});
    RegistrationResult& fit = record.fit;
    fit.correspondence.resize(4);
    fit.correspondence[2].triangle = 17;
    fit.correspondence[2].barycentric = Vector3(0.2, 0.3, 0.5);
    fit.energy = {3, 2.5};
    fit.motion.translation = Vector3(1, 2, 1.0 / 3);
    fit.motion.scale = 1.1;
    fit.verdict.reasons = {"a scan of \"half\" a face", "zwölf"};
    fit.verdict.notes = {"tied to another visit"};
    fit.verdict.landmarks_rejected = {"gnathion"};
    fit.verdict.colors = {{"lips", 0.75}};
    fit.verdict.colors_left_out = {"brow_left"};
    fit.verdict.whole.size = 1.0 / 7;
    fit.verdict.whole.no_colors = 1;
    fit.verdict.whole.landmarks = 66;
    fit.verdict.whole.worst_unseen = 0.7;
    ZoneMeasures face;
    face.name = "face";
    face.stretch = 1.0 / 3;
    face.landmarks = 5;
    face.asymmetry_mm = 0.4;
    face.color_doubt = 1.0 / 9;
    fit.verdict.zones = {face};
    fit.verdict.expected = {{"face", 1.0 / 3, 0.1, 2, FitQuality::doubtful, FitMeasure::stretch}};
    fit.verdict.landmarks_used = 66;
    fit.verdict.may_slide = true;
    fit.unknown_landmarks = {"elbow"};
    fit.iterations = 12;
    fit.sigma_mm = 0.5;
    return record;
}

std::string path() {
    return ::testing::TempDir() + "mien_fit_record.safetensors";
}

TEST(FitRecord, LosesNoBitOnItsWayThroughAFile) {
    const FitRecord kept = made();
    save_fit_record(path(), kept.mesh, kept.fit, kept.zones, kept.tie.get(), Context());
    const FitRecord read = load_fit_record(path(), Context());
    EXPECT_EQ(read.mesh.vertices, kept.mesh.vertices);
    EXPECT_EQ(read.mesh.triangles, kept.mesh.triangles);
    EXPECT_EQ(read.fit.weight, kept.fit.weight);
    EXPECT_EQ(read.fit.residual_mm, kept.fit.residual_mm);
    EXPECT_EQ(read.fit.confidence_mm, kept.fit.confidence_mm);
    EXPECT_EQ(registration_json(read.fit), registration_json(kept.fit));
    ASSERT_EQ(read.zones.size(), 2u);
    EXPECT_EQ(read.zones[0].name, "nose");
    EXPECT_EQ(read.zones[0].vertices, kept.zones[0].vertices);
    EXPECT_EQ(read.fit.correspondence[2].triangle, 17u);
    EXPECT_EQ(read.fit.correspondence[2].barycentric, kept.fit.correspondence[2].barycentric);
    EXPECT_TRUE(read.fit.verdict.may_slide);
    ASSERT_EQ(read.fit.verdict.expected.size(), 1u);
    EXPECT_EQ(read.fit.verdict.expected[0].cause, FitMeasure::stretch);
    std::remove(path().c_str());
}

// Measures were added: files from before them hold fewer columns.
TEST(FitRecord, MeasuresThatAFileLacksAreZero) {
    const FitRecord kept = made();
    save_fit_record(path(), kept.mesh, kept.fit, kept.zones, kept.tie.get(), Context());
    const SafetensorsFile file = SafetensorsFile::open(path(), {}, Context());
    std::vector<TensorToWrite> tensors;
    for (const auto& [name, tensor] : file.tensors()) {
        tensors.push_back({name, tensor.dtype, tensor.shape, tensor.data});
        if (name == "measures") tensors.back().shape = {12};
        if (name == "zone_measures") tensors.back().shape = {1, 8};
    }
    const auto read_again = [&] {
        const std::string old_path = path() + ".old";
        write_safetensors(old_path, tensors, file.metadata(), Context());
        const FitRecord read = load_fit_record(old_path, Context());
        std::remove(old_path.c_str());
        return read;
    };
    const FitRecord read = read_again();
    EXPECT_EQ(read.fit.verdict.whole.size, kept.fit.verdict.whole.size);
    EXPECT_EQ(read.fit.verdict.whole.landmarks, 0);
    ASSERT_EQ(read.fit.verdict.zones.size(), 1u);
    EXPECT_EQ(read.fit.verdict.zones[0].stretch, kept.fit.verdict.zones[0].stretch);
    EXPECT_EQ(read.fit.verdict.zones[0].asymmetry_mm, 0);
    for (TensorToWrite& tensor : tensors)
        if (tensor.name == "zone_measures") tensor.shape = {1, 5};
    EXPECT_THROW(read_again(), Error);
    std::remove(path().c_str());
}

TEST(FitRecord, WhatWasNotKnownIsNotKnownAgain) {
    const FitRecord kept = fit_record_of(made().mesh, {}, {}, {}, FitQuality::good, {});
    save_fit_record(path(), kept.mesh, kept.fit, kept.zones, kept.tie.get(), Context());
    const FitRecord read = load_fit_record(path(), Context());
    EXPECT_EQ(read.fit.weight.size(), 0);
    EXPECT_EQ(read.fit.confidence_mm.size(), 0);
    EXPECT_TRUE(read.zones.empty());
    EXPECT_TRUE(read.fit.correspondence.empty());
    std::remove(path().c_str());
}

TEST(FitRecord, ArraysThatAreNoFitAreRefused) {
    const TriMesh mesh = made().mesh;
    const Vector ones = Vector::Ones(4), none;
    Vector wrong = ones;
    wrong[2] = -1;
    const auto status = [&](const Vector& weights, const Vector& sd, std::vector<Zone> zones) {
        try {
            fit_record_of(mesh, weights, none, sd, FitQuality::good, std::move(zones));
        } catch (const Error& failure) {
            return failure.status();
        }
        return Status::ok;
    };
    EXPECT_EQ(status(ones, ones, {}), Status::ok);
    EXPECT_EQ(status(wrong, ones, {}), Status::invalid_argument);
    EXPECT_EQ(status(2 * ones, ones, {}), Status::invalid_argument);
    EXPECT_EQ(status(ones, wrong, {}), Status::invalid_argument);
    EXPECT_EQ(status(Vector::Ones(3), ones, {}), Status::mismatch);
    EXPECT_EQ(status(ones, ones, {{"nose", {4}}}), Status::mismatch);
}

TextureTie made_tie() {
    TextureTie tie;
    tie.tied = true;
    tie.slide_mm = Vector::LinSpaced(4, 0, 1.0 / 3);
    tie.agreement = Vector::LinSpaced(4, -1, 1);
    tie.share = Vector::LinSpaced(4, 0, 1);
    tie.sd_mm = Vector::Constant(4, 0.1);
    tie.compared = 0.9;
    tie.agreeing = 1.0 / 7;
    tie.median_slide_mm = 0.2;
    tie.undone = 3;
    return tie;
}

TEST(FitRecord, ATieIsKeptWithTheFit) {
    const FitRecord kept = made();
    TextureTie tie = made_tie();
    save_fit_record(path(), kept.mesh, kept.fit, kept.zones, &tie, Context());
    const FitRecord read = load_fit_record(path(), Context());
    ASSERT_NE(read.tie, nullptr);
    EXPECT_EQ(tie_json(*read.tie, read.zones), tie_json(tie, kept.zones));
    EXPECT_EQ(read.tie->slide_mm, tie.slide_mm);
    EXPECT_EQ(read.tie->agreement, tie.agreement);
    EXPECT_EQ(read.tie->share, tie.share);
    EXPECT_EQ(read.tie->sd_mm, tie.sd_mm);
    // A share of two is none: whoever wrote it did not write a tie.
    tie.share[2] = 2;
    save_fit_record(path(), kept.mesh, kept.fit, kept.zones, &tie, Context());
    EXPECT_THROW(load_fit_record(path(), Context()), Error);
    std::remove(path().c_str());
}

TEST(FitRecord, EveryTruncationIsATypedError) {
    FitRecord kept = made();
    kept.tie = std::make_shared<TextureTie>(made_tie());
    save_fit_record(path(), kept.mesh, kept.fit, kept.zones, kept.tie.get(), Context());
    std::ifstream in(path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    for (std::size_t size = 0; size < bytes.size(); size += 7)
        EXPECT_THROW(
            read_fit_record(SafetensorsFile::from_memory(bytes.data(), size, {}, Context())),
            Error);
    std::remove(path().c_str());
}

}  // namespace
}  // namespace mien
