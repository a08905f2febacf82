// What neutralization does off the beaten track, and to volumes:
//
//   expression_stress TRAIN TEST MOUTH FACE [ODD]
//
// TRAIN and TEST are data sets of shared/tools/make_faces20.py, MOUTH and FACE files of vertex numbers
// (one per line), ODD a data set with an expression that no training set has. Prints volume errors per
// zone against the untouched face (tables A.1 and 4.3), an expression held out of training, the odd
// expression, half of the face unseen, and a series of four scans of one person.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "expression/evaluation.hpp"
#include "expression/series.hpp"
#include "expression/training.hpp"
#include "measure/volume.hpp"

using namespace mien;

namespace {

std::vector<std::uint32_t> numbers(const char* path) {
    std::ifstream in(path);
    std::vector<std::uint32_t> values;
    for (std::uint32_t value; in >> value;) values.push_back(value);
    return values;
}

/// A source without one expression.
class Without final : public ColumnSource {
  public:
    Without(std::unique_ptr<ColumnSource> all, int expression) : all_(std::move(all)) {
        num_vertices = all_->num_vertices;
        triangles = all_->triangles;
        expression_names = all_->expression_names;
        neutral_subject = all_->neutral_subject;
        for (Index k = 0; k < all_->num_displacements(); ++k) {
            const auto place = static_cast<std::size_t>(k);
            if (all_->displacement_expression[place] == expression) continue;
            kept_.push_back(k);
            displacement_subject.push_back(all_->displacement_subject[place]);
            displacement_expression.push_back(all_->displacement_expression[place]);
        }
    }
    void neutrals(Index begin, Eigen::Ref<Matrix> block) const override { all_->neutrals(begin, block); }
    void displacements(Index begin, Eigen::Ref<Matrix> block) const override {
        for (Index k = 0; k < block.cols(); ++k)
            all_->displacements(kept_[static_cast<std::size_t>(begin + k)], block.middleCols(k, 1));
    }

  private:
    std::unique_ptr<ColumnSource> all_;
    std::vector<Index> kept_;
};

double mean_distance(const Points& a, const Points& b) { return (a - b).rowwise().norm().mean(); }

struct Sums {
    double before = 0, after = 0, worst_ratio = 0;
    int count = 0, worse = 0;
    void add(double untouched, double neutralized) {
        before += untouched;
        after += neutralized;
        ++count;
        worse += neutralized > untouched;
    }
    void print(const char* name, const char* unit) const {
        std::printf("  %-28s untouched %8.3f %s, neutralized %8.3f %s = %5.1f %%, worse than the input %d of %d\n", name,
                    before / count, unit, after / count, unit, 100 * after / before, worse, count);
    }
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 5) return std::puts("expression_stress TRAIN TEST MOUTH FACE [ODD]"), 2;
    ThreadPool pool(2);
    Context context;
    context.pool = &pool;
    auto train = std::make_shared<FaceDataset>(FaceDataset::open(argv[1], {false, false}, context));
    const FaceDataset test = FaceDataset::open(argv[2], {}, context);
    const auto model = train_expression_model(train, {}, context);
    const std::vector<Zone> mouth{{"mouth", numbers(argv[3])}}, face_zone{{"face", numbers(argv[4])}};
    std::map<int, Points> neutral_of;
    Points face;
    for (Index k = 0; k < test.num_faces(); ++k)
        if (test.expression(k) == test.neutral_expression()) test.face(k, neutral_of[test.subject(k)]);
    auto neutralized = [&](const ExpressionModel& with, const Points& vertices, const Vector& weights) {
        return neutralize(context, with, vertices, weights, {}).neutral_vertices;
    };

    std::puts("absolute volume between face and true neutral face");
    std::map<std::string, Sums> mouth_sums, face_sums;
    for (Index k = 0; k < test.num_faces(); ++k) {
        const std::string& name = test.expression_names()[static_cast<std::size_t>(test.expression(k))];
        if (name != "mouth_stretch" && name != "grin" && name != "lip_funneler" && name != "cheek_blowing")
            continue;
        test.face(k, face);
        const Points& truth = neutral_of.at(test.subject(k));
        const Points result = neutralized(*model, face, Vector());
        auto volume = [&](const Points& other, const std::vector<Zone>& zone) {
            return measure_volume(truth, other, test.triangles(), zone, context).zones[0].volume.absolute_ml;
        };
        mouth_sums[name].add(volume(face, mouth), volume(result, mouth));
        face_sums[name].add(volume(face, face_zone), volume(result, face_zone));
    }
    for (const auto& [name, sums] : mouth_sums) sums.print(("mouth, " + name).c_str(), "mL");
    for (const auto& [name, sums] : face_sums) sums.print(("face, " + name).c_str(), "mL");

