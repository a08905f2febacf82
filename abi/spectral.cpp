#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "arrays.hpp"
#include "guard.hpp"
#include "mesh.hpp"
#include "mesh/dataset.hpp"
#include "options.hpp"
#include "session.hpp"
#include "spectral/blendshapes.hpp"
#include "spectral/deformation_transfer.hpp"
#include "spectral/hierarchy.hpp"
#include "spectral/metrics.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_spectral_basis : Object {
    static constexpr Tag kTag = Tag::spectral_basis;
    static constexpr const char* kName = "spectral basis";
    explicit mien_spectral_basis(std::shared_ptr<const SpectralBasis> basis)
        : Object(kTag), data(std::move(basis)) {}
    const std::shared_ptr<const SpectralBasis> data;
};

struct mien_representation : Object {
    static constexpr Tag kTag = Tag::representation;
    static constexpr const char* kName = "representation";
    explicit mien_representation(std::shared_ptr<const FaceFeatures> features)
        : Object(kTag), data(std::move(features)) {}
    const std::shared_ptr<const FaceFeatures> data;
};

struct mien_hierarchy : Object {
    static constexpr Tag kTag = Tag::hierarchy;
    static constexpr const char* kName = "hierarchy";
    explicit mien_hierarchy(std::shared_ptr<const MeshHierarchy> hierarchy)
        : Object(kTag), data(std::move(hierarchy)) {}
    const std::shared_ptr<const MeshHierarchy> data;
};

struct mien_blendshape_model : Object {
    static constexpr Tag kTag = Tag::transfer;
    static constexpr const char* kName = "blendshape model";
    explicit mien_blendshape_model(std::shared_ptr<const BlendshapeModel> model)
        : Object(kTag), data(std::move(model)) {}
    const std::shared_ptr<const BlendshapeModel> data;
};

namespace {

mien_mesh* make_mesh(Points&& vertices, const Triangles& triangles) {
    auto mesh = std::make_shared<TriMesh>();
    mesh->vertices = std::move(vertices);
    mesh->triangles = triangles;
    return new mien_mesh(std::shared_ptr<const TriMesh>(std::move(mesh)));
}

Index as_index(std::uint64_t value) {
    return static_cast<Index>(std::min<std::uint64_t>(value, std::numeric_limits<std::int32_t>::max()));
}

mien_spectral_basis_options default_basis_options() {
    mien_spectral_basis_options options{};
    options.mode_count = 500;
    return options;
}

SpectralBasisOptions basis_settings(const mien_spectral_basis_options& given) {
    SpectralBasisOptions settings;
    settings.num_modes = given.mode_count;
    if (given.mass < MIEN_MASS_MIXED_VORONOI || given.mass > MIEN_MASS_NONE)
        fail(Status::unsupported_option, "options.mass is %d", given.mass);
    if (given.cotangents < MIEN_COTANGENTS_INTRINSIC_DELAUNAY || given.cotangents > MIEN_COTANGENTS_KEEP)
        fail(Status::unsupported_option, "options.cotangents is %d", given.cotangents);
    settings.with_mass = given.mass != MIEN_MASS_NONE;
    settings.laplacian.mass =
        given.mass == MIEN_MASS_BARYCENTRIC ? MassKind::barycentric : MassKind::mixed_voronoi;
    settings.laplacian.negative = given.cotangents == MIEN_COTANGENTS_KEEP ? NegativeCotangents::keep
                                  : given.cotangents == MIEN_COTANGENTS_CLAMP
                                      ? NegativeCotangents::clamp
                                      : NegativeCotangents::intrinsic_delaunay;
    return settings;
}

std::vector<Index> read_limits(const std::uint64_t* limits, std::uint64_t count) {
    check_array(limits, count, alignof(std::uint64_t), 1000000, "limits");
    std::vector<Index> result;
    for (std::uint64_t i = 0; i < count; ++i) result.push_back(as_index(limits[i]));
    return result;
}

Vector read_doubles(const double* values, std::uint64_t count, const char* name) {
    if (values == nullptr) fail(Status::invalid_argument, "%s is null", name);
    if (reinterpret_cast<std::uintptr_t>(values) % alignof(double) != 0)
        fail(Status::invalid_argument, "%s is misaligned", name);
    return Eigen::Map<const Vector>(values, static_cast<Index>(count));
}

std::optional<Similarity> read_motion(const double* motion) {
    if (motion == nullptr) return std::nullopt;
    Similarity result;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) result.rotation(r, c) = motion[3 * r + c];
    result.translation = Vector3(motion[9], motion[10], motion[11]);
    if (!result.rotation.allFinite() || !result.translation.allFinite() ||
        !(result.rotation * result.rotation.transpose()).isIdentity(1e-6))
        fail(Status::invalid_argument, "motion is not a rotation and a translation");
    return result;
}

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

