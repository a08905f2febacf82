// Biomarker scores and statistics of the C++ face.
#ifndef MIEN_DETAIL_SCORE_HPP
#define MIEN_DETAIL_SCORE_HPP

#include "core.hpp"

namespace mien {

/// The settings of mien_score_options, vectors for its arrays.
struct ScoreSettings {
    ScoreSettings() { mien_score_options_init(&c, sizeof c); }
    mien_score_options c;  ///< its vertex sets, progress and cancel are set from what follows
    std::vector<std::uint32_t> zone, stable_zone;
    Progress progress;
};

/// A trained score; copies share it.
class ScoreModel {
  public:
    ScoreModel(const Session& session, const std::string& path) {
        mien_score_model* model = nullptr;
        detail::call(mien_score_model_load, session.get(), path.c_str(), &model);
        adopt(model);
    }
    static ScoreModel train(const Session& session, const std::string& dataset,
                            const std::vector<double>& grades, const ScoreSettings& settings = {}) {
        mien_score_options options = settings.c;
        options.zone_vertices = settings.zone.data();
        options.zone_count = settings.zone.size();
        options.stable_vertices = settings.stable_zone.data();
        options.stable_count = settings.stable_zone.size();
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options);
        mien_score_model* model = nullptr;
        bridge.call(mien_score_model_train, session.get(), dataset.c_str(), grades.data(),
                    std::uint64_t{grades.size()}, &options, &model);
        ScoreModel result;
        result.adopt(model);
        return result;
    }

    void save(const Session& session, const std::string& path) const {
        detail::call(mien_score_model_save, session.get(), get(), path.c_str());
    }
    mien_score_prediction predict(const Session& session, const Mesh& face) const {
        mien_score_prediction out{};
        out.struct_size = sizeof out;
        detail::call(mien_score_model_predict, session.get(), get(), face.get(), &out);
        return out;
    }
    /// face null: the training's mean face.
    Mesh simulate(const Session& session, const Mesh* face, double target) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_score_model_simulate, session.get(), get(),
                     face != nullptr ? face->get() : nullptr, target, &mesh);
        return Mesh(mesh);
    }
    /// mm per vertex; component -1: per unit of score.
    std::vector<double> latent(std::int32_t component) const {
        std::uint64_t count = 0;
        detail::call(mien_score_model_get_latent, get(), component, nullptr, std::uint64_t{0},
                     &count);
        std::vector<double> values(static_cast<std::size_t>(count));
        detail::call(mien_score_model_get_latent, get(), component, values.data(), count, &count);
        return values;
    }
    std::string json() const { return detail::read_text(mien_score_model_get_json, get()); }
    const mien_score_model* get() const noexcept { return handle_.get(); }

  private:
    ScoreModel() = default;
    void adopt(mien_score_model* model) {
        handle_ = std::shared_ptr<mien_score_model>(model, mien_score_model_release);
    }
    std::shared_ptr<mien_score_model> handle_;
};

namespace detail {

/// The two-call protocol for statistics: f(arguments..., dst, capacity, count, error).
template <typename Function, typename... Arguments>
std::string statistics_text(Function function, Arguments... arguments) {
    std::uint64_t size = 0;
    call(function, arguments..., nullptr, std::uint64_t{0}, &size);
    std::string text(static_cast<std::size_t>(size), '\0');
    call(function, arguments..., &text[0], size, &size);
    text.resize(static_cast<std::size_t>(size) - 1);
    return text;
}

}  // namespace detail

/// ratings: subject after subject, each with rater_count grades; negative: missing. JSON.
inline std::string rater_agreement(const Session& session, const std::vector<std::int32_t>& ratings,
                                   std::uint32_t rater_count, std::int32_t grade_count) {
    if (rater_count == 0 || ratings.size() % rater_count != 0)
        throw std::invalid_argument(
            "the number of ratings is not a multiple of the number of raters");
    return detail::statistics_text(mien_statistics_agreement, session.get(), ratings.data(),
                                   std::uint64_t{ratings.size() / rater_count}, rater_count,
                                   grade_count);
}

/// JSON; `blanks` are changes measured where nothing changed, and may be empty.
inline std::string repeatability(const Session& session, const std::vector<double>& values,
                                 const std::vector<std::int32_t>& subjects,
                                 const std::vector<double>& blanks = {}) {
    if (values.size() != subjects.size())
        throw std::invalid_argument("values and subjects differ in number");
    return detail::statistics_text(mien_statistics_repeatability, session.get(), values.data(),
                                   subjects.data(), std::uint64_t{values.size()}, blanks.data(),
                                   std::uint64_t{blanks.size()});
}

/// JSON.
inline std::string bland_altman(const Session& session, const std::vector<double>& first,
                                const std::vector<double>& second) {
    if (first.size() != second.size())
        throw std::invalid_argument("the two lists differ in length");
    return detail::statistics_text(mien_statistics_bland_altman, session.get(), first.data(),
                                   second.data(), std::uint64_t{first.size()});
}

}  // namespace mien

#endif
