#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "arrays.hpp"
#include "guard.hpp"
#include "mesh.hpp"
#include "mesh/cleaning.hpp"
#include "mesh/decimation.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/manifold.hpp"
#include "mesh/mesh_report.hpp"
#include "mesh/winding.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_mesh* make_checked_mesh(TriMesh&& mesh) {
    check_mesh(mesh, "the result");
    return new mien_mesh(std::make_shared<const TriMesh>(std::move(mesh)));
}

TriMesh transformed(const TriMesh& mesh, const double* matrix) {
    if (matrix == nullptr) fail(Status::invalid_argument, "matrix is null");
    check_output(matrix, "matrix");
    for (int k = 0; k < 16; ++k)
        if (!std::isfinite(matrix[k]))
            fail_at(Status::invalid_argument, k, "entry %d of the matrix is not finite", k);
    if (matrix[12] != 0 || matrix[13] != 0 || matrix[14] != 0 || matrix[15] != 1)
        fail(Status::invalid_argument, "the matrix' last row is not 0 0 0 1: give an affine one");
    Matrix3 linear;
    Vector3 shift;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) linear(i, j) = matrix[4 * i + j];
        shift[i] = matrix[4 * i + 3];
    }
    const double determinant = linear.determinant();
    if (!(std::abs(determinant) > 0) || !std::isfinite(determinant))
        fail(Status::invalid_argument, "the matrix is not invertible: it would flatten the mesh");
    TriMesh moved = mesh;
    moved.vertices = (mesh.vertices * linear.transpose()).rowwise() + shift.transpose();
    if (determinant < 0) turn_over(moved);
    return moved;
}

}  // namespace

extern "C" {

mien_status MIEN_CALL mien_mesh_inspect(mien_session* session, const mien_mesh* mesh, char* dst,
                                        uint64_t capacity, uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        const std::string json = mesh_report_json(inspect_mesh(data, call.context()));
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_clean(mien_session* session, const mien_mesh* mesh,
                                      uint64_t min_triangles, mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        if (min_triangles > static_cast<std::uint64_t>(data.triangles.rows()))
            fail(Status::invalid_argument, "min_triangles is %llu, the mesh has %lld triangles",
                 static_cast<unsigned long long>(min_triangles),
                 static_cast<long long>(data.triangles.rows()));
        CleaningOptions options;
        options.min_component_triangles = static_cast<Index>(min_triangles);
        TriMesh cleaned = clean_mesh(data, options, call.context()).mesh;
        make_windings_consistent(cleaned, WindingSettings(), call.context());
        return make_checked_mesh(std::move(cleaned));
    });
}

mien_status MIEN_CALL mien_mesh_transform(mien_session* session, const mien_mesh* mesh,
                                          const double* matrix, mien_mesh** out,
                                          mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        return make_checked_mesh(transformed(data, matrix));
    });
}

mien_status MIEN_CALL mien_mesh_turn_over(mien_session* session, const mien_mesh* mesh,
                                          mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        TriMesh turned = *checked(mesh, "mesh").mesh;
        const Call call(session);
        turn_over(turned);
        return make_checked_mesh(std::move(turned));
    });
}

mien_status MIEN_CALL mien_mesh_decimate(mien_session* session, const mien_mesh* mesh,
                                         uint64_t vertex_count, mien_mesh** out,
                                         mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        if (vertex_count > static_cast<std::uint64_t>(data.vertices.rows()))
            fail(Status::invalid_argument, "vertex_count is %llu, the mesh has only %lld vertices",
                 static_cast<unsigned long long>(vertex_count),
                 static_cast<long long>(data.vertices.rows()));
        const ManifoldMesh ready = make_manifold(data, call.context());
        const Index most = std::min(static_cast<Index>(vertex_count), ready.mesh.vertices.rows());
        DecimatedMesh coarse = decimate(ready.mesh, most, call.context());
        if (data.colors.rows() == data.vertices.rows()) {
            coarse.mesh.colors.resize(coarse.mesh.vertices.rows(), 3);
            for (std::size_t v = 0; v < coarse.kept.size(); ++v)
                coarse.mesh.colors.row(static_cast<Index>(v)) =
                    data.colors.row(ready.vertex_to_old[coarse.kept[v]]);
        }
        return make_checked_mesh(std::move(coarse.mesh));
    });
}

mien_status MIEN_CALL mien_mesh_check_same_unit(const mien_mesh* first, const mien_mesh* second,
                                                mien_error* error) {
    return guarded(error, [&] {
        check_same_unit(checked(first, "first").mesh->vertices, "the first mesh",
                        checked(second, "second").mesh->vertices, "the second mesh");
    });
}

}  // extern "C"
