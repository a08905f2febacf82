/* The smallest proof that headers and library fit: a mesh goes in and comes out. */
#include <mien/mien.h>

#include <stdio.h>
#include <string.h>

int main(void) {
    static const float positions[9] = {0, 0, 0, 10, 0, 0, 0, 10, 0};
    static const uint32_t triangles[3] = {0, 1, 2};
    mien_error error;
    mien_session* session = NULL;
    mien_mesh* mesh = NULL;
    mien_mesh_arrays arrays;
    uint64_t vertices = 0, faces = 0;

    memset(&error, 0, sizeof error);
    error.struct_size = sizeof error;
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    arrays.positions.data = positions;
    arrays.positions.count = 3;
    arrays.positions.dtype = MIEN_DTYPE_F32;
    arrays.triangles = triangles;
    arrays.triangle_count = 1;
    if (mien_session_create(MIEN_ABI_VERSION, &session, &error) ||
        mien_mesh_create(session, &arrays, &mesh, &error) ||
        mien_mesh_get_counts(mesh, &vertices, &faces, &error))
        fprintf(stderr, "mien: %s\n", error.message);
    else
        printf("%s: %d vertices, %d triangle\n", mien_build_id(), (int)vertices, (int)faces);
    mien_mesh_release(mesh);
    mien_session_release(session);
    return error.status != MIEN_OK || vertices != 3 || faces != 1;
}
