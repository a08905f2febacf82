#include <cfenv>
#include <cstddef>
#include <cstdio>
#include <mien/mien.hpp>

#include "handles.hpp"

namespace {

using namespace mien_test;

TEST(Session, RefusesAnotherAbi) {
    mien_session* session = nullptr;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_UNSUPPORTED_VERSION,
              mien_session_create(MIEN_ABI_VERSION + 1, &session, &error));
    EXPECT_EQ(nullptr, session);
    EXPECT_EQ(MIEN_E_UNSUPPORTED_VERSION, error.status);
}

TEST(Session, SuccessClearsTheRecord) {
    mien_error error = fresh_error();
    mien_session* session = nullptr;
    mien_session_create(MIEN_ABI_VERSION + 1, &session, &error);
    ASSERT_EQ(MIEN_OK, mien_session_create(MIEN_ABI_VERSION, &session, &error));
    EXPECT_EQ(MIEN_OK, error.status);
    EXPECT_STREQ("", error.message);
    EXPECT_EQ(-1, error.detail_index);
    mien_session_release(session);
}

TEST(Session, WritesOnlyWithinTheCallersRecord) {
    struct {
        mien_error error;
    } record;
    std::memset(&record, 0x5A, sizeof record);
    record.error.struct_size = 8;  // knows no more than the status
    mien_session* session = nullptr;
    mien_session_create(MIEN_ABI_VERSION + 1, &session, &record.error);
    EXPECT_EQ(MIEN_E_UNSUPPORTED_VERSION, record.error.status);
    EXPECT_EQ(0x5A5A5A5A5A5A5A5A, record.error.detail_index);
    EXPECT_EQ(0x5A, record.error.message[0]);
}

TEST(Session, OptionsMayBeShortExactOrLongerWithAZeroTail) {
    struct Longer {
        mien_session_options known;
        uint64_t tail;
    } longer;
    mien_session_options_init(&longer.known, sizeof longer);
    EXPECT_EQ(0u, longer.tail);
    EXPECT_EQ(1, longer.known.num_threads);
    mien_session* session = nullptr;
    EXPECT_EQ(MIEN_OK,
              mien_session_create_with_options(MIEN_ABI_VERSION, &longer.known, &session, nullptr));
    mien_session_release(session);
    longer.tail = 1;
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION,
              mien_session_create_with_options(MIEN_ABI_VERSION, &longer.known, &session, nullptr));
    longer.tail = 0;
    longer.known.struct_size = offsetof(mien_session_options, max_seconds);  // the first release's
    EXPECT_EQ(MIEN_OK,
              mien_session_create_with_options(MIEN_ABI_VERSION, &longer.known, &session, nullptr));
    mien_session_release(session);
    longer.known.struct_size = offsetof(mien_session_options, max_seconds) - 1;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_session_create_with_options(MIEN_ABI_VERSION, &longer.known, &session, nullptr));
}

TEST(Session, RefusesSillyThreadCounts) {
    mien_session_options options;
    mien_session_options_init(&options, sizeof options);
    mien_session* session = nullptr;
    for (int threads : {0, -1, 257}) {
        options.num_threads = threads;
        EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
                  mien_session_create_with_options(MIEN_ABI_VERSION, &options, &session, nullptr));
    }
}

TEST(Session, ReleaseOfNullIsSilent) {
    mien_session_release(nullptr);
    mien_cancel_release(nullptr);
    mien_cancel_request(nullptr);
    mien_mesh_release(nullptr);
    mien_mesh_retain(nullptr);
    mien_dataset_writer_release(nullptr);
}

TEST(Session, KeepsTheHostsRoundingMode) {
    std::fesetround(FE_UPWARD);
    Session session(2);
    EXPECT_EQ(FE_UPWARD, std::fegetround());
    std::fesetround(FE_TONEAREST);
}

TEST(Session, StatusNamesAndVersion) {
    EXPECT_STREQ("MIEN_OK", mien_status_name(MIEN_OK));
    EXPECT_STREQ("MIEN_E_CANCELLED", mien_status_name(MIEN_E_CANCELLED));
    EXPECT_STREQ("MIEN_E_UNKNOWN", mien_status_name(12345));
    EXPECT_STREQ(MIEN_VERSION_STRING, mien_version_string());
    EXPECT_EQ(MIEN_VERSION_MAJOR * 1000000u + MIEN_VERSION_MINOR * 1000u + MIEN_VERSION_PATCH,
              mien_version_number());
}

TEST(Session, TellsTheHashOfAFile) {
    const mien::Session session;
    const std::string path = temporary_path("hashed.txt");
    std::FILE* file = std::fopen(path.c_str(), "wb");
    ASSERT_NE(nullptr, file);
    std::fputs("abc", file);
    std::fclose(file);
    // FIPS 180-4's own example.
    const char* const known = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    EXPECT_EQ(known, session.hash_file(path));
    std::uint64_t count = 0;
    char room[65] = "";
    EXPECT_EQ(MIEN_OK,
              mien_session_hash_file(session.get(), path.c_str(), nullptr, 0, &count, nullptr));
    EXPECT_EQ(65u, count);
    EXPECT_EQ(MIEN_E_BUFFER_TOO_SMALL,
              mien_session_hash_file(session.get(), path.c_str(), room, 64, &count, nullptr));
    EXPECT_STREQ("", room);
    EXPECT_EQ(MIEN_E_IO, mien_session_hash_file(session.get(), temporary_path("absent").c_str(),
                                                room, sizeof room, nullptr, nullptr));
    std::remove(path.c_str());
}

TEST(CppFace, ThrowsTheRecordAndSharesMeshes) {
    const mien::Session session(2);
    try {
        const mien::Mesh missing(session, temporary_path("absent.ply"));
        FAIL() << "expected an exception";
    } catch (const mien::Exception& failure) {
        EXPECT_EQ(MIEN_E_IO, failure.status());
    }
    const mien::Mesh mesh(session, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}},
                          {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
    const mien::Mesh copy = mesh;
    EXPECT_EQ(3u, copy.positions().size());
    EXPECT_EQ(1u, copy.triangles().size());
    EXPECT_EQ(9, copy.colors()[2][2]);
}

}  // namespace
