// Personalised blendshapes (kosk-2024, chapter 5): from a neutral face to one expression of the
// same person, by networks and by rivals that need no training.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "geometry/alignment.hpp"
#include "learning/band_network.hpp"
#include "spectral/deformation_transfer.hpp"
#include "spectral/metrics.hpp"
#include "training/rivals.hpp"
#include "training/runner.hpp"
#include "training/runs.hpp"

namespace mien::training {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// 5.3.4: 0, 10, ..., 100, 120, ..., 200, 230, ..., 500, 550, ..., 1000 and "all".
std::vector<Index> band_candidates(Index modes) {
    std::vector<Index> candidates;
    const auto range = [&](Index first, Index last, Index step) {
        for (Index k = first; k <= std::min(last, modes); k += step) candidates.push_back(k);
    };
    range(0, 100, 10);
    range(120, 200, 20);
    range(230, 500, 30);
    range(550, 1000, 50);
    candidates.push_back(kWholeBand);
    return candidates;
}

std::shared_ptr<const SpectralBasis> basis_for(const TriMesh& mean, Index most) {
    SpectralBasisOptions options;
    options.num_modes = std::min({most, Index(1000), mean.vertices.rows() / 2});
    return build_spectral_basis(mean, options, {});
}

/// Errors of a way to predict over people; `without_place`: the guess is put onto the truth rigidly
/// first, as deformations know no place.
Json errors_over(const RunContext& context, const std::vector<std::int32_t>& people,
                 const std::vector<PredictExpression>& ways, bool without_place, double scale_mm) {
    const FacePairs pairs =
        expression_pairs(context.data, people, context.configuration.data.expression);
    ReconstructionErrors errors;
    TriMesh truth, guess;
    truth.triangles = guess.triangles = context.data.triangles();
    Points neutral;
    for (Index k = 0; k < pairs.count; ++k) {
        pairs.pair(k, neutral, truth.vertices);
        for (const PredictExpression& way : ways) {
            guess.vertices = way(neutral);
            if (without_place)
                guess.vertices =
                    align_points(guess.vertices, truth.vertices, {}, false).apply(guess.vertices);
            errors.l1_mm.push_back(l1_distance(truth.vertices, guess.vertices));
            errors.l2_mm.push_back(l2_distance(truth.vertices, guess.vertices));
            errors.dame.push_back(dame(truth, guess, {}));
            errors.fmpd.push_back(fmpd(truth, guess, {}));
        }
    }
    return errors_json(errors, scale_mm);
}

/// Trains (or goes on), or takes the encoder of an autoencoder of neutral faces and trains the
/// decoder alone.
MadeNetworks make_expression(const RunContext& context) {
    const Configuration& c = context.configuration;
    const PreparedExpression faces = prepare_expression(
        context.data, context.split, c.data.expression, c.representation, c.spread, {});
    NetworkOptions options = c.model;
    options.channels_in = faces.input->num_channels();
    options.channels_out = faces.output->num_channels();
    NetworkLayers initial = build_network(faces.input->mean(), options, {});
    TrainingSettings settings = c.training;
    MadeNetworks made;
    if (c.two_step) {
        Configuration neutral = c;  // 5.2.2: its own autoencoder, on the same people
        neutral.two_step = false;
        neutral.data.expression.clear();
        neutral.data.neutral = true;
        neutral.text["data"].erase("expression");
        neutral.text["data"]["neutral"] = true;
        neutral.text["model"].erase("two_step");
        neutral.name = c.name.substr(0, c.name.find("-two-step"));
        if (run_configuration(neutral, context.folder, context.stop).is_null()) return {};
        const auto encoder = Network::load(
            (fs::u8path(context.folder) / fs::u8path(neutral.name) / "network.safetensors")
                .u8string(),
            {}, {});
        for (const NetworkLayer& layer : initial.encoder)
            for (const auto& [role, name] : layer.tensors)
                if (is_trained_role(layer.kind, role))
                    initial.tensors[name] = encoder->layers().tensors.at(name);
        settings.frozen_encoder = true;
    }
    NetworkLayers last, best;
    made.run =
        train_single(context, initial, faces.training, faces.validation, settings, last, best);
    if (made.run.is_null()) return {};
    const auto network_of = [&](NetworkLayers layers) {
        return Network::make(std::move(layers), faces.input, faces.output, {c.name, c.text.dump()},
                             {}, NetworkTask::displacement);
    };
    made.last = network_of(std::move(last));
    made.best = network_of(std::move(best));
    return made;
}

/// 5.3: the networks of two other rows, joined where validation people say.
MadeNetworks make_assembly(const RunContext& context) {
    const Configuration& c = context.configuration;
    std::shared_ptr<const Network> parts[2];
    for (const bool high : {false, true}) {
        Configuration part = c;
        part.bands = false;
        part.representation = high ? c.high_kind : c.low_kind;
        part.text["representation"] = {{"kind", feature_kind_name(part.representation)}};
        if (c.text["representation"].contains("spread"))
            part.text["representation"]["spread"] = c.text["representation"]["spread"];
        part.name = std::string(network_operator_name(c.model.op)) + "-" +
                    feature_kind_name(part.representation) + "-" + c.data.expression;
        if (run_configuration(part, context.folder, context.stop).is_null()) return {};
        parts[high] = Network::load(
            (fs::u8path(context.folder) / fs::u8path(part.name) / "network.safetensors").u8string(),
            {}, {});
    }
    BandNetwork::Parts joined{
        parts[0], parts[1], basis_for(parts[0]->mean(), c.band_limit), BandTask::expression, 0, 1};
    const NetworkOrigin origin{c.name, c.text.dump()};
    const auto unsearched = BandNetwork::make(joined, origin);
    const std::vector<std::int32_t>& people =
        context.split.validation.empty() ? context.split.training : context.split.validation;
    const PredictBands predict = [&](const Points& neutral, Points& spatial, Points& differential) {
        BandNetwork::Prediction prediction = unsearched->predict(neutral, {});
        spatial = std::move(prediction.spatial);
        differential = std::move(prediction.differential);
    };
    const std::vector<BandChoice> choices =
        search_band_limit(predict, context.data.triangles(), *joined.basis,
                          expression_pairs(context.data, people, c.data.expression),
                          band_candidates(joined.basis->num_modes()), {});
    MadeNetworks made;
    made.run = {{"search", Json::array()}};
    for (const BandChoice& choice : choices) {
        made.run["search"].push_back({{"k", choice.k == kWholeBand ? Json("all") : Json(choice.k)},
                                      {"l1_mm", choice.l1_mm},
                                      {"dame", choice.dame},
                                      {"fmpd", choice.fmpd},
                                      {"on_front", choice.on_front},
                                      {"chosen", choice.chosen}});
        if (choice.chosen) joined.band_limit = choice.k;
    }
    made.run["band_limit"] =
        joined.band_limit == kWholeBand ? Json("all") : Json(joined.band_limit);
    made.last = made.best = BandNetwork::make(joined, origin);
    return made;
}

}  // namespace

