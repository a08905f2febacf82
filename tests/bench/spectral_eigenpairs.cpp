// Prints wall and processor seconds of the first k Laplace-Beltrami eigenpairs.
//   spectral_eigenpairs MESH [K [VERTICES [THREADS]]]
// VERTICES refines the mesh by splitting long edges.
#include <cstdio>
#include <cstdlib>

#include "geometry/spectrum.hpp"
#include "mesh/mesh_file.hpp"
#include "spectral_support.hpp"

int main(int argc, char** argv) {
    using namespace mien;
    if (argc < 2)
        return std::fprintf(stderr, "usage: %s MESH [K [VERTICES [THREADS]]]\n", argv[0]), 2;
    const Index k = argc > 2 ? std::atol(argv[2]) : 500;
    const Index vertices = argc > 3 ? std::atol(argv[3]) : 0;
    const int threads = argc > 4 ? std::atoi(argv[4]) : 1;
    try {
        ThreadPool pool(threads);
        Context context;
        context.pool = &pool;
        TriMesh mesh = read_mesh_file(argv[1], context);
        if (vertices > mesh.vertices.rows()) mesh = bench::refined(mesh, vertices);
        double wall = bench::wall_seconds(), cpu = bench::cpu_seconds();
        const LaplaceOperator laplace = build_laplacian(mesh.vertices, mesh.triangles, {});
        std::printf("laplacian  n %ld  wall %.3f s  cpu %.3f s\n",
                    static_cast<long>(mesh.vertices.rows()), bench::wall_seconds() - wall,
                    bench::cpu_seconds() - cpu);
        wall = bench::wall_seconds(), cpu = bench::cpu_seconds();
        const EigenPairs pairs = smallest_eigenpairs(laplace, k, context);
        std::printf("eigenpairs k %ld threads %d  wall %.3f s  cpu %.3f s\n", static_cast<long>(k),
                    threads, bench::wall_seconds() - wall, bench::cpu_seconds() - cpu);
        const Matrix weighted = laplace.mass.asDiagonal() * pairs.vectors;
        Matrix gram = pairs.vectors.transpose() * weighted;
        gram.diagonal().array() -= 1.0;
        const Matrix residual =
            laplace.stiffness * pairs.vectors - weighted * pairs.values.asDiagonal();
        std::printf("lambda %.6g .. %.6g  max |U'MU - I| %.3g  max residual / lambda_k %.3g\n",
                    pairs.values[0], pairs.values[k - 1], gram.cwiseAbs().maxCoeff(),
                    (laplace.mass.cwiseSqrt().cwiseInverse().asDiagonal() * residual)
                            .colwise()
                            .norm()
                            .maxCoeff() /
                        pairs.values[k - 1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
