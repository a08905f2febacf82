#include "measure/anthropometry.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "base/scalar_math.hpp"
#include "geometry/normals.hpp"
#include "measure/lengths.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

using Kind = AnthropometricKind;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 1.0 / kRadiansPerDegree;
/// Step of the central differences, as a share of the extent of a measurement's marks: errors of
/// the differences and of rounding are both below 1e-9 of a slope.
constexpr double kStepShare = 1e-5;

using MarkPoints = std::array<Vector3, kMostMarks>;

double angle_between(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Not a number where places coincide and the measurement is none.
double value_of(Kind kind, const MarkPoints& p) {
    switch (kind) {
        case Kind::length:
            return (p[0] - p[1]).norm();
        case Kind::surface_length:
            return kUnknown;
        case Kind::angle: {
            const Vector3 a = p[0] - p[1], b = p[2] - p[1];
            return a.norm() > 0 && b.norm() > 0 ? kDegrees * angle_between(a, b) : kUnknown;
        }
        case Kind::inclination: {
            const Vector3 a = p[1] - p[0], b = p[3] - p[2];
            const Vector3 up = 0.5 * (p[0] + p[1]) - 0.5 * (p[4] + p[5]);
            const Vector3 axis = a.cross(up);
            if (!(axis.norm() > 0) || !(b.norm() > 0)) return kUnknown;
            // Seen along the axis: what of b lies along it does not count.
            const Vector3 unit = axis.normalized(), flat = b - unit.dot(b) * unit;
            return kDegrees * std::atan2(unit.dot(a.cross(flat)), a.dot(flat));
        }
        case Kind::proportion: {
            const double below = (p[2] - p[3]).norm();
            return below > 0 ? 100.0 * (p[0] - p[1]).norm() / below : kUnknown;
        }
        case Kind::line_offset: {
            const Vector3 line = (p[1] - p[0]).normalized();
            const auto off = [&](const Vector3& x) {
                const Vector3 from = x - p[0];
                return Vector3(from - line.dot(from) * line);
            };
            const Vector3 behind = off(0.5 * (p[3] + p[4]));
            return behind.norm() > 0 ? -off(p[2]).dot(behind.normalized()) : kUnknown;
        }
    }
    return kUnknown;
}

/// The face's places with what is known of their errors.
class Places {
  public:
    Places(const TriMesh& face, const std::vector<FacePlace>& places,
           const AnthropometryErrors& errors)
        : errors_(errors), known_(errors.place_sd_mm.size() != 0) {
        const Index n = face.vertices.rows();
        const Points normals = vertex_normals(face.vertices, face.triangles);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const FacePlace& place = places[i];
            if (place.vertex >= n)
                fail_at(Status::mismatch, static_cast<std::int64_t>(i),
                        "the landmark '%.60s' is vertex %lld, the face has %lld",
                        place.name.c_str(), static_cast<long long>(place.vertex),
                        static_cast<long long>(n));
            if (place.vertex < 0) {
                if (!place.point.allFinite())
                    fail_at(Status::invalid_argument, static_cast<std::int64_t>(i),
                            "the landmark '%.60s' is not finite", place.name.c_str());
                points_.push_back(place.point);
                normals_.push_back(Vector3::Zero());
                continue;
            }
            points_.push_back(face.vertices.row(place.vertex).transpose());
            normals_.push_back(normals.row(place.vertex).transpose());
        }
        for (const FacePlace& place : places) {
            double across = kUnknown, along = kUnknown;
            if (known_ && place.vertex >= 0) {
                const double s = errors.place_sd_mm[place.vertex];
                across = errors.normal_sd_mm.size() != 0 ? errors.normal_sd_mm[place.vertex] : s;
                // Where the normal says more than the whole place, the place is believed.
                across = std::min(across, std::sqrt(3.0) * s);
                along = std::sqrt(0.5 * (3.0 * s * s - across * across));
            }
            across_.push_back(across);
            along_.push_back(along);
        }
    }

    const Vector3& point(std::size_t i) const { return points_[i]; }

    /// The first-order variance of a measurement with these slopes.
    double variance(const std::map<std::size_t, Vector3>& slopes) const {
        double sum = 0.0;
        for (const auto& [i, g] : slopes)
            for (const auto& [j, h] : slopes) {
                const double d2 = (points_[i] - points_[j]).squaredNorm();
                const double gn = g.dot(normals_[i]), hn = h.dot(normals_[j]);
                const Vector3 gt = g - gn * normals_[i], ht = h - hn * normals_[j];
                sum +=
                    together(d2, errors_.normal_correlation_mm) * gn * hn * across_[i] *
                        across_[j] +
                    together(d2, errors_.slide_correlation_mm) * gt.dot(ht) * along_[i] * along_[j];
            }
        return sum;
    }

  private:
    static double together(double squared, double length) {
        if (squared == 0.0) return 1.0;
        return length > 0 ? std::exp(-squared / (2 * length * length)) : 0.0;
    }
    const AnthropometryErrors& errors_;
    bool known_;
    std::vector<Vector3> points_, normals_;
    std::vector<double> across_, along_;
};

