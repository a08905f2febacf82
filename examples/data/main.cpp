// mien-demo-data: writes a template, a training set and a simulated scan session of a person that
// is not in it, so that everything can be tried without a download. Built on the C ABI's C++ face.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mien/mien.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "demo_faces.hpp"

namespace {

using mien::demo::DemoFaces;
using mien::demo::FaceMesh;
using nlohmann::json;

struct Settings {
    std::string out;
    bool nonlinear = false;
    int subjects = 30, test_subjects = 5;
    std::uint64_t seed = 1;
};

constexpr const char* kUsage =
    "usage: mien-demo-data --out DIR [--subjects N] [--test-subjects N] [--seed S] "
    "[--nonlinear]\n"
    "\n"
    "Writes, all made up (millimetres):\n"
    "  template.ply landmarks.json zones.json   the template head\n"
    "  train.safetensors test.safetensors       subjects x 20 expressions, different people (30 "
    "and 5)\n"
    "  scan/                                    a scan session of one more person: scan_grin.ply,\n"
    "                                           scan_mouth_stretch.ply, scan_neutral.ply, "
    "landmarks of\n"
    "                                           each, and the true faces in the scans' frame\n"
    "\n"
    "--nonlinear: the datasets alone, of people whose shapes are no sums of fixed directions and\n"
    "whose expressions are functions of the person with a little chance. Prints, and writes to\n"
    "oracle.json, how far the test faces are from those without chance: no method that knows the\n"
    "family perfectly gets closer on average.\n"
    "\n"
    "Example: mien-demo-data --out demo --subjects 40\n";

int number(const char* text, const char* option, int low, int high) {
    char* end = nullptr;
    const long value = std::strtol(text, &end, 10);
    if (end == text || *end != '\0' || value < low || value > high)
        throw std::invalid_argument(std::string(option) + " takes a number from " +
                                    std::to_string(low) + " to " + std::to_string(high));
    return static_cast<int>(value);
}

Settings parse(int argc, char** argv) {
    Settings settings;
    for (int k = 1; k < argc; ++k) {
        const std::string option = argv[k];
        if (option == "--nonlinear") {
            settings.nonlinear = true;
            continue;
        }
        if (k + 1 >= argc) throw std::invalid_argument(option + " needs a value");
        const char* value = argv[++k];
        if (option == "--out")
            settings.out = value;
        else if (option == "--subjects")
            settings.subjects = number(value, "--subjects", 1, 2000);
        else if (option == "--test-subjects")
            settings.test_subjects = number(value, "--test-subjects", 0, 2000);
        else if (option == "--seed")
            settings.seed = static_cast<std::uint64_t>(number(value, "--seed", 0, 1000000000));
        else
            throw std::invalid_argument("unknown option " + option);
    }
    if (settings.out.empty()) throw std::invalid_argument("--out is missing");
    return settings;
}

void write_text(const std::string& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out << text;
    out.close();
    if (!out) throw std::runtime_error(path + ": cannot be written");
}

class Writer {
  public:
    explicit Writer(std::string folder) : folder_(std::move(folder)) {}

    mien::Mesh mesh(const std::vector<double>& vertices, const FaceMesh& like) const {
        std::vector<mien::Position> positions;
        std::vector<mien::Triangle> triangles;
        std::vector<mien::Color> colors;
        for (std::size_t k = 0; k < vertices.size(); k += 3)
            positions.push_back({vertices[k], vertices[k + 1], vertices[k + 2]});
        for (std::size_t k = 0; k < like.triangles.size(); k += 3)
            triangles.push_back({like.triangles[k], like.triangles[k + 1], like.triangles[k + 2]});
        for (std::size_t k = 0; k < like.colors.size(); k += 3)
            colors.push_back({like.colors[k], like.colors[k + 1], like.colors[k + 2]});
        return mien::Mesh(session_, positions, triangles, colors);
    }
    void save(const std::string& name, const std::vector<double>& vertices,
              const FaceMesh& like) const {
        mesh(vertices, like).save(session_, folder_ + name);
    }
    void save(const std::string& name, const json& value) const {
        write_text(folder_ + name, value.dump(1) + "\n");
    }
    void dataset(const std::string& name, const DemoFaces& faces, std::uint64_t seed, int first,
                 int count, bool nonlinear = false) const {
        const FaceMesh& topology = faces.template_mesh();
        mien::DatasetWriter writer(session_, mesh(topology.vertices, topology),
                                   DemoFaces::expression_names());
        std::vector<mien::Position> positions(topology.vertices.size() / 3);
        for (int s = first; s < first + count; ++s) {
            int expression = 0;
            const auto person = nonlinear ? faces.nonlinear_person(seed, s) : faces.person(seed, s);
            for (const auto& vertices : faces.all_faces(person)) {
                for (std::size_t v = 0; v < positions.size(); ++v)
                    positions[v] = {vertices[3 * v], vertices[3 * v + 1], vertices[3 * v + 2]};
                writer.add(positions, s, expression++);
            }
        }
        writer.save(session_, folder_ + name);
    }

