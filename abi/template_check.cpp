#include "model/template_check.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "landmarks.hpp"
#include "mesh.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

extern "C" {

mien_status MIEN_CALL mien_template_check(mien_session* session, const mien_mesh* template_mesh,
                                          const mien_landmarks* landmarks, int32_t mirror,
                                          char* dst, uint64_t capacity, uint64_t* count,
                                          mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& mesh = *checked(template_mesh, "template_mesh").mesh;
        const Call call(session);
        TemplateCheckOptions options;
        options.mirror = read_switch(mirror, "mirror");
        if (landmarks != nullptr)
            for (const Mark& mark : checked(landmarks, "landmarks").file.marks) {
                if (mark.where == Mark::Where::place)
                    fail(Status::invalid_argument,
                         "the landmark '%.60s' is a place; a template's are vertex numbers",
                         mark.name.c_str());
                if (mark.where == Mark::Where::vertex)
                    options.landmarks.push_back({mark.name, mark.vertex});
            }
        const std::string json =
            template_findings_json(check_template(mesh, options, call.context()));
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

}  // extern "C"
