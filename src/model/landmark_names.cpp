#include "model/landmark_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/json.hpp"
#include "geometry/alignment.hpp"

namespace mien {
namespace {

constexpr int kScheme = 68;

/// MediaPipe's numbers in the order of the 68; -1: lies elsewhere (its outline of the face).
constexpr std::array<int, kScheme> kMediaPipe = {
    -1,  -1,  -1,  -1,  -1,  -1,  -1,  -1,  152, -1,  -1,  -1,  -1,  -1,  -1,  -1, -1,
    71,  63,  105, 66,  107, 336, 296, 334, 293, 301, 168, 197, 5,   4,   75,  97, 2,
    326, 305, 33,  160, 158, 133, 153, 144, 362, 385, 387, 263, 373, 380, 61,  39, 37,
    0,   267, 269, 291, 405, 314, 17,  84,  181, 78,  82,  13,  312, 308, 317, 14, 87};

/// Name of the scheme's k-th landmark without separators and leading zeros.
std::string scheme_name(int k) {
    struct Part {
        const char* name;
        int count;
    };
    static constexpr Part kParts[] = {{"jaw", 17},       {"browright", 5},   {"browleft", 5},
                                      {"nosebridge", 4}, {"nosebase", 5},    {"eyeright", 6},
                                      {"eyeleft", 6},    {"mouthouter", 12}, {"mouthinner", 8}};
    for (const Part& part : kParts) {
        if (k < part.count) return part.name + std::to_string(k);
        k -= part.count;
    }
    return std::string();
}

std::string plain_name(const std::string& name) {
    std::string plain;
    for (std::size_t i = 0; i < name.size(); ++i) {
        char c = name[i];
        if (c == '_' || c == '-' || c == '.' || c == ' ') continue;
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        const bool after_digit = i > 0 && name[i - 1] >= '0' && name[i - 1] <= '9';
        const bool before_digit = i + 1 < name.size() && name[i + 1] >= '0' && name[i + 1] <= '9';
        if (c == '0' && before_digit && !after_digit) {
            while (i + 2 < name.size() && name[i + 1] == '0' && name[i + 2] >= '0' &&
                   name[i + 2] <= '9')
                ++i;
            continue;
        }
        plain += c;
    }
    return plain;
}

/// A number of 1 to 3 digits, or -1.
int number_of(const std::string& name) {
    if (name.empty() || name.size() > 3) return -1;
    int number = 0;
    for (const char c : name) {
        if (c < '0' || c > '9') return -1;
        number = 10 * number + (c - '0');
    }
    return number;
}

using Numbers = std::map<std::string, int>;

/// The model's landmarks by plain name; names that only differ in what is left out stand for none.
Numbers plain_landmarks(const DeformationModel& model) {
    Numbers plain;
    for (std::size_t i = 0; i < model.landmarks.size(); ++i) {
        const auto [place, fresh] =
            plain.emplace(plain_name(model.landmarks[i].name), static_cast<int>(i));
        if (!fresh) place->second = -1;
    }
    return plain;
}

NameMatch match_by_name(const DeformationModel& model, const Numbers& plain,
                        const std::vector<Mark>& marks) {
    Numbers exact;
    for (std::size_t i = 0; i < model.landmarks.size(); ++i)
        exact.emplace(model.landmarks[i].name, static_cast<int>(i));
    NameMatch match;
    match.scheme = "names";
    for (const Mark& mark : marks) {
        Numbers::const_iterator found = exact.find(mark.name);
        int number = found == exact.end() ? -1 : found->second;
        if (number < 0 && (found = plain.find(plain_name(mark.name))) != plain.end())
            number = found->second;
        match.landmark.push_back(number);
        match.matched += number >= 0;
    }
    return match;
}

/// Numbers of the file -> the scheme's 68 -> the model's landmarks.
NameMatch match_by_number(const Numbers& plain, const std::vector<Mark>& marks, const char* scheme,
                          int first) {
    std::map<int, int> place_of;  // number in the file -> place among the 68
    for (int k = 0; k < kScheme; ++k) {
        const int number = first >= 0 ? k + first : kMediaPipe[static_cast<std::size_t>(k)];
        if (number >= 0) place_of[number] = k;
    }
    NameMatch match;
    match.scheme = scheme;
    for (const Mark& mark : marks) {
        const auto place = place_of.find(number_of(mark.name));
        int landmark = -1;
        if (place != place_of.end()) {
            const auto known = plain.find(scheme_name(place->second));
            if (known != plain.end()) landmark = known->second;
        }
        match.landmark.push_back(landmark);
        match.matched += landmark >= 0;
    }
    return match;
}

/// How badly the places lie beside the template's, relative to their extent; infinite when too few
/// are known to say so.
double misfit(const DeformationModel& model, const std::vector<Mark>& marks,
              const NameMatch& match) {
    constexpr Index kFewest = 6;
    Points from(static_cast<Index>(marks.size()), 3), to(from.rows(), 3);
    Index count = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (match.landmark[i] < 0 || marks[i].where != Mark::Where::place) continue;
        const Landmark& landmark = model.landmarks[static_cast<std::size_t>(match.landmark[i])];
        from.row(count) = marks[i].point.transpose();
        to.row(count++) = model.template_mesh.vertices.row(landmark.vertex);
    }
    if (count < kFewest) return HUGE_VAL;
    const Points a = from.topRows(count), b = to.topRows(count);
    try {
        const Similarity motion = align_points(a, b, Vector(), true);
        const Eigen::RowVector3d middle = b.colwise().mean();
        return std::sqrt((motion.apply(PointsRef(a)) - b).squaredNorm() /
                         (b.rowwise() - middle).squaredNorm());
    } catch (const Error&) {
        return HUGE_VAL;
    }
}

/// The numbering schemes that all given numbers fit into.
std::vector<NameMatch> possible_schemes(const Numbers& plain, const std::vector<Mark>& marks) {
    int low = 1000, high = -1;
    for (const Mark& mark : marks) {
        const int number = number_of(mark.name);
        if (number < 0) return {};
        low = std::min(low, number);
        high = std::max(high, number);
    }
    std::vector<NameMatch> schemes;
    if (low >= 1 && high <= kScheme)
        schemes.push_back(match_by_number(plain, marks, "iBUG-68 from 1", 1));
    if (high < kScheme) schemes.push_back(match_by_number(plain, marks, "iBUG-68 from 0", 0));
    if (high < 478) schemes.push_back(match_by_number(plain, marks, "MediaPipe", -1));
    return schemes;
}

/// The scheme whose places lie like the template's; without places, the one that the numbers fill.
NameMatch choose_scheme(const DeformationModel& model, std::vector<NameMatch> schemes,
                        const std::vector<Mark>& marks, const NameMatch& none) {
    constexpr double kClearly = 1.5;  // ratio of misfits above which the better one is taken
    const NameMatch* best = &none;
    double lowest = HUGE_VAL, second = HUGE_VAL;
    std::size_t known = 0;
    for (const NameMatch& scheme : schemes) {
        if (scheme.matched == 0) continue;
        ++known;
        const double wrong = misfit(model, marks, scheme);
        second = std::min(second, std::max(lowest, wrong));
        if (wrong < lowest) lowest = wrong, best = &scheme;
    }
    if (std::isinf(lowest)) {
        const auto fullest =
            std::max_element(schemes.begin(), schemes.end(),
                             [](const auto& a, const auto& b) { return a.matched < b.matched; });
        if (fullest != schemes.end() && fullest->matched > 0) {
            best = &*fullest;
            for (const NameMatch& scheme : schemes)
                if (&scheme != best && scheme.matched == best->matched) second = 0;
        }
    }
    if (known > 1 && second < kClearly * lowest && !(std::isinf(lowest) && std::isinf(second)))
        fail(Status::invalid_argument,
             "the landmarks' numbers fit more than one numbering (iBUG-68 from 0, from 1, "
             "MediaPipe); give names instead, such as %s",
             known_landmark_examples(model).c_str());
    return *best;
}

void refuse_doubled(const DeformationModel& model, const std::vector<Mark>& marks,
                    const NameMatch& match) {
    std::map<int, std::size_t> first;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (match.landmark[i] < 0) continue;
        const auto [place, fresh] = first.emplace(match.landmark[i], i);
        if (!fresh)
            fail(Status::invalid_argument,
                 "the landmarks '%s' and '%s' both mean '%s' of the model; keep one of them",
                 shown_name(marks[place->second].name).c_str(), shown_name(marks[i].name).c_str(),
                 model.landmarks[static_cast<std::size_t>(match.landmark[i])].name.c_str());
    }
}

}  // namespace

