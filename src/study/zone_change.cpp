#include "study/zone_change.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "measure/area.hpp"
#include "measure/distance.hpp"
#include "measure/interval.hpp"
#include "measure/measurement.hpp"
#include "measure/pair_check.hpp"
#include "measure/repeatability.hpp"
#include "measure/scan_volume.hpp"
#include "study/slide_error.hpp"

namespace mien {
namespace {

constexpr double kNoiseReach = 3.0;               ///< deviations; a change farther out is no noise
const double kPositivePart = 0.3989422804014327;  ///< 1 / sqrt(2 pi): E max(x, 0), x ~ N(0, 1)

/// One pair of faces, prepared, and asked for one zone after another.
class PairMeasure {
  public:
    PairMeasure(const Context& context, const StudyData& data, std::size_t first,
                std::size_t second, PairChange& result)
        : context_(context),
          data_(data),
          first_(first),
          second_(second),
          before_(*data.neutral.meshes[first]) {
        const TriMesh& moving = *data.neutral.meshes[second];
        result.alignment = align_fits_on_zone(moving.vertices, before_, data.zones.stable, context);
        after_ = result.alignment.motion.apply(PointsRef(moving.vertices));
        MeasureOptions options;
        options.zones = data.zones.measured;
        if (reason_of_faces() == WhyUnknown::nothing) {
            options.errors = errors(result.alignment);
            propagation_.emplace(before_.vertices, after_, before_.triangles, *options.errors);
        }
        volume_ =
            measure_volume_fully(before_.vertices, after_, before_.triangles, options, context);
        distance_ = measure_distance(before_.vertices, after_, before_.triangles,
                                     data.zones.measured, context);
        areas_ = vertex_areas(before_.vertices, before_.triangles);
        if (!propagation_) return;
        total_sd_mm_ = propagation_->total_sd_mm();
        if (data.expression_map.size() == 0) return;
        expression_.emplace(data.expression_map, data.neutral, first, second,
                            propagation_->normals());
        const Vector more = expression_->normal_sd_mm(data.settings.expression);
        for (Index v = 0; v < more.size(); ++v)
            total_sd_mm_[v] = std::hypot(total_sd_mm_[v], more[v]);
    }

    ZoneChange of(std::size_t zone) const {
        const std::vector<char> inside =
            membership(data_.zones.measured[zone].vertices, before_.vertices.rows());
        ZoneChange change;
        change.seen_share =
            seen_share(membership(data_.zones.named[zone].vertices, before_.vertices.rows()));
        change.reason = reason_of(inside, change.seen_share);
        if (change.reason == WhyUnknown::unseen) return change;
        const ZoneVolume& volume = volume_.volume->zones[zone];
        change.signed_ml.value = volume.volume.signed_ml;
        change.gained_ml.value = volume.volume.positive_ml;
        change.lost_ml.value = volume.volume.negative_ml;
        change.absolute_ml.value = volume.volume.absolute_ml;
        change.area_before_mm2 = volume.area_before_mm2;
        change.area_after_mm2 = volume.area_after_mm2;
        change.area_mm2.value = volume.area_after_mm2 - volume.area_before_mm2;
        change.mean_distance_mm.value = distance_.zones[zone].mean_signed_mm;
        if (change.reason != WhyUnknown::nothing) return change;
        signed_errors(zone, change);
        one_sided_errors(inside, change);
        change.area_mm2.sd = area_sd(inside);
        finish(change);
        return change;
    }

  private:
    const StudyFace& face(std::size_t k) const { return data_.faces[k]; }

    WhyUnknown reason_of_faces() const {
        for (const std::size_t k : {first_, second_})
            if (face(k).failed) return WhyUnknown::failed_fit;
        for (const std::size_t k : {first_, second_})
            if (face(k).normal_sd_mm.size() == 0) return WhyUnknown::no_surface_errors;
        return WhyUnknown::nothing;
    }

    WhyUnknown reason_of(const std::vector<char>& inside, double seen) const {
        if (seen < data_.settings.reporting.min_seen_share) return WhyUnknown::unseen;
        const WhyUnknown of_faces = reason_of_faces();
        if (of_faces != WhyUnknown::nothing || data_.model == nullptr) return of_faces;
        const Index rim = data_.model->num_vertices();
        double all = 0.0, outside = 0.0;
        for (Index v = 0; v < areas_.size(); ++v)
            if (inside[static_cast<std::size_t>(v)]) {
                all += areas_[v];
                if (v >= rim) outside += areas_[v];
            }
        return outside > data_.settings.reporting.max_outside_share * all
                   ? WhyUnknown::outside_expressions
                   : WhyUnknown::nothing;
    }