Json run_expression(const RunContext& context) {
    const Configuration& c = context.configuration;
    Json row = row_head(c);
    row["expression"] = c.data.expression;
    if (!c.rival.empty()) {
        const Rival rival = make_rival(context, [&](const TriMesh& mean) {
            const auto basis = basis_for(mean, c.band_limit);
            return std::make_pair(basis, band_candidates(basis->num_modes()));
        });
        const auto errors = [&](const std::vector<std::int32_t>& people) {
            return errors_over(context, people, rival.ways, false, rival.scale_mm);
        };
        row.update({{"code", rival.numbers},
                    {"weights", 0},
                    {"scale_mm", rival.scale_mm},
                    {"training", errors(context.split.training)},
                    {"test", errors(context.split.test)},
                    {"run", rival.run}});
        row["test_best"] = row["test"];
        return row;
    }
    const MadeNetworks made = c.bands ? make_assembly(context) : make_expression(context);
    if (made.last == nullptr) return nullptr;
    made.last->save(context.room + "network.safetensors", {});
    made.best->save(context.room + "best.safetensors", {});
    const bool without_place = !c.bands && c.representation >= FeatureKind::deformation;
    const auto errors = [&](const FaceNetwork& network, const std::vector<std::int32_t>& people) {
        const PredictExpression way = [&](const Points& neutral) {
            return network.apply(neutral, {});
        };
        return errors_over(context, people, {way}, without_place, network.scale_mm());
    };
    row.update({{"code", made.last->code_size()},
                {"weights", Json::parse(made.last->json())["weights"]},
                {"scale_mm", made.last->scale_mm()},
                {"training", errors(*made.last, context.split.training)},
                {"test", errors(*made.last, context.split.test)},
                {"test_best", errors(*made.best, context.split.test)},
                {"run", made.run}});
    return row;
}

}  // namespace mien::training
