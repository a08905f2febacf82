#include "registration/skin_image.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/parallel.hpp"

namespace mien {
namespace {

using Plane = SkinImage::Plane;
constexpr std::size_t kPictureRows = 16;  // of a chunk

SkinImage empty_image(Index width, Index height, double pixel_mm) {
    SkinImage image;
    image.width = width;
    image.height = height;
    image.pixel_mm = pixel_mm;
    for (Plane& plane : image.channel) plane.assign(image.num_pixels(), 0);
    image.mask.assign(image.num_pixels(), 0);
    return image;
}

Vector3 facet_normal(const Points& places, const Triangles& triangles, std::uint32_t triangle) {
    const auto corner = triangles.row(static_cast<Index>(triangle));
    const Vector3 a = places.row(corner[0]), b = places.row(corner[1]), c = places.row(corner[2]);
    return (b - a).cross(c - a).normalized();
}

// The mean of each seen pixel and those beside it, by 1 2 1 along both axes; in place.
void soften(Plane& plane, const Plane& mask, Index width, Index height) {
    Plane line(static_cast<std::size_t>(std::max(width, height)));
    const auto run = [&](std::size_t first, std::size_t step, Index count) {
        for (Index i = 0; i < count; ++i) {
            const std::size_t at = first + static_cast<std::size_t>(i) * step;
            float sum = 2 * plane[at], seen = 2;
            if (i > 0 && mask[at - step] > 0) {
                sum += plane[at - step];
                ++seen;
            }
            if (i + 1 < count && mask[at + step] > 0) {
                sum += plane[at + step];
                ++seen;
            }
            line[static_cast<std::size_t>(i)] = mask[at] > 0 ? sum / seen : 0;
        }
        for (Index i = 0; i < count; ++i)
            plane[first + static_cast<std::size_t>(i) * step] = line[static_cast<std::size_t>(i)];
    };
    const std::size_t columns = static_cast<std::size_t>(width);
    for (Index y = 0; y < height; ++y) run(static_cast<std::size_t>(y) * columns, 1, width);
    for (Index x = 0; x < width; ++x) run(static_cast<std::size_t>(x), columns, height);
}

// Means of `plane` over squares of 2 radius + 1 pixels, in place; pixels beyond the sides are 0.
void sum_square(Plane& plane, Index width, Index height, Index radius) {
    Plane line(static_cast<std::size_t>(std::max(width, height)));
    const auto run = [&](float* first, Index step, Index count) {
        double sum = 0;
        for (Index i = 0; i < std::min(radius, count); ++i)
            sum += static_cast<double>(first[i * step]);
        for (Index i = 0; i < count; ++i) {
            if (i + radius < count) sum += static_cast<double>(first[(i + radius) * step]);
            line[static_cast<std::size_t>(i)] = static_cast<float>(sum);
            if (i >= radius) sum -= static_cast<double>(first[(i - radius) * step]);
        }
        for (Index i = 0; i < count; ++i) first[i * step] = line[static_cast<std::size_t>(i)];
    };
    for (Index y = 0; y < height; ++y) run(plane.data() + y * width, 1, width);
    for (Index x = 0; x < width; ++x) run(plane.data() + x, width, height);
}

}  // namespace

SkinImage sample_skin(const SkinView& view, const Triangles& triangles, const SkinVisit& visit,
                      const SkinSampleSettings& settings, const Context& context) {
    SkinImage image = empty_image(view.width, view.height, view.pixel_mm);
    const ScanSurface& scan = visit.scan;
    const auto look = [&](std::size_t pixel, std::uint32_t& hint) {
        if (visit.weight.size() > 0) {
            const auto corner = triangles.row(static_cast<Index>(view.triangle[pixel]));
            const double b = static_cast<double>(view.second[pixel]),
                         c = static_cast<double>(view.third[pixel]);
            if ((1 - b - c) * visit.weight[corner[0]] + b * visit.weight[corner[1]] +
                    c * visit.weight[corner[2]] <
                settings.least_weight)
                return;
        }
        const SurfaceHit hit =
            scan.tree.closest(view.at(pixel, triangles, visit.places), settings.reach_mm, hint);
        if (!hit.valid()) return;
        hint = hit.triangle;
        if (!scan.tree.is_point_cloud()) {
            // Scans may face inwards.
            const double cosine =
                facet_normal(scan.vertices, scan.triangles, hit.triangle)
                    .dot(facet_normal(visit.places, triangles, view.triangle[pixel]));
            if (!(std::abs(cosine) >= settings.least_cosine)) return;
        }
        const Eigen::Vector2d signal = scan.colors_at(hit);
        for (std::size_t k = 0; k < SkinImage::kChannels; ++k)
            image.channel[k][pixel] = static_cast<float>(signal[static_cast<Index>(k)]);
        image.mask[pixel] = 1;
    };
    parallel_for(context, static_cast<std::size_t>(view.height), kPictureRows,
                 [&](std::size_t begin, std::size_t end) {
                     for (std::size_t y = begin; y < end; ++y) {
                         std::uint32_t hint = SurfaceHit::kNone;
                         for (std::size_t x = 0; x < static_cast<std::size_t>(view.width); ++x) {
                             const std::size_t pixel = y * static_cast<std::size_t>(view.width) + x;
                             if (view.triangle[pixel] != SkinView::kNone) look(pixel, hint);
                         }
                     }
                 });
    return image;
}

SkinImage halve(const SkinImage& image) {
    SkinImage half = empty_image(image.width / 2, image.height / 2, 2 * image.pixel_mm);
    for (Index y = 0; y < half.height; ++y)
        for (Index x = 0; x < half.width; ++x) {
            float seen = 0, sum[SkinImage::kChannels] = {};
            for (Index j = 0; j < 2; ++j)
                for (Index i = 0; i < 2; ++i) {
                    const std::size_t from =
                        static_cast<std::size_t>((2 * y + j) * image.width + 2 * x + i);
                    seen += image.mask[from];
                    for (std::size_t k = 0; k < SkinImage::kChannels; ++k)
                        sum[k] += image.mask[from] * image.channel[k][from];
                }
            if (seen < 2) continue;
            const std::size_t to = static_cast<std::size_t>(y * half.width + x);
            half.mask[to] = 1;
            for (std::size_t k = 0; k < SkinImage::kChannels; ++k)
                half.channel[k][to] = sum[k] / seen;
        }
    return half;
}

SkinImage detail_of(const SkinImage& image, const SkinDetailSettings& settings) {
    const Index radius =
        std::max<Index>(1, static_cast<Index>(std::lround(settings.coarse_mm / image.pixel_mm)));
    SkinImage detail = image;
    // Twice a square is nearly a round hill.
    const auto mean = [&](Plane& plane) {
        for (int pass = 0; pass < 2; ++pass)
            sum_square(plane, image.width, image.height, std::max<Index>(1, radius / 2));
    };
    Plane around = image.mask;
    mean(around);
    const float floor = static_cast<float>(settings.floor);
    for (Plane& plane : detail.channel) {
        if (image.pixel_mm <= settings.noise_mm)
            soften(plane, image.mask, image.width, image.height);
        Plane blurred = plane;
        mean(blurred);
        for (std::size_t p = 0; p < plane.size(); ++p)
            plane[p] = image.mask[p] > 0 ? plane[p] - blurred[p] / around[p] : 0;
        for (std::size_t p = 0; p < plane.size(); ++p) blurred[p] = plane[p] * plane[p];
        mean(blurred);
        for (std::size_t p = 0; p < plane.size(); ++p)
            if (image.mask[p] > 0)
                plane[p] /= std::sqrt(std::max(blurred[p] / around[p], 0.f) + floor * floor);
    }
    return detail;
}

SkinImage moved(const SkinImage& image, const Plane& across, const Plane& up) {
    SkinImage out = empty_image(image.width, image.height, image.pixel_mm);
    for (Index y = 0; y < image.height; ++y)
        for (Index x = 0; x < image.width; ++x) {
            const std::size_t to = static_cast<std::size_t>(y * image.width + x);
            const float px = static_cast<float>(x) + across[to],
                        py = static_cast<float>(y) + up[to];
            const float x0 = std::floor(px), y0 = std::floor(py);
            if (!(x0 >= 0) || !(y0 >= 0) || !(x0 + 1 < static_cast<float>(image.width)) ||
                !(y0 + 1 < static_cast<float>(image.height)))
                continue;
            const float fx = px - x0, fy = py - y0;
            const std::size_t from = static_cast<std::size_t>(static_cast<Index>(y0) * image.width +
                                                              static_cast<Index>(x0)),
                              next = from + static_cast<std::size_t>(image.width);
            const std::size_t at[4] = {from, from + 1, next, next + 1};
            const float share[4] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
            float seen = 0, sum[SkinImage::kChannels] = {};
            for (int k = 0; k < 4; ++k) {
                const float weight = share[k] * image.mask[at[k]];
                seen += weight;
                for (std::size_t c = 0; c < SkinImage::kChannels; ++c)
                    sum[c] += weight * image.channel[c][at[k]];
            }
            if (seen < 0.5f) continue;
            out.mask[to] = 1;
            for (std::size_t c = 0; c < SkinImage::kChannels; ++c)
                out.channel[c][to] = sum[c] / seen;
        }
    return out;
}

}  // namespace mien