    /// Of the zone's area, what both visits saw; not a number when a face does not say.
    double seen_share(const std::vector<char>& inside) const {
        const Vector &a = face(first_).weights, &b = face(second_).weights;
        if (a.size() == 0 || b.size() == 0) return kUnknown;
        double all = 0.0, seen = 0.0;
        for (Index v = 0; v < areas_.size(); ++v)
            if (inside[static_cast<std::size_t>(v)]) {
                all += areas_[v];
                seen += areas_[v] * std::min(a[v], b[v]);
            }
        return all > 0 ? seen / all : 0.0;
    }

    VolumeErrorModel errors(const RigidZoneResult& alignment) const {
        const SurfaceErrorSettings& surface = data_.settings.surface;
        VolumeErrorModel model;
        model.sd_before_mm =
            change_deviation_mm(face(first_), face(second_), surface.unseen_apart_share);
        model.sd_after_mm =
            change_deviation_mm(face(second_), face(first_), surface.unseen_apart_share);
        model.correlation_length_mm = surface.correlation_length_mm;
        model.common_bias_mm = surface.common_bias_mm;
        model.alignment_centre = alignment.centre;
        // Alike about all axes: the injection study's settings were chosen so.
        model.alignment_covariance.diagonal().head<3>().setConstant(
            alignment.covariance.diagonal().head<3>().mean());
        model.alignment_covariance.diagonal().tail<3>().setConstant(
            alignment.covariance.diagonal().tail<3>().mean());
        return model;
    }

    double expression_sd(const ExpressionError::Part& part) const {
        return std::hypot(data_.settings.expression.posterior_factor * part.sd,
                          data_.settings.expression.untrained_share * part.removed);
    }

    void signed_errors(std::size_t zone, ZoneChange& change) const {
        const VolumeUncertainty& parts = volume_.zone_verdicts[zone].uncertainty;
        change.surface_sd_ml = parts.noise_ml;
        change.alignment_sd_ml = parts.alignment_ml;
        change.bias_sd_ml = parts.bias_ml;
        change.signed_ml.sd = parts.sd_ml;
        change.expression_sd_ml = 0.0;
        if (expression_) {
            const RemovedVolume removed =
                removed_volume(context_, *data_.model, data_.neutral.joint, first_, second_,
                               data_.zones.measured[zone].vertices);
            change.expression_removed_ml = removed.removed_ml;
            change.expression_sd_ml = expression_sd({removed.removed_ml, removed.sd_ml});
            change.signed_ml.sd = std::hypot(change.signed_ml.sd, change.expression_sd_ml);
        }
        change.mean_distance_mm.sd = 1e3 * change.signed_ml.sd / change.area_before_mm2;
    }

    double sd_of_loads(const Vector& loads_mm2) const {
        const double plain = propagation_->of_loads(loads_mm2, context_).sd_ml;
        if (!expression_) return plain;
        const ExpressionError::Part part = expression_->of_loads(loads_mm2);
        return std::hypot(plain, 1e-3 * expression_sd(part));
    }

    /// Gained, lost and absolute: the sums of parts of the zone.
    void one_sided_errors(const std::vector<char>& inside, ZoneChange& change) const {
        const Vector &moved = distance_.signed_mm, &areas = propagation_->areas_mm2();
        Vector gained = Vector::Zero(areas.size()), lost = gained;
        double bias_mm3 = 0.0;
        for (Index v = 0; v < areas.size(); ++v) {
            if (!inside[static_cast<std::size_t>(v)]) continue;
            (moved[v] >= 0 ? gained : lost)[v] = areas[v];
            if (std::fabs(moved[v]) < kNoiseReach * total_sd_mm_[v])
                bias_mm3 += areas[v] * total_sd_mm_[v] * kPositivePart;
        }
        change.gained_ml.noise_bias = 1e-3 * bias_mm3;
        change.lost_ml.noise_bias = -1e-3 * bias_mm3;
        change.absolute_ml.noise_bias = 2e-3 * bias_mm3;
        change.gained_ml.sd = sd_of_loads(gained);
        change.lost_ml.sd = sd_of_loads(lost);
        change.absolute_ml.sd = sd_of_loads(gained - lost);
    }