    std::puts("lip_puckerer held out of training");
    int held = -1;
    for (std::size_t e = 0; e < train->expression_names().size(); ++e)
        if (train->expression_names()[e] == "lip_puckerer") held = static_cast<int>(e);
    const auto partial = train_expression_model(Without(dataset_columns(train, {}), held), {}, context);
    for (FitMethod method : {FitMethod::mixture, FitMethod::map}) {
        Sums sums;
        NeutralizeOptions options;
        options.fit.method = method;
        for (Index k = 0; k < test.num_faces(); ++k) {
            if (test.expression(k) != held) continue;
            test.face(k, face);
            const Points& truth = neutral_of.at(test.subject(k));
            sums.add(mean_distance(face, truth),
                     mean_distance(neutralize(context, *partial, face, Vector(), options).neutral_vertices, truth));
        }
        sums.print(method == FitMethod::mixture ? "mixture" : "map", "mm");
    }

    if (argc > 5) {
        std::puts("an expression that no training face shows");
        const FaceDataset odd = FaceDataset::open(argv[5], {}, context);
        for (FitMethod method : {FitMethod::mixture, FitMethod::map}) {
            Sums sums;
            NeutralizeOptions options;
            options.fit.method = method;
            Points truth;
            for (Index k = 0; k + 1 < odd.num_faces(); k += 2) {
                odd.face(k, truth);
                odd.face(k + 1, face);
                sums.add(mean_distance(face, truth),
                         mean_distance(neutralize(context, *model, face, Vector(), options).neutral_vertices, truth));
            }
            sums.print(method == FitMethod::mixture ? "mixture" : "map", "mm");
        }
    }

    std::puts("the subject's right half unseen (weights zero, coordinates moved by 50 mm)");
    Sums seen_half, unseen_half;
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
        const Points result = neutralized(*model, damaged, weights);
        double seen[2] = {0, 0}, unseen[2] = {0, 0};
        Index count = 0;
        for (Index i = 0; i < face.rows(); ++i) {
            const double before = (face.row(i) - truth.row(i)).norm();
            const double after = (result.row(i) - truth.row(i)).norm();
            (weights[i] > 0 ? seen : unseen)[0] += before;
            (weights[i] > 0 ? seen : unseen)[1] += after;
            count += weights[i] > 0;
        }
        seen_half.add(seen[0] / count, seen[1] / count);
        unseen_half.add(unseen[0] / (face.rows() - count), unseen[1] / (face.rows() - count));
    }
    seen_half.print("seen half", "mm");
    unseen_half.print("unseen half (made up)", "mm");

    std::puts("series of four scans of one person with four expressions");
    for (double share : {0.001, 0.01, 0.1}) {
        double alone = 0, together = 0;
        int count = 0;
        for (Index first = 0; first + 20 <= test.num_faces(); first += 20) {
            std::vector<SeriesScan> scans;
            Points truth;
            for (Index k : {Index(1), Index(2 + (first / 20) % 5), Index(9 + (first / 20) % 4), Index(17)}) {
                SeriesScan scan;
                test.face(first + k, scan.vertices);
                truth = neutral_of.at(test.subject(first));
                alone += 0.25 * mean_distance(neutralized(*model, scan.vertices, Vector()), truth);
                scans.push_back(std::move(scan));
            }
            SeriesOptions options;
            options.scan_noise_share = share;
            together += mean_distance(neutralize_series(context, *model, scans, options).identity_vertices, truth);
            ++count;
        }
        std::printf("  scan noise share %5.3f: each alone %.4f mm, series %.4f mm (%.1f %% lower)\n", share,
                    alone / count, together / count, 100 * (1 - together / alone));
    }
    return 0;
} catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
