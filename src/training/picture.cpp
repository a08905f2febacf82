#include "training/picture.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "cli/plot.hpp"

namespace mien::training {

void write_table_picture(const std::string& path, const nlohmann::json& table) {
    std::vector<cli::Curve> curves;
    const auto curve_of = [&](const std::string& label) -> cli::Curve& {
        for (cli::Curve& curve : curves)
            if (curve.label == label) return curve;
        curves.emplace_back();
        curves.back().label = label;
        curves.back().line = false;
        curves.back().markers = true;
        return curves.back();
    };
    std::vector<std::pair<double, double>> front;
    for (const auto& row : table["rows"]) {
        const double l1 = row["test"]["l1_mm"], dame = row["test"]["dame"];
        cli::Curve& curve = curve_of(row["model"]);
        curve.x.push_back(l1);
        curve.y.push_back(dame);
        if (row["on_front"].get<bool>()) front.emplace_back(l1, dame);
    }
    std::sort(front.begin(), front.end());
    // An untrained or failed row is hundreds of times worse than a good one.
    constexpr double kWide = 30;
    double least[2], greatest[2];
    for (int k = 0; k < 2; ++k) {
        least[k] = std::numeric_limits<double>::infinity();
        greatest[k] = 0;
    }
    for (const cli::Curve& curve : curves)
        for (std::size_t i = 0; i < curve.x.size(); ++i)
            for (int k = 0; k < 2; ++k) {
                const double value = k == 0 ? curve.x[i] : curve.y[i];
                least[k] = std::min(least[k], value);
                greatest[k] = std::max(greatest[k], value);
            }
    cli::Curve line;
    line.label = "Pareto front";
    for (const auto& [x, y] : front) {
        line.x.push_back(x);
        line.y.push_back(y);
    }
    curves.push_back(line);
    cli::PlotOptions options;
    options.title = "people that nobody was trained on";
    options.x_label = "L1, mm";
    options.y_label = "DAME, rad";
    options.log_x = least[0] > 0 && greatest[0] > kWide * least[0];
    options.log_y = least[1] > 0 && greatest[1] > kWide * least[1];
    options.width = 900;
    options.height = 600;
    const std::string bytes = cli::encode_png(cli::draw_plot(curves, options));
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace mien::training
