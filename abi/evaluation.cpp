#include "expression/evaluation.hpp"

#include "arrays.hpp"
#include "expression.hpp"
#include "expression/report_json.hpp"
#include "expression_options.hpp"
#include "guard.hpp"
#include "measure/volume.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_evaluate_options default_evaluate_options() {
    mien_evaluate_options options{};
    options.method = MIEN_FIT_MIXTURE;
    options.max_sweeps = 200;
    options.against_method = MIEN_FIT_ALTERNATING;
    options.against_max_sweeps = 3;
    return options;
}

EvaluationOptions evaluation_with(const EvaluationOptions& common, std::int32_t method,
                                  std::int32_t max_sweeps) {
    EvaluationOptions options = common;
    options.neutralize.fit.method = static_cast<FitMethod>(method);
    options.neutralize.fit.max_sweeps = max_sweeps;
    return options;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_evaluate_options_init(mien_evaluate_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_evaluate_options());
}

mien_status MIEN_CALL mien_evaluate_neutralization(mien_session* session,
                                                   const mien_expression_model* model,
                                                   const char* dataset_path,
                                                   const mien_evaluate_options* options,
                                                   mien_evaluation** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_evaluate_options given =
            read_options(options, default_evaluate_options(),
                         MIEN_FIRST_SIZE(mien_evaluate_options, cancel), "options");
        check_fit(given.method, "options.method");
        check_fit(given.against_method, "options.against_method");
        if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const ExpressionModel& data = *checked(model, "model").model;
        EvaluationOptions common;
        const FaceDataset dataset =
            FaceDataset::open(checked_text(dataset_path, "dataset_path"), {}, call.context());
        common.zone = read_vertices(given.zone_vertices, given.zone_count, dataset.num_vertices(),
                                    "options.zone_vertices");
        common.stable = read_vertices(given.stable_vertices, given.stable_count,
                                      dataset.num_vertices(), "options.stable_vertices");
        const std::vector<Zone> zones = read_zones(given.volume_zones, given.volume_zone_count,
                                                   dataset.num_vertices(), "options.volume_zones");
        for (const Zone& zone : zones) common.volume_names.push_back(zone.name);
        if (!zones.empty())
            common.volumes_ml = [&](const Points& neutral, const Points& face) {
                const VolumeReport report =
                    measure_volume(neutral, face, dataset.triangles(), zones, call.context());
                std::vector<double> volumes;
                for (const ZoneVolume& zone : report.zones)
                    volumes.push_back(zone.volume.absolute_ml);
                return volumes;
            };
        const EvaluatedFaces baseline = evaluate_faces(call.context(), dataset, common, nullptr);
        const EvaluatedFaces result = evaluate_model(
            call.context(), dataset, data, evaluation_with(common, given.method, given.max_sweeps));
        EvaluatedFaces other;
        if (given.against != nullptr) {
            // Progress is monotone within a call: the second model's share is not reported.
            Context quiet = call.context();
            quiet.progress_function = nullptr;
            other = evaluate_model(
                quiet, dataset, *checked(given.against, "options.against").model,
                evaluation_with(common, given.against_method, given.against_max_sweeps));
        }
        return new mien_evaluation(evaluation_json(dataset, baseline, result,
                                                   given.against != nullptr ? &other : nullptr,
                                                   common.volume_names));
    });
}

mien_status MIEN_CALL mien_evaluation_get_json(const mien_evaluation* evaluation, char* dst,
                                               uint64_t capacity, uint64_t* count,
                                               mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(evaluation, "evaluation").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_evaluation_release(mien_evaluation* evaluation) {
    release(evaluation);
}

}  // extern "C"
