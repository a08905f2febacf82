// What neutralization does off the beaten track, and to volumes:
//
//   expression_stress TRAIN TEST MOUTH FACE
//
// TRAIN and TEST are data sets with the 20 expressions of FaceWarehouse, MOUTH and FACE files of
// vertex numbers (one per line). Prints volume errors per zone against the untouched face (tables
// A.1 and 4.3), an expression held out of training, a one-sided smile, half of the face unseen, and
// a series of four scans of one person; and how often a face became worse than the input, with and
// without a warning.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "expression/evaluation.hpp"
#include "expression/training.hpp"
#include "expression/visits.hpp"
#include "expression_support.hpp"
#include "measure/volume.hpp"

using namespace mien;

namespace {

std::vector<std::uint32_t> numbers(const char* path) {
    std::ifstream in(path);
    std::vector<std::uint32_t> values;
    for (std::uint32_t value; in >> value;) values.push_back(value);
    return values;
}

struct Sums {
    double before = 0, after = 0;
    int count = 0, worse = 0, silent = 0, warned = 0;
    void add(double untouched, double neutralized, bool warning) {
        before += untouched;
        after += neutralized;
        ++count;
        worse += neutralized > untouched;
        silent += neutralized > untouched && !warning;
        warned += warning;
    }
    void print(const char* name, const char* unit) const {
        std::printf(
            "  %-28s untouched %7.3f %s, neutralized %7.3f %s = %5.1f %%; worse than the input %d "
            "of %d, "
            "without a warning %d; warnings %d\n",
            name, before / count, unit, after / count, unit, 100 * after / before, worse, count,
            silent, warned);
    }
};

/// How often a vertex lies within twice its stated deviation (Rayleigh-like: three coordinates).
struct Coverage {
    double inside = 0, count = 0;
    void add(double error, double deviation) {
        inside += error <= 2.0 * deviation;
        count += 1;
    }
    void print(const char* name) const {
        std::printf("  %s: %.1f %% within twice the stated deviation\n", name,
                    100 * inside / count);
    }
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 5) return std::puts("expression_stress TRAIN TEST MOUTH FACE"), 2;
    ThreadPool pool(2);
    Context context;
    context.pool = &pool;
    auto train = std::make_shared<FaceDataset>(FaceDataset::open(argv[1], {false, false}, context));
    const FaceDataset test = FaceDataset::open(argv[2], {}, context);
    const auto model = train_expression_model(train, {}, context);
    const std::vector<Zone> mouth{{"mouth", numbers(argv[3])}},
        face_zone{{"face", numbers(argv[4])}};
    std::map<int, Points> neutral_of;
    Points face;
    for (Index k = 0; k < test.num_faces(); ++k)
        if (test.expression(k) == test.neutral_expression())
            test.face(k, neutral_of[test.subject(k)]);
    NeutralizeOptions stating;
    stating.uncertainty = true;
    auto neutralized = [&](const ExpressionModel& with, const Points& vertices,
                           const Vector& weights) {
        return neutralize(context, with, vertices, weights, {}).neutral_vertices;
    };
    std::printf("expected residual %.3f mm\n", model->expected_residual_mm);

    std::puts("all test faces");
    std::map<std::string, Sums> all_sums;
    Coverage coverage;
    for (Index k = 0; k < test.num_faces(); ++k) {
        test.face(k, face);
        const Points& truth = neutral_of.at(test.subject(k));
        const NeutralizationResult result = neutralize(context, *model, face, Vector(), stating);
        const bool neutral = test.expression(k) == test.neutral_expression();
        all_sums[neutral ? "neutral" : "expressions"].add(
            mean_distance(face, truth), mean_distance(result.neutral_vertices, truth),
            !neutralization_warnings(*model, result).empty());
        if (!neutral)
            for (Index i = 0; i < face.rows(); i += 11)
                coverage.add((result.neutral_vertices.row(i) - truth.row(i)).norm(),
                             result.uncertainty_mm[i]);
    }
    for (const auto& [name, sums] : all_sums) sums.print(name.c_str(), "mm");
    coverage.print("expressions");

    std::puts("absolute volume between face and true neutral face");
    std::map<std::string, Sums> mouth_sums, face_sums;
    for (Index k = 0; k < test.num_faces(); ++k) {
        const std::string& name =
            test.expression_names()[static_cast<std::size_t>(test.expression(k))];
        if (name != "mouth_stretch" && name != "grin" && name != "lip_funneler" &&
            name != "cheek_blowing")
            continue;
        test.face(k, face);
        const Points& truth = neutral_of.at(test.subject(k));
        const Points result = neutralized(*model, face, Vector());
        auto volume = [&](const Points& other, const std::vector<Zone>& zone) {
            return measure_volume(truth, other, test.triangles(), zone, context)
                .zones[0]
                .volume.absolute_ml;
        };
        mouth_sums[name].add(volume(face, mouth), volume(result, mouth), false);
        face_sums[name].add(volume(face, face_zone), volume(result, face_zone), false);
    }
    for (const auto& [name, sums] : mouth_sums) sums.print(("mouth, " + name).c_str(), "mL");
    for (const auto& [name, sums] : face_sums) sums.print(("face, " + name).c_str(), "mL");

