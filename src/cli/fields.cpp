#include "fields.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace mien::cli {

std::vector<double> read_field(const std::string& path) {
    std::vector<double> values;
    const auto ends_with = [&](const char* tail) {
        const std::string t = tail;
        return path.size() >= t.size() && path.compare(path.size() - t.size(), t.size(), t) == 0;
    };
    if (ends_with(".json")) {
        nlohmann::json file = read_json(path);
        const nlohmann::json& list =
            file.is_object() && file.contains("values") ? file["values"] : file;
        if (!list.is_array())
            throw std::runtime_error(path + ": expected [number, ...] or {\"values\": [...]}");
        for (const nlohmann::json& v : list) {
            if (!v.is_number() && !v.is_null())
                throw std::runtime_error(path + ": value " + std::to_string(values.size()) +
                                         " is not a number");
            values.push_back(v.is_null() ? std::nan("") : v.get<double>());
        }
        return values;
    }
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error(path + ": cannot be opened for reading");
    std::stringstream text;
    text << in.rdbuf();
    std::string word;
    const auto finish = [&] {
        if (word.empty()) return;
        std::size_t used = 0;
        double value = 0;
        try {
            value = std::stod(word, &used);
        } catch (const std::exception&) {
            used = 0;
        }
        if (used != word.size())
            throw std::runtime_error(path + ": '" + word.substr(0, 20) +
                                     "' is not a number; give one number per vertex");
        values.push_back(value);
        word.clear();
    };
    for (const char c : text.str()) {
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == ',')
            finish();
        else
            word += c;
    }
    finish();
    return values;
}

void draw_field(const std::string& path, const Mesh& mesh, std::vector<double> field,
                const FieldPicture& how) {
    if (path.empty()) return;
    for (double& value : field)
        if (!std::isfinite(value)) value = std::nan("");
    RenderOptions options;
    options.scalar = std::move(field);
    options.color_map = how.is_signed ? ColorMap::diverging : ColorMap::sequential;
    options.low = how.low;
    options.label = how.label;
    options.title = how.title;
    options.points = how.points;
    write_png(path, render_mesh(arrays_of(mesh), options));
}

FieldSummary summary_of(const std::vector<double>& field) {
    FieldSummary summary{HUGE_VAL, 0, -HUGE_VAL};
    double count = 0;
    for (const double value : field) {
        if (!std::isfinite(value)) continue;
        summary.least = std::min(summary.least, value);
        summary.most = std::max(summary.most, value);
        summary.mean += value;
        ++count;
    }
    if (count == 0) throw std::runtime_error("no vertex has a finite value");
    summary.mean /= count;
    return summary;
}

nlohmann::json summary_json(const FieldSummary& summary) {
    return {{"min", summary.least}, {"mean", summary.mean}, {"max", summary.most}};
}

}  // namespace mien::cli
