// Expression models and neutralization of the C++ face. Header-only; keeps no state of its own.
#ifndef MIEN_DETAIL_EXPRESSION_HPP
#define MIEN_DETAIL_EXPRESSION_HPP

#include "core.hpp"
#include "registration.hpp"

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
    /// Where the person may have been changed; must live until the call returns.
    void set_treated(const std::vector<std::uint32_t>& vertices) {
        treated = vertices.data();
        treated_count = vertices.size();
    }
};

/// mien_evaluate_options with its defaults.
struct EvaluateOptions : mien_evaluate_options {
    EvaluateOptions() { mien_evaluate_options_init(this, sizeof(mien_evaluate_options)); }
};

/// A trained model of identities and expressions; copies share it.
class ExpressionModel {
  public:
    static ExpressionModel train(const Session& session, const std::string& dataset_path,
                                 TrainOptions options = {}, const Progress& progress = {}) {
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_expression_model* model = nullptr;
        bridge.call(mien_expression_model_train, session.get(), dataset_path.c_str(), &options,
                    &model);
        return ExpressionModel(model);
    }
    /// From the bytes of a model file, which are copied.
    static ExpressionModel load_memory(const Session& session, const void* data, std::size_t size) {
        mien_expression_model* model = nullptr;
        detail::call(mien_expression_model_load_memory, session.get(), data, size, &model);
        return ExpressionModel(model);
    }
    /// Writes what part `part` of `part_count` of a dataset contributes to training.
    static void write_shard(const Session& session, const std::string& dataset_path, int part,
                            int part_count, const std::string& shard_path, int max_rank = 512,
                            const Progress& progress = {},
                            const std::vector<std::uint32_t>& stable_vertices = {}) {
        mien_shard_options options;
        mien_shard_options_init(&options, sizeof options);
        options.part = part;
        options.part_count = part_count;
        options.max_rank = max_rank;
        options.stable_vertices = stable_vertices.data();
        options.stable_count = stable_vertices.size();
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        bridge.call(mien_expression_shard_create, session.get(), dataset_path.c_str(), &options,
                    shard_path.c_str());
    }
    static ExpressionModel merge(const Session& session,
                                 const std::vector<std::string>& shard_paths,
                                 TrainOptions options = {}, const Progress& progress = {}) {
        std::vector<const char*> paths;
        paths.reserve(shard_paths.size());
        for (const std::string& path : shard_paths) paths.push_back(path.c_str());
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_expression_model* model = nullptr;
        bridge.call(mien_expression_model_merge, session.get(), paths.data(),
                    static_cast<std::uint32_t>(paths.size()), &options, &model);
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
        const mien_array_view who{identity.data(), identity.size(), sizeof(double), MIEN_DTYPE_F64,
                                  0};
        const mien_array_view what{expression.data(), expression.size(), sizeof(double),
                                   MIEN_DTYPE_F64, 0};
        mien_mesh* mesh = nullptr;
        detail::call(mien_expression_model_synthesize, session.get(), get(), &who, &what, &mesh);
        return Mesh(mesh);
    }

    /// A random face; `expression` is a name, or null for neutral.
    Mesh sample(const Session& session, std::uint64_t seed,
                const char* expression = nullptr) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_expression_model_sample, session.get(), get(), seed, expression, &mesh);
        return Mesh(mesh);
    }
    /// Table of neutralization errors over a dataset, as JSON text.
    std::string evaluate(const Session& session, const std::string& dataset_path,
                         EvaluateOptions options = {}, const Progress& progress = {}) const {
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_evaluation* evaluation = nullptr;
        bridge.call(mien_evaluate_neutralization, session.get(), get(), dataset_path.c_str(),
                    &options, &evaluation);
        const detail::Handle<mien_evaluation, mien_evaluation_release> owner(evaluation);
        return detail::read_text(mien_evaluation_get_json, evaluation);
    }

    mien_expression_model* get() const noexcept { return handle_.get(); }

  private:
    void adopt(mien_expression_model* owned) {
        handle_.reset(owned, mien_expression_model_release);
    }
    std::shared_ptr<mien_expression_model> handle_;
};

/// mien_series_options with its defaults.
struct SeriesOptions : mien_series_options {
    SeriesOptions() { mien_series_options_init(this, sizeof(mien_series_options)); }
    /// `values`, one per vertex, face by face, must live until the call returns.
    void set_weights(const std::vector<double>& values) {
        weights = {values.data(), values.size(), sizeof(double), MIEN_DTYPE_F64, 0};
    }
};

/// Several scans of one person, neutralized together.
class Series {
  public:
    Series(const Session& session, const ExpressionModel& model, const std::vector<Mesh>& faces,
           SeriesOptions options = {}, const Progress& progress = {}) {
        std::vector<const mien_mesh*> handles;
        handles.reserve(faces.size());
        for (const Mesh& face : faces) handles.push_back(face.get());
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_series* series = nullptr;
        bridge.call(mien_neutralize_series, session.get(), model.get(), handles.data(),
                    static_cast<std::uint32_t>(handles.size()), &options, &series);
        handle_.reset(series);
    }
    /// The person's shared neutral face, in the training's frame.
    Mesh identity() const { return at(-1); }
    /// The neutral face of one scan, in its frame.
    Mesh neutral(std::int32_t index) const { return at(index); }
    std::string json() const { return detail::read_text(mien_series_get_json, get()); }
    mien_series* get() const noexcept { return handle_.get(); }

  private:
    Mesh at(std::int32_t index) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_series_get_mesh, get(), index, &mesh);
        return Mesh(mesh);
    }
    detail::Handle<mien_series, mien_series_release> handle_;
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
        adopt(neutralization);
    }
    Neutralization(const Session& session, const ExpressionModel& model, const Registration& fitted,
                   NeutralizeOptions options = {}, const Progress& progress = {}) {
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_neutralization* neutralization = nullptr;
        bridge.call(mien_neutralize, session.get(), model.get(), fitted.get(), &options,
                    &neutralization);
        adopt(neutralization);
    }
    /// The scan that the face was fitted to, its own vertices moved; 0: the default distance.
    Mesh apply_to_scan(const Session& session, const Mesh& scan, double max_distance_mm = 0) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_neutralization_apply_to_scan, session.get(), get(), scan.get(),
                     max_distance_mm, &mesh);
        return Mesh(mesh);
    }
    /// This face's expression on the target's neutral face.
    Mesh transfer_to(const Session& session, const ExpressionModel& model,
                     const Neutralization& target) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_expression_model_transfer, session.get(), model.get(), get(),
                     target.get(), &mesh);
        return Mesh(mesh);
    }
    Mesh mesh() const { return Mesh::share(mien_neutralization_mesh(get())); }
    /// MIEN_READING_*; needs NeutralizeOptions::set_treated().
    mien_zone_reading reading(std::int32_t which) const {
        mien_zone_reading out{};
        out.struct_size = sizeof out;
        detail::call(mien_neutralization_get_reading, get(), which, &out);
        return out;
    }
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
    void adopt(mien_neutralization* neutralization) {
        handle_.reset(neutralization);
        std::uint32_t identity_modes = 0, expression_modes = 0;
        detail::call(mien_neutralization_get_counts, get(), nullptr, &identity_modes,
                     &expression_modes);
        identity_.resize(identity_modes);
        expression_.resize(expression_modes);
        detail::call(mien_neutralization_get_coordinates, get(), identity_.data(),
                     expression_.data());
    }

    detail::Handle<mien_neutralization, mien_neutralization_release> handle_;
    std::vector<double> identity_, expression_;
};

}  // namespace mien

#endif
