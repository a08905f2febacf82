// The table of a platform run, with what it says in words.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "training/runner.hpp"

namespace mien::training {
namespace {

using Json = nlohmann::json;

double test_of(const Json& row, const char* metric) {
    return row["test"][metric].get<double>();
}

/// The row of a model and representation, or null.
const Json* find_row(const Json& rows, const std::string& model, const char* representation) {
    for (const Json& row : rows)
        if (row["model"] == model && row["representation"] == representation &&
            row["spread"] == "per_vertex")
            return &row;
    return nullptr;
}

constexpr const char* kModels[] = {"feastnet", "neural3dmm", "spiralnet++", "mesh-autoencoder",
                                   "lsa-3dmm"};

/// "holds in 4 of 5" for `better` having the lower value, model by model.
std::string compared(const Json& rows, const char* better, const char* worse, const char* metric,
                     std::initializer_list<const char*> models) {
    int holds = 0, known = 0;
    for (const char* model : models) {
        const Json* a = find_row(rows, model, better);
        const Json* b = find_row(rows, model, worse);
        if (a == nullptr || b == nullptr) continue;
        ++known;
        holds += test_of(*a, metric) < test_of(*b, metric);
    }
    return known == 0 ? "not run"
                      : "holds in " + std::to_string(holds) + " of " + std::to_string(known);
}

Json orders(const Json& rows) {
    const std::initializer_list<const char*> all = {kModels[0], kModels[1], kModels[2], kModels[3],
                                                    kModels[4]};
    Json said = Json::array();
    const auto say = [&](const std::string& text) { said.push_back(text); };
    constexpr const char *plain = "euclidean", *standardised = "euclidean_standardised",
                         *deformation = "deformation", *normalised = "deformation_normalised";
    say("(a) standardised coordinates beat plain ones, L1: " +
        compared(rows, standardised, plain, "l1_mm", all) +
        "; DAME: " + compared(rows, standardised, plain, "dame", all));
    say("(b) standardised coordinates beat deformations in L1: " +
        compared(rows, standardised, deformation, "l1_mm", all) +
        "; deformations beat them in DAME: " +
        compared(rows, deformation, standardised, "dame", all));
    say("(c) normalising deformations hurts feastnet, neural3dmm and spiralnet++ in L1: " +
        compared(rows, deformation, normalised, "l1_mm", {kModels[0], kModels[1], kModels[2]}) +
        "; it helps mesh-autoencoder and lsa-3dmm: " +
        compared(rows, normalised, deformation, "l1_mm", {kModels[3], kModels[4]}));
    int on_front = 0, known = 0;
    for (const char* model : {kModels[3], kModels[4]})
        if (const Json* row = find_row(rows, model, standardised)) {
            ++known;
            on_front += (*row)["on_front_of_networks"].get<bool>();
        }
    say("(d) mesh-autoencoder and lsa-3dmm on standardised coordinates are on the networks' front "
        "of L1 and DAME: " +
        (known == 0 ? std::string("not run")
                    : "holds for " + std::to_string(on_front) + " of " + std::to_string(known)));
    return said;
}

/// Rows without training: they are not on the networks' own front.
bool is_rival(const Json& row) {
    if (row["model"] == "pca") return true;
    return std::any_of(std::begin(kRivals), std::end(kRivals),
                       [&](const char* name) { return row["model"] == name; });
}

void mark_fronts(Json& rows) {
    for (Json& row : rows)
        for (const bool networks_only : {false, true}) {
            const bool beaten = std::any_of(rows.begin(), rows.end(), [&](const Json& other) {
                if (networks_only && is_rival(other)) return false;
                const double l1 = test_of(other, "l1_mm"), dame = test_of(other, "dame");
                return l1 <= test_of(row, "l1_mm") && dame <= test_of(row, "dame") &&
                       (l1 < test_of(row, "l1_mm") || dame < test_of(row, "dame"));
            });
            row[networks_only ? "on_front_of_networks" : "on_front"] = !beaten;
        }
}

std::string percent(double now, double before) {
    char text[32];
    std::snprintf(text, sizeof text, "%+.1f %%", 100 * (now / before - 1));
    return text;
}

/// Deep Spectral Meshes against single networks of the same operator (tables 4.2, 4.3), and what
/// the pictures of the thesis show, in numbers (4.17 to 4.19).
void say_bands(const Json& rows, Json& said) {
    for (const Json& row : rows) {
        if (row["representation"] != "bands" || row.contains("expression")) continue;
        const std::string name = row["name"];
        std::string text = name + ": two bands are " +
                           (row["on_front_of_networks"].get<bool>() ? "" : "not ") +
                           "on the networks' front of L1 and DAME";
        for (const char* single : {"euclidean_standardised", "deformation_normalised"})
            if (const Json* other = find_row(rows, row["model"], single))
                text += std::string("; against ") + single + " L1 " +
                        percent(test_of(row, "l1_mm"), test_of(*other, "l1_mm")) + ", DAME " +
                        percent(test_of(row, "dame"), test_of(*other, "dame"));
        said.push_back(text);
        if (!row.contains("bands") || row["bands"].is_null()) continue;
        const Json& bands = row["bands"];
        char line[300];
        std::snprintf(
            line, sizeof line,
            "%s: exchanging the low codes of two people moves the low band by %.3f mm and "
            "the high one by %.3f mm; half-way faces are %.3f as rough as their parents by "
            "the network, %.3f by coordinates",
            name.c_str(), bands["low_edit_moves_low_mm"].get<double>(),
            bands["low_edit_moves_high_mm"].get<double>(),
            bands["halfway_roughness_network"].get<double>(),
            bands["halfway_roughness_coordinates"].get<double>());
        said.push_back(line);
    }
}

/// Spectral assembly against the coordinates' network, networks against rivals (table 5.2).
void say_expressions(const Json& rows, Json& said) {
    for (const Json& row : rows) {
        if (!row.contains("expression") || is_rival(row)) continue;
        const std::string name = row["name"];
        if (row["representation"] == "bands") {
            const Json* single = find_row(rows, row["model"], "euclidean_standardised");
            if (single != nullptr)
                said.push_back(
                    name + ": spectral assembly at k = " + row["run"]["band_limit"].dump() +
                    " changes the coordinate network's FMPD by " +
                    percent(test_of(row, "fmpd"), test_of(*single, "fmpd")) + " and its L1 by " +
                    percent(test_of(row, "l1_mm"), test_of(*single, "l1_mm")));
        }
        for (const char* rival : {"ridge", "banded-regression"})
            for (const Json& other : rows)
                if (other["model"] == rival)
                    said.push_back(name + " against " + rival + ": L1 " +
                                   percent(test_of(row, "l1_mm"), test_of(other, "l1_mm")) +
                                   ", DAME " +
                                   percent(test_of(row, "dame"), test_of(other, "dame")));
    }
}

}  // namespace

Json finish_table(std::vector<Json> given) {
    Json rows(std::move(given));
    mark_fronts(rows);
    Json findings = Json::array();
    const Json* pca = find_row(rows, "pca", "euclidean");
    const Json* best = nullptr;
    for (const Json& row : rows)
        if (!is_rival(row) && !row.contains("expression") &&
            (best == nullptr || test_of(row, "l1_mm") < test_of(*best, "l1_mm")))
            best = &row;
    if (pca != nullptr && best != nullptr) {
        char text[300];
        const bool wins = test_of(*pca, "l1_mm") < test_of(*best, "l1_mm");
        std::snprintf(
            text, sizeof text,
            "%s: on people that nobody was trained on, L1 is %.4f mm for the linear model "
            "with %d numbers and %.4f mm for the best network (%s, %d numbers)",
            wins ? "PCA wins" : "the best network beats PCA", test_of(*pca, "l1_mm"),
            (*pca)["code"].get<int>(), test_of(*best, "l1_mm"),
            (*best)["name"].get<std::string>().c_str(), (*best)["code"].get<int>());
        findings.push_back(text);
    }
    if (pca != nullptr && pca->contains("code_function")) {
        const double curved = (*pca)["code_function"]["test"]["l1_mm"].get<double>();
        char text[200];
        std::snprintf(text, sizeof text,
                      "a smooth function of PCA's own numbers brings its L1 from %.4f to %.4f mm "
                      "(%s): so much of these faces is curved, as far as the training faces show",
                      test_of(*pca, "l1_mm"), curved,
                      percent(curved, test_of(*pca, "l1_mm")).c_str());
        findings.push_back(text);
    }
    say_bands(rows, findings);
    say_expressions(rows, findings);
    const bool expressions = !rows.empty() && rows[0].contains("expression");
    if (!expressions)
        for (const Json& order : orders(rows)) findings.push_back(order);
    return {{"rows", rows}, {"findings", findings}};
}

std::string oracle_text(const DataChoice& data) {
    if (data.oracle.empty()) return {};
    std::ifstream in(std::filesystem::u8path(data.oracle));
    const Json oracle = Json::parse(in, nullptr, false);
    const Json* value = nullptr;
    if (oracle.is_object() && data.expression.empty() && oracle.contains("neutral_l1_mm"))
        value = &oracle["neutral_l1_mm"];
    if (oracle.is_object() && oracle.contains("expressions_l1_mm") &&
        oracle["expressions_l1_mm"].contains(data.expression))
        value = &oracle["expressions_l1_mm"][data.expression];
    if (value == nullptr || !value->is_number())
        fail(Status::bad_format,
             "%.150s: says nothing of %.60s; it is oracle.json of mien-demo-data",
             data.oracle.c_str(),
             data.expression.empty() ? "neutral faces" : data.expression.c_str());
    char text[160];
    std::snprintf(text, sizeof text,
                  "best possible predictor of these faces, on the whole template: L1 %.4f mm",
                  value->get<double>());
    return text;
}

std::string table_text(const Json& table) {
    std::string text;
    char line[300];
    std::snprintf(line, sizeof line, "%-44s %4s %8s | %8s %8s %8s | %8s %8s %8s %8s | %8s %s\n", "",
                  "code", "weights", "train L1", "L2 mm", "DAME", "test L1", "L2 mm", "DAME",
                  "FMPD", "best L1", "front");
    text += line;
    for (const Json& row : table["rows"]) {
        const Json &training = row["training"], &test = row["test"];
        std::snprintf(line, sizeof line,
                      "%-44s %4d %7.2fM | %8.4f %8.4f %8.4f | %8.4f %8.4f %8.4f %8.4f | %8.4f %s\n",
                      row["name"].get<std::string>().c_str(), row["code"].get<int>(),
                      1e-6 * row["weights"].get<double>(), training["l1_mm"].get<double>(),
                      training["l2_mm"].get<double>(), training["dame"].get<double>(),
                      test["l1_mm"].get<double>(), test["l2_mm"].get<double>(),
                      test["dame"].get<double>(), test["fmpd"].get<double>(),
                      row["test_best"]["l1_mm"].get<double>(),
                      row["on_front"].get<bool>() ? "*" : "");
        text += line;
    }
    for (const Json& finding : table["findings"]) text += finding.get<std::string>() + "\n";
    return text;
}

}  // namespace mien::training
