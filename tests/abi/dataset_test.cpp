#include "handles.hpp"

namespace {

using namespace mien_test;

struct Writer {
    Writer(mien_session* session, const mien_mesh* topology) {
        const char* names[] = {"neutral", "smile"};
        EXPECT_EQ(MIEN_OK,
                  mien_dataset_writer_create(session, topology, names, 2, &handle, nullptr));
    }
    ~Writer() { mien_dataset_writer_release(handle); }
    mien_dataset_writer* handle = nullptr;
};

TEST(DatasetWriter, RefusesFacesThatDoNotBelong) {
    Session session;
    const Mesh mesh = make_square(session);
    Writer writer(session, mesh.get());
    Square square;
    mien_array_view face{square.positions, 4, 0, MIEN_DTYPE_F32, 0};
    EXPECT_EQ(MIEN_OK, mien_dataset_writer_add(writer.handle, &face, 7, 1, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_dataset_writer_add(writer.handle, &face, 7, 2, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_dataset_writer_add(writer.handle, &face, 7, -1, nullptr));
    face.count = 3;
    EXPECT_EQ(MIEN_E_MISMATCH, mien_dataset_writer_add(writer.handle, &face, 7, 0, nullptr));
    face.count = 4;
    square.positions[0] = INFINITY;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_INVALID_MESH, mien_dataset_writer_add(writer.handle, &face, 7, 0, &error));
    EXPECT_EQ(0, error.detail_index);
    EXPECT_EQ(MIEN_OK,
              mien_dataset_writer_save(session, writer.handle,
                                       temporary_path("faces.safetensors").c_str(), nullptr));
}

TEST(DatasetWriter, RefusesToSaveNothing) {
    Session session;
    const Mesh mesh = make_square(session);
    Writer writer(session, mesh.get());
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_dataset_writer_save(session, writer.handle,
                                       temporary_path("none.safetensors").c_str(), nullptr));
}

}  // namespace
