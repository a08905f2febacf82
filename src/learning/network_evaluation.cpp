#include "learning/network_evaluation.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "spectral/metrics.hpp"

namespace mien {

double ReconstructionErrors::mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

std::vector<Index> chosen_faces(const FaceDataset& data, const std::vector<std::int32_t>& subjects,
                                bool neutral_only) {
    std::vector<Index> faces;
    for (Index k = 0; k < data.num_faces(); ++k) {
        const bool listed = subjects.empty() || std::find(subjects.begin(), subjects.end(),
                                                          data.subject(k)) != subjects.end();
        if (listed && (!neutral_only || data.expression(k) == data.neutral_expression()))
            faces.push_back(k);
    }
    return faces;
}

ReconstructionErrors reconstruction_errors(const FaceDataset& data, const std::vector<Index>& faces,
                                           const Reconstruct& reconstruct, bool perceptual,
                                           const Context& context) {
    if (faces.empty())
        fail(Status::not_found, "the dataset has no face of the subjects and kind asked for");
    ReconstructionErrors errors;
    TriMesh truth, made;
    truth.triangles = made.triangles = data.triangles();
    for (std::size_t k = 0; k < faces.size(); ++k) {
        context.progress(Stage::measuring,
                         static_cast<double>(k) / static_cast<double>(faces.size()));
        data.face(faces[k], truth.vertices);
        made.vertices = reconstruct(truth.vertices);
        errors.l1_mm.push_back(l1_distance(truth.vertices, made.vertices));
        errors.l2_mm.push_back(l2_distance(truth.vertices, made.vertices));
        if (!perceptual) continue;
        errors.dame.push_back(dame(truth, made, context));
        errors.fmpd.push_back(fmpd(truth, made, context));
    }
    context.progress(Stage::measuring, 1);
    return errors;
}

std::string reconstruction_json(const ReconstructionErrors& errors) {
    JsonText json;
    json.begin_object().field("faces", errors.l1_mm.size());
    const auto add = [&](const char* name, const std::vector<double>& values) {
        if (values.empty()) return;
        json.field(name, ReconstructionErrors::mean(values));
        json.field(std::string(name) + "_by_face", values);
    };
    add("l1_mm", errors.l1_mm);
    add("l2_mm", errors.l2_mm);
    add("dame", errors.dame);
    add("fmpd", errors.fmpd);
    json.end_object();
    return json.take();
}

}  // namespace mien