const MeshLevel& level_of(const MeshHierarchy& hierarchy, std::uint32_t level) {
    if (level >= hierarchy.levels.size())
        fail(Status::invalid_argument, "level %u of a hierarchy with %zu", level, hierarchy.levels.size());
    return hierarchy.levels[level];
}

mien_blendshape_options read_blendshape_options(const mien_blendshape_options* options) {
    const mien_blendshape_options given = read_options(
        options, mien_blendshape_options{}, MIEN_FIRST_SIZE(mien_blendshape_options, cancel), "options");
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    check_numbers({{"ridge", given.ridge}});
    return given;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_spectral_basis_options_init(mien_spectral_basis_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_basis_options());
}

mien_status MIEN_CALL mien_spectral_basis_build(mien_session* session, const mien_mesh* mean,
                                                const mien_spectral_basis_options* options,
                                                mien_spectral_basis** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_spectral_basis_options given =
            read_options(options, default_basis_options(),
                         MIEN_FIRST_SIZE(mien_spectral_basis_options, cancel), "options");
        const TriMesh& mesh = *checked(mean, "mean").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        return new mien_spectral_basis(build_spectral_basis(mesh, basis_settings(given), call.context()));
    });
}

mien_status MIEN_CALL mien_spectral_basis_load(mien_session* session, const char* path,
                                               mien_spectral_basis** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_spectral_basis(load_spectral_basis(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_spectral_basis_save(mien_session* session, const mien_spectral_basis* basis,
                                               const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        save_spectral_basis(checked_text(path, "path"), *checked(basis, "basis").data, call.context());
    });
}

mien_status MIEN_CALL mien_spectral_basis_get_counts(const mien_spectral_basis* basis,
                                                     uint64_t* vertex_count, uint64_t* mode_count,
                                                     mien_error* error) {
    return guarded(error, [&] {
        const SpectralBasis& data = *checked(basis, "basis").data;
        store(vertex_count, data.num_vertices());
        store(mode_count, data.num_modes());
    });
}

mien_status MIEN_CALL mien_spectral_basis_get_eigenvalues(const mien_spectral_basis* basis, double* dst,
                                                          uint64_t capacity, uint64_t* count,
                                                          mien_error* error) {
    return guarded(error, [&] {
        const Vector& values = checked(basis, "basis").data->values;
        copy_rows(values.data(), static_cast<uint64_t>(values.size()), sizeof(double), dst, capacity, count);
    });
}

void MIEN_CALL mien_spectral_basis_retain(mien_spectral_basis* basis) { retain(basis); }
void MIEN_CALL mien_spectral_basis_release(mien_spectral_basis* basis) { release(basis); }

mien_status MIEN_CALL mien_spectral_split(mien_session* session, const mien_spectral_basis* basis,
                                          const mien_mesh* face, uint64_t k, mien_mesh** low,
                                          mien_mesh** high, mien_error* error) {
    return guarded(error, [&] {
        store(low, nullptr);
        store(high, nullptr);
        const SpectralBasis& data = *checked(basis, "basis").data;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const Call call(session);
        Points lower = low_band(data, mesh.vertices, as_index(k), call.context());
        // The rest, so that the two add up to the face to the last bit that double allows.
        Points higher = data.mean_mesh.vertices + (mesh.vertices - lower);
        struct Guard {
            mien_mesh* mesh = nullptr;
            ~Guard() { release(mesh); }
        } first;
        if (low != nullptr) first.mesh = make_mesh(std::move(lower), data.mean_mesh.triangles);
        if (high != nullptr) store(high, make_mesh(std::move(higher), data.mean_mesh.triangles));
        store(low, first.mesh);
        first.mesh = nullptr;
    });
}

mien_status MIEN_CALL mien_spectral_assemble(mien_session* session, const mien_spectral_basis* basis,
                                             const mien_mesh* low, const mien_mesh* high, uint64_t k,
                                             mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const SpectralBasis& data = *checked(basis, "basis").data;
        const TriMesh &first = *checked(low, "low").mesh, &second = *checked(high, "high").mesh;
        const Call call(session);
        return make_mesh(assemble(data, first.vertices, second.vertices, as_index(k), call.context()),
                         data.mean_mesh.triangles);
    });
}