  private:
    std::string folder_;
    mien::Session session_;
};

/// Mean over vertices of |dx| + |dy| + |dz|.
double l1_mm(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += std::fabs(a[k] - b[k]);
    return sum / (static_cast<double>(a.size()) / 3);
}

void run_nonlinear(const Settings& settings) {
    std::filesystem::create_directories(settings.out);
    const DemoFaces faces;
    const Writer writer(settings.out + "/");
    writer.save("template.ply", faces.template_mesh().vertices, faces.template_mesh());
    writer.dataset("train.safetensors", faces, settings.seed, 0, settings.subjects, true);
    if (settings.test_subjects == 0) return;
    writer.dataset("test.safetensors", faces, settings.seed, 100000, settings.test_subjects, true);
    double neutral = 0, expressed = 0;
    std::map<std::string, double> by_name;
    for (int s = 0; s < settings.test_subjects; ++s) {
        const auto person = faces.nonlinear_person(settings.seed, 100000 + s);
        const auto made = faces.all_faces(person);
        const auto known = faces.all_faces(DemoFaces::without_chance(person));
        neutral += l1_mm(made[0], known[0]) / settings.test_subjects;
        // Of the displacement: the person's own detail is seen in the neutral face.
        for (std::size_t e = 1; e < made.size(); ++e) {
            std::vector<double> moved = known[e];
            for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += made[0][k] - known[0][k];
            const double l1 = l1_mm(made[e], moved) / settings.test_subjects;
            expressed += l1 / static_cast<double>(made.size() - 1);
            by_name[DemoFaces::expression_names()[e]] += l1;
        }
    }
    std::printf(
        "oracle, test people, L1: neutral faces from their 48 numbers %.4f mm, expressions from "
        "the "
        "neutral face %.4f mm\n",
        neutral, expressed);
    writer.save("oracle.json", json{{"numbers", 48},
                                    {"neutral_l1_mm", neutral},
                                    {"expression_l1_mm", expressed},
                                    {"expressions_l1_mm", by_name}});
}

void run(const Settings& settings) {
    std::filesystem::create_directories(settings.out + "/scan");
    const DemoFaces faces;
    const Writer writer(settings.out + "/");
    const FaceMesh& head = faces.template_mesh();
    writer.save("template.ply", head.vertices, head);
    json landmarks;
    landmarks["scheme"] = "multipie68";
    landmarks["alignment4"] = {"eye_right_0", "eye_left_3", "mouth_outer_00", "mouth_outer_06"};
    for (const auto& [name, vertex] : faces.landmarks()) landmarks["vertices"][name] = vertex;
    writer.save("landmarks.json", landmarks);
    json zones;
    for (const auto& [name, members] : faces.zones()) zones["zones"][name] = members;
    zones["lips"] = faces.lips();
    writer.save("zones.json", zones);

    writer.dataset("train.safetensors", faces, settings.seed, 0, settings.subjects);
    if (settings.test_subjects > 0)
        writer.dataset("test.safetensors", faces, settings.seed, 100000, settings.test_subjects);

    // One more person, scanned three times in one sitting (the pose is the sitting's, scans are in
    // one frame, so that before and after can be compared).
    const auto person = faces.person(settings.seed, 200000);
    for (const char* name : {"grin", "mouth_stretch", "neutral"}) {
        const auto scan = faces.scan(person, DemoFaces::expression_index(name), {});
        const std::string suffix = std::string("_") + name;
        writer.save("scan/scan" + suffix + ".ply", scan.mesh.vertices, scan.mesh);
        writer.save("scan/truth" + suffix + ".ply", scan.truth, head);
        json picked;
        picked["scheme"] = "multipie68";
        picked["units"] = "mm";
        for (const auto& [landmark, point] : scan.landmarks) picked["points"][landmark] = point;
        writer.save("scan/landmarks" + suffix + ".json", picked);
        if (std::strcmp(name, "grin") == 0) writer.save("scan/landmarks.json", picked);
        json visible;
        visible["zones"]["visible"] = json::array();
        for (std::size_t v = 0; v < scan.visible.size(); ++v)
            if (scan.visible[v]) visible["zones"]["visible"].push_back(v);
        writer.save("scan/visible" + suffix + ".json", visible);
    }
    std::printf(
        "%s: template of %zu vertices, %d + %d people x %zu expressions, 3 scans of one more "
        "person\n",
        settings.out.c_str(), head.vertices.size() / 3, settings.subjects, settings.test_subjects,
        DemoFaces::expression_names().size());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || std::strcmp(argv[1], "--help") == 0) {
        std::fputs(kUsage, argc < 2 ? stderr : stdout);
        return argc < 2 ? 2 : 0;
    }
    try {
        const Settings settings = parse(argc, argv);
        settings.nonlinear ? run_nonlinear(settings) : run(settings);
        return 0;
    } catch (const std::invalid_argument& failure) {
        std::fprintf(stderr, "mien-demo-data: %s\n%s", failure.what(), kUsage);
        return 2;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "mien-demo-data: %s\n", failure.what());
        return 1;
    }
}
