// The landmarks and the measurements of the field as two tables: names, definitions, sources.
//
// Sources: Farkas, Anthropometry of the Head and Face, 2nd ed. 1994 (F94); Farkas et al. 2005, J
// Craniofac Surg 16(4) (F05); Legan & Burstone 1980 (LB80); Ricketts 1968 (R68); Burstone 1967
// (B67); Powell & Humphreys 1984 (PH84); Caple & Stephan 2016 for the names of landmarks.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mien {

enum class AnthropometricKind : std::int32_t {
    length = 1,          ///< straight, mm: marks a, b
    surface_length = 2,  ///< along the skin, mm: a, b
    angle = 3,           ///< at the middle mark, degrees: a, b, c
    /// Of the direction c to d against a to b, signed, degrees: a, b, c, d, e, f. It turns about
    /// the axis (b - a) x (middle of a and b - middle of e and f), counter-clockwise positive.
    inclination = 4,
    proportion = 5,  ///< 100 |ab| / |cd|, percent
    /// Of c from the line through a and b, mm: a, b, c, d, e; positive on the side that is turned
    /// away from the middle of d and e.
    line_offset = 6,
};

/// How many marks a kind has.
int mark_count(AnthropometricKind kind);
/// "mm", "degrees" or "percent".
const char* unit_of(AnthropometricKind kind);

constexpr int kMostMarks = 6;

/// One measurement. Marks are names of the table of landmarks; a paired landmark ends in "_right"
/// or "_left", the subject's.
struct AnthropometricDefinition {
    const char* name;   ///< of the field, such as "n-gn"
    const char* title;  ///< in words
    AnthropometricKind kind;
    std::array<const char*, kMostMarks> marks;
    const char* source;
};

/// One landmark of the field, of the middle or of one side.
struct AnatomicalLandmark {
    std::string name;                   ///< "pronasale", "cheilion_left"
    std::string abbreviation;           ///< "prn", "ch_left"
    const char* meaning;                ///< where it lies
    std::vector<const char*> numbered;  ///< names of the 68-point scheme (iBUG) that it coincides
                                        ///< with; of two, it is their middle; empty: of none
};

const std::vector<AnatomicalLandmark>& anatomical_landmarks();
const std::vector<AnthropometricDefinition>& anthropometric_definitions();

}  // namespace mien
