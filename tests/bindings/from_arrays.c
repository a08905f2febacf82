/* The main job of a host that keeps its meshes as arrays, in C: from_arrays FACE.safetensors
 * EXPRESSIONS.safetensors SCAN.ply NEUTRAL.ply. The scan is read, taken out as positions, triangles
 * and colours, and made again of these. */
#include <mien/mien.h>
#include <stdio.h>
#include <stdlib.h>

/* The arrays of a mesh in memory of this program; colours may be none. */
static mien_status copy(const mien_mesh* file, mien_mesh_arrays* arrays, mien_error* error) {
    uint64_t vertices, triangles, colors;
    double* positions;
    uint32_t* corners;
    uint8_t* rgb;
    mien_status status;
    if ((status = mien_mesh_get_positions(file, MIEN_DTYPE_F64, NULL, 0, &vertices, error)) ||
        (status = mien_mesh_get_triangles(file, NULL, 0, &triangles, error)) ||
        (status = mien_mesh_get_colors(file, NULL, 0, &colors, error)))
        return status;
    positions = malloc(vertices * 3 * sizeof *positions);
    corners = malloc(triangles * 3 * sizeof *corners);
    rgb = malloc(colors * 3 + 1);
    if (!positions || !corners || !rgb) return MIEN_E_NO_MEMORY;
    mien_mesh_arrays_init(arrays, sizeof *arrays);
    arrays->positions = (mien_array_view){positions, vertices, 0, MIEN_DTYPE_F64, 0};
    arrays->triangles = corners;
    arrays->triangle_count = triangles;
    arrays->colors = colors ? rgb : NULL;
    if ((status =
             mien_mesh_get_positions(file, MIEN_DTYPE_F64, positions, vertices, NULL, error)) ||
        (status = mien_mesh_get_triangles(file, corners, triangles, NULL, error)))
        return status;
    return colors ? mien_mesh_get_colors(file, rgb, colors, NULL, error) : MIEN_OK;
}

int main(int argc, char** argv) {
    mien_error error = {.struct_size = sizeof error};
    mien_session* session = NULL;
    mien_model* face = NULL;
    mien_expression_model* expressions = NULL;
    mien_mesh *file = NULL, *scan = NULL;
    mien_registration* fitted = NULL;
    mien_neutralization* neutral = NULL;
    mien_mesh_arrays arrays;

    if (argc != 5) return 2;
    if (mien_session_create(MIEN_ABI_VERSION, &session, &error) ||
        mien_model_load(session, argv[1], &face, &error) ||
        mien_expression_model_load(session, argv[2], &expressions, &error) ||
        mien_mesh_load(session, argv[3], &file, &error) || copy(file, &arrays, &error) ||
        mien_mesh_create(session, &arrays, &scan, &error) ||
        mien_register(session, face, scan, NULL, &fitted, &error) ||
        mien_neutralize(session, expressions, fitted, NULL, &neutral, &error) ||
        mien_mesh_save(session, mien_neutralization_mesh(neutral), argv[4], &error)) {
        fprintf(stderr, "from_arrays: %s\n", error.message);
        return 1;
    }
    if (!arrays.colors) {
        fprintf(stderr, "from_arrays: %s has no colours\n", argv[3]);
        return 1;
    }
    return 0;
}
