// Table 5.2 and figure 5.8 in numbers: deformation transfer against the banded regression.
//   spectral_blendshapes DATASET TRAIN_SUBJECTS EXPRESSION...
// The first TRAIN_SUBJECTS subjects train (the last eighth of them chooses k and is then trained
// with), the others test. Transfer takes three training subjects as sources and reports their mean.
#include <cstdio>
#include <cstdlib>
#include <map>

#include "learning/blendshapes.hpp"
#include "mesh/dataset.hpp"
#include "spectral/deformation_transfer.hpp"
#include "spectral/metrics.hpp"
#include "spectral_support.hpp"

namespace {

using namespace mien;

struct Errors {
    double l1 = 0, l2 = 0, dame_ = 0, fmpd_ = 0;
    int count = 0;
    void add(const TriMesh& truth, const Points& guess) {
        TriMesh mesh = truth;
        mesh.vertices = guess;
        l1 += l1_distance(truth.vertices, guess);
        l2 += l2_distance(truth.vertices, guess);
        dame_ += dame(truth, mesh, {});
        fmpd_ += fmpd(truth, mesh, {});
        ++count;
    }
    void print(const char* name) const {
        std::printf("  %-22s L1 %.4f mm  L2 %.4f mm  DAME %.5f  FMPD %.5f\n", name, l1 / count,
                    l2 / count, dame_ / count, fmpd_ / count);
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4)
        return std::fprintf(stderr, "usage: %s DATASET TRAIN EXPRESSION...\n", argv[0]), 2;
    try {
        ThreadPool pool(2);
        Context context;
        context.pool = &pool;
        const FaceDataset data = FaceDataset::open(argv[1], {}, context);
        const int num_train = std::atoi(argv[2]);
        std::map<std::pair<int, int>, Index> place;
        std::vector<int> subjects;
        for (Index k = 0; k < data.num_faces(); ++k) {
            place[{data.subject(k), data.expression(k)}] = k;
            if (data.expression(k) == data.neutral_expression())
                subjects.push_back(data.subject(k));
        }
        std::shared_ptr<const SpectralBasis> basis;
        for (int a = 3; a < argc; ++a) {
            int expression = -1;
            for (std::size_t e = 0; e < data.expression_names().size(); ++e)
                if (data.expression_names()[e] == argv[a]) expression = static_cast<int>(e);
            if (expression < 0) return std::fprintf(stderr, "no expression %s\n", argv[a]), 1;
            const auto pairs = [&](int first, int last) {
                FacePairs p;
                p.count = last - first;
                p.pair = [&, first](Index k, Points& neutral, Points& face) {
                    data.face(place.at({subjects[first + k], data.neutral_expression()}), neutral);
                    data.face(place.at({subjects[first + k], expression}), face);
                };
                return p;
            };
            const int inner = num_train - num_train / 8;
            double start = bench::cpu_seconds();
            const auto tuning =
                BlendshapeModel::train(data.triangles(), pairs(0, inner), {}, context);
            if (!basis) {
                SpectralBasisOptions options;
                options.num_modes = 1000;
                basis = build_spectral_basis(tuning->mean(), options, context);
            }
            const std::vector<Index> candidates = {0,   10,  20,  50,   100,    200,
                                                   300, 500, 700, 1000, 1000000};
            const auto choices =
                search_band_limit(*tuning, *basis, pairs(inner, num_train), candidates, context);
            Index k = 0;
            std::printf("%s: Pareto search on %d subjects\n", argv[a], num_train - inner);
            for (const BandChoice& c : choices) {
                std::printf("  k %7ld  L1 %.4f  DAME %.5f  FMPD %.5f%s%s\n", static_cast<long>(c.k),
                            c.l1_mm, c.dame, c.fmpd, c.on_front ? "  front" : "",
                            c.chosen ? "  chosen" : "");
                if (c.chosen) k = c.k > basis->num_modes() ? basis->num_vertices() : c.k;
            }
            const auto model =
                BlendshapeModel::train(data.triangles(), pairs(0, num_train), {}, context);
            std::printf("  ridges %.3g %.3g; training and search %.1f s cpu\n",
                        model->spatial_ridge(), model->differential_ridge(),
                        bench::cpu_seconds() - start);
            Errors none, transfer, spatial, differential, banded;
            const FacePairs test = pairs(num_train, static_cast<int>(subjects.size())),
                            train = pairs(0, num_train);
            TriMesh truth, neutral;
            truth.triangles = neutral.triangles = data.triangles();
            Points source_neutral, source_face;
            for (Index i = 0; i < test.count; ++i) {
                test.pair(i, neutral.vertices, truth.vertices);
                none.add(truth, neutral.vertices);
                const DeformationTransfer carry(neutral, context);
                for (const Index s : {Index(0), Index(num_train / 3), Index(2 * num_train / 3)}) {
                    train.pair(s, source_neutral, source_face);
                    transfer.add(truth, carry.transfer(source_neutral, source_face, context));
                }
                const auto p = model->predict(neutral.vertices, context);
                spatial.add(truth, p.spatial);
                differential.add(truth, p.differential);
                banded.add(truth, assemble(*basis, p.spatial, p.differential, k, context));
            }
            std::printf("%s: %ld test subjects\n", argv[a], static_cast<long>(test.count));
            none.print("neutral unchanged");
            transfer.print("deformation transfer");
            spatial.print("regression, spatial");
            differential.print("regression, DR");
            banded.print("regression, banded");
            std::printf("  L1 lowered by %.1f %%, DAME %s (%.5f against %.5f)\n",
                        100 * (1 - banded.l1 / banded.count / (transfer.l1 / transfer.count)),
                        banded.dame_ / banded.count <= transfer.dame_ / transfer.count ? "no worse"
                                                                                       : "worse",
                        banded.dame_ / banded.count, transfer.dame_ / transfer.count);
            std::fflush(stdout);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
