// Expression models and neutralization of the C++ face. Header-only; keeps no state of its own.
#ifndef MIEN_DETAIL_EXPRESSION_HPP
#define MIEN_DETAIL_EXPRESSION_HPP

#include "core.hpp"

namespace mien {

/// mien_train_options with its defaults.
struct TrainOptions : mien_train_options {
    TrainOptions() { mien_train_options_init(this, sizeof(mien_train_options)); }
};

/// mien_neutralize_options with its defaults.
struct NeutralizeOptions : mien_neutralize_options {
    NeutralizeOptions() { mien_neutralize_options_init(this, sizeof(mien_neutralize_options)); }
    /// `values`, one per vertex, must live until the call returns.
    void set_weights(const std::vector<double>& values) {
        weights = {values.data(), values.size(), sizeof(double), MIEN_DTYPE_F64, 0};
    }
};

/// A trained model of identities and expressions; copies share it.
class ExpressionModel {
  public:
    static ExpressionModel train(const Session& session, const std::string& dataset_path,
                                 TrainOptions options = {}, const Progress& progress = {}) {
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_expression_model* model = nullptr;
        bridge.call(mien_expression_model_train, session.get(), dataset_path.c_str(), &options, &model);
        return ExpressionModel(model);
    }
    ExpressionModel(const Session& session, const std::string& path) {
        mien_expression_model* model = nullptr;
        detail::call(mien_expression_model_load, session.get(), path.c_str(), &model);
        adopt(model);
    }
    /// Takes over one reference.
    explicit ExpressionModel(mien_expression_model* owned) { adopt(owned); }

    void save(const Session& session, const std::string& path) const {
        detail::call(mien_expression_model_save, session.get(), get(), path.c_str());
    }
    std::uint64_t vertex_count() const {
        std::uint64_t count = 0;
        detail::call(mien_expression_model_get_counts, get(), &count, nullptr, nullptr);
        return count;
    }
    std::uint32_t identity_modes() const {
        std::uint32_t count = 0;
        detail::call(mien_expression_model_get_counts, get(), nullptr, &count, nullptr);
        return count;
    }
    std::uint32_t expression_modes() const {
        std::uint32_t count = 0;
        detail::call(mien_expression_model_get_counts, get(), nullptr, nullptr, &count);
        return count;
    }
    std::string json() const { return detail::read_text(mien_expression_model_get_json, get()); }

    /// A face from coordinates in millimetres; an empty vector stands for the mean.
    Mesh synthesize(const Session& session, const std::vector<double>& identity,
                    const std::vector<double>& expression) const {
        const mien_array_view who{identity.data(), identity.size(), sizeof(double), MIEN_DTYPE_F64, 0};
        const mien_array_view what{expression.data(), expression.size(), sizeof(double), MIEN_DTYPE_F64,
                                   0};
        mien_mesh* mesh = nullptr;
        detail::call(mien_expression_model_synthesize, session.get(), get(), &who, &what, &mesh);
        return Mesh(mesh);
    }

    mien_expression_model* get() const noexcept { return handle_.get(); }

  private:
    void adopt(mien_expression_model* owned) { handle_.reset(owned, mien_expression_model_release); }
    std::shared_ptr<mien_expression_model> handle_;
};

/// A neutralized face.
class Neutralization {
  public:
    Neutralization(const Session& session, const ExpressionModel& model, const Mesh& face,
                   NeutralizeOptions options = {}, const Progress& progress = {}) {
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_neutralization* neutralization = nullptr;
        bridge.call(mien_neutralize_mesh, session.get(), model.get(), face.get(), &options,
                    &neutralization);
        handle_.reset(neutralization);
        identity_.resize(model.identity_modes());
        expression_.resize(model.expression_modes());
        detail::call(mien_neutralization_get_coordinates, get(), identity_.data(), expression_.data());
    }
    Mesh mesh() const { return Mesh::share(mien_neutralization_mesh(get())); }
    const std::vector<double>& identity() const noexcept { return identity_; }
    const std::vector<double>& expression() const noexcept { return expression_; }
    /// One deviation per vertex, mm; needs NeutralizeOptions::uncertainty = 1.
    std::vector<double> uncertainty() const {
        std::uint64_t count = 0;
        detail::call(mien_neutralization_get_uncertainty, get(), nullptr, std::uint64_t{0}, &count);
        std::vector<double> values(static_cast<std::size_t>(count));
        detail::call(mien_neutralization_get_uncertainty, get(), values.data(), count, &count);
        return values;
    }
    std::string json() const { return detail::read_text(mien_neutralization_get_json, get()); }
    mien_neutralization* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<mien_neutralization, mien_neutralization_release> handle_;
    std::vector<double> identity_, expression_;
};

}  // namespace mien

#endif
