#include "demo_faces.hpp"

#include <algorithm>

#include "people.hpp"
#include "scanner.hpp"

namespace mien::demo {

struct DemoFaces::Parts {
    Anatomy anatomy;
    IdentityBasis basis;
    FaceMesh mesh;
    std::vector<std::pair<std::string, std::uint32_t>> landmarks;
    std::vector<std::pair<std::string, std::vector<std::uint32_t>>> zones;
    std::vector<std::uint32_t> lips, mirror;
    std::vector<std::vector<double>> directions;
};

namespace {

std::vector<double> flat(const std::vector<V3>& points, int count) {
    std::vector<double> out;
    out.reserve(3 * static_cast<std::size_t>(count));
    for (int v = 0; v < count; ++v) out.insert(out.end(), {points[v].x, points[v].y, points[v].z});
    return out;
}

}  // namespace

DemoFaces::DemoFaces() {
    auto parts = std::make_unique<Parts>();
    parts->anatomy = make_anatomy();
    parts->basis = make_identity_basis(parts->anatomy);
    const TemplateHead& head = parts->anatomy.head;
    parts->mesh.vertices = flat(head.points, parts->anatomy.count());
    for (const auto& t : head.triangles)
        for (int v : t) parts->mesh.triangles.push_back(static_cast<std::uint32_t>(v));
    for (const auto& c : head.colors)
        parts->mesh.colors.insert(parts->mesh.colors.end(), c.begin(), c.end());
    for (const auto& [name, vertex] : head.landmarks)
        parts->landmarks.emplace_back(name, static_cast<std::uint32_t>(vertex));
    for (const auto& [name, members] : head.zones)
        parts->zones.emplace_back(name, std::vector<std::uint32_t>(members.begin(), members.end()));
    parts->lips.assign(head.lips.begin(), head.lips.end());
    parts->mirror.assign(head.mirror.begin(), head.mirror.end());
    for (const auto& field : parts->basis.directions)
        parts->directions.push_back(flat(field, parts->anatomy.count()));
    parts_ = std::move(parts);
}

DemoFaces::~DemoFaces() = default;

const FaceMesh& DemoFaces::template_mesh() const {
    return parts_->mesh;
}
const std::vector<std::pair<std::string, std::uint32_t>>& DemoFaces::landmarks() const {
    return parts_->landmarks;
}
const std::vector<std::pair<std::string, std::vector<std::uint32_t>>>& DemoFaces::zones() const {
    return parts_->zones;
}
const std::vector<std::uint32_t>& DemoFaces::lips() const {
    return parts_->lips;
}
const std::vector<std::uint32_t>& DemoFaces::mirror() const {
    return parts_->mirror;
}
const std::vector<std::string>& DemoFaces::identity_names() const {
    return parts_->basis.names;
}
const std::vector<double>& DemoFaces::identity_direction(int k) const {
    return parts_->directions.at(static_cast<std::size_t>(k));
}

Person DemoFaces::person(std::uint64_t seed, int subject) const {
    Person person;
    person.seed = seed;
    person.subject = subject;
    Random random(seed, 1000003u * static_cast<std::uint64_t>(subject) + 1);
    for (std::size_t k = 0; k < identity_names().size(); ++k)
        person.weights.push_back(clamp(random.normal(), -2.5, 2.5));
    person.liveliness = clamp(1 + 0.15 * random.normal(), 0.65, 1.25);
    return person;
}

Person DemoFaces::nonlinear_person(std::uint64_t seed, int subject) const {
    Person made = person(seed, subject);
    // Twelve directions, the others are still: with the places they make 48 numbers.
    for (std::size_t k = 12; k < made.weights.size(); ++k) made.weights[k] = 0;
    Random random(seed, 1000003u * static_cast<std::uint64_t>(subject) + 29);
    for (int k = 0; k < kNumPlaces; ++k) made.places.push_back(clamp(random.normal(), -2.5, 2.5));
    made.detail_mm = 0.08;
    made.strength_noise = 0.03;
    return made;
}

Person DemoFaces::without_chance(Person person) {
    person.detail_mm = 0;
    person.strength_noise = 0;
    return person;
}

std::vector<double> DemoFaces::face(const Person& person, int expression) const {
    const int known = static_cast<int>(expression_names().size());
    if (expression < 0 || expression >= known) return {};
    const auto neutral = neutral_shape(parts_->anatomy, parts_->basis, person);
    return flat(express(parts_->anatomy, neutral, person, expression), parts_->anatomy.count());
}

std::vector<std::vector<double>> DemoFaces::all_faces(const Person& person) const {
    const auto neutral = neutral_shape(parts_->anatomy, parts_->basis, person);
    std::vector<std::vector<double>> all;
    for (int e = 0; e < static_cast<int>(expression_names().size()); ++e)
        all.push_back(flat(express(parts_->anatomy, neutral, person, e), parts_->anatomy.count()));
    return all;
}

SimulatedScan DemoFaces::scan(const Person& person, int expression,
                              const ScanOptions& options) const {
    const auto neutral = neutral_shape(parts_->anatomy, parts_->basis, person);
    const auto shape = express(parts_->anatomy, neutral, person, expression);
    return simulate_scan(parts_->anatomy, neutral, shape, person, options);
}

}  // namespace mien::demo