    std::puts("lip_puckerer held out of training");
    int held = -1;
    for (std::size_t e = 0; e < train->expression_names().size(); ++e)
        if (train->expression_names()[e] == "lip_puckerer") held = static_cast<int>(e);
    const auto partial =
        train_expression_model(Without(dataset_columns(train, {}), held), {}, context);
    for (FitMethod method : {FitMethod::mixture, FitMethod::map}) {
        Sums sums;
        NeutralizeOptions options;
        options.fit.method = method;
        for (Index k = 0; k < test.num_faces(); ++k) {
            if (test.expression(k) != held) continue;
            test.face(k, face);
            const Points& truth = neutral_of.at(test.subject(k));
            const NeutralizationResult result =
                neutralize(context, *partial, face, Vector(), options);
            sums.add(mean_distance(face, truth), mean_distance(result.neutral_vertices, truth),
                     !neutralization_warnings(*partial, result).empty());
        }
        sums.print(method == FitMethod::mixture ? "mixture" : "map", "mm");
    }

    std::puts("one-sided: the left half of an expression, running out over 20 mm");
    for (const char* name : {"smile", "grin", "dimpler"})
        for (FitMethod method : {FitMethod::mixture, FitMethod::map}) {
            Sums sums;
            NeutralizeOptions options;
            options.fit.method = method;
            for (Index k = 0; k < test.num_faces(); ++k) {
                if (test.expression_names()[static_cast<std::size_t>(test.expression(k))] != name)
                    continue;
                test.face(k, face);
                const Points& truth = neutral_of.at(test.subject(k));
                for (Index i = 0; i < face.rows(); ++i) {
                    const double share =
                        std::min(1.0, std::max(0.0, 0.5 + model->mean(i, 0) / 20.0));
                    face.row(i) = truth.row(i) + share * share * (3.0 - 2.0 * share) *
                                                     (face.row(i) - truth.row(i));
                }
                const NeutralizationResult result =
                    neutralize(context, *model, face, Vector(), options);
                sums.add(mean_distance(face, truth), mean_distance(result.neutral_vertices, truth),
                         !neutralization_warnings(*model, result).empty());
            }
            sums.print((std::string(name) + (method == FitMethod::mixture ? ", mixture" : ", map"))
                           .c_str(),
                       "mm");
        }

    std::puts("the subject's right half unseen (weights zero, no coordinates)");
    Sums seen_half, unseen_half;
    Coverage seen_coverage, unseen_coverage;
    for (Index k = 0; k < test.num_faces(); k += 7) {
        if (test.expression(k) == test.neutral_expression()) continue;
        test.face(k, face);
        const Points& truth = neutral_of.at(test.subject(k));
        Vector weights = Vector::Ones(face.rows());
        Points damaged = face;
        for (Index i = 0; i < face.rows(); ++i)
            if (model->mean(i, 0) < 0.0) {
                weights[i] = 0.0;
                damaged.row(i).setConstant(std::nan(""));
            }
        const NeutralizationResult whole = neutralize(context, *model, damaged, weights, stating);
        const Points& result = whole.neutral_vertices;
        const bool warning = !neutralization_warnings(*model, whole).empty();
        double seen[2] = {0, 0}, unseen[2] = {0, 0};
        Index count = 0;
        for (Index i = 0; i < face.rows(); ++i) {
            const double before = (face.row(i) - truth.row(i)).norm();
            const double after = (result.row(i) - truth.row(i)).norm();
            (weights[i] > 0 ? seen : unseen)[0] += before;
            (weights[i] > 0 ? seen : unseen)[1] += after;
            count += weights[i] > 0;
            (weights[i] > 0 ? seen_coverage : unseen_coverage).add(after, whole.uncertainty_mm[i]);
        }
        seen_half.add(seen[0] / count, seen[1] / count, warning);
        unseen_half.add(unseen[0] / (face.rows() - count), unseen[1] / (face.rows() - count),
                        warning);
    }
    seen_half.print("seen half", "mm");
    unseen_half.print("unseen half (made up)", "mm");
    seen_coverage.print("seen half");
    unseen_coverage.print("unseen half");

    std::puts("series of four scans of one person with four expressions");
    for (double share : {0.001, 0.01, 0.1}) {
        double alone = 0, together = 0;
        int count = 0;
        for (Index first = 0; first + 20 <= test.num_faces(); first += 20) {
            std::vector<VisitFace> scans;
            Points truth;
            for (Index k :
                 {Index(1), Index(2 + (first / 20) % 5), Index(9 + (first / 20) % 4), Index(17)}) {
                VisitFace scan;
                test.face(first + k, scan.vertices);
                truth = neutral_of.at(test.subject(first));
                alone += 0.25 * mean_distance(neutralized(*model, scan.vertices, Vector()), truth);
                scans.push_back(std::move(scan));
            }
            VisitsOptions options;
            options.noise = JointNoise::isotropic;
            options.face_noise_share = share;
            together += mean_distance(
                neutralize_visits(context, *model, scans, options).shared_vertices, truth);
            ++count;
        }
        std::printf(
            "  scan noise share %5.3f: each alone %.4f mm, series %.4f mm (%.1f %% lower)\n", share,
            alone / count, together / count, 100 * (1 - together / alone));
    }
    return 0;
} catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
