// Table 4.2 of the thesis on two data sets of shared/tools/make_faces20.py, with times:
//
//   expression_table TRAIN TEST [--stable FILE] [--modes N] [--threads N] [--quick 1]
//
// FILE lists the vertex numbers of the stable zone (posture), one per line.
//
// Prints one block per training method: baseline, alternating (3 sweeps and converged), exact, map,
// mixture; mean, worst expression, neutral input; Cohen's d and superiority over J-PCA with 3
// sweeps; the orthogonality score per number of components; times of training and of one
// neutralization.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "expression/evaluation.hpp"
#include "expression/training.hpp"

using namespace mien;

namespace {

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

std::vector<std::uint32_t> numbers(const char* path) {
    std::ifstream in(path);
    std::vector<std::uint32_t> values;
    for (std::uint32_t value; in >> value;) values.push_back(value);
    return values;
}

struct Row {
    std::string name;
    EvaluatedFaces errors;
    double seconds_per_face = 0;
};

void print_table(const FaceDataset& data, const std::vector<Row>& rows) {
    const int neutral = data.neutral_expression();
    std::printf("%-16s", "mm");
    for (const Row& row : rows) std::printf(" %12s", row.name.c_str());
    std::printf("\n");
    for (std::size_t e = 0; e < data.expression_names().size(); ++e) {
        std::printf("%-16s", data.expression_names()[e].c_str());
        for (const Row& row : rows)
            for (const ErrorSummary& s : summarize(row.errors, data.expression_names()))
                if (s.name == data.expression_names()[e])
                    std::printf("  %5.3f(%4.2f)", s.mean_mm, s.deviation_mm);
        std::printf("\n");
    }
    std::printf("%-16s", "all but neutral");
    for (const Row& row : rows) {
        const ErrorSummary s = summarize_moved(row.errors, neutral);
        std::printf("  %5.3f(%4.2f)", s.mean_mm, s.deviation_mm);
    }
    std::printf("\n%-16s", "max vertex");
    for (const Row& row : rows)
        std::printf(" %12.2f", summarize_moved(row.errors, neutral).max_vertex_mm);
    auto moved = [&](const Row& row) {
        std::vector<double> values;
        for (std::size_t k = 0; k < row.errors.face.size(); ++k)
            if (row.errors.expression[k] != neutral) values.push_back(row.errors.mean_mm[k]);
        return values;
    };
    std::printf("\n%-16s", "d over baseline");
    for (const Row& row : rows)
        std::printf(" %12.2f", effect_size(moved(rows[0]), moved(row)).cohens_d);
    std::printf("\n%-16s", "superiority %");
    for (const Row& row : rows)
        std::printf(" %12.1f", 100 * effect_size(moved(rows[0]), moved(row)).superiority);
    std::printf("\n%-16s", "ms per face");
    for (const Row& row : rows) std::printf(" %12.2f", 1e3 * row.seconds_per_face);
    std::printf("\n\n");
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3)
        return std::puts("expression_table TRAIN TEST [--stable FILE] [--modes N] [--threads N]"),
               2;
    TrainOptions base;
    EvaluationOptions evaluation;
    int threads = 2;
    bool quick = false;  // joint PCA alone
    for (int k = 3; k + 1 < argc; k += 2) {
        if (!std::strcmp(argv[k], "--stable"))
            base.stable_vertices = evaluation.stable = numbers(argv[k + 1]);
        if (!std::strcmp(argv[k], "--modes"))
            base.subspaces.identity_modes = base.subspaces.expression_modes =
                std::atoi(argv[k + 1]);
        if (!std::strcmp(argv[k], "--quick")) quick = std::atoi(argv[k + 1]) != 0;
        if (!std::strcmp(argv[k], "--threads")) threads = std::atoi(argv[k + 1]);
    }
    ThreadPool pool(threads);
    Context context;
    context.pool = &pool;
    auto train = std::make_shared<FaceDataset>(FaceDataset::open(argv[1], {false, false}, context));
    const FaceDataset test = FaceDataset::open(argv[2], {}, context);

    std::vector<Row> rows{{"baseline", evaluate_faces(context, test, evaluation, nullptr), 0.0}};
    auto measure = [&](const ExpressionModel& model, const char* name, FitMethod method,
                       int sweeps) {
        EvaluationOptions options = evaluation;
        options.neutralize.fit.method = method;
        options.neutralize.fit.max_sweeps = sweeps;
        const double begin = seconds();
        Row row{name, evaluate_model(context, test, model, options), 0.0};
        row.seconds_per_face = (seconds() - begin) / static_cast<double>(row.errors.face.size());
        rows.push_back(std::move(row));
    };
    struct Kind {
        const char* name;
        TrainMethod method;
        double factor;
    };
    for (const Kind& kind : {Kind{"J-PCA", TrainMethod::joint_pca, 10},
                             Kind{"QOJPCA 1x", TrainMethod::quasi_orthogonal, 1},
                             Kind{"QOJPCA 10x", TrainMethod::quasi_orthogonal, 10}}) {
        if (quick && kind.method != TrainMethod::joint_pca) continue;
        TrainOptions options = base;
        options.subspaces.method = kind.method;
        options.subspaces.lambda_factor = kind.factor;
        TrainReport report;
        const double begin = seconds();
        const std::clock_t cpu = std::clock();
        const auto model = train_expression_model(train, options, context, &report);
        std::printf(
            "%s: %.1f s (%.1f s of processor), %d iterations, last angle %.1e, noise map %g "
            "mixture %g\n",
            kind.name, seconds() - begin, double(std::clock() - cpu) / CLOCKS_PER_SEC,
            report.iterations, report.last_angle_rad, model->map_noise_mm2,
            model->mixture_noise_mm2);
        std::printf("  orthogonality at 5, 10, ..:");
        for (Index k = 4; k < report.orthogonality.size(); k += 5)
            std::printf(" %.4f", report.orthogonality[k]);
        std::printf("\n  identity explained %.5f, expression %.5f\n", report.identity_explained,
                    report.expression_explained);
        if (kind.method == TrainMethod::joint_pca) {
            measure(*model, "J-PCA 3", FitMethod::alternating, 3);
            measure(*model, "J-PCA conv.", FitMethod::alternating, 2000);
            measure(*model, "exact", FitMethod::exact, 1);
            measure(*model, "map", FitMethod::map, 1);
            measure(*model, "mixture", FitMethod::mixture, 1);
        } else {
            measure(*model, kind.name, FitMethod::alternating, 2000);
        }
    }
    print_table(test, rows);
    return 0;
} catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
