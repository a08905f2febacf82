#include "training/configuration.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace mien::training {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

Json load(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) fail(Status::io, "%.150s: cannot be opened for reading", path.u8string().c_str());
    try {
        return Json::parse(in);
    } catch (const Json::exception& failure) {
        fail(Status::bad_format, "%.100s: is not JSON (%.100s)", path.u8string().c_str(),
             failure.what());
    }
}

/// Paths of the data are made absolute against the file that names them.
void anchor_paths(Json& section, const fs::path& folder) {
    for (const char* key : {"faces", "split", "oracle"})
        if (section.contains(key) && section[key].is_string()) {
            const fs::path given = fs::u8path(section[key].get<std::string>());
            section[key] =
                (given.is_absolute() ? given : folder / given).lexically_normal().u8string();
        }
}

constexpr int kDeepestBase = 16;

Json resolve(const Json& node, const fs::path& folder, int depth = 0) {
    if (depth > kDeepestBase)
        fail(Status::bad_format, "configurations name each other in a circle");
    if (node.is_string()) {
        const fs::path path = folder / fs::u8path(node.get<std::string>());
        return resolve(load(path), path.parent_path(), depth + 1);
    }
    if (!node.is_object())
        fail(Status::bad_format, "a part of a configuration is neither an object nor a path: %.80s",
             node.dump().c_str());
    Json own = node;
    own.erase("base");
    anchor_paths(own, folder);
    if (!node.contains("base")) return own;
    Json whole = resolve(node["base"], folder, depth + 1);
    whole.merge_patch(own);
    return whole;
}

/// Reads the entries of a section and refuses those that nobody asked for.
class Section {
  public:
    Section(const Json& whole, const char* name)
        : name_(name), json_(whole.contains(name) ? whole[name] : Json::object()) {}

    template <typename Value>
    void read(const char* key, Value& value) {
        known_ += known_.empty() ? key : std::string(", ") + key;
        if (!json_.contains(key)) return;
        try {
            value = json_[key].get<Value>();
        } catch (const Json::exception&) {
            fail(Status::bad_format, "'%s.%s' is %.60s, which is of the wrong kind", name_, key,
                 json_[key].dump().c_str());
        }
        json_.erase(key);
    }
    void finish() const {
        if (!json_.empty())
            fail(Status::bad_format, "'%s.%.40s' does not exist; known are %.150s", name_,
                 json_.begin().key().c_str(), known_.c_str());
    }

  private:
    const char* name_;
    Json json_;
    std::string known_;
};

/// Gives the kind's name; `label`: the name that the configuration wants instead.
std::string read_representation(const Json& text, Configuration& c, std::string& label) {
    Section representation(text, "representation");
    std::string kind = "euclidean", spread = "per_vertex";
    representation.read("kind", kind);
    representation.read("spread", spread);
    representation.read("name", label);
    std::string low = feature_kind_name(c.low_kind), high = feature_kind_name(c.high_kind);
    representation.read("band_limit", c.band_limit);
    representation.read("conditioning", c.training.conditioning);
    representation.read("low", low);
    representation.read("high", high);
    representation.finish();
    c.bands = kind == "bands";
    if (!c.bands) c.representation = feature_kind(kind);
    c.low_kind = feature_kind(low);
    c.high_kind = feature_kind(high);
    if (spread != "per_vertex" && spread != "per_channel")
        fail(Status::bad_format,
             "representation.spread is %.40s; known are per_vertex, per_channel", spread.c_str());
    c.spread = spread == "per_vertex" ? FeatureSpread::per_vertex : FeatureSpread::per_channel;
    return kind;
}

Configuration configuration_of(const Json& text) {
    Configuration c;
    c.text = text;
    Section data(text, "data");
    data.read("faces", c.data.faces);
    data.read("split", c.data.split);
    data.read("neutral", c.data.neutral);
    data.read("expression", c.data.expression);
    data.read("oracle", c.data.oracle);
    data.finish();
    if (c.data.faces.empty() || c.data.split.empty())
        fail(Status::bad_format, "a configuration needs data.faces and data.split");

    std::string label;
    const std::string kind = read_representation(text, c, label);

    Section model(text, "model");
    std::string op = "spiralnet++";
    NetworkOptions& m = c.model;
    model.read("operator", op);
    model.read("latent", m.latent);
    model.read("widths", m.widths);
    model.read("mesh_widths", m.mesh_widths);
    model.read("factor", m.factor);
    model.read("spiral_length", m.spiral_length);
    model.read("matrices", m.matrices);
    model.read("places", m.places);
    model.read("mixing_bases", m.mixing_bases);
    model.read("bases", m.bases);
    model.read("residual_rate", m.residual_rate);
    model.read("reference_vertex", m.reference_vertex);
    model.read("variational", m.variational);
    model.read("two_step", c.two_step);
    model.finish();
    const bool expression = !c.data.expression.empty();
    const auto is_op = [&](const char* name) { return op == name; };
    if (expression && std::any_of(std::begin(kRivals), std::end(kRivals), is_op)) c.rival = op;
    c.pca = op == "pca" && !expression;
    if (!c.pca && c.rival.empty()) m.op = network_operator(op);
    if (c.two_step && (!expression || c.bands))
        fail(Status::bad_format,
             "model.two_step is of networks to one data.expression, in one representation");

    Section experiment(text, "experiment");
    TrainingSettings& t = c.training;
    experiment.read("epochs", t.epochs);
    experiment.read("batch", t.batch);
    experiment.read("learning_rate", t.learning_rate);
    experiment.read("decay", t.decay);
    experiment.read("weight_decay", t.weight_decay);
    experiment.read("divergence", t.divergence);
    experiment.read("seed", t.seed);
    experiment.read("threads", t.threads);
    experiment.read("checkpoint_every", t.checkpoint_every);
    experiment.read("validate_every", t.validate_every);
    experiment.read("accelerator", t.accelerator);
    experiment.finish();
    m.seed = t.seed;
    c.name = op;
    if (c.rival.empty()) c.name += "-" + (label.empty() ? kind : label);
    if (c.two_step) c.name += "-two-step";
    if (expression) c.name += "-" + c.data.expression;
    return c;
}

