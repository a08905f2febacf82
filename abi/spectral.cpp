// Frequency bands and distances.
#include "spectral.hpp"
#include "arrays.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "session.hpp"
#include "spectral/metrics.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_spectral_basis_options default_basis_options() {
    mien_spectral_basis_options options{};
    options.mode_count = 500;
    return options;
}

SpectralBasisOptions basis_settings(const mien_spectral_basis_options& given) {
    SpectralBasisOptions settings;
    settings.num_modes = given.mode_count;
    check_choice(given.mass, MIEN_MASS_MIXED_VORONOI, MIEN_MASS_NONE, "options.mass");
    check_choice(given.cotangents, MIEN_COTANGENTS_INTRINSIC_DELAUNAY, MIEN_COTANGENTS_KEEP,
                 "options.cotangents");
    settings.with_mass = given.mass != MIEN_MASS_NONE;
    settings.laplacian.mass =
        given.mass == MIEN_MASS_BARYCENTRIC ? MassKind::barycentric : MassKind::mixed_voronoi;
    settings.laplacian.negative =
        given.cotangents == MIEN_COTANGENTS_KEEP    ? NegativeCotangents::keep
        : given.cotangents == MIEN_COTANGENTS_CLAMP ? NegativeCotangents::clamp
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

}  // namespace

extern "C" {

void MIEN_CALL mien_spectral_basis_options_init(mien_spectral_basis_options* options,
                                                size_t struct_size) {
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
        return new mien_spectral_basis(
            build_spectral_basis(mesh, basis_settings(given), call.context()));
    });
}

