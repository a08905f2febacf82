// The search over band limits of personalised blendshapes: L1 against FMPD and DAME of every k,
// beside the mean displacement, which knows nothing of the person.
#pragma once

#include <mien/mien.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mien::cli {

struct BandSearch {
    std::vector<mien_band_choice> choices;
    bool has_mean = false;  ///< false: the model came from a file, without its training faces
    mien_band_choice
        mean{};  ///< the training people's mean displacement added to each neutral face
};

/// `data`: what the model was trained on, for the mean displacement; empty: none.
BandSearch search_bands(const Session& session, const BlendshapeModel& model,
                        const SpectralBasis& basis, const std::string& data,
                        const std::string& validate, const std::string& expression,
                        const std::vector<std::uint64_t>& candidates,
                        const BlendshapeOptions& options);

/// A line for each k and for the mean displacement, on stdout.
void print_bands(const BandSearch& search);
/// {"search": [...], "mean_displacement": {...} or null}
nlohmann::json bands_json(const BandSearch& search);
/// L1 against FMPD and against DAME, each with its own Pareto front and the mean displacement.
void draw_bands(const std::string& path, const BandSearch& search, const std::string& expression);

}  // namespace mien::cli