mien_status MIEN_CALL mien_spectral_edit(mien_session* session, const mien_spectral_basis* basis,
                                         const mien_mesh* face, const uint64_t* limits,
                                         uint64_t limit_count, const double* gains, mien_mesh** out,
                                         mien_error* error) {
    return guarded_create(out, error, [&] {
        const SpectralBasis& data = *checked(basis, "basis").data;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const Call call(session);
        const std::vector<Index> cuts = read_limits(limits, limit_count);
        return make_mesh(edit_bands(data, mesh.vertices, cuts, read_doubles(gains, limit_count + 1, "gains"),
                                    call.context()),
                         data.mean_mesh.triangles);
    });
}

mien_status MIEN_CALL mien_spectral_mix(mien_session* session, const mien_spectral_basis* basis,
                                        const mien_mesh* first, const mien_mesh* second,
                                        const uint64_t* limits, uint64_t limit_count,
                                        const double* weights, mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const SpectralBasis& data = *checked(basis, "basis").data;
        const TriMesh &a = *checked(first, "first").mesh, &b = *checked(second, "second").mesh;
        const Call call(session);
        const std::vector<Index> cuts = read_limits(limits, limit_count);
        return make_mesh(mix_bands(data, a.vertices, b.vertices, cuts,
                                   read_doubles(weights, limit_count + 1, "weights"), call.context()),
                         data.mean_mesh.triangles);
    });
}

mien_status MIEN_CALL mien_metric(mien_session* session, int32_t metric, const mien_mesh* reference,
                                  const mien_mesh* other, double* value, mien_error* error) {
    return guarded(error, [&] {
        const TriMesh &a = *checked(reference, "reference").mesh, &b = *checked(other, "other").mesh;
        const Call call(session);
        if (value == nullptr) fail(Status::invalid_argument, "value is null");
        switch (metric) {
            case MIEN_METRIC_L1: store(value, l1_distance(a.vertices, b.vertices)); break;
            case MIEN_METRIC_L2: store(value, l2_distance(a.vertices, b.vertices)); break;
            case MIEN_METRIC_HAUSDORFF: store(value, hausdorff_distance(a, b, call.context())); break;
            case MIEN_METRIC_DAME: store(value, dame(a, b, call.context())); break;
            case MIEN_METRIC_FMPD: store(value, fmpd(a, b, call.context())); break;
            default: fail(Status::invalid_argument, "metric is %d, allowed are 1 to 5", metric);
        }
    });
}

mien_status MIEN_CALL mien_representation_train(mien_session* session, const char* dataset_path,
                                                int32_t kind, int32_t neutral_only,
                                                mien_representation** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        if (neutral_only != 0 && neutral_only != 1)
            fail(Status::invalid_argument, "neutral_only is %d, allowed are 0 and 1", neutral_only);
        const FaceDataset data =
            FaceDataset::open(checked_text(dataset_path, "dataset_path"), {}, call.context());
        std::vector<Index> chosen;
        for (Index k = 0; k < data.num_faces(); ++k)
            if (neutral_only == 0 || data.expression(k) == data.neutral_expression()) chosen.push_back(k);
        if (chosen.empty()) fail(Status::not_found, "the dataset has no neutral face");
        FaceSource source;
        source.count = static_cast<Index>(chosen.size());
        source.face = [&](Index k, Points& face) { data.face(chosen[static_cast<std::size_t>(k)], face); };
        return new mien_representation(FaceFeatures::train(
            data.triangles(), source, static_cast<FeatureKind>(kind), call.context()));
    });
}

