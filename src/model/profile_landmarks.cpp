#include "model/profile_landmarks.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "model/mirror.hpp"

namespace mien {
namespace {

constexpr double kAboveEyes = 25.0;    ///< mm over the inner corners that the root can reach
constexpr double kAboveNasion = 30.0;  ///< mm that the brows' bulge can lie higher
/// A midline vertex with another one so far in front of it, mm, at about its height, mm, lies
/// behind the face: on the back of the head, inside the mouth.
constexpr double kInFront = 30.0, kSameHeight = 4.0;

std::string folded(const std::string& name) {
    std::string plain;
    for (const char c : name)
        if (c != '_' && c != '-' && c != ' ' && c != '.')
            plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return plain;
}

bool has(const std::vector<Landmark>& known, const char* name) {
    return std::any_of(known.begin(), known.end(),
                       [&](const Landmark& one) { return folded(one.name) == folded(name); });
}

class Profile {
  public:
    Profile(const TriMesh& mesh, const std::vector<Landmark>& known) : mesh_(mesh), known_(known) {
        const std::vector<std::uint32_t> partner = mirror_map(mesh, Context());
        std::vector<std::uint32_t> all;
        for (std::uint32_t v = 0; v < partner.size(); ++v)
            if (partner[v] == v) all.push_back(v);
        for (const std::uint32_t v : all)
            if (std::none_of(all.begin(), all.end(), [&](std::uint32_t other) {
                    return std::fabs(mesh.vertices(other, 1) - mesh.vertices(v, 1)) < kSameHeight &&
                           mesh.vertices(other, 2) - mesh.vertices(v, 2) > kInFront;
                }))
                middle_.push_back(v);
    }

    Vector3 place(const char* name) const {
        const auto at = std::find_if(known_.begin(), known_.end(), [&](const Landmark& one) {
            return folded(one.name) == folded(name);
        });
        if (at == known_.end())
            fail(Status::not_found,
                 "the landmarks lack '%s', from which those of the profile are searched", name);
        if (at->vertex >= static_cast<std::uint64_t>(mesh_.vertices.rows()))
            fail(Status::mismatch, "the landmark '%s' is vertex %u, the template has %lld", name,
                 at->vertex, static_cast<long long>(mesh_.vertices.rows()));
        return mesh_.vertices.row(at->vertex).transpose();
    }

    /// The midline's vertex between two heights with the greatest score.
    template <typename Score>
    std::uint32_t best(double low, double high, const char* name, Score&& score) const {
        double greatest = -HUGE_VAL;
        std::uint32_t found = 0;
        for (const std::uint32_t v : middle_) {
            const Vector3 x = mesh_.vertices.row(v).transpose();
            if (!(x.y() > low && x.y() < high)) continue;
            const double value = score(x);
            if (value > greatest) {
                greatest = value;
                found = v;
            }
        }
        if (greatest == -HUGE_VAL)
            fail(Status::invalid_mesh,
                 "the template has no vertex on its midline between y %.1f and %.1f, where '%s' is "
                 "searched; is +y up, +z forward?",
                 low, high, name);
        return found;
    }

    Vector3 at(std::uint32_t vertex) const { return mesh_.vertices.row(vertex).transpose(); }

  private:
    const TriMesh& mesh_;
    const std::vector<Landmark>& known_;
    std::vector<std::uint32_t> middle_;
};

}  // namespace

std::vector<Landmark> profile_landmarks(const TriMesh& template_mesh,
                                        const std::vector<Landmark>& known) {
    const Profile profile(template_mesh, known);
    const Vector3 tip = profile.place("nose_bridge_3"), base = profile.place("nose_base_2"),
                  lip = profile.place("mouth_outer_09"), chin = profile.place("jaw_08");
    const double eyes = 0.5 * (profile.place("eye_right_3").y() + profile.place("eye_left_0").y());
    const auto forward = [](const Vector3& x) { return x.z(); };
    const auto backward = [](const Vector3& x) { return -x.z(); };
    std::vector<Landmark> found;
    const auto add = [&](const char* name, std::uint32_t vertex) {
        if (!has(known, name)) found.push_back({name, vertex});
    };
    const std::uint32_t nasion = profile.best(tip.y(), eyes + kAboveEyes, "nasion", backward);
    const double root = profile.at(nasion).y();
    add("glabella", profile.best(root, root + kAboveNasion, "glabella", forward));
    add("nasion", nasion);
    // Outside of the chord, which the tip lies in front of and the base below.
    const Vector3 chord = (base - tip).normalized();
    add("columella", profile.best(base.y(), tip.y(), "columella", [&](const Vector3& x) {
        const Vector3 from = x - tip;
        return from.z() * -chord.y() + from.y() * chord.z();
    }));
    // The chin first: below its bulge the profile recedes farther than the hollow above it.
    const std::uint32_t bulge =
        profile.best(chin.y(), 0.5 * (chin.y() + lip.y()), "pogonion", forward);
    add("sublabiale", profile.best(profile.at(bulge).y(), lip.y(), "sublabiale", backward));
    add("pogonion", bulge);
    return found;
}

}  // namespace mien
