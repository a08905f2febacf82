#include "measure_faces.hpp"

#include <cmath>
#include <cstdio>

namespace mien::cli {

KnownFace read_known_face(const Session& session, const std::string& path, const std::string& json,
                          const std::optional<double>& sd_mm) {
    if (!is_record(path) && json.empty()) {
        const Mesh mesh(session, path);
        const std::vector<double> sd =
            sd_mm ? std::vector<double>(mesh.vertex_count(), *sd_mm) : std::vector<double>();
        return {mesh, sd, sd};
    }
    const Registration fit = read_fitted(session, {path, json}, {}, {}).fit;
    if (fit.verdict().quality == MIEN_QUALITY_FAILED) return {fit.mesh(), {}, {}};
    return {fit.mesh(), fit.field(MIEN_REGISTRATION_NORMAL_DEVIATION_MM),
            fit.field(MIEN_REGISTRATION_STANDARD_DEVIATION_MM)};
}

std::vector<MeasureZone> measure_zones(const std::string& path) {
    std::vector<MeasureZone> zones;
    if (!path.empty())
        for (auto& [name, vertices] : read_zones(path))
            zones.push_back({name, std::move(vertices)});
    return zones;
}

void write_field(const std::string& path, const std::vector<double>& values) {
    std::string text;
    char line[40];
    for (double value : values) {
        if (std::isfinite(value))
            std::snprintf(line, sizeof line, "%.9g\n", value);
        else
            std::snprintf(line, sizeof line, "nan\n");
        text += line;
    }
    write_file(path, text);
}

}  // namespace mien::cli
