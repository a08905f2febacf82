// What neutralization is held to, by one command:
//
//   expression_acceptance TRAIN TEST [--modes N] [--directions N] [--every K] [--threads N]
//
// TRAIN and TEST are data sets of make_faces20.py of different people (an entry "neutral" and other
// expressions); N modes of each kind, 0: found by hold-out (default); N directions of the person
// that an expression's mean follows; every K-th test person (1). Prints, in mm, mean distance of
// corresponding vertices before and after: all expressions, the neutral faces, the worst
// expression; the same with fewer training people; two expressions at once; a quarter of an
// expression; each of a few expressions held out of the training, and how many of those faces come
// with a warning; a neutral face fitted together with a quarter of an expression. Data sets of a
// wider --jitter or with --posture are given as TRAIN and TEST themselves.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "expression/neutralize.hpp"
#include "expression/training.hpp"
#include "expression/visits.hpp"
#include "expression_support.hpp"

using namespace mien;

namespace {

struct Options {
    Index modes = 0, every = 1, directions = PriorOptions().identity_directions;
    int threads = 2;
};

struct Sums {
    double before = 0, after = 0;
    int count = 0, warned = 0, worse_in_silence = 0;

    void add(const Points& face, const Points& truth, const NeutralizationResult& result,
             const ExpressionModel& model) {
        const double untouched = mean_distance(face, truth),
                     left = mean_distance(result.neutral_vertices, truth);
        const bool warning = !neutralization_warnings(model, result).empty();
        before += untouched;
        after += left;
        ++count;
        warned += warning;
        worse_in_silence += left > untouched && !warning;
    }
    double mean() const { return count > 0 ? after / count : 0.0; }
    void print(const std::string& name) const {
        if (count == 0) return;
        std::printf(
            "%-44s %4d faces  before %7.4f  after %7.4f  warned %4d  worse in silence %4d\n",
            name.c_str(), count, before / count, mean(), warned, worse_in_silence);
        std::fflush(stdout);
    }
};

/// The test people's faces, by person and expression.
class TestFaces {
  public:
    TestFaces(const FaceDataset& data, Index every) : data_(data) {
        std::map<int, Index> order;
        for (Index k = 0; k < data.num_faces(); ++k)
            order.emplace(data.subject(k), static_cast<Index>(order.size()));
        for (Index k = 0; k < data.num_faces(); ++k)
            if (order.at(data.subject(k)) % every == 0)
                places_[data.subject(k)].emplace(data.expression(k), k);
    }
    /// (person, expression) -> face.
    const std::map<int, std::map<int, Index>>& places() const { return places_; }
    Points face(Index place) const {
        Points vertices;
        data_.face(place, vertices);
        return vertices;
    }
    int neutral() const { return data_.neutral_expression(); }
    const std::string& name(int expression) const {
        return data_.expression_names()[static_cast<std::size_t>(expression)];
    }

  private:
    const FaceDataset& data_;
    std::map<int, std::map<int, Index>> places_;
};

class Acceptance {
  public:
    Acceptance(const Context& context, const TestFaces& faces) : context_(context), faces_(faces) {}

    /// Rows of all expressions, of the neutral faces and of the worst expression.
    void whole(const ExpressionModel& model, const std::string& name) const {
        std::map<int, Sums> by_expression;
        Sums moved, neutral;
        for (const auto& [person, places] : faces_.places()) {
            if (places.count(faces_.neutral()) == 0) continue;
            const Points truth = faces_.face(places.at(faces_.neutral()));
            for (const auto& [expression, place] : places) {
                const Points face = faces_.face(place);
                const NeutralizationResult result = fit(model, face);
                (expression == faces_.neutral() ? neutral : moved).add(face, truth, result, model);
                if (expression != faces_.neutral())
                    by_expression[expression].add(face, truth, result, model);
            }
        }
        moved.print(name + ": all expressions");
        neutral.print(name + ": neutral faces");
        const auto worst = std::max_element(
            by_expression.begin(), by_expression.end(),
            [](const auto& a, const auto& b) { return a.second.mean() < b.second.mean(); });
        if (worst != by_expression.end())
            worst->second.print(name + ": worst, " + faces_.name(worst->first));
    }

    /// `share` of one expression, or of two that follow each other in the set's order.
    void scaled(const ExpressionModel& model, double share, bool two,
                const std::string& name) const {
        Sums sums;
        for (const auto& [person, places] : faces_.places()) {
            if (places.count(faces_.neutral()) == 0) continue;
            const Points truth = faces_.face(places.at(faces_.neutral()));
            Points before;
            for (const auto& [expression, place] : places) {
                if (expression == faces_.neutral()) continue;
                const Points moved = share * (faces_.face(place) - truth);
                if (!two || before.rows() != 0) {
                    const Points face =
                        two ? Points(truth + moved + before) : Points(truth + moved);
                    sums.add(face, truth, fit(model, face), model);
                }
                before = moved;
            }
        }
        sums.print(name);
    }

    void one_expression(const ExpressionModel& model, int expression,
                        const std::string& name) const {
        Sums sums;
        for (const auto& [person, places] : faces_.places()) {
            if (places.count(faces_.neutral()) == 0 || places.count(expression) == 0) continue;
            const Points truth = faces_.face(places.at(faces_.neutral())),
                         face = faces_.face(places.at(expression));
            sums.add(face, truth, fit(model, face), model);
        }
        sums.print(name);
    }

