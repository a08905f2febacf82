// Registration of the C++ face.
#ifndef MIEN_DETAIL_REGISTRATION_HPP
#define MIEN_DETAIL_REGISTRATION_HPP

#include "model.hpp"

namespace mien {

/// A named place on a scan, in the scan's frame and unit.
struct ScanLandmark {
    std::string name;
    Position position;
};

/// The settings of mien_register_options: `c` holds its plain numbers, set to the defaults.
struct RegisterOptions {
    RegisterOptions() { mien_register_options_init(&c, sizeof c); }
    std::vector<ScanLandmark> landmarks;
    std::vector<double> scan_weights;  ///< one per scan vertex, or empty
    Progress progress;
    mien_cancel* cancel = nullptr;
    mien_register_options c;
};

namespace detail {

/// The options as a call takes them; borrows the settings.
struct RegisterCall {
    explicit RegisterCall(const RegisterOptions& settings) : c(settings.c) {
        for (const ScanLandmark& landmark : settings.landmarks)
            landmarks.push_back(
                {landmark.name.c_str(),
                 {landmark.position[0], landmark.position[1], landmark.position[2]}});
        c.landmarks = landmarks.data();
        c.landmark_count = landmarks.size();
        if (!settings.scan_weights.empty())
            c.scan_weights = {settings.scan_weights.data(), settings.scan_weights.size(), 0,
                              MIEN_DTYPE_F64, 0};
        c.cancel = settings.cancel;
    }
    RegisterCall(const RegisterCall&) = delete;
    RegisterCall& operator=(const RegisterCall&) = delete;

    std::vector<mien_scan_landmark> landmarks;
    mien_register_options c;
};

}  // namespace detail

/// The settings of mien_tie_options, set to the defaults.
struct TieOptions {
    TieOptions() { mien_tie_options_init(&c, sizeof c); }
    Progress progress;
    mien_cancel* cancel = nullptr;
    mien_tie_options c;
};

/// A fitted template; copies share it.
class Registration {
  public:
    /// Takes over one reference.
    explicit Registration(mien_registration* owned) : handle_(owned, mien_registration_release) {}
    Registration(const Session& session, const Model& model, const Mesh& scan,
                 const RegisterOptions& settings = {}) {
        detail::RegisterCall options(settings);
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options.c);
        mien_registration* registration = nullptr;
        bridge.call(mien_register, session.get(), model.get(), scan.get(), &options.c,
                    &registration);
        handle_ = std::shared_ptr<mien_registration>(registration, mien_registration_release);
    }

    /// What save() kept.
    Registration(const Session& session, const std::string& path) {
        mien_registration* registration = nullptr;
        detail::call(mien_registration_load, session.get(), path.c_str(), &registration);
        handle_ = std::shared_ptr<mien_registration>(registration, mien_registration_release);
    }
    /// A face that was fitted elsewhere; one value per vertex, or empty: not known; quality:
    /// MIEN_QUALITY_*.
    Registration(const Session& session, const Mesh& mesh, const std::vector<double>& weight,
                 const std::vector<double>& residual_mm,
                 const std::vector<double>& standard_deviation_mm, std::int32_t quality) {
        const auto view = [](const std::vector<double>& values) {
            return mien_array_view{values.data(), values.size(), sizeof(double), MIEN_DTYPE_F64, 0};
        };
        const mien_array_view w = view(weight), r = view(residual_mm),
                              s = view(standard_deviation_mm);
        mien_registration* registration = nullptr;
        detail::call(mien_registration_create, session.get(), mesh.get(),
                     weight.empty() ? nullptr : &w, residual_mm.empty() ? nullptr : &r,
                     standard_deviation_mm.empty() ? nullptr : &s, quality, &registration);
        handle_ = std::shared_ptr<mien_registration>(registration, mien_registration_release);
    }
    void save(const Session& session, const std::string& path) const {
        detail::call(mien_registration_save, session.get(), get(), path.c_str());
    }

