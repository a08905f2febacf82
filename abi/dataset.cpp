#include "mesh/dataset.hpp"

#include <cmath>

#include "arrays.hpp"
#include "guard.hpp"
#include "mesh.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_dataset_writer : Object {
    static constexpr Tag kTag = Tag::dataset_writer;
    static constexpr const char* kName = "dataset writer";
    mien_dataset_writer(const TriMesh& topology, std::vector<std::string> names)
        : Object(kTag),
          num_vertices(topology.vertices.rows()),
          num_expressions(static_cast<std::int32_t>(names.size())),
          writer(topology.triangles, topology.vertices.rows(), std::move(names)) {}
    Index num_vertices;
    std::int32_t num_expressions;
    FaceDatasetWriter writer;
};

extern "C" {

mien_status MIEN_CALL mien_dataset_writer_create(mien_session* session, const mien_mesh* topology,
                                                 const char* const* expression_names,
                                                 uint32_t expression_count,
                                                 mien_dataset_writer** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        checked(session, "session");
        const TriMesh& mesh = *checked(topology, "topology").mesh;
        if (expression_count == 0) fail(Status::invalid_argument, "expression_count is 0");
        check_array(expression_names, expression_count, alignof(const char*), 1000000,
                    "expression_names");
        std::vector<std::string> names;
        for (uint32_t i = 0; i < expression_count; ++i)
            names.emplace_back(checked_text(expression_names[i], "an expression name"));
        return new mien_dataset_writer(mesh, std::move(names));
    });
}

mien_status MIEN_CALL mien_dataset_writer_add(mien_dataset_writer* writer,
                                              const mien_array_view* positions, int32_t subject,
                                              int32_t expression, mien_error* error) {
    return guarded(error, [&] {
        mien_dataset_writer& target = checked(writer, "writer");
        const mien_array_view& given = checked_view(positions, "positions");
        if (expression < 0 || expression >= target.num_expressions)
            fail(Status::invalid_argument, "expression is %d, the dataset has %d expression names",
                 expression, target.num_expressions);
        const Points face = read_points(given, "positions");
        if (face.rows() != target.num_vertices)
            fail(Status::mismatch, "the face has %lld vertices, the dataset's topology %lld",
                 static_cast<long long>(face.rows()), static_cast<long long>(target.num_vertices));
        for (Index v = 0; v < face.rows(); ++v)
            if (!face.row(v).allFinite())
                fail_at(Status::invalid_mesh, v, "vertex %lld of the face is not finite",
                        static_cast<long long>(v));
        target.writer.add(face, subject, expression);
    });
}

mien_status MIEN_CALL mien_dataset_writer_save(mien_session* session,
                                               const mien_dataset_writer* writer, const char* path,
                                               mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        checked(writer, "writer").writer.save(checked_text(path, "path"), call.context());
    });
}

void MIEN_CALL mien_dataset_writer_release(mien_dataset_writer* writer) {
    release(writer);
}

}  // extern "C"