NameMatch match_landmark_names(const DeformationModel& model, const std::vector<Mark>& marks) {
    const Numbers plain = plain_landmarks(model);
    NameMatch best = match_by_name(model, plain, marks);
    if (best.matched == 0) best = choose_scheme(model, possible_schemes(plain, marks), marks, best);
    if (best.matched == 0) best.scheme.clear();
    refuse_doubled(model, marks, best);
    return best;
}

std::string known_landmark_examples(const DeformationModel& model) {
    constexpr std::size_t kShown = 4;
    const std::size_t count = model.landmarks.size();
    if (count == 0) return "(the model has no landmarks)";
    std::string text;
    for (std::size_t k = 0; k < std::min(kShown, count); ++k) {
        const std::size_t i = count <= kShown ? k : k * (count - 1) / (kShown - 1);
        text += (k > 0 ? ", '" : "'") + shown_name(model.landmarks[i].name) + "'";
    }
    return text;
}

void require_known_landmark(const DeformationModel& model, const NameMatch& match,
                            const std::vector<Mark>& marks) {
    if (match.matched > 0 || marks.empty()) return;
    fail(Status::not_found,
         "none of the %zu landmarks ('%.40s', ...) is known to the model; it knows names such as "
         "%s, and numbers of iBUG-68 and MediaPipe where it has their 68 names",
         marks.size(), shown_name(marks[0].name).c_str(), known_landmark_examples(model).c_str());
}

}  // namespace mien
