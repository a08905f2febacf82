// Expressions carried over and predicted.
#include <algorithm>
#include <map>

#include "arrays.hpp"
#include "guard.hpp"
#include "learning/blendshapes.hpp"
#include "mesh/dataset.hpp"
#include "options.hpp"
#include "session.hpp"
#include "spectral.hpp"
#include "spectral/deformation_transfer.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_blendshape_model : Object {
    static constexpr Tag kTag = Tag::transfer;
    static constexpr const char* kName = "blendshape model";
    explicit mien_blendshape_model(std::shared_ptr<const BlendshapeModel> model)
        : Object(kTag), data(std::move(model)) {}
    const std::shared_ptr<const BlendshapeModel> data;
};

namespace {

/// The neutral face and one expression of every subject that has both.
struct DatasetPairs {
    FaceDataset data;
    std::vector<std::pair<Index, Index>> faces;
    FacePairs pairs() const {
        FacePairs result;
        result.count = static_cast<Index>(faces.size());
        result.pair = [this](Index k, Points& neutral, Points& expression) {
            data.face(faces[static_cast<std::size_t>(k)].first, neutral);
            data.face(faces[static_cast<std::size_t>(k)].second, expression);
        };
        return result;
    }
};

DatasetPairs open_pairs(const char* path, const char* expression, const Context& context) {
    DatasetPairs result{FaceDataset::open(checked_text(path, "dataset_path"), {}, context), {}};
    const std::string wanted = checked_text(expression, "expression");
    const auto& names = result.data.expression_names();
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end())
        fail(Status::not_found, "the dataset has no expression '%.80s'", wanted.c_str());
    if (result.data.neutral_expression() < 0)
        fail(Status::not_found, "the dataset marks no expression as neutral");
    const int number = static_cast<int>(found - names.begin());
    std::map<int, std::pair<Index, Index>> by_subject;
    for (Index k = 0; k < result.data.num_faces(); ++k) {
        auto& entry = by_subject.try_emplace(result.data.subject(k), -1, -1).first->second;
        if (result.data.expression(k) == result.data.neutral_expression()) entry.first = k;
        if (result.data.expression(k) == number) entry.second = k;
    }
    for (const auto& subject : by_subject)
        if (subject.second.first >= 0 && subject.second.second >= 0)
            result.faces.push_back(subject.second);
    return result;
}

mien_blendshape_options read_blendshape_options(const mien_blendshape_options* options) {
    const mien_blendshape_options given =
        read_options(options, mien_blendshape_options{},
                     MIEN_FIRST_SIZE(mien_blendshape_options, cancel), "options");
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    check_numbers({{"ridge", given.ridge}});
    return given;
}

}  // namespace

extern "C" {

mien_status MIEN_CALL mien_transfer_expression(mien_session* session,
                                               const mien_mesh* source_neutral,
                                               const mien_mesh* source_expression,
                                               const mien_mesh* target_neutral, mien_mesh** out,
                                               mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh &before = *checked(source_neutral, "source_neutral").mesh,
                      &after = *checked(source_expression, "source_expression").mesh,
                      &target = *checked(target_neutral, "target_neutral").mesh;
        const Call call(session);
        return make_mesh(DeformationTransfer(target, call.context())
                             .transfer(before.vertices, after.vertices, call.context()),
                         target.triangles);
    });
}

void MIEN_CALL mien_blendshape_options_init(mien_blendshape_options* options, size_t struct_size) {
    write_defaults(options, struct_size, mien_blendshape_options{});
}

mien_status MIEN_CALL mien_blendshape_model_train(mien_session* session, const char* dataset_path,
                                                  const char* expression,
                                                  const mien_blendshape_options* options,
                                                  mien_blendshape_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_blendshape_options given = read_blendshape_options(options);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const DatasetPairs data = open_pairs(dataset_path, expression, call.context());
        BlendshapeOptions settings;
        settings.ridge = given.ridge;
        return new mien_blendshape_model(
            BlendshapeModel::train(data.data.triangles(), data.pairs(), settings, call.context()));
    });
}

mien_status MIEN_CALL mien_blendshape_model_load(mien_session* session, const char* path,
                                                 mien_blendshape_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_blendshape_model(
            BlendshapeModel::load(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_blendshape_model_save(mien_session* session,
                                                 const mien_blendshape_model* model,
                                                 const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        checked(model, "model").data->save(checked_text(path, "path"), call.context());
    });
}

mien_status MIEN_CALL mien_blendshape_model_get_mean(const mien_blendshape_model* model,
                                                     mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& mean = checked(model, "model").data->mean();
        return make_mesh(Points(mean.vertices), mean.triangles);
    });
}

mien_status MIEN_CALL mien_blendshape_model_predict(mien_session* session,
                                                    const mien_blendshape_model* model,
                                                    const mien_spectral_basis* basis, uint64_t k,
                                                    const mien_mesh* neutral, mien_mesh** out,
                                                    mien_error* error) {
    return guarded_create(out, error, [&] {
        const BlendshapeModel& data = *checked(model, "model").data;
        const TriMesh& face = *checked(neutral, "neutral").mesh;
        const SpectralBasis* bands =
            basis != nullptr ? checked(basis, "basis").data.get() : nullptr;
        const Call call(session);
        BlendshapeModel::Prediction prediction = data.predict(face.vertices, call.context());
        if (bands == nullptr)
            return make_mesh(
                k == 0 ? std::move(prediction.differential) : std::move(prediction.spatial),
                data.mean().triangles);
        return make_mesh(assemble(*bands, prediction.spatial, prediction.differential, as_index(k),
                                  call.context()),
                         data.mean().triangles);
    });
}

mien_status MIEN_CALL mien_blendshape_model_search(
    mien_session* session, const mien_blendshape_model* model, const mien_spectral_basis* basis,
    const char* dataset_path, const char* expression, const uint64_t* candidates,
    uint32_t candidate_count, const mien_blendshape_options* options, mien_band_choice* choices,
    mien_error* error) {
    return guarded(error, [&] {
        const mien_blendshape_options given = read_blendshape_options(options);
        const BlendshapeModel& data = *checked(model, "model").data;
        const SpectralBasis& bands = *checked(basis, "basis").data;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        if (candidates == nullptr || choices == nullptr)
            fail(Status::invalid_argument, "candidates or choices is null");
        if (candidate_count < 1 || candidate_count > 10000)
            fail(Status::invalid_argument, "candidate_count is %u, allowed are 1 to 10000",
                 candidate_count);
        check_array(candidates, candidate_count, alignof(std::uint64_t), 10000, "candidates");
        check_output(choices, "choices");
        std::vector<Index> tried;
        for (std::uint32_t i = 0; i < candidate_count; ++i)
            tried.push_back(as_index(candidates[i]));
        const DatasetPairs faces = open_pairs(dataset_path, expression, call.context());
        const auto found = search_band_limit(data, bands, faces.pairs(), tried, call.context());
        for (std::uint32_t i = 0; i < candidate_count; ++i)
            choices[i] = {candidates[i],
                          found[i].l1_mm,
                          found[i].dame,
                          found[i].fmpd,
                          found[i].on_front ? 1 : 0,
                          found[i].chosen ? 1 : 0};
    });
}

void MIEN_CALL mien_blendshape_model_retain(mien_blendshape_model* model) {
    retain(model);
}
void MIEN_CALL mien_blendshape_model_release(mien_blendshape_model* model) {
    release(model);
}

}  // extern "C"
