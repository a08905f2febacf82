// The table of a platform run, with what it says in words.
#include <algorithm>
#include <cstdio>

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

void mark_fronts(Json& rows) {
    for (Json& row : rows)
        for (const bool networks_only : {false, true}) {
            const bool beaten = std::any_of(rows.begin(), rows.end(), [&](const Json& other) {
                if (networks_only && other["model"] == "pca") return false;
                const double l1 = test_of(other, "l1_mm"), dame = test_of(other, "dame");
                return l1 <= test_of(row, "l1_mm") && dame <= test_of(row, "dame") &&
                       (l1 < test_of(row, "l1_mm") || dame < test_of(row, "dame"));
            });
            row[networks_only ? "on_front_of_networks" : "on_front"] = !beaten;
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
        if (row["model"] != "pca" &&
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
    for (const Json& order : orders(rows)) findings.push_back(order);
    return {{"rows", rows}, {"findings", findings}};
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
