// DR round trips on a data set, and interpolation half-way between two expressions:
//   spectral_representation TEMPLATE DATASET [EXPRESSION_A EXPRESSION_B]
#include <cstdio>

#include "geometry/alignment.hpp"
#include "mesh/dataset.hpp"
#include "mesh/mesh_file.hpp"
#include "mesh/topology.hpp"
#include "spectral/deformation_representation.hpp"
#include "spectral_support.hpp"

namespace {

using namespace mien;

/// Deviation of the edge lengths from the mean of both ends: mean of the relative ones, sum of the
/// absolute ones over the sum of lengths, and the median of the relative ones.
Vector3 edge_error(const EdgeTable& edges, const Points& a, const Points& b, const Points& x) {
    double sum = 0, absolute = 0, total = 0;
    std::vector<double> relative;
    for (const auto& e : edges.edges) {
        const double wanted = 0.5 * ((a.row(e[0]) - a.row(e[1])).norm() + (b.row(e[0]) - b.row(e[1])).norm());
        const double length = (x.row(e[0]) - x.row(e[1])).norm();
        // Only what the expression moved: a fixed scalp would hide the face.
        if ((a.row(e[0]) - b.row(e[0])).norm() < 2.0) continue;
        relative.push_back(std::abs(length / wanted - 1));
        sum += relative.back();
        absolute += std::abs(length - wanted);
        total += wanted;
    }
    std::nth_element(relative.begin(), relative.begin() + relative.size() / 2, relative.end());
    return {100 * sum / static_cast<double>(relative.size()), 100 * absolute / total,
            100 * relative[relative.size() / 2]};
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
        std::printf("%ld faces: largest round-trip error %.3g mm, largest feature %.3g, encode %.1f ms, "
                    "decode %.1f ms cpu\n", static_cast<long>(data.num_faces()), worst, largest,
                    1e3 * encode / data.num_faces(), 1e3 * decode / data.num_faces());
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
        Vector3 euclidean = Vector3::Zero(), deformed = euclidean, from_own = euclidean;
        int count = 0;
        for (Index i = 0; i < data.num_faces(); ++i)
            for (Index j = 0; j < data.num_faces(); ++j)
                if (data.subject(i) == data.subject(j) && data.expression(i) == numbers[0] &&
                    data.expression(j) == numbers[1]) {
                    Points a, b;
                    data.face(i, a);
                    data.face(j, b);
                    // From the mean shape, and from the first face itself.
                    const Features half = 0.5 * (dr.encode(a, context) + dr.encode(b, context));
                    euclidean += edge_error(edges, a, b, 0.5 * (a + b));
                    deformed += edge_error(edges, a, b, dr.decode(half, context));
                    TriMesh own = mesh;
                    own.vertices = a;
                    const DeformationRepresentation own_dr(own, context);
                    const Features own_half = 0.5 * own_dr.encode(b, context);
                    from_own += edge_error(edges, a, b, own_dr.decode(own_half, context));
                    if (count++ == 0) {
                        TriMesh out = mesh;
                        out.vertices = dr.decode(half, context);
                        write_mesh_file("half_dr.ply", out, context);
                        out.vertices = 0.5 * (a + b);
                        write_mesh_file("half_euclidean.ply", out, context);
                    }
                }
        std::printf("half-way %s - %s, %d subjects, edges that move by 2 mm or more: mean relative error, "
                    "absolute over length, median, in %%\n", names[0], names[1], count);
        const auto print = [&](const char* name, const Vector3& e) {
            std::printf("  %-22s %.4f  %.4f  %.4f\n", name, e[0] / count, e[1] / count, e[2] / count);
        };
        print("euclidean", euclidean);
        print("DR on the mean shape", deformed);
        print("DR on the first face", from_own);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
