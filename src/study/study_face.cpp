#include "study/study_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

void check_values(const Vector& values, Index count, std::size_t face, double highest,
                  const char* what) {
    if (values.size() == 0) return;
    if (values.size() != count)
        fail(Status::mismatch, "face %zu has %lld %s for %lld vertices", face,
             static_cast<long long>(values.size()), what, static_cast<long long>(count));
    for (Index v = 0; v < count; ++v)
        if (!(values[v] >= 0) || !(values[v] <= highest) || !std::isfinite(values[v]))
            fail_at(Status::invalid_argument, v, "%s %lld of face %zu is %g", what,
                    static_cast<long long>(v), face, values[v]);
}

}  // namespace

Vector normal_deviation_mm(const Vector& place_sd_mm, const Vector& weights,
                           const Vector& residual_mm, double noise_mm) {
    const Index n = place_sd_mm.size();
    if ((weights.size() != 0 && weights.size() != n && n != 0) ||
        (residual_mm.size() != 0 && residual_mm.size() != n && n != 0))
        fail(Status::mismatch, "%lld deviations, %lld weights, %lld residuals of one face",
             static_cast<long long>(n), static_cast<long long>(weights.size()),
             static_cast<long long>(residual_mm.size()));
    Vector sd = place_sd_mm;
    for (Index v = 0; v < n; ++v) {
        const double weight = weights.size() != 0 ? weights[v] : 1.0;
        const double residual = residual_mm.size() != 0 ? residual_mm[v] : 0.0;
        sd[v] = weight * std::min(std::hypot(noise_mm, residual), sd[v]) + (1 - weight) * sd[v];
    }
    return sd;
}

Vector change_deviation_mm(const StudyFace& face, const StudyFace& other, double apart_share) {
    Vector sd = face.normal_sd_mm;
    if (face.weights.size() == 0 || other.weights.size() == 0 || face.place_sd_mm.size() == 0)
        return sd;
    for (Index v = 0; v < sd.size(); ++v) {
        const double unseen = 1.0 - std::max(face.weights[v], other.weights[v]);
        sd[v] = std::max(0.0, sd[v] - (1.0 - apart_share) * unseen * face.place_sd_mm[v]);
    }
    return sd;
}

StudyFace study_face_of(std::shared_ptr<const TriMesh> mesh, const RegistrationResult& fit,
                        double noise_mm) {
    StudyFace face;
    face.mesh = std::move(mesh);
    face.weights = fit.weight;
    face.place_sd_mm = fit.confidence_mm;
    face.normal_sd_mm =
        normal_deviation_mm(fit.confidence_mm, fit.weight, fit.residual_mm, noise_mm);
    face.failed = fit.verdict.quality == FitQuality::failed;
    return face;
}

void check_study_faces(const std::vector<StudyFace>& faces) {
    if (faces.empty()) fail(Status::invalid_argument, "a study needs at least one face");
    const TriMesh& first = *faces.front().mesh;
    check_surface(first.vertices, first.triangles, "the first face");
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const StudyFace& face = faces[k];
        const Index n = face.mesh->vertices.rows();
        if (n != first.vertices.rows() || face.mesh->triangles.rows() != first.triangles.rows() ||
            face.mesh->triangles != first.triangles)
            fail(Status::mismatch,
                 "face %zu (%lld vertices) is not in the first face's topology (%lld vertices): "
                 "register all scans with one model",
                 k, static_cast<long long>(n), static_cast<long long>(first.vertices.rows()));
        if (!face.mesh->vertices.allFinite())
            fail(Status::invalid_mesh, "face %zu has a coordinate that is not finite", k);
        const double any = std::numeric_limits<double>::max();
        check_values(face.normal_sd_mm, n, k, any, "deviations along the normal");
        check_values(face.place_sd_mm, n, k, any, "deviations of the place");
        check_values(face.weights, n, k, 1.0, "weights");
        const int before = k == 0 ? -1 : faces[k - 1].visit;
        if (face.visit != before + 1 && (k == 0 || face.visit != before))
            fail(Status::invalid_argument,
                 "face %zu is of visit %d after one of visit %d; number visits 0, 1, 2 ... and "
                 "give them in that order",
                 k, face.visit, before);
    }
}

}  // namespace mien