    /// A neutral face together with a quarter of an expression, another for each person.
    void series(const ExpressionModel& model) const {
        double neutral_moved = 0, left = 0;
        int count = 0, still = 0, turn = 0;
        for (const auto& [person, places] : faces_.places()) {
            if (places.count(faces_.neutral()) == 0 || places.size() < 2) continue;
            auto other = places.begin();
            std::advance(other, turn++ % static_cast<int>(places.size()));
            if (other->first == faces_.neutral()) other = std::next(other);
            if (other == places.end()) other = places.begin();
            const Points truth = faces_.face(places.at(faces_.neutral()));
            VisitFace first, second;
            first.vertices = truth;
            second.vertices = truth + 0.25 * (faces_.face(other->second) - truth);
            VisitsOptions options;
            options.noise = JointNoise::isotropic;
            const VisitsResult result =
                neutralize_visits(context_, model, {first, second}, options);
            const double moved = mean_distance(result.neutral_vertices[0], truth);
            neutral_moved += moved;
            still += moved <= 0.1;
            left += mean_distance(result.neutral_vertices[1], truth);
            ++count;
        }
        if (count > 0)
            std::printf(
                "series: neutral with a quarter               %4d people the neutral moves %.4f, "
                "by "
                "at most 0.1 in %d; the quarter leaves %.4f\n",
                count, neutral_moved / count, still, left / count);
    }

  private:
    NeutralizationResult fit(const ExpressionModel& model, const Points& face) const {
        return neutralize(context_, model, face, Vector(), {});
    }
    const Context& context_;
    const TestFaces& faces_;
};

std::vector<int> first_people(const FaceDataset& data, std::size_t count) {
    std::vector<int> people;
    for (Index k = 0; k < data.num_faces() && people.size() < count; ++k)
        if (std::find(people.begin(), people.end(), data.subject(k)) == people.end())
            people.push_back(data.subject(k));
    return people;
}

Options read_options(int argc, char** argv) {
    Options options;
    for (int k = 3; k + 1 < argc; k += 2) {
        if (!std::strcmp(argv[k], "--modes")) options.modes = std::atoi(argv[k + 1]);
        if (!std::strcmp(argv[k], "--directions")) options.directions = std::atoi(argv[k + 1]);
        if (!std::strcmp(argv[k], "--every")) options.every = std::max(1, std::atoi(argv[k + 1]));
        if (!std::strcmp(argv[k], "--threads")) options.threads = std::atoi(argv[k + 1]);
    }
    return options;
}

void run(const Context& context, const Options& given, const char* train_path,
         const char* test_path) {
    const auto train =
        std::make_shared<FaceDataset>(FaceDataset::open(train_path, {false, false}, context));
    const FaceDataset test = FaceDataset::open(test_path, {}, context);
    const TestFaces faces(test, given.every);
    const Acceptance acceptance(context, faces);
    TrainOptions options;
    options.subspaces.identity_modes = options.subspaces.expression_modes = given.modes;
    options.prior.identity_directions = given.directions;
    TrainReport report;
    const auto model = train_expression_model(train, options, context, &report);
    for (const TriedModes& pair : report.tried_modes)
        std::printf("tried %lld + %lld modes: people left out %.4f mm\n",
                    static_cast<long long>(pair.identity), static_cast<long long>(pair.expression),
                    pair.held_out_mm);
    for (const TriedSmoothness& tried : report.tried_smoothness)
        std::printf("tried a smooth prior of %g mm2: people left out %.4f mm\n", tried.variance_mm2,
                    tried.held_out_mm);
    std::printf("noise %g mm2, %lld smooth modes\n", model->mixture_noise_mm2,
                static_cast<long long>(model->smooth_modes));
    std::printf("trained on %lld people: %lld + %lld modes\n",
                static_cast<long long>(report.subjects),
                static_cast<long long>(model->num_identity_modes()),
                static_cast<long long>(model->num_expression_modes()));
    acceptance.whole(*model, "all people");
    acceptance.scaled(*model, 0.25, false, "a quarter of an expression");
    acceptance.scaled(*model, 0.6, true, "two expressions at 0.6 each");
    acceptance.series(*model);
    for (const std::size_t people : {std::size_t{10}, std::size_t{20}, std::size_t{30}}) {
        const std::vector<int> kept = first_people(*train, people);
        if (kept.size() < people) break;
        const auto small = train_expression_model(*dataset_columns(train, kept), options, context);
        acceptance.whole(*small, std::to_string(people) + " people");
    }
    for (const char* held : {"lip_puckerer", "grin", "jaw_left", "cheek_blowing"}) {
        const std::vector<std::string>& names = train->expression_names();
        const auto at = std::find(names.begin(), names.end(), held);
        if (at == names.end()) continue;
        const int expression = static_cast<int>(at - names.begin());
        const auto partial = train_expression_model(Without(dataset_columns(train, {}), expression),
                                                    options, context);
        const auto in_test =
            std::find(test.expression_names().begin(), test.expression_names().end(), held);
        if (in_test == test.expression_names().end()) continue;
        acceptance.one_expression(*partial,
                                  static_cast<int>(in_test - test.expression_names().begin()),
                                  std::string(held) + ", held out");
    }
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3)
        return std::puts(
                   "expression_acceptance TRAIN TEST [--modes N] [--directions N] [--every K] "
                   "[--threads N]"),
               2;
    const Options options = read_options(argc, argv);
    ThreadPool pool(options.threads);
    Context context;
    context.pool = &pool;
    run(context, options, argv[1], argv[2]);
    return 0;
} catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
