// Part of mien.hpp: trained networks.
#ifndef MIEN_DETAIL_NETWORK_HPP
#define MIEN_DETAIL_NETWORK_HPP

#include <array>

#include "spectral.hpp"

namespace mien {

/// Face to code and back; copies share it.
class Network {
  public:
    using Motion = std::array<double, 12>;
    static Network load(const Session& session, const std::string& path) {
        mien_network* network = nullptr;
        detail::call(mien_network_load, session.get(), path.c_str(), &network);
        return Network(network);
    }
    static Network from_memory(const Session& session, const void* data, std::uint64_t size) {
        mien_network* network = nullptr;
        detail::call(mien_network_load_memory, session.get(), data, size, &network);
        return Network(network);
    }
    std::uint64_t vertex_count() const {
        std::uint64_t count = 0;
        detail::call(mien_network_get_counts, get(), &count, nullptr);
        return count;
    }
    std::uint64_t code_count() const {
        std::uint64_t count = 0;
        detail::call(mien_network_get_counts, get(), nullptr, &count);
        return count;
    }
    std::string json() const { return detail::read_text(mien_network_get_json, get()); }
    Mesh mean() const { return detail::make_mesh(mien_network_get_mean, get()); }

    /// `motion` (optional) receives the rigid motion onto the mean.
    std::vector<double> encode(const Session& session, const Mesh& face, Motion* motion = nullptr,
                               mien_cancel* cancel = nullptr) const {
        const mien_network_options options = options_of(cancel);
        std::vector<double> code(static_cast<std::size_t>(code_count()));
        std::uint64_t count = 0;
        detail::call(mien_network_encode, session.get(), get(), face.get(), &options,
                     motion != nullptr ? motion->data() : nullptr, code.data(),
                     std::uint64_t{code.size()}, &count);
        return code;
    }
    /// In the mean's frame, or where `motion` came from.
    Mesh decode(const Session& session, const std::vector<double>& code,
                const Motion* motion = nullptr, mien_cancel* cancel = nullptr) const {
        const mien_network_options options = options_of(cancel);
        return detail::make_mesh(mien_network_decode, session.get(), get(), code.data(),
                                 std::uint64_t{code.size()},
                                 motion != nullptr ? motion->data() : nullptr, &options);
    }
    /// decode(encode(face)) in the frame of the face; of a network that adds an expression: the
    /// face with it, `band_limit` as in mien_network_options.
    Mesh apply(const Session& session, const Mesh& face, mien_cancel* cancel = nullptr,
               std::int64_t band_limit = 0) const {
        mien_network_options options = options_of(cancel);
        options.band_limit = band_limit;
        return detail::make_mesh(mien_network_apply, session.get(), get(), face.get(), &options);
    }
    /// Numbers of the low band's code, which come first; all without bands.
    std::uint64_t low_code_count() const {
        std::uint64_t count = 0;
        detail::call(mien_network_get_bands, get(), &count, nullptr);
        return count;
    }
    /// Modes of the low band; -1 without bands.
    std::int64_t band_limit() const {
        std::int64_t limit = 0;
        detail::call(mien_network_get_bands, get(), nullptr, &limit);
        return limit;
    }
    /// Each band of a moved towards b's by its own weight, in the frame of a.
    Mesh mix(const Session& session, const Mesh& a, const Mesh& b, double low_weight,
             double high_weight, mien_cancel* cancel = nullptr) const {
        const mien_network_options options = options_of(cancel);
        return detail::make_mesh(mien_network_mix, session.get(), get(), a.get(), b.get(),
                                 low_weight, high_weight, &options);
    }
    /// The code of a made-up face.
    std::vector<double> sample(std::uint64_t seed, std::uint64_t number, double spread = 1) const {
        std::vector<double> code(static_cast<std::size_t>(code_count()));
        detail::call(mien_network_sample, get(), seed, number, spread, code.data(),
                     std::uint64_t{code.size()}, nullptr);
        return code;
    }
    struct Evaluation {
        bool neutral_only = false, perceptual = true;
        std::vector<std::int32_t> subjects;  ///< empty: all
        Progress progress;
        mien_cancel* cancel = nullptr;
    };
    /// JSON: errors over the faces of a dataset.
    std::string evaluate(const Session& session, const std::string& dataset_path,
                         const Evaluation& settings) const {
        mien_network_evaluation_options options;
        mien_network_evaluation_options_init(&options, sizeof options);
        options.neutral_only = settings.neutral_only ? 1 : 0;
        options.perceptual = settings.perceptual ? 1 : 0;
        options.subjects = settings.subjects.empty() ? nullptr : settings.subjects.data();
        options.subject_count = settings.subjects.size();
        options.cancel = settings.cancel;
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options);
        // The size is not known before the work is done, which should not be done twice.
        std::string text(std::size_t{1} << 16, '\0');
        std::uint64_t size = 0;
        for (;;) {
            const auto capacity = static_cast<std::uint64_t>(text.size());
            try {
                bridge.call(mien_network_evaluate, session.get(), get(), dataset_path.c_str(),
                            &options, &text[0], capacity, &size);
                break;
            } catch (const Exception& failure) {
                if (failure.status() != MIEN_E_BUFFER_TOO_SMALL || size <= capacity) throw;
                text.resize(static_cast<std::size_t>(size));
            }
        }
        text.resize(static_cast<std::size_t>(size) - 1);
        return text;
    }
    const mien_network* get() const noexcept { return handle_.get(); }

  private:
    explicit Network(mien_network* owned) : handle_(owned, mien_network_release) {}
    static mien_network_options options_of(mien_cancel* cancel) {
        mien_network_options options;
        mien_network_options_init(&options, sizeof options);
        options.cancel = cancel;
        return options;
    }
    std::shared_ptr<mien_network> handle_;
};

}  // namespace mien

#endif
