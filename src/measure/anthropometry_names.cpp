// Which landmark of the field a face's names mean.
#include <map>

#include "measure/anthropometry.hpp"

namespace mien {
namespace {

/// Lower case, without separators and without zeros before a number: "Mouth-Outer_00" and
/// "mouth_outer_0" are one name.
std::string folded(const std::string& name) {
    std::string plain;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        if (c == '_' || c == '-' || c == '.' || c == ' ') continue;
        const bool digit_before = !plain.empty() && plain.back() >= '0' && plain.back() <= '9';
        const bool digit_after = i + 1 < name.size() && name[i + 1] >= '0' && name[i + 1] <= '9';
        if (c == '0' && !digit_before && digit_after) continue;
        plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return plain;
}

/// "cheilion_left" is also "left_cheilion" and "cheilion_l".
void add_forms(const std::string& name, std::vector<std::string>& forms) {
    forms.push_back(folded(name));
    for (const char* side : {"_right", "_left"}) {
        const std::string tail = side;
        if (name.size() <= tail.size() ||
            name.compare(name.size() - tail.size(), tail.size(), tail) != 0)
            continue;
        const std::string stem = name.substr(0, name.size() - tail.size());
        forms.push_back(folded(tail + stem));
        forms.push_back(folded(stem + "_" + tail[1]));
    }
}

}  // namespace

std::vector<AnatomicalPlace> find_anatomical_places(const std::vector<FacePlace>& places) {
    std::map<std::string, std::size_t> by_name;  // the first of several
    for (std::size_t i = 0; i < places.size(); ++i) by_name.emplace(folded(places[i].name), i);
    std::vector<AnatomicalPlace> found;
    for (const AnatomicalLandmark& landmark : anatomical_landmarks()) {
        AnatomicalPlace place;
        std::vector<std::string> forms;
        add_forms(landmark.name, forms);
        add_forms(landmark.abbreviation, forms);
        for (const std::string& form : forms) {
            const auto at = by_name.find(form);
            if (at == by_name.end()) continue;
            place = {{at->second}, places[at->second].name};
            break;
        }
        if (place.places.empty())
            for (const char* name : landmark.numbered) {
                const auto at = by_name.find(folded(name));
                if (at == by_name.end()) {
                    place = {};
                    break;
                }
                place.places.push_back(at->second);
                place.from += (place.from.empty() ? "" : " and ") + places[at->second].name;
            }
        found.push_back(std::move(place));
    }
    return found;
}

}  // namespace mien