mien_status MIEN_CALL mien_representation_load(mien_session* session, const char* path,
                                               mien_representation** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_representation(FaceFeatures::load(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_representation_save(mien_session* session,
                                               const mien_representation* representation, const char* path,
                                               mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        checked(representation, "representation").data->save(checked_text(path, "path"), call.context());
    });
}

mien_status MIEN_CALL mien_representation_get_counts(const mien_representation* representation,
                                                     uint64_t* vertex_count, uint64_t* channel_count,
                                                     mien_error* error) {
    return guarded(error, [&] {
        const FaceFeatures& data = *checked(representation, "representation").data;
        store(vertex_count, data.num_vertices());
        store(channel_count, data.num_channels());
    });
}

mien_status MIEN_CALL mien_representation_encode(mien_session* session,
                                                 const mien_representation* representation,
                                                 const mien_mesh* face, double* motion, double* dst,
                                                 uint64_t capacity, uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const FaceFeatures& data = *checked(representation, "representation").data;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const Call call(session);
        const auto rows = static_cast<uint64_t>(data.num_vertices());
        const std::size_t row_bytes = static_cast<std::size_t>(data.num_channels()) * sizeof(double);
        if (dst == nullptr || capacity < rows) {  // the count needs no work
            copy_rows(nullptr, rows, row_bytes, dst, capacity, count);
            return;
        }
        check_output(motion, "motion");
        Similarity onto_mean;
        const Features features = data.encode(mesh.vertices, &onto_mean, call.context());
        copy_rows(features.data(), rows, row_bytes, dst, capacity, count);
        if (motion != nullptr) {
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) motion[3 * r + c] = onto_mean.rotation(r, c);
            for (int r = 0; r < 3; ++r) motion[9 + r] = onto_mean.translation[r];
        }
    });
}

mien_status MIEN_CALL mien_representation_decode(mien_session* session,
                                                 const mien_representation* representation,
                                                 const double* features, uint64_t row_count,
                                                 const double* motion, mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const FaceFeatures& data = *checked(representation, "representation").data;
        const Call call(session);
        if (row_count != static_cast<uint64_t>(data.num_vertices()))
            fail(Status::mismatch, "row_count is %llu, the representation has %lld vertices",
                 static_cast<unsigned long long>(row_count), static_cast<long long>(data.num_vertices()));
        if (features == nullptr) fail(Status::invalid_argument, "features is null");
        if (reinterpret_cast<std::uintptr_t>(features) % alignof(double) != 0 ||
            reinterpret_cast<std::uintptr_t>(motion) % alignof(double) != 0)
            fail(Status::invalid_argument, "features or motion is misaligned");
        const Features given =
            Eigen::Map<const Features>(features, data.num_vertices(), data.num_channels());
        const std::optional<Similarity> onto_mean = read_motion(motion);
        return make_mesh(data.decode(given, onto_mean ? &*onto_mean : nullptr, call.context()),
                         data.mean().triangles);
    });
}

void MIEN_CALL mien_representation_retain(mien_representation* representation) { retain(representation); }
void MIEN_CALL mien_representation_release(mien_representation* representation) { release(representation); }

mien_status MIEN_CALL mien_hierarchy_build_quadric(mien_session* session, const mien_mesh* mesh,
                                                   uint32_t level_count, double factor,
                                                   mien_hierarchy** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        return new mien_hierarchy(quadric_hierarchy(data, level_count, factor, call.context()));
    });
}

mien_status MIEN_CALL mien_hierarchy_build_connectivity(mien_session* session, const mien_mesh* mesh,
                                                        uint32_t level_count, uint32_t stride,
                                                        uint32_t radius, mien_hierarchy** out,
                                                        mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        return new mien_hierarchy(
            connectivity_hierarchy(data, level_count, stride, radius, call.context()));
    });
}

mien_status MIEN_CALL mien_hierarchy_load(mien_session* session, const char* path, mien_hierarchy** out,
                                          mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_hierarchy(load_mesh_hierarchy(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_hierarchy_save(mien_session* session, const mien_hierarchy* hierarchy,
                                          const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        save_mesh_hierarchy(checked_text(path, "path"), *checked(hierarchy, "hierarchy").data,
                            call.context());
    });
}

mien_status MIEN_CALL mien_hierarchy_get_level_count(const mien_hierarchy* hierarchy,
                                                     uint32_t* level_count, mien_error* error) {
    return guarded(error, [&] {
        const MeshHierarchy& data = *checked(hierarchy, "hierarchy").data;
        if (level_count == nullptr) fail(Status::invalid_argument, "level_count is null");
        store(level_count, data.levels.size());
    });
}

mien_status MIEN_CALL mien_hierarchy_get_level(const mien_hierarchy* hierarchy, uint32_t level,
                                               mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const MeshLevel& data = level_of(*checked(hierarchy, "hierarchy").data, level);
        return make_mesh(Points(data.mesh.vertices), data.mesh.triangles);
    });
}

