// Figures 4.2 to 4.5: what k modes leave out, with and without the mass matrix, on neutral faces;
// and the time to project and assemble one face.
//   spectral_bands DATASET [FACES [MODES [VERTICES [PICTURE.png]]]]
// VERTICES refines the mean for the timing alone (0: no timing). The picture shows greatest against
// mean error.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "cli/plot.hpp"
#include "learning/face_features.hpp"
#include "mesh/dataset.hpp"
#include "spectral/spectral_basis.hpp"
#include "spectral_support.hpp"

int main(int argc, char** argv) {
    using namespace mien;
    if (argc < 2)
        return std::fprintf(stderr, "usage: %s DATASET [FACES [MODES [VERTICES [PICTURE.png]]]]\n",
                            argv[0]),
               2;
    try {
        ThreadPool pool(2);
        Context context, serial;
        context.pool = &pool;
        const FaceDataset data = FaceDataset::open(argv[1], {}, context);
        const Index wanted = argc > 2 ? std::atol(argv[2]) : 100;
        const Index modes = argc > 3 ? std::atol(argv[3]) : 2000;
        std::vector<Index> faces;
        for (Index k = 0; k < data.num_faces() && static_cast<Index>(faces.size()) < wanted; ++k)
            if (data.expression(k) == data.neutral_expression()) faces.push_back(k);
        TriMesh mean;
        mean.triangles = data.triangles();
        mean.vertices = Points::Zero(data.num_vertices(), 3);
        Points face;
        for (const Index k : faces) {
            data.face(k, face);
            mean.vertices += face / static_cast<double>(faces.size());
        }
        std::shared_ptr<const SpectralBasis> bases[2];
        for (const bool with_mass : {true, false}) {
            SpectralBasisOptions options;
            options.num_modes = modes;
            options.with_mass = with_mass;
            const double cpu = bench::cpu_seconds();
            bases[with_mass ? 0 : 1] = build_spectral_basis(mean, options, context);
            std::fprintf(stderr, "%ld modes %s mass: %.1f s cpu\n", static_cast<long>(modes),
                         with_mass ? "with" : "without", bench::cpu_seconds() - cpu);
        }
        const Index ks[] = {50,  100, 150, 200,  250,  300,  350,  400, 500,
                            600, 700, 900, 1000, 1200, 1500, 1700, 2000};
        std::printf(
            "# %zu faces, L1 in mm: k, mean and greatest with mass, mean and greatest without\n",
            faces.size());
        cli::Curve curves[2];
        curves[0].label = "with mass matrix";
        curves[1].label = "without";
        for (const Index k : ks) {
            if (k > modes) break;
            double average[2] = {0, 0}, greatest[2] = {0, 0};
            for (const Index f : faces) {
                data.face(f, face);
                for (int b = 0; b < 2; ++b) {
                    const Vector error =
                        (low_band(*bases[b], face, k, context) - face).cwiseAbs().rowwise().sum();
                    average[b] += error.mean() / static_cast<double>(faces.size());
                    greatest[b] += error.maxCoeff() / static_cast<double>(faces.size());
                }
            }
            for (int b = 0; b < 2; ++b) {
                curves[b].x.push_back(average[b]);
                curves[b].y.push_back(greatest[b]);
            }
            std::printf("%5ld  %.5f %.5f  %.5f %.5f\n", static_cast<long>(k), average[0],
                        greatest[0], average[1], greatest[1]);
            std::fflush(stdout);
        }
        if (argc > 5) {
            cli::PlotOptions plot;
            plot.title = "what the low band leaves out";
            plot.x_label = "mean error, mm";
            plot.y_label = "greatest error, mm";
            std::ofstream(argv[5], std::ios::binary)
                << cli::encode_png(cli::draw_plot({curves[0], curves[1]}, plot));
        }
        if (argc > 4 && std::atol(argv[4]) > 0) {
            const TriMesh fine = bench::refined(mean, std::atol(argv[4]));
            SpectralBasisOptions options;
            options.num_modes = 500;
            const auto basis = build_spectral_basis(fine, options, context);
            const Points moved = 1.01 * fine.vertices;
            for (const Context* c : {&serial, &context}) {
                double projection = 1e9, synthesis = 1e9, assembly = 1e9;
                const auto best_of = [](double& best, const auto& work) {
                    const double wall = bench::wall_seconds();
                    work();
                    best = std::min(best, bench::wall_seconds() - wall);
                };
                for (int i = 0; i < 50; ++i) {
                    Matrix coefficients;
                    best_of(projection, [&] { coefficients = project(*basis, moved, 500, *c); });
                    best_of(synthesis, [&] { synthesise(*basis, coefficients, 0, *c); });
                    best_of(assembly, [&] { assemble(*basis, fine.vertices, moved, 500, *c); });
                }
                std::printf(
                    "# one face, %ld vertices, 500 modes, %s, wall, best of 50: projection %.1f "
                    "ms, synthesis "
                    "%.1f ms, two faces assembled %.1f ms\n",
                    static_cast<long>(fine.vertices.rows()),
                    c == &serial ? "1 thread" : "2 threads", 1e3 * projection, 1e3 * synthesis,
                    1e3 * assembly);
            }
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
