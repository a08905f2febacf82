#include "measure/norms.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json_text.hpp"
#include "base/json_value.hpp"

namespace mien {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Sum {
    double value = 0.0, squares = 0.0;
    Index count = 0;
};

/// One person's measurements: the mean over that person's neutral faces.
using Person = std::vector<Sum>;

void check(const Norm& norm) {
    if (!std::isfinite(norm.mean) || !(norm.sd >= 0) || !std::isfinite(norm.sd))
        fail(Status::invalid_argument, "the norm '%.60s' has the mean %g and the deviation %g",
             norm.name.c_str(), norm.mean, norm.sd);
    if (norm.people < kFewestNormPeople)
        fail(Status::invalid_argument, "the norm '%.60s' stands on %lld people; %lld are needed",
             norm.name.c_str(), static_cast<long long>(norm.people),
             static_cast<long long>(kFewestNormPeople));
}

Norm norm_over(const AnthropometricDefinition& definition, const std::map<int, Person>& people,
               std::size_t k) {
    std::vector<double> values;
    for (const auto& [subject, person] : people)
        if (person[k].count > 0)
            values.push_back(person[k].value / static_cast<double>(person[k].count));
    Norm norm;
    norm.name = definition.name;
    norm.people = static_cast<Index>(values.size());
    const double count = static_cast<double>(values.size());
    for (const double value : values) norm.mean += value / count;
    for (const double value : values)
        norm.sd += (value - norm.mean) * (value - norm.mean) / (count - 1.0);
    norm.sd = std::sqrt(norm.sd);
    return norm;
}

double member(const JsonValue& norm, const char* key, const std::string& path,
              const std::string& name) {
    const JsonValue* value = norm.find(key);
    if (value == nullptr || !value->is(JsonValue::Kind::number))
        fail(Status::bad_format, "%s: the norm '%.60s' has no number '%s'",
             shown_path(path).c_str(), name.c_str(), key);
    return value->number;
}

}  // namespace

NormSet::NormSet(std::vector<Norm> list) : list_(std::move(list)) {
    for (std::size_t i = 0; i < list_.size(); ++i) {
        check(list_[i]);
        for (std::size_t j = 0; j < i; ++j)
            if (list_[i].name == list_[j].name)
                fail(Status::invalid_argument, "the norm '%.60s' is given twice",
                     list_[i].name.c_str());
    }
}

const Norm* NormSet::find(const std::string& name) const {
    for (const Norm& norm : list_)
        if (norm.name == name) return &norm;
    return nullptr;
}

NormScore score_against(const NormSet* norms, const AnthropometricValue& value) {
    const Norm* norm = norms != nullptr ? norms->find(value.definition->name) : nullptr;
    if (norm == nullptr) return {kUnknown, kUnknown, kUnknown, kUnknown, 0};
    NormScore score{kUnknown, kUnknown, norm->mean, norm->sd, norm->people};
    if (norm->sd > 0) {
        score.z = (value.value - norm->mean) / norm->sd;
        score.sd = value.sd / norm->sd;
    }
    return score;
}

NormSet norms_of_dataset(const FaceDataset& dataset, const std::vector<FacePlace>& places,
                         const Context& context) {
    if (dataset.neutral_expression() < 0)
        fail(Status::not_found,
             "the dataset has no expression named 'neutral'; norms need neutral faces");
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i].vertex < 0)
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(i),
                    "the landmark '%.60s' is a place and no vertex; norms need vertices of the "
                    "dataset's faces",
                    places[i].name.c_str());
    const auto& definitions = anthropometric_definitions();
    std::map<int, Person> people;
    TriMesh face;
    face.triangles = dataset.triangles();
    for (Index k = 0; k < dataset.num_faces(); ++k) {
        context.progress(Stage::measuring,
                         static_cast<double>(k) / static_cast<double>(dataset.num_faces()));
        if (dataset.expression(k) != dataset.neutral_expression()) continue;
        dataset.face(k, face.vertices);
        dataset.release_face(k);
        const std::vector<AnthropometricValue> values =
            measure_anthropometry(face, places, AnthropometryErrors(), context);
        Person& person = people[dataset.subject(k)];
        person.resize(definitions.size());
        for (std::size_t m = 0; m < values.size(); ++m)
            if (values[m].reason.empty()) {
                person[m].value += values[m].value;
                ++person[m].count;
            }
    }
    if (static_cast<Index>(people.size()) < kFewestNormPeople)
        fail(Status::invalid_argument,
             "the dataset has neutral faces of %zu people; norms need %lld", people.size(),
             static_cast<long long>(kFewestNormPeople));
    std::vector<Norm> list;
    for (std::size_t m = 0; m < definitions.size(); ++m) {
        const Norm norm = norm_over(definitions[m], people, m);
        if (norm.people >= kFewestNormPeople) list.push_back(norm);
    }
    if (list.empty())
        fail(Status::not_found,
             "none of the measurements has its landmarks among the %zu given; names such as "
             "'pronasale' or 'mouth_outer_00' are known",
             places.size());
    context.progress(Stage::measuring, 1.0);
    return NormSet(std::move(list));
}

std::string norms_json(const NormSet& norms) {
    JsonText json;
    json.begin_object().key("norms").begin_object();
    for (const Norm& norm : norms.list()) {
        json.key(norm.name).begin_object();
        json.field("mean", norm.mean);
        json.field("sd", norm.sd);
        json.field("people", static_cast<std::int64_t>(norm.people));
        json.end_object();
    }
    json.end_object().end_object();
    return json.take();
}

NormSet parse_norms(const char* data, std::size_t size, const std::string& path) {
    const JsonValue root = parse_json_value(data, size, shown_path(path).c_str());
    const JsonValue* listed = root.find("norms");
    if (listed == nullptr || !listed->is(JsonValue::Kind::object))
        fail(Status::bad_format,
             "%s: expected {\"norms\": {name: {\"mean\": x, \"sd\": x, \"people\": n}}}",
             shown_path(path).c_str());
    std::vector<Norm> list;
    for (std::size_t i = 0; i < listed->items.size(); ++i) {
        const JsonValue& one = listed->items[i];
        Norm norm;
        norm.name = listed->keys[i];
        norm.mean = member(one, "mean", path, norm.name);
        norm.sd = member(one, "sd", path, norm.name);
        const double people = member(one, "people", path, norm.name);
        if (!(people >= 0 && people <= 1e9))
            fail(Status::bad_format, "%s: the norm '%.60s' stands on %g people",
                 shown_path(path).c_str(), norm.name.c_str(), people);
        norm.people = static_cast<Index>(people);
        list.push_back(std::move(norm));
    }
    return NormSet(std::move(list));
}

NormSet read_norms(const std::string& path, const Context& context) {
    const FileBytes bytes = read_whole_file(path, context);
    return parse_norms(bytes.data, bytes.size, path);
}

void write_norms(const std::string& path, const NormSet& norms) {
    AtomicFile file(path);
    file.write(norms_json(norms) + "\n");
    file.commit();
}

}  // namespace mien
