/* File names are UTF-8 on every machine, whatever its locale or code page: what the library writes
 * under such a name is found under the same name by the system's own functions, and read again by
 * the library. */
#include <mien/mien.h>
#include <stdio.h>
#include <string.h>

/* A letter of Latin, one of Chinese and one beyond sixteen bits. */
#define NAME "gesicht_\xc3\xa4_\xe9\xa1\x94_\xf0\x9f\x98\x80.ply"
#define WIDE_NAME L"gesicht_\x00e4_\x9854_\xd83d\xde00.ply"

static FILE* open_by_the_system(void) {
#ifdef _WIN32
    return _wfopen(WIDE_NAME, L"rb");
#else
    return fopen(NAME, "rb");
#endif
}

static void remove_by_the_system(void) {
#ifdef _WIN32
    _wremove(WIDE_NAME);
#else
    remove(NAME);
#endif
}

int main(void) {
    static const float positions[9] = {0, 0, 0, 10, 0, 0, 0, 10, 0};
    static const uint32_t triangles[3] = {0, 1, 2};
    mien_error error;
    mien_mesh_arrays arrays;
    mien_session* session = NULL;
    mien_mesh *mesh = NULL, *again = NULL;
    uint64_t vertices = 0, faces = 0;
    char start[3] = "";
    FILE* file;

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
        mien_mesh_save(session, mesh, NAME, &error) ||
        mien_mesh_load(session, NAME, &again, &error) ||
        mien_mesh_get_counts(again, &vertices, &faces, &error))
        printf("FAILED: %s\n", error.message);
    file = open_by_the_system();
    if (file == NULL || fread(start, 1, 3, file) != 3 || memcmp(start, "ply", 3) != 0) {
        printf("FAILED: the system does not find the file under its name\n");
        vertices = 0;
    }
    if (file != NULL) fclose(file);
    remove_by_the_system();
    mien_mesh_release(again);
    mien_mesh_release(mesh);
    mien_session_release(session);
    if (error.status != MIEN_OK || vertices != 3 || faces != 1) return 1;
    printf("file names are UTF-8 here\n");
    return 0;
}