void check_deviations(const Vector& sd, Index num_vertices, const char* what) {
    if (sd.size() == 0) return;
    if (sd.size() != num_vertices)
        fail(Status::mismatch, "%lld deviations %s for %lld vertices",
             static_cast<long long>(sd.size()), what, static_cast<long long>(num_vertices));
    for (Index v = 0; v < num_vertices; ++v)
        if (!(sd[v] >= 0) || !std::isfinite(sd[v]))
            fail_at(Status::invalid_argument, v, "deviation %s is %g; deviations are zero or more",
                    what, sd[v]);
}

/// One face, asked for one definition after another.
class Measuring {
  public:
    Measuring(const TriMesh& face, const std::vector<FacePlace>& places,
              const AnthropometryErrors& errors)
        : face_(face),
          given_(places),
          places_(face, places, errors),
          found_(find_anatomical_places(places)) {
        const auto& landmarks = anatomical_landmarks();
        for (std::size_t k = 0; k < landmarks.size(); ++k) number_[landmarks[k].name] = k;
    }

    AnthropometricValue of(const AnthropometricDefinition& definition) const {
        AnthropometricValue result{&definition, kUnknown, kUnknown, ""};
        const auto count = static_cast<std::size_t>(mark_count(definition.kind));
        for (std::size_t k = 0; k < count; ++k)
            if (mark(definition, k).places.empty()) add_missing(definition.marks[k], result.reason);
        if (!result.reason.empty()) {
            result.reason = "the face has no landmark " + result.reason;
            return result;
        }
        if (definition.kind == Kind::surface_length) return result;  // all together, later
        MarkPoints points{};
        for (std::size_t k = 0; k < count; ++k) points[k] = place_of(mark(definition, k));
        result.value = value_of(definition.kind, points);
        if (!std::isfinite(result.value)) {
            result.value = kUnknown;
            result.reason = "its landmarks coincide";
            return result;
        }
        result.sd = std::sqrt(places_.variance(slopes(definition, points, count)));
        return result;
    }