    /// This later visit's fit tied to `reference` along the skin by the textures of both scans;
    /// when they do not agree its places are these, and json() says why.
    Registration tied_to(const Session& session, const Model& model, const Registration& reference,
                         const Mesh& reference_scan, const Mesh& scan,
                         const TieOptions& settings = {}) const {
        mien_tie_options options = settings.c;
        options.cancel = settings.cancel;
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options);
        mien_registration* tied = nullptr;
        bridge.call(mien_registration_tie, session.get(), model.get(), reference.get(),
                    reference_scan.get(), get(), scan.get(), &options, &tied);
        return Registration(tied);
    }

    /// The fitted template, scan frame, mm.
    Mesh mesh() const { return Mesh::share(mien_registration_mesh(get())); }
    mien_fit_verdict verdict() const {
        mien_fit_verdict out{};
        out.struct_size = sizeof out;
        detail::call(mien_registration_get_verdict, get(), &out);
        return out;
    }
    /// Of a zone of the model; null: of the whole face.
    mien_expected_error expected_error(const char* zone = nullptr) const {
        mien_expected_error out{};
        out.struct_size = sizeof out;
        detail::call(mien_registration_get_expected_error, get(), zone, &out);
        return out;
    }
    /// MIEN_REGISTRATION_RESIDUAL_MM and its kin, one value per template vertex.
    std::vector<double> field(std::int32_t field) const {
        std::uint64_t count = 0;
        detail::call(mien_registration_get_field, get(), field, nullptr, std::uint64_t{0}, &count);
        std::vector<double> values(static_cast<std::size_t>(count));
        detail::call(mien_registration_get_field, get(), field, values.data(), count, &count);
        return values;
    }
    /// For every template vertex: a triangle of the scan and the place in it.
    void correspondence(std::vector<std::uint32_t>& triangles,
                        std::vector<Position>& barycentric) const {
        std::uint64_t count = 0;
        detail::call(mien_registration_get_correspondence, get(), nullptr, nullptr,
                     std::uint64_t{0}, &count);
        triangles.resize(static_cast<std::size_t>(count));
        barycentric.resize(static_cast<std::size_t>(count));
        if (count != 0)
            detail::call(mien_registration_get_correspondence, get(), triangles.data(),
                         barycentric.front().data(), count, &count);
    }
    /// Row-major 4 x 4, template to scan.
    std::array<double, 16> motion() const {
        std::array<double, 16> matrix{};
        detail::call(mien_registration_get_motion, get(), matrix.data());
        return matrix;
    }
    std::string json() const { return detail::read_text(mien_registration_get_json, get()); }
    const mien_registration* get() const noexcept { return handle_.get(); }

  private:
    std::shared_ptr<mien_registration> handle_;
};

/// Nearest places of `points` on a surface, mm; a place farther than max_distance_mm (0: 10, below
/// 0: no limit) stays where it was.
inline std::vector<Position> transfer_points(const Session& session, const Mesh& surface,
                                             const std::vector<Position>& points,
                                             double max_distance_mm = 0) {
    std::vector<Position> places(points.size());
    if (points.empty()) return places;
    const mien_array_view view{points.data(), points.size(), sizeof(Position), MIEN_DTYPE_F64, 0};
    std::uint64_t count = 0;
    detail::call(mien_surface_transfer_points, session.get(), surface.get(), &view, max_distance_mm,
                 nullptr, nullptr, places.front().data(), std::uint64_t{places.size()}, &count);
    return places;
}

/// Vertices of `to` under a zone of `from`.
inline std::vector<std::uint32_t> transfer_zone(const Session& session, const Mesh& from,
                                                const std::vector<std::uint32_t>& vertices,
                                                const Mesh& to, double max_distance_mm = 0) {
    std::vector<std::uint32_t> inside(to.vertex_count());
    std::uint64_t count = 0;
    detail::call(mien_surface_transfer_zone, session.get(), from.get(), vertices.data(),
                 std::uint64_t{vertices.size()}, to.get(), max_distance_mm, inside.data(),
                 std::uint64_t{inside.size()}, &count);
    inside.resize(static_cast<std::size_t>(count));
    return inside;
}

/// A model's landmarks (MIEN_TRANSFER_LANDMARKS) or zones on a scan, as JSON text.
inline std::string transfer_json(const Session& session, const Model& model, const Mesh& fitted,
                                 const Mesh& scan, std::int32_t what, double max_distance_mm = 0) {
    std::uint64_t size = 0;
    detail::call(mien_surface_transfer_json, session.get(), model.get(), fitted.get(), scan.get(),
                 what, max_distance_mm, nullptr, std::uint64_t{0}, &size);
    std::string text(static_cast<std::size_t>(size), '\0');
    detail::call(mien_surface_transfer_json, session.get(), model.get(), fitted.get(), scan.get(),
                 what, max_distance_mm, &text[0], size, &size);
    text.resize(static_cast<std::size_t>(size) - 1);
    return text;
}

}  // namespace mien

#endif
