// What the classes do by themselves, for programs that mix C and C++: references to C handles,
// views without copies, versions. Header-only; keeps no state of its own.
#ifndef MIEN_DETAIL_LIFETIME_HPP
#define MIEN_DETAIL_LIFETIME_HPP

#include "core.hpp"

namespace mien {

/// The library's version, e.g. "0.1.0".
inline std::string version() {
    return mien_version_string();
}
/// The same as MAJOR * 1000000 + MINOR * 1000 + PATCH.
inline std::uint32_t version_number() noexcept {
    return mien_version_number();
}
/// What was built, for bug reports.
inline std::string build_id() {
    return mien_build_id();
}
/// The name of a status, e.g. "MIEN_E_IO".
inline std::string status_name(mien_status status) {
    return mien_status_name(status);
}

/// #V positions inside a mesh: no copy; the view keeps the mesh.
struct PositionsView {
    Mesh mesh;
    const double* data = nullptr;  ///< #V x 3, mm
    std::size_t count = 0;         ///< #V
};
inline PositionsView positions_view(const Mesh& mesh) {
    PositionsView view{mesh};
    std::uint64_t count = 0;
    detail::call(mien_mesh_positions_view, mesh.get(), &view.data, &count);
    view.count = static_cast<std::size_t>(count);
    return view;
}

/// A session with default options as a C handle.
inline std::shared_ptr<mien_session> default_session() {
    mien_session* session = nullptr;
    detail::call(mien_session_create, MIEN_ABI_VERSION, &session);
    return std::shared_ptr<mien_session>(session, mien_session_release);
}

/// One more reference to a C handle, given back with the last copy of the pointer; null stays null.
inline std::shared_ptr<mien_mesh> retained(mien_mesh* handle) {
    mien_mesh_retain(handle);
    return std::shared_ptr<mien_mesh>(handle, mien_mesh_release);
}
inline std::shared_ptr<mien_model> retained(mien_model* handle) {
    mien_model_retain(handle);
    return std::shared_ptr<mien_model>(handle, mien_model_release);
}
inline std::shared_ptr<mien_registration> retained(mien_registration* handle) {
    mien_registration_retain(handle);
    return std::shared_ptr<mien_registration>(handle, mien_registration_release);
}
inline std::shared_ptr<mien_expression_model> retained(mien_expression_model* handle) {
    mien_expression_model_retain(handle);
    return std::shared_ptr<mien_expression_model>(handle, mien_expression_model_release);
}
inline std::shared_ptr<mien_spectral_basis> retained(mien_spectral_basis* handle) {
    mien_spectral_basis_retain(handle);
    return std::shared_ptr<mien_spectral_basis>(handle, mien_spectral_basis_release);
}
inline std::shared_ptr<mien_blendshape_model> retained(mien_blendshape_model* handle) {
    mien_blendshape_model_retain(handle);
    return std::shared_ptr<mien_blendshape_model>(handle, mien_blendshape_model_release);
}
inline std::shared_ptr<mien_hierarchy> retained(mien_hierarchy* handle) {
    mien_hierarchy_retain(handle);
    return std::shared_ptr<mien_hierarchy>(handle, mien_hierarchy_release);
}
inline std::shared_ptr<mien_representation> retained(mien_representation* handle) {
    mien_representation_retain(handle);
    return std::shared_ptr<mien_representation>(handle, mien_representation_release);
}
inline std::shared_ptr<mien_score_model> retained(mien_score_model* handle) {
    mien_score_model_retain(handle);
    return std::shared_ptr<mien_score_model>(handle, mien_score_model_release);
}

}  // namespace mien

#endif