    /// The surface lengths among the values that have their landmarks.
    void add_surface_lengths(std::vector<AnthropometricValue>& values,
                             const Context& context) const {
        std::vector<AnthropometricValue*> asked;
        std::vector<std::array<std::uint32_t, 2>> ends;
        for (AnthropometricValue& value : values) {
            if (value.definition->kind != Kind::surface_length || !value.reason.empty()) continue;
            std::array<std::uint32_t, 2> pair{};
            for (std::size_t k = 0; k < 2; ++k) {
                const AnatomicalPlace& place = mark(*value.definition, k);
                if (place.places.size() != 1 || given_[place.places[0]].vertex < 0)
                    value.reason = std::string("the landmark ") + value.definition->marks[k] +
                                   " is no vertex of the face";
                else
                    pair[k] = static_cast<std::uint32_t>(given_[place.places[0]].vertex);
            }
            if (!value.reason.empty()) continue;
            asked.push_back(&value);
            ends.push_back(pair);
        }
        const std::vector<SurfaceLength> lengths =
            surface_lengths(face_.vertices, face_.triangles, ends, context);
        for (std::size_t k = 0; k < asked.size(); ++k) {
            AnthropometricValue& value = *asked[k];
            if (!std::isfinite(lengths[k].mm)) {
                value.reason = "no surface joins its landmarks";
                continue;
            }
            value.value = lengths[k].mm;
            std::map<std::size_t, Vector3> slope;
            for (std::size_t end = 0; end < 2; ++end)
                slope[mark(*value.definition, end).places[0]] = lengths[k].growth[end];
            value.sd =
                std::hypot(std::sqrt(places_.variance(slope)), kHeatLengthShare * lengths[k].mm);
        }
    }

  private:
    const AnatomicalPlace& mark(const AnthropometricDefinition& definition, std::size_t k) const {
        return found_[number_.at(definition.marks[k])];
    }
    Vector3 place_of(const AnatomicalPlace& place) const {
        Vector3 sum = Vector3::Zero();
        for (const std::size_t i : place.places) sum += places_.point(i);
        return sum / static_cast<double>(place.places.size());
    }
    static void add_missing(const std::string& name, std::string& list) {
        if (list.find(name) != std::string::npos) return;
        list += (list.empty() ? "" : ", ") + name;
    }

    /// How the value grows with each place, by central differences.
    std::map<std::size_t, Vector3> slopes(const AnthropometricDefinition& definition,
                                          const MarkPoints& points, std::size_t count) const {
        double extent = 0.0;
        for (std::size_t k = 1; k < count; ++k)
            extent = std::max(extent, (points[k] - points[0]).norm());
        const double step = kStepShare * extent;
        std::map<std::size_t, Vector3> slopes;
        for (std::size_t k = 0; k < count; ++k) {
            Vector3 slope;
            for (int axis = 0; axis < 3; ++axis) {
                MarkPoints up = points, down = points;
                up[k][axis] += step;
                down[k][axis] -= step;
                double change = value_of(definition.kind, up) - value_of(definition.kind, down);
                if (definition.kind == Kind::inclination)
                    change = std::remainder(change, 360.0);  // across the cut of the circle
                slope[axis] = change / (2 * step);
            }
            const AnatomicalPlace& place = mark(definition, k);
            for (const std::size_t i : place.places) {
                const auto at = slopes.emplace(i, Vector3::Zero()).first;
                at->second += slope / static_cast<double>(place.places.size());
            }
        }
        return slopes;
    }

    const TriMesh& face_;
    const std::vector<FacePlace>& given_;
    Places places_;
    std::vector<AnatomicalPlace> found_;
    std::map<std::string, std::size_t> number_;
};

}  // namespace

std::vector<AnthropometricValue> measure_anthropometry(const TriMesh& face,
                                                       const std::vector<FacePlace>& places,
                                                       const AnthropometryErrors& errors,
                                                       const Context& context) {
    check_surface(face.vertices, face.triangles, "the face");
    check_deviations(errors.place_sd_mm, face.vertices.rows(), "of places");
    check_deviations(errors.normal_sd_mm, face.vertices.rows(), "along the normal");
    for (const double length : {errors.slide_correlation_mm, errors.normal_correlation_mm})
        if (!(length >= 0) || !std::isfinite(length))
            fail(Status::invalid_argument, "correlation length %g mm; give zero or more", length);
    context.progress(Stage::measuring, 0);
    const Measuring measuring(face, places, errors);
    std::vector<AnthropometricValue> values;
    for (const AnthropometricDefinition& definition : anthropometric_definitions())
        values.push_back(measuring.of(definition));
    context.progress(Stage::measuring, 0.5);
    measuring.add_surface_lengths(values, context);
    context.progress(Stage::measuring, 1);
    return values;
}

}  // namespace mien
