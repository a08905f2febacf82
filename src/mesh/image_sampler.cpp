#include "mesh/image_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/scalar_math.hpp"

namespace mien {
namespace {

/// The pixel at a whole place, repeated beyond the image's sides.
Index repeated(double place, Index size) {
    const double wrapped =
        place - std::floor(place / static_cast<double>(size)) * static_cast<double>(size);
    return std::min(static_cast<Index>(wrapped), size - 1);
}

/// Within the triangle: what is negative becomes 0, and the sum 1 again.
Vector3 pulled_inside(const Vector3& barycentric) {
    const Vector3 inside = barycentric.cwiseMax(0.0);
    const double sum = inside.sum();
    return sum > 0.0 ? Vector3(inside / sum) : Vector3(1, 0, 0);
}

}  // namespace

ImageSampler::ImageSampler(const TriMesh& mesh, const Context& context) {
    const Index num_triangles = mesh.triangles.rows();
    if (mesh.texture_triangles.rows() != num_triangles || num_triangles == 0 ||
        mesh.materials.empty())
        return;
    std::vector<std::int32_t> place(mesh.images.size(), -1);
    std::vector<std::uint8_t> tried(mesh.images.size(), 0);
    std::vector<std::int32_t> image_of(static_cast<std::size_t>(num_triangles), -1);
    for (std::size_t t = 0; t < image_of.size(); ++t) {
        const std::size_t material =
            mesh.triangle_materials.empty() ? 0 : mesh.triangle_materials[t];
        const std::int32_t image = mesh.materials[material].image;
        if (image < 0) continue;
        const std::size_t k = static_cast<std::size_t>(image);
        if (!tried[k]) {
            tried[k] = 1;
            try {
                images_.push_back(decode_image(*mesh.images[k], context));
                place[k] = static_cast<std::int32_t>(images_.size()) - 1;
            } catch (const Error& error) {
                if (error.status() != Status::bad_format &&
                    error.status() != Status::unsupported_option)
                    throw;
                context.log(LogLevel::warning, "no colours from an image: %s", error.what());
            }
        }
        image_of[t] = place[k];
    }
    if (images_.empty()) return;
    image_of_ = std::move(image_of);
    for (const Material& material : mesh.materials)
        tint_of_image_use_.push_back(Vector3(static_cast<double>(material.color[0]),
                                             static_cast<double>(material.color[1]),
                                             static_cast<double>(material.color[2])));
    tint_of_ = mesh.triangle_materials;
    vertices_ = mesh.vertices;
    triangles_ = mesh.triangles;
    texture_triangles_ = mesh.texture_triangles;
    texture_ = mesh.texture;
}

Vector3 ImageSampler::pixel(const Image& image, double u, double v) const {
    // Pixel centres lie at halves; rows run down, v runs up.
    const double x = u * static_cast<double>(image.width) - 0.5;
    const double y = (1.0 - v) * static_cast<double>(image.height) - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const double fx = x - x0, fy = y - y0;
    const Index columns[2] = {repeated(x0, image.width), repeated(x0 + 1.0, image.width)};
    const Index rows[2] = {repeated(y0, image.height), repeated(y0 + 1.0, image.height)};
    Vector3 sum = Vector3::Zero();
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const double weight = (i == 0 ? 1.0 - fx : fx) * (j == 0 ? 1.0 - fy : fy);
            const std::uint8_t* rgb = image.rgb.data() + 3 * (rows[j] * image.width + columns[i]);
            sum += weight * Vector3(rgb[0], rgb[1], rgb[2]);
        }
    return sum;
}

Vector3 ImageSampler::color(std::uint32_t triangle, const Vector3& barycentric) const {
    double u = 0.0, v = 0.0;
    for (int k = 0; k < 3; ++k) {
        const Index at = static_cast<Index>(texture_triangles_(triangle, k));
        u += barycentric[k] * static_cast<double>(texture_(at, 0));
        v += barycentric[k] * static_cast<double>(texture_(at, 1));
    }
    const Image& image = images_[static_cast<std::size_t>(image_of_[triangle])];
    const std::size_t material = tint_of_.empty() ? 0 : tint_of_[triangle];
    return pixel(image, u, v).cwiseProduct(tint_of_image_use_[material]);
}

Vector3 ImageSampler::color(std::uint32_t triangle, const Vector3& barycentric,
                            double radius_mm) const {
    const Vector3 a = vertices_.row(triangles_(triangle, 0));
    const Vector3 ab = vertices_.row(triangles_(triangle, 1)).transpose() - a;
    const Vector3 ac = vertices_.row(triangles_(triangle, 2)).transpose() - a;
    const Vector3 normal = ab.cross(ac);
    const double square = normal.squaredNorm();
    if (!(square > 0.0) || !(radius_mm > 0.0)) return color(triangle, barycentric);
    // Two rings whose samples stand for equal areas of the disc, and the middle.
    constexpr int kRings = 2, kSpokes = 6;
    const Vector3 along = ab.normalized(), across = normal.cross(ab).normalized();
    Vector3 sum = color(triangle, pulled_inside(barycentric));
    for (int ring = 0; ring < kRings; ++ring)
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const double angle_rad = (spoke + 0.5 * ring) * 2.0 * kPi / kSpokes;
            const double radius = radius_mm * std::sqrt((ring + 0.5) / kRings);
            const Vector3 step =
                radius * (std::cos(angle_rad) * along + std::sin(angle_rad) * across);
            // What the step adds to the weights of the second and third corner.
            const double second = step.cross(ac).dot(normal) / square;
            const double third = ab.cross(step).dot(normal) / square;
            sum += color(triangle,
                         pulled_inside(barycentric + Vector3(-second - third, second, third)));
        }
    return sum / (1 + kRings * kSpokes);
}

Colors ImageSampler::vertex_colors(const TriMesh& mesh, double radius_mm) const {
    const Index count = mesh.vertices.rows();
    Points sum = Points::Zero(count, 3);
    Vector number = Vector::Zero(count);
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        if (!covers(static_cast<std::uint32_t>(t))) continue;
        for (int k = 0; k < 3; ++k) {
            const Index v = static_cast<Index>(mesh.triangles(t, k));
            sum.row(v) +=
                color(static_cast<std::uint32_t>(t), Vector3::Unit(k), radius_mm).transpose();
            number[v] += 1.0;
        }
    }
    constexpr std::uint8_t kGrey = 128;
    Colors colors(count, 3);
    for (Index v = 0; v < count; ++v)
        for (int k = 0; k < 3; ++k) {
            const double value = number[v] > 0.0 ? sum(v, k) / number[v] : 0.0;
            const std::uint8_t plain = mesh.colors.rows() == count ? mesh.colors(v, k) : kGrey;
            colors(v, k) =
                number[v] > 0.0 ? static_cast<std::uint8_t>(std::min(value + 0.5, 255.0)) : plain;
        }
    return colors;
}

}  // namespace mien
