#include "registration/slide_field.hpp"

#include <cmath>

#include "base/parallel.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

constexpr std::size_t kSlideRows = 2048;  // of a chunk

double sum_of_products(const Points& a, const Points& b, const Context& context) {
    return parallel_sum(
        context, static_cast<std::size_t>(a.rows()), kSlideRows, 0.0,
        [&](std::size_t begin, std::size_t end) {
            const Index first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
            return a.middleRows(first, count).cwiseProduct(b.middleRows(first, count)).sum();
        });
}

}  // namespace

SlideField::SlideField(const TriMesh& template_mesh, const VertexRings& rings,
                       const std::vector<std::uint8_t>& part)
    : rings_(rings), part_(part), area_(Vector::Zero(template_mesh.vertices.rows())) {
    const Points normals = triangle_normals(template_mesh.vertices, template_mesh.triangles);
    for (Index t = 0; t < normals.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            area_[template_mesh.triangles(t, k)] += normals.row(t).norm() / 6;
}

void SlideField::solve(const std::vector<SlidePull>& pulls, const SlideFieldSettings& settings,
                       Points& field, const Context& context) const {
    const double edge = 1 / std::sqrt(3.0);
    const double data = 1 / (settings.smooth_mm * settings.smooth_mm),
                 ground = 1 / (settings.ground_mm * settings.ground_mm);
    const std::size_t n = part_.size();
    // The equations times a field; with their diagonal, by which the steps are scaled.
    const auto apply = [&](const Points& x, Points& image) {
        parallel_for(context, n, kSlideRows, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                const Index row = static_cast<Index>(v);
                if (!part_[v]) {
                    image.row(row).setZero();
                    continue;
                }
                const Vector3 here = x.row(row);
                Vector3 sum = area_[row] * (data * (pulls[v].trust * here) + ground * here);
                for (const std::uint32_t j : rings_.of(v))
                    if (part_[j]) sum += edge * (here - x.row(static_cast<Index>(j)).transpose());
                image.row(row) = sum;
            }
        });
    };
    Points inverse = Points::Zero(field.rows(), 3), pull = inverse, image = inverse;
    for (std::size_t v = 0; v < n; ++v) {
        const Index row = static_cast<Index>(v);
        field.row(row) *= part_[v] ? 1 : 0;
        if (!part_[v]) continue;
        double degree = 0;
        for (const std::uint32_t j : rings_.of(v)) degree += part_[j] ? edge : 0;
        for (int k = 0; k < 3; ++k) {
            const double diagonal = area_[row] * (data * pulls[v].trust(k, k) + ground) + degree;
            inverse(row, k) = diagonal > 0 ? 1 / diagonal : 0;
        }
        pull.row(row) = area_[row] * data * pulls[v].pull;
    }
    apply(field, image);
    Points residual = pull - image, scaled = residual.cwiseProduct(inverse), direction = scaled;
    double rz = sum_of_products(residual, scaled, context);
    const double enough = settings.tolerance * settings.tolerance *
                          sum_of_products(pull, pull.cwiseProduct(inverse), context);
    for (int k = 0; k < settings.most_iterations && rz > enough; ++k) {
        apply(direction, image);
        const double curved = sum_of_products(direction, image, context);
        if (!(curved > 0)) break;
        field += rz / curved * direction;
        residual -= rz / curved * image;
        scaled = residual.cwiseProduct(inverse);
        const double next = sum_of_products(residual, scaled, context);
        direction = scaled + next / rz * direction;
        rz = next;
    }
}

}  // namespace mien
