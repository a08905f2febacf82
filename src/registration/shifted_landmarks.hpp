// Landmarks that lie beside the scan all together: picked in a picture that is not where the
// surface is, with a pointer's tip, or on another capture. Each one looks like a small error of
// picking; that all err to the same side tells. A fit between surface and landmarks shows it.
#pragma once

#include <optional>
#include <vector>

#include "registration/fit_state.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct ShiftedLandmarkSettings {
    bool mend = true;
    /// > 0: length of the mean misfit over what it would be by chance, from which further fits are
    /// tried: above the 1.6 of right landmarks. One part of the face that is off reaches 3.0; what
    /// the further fits find there is not kept. [T] "Landmarks shifted together"
    double least_score = 2.2;
    double least_half = 0.25;  ///< 0 to 1: of the mean misfit, that the left, right, upper and
                               ///< lower landmarks show as well: an open mouth is no shift [J]
    double least_mm = 0.5;     ///< mm, > 0: a mean misfit of less is none [J]
    int most_fits = 4;         ///< >= 1: after the first [J]
    double seen_first = 0.6;   ///< 0 to 1: share of a shift that the first fit is taken to show [J]
    double seen_least = 0.5;   ///< 0 to 1: and a later one at least [J]
    double settled_mm = 0.3;   ///< mm, >= 0: mean misfit with which no further fit is made [J]
    double kept_mean = 0.5;    ///< 0 to 1: once moved, less of the mean misfit must be left [J]
    double kept = 0.9;         ///< 0 to 1: and less of its root mean square [T]
};

struct Misfit {
    Vector3 mean = Vector3::Zero();  ///< of landmark minus fitted place, mm
    double rms_mm = 0;
};

/// Pins must not be empty. `places`: #V x 3, mm, in the pins' frame.
Misfit misfit_of(const std::vector<Pin>& pins, const Points& places);

/// The same where the mean is common to all; nothing where it is not, or without pins.
std::optional<Misfit> common_misfit(const std::vector<Pin>& pins, const Points& places,
                                    const ShiftedLandmarkSettings& settings);

/// Looks for the whole shift: a fit that yields to its landmarks shows only a share of it, which
/// is told by how the misfit follows what the landmarks were moved by.
class ShiftSearch {
  public:
    ShiftSearch(const Misfit& found, const ShiftedLandmarkSettings& settings);
    const Vector3& shift() const { return shift_; }  ///< mm, to be taken off all landmarks
    /// What a fit to landmarks without shift() leaves; whether it is the best so far, and good
    /// enough to be kept.
    bool take(const Misfit& left);
    bool settled() const;

  private:
    void step();

    const ShiftedLandmarkSettings& settings_;
    Misfit found_;
    Vector3 left_, step_, shift_ = Vector3::Zero();
    double seen_, best_rms_mm_;
};

}  // namespace mien
