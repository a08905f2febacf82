// What the skin looks like in a view, as two visits can compare it: redness and darkness
// (color_signals.hpp), without what light and camera do to them.
//
//   s = (c - m) / sqrt(m((c - m)^2) + f^2),   m(.) the mean over a few millimetres around
//
// A light that shines from elsewhere multiplies colours by what changes slowly over the face: in
// logarithms it is added, and gone with the mean. Gain and contrast of a camera are gone with the
// deviation; f keeps noise on plain skin from being blown up to detail.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "registration/scan_surface.hpp"
#include "registration/skin_views.hpp"

namespace mien {

/// Planes over the pixels of a view, row * width + column; 0 where `mask` is.
struct SkinImage {
    static constexpr std::size_t kChannels = 2;
    using Plane = std::vector<float>;

    Index width = 0, height = 0;
    double pixel_mm = 1;
    Plane channel[kChannels];
    Plane mask;  ///< 1: seen, 0: not; between where pixels were mixed

    std::size_t num_pixels() const { return static_cast<std::size_t>(width * height); }
};

/// Tags in brackets: registration/settings.hpp.
struct SkinSampleSettings {
    double reach_mm = 1.5;      ///< mm, > 0: scan farther from the fit is not its skin [J]
    double least_cosine = 0.5;  ///< 0 to 1: between the normals of fit and scan [J]
    double least_weight = 0.2;  ///< 0 to 1: of the fit there, how far the scan counted [J]
};

/// What is compared of a visit.
struct SkinVisit {
    const Points& places;     ///< #V x 3: the fitted template in the scan's frame, mm
    const ScanSurface& scan;  ///< with colours
    const Vector& weight;     ///< #V, how far the scan counted, or empty: all one
};

/// The scan's colours, as logarithms, where the fit carries the view's pixels. O(pixels log F).
SkinImage sample_skin(const SkinView& view, const Triangles& triangles, const SkinVisit& visit,
                      const SkinSampleSettings& settings, const Context& context);

/// Of half the resolution: means over seen pixels of two by two.
SkinImage halve(const SkinImage& image);

/// Tags in brackets: registration/settings.hpp.
struct SkinDetailSettings {
    double coarse_mm = 4;   ///< mm, > 0: half width of the means that are taken away [J]
    double floor = 0.02;    ///< f, > 0, logarithms: about 2 % of brightness [J]
    double noise_mm = 0.5;  ///< mm, >= 0: what is finer is averaged as noise [J]
};

/// s of the picture. O(pixels).
SkinImage detail_of(const SkinImage& image, const SkinDetailSettings& settings);

/// The picture seen through a move: pixel p shows what was at p + move(p). `across`, `up`: planes,
/// in pixels.
SkinImage moved(const SkinImage& image, const SkinImage::Plane& across, const SkinImage::Plane& up);

}  // namespace mien
