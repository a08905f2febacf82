// The report's pictures: scan and fitted face at one scale, what changed in colours, the rims of
// treated zones, and the turnable view.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "render.hpp"
#include "report_fits.hpp"
#include "report_words.hpp"

namespace mien::cli {

/// A field of the study, or nothing where the study knows of none.
std::vector<double> field_or_none(const Study& study, std::int32_t visit, std::int32_t field);

/// Edges around the triangles whose corners all lie in one of the zones.
std::vector<std::array<std::uint32_t, 2>> zone_rims(
    const std::vector<Triangle>& triangles, const std::vector<std::vector<std::uint32_t>>& zones);

/// The measured faces of a study, upright and at one scale.
class ReportPictures {
  public:
    /// fits: the measured capture of each visit. Throws what the study throws.
    ReportPictures(const Study& study, const std::vector<const Fitted*>& fits,
                   std::vector<std::array<std::uint32_t, 2>> rims);

    double range_mm() const { return range_mm_; }
    /// False: nothing is known of the faces' errors, so that colours may be noise.
    bool errors_known() const { return errors_known_; }
    Image face(std::size_t visit) const;
    Image change(std::size_t visit) const;
    /// Empty when the scan is not known.
    Image scan(const Session& session, std::size_t visit) const;
    /// HTML of the view with its data and its script. Of many visits it holds the first and the
    /// last ones, which the text says.
    std::string view(const Words& words, const std::vector<std::string>& names) const;

  private:
    void find_changes(const Study& study);
    std::vector<double> change_of(const Study& study, std::int32_t visit,
                                  const std::vector<double>& first_sd) const;
    Image draw(const MeshArrays& face, std::size_t visit, RenderOptions options) const;

    std::vector<const Fitted*> fits_;
    std::vector<std::array<std::uint32_t, 2>> rims_;
    std::vector<MeshArrays> fitted_;            ///< as they were fitted, upright
    std::vector<MeshArrays> aligned_;           ///< neutral, in the first visit's frame, upright
    std::vector<std::vector<double>> changes_;  ///< mm; NaN: nothing is known
    double range_mm_ = 0.5;
    bool errors_known_ = true;
    int size_ = 360;  ///< pixels, height of a view
};

}  // namespace mien::cli