mien_status MIEN_CALL mien_hierarchy_apply(const mien_hierarchy* hierarchy, uint32_t level,
                                           int32_t direction, const double* values, uint64_t row_count,
                                           uint64_t channel_count, double* dst, uint64_t capacity,
                                           uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const MeshLevel& data = level_of(*checked(hierarchy, "hierarchy").data, level);
        if (level == 0) fail(Status::invalid_argument, "level 0 has no maps; level names the coarser one");
        if (direction != MIEN_MAP_DOWN && direction != MIEN_MAP_UP)
            fail(Status::invalid_argument, "direction is %d, allowed are 1 and 2", direction);
        const RowSparse& map = direction == MIEN_MAP_DOWN ? data.down : data.up;
        if (channel_count < 1 || channel_count > 4096)
            fail(Status::invalid_argument, "channel_count is %llu, allowed are 1 to 4096",
                 static_cast<unsigned long long>(channel_count));
        const auto rows = static_cast<uint64_t>(map.rows());
        const std::size_t row_bytes = static_cast<std::size_t>(channel_count) * sizeof(double);
        if (dst == nullptr || capacity < rows) {
            copy_rows(nullptr, rows, row_bytes, dst, capacity, count);
            return;
        }
        if (row_count != static_cast<uint64_t>(map.cols()))
            fail(Status::mismatch, "row_count is %llu, the map takes %lld",
                 static_cast<unsigned long long>(row_count), static_cast<long long>(map.cols()));
        if (values == nullptr || reinterpret_cast<std::uintptr_t>(values) % alignof(double) != 0)
            fail(Status::invalid_argument, "values is null or misaligned");
        const Eigen::Map<const Features> from(values, map.cols(), static_cast<Index>(channel_count));
        const Features to = map * from;
        copy_rows(to.data(), rows, row_bytes, dst, capacity, count);
    });
}

void MIEN_CALL mien_hierarchy_retain(mien_hierarchy* hierarchy) { retain(hierarchy); }
void MIEN_CALL mien_hierarchy_release(mien_hierarchy* hierarchy) { release(hierarchy); }

mien_status MIEN_CALL mien_transfer_expression(mien_session* session, const mien_mesh* source_neutral,
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

mien_status MIEN_CALL mien_blendshape_model_save(mien_session* session, const mien_blendshape_model* model,
                                                 const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        checked(model, "model").data->save(checked_text(path, "path"), call.context());
    });
}

mien_status MIEN_CALL mien_blendshape_model_get_mean(const mien_blendshape_model* model, mien_mesh** out,
                                                     mien_error* error) {
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
        const SpectralBasis* bands = basis != nullptr ? checked(basis, "basis").data.get() : nullptr;
        const Call call(session);
        BlendshapeModel::Prediction prediction = data.predict(face.vertices, call.context());
        if (bands == nullptr)
            return make_mesh(k == 0 ? std::move(prediction.differential) : std::move(prediction.spatial),
                             data.mean().triangles);
        return make_mesh(assemble(*bands, prediction.spatial, prediction.differential, as_index(k),
                                  call.context()),
                         data.mean().triangles);
    });
}

mien_status MIEN_CALL mien_blendshape_model_search(
    mien_session* session, const mien_blendshape_model* model, const mien_spectral_basis* basis,
    const char* dataset_path, const char* expression, const uint64_t* candidates, uint32_t candidate_count,
    const mien_blendshape_options* options, mien_band_choice* choices, mien_error* error) {
    return guarded(error, [&] {
        const mien_blendshape_options given = read_blendshape_options(options);
        const BlendshapeModel& data = *checked(model, "model").data;
        const SpectralBasis& bands = *checked(basis, "basis").data;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        if (candidates == nullptr || choices == nullptr)
            fail(Status::invalid_argument, "candidates or choices is null");
        if (candidate_count < 1 || candidate_count > 10000)
            fail(Status::invalid_argument, "candidate_count is %u, allowed are 1 to 10000", candidate_count);
        check_array(candidates, candidate_count, alignof(std::uint64_t), 10000, "candidates");
        check_output(choices, "choices");
        std::vector<Index> tried;
        for (std::uint32_t i = 0; i < candidate_count; ++i) tried.push_back(as_index(candidates[i]));
        const DatasetPairs faces = open_pairs(dataset_path, expression, call.context());
        const auto found = search_band_limit(data, bands, faces.pairs(), tried, call.context());
        for (std::uint32_t i = 0; i < candidate_count; ++i)
            choices[i] = {candidates[i], found[i].l1_mm, found[i].dame, found[i].fmpd,
                          found[i].on_front ? 1 : 0, found[i].chosen ? 1 : 0};
    });
}

void MIEN_CALL mien_blendshape_model_retain(mien_blendshape_model* model) { retain(model); }
void MIEN_CALL mien_blendshape_model_release(mien_blendshape_model* model) { release(model); }

}  // extern "C"
