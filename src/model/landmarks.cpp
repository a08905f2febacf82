#include "model/landmarks.hpp"

namespace mien {
namespace {

template <typename Named>
const Named* find_named(const std::vector<Named>& all, const std::string& name) {
    for (const Named& one : all)
        if (one.name == name) return &one;
    return nullptr;
}

}  // namespace

const Landmark* find_landmark(const std::vector<Landmark>& landmarks, const std::string& name) {
    return find_named(landmarks, name);
}

const Zone* find_zone(const std::vector<Zone>& zones, const std::string& name) {
    return find_named(zones, name);
}

}  // namespace mien
