// DR round trips on a data set, and interpolation half-way between two expressions:
//   spectral_representation TEMPLATE DATASET [EXPRESSION_A EXPRESSION_B]
#include <algorithm>
#include <cstdio>

#include "geometry/alignment.hpp"
#include "mesh/dataset.hpp"
#include "mesh/mesh_file.hpp"
#include "mesh/topology.hpp"
#include "spectral/deformation_representation.hpp"
#include "spectral_support.hpp"

namespace {

using namespace mien;

/// Deviation of the edge lengths from the mean of both ends, in %: mean and median of the relative
/// ones, and sum of the absolute ones over the sum of lengths. Only edges whose ends move by
/// `least_mm` or more from a to b count.
Vector3 edge_error(const EdgeTable& edges, const Points& a, const Points& b, const Points& x,
                   double least_mm) {
    double sum = 0, absolute = 0, total = 0;
    std::vector<double> relative;
    for (const auto& e : edges.edges) {
        const double wanted =
            0.5 * ((a.row(e[0]) - a.row(e[1])).norm() + (b.row(e[0]) - b.row(e[1])).norm());
        const double length = (x.row(e[0]) - x.row(e[1])).norm();
        if ((a.row(e[0]) - b.row(e[0])).norm() < least_mm ||
            (a.row(e[1]) - b.row(e[1])).norm() < least_mm)
            continue;
        relative.push_back(std::abs(length / wanted - 1));
        sum += relative.back();
        absolute += std::abs(length - wanted);
        total += wanted;
    }
    std::nth_element(relative.begin(), relative.begin() + relative.size() / 2, relative.end());
    return {100 * sum / static_cast<double>(relative.size()), 100 * relative[relative.size() / 2],
            100 * absolute / total};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return std::fprintf(stderr, "usage: %s TEMPLATE DATASET [A B]\n", argv[0]), 2;
    try {
        const Context context;
        const TriMesh mesh = read_mesh_file(argv[1], context);
        const FaceDataset data = FaceDataset::open(argv[2], {}, context);
        double start = bench::cpu_seconds();
        const DeformationRepresentation dr(mesh, context);
        std::printf("factorisation %.3f s cpu\n", bench::cpu_seconds() - start);
        double worst = 0, encode = 0, decode = 0, largest = 0;
        Points face;
        for (Index k = 0; k < data.num_faces(); ++k) {
            data.face(k, face);
            start = bench::cpu_seconds();
            const Features features = dr.encode(face, context);
            encode += bench::cpu_seconds() - start;
            start = bench::cpu_seconds();
            const Points back = dr.decode(features, context);
            decode += bench::cpu_seconds() - start;
            const Points aligned = align_points(back, face, {}, false).apply(back);
            worst = std::max(worst, (aligned - face).rowwise().norm().maxCoeff());
            largest = std::max(largest, features.cwiseAbs().maxCoeff());
        }
        std::printf(
            "%ld faces: largest round-trip error %.3g mm, largest feature %.3g, encode %.1f ms, "
            "decode %.1f ms cpu\n",
            static_cast<long>(data.num_faces()), worst, largest, 1e3 * encode / data.num_faces(),
            1e3 * decode / data.num_faces());
        const char* names[] = {argc > 4 ? argv[3] : "neutral", argc > 4 ? argv[4] : "jaw_open"};
        int numbers[2] = {-1, -1};
        for (int i = 0; i < 2; ++i)
            for (std::size_t e = 0; e < data.expression_names().size(); ++e)
                if (data.expression_names()[e] == names[i]) numbers[i] = static_cast<int>(e);
        if (numbers[0] < 0 || numbers[1] < 0) {
            std::printf("expressions:");
            for (const auto& name : data.expression_names()) std::printf(" %s", name.c_str());
            return std::printf("\n"), 0;
        }
        const EdgeTable edges = build_edge_table(mesh.triangles, mesh.vertices.rows(), context);
        Matrix3 all = Matrix3::Zero(), moving = all;  // columns: euclidean, mean shape, first face
        int count = 0;
        for (Index i = 0; i < data.num_faces(); ++i)
            for (Index j = 0; j < data.num_faces(); ++j)
                if (data.subject(i) == data.subject(j) && data.expression(i) == numbers[0] &&
                    data.expression(j) == numbers[1]) {
                    Points a, b;
                    data.face(i, a);
                    data.face(j, b);
                    TriMesh own = mesh;
                    own.vertices = a;
                    const DeformationRepresentation own_dr(own, context);
                    const Points half[] = {
                        0.5 * (a + b),
                        dr.decode(0.5 * (dr.encode(a, context) + dr.encode(b, context)), context),
                        own_dr.decode(0.5 * own_dr.encode(b, context), context)};
                    for (int k = 0; k < 3; ++k) {
                        all.col(k) += edge_error(edges, a, b, half[k], 0);
                        moving.col(k) += edge_error(edges, a, b, half[k], 2);
                    }
                    if (count++ == 0) {
                        TriMesh out = mesh;
                        out.vertices = half[1];
                        write_mesh_file("half_dr.ply", out, context);
                        out.vertices = half[0];
                        write_mesh_file("half_euclidean.ply", out, context);
                    }
                }
        std::printf(
            "half-way %s - %s, %d subjects: deviation of the edges from the mean of both lengths, "
            "%%: mean, "
            "median, sum over length; all edges | edges that move by 2 mm or more\n",
            names[0], names[1], count);
        const char* titles[] = {"euclidean", "DR on the mean shape", "DR on the first face"};
        for (int k = 0; k < 3; ++k)
            std::printf("  %-22s %.4f  %.4f  %.4f | %.4f  %.4f  %.4f\n", titles[k],
                        all(0, k) / count, all(1, k) / count, all(2, k) / count,
                        moving(0, k) / count, moving(1, k) / count, moving(2, k) / count);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