void apply_override(Json& text, const std::string& setting) {
    const std::size_t equal = setting.find('=');
    if (equal == std::string::npos || equal == 0)
        fail(Status::invalid_argument, "'%.80s': give section.key=value", setting.c_str());
    std::string key = setting.substr(0, equal);
    const std::string value = setting.substr(equal + 1);
    Json parsed = Json::parse(value, nullptr, false);
    if (parsed.is_discarded()) parsed = value;
    std::replace(key.begin(), key.end(), '.', '/');
    text[Json::json_pointer("/" + key)] = parsed;
}

/// What holds for every representation of a table; what is of bands alone only where it means
/// something, so that a single network's row is the same in every table.
void merge_representation(Json& own, Json common) {
    if (own.value("kind", "") != "bands")
        for (const char* key : {"band_limit", "conditioning", "low", "high"}) common.erase(key);
    own.merge_patch(common);
}

}  // namespace

Plan read_plan(const std::string& path, const std::vector<std::string>& overrides) {
    const fs::path file = fs::u8path(path);
    const fs::path folder = file.parent_path();
    Json text = load(file);
    if (!text.is_object()) fail(Status::bad_format, "%.150s: is no object", path.c_str());
    // A whole section, "model=model/pca.json", is read like one in the file; then its keys.
    const auto of_section = [](const std::string& setting) {
        return setting.substr(0, setting.find('=')).find('.') == std::string::npos;
    };
    for (const std::string& setting : overrides)
        if (of_section(setting)) apply_override(text, setting);
    for (const char* section : {"data", "representation", "model", "experiment"})
        if (text.contains(section)) text[section] = resolve(text[section], folder);
    for (const char* list : {"models", "representations"})
        if (text.contains(list)) {
            if (!text[list].is_array())
                fail(Status::bad_format, "%.100s: '%s' is no list", path.c_str(), list);
            for (Json& item : text[list]) item = resolve(item, folder);
        }
    for (const std::string& setting : overrides)
        if (!of_section(setting)) apply_override(text, setting);
    for (const auto& entry : text.items())
        if (entry.key() != "data" && entry.key() != "representation" && entry.key() != "model" &&
            entry.key() != "experiment" && entry.key() != "models" &&
            entry.key() != "representations" && entry.key() != "out")
            fail(Status::bad_format,
                 "%.100s: '%.40s' does not exist; known are data, representation(s), model(s), "
                 "experiment, out",
                 path.c_str(), entry.key().c_str());
    Plan plan;
    if (!text.contains("out") || !text["out"].is_string())
        fail(Status::bad_format, "%.120s: names no folder 'out'", path.c_str());
    plan.out = text["out"].get<std::string>();
    plan.table = text.contains("models") || text.contains("representations");
    const auto part = [&](const char* list, const char* single) {
        return text.contains(list) ? text[list] : Json::array({text.value(single, Json::object())});
    };
    for (const Json& model : part("models", "model"))
        for (const Json& representation : part("representations", "representation")) {
            Json one = {{"data", text.value("data", Json::object())},
                        {"representation", representation},
                        {"model", model},
                        {"experiment", text.value("experiment", Json::object())}};
            // "model.latent=32" holds for every model of a table.
            if (plan.table && text.contains("model")) one["model"].merge_patch(text["model"]);
            if (plan.table && text.contains("representation"))
                merge_representation(one["representation"], text["representation"]);
            // Assembly takes end-to-end networks: of this pair there is no row.
            if (plan.table && one["model"].value("two_step", false) &&
                one["representation"].value("kind", "") == "bands")
                continue;
            plan.configurations.push_back(configuration_of(one));
        }
    for (std::size_t k = 0; k < plan.configurations.size(); ++k)
        for (std::size_t j = 0; j < k; ++j)
            if (plan.configurations[k].name == plan.configurations[j].name)
                fail(Status::bad_format,
                     "two configurations are called %.80s; give one's representation a 'name'",
                     plan.configurations[k].name.c_str());
    return plan;
}

}  // namespace mien::training