    /// Not a number when how far the template slid along the skin is not known.
    double area_sd(const std::vector<char>& inside) const {
        const Points& middle = propagation_->middle();
        const Points slopes = area_gradient(middle, before_.triangles, inside);
        const Vector along = slopes.cwiseProduct(propagation_->normals()).rowwise().sum();
        const VolumeUncertainty normal = propagation_->of_loads(along, context_);
        const double by_normal = 1e3 * std::hypot(normal.noise_ml, normal.bias_ml);
        const Points tangential = slopes - Points(along.asDiagonal() * propagation_->normals());
        const double by_slide = slide(middle, tangential);
        const double by_expression =
            expression_ ? expression_sd(expression_->of_slopes(slopes)) : 0.0;
        return std::hypot(by_normal, by_slide, by_expression);
    }

    /// Neutralized together, faces stand in correspondence along the skin where both were seen.
    double slide(const Points& middle, const Points& tangential) const {
        Vector a = face(first_).place_sd_mm, b = face(second_).place_sd_mm;
        if (a.size() == 0 || b.size() == 0) return kUnknown;
        const Vector &seen_a = face(first_).weights, &seen_b = face(second_).weights;
        for (Index v = 0; v < a.size() && expression_; ++v) {
            const double seen = std::min(seen_a.size() != 0 ? seen_a[v] : 1.0,
                                         seen_b.size() != 0 ? seen_b[v] : 1.0);
            a[v] *= 1.0 - seen;
            b[v] *= 1.0 - seen;
        }
        return slide_sd(context_, middle, tangential, a, b,
                        data_.settings.surface.slide_correlation_mm);
    }

    void finish(ZoneChange& change) const {
        const double level = data_.settings.reporting.level;
        for (StudyValue* value :
             {&change.signed_ml, &change.gained_ml, &change.lost_ml, &change.absolute_ml,
              &change.area_mm2, &change.mean_distance_mm}) {
            const Interval interval = normal_interval(value->value, value->sd, level);
            value->low = interval.low - std::max(0.0, value->noise_bias);
            value->high = interval.high - std::min(0.0, value->noise_bias);
            value->limit_of_detection =
                std::fabs(value->noise_bias) + minimal_detectable_change(value->sd, level);
        }
        change.gained_ml.low = std::max(0.0, change.gained_ml.low);
        change.lost_ml.high = std::min(0.0, change.lost_ml.high);
        change.absolute_ml.low = std::max(0.0, change.absolute_ml.low);
        change.detected =
            compare_with_limit(change.signed_ml.value, change.signed_ml.limit_of_detection) ==
                    Detection::detected
                ? 1
                : 0;
    }

    const Context& context_;
    const StudyData& data_;
    std::size_t first_, second_;
    const TriMesh& before_;
    Points after_;
    std::optional<VolumePropagation> propagation_;
    std::optional<ExpressionError> expression_;
    Measurement volume_;
    DistanceReport distance_;
    Vector areas_, total_sd_mm_;
};

}  // namespace

const char* why_unknown(WhyUnknown reason) {
    switch (reason) {
        case WhyUnknown::nothing:
            return "";
        case WhyUnknown::unseen:
            return "too little of the zone was seen in one of the visits";
        case WhyUnknown::failed_fit:
            return "the fit of one of the visits failed";
        case WhyUnknown::no_surface_errors:
            return "the surfaces' errors are unknown";
        case WhyUnknown::outside_expressions:
            return "the zone lies outside what the expression model covers";
    }
    return "";
}

PairChange compare_faces(const Context& context, const StudyData& data, std::size_t first,
                         std::size_t second) {
    PairChange result;
    const PairMeasure pair(context, data, first, second, result);
    for (std::size_t zone = 0; zone < data.zones.measured.size(); ++zone) {
        context.check_cancelled();
        result.zones.push_back(pair.of(zone));
    }
    return result;
}

TriMesh aligned_face(const StudyData& data, std::size_t second, const RigidZoneResult& alignment) {
    TriMesh face = *data.neutral.meshes[second];
    face.vertices = alignment.motion.apply(PointsRef(face.vertices));
    return face;
}

}  // namespace mien
