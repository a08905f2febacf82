// The same through the C ABI: a failed allocation is MIEN_E_NO_MEMORY, the output handle is null
// and the session goes on working.
#include <mien/mien.h>

#include <string>

#include "fail_nth.hpp"
#include "unit/scratch.hpp"

int main() {
    if (!oom::available()) {
        std::puts("the malloc family cannot be replaced in this build: skipped");
        return 0;
    }
    const mien::testing::ScratchFolder folder;
    const std::string path = folder / "m.ply", copy = folder / "copy.obj";
    mien::testing::write_bytes(
        path,
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    auto fine = [](mien_status status) { return status == MIEN_OK || status == MIEN_E_NO_MEMORY; };
    int failed = 0;

    oom::Sweep sessions("session");
    sessions.run([&] {
        mien_session* session = nullptr;
        const mien_status status = mien_session_create(MIEN_ABI_VERSION, &session, nullptr);
        const bool right = fine(status) && (session != nullptr) == (status == MIEN_OK);
        mien_session_release(session);
        return right;
    });
    failed += sessions.report();

    mien_session* session = nullptr;
    if (mien_session_create(MIEN_ABI_VERSION, &session, nullptr) != MIEN_OK) return 1;
    oom::Sweep files("mesh load and save");
    files.run([&] {
        mien_error error = {};
        error.struct_size = sizeof error;
        mien_mesh* mesh = nullptr;
        mien_status status = mien_mesh_load(session, path.c_str(), &mesh, &error);
        bool right = fine(status) && (mesh != nullptr) == (status == MIEN_OK) &&
                     (status == MIEN_OK || error.message[0] != '\0');
        if (mesh != nullptr) {
            status = mien_mesh_save(session, mesh, copy.c_str(), &error);
            right = right && fine(status);
        }
        mien_mesh_release(mesh);
        return right;
    });
    failed += files.report();

    mien_mesh* mesh = nullptr;
    failed += mien_mesh_load(session, path.c_str(), &mesh, nullptr) != MIEN_OK;
    mien_mesh_release(mesh);
    mien_session_release(session);
    return failed == 0 ? 0 : 1;
}
