#include "training/runner.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "training/code_function.hpp"
#include "training/runs.hpp"

namespace mien::training {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

Json face_errors(const RunContext& context, const FaceNetwork& network,
                 const std::vector<std::int32_t>& people) {
    const auto reconstruct = [&](const Points& face) { return network.apply(face, {}); };
    return errors_json(
        reconstruction_errors(
            context.data, chosen_faces(context.data, people, context.configuration.data.neutral),
            reconstruct, true, {}),
        network.scale_mm());
}

Json run_faces(const RunContext& context) {
    const Configuration& c = context.configuration;
    const MadeNetworks made = make_face_networks(context);
    if (made.last == nullptr) return nullptr;
    made.last->save(context.room + "network.safetensors", {});
    made.best->save(context.room + "best.safetensors", {});
    Json row = row_head(c);
    row.update({{"code", made.last->code_size()},
                {"weights", Json::parse(made.last->json())["weights"]},
                {"scale_mm", made.last->scale_mm()},
                {"training", face_errors(context, *made.last, context.split.training)},
                {"test", face_errors(context, *made.last, context.split.test)},
                {"test_best", face_errors(context, *made.best, context.split.test)},
                {"run", made.run}});
    if (c.pca)
        if (const Json found = code_function_row(context, *made.last); !found.is_null())
            row["code_function"] = found;
    if (c.bands)
        row["bands"] = band_measures(*made.last, context.data,
                                     chosen_faces(context.data, context.split.test, true));
    return row;
}

}  // namespace

void write_run_text(const std::string& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

Json errors_json(const ReconstructionErrors& errors, double scale_mm) {
    const double l1 = ReconstructionErrors::mean(errors.l1_mm);
    return {{"faces", errors.l1_mm.size()},
            {"l1_mm", l1},
            {"l2_mm", ReconstructionErrors::mean(errors.l2_mm)},
            {"l1_scaled", l1 / 3 / scale_mm},
            {"dame", ReconstructionErrors::mean(errors.dame)},
            {"fmpd", ReconstructionErrors::mean(errors.fmpd)}};
}

Json row_head(const Configuration& c) {
    std::string model = c.pca ? "pca" : c.rival;
    if (model.empty()) model = network_operator_name(c.model.op);
    if (c.two_step) model += " two-step";
    Json row = {{"configuration", c.text}, {"name", c.name}, {"model", model}};
    row["representation"] = c.bands ? "bands" : feature_kind_name(c.representation);
    row["spread"] = c.spread == FeatureSpread::per_vertex ? "per_vertex" : "per_channel";
    return row;
}

Configuration pca_of(const Configuration& configuration) {
    Configuration pca = configuration;
    pca.pca = true;
    pca.bands = false;
    pca.name = "pca-euclidean";
    pca.representation = FeatureKind::euclidean;
    pca.spread = FeatureSpread::per_vertex;
    pca.text["model"] = {{"operator", "pca"}, {"latent", configuration.model.latent}};
    pca.text["representation"] = {{"kind", "euclidean"}};
    pca.text["experiment"] = Json::object();
    return pca;
}

std::vector<Configuration> with_rivals(std::vector<Configuration> all) {
    std::vector<Configuration> rivals;
    const Configuration& first = all.front();
    if (first.data.expression.empty()) {
        if (std::none_of(all.begin(), all.end(), [](const auto& c) { return c.pca; }))
            rivals.push_back(pca_of(first));
    } else {
        for (const char* name : kRivals) {
            if (std::any_of(all.begin(), all.end(), [&](const auto& c) { return c.rival == name; }))
                continue;
            Configuration rival = first;
            rival.rival = name;
            rival.bands = rival.two_step = false;
            rival.representation = FeatureKind::euclidean;
            rival.name = std::string(name) + "-" + first.data.expression;
            rival.text["model"] = {{"operator", name}, {"latent", first.model.latent}};
            rival.text["representation"] = {{"kind", "euclidean"}};
            rival.text["experiment"] = Json::object();
            rivals.push_back(rival);
        }
    }
    all.insert(all.begin(), rivals.begin(), rivals.end());
    return all;
}

Json run_configuration(const Configuration& c, const std::string& folder,
                       const std::atomic<bool>& stop) {
    const fs::path room = fs::u8path(folder) / fs::u8path(c.name);
    fs::create_directories(room);
    const fs::path result_path = room / "result.json";
    if (fs::exists(result_path)) {
        std::ifstream in(result_path);
        Json row = Json::parse(in, nullptr, false);
        if (!row.is_discarded() && row.value("configuration", Json()) == c.text) return row;
    }
    const FaceDataset data = FaceDataset::open(c.data.faces, {}, {});
    const SubjectSplit split = read_split(c.data.split);
    const RunContext context{c, data, split, folder, (room / "").u8string(), stop};
    const Json row = c.data.expression.empty() ? run_faces(context) : run_expression(context);
    if (!row.is_null()) write_run_text(result_path.u8string(), row.dump(1) + "\n");
    return row;
}

}  // namespace mien::training
