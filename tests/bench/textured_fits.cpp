// Do fits see a photograph as well as colours at vertices, whatever the file? Each scan is written
// with its colours in images, read back, and registered:
//
//   textured_fits MODEL.safetensors WORK_FOLDER SCAN_FOLDER ...
//
// First table: at the scan's own vertices, with landmarks and without, the fit of each kind of file
// against the vertex-coloured scan's: difference of the error, mm, and mean distance of the
// vertices, mm. Second: what colours bring to a fit without landmarks, of the dense scan with
// colours at its vertices, and of 3000 vertices with colours there and in images.
#include "textured_scan.hpp"

#include "registration_case.hpp"

namespace {

using namespace mien;

constexpr double kPixel_mm = 0.4;
constexpr Index kSparse = 3000;

struct Fit {
    double face_mm = 0;
    Points places;
};

Fit fit(const DeformationModel& model, const Case& one, const TriMesh& scan, bool landmarks,
        bool colors, const Context& context) {
    RegistrationSettings settings;
    settings.colors.enabled = colors;
    const RegistrationResult result = register_scan(
        model, scan, landmarks ? one.landmarks : std::vector<LandmarkPoint>(), settings, context);
    return {errors_of(model, {}, one, result).face_mm, result.fitted.vertices};
}

struct File {
    const char* name;
    TriMesh mesh;
};

// Written and read back.
std::vector<File> files_of(const ColoredScan& dense, const TriMesh& form, const std::string& stem,
                           const Context& context) {
    const TriMesh two = with_images(dense, form, 2, kPixel_mm);
    const TriMesh one = with_jpegs(with_images(dense, form, 1, kPixel_mm));
    std::vector<File> files;
    for (const auto& [name, end, mesh] : {std::make_tuple("OBJ, one JPEG", "_jpeg.obj", &one),
                                          std::make_tuple("OBJ, two PNG", "_png.obj", &two),
                                          std::make_tuple("GLB, two PNG", ".glb", &two),
                                          std::make_tuple("PLY, texture", "_texture.ply", &one)}) {
        write_mesh_file(stem + end, *mesh, context);
        files.push_back({name, read_mesh_file(stem + end, context)});
    }
    return files;
}

void run(const DeformationModel& model, const std::string& work,
         const std::vector<std::string>& folders, const Context& context) {
    std::printf(
        "| scan | file | landmarks | vertex colours, mm | image, mm | difference | apart |\n"
        "|---|---|---|---:|---:|---:|---:|\n");
    struct Gain {
        std::string name;
        double dense, dense_plain, sparse, sparse_plain, vertex;
    };
    std::vector<Gain> gains;
    for (const std::string& folder : folders) {
        const Case one = read_case(folder, context);
        const ColoredScan dense = read_colored(folder + "/scan.ply", context);
        const TriMesh form = form_of(dense, 0, context);
        const TriMesh colored = with_vertex_colors(dense, form);
        const std::string stem = work + "/" + one.name;
        for (const bool landmarks : {true, false}) {
            const Fit base = fit(model, one, colored, landmarks, true, context);
            for (const File& file : files_of(dense, form, stem, context)) {
                const Fit other = fit(model, one, file.mesh, landmarks, true, context);
                std::printf("| %s | %s | %s | %.3f | %.3f | %+.4f | %.3f |\n", one.name.c_str(),
                            file.name, landmarks ? "yes" : "no", base.face_mm, other.face_mm,
                            other.face_mm - base.face_mm,
                            (other.places - base.places).rowwise().norm().mean());
                std::fflush(stdout);
            }
        }
        const TriMesh thin = form_of(dense, kSparse, context);
        const TriMesh thin_images = with_images(dense, thin, 1, kPixel_mm);
        gains.push_back(
            {one.name, fit(model, one, colored, false, true, context).face_mm,
             fit(model, one, colored, false, false, context).face_mm,
             fit(model, one, thin_images, false, true, context).face_mm,
             fit(model, one, thin_images, false, false, context).face_mm,
             fit(model, one, with_vertex_colors(dense, thin), false, true, context).face_mm});
    }
    std::printf(
        "\n| scan | dense, no colours | vertex colours | gain | %lld, no colours | vertex "
        "colours | image | gain |\n|---|---:|---:|---:|---:|---:|---:|---:|\n",
        static_cast<long long>(kSparse));
    double dense_gain = 0, sparse_gain = 0;
    for (const Gain& g : gains) {
        std::printf("| %s | %.3f | %.3f | %+.3f | %.3f | %.3f | %.3f | %+.3f |\n", g.name.c_str(),
                    g.dense_plain, g.dense, g.dense_plain - g.dense, g.sparse_plain, g.vertex,
                    g.sparse, g.sparse_plain - g.sparse);
        dense_gain += (g.dense_plain - g.dense) / static_cast<double>(gains.size());
        sparse_gain += (g.sparse_plain - g.sparse) / static_cast<double>(gains.size());
    }
    std::printf("mean gain: dense %.3f mm, sparse with images %.3f mm\n", dense_gain, sparse_gain);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr,
                     "usage: textured_fits MODEL.safetensors WORK_FOLDER SCAN_FOLDER ...\n");
        return 2;
    }
    try {
        const Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        run(*model, argv[2], std::vector<std::string>(argv + 3, argv + argc), context);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "textured_fits: %s\n", error.what());
        return 1;
    }
    return 0;
}