mien_status MIEN_CALL mien_spectral_basis_load(mien_session* session, const char* path,
                                               mien_spectral_basis** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_spectral_basis(
            load_spectral_basis(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_spectral_basis_save(mien_session* session,
                                               const mien_spectral_basis* basis, const char* path,
                                               mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        save_spectral_basis(checked_text(path, "path"), *checked(basis, "basis").data,
                            call.context());
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

mien_status MIEN_CALL mien_spectral_basis_get_eigenvalues(const mien_spectral_basis* basis,
                                                          double* dst, uint64_t capacity,
                                                          uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const Vector& values = checked(basis, "basis").data->values;
        copy_rows(values.data(), static_cast<uint64_t>(values.size()), sizeof(double), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_spectral_basis_get_vector(const mien_spectral_basis* basis,
                                                     uint64_t mode, double* dst, uint64_t capacity,
                                                     uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const SpectralBasis& data = *checked(basis, "basis").data;
        const Index rows = data.num_vertices(), modes = data.num_modes();
        if (mode >= static_cast<uint64_t>(modes))
            fail(Status::invalid_argument, "mode %llu of a basis with %lld",
                 static_cast<unsigned long long>(mode), static_cast<long long>(modes));
        if (!wants_copy(static_cast<uint64_t>(rows), dst, capacity, count)) return;
        Vector vector(rows);
        for (Index v = 0; v < rows; ++v) vector[v] = data.vectors[v * modes + as_index(mode)];
        copy_rows(vector.data(), static_cast<uint64_t>(rows), sizeof(double), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_spectral_basis_get_mass(const mien_spectral_basis* basis, double* dst,
                                                   uint64_t capacity, uint64_t* count,
                                                   mien_error* error) {
    return guarded(error, [&] {
        const Vector& mass = checked(basis, "basis").data->mass;
        copy_rows(mass.data(), static_cast<uint64_t>(mass.size()), sizeof(double), dst, capacity,
                  count);
    });
}

mien_status MIEN_CALL mien_spectral_basis_get_mean(const mien_spectral_basis* basis,
                                                   mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& mean = checked(basis, "basis").data->mean_mesh;
        return make_mesh(Points(mean.vertices), mean.triangles);
    });
}

void MIEN_CALL mien_spectral_basis_retain(mien_spectral_basis* basis) {
    retain(basis);
}
void MIEN_CALL mien_spectral_basis_release(mien_spectral_basis* basis) {
    release(basis);
}

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

mien_status MIEN_CALL mien_spectral_assemble(mien_session* session,
                                             const mien_spectral_basis* basis, const mien_mesh* low,
                                             const mien_mesh* high, uint64_t k, mien_mesh** out,
                                             mien_error* error) {
    return guarded_create(out, error, [&] {
        const SpectralBasis& data = *checked(basis, "basis").data;
        const TriMesh &first = *checked(low, "low").mesh, &second = *checked(high, "high").mesh;
        const Call call(session);
        return make_mesh(
            assemble(data, first.vertices, second.vertices, as_index(k), call.context()),
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
        return make_mesh(edit_bands(data, mesh.vertices, cuts,
                                    read_doubles(gains, limit_count + 1, "gains"), call.context()),
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
        return make_mesh(
            mix_bands(data, a.vertices, b.vertices, cuts,
                      read_doubles(weights, limit_count + 1, "weights"), call.context()),
            data.mean_mesh.triangles);
    });
}

mien_status MIEN_CALL mien_spectral_project(mien_session* session, const mien_spectral_basis* basis,
                                            const mien_mesh* face, uint64_t mode_count, double* dst,
                                            uint64_t capacity, uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const SpectralBasis& data = *checked(basis, "basis").data;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const Call call(session);
        const Index modes = std::min(as_index(mode_count), data.num_modes());
        if (mesh.vertices.rows() != data.num_vertices())
            fail(Status::mismatch, "the face has %lld vertices, the basis %lld",
                 static_cast<long long>(mesh.vertices.rows()),
                 static_cast<long long>(data.num_vertices()));
        if (!wants_copy(static_cast<uint64_t>(modes), dst, capacity, count) || modes == 0) return;
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
        const Points away = mesh.vertices - data.mean_mesh.vertices;
        const Rows rows = project(data, away, modes, call.context());
        copy_rows(rows.data(), static_cast<uint64_t>(modes), 3 * sizeof(double), dst, capacity,
                  count);
    });
}

mien_status MIEN_CALL mien_spectral_synthesize(mien_session* session,
                                               const mien_spectral_basis* basis,
                                               const double* coefficients, uint64_t row_count,
                                               uint64_t first_mode, mien_mesh** out,
                                               mien_error* error) {
    return guarded_create(out, error, [&] {
        const SpectralBasis& data = *checked(basis, "basis").data;
        const Call call(session);
        const auto modes = static_cast<uint64_t>(data.num_modes());
        if (first_mode > modes || row_count > modes - first_mode)
            fail(Status::invalid_argument, "%llu coefficients from mode %llu of a basis with %llu",
                 static_cast<unsigned long long>(row_count),
                 static_cast<unsigned long long>(first_mode),
                 static_cast<unsigned long long>(modes));
        check_array(coefficients, row_count, alignof(double), modes, "coefficients");
        Points face = data.mean_mesh.vertices;
        if (row_count != 0) {
            const Matrix rows = Eigen::Map<const Points>(coefficients, as_index(row_count), 3);
            for (Index j = 0; j < rows.rows(); ++j)
                if (!rows.row(j).allFinite())
                    fail_at(Status::invalid_argument, j, "coefficient %lld is not finite",
                            static_cast<long long>(j));
            face += synthesise(data, rows, as_index(first_mode), call.context());
        }
        return make_mesh(std::move(face), data.mean_mesh.triangles);
    });
}

mien_status MIEN_CALL mien_metric(mien_session* session, int32_t metric, const mien_mesh* reference,
                                  const mien_mesh* other, double* value, mien_error* error) {
    return guarded(error, [&] {
        const TriMesh &a = *checked(reference, "reference").mesh,
                      &b = *checked(other, "other").mesh;
        const Call call(session);
        if (value == nullptr) fail(Status::invalid_argument, "value is null");
        check_choice(metric, MIEN_METRIC_L1, MIEN_METRIC_FMPD, "metric");
        switch (metric) {
            case MIEN_METRIC_L1:
                store(value, l1_distance(a.vertices, b.vertices));
                break;
            case MIEN_METRIC_L2:
                store(value, l2_distance(a.vertices, b.vertices));
                break;
            case MIEN_METRIC_HAUSDORFF:
                store(value, hausdorff_distance(a, b, call.context()));
                break;
            case MIEN_METRIC_DAME:
                store(value, dame(a, b, call.context()));
                break;
            default:
                store(value, fmpd(a, b, call.context()));
                break;
        }
    });
}

mien_status MIEN_CALL mien_metric_field(mien_session* session, int32_t metric,
                                        const mien_mesh* reference, const mien_mesh* other,
                                        double* dst, uint64_t capacity, uint64_t* count,
                                        mien_error* error) {
    return guarded(error, [&] {
        const TriMesh &a = *checked(reference, "reference").mesh,
                      &b = *checked(other, "other").mesh;
        const Call call(session);
        check_choice(metric, MIEN_METRIC_L1, MIEN_METRIC_FMPD, "metric");
        const auto rows = static_cast<uint64_t>(a.vertices.rows());
        if (!wants_copy(rows, dst, capacity, count)) return;
        const Vector field =
            metric == MIEN_METRIC_L1 || metric == MIEN_METRIC_L2
                ? vertex_distances(a.vertices, b.vertices, metric == MIEN_METRIC_L1)
            : metric == MIEN_METRIC_HAUSDORFF ? surface_distances(a, b, call.context())
            : metric == MIEN_METRIC_DAME      ? dame_field(a, b, call.context())
                                              : fmpd_field(a, b, call.context());
        copy_rows(field.data(), rows, sizeof(double), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_metric_roughness(mien_session* session, const mien_mesh* mesh,
                                            double* dst, uint64_t capacity, uint64_t* count,
                                            mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& surface = *checked(mesh, "mesh").mesh;
        const Call call(session);
        const auto rows = static_cast<uint64_t>(surface.vertices.rows());
        if (!wants_copy(rows, dst, capacity, count)) return;
        const Vector field = local_roughness(surface, call.context());
        copy_rows(field.data(), rows, sizeof(double), dst, capacity, count);
    });
}

}  // extern "C"
