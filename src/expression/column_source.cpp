#include "expression/column_source.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "geometry/alignment.hpp"

namespace mien {
namespace {

class DatasetColumns final : public ColumnSource {
  public:
    DatasetColumns(std::shared_ptr<const FaceDataset> dataset, const std::vector<int>& keep,
                   const std::vector<std::uint32_t>& stable)
        : dataset_(std::move(dataset)) {
        const int neutral = dataset_->neutral_expression();
        if (neutral < 0)
            fail(Status::invalid_argument,
                 "the data set's expression_names have no entry 'neutral'; training needs neutral "
                 "faces");
        num_vertices = dataset_->num_vertices();
        triangles = dataset_->triangles();
        expression_names = dataset_->expression_names();

        std::map<int, std::vector<Index>> neutrals_of;
        std::map<int, Index> first_neutral_of;  // of every subject
        auto kept = [&](int subject) {
            return keep.empty() || std::find(keep.begin(), keep.end(), subject) != keep.end();
        };
        for (Index face = 0; face < dataset_->num_faces(); ++face)
            if (dataset_->expression(face) == neutral) {
                first_neutral_of.emplace(dataset_->subject(face), face);
                if (kept(dataset_->subject(face)))
                    neutrals_of[dataset_->subject(face)].push_back(face);
            }
        std::map<int, std::size_t> place;
        for (auto& [subject, faces] : neutrals_of) {
            place[subject] = neutral_faces_.size();
            neutral_subject.push_back(subject);
            neutral_faces_.push_back(std::move(faces));
        }
        for (Index face = 0; face < dataset_->num_faces(); ++face) {
            const int subject = dataset_->subject(face);
            if (dataset_->expression(face) == neutral || !kept(subject)) continue;
            const auto found = place.find(subject);
            if (found == place.end()) {
                ++num_skipped;
                continue;
            }
            displacement_subject.push_back(subject);
            displacement_expression.push_back(dataset_->expression(face));
            displacement_face_.push_back(face);
            displacement_neutral_.push_back(found->second);
        }
        if (neutral_faces_.size() < 2 || displacement_face_.empty())
            fail(Status::invalid_argument,
                 "training needs at least 2 subjects with a neutral face and one other expression; "
                 "there are %zu subjects and %zu usable faces",
                 neutral_faces_.size(), displacement_face_.size());
        if (!stable.empty()) find_reference(stable, first_neutral_of);
    }

    void neutrals(Index begin, Eigen::Ref<Matrix> block) const override {
        for (Index k = 0; k < block.cols(); ++k) {
            neutral(static_cast<std::size_t>(begin + k), face_);
            block.col(k) = face_;
        }
    }

    void displacements(Index begin, Eigen::Ref<Matrix> block) const override {
        std::size_t held = neutral_faces_.size();  // the neutral of consecutive faces is read once
        for (Index k = 0; k < block.cols(); ++k) {
            const std::size_t column = static_cast<std::size_t>(begin + k);
            if (displacement_neutral_[column] != held) {
                held = displacement_neutral_[column];
                neutral(held, neutral_);
            }
            read(displacement_face_[column], face_);
            block.col(k) = face_ - neutral_;
        }
    }

  private:
    void neutral(std::size_t column, Vector& out) const {
        const std::vector<Index>& faces = neutral_faces_[column];
        read(faces[0], out);
        if (faces.size() == 1) return;
        Vector other;
        for (std::size_t k = 1; k < faces.size(); ++k) {
            read(faces[k], other);
            out += other;
        }
        out /= static_cast<double>(faces.size());
    }

    void read(Index face, Vector& out) const {
        Points points;
        dataset_->face(face, points);
        dataset_->release_face(face);
        if (stable_reference.rows() != 0)
            points = align_points(stable_rows(points), stable_reference, Vector(), false)
                         .apply(PointsRef(points));
        out = Eigen::Map<const Vector>(points.data(), points.size());
        if (!out.allFinite())
            fail_at(Status::corrupt, static_cast<std::int64_t>(face),
                    "face %lld of the data set holds a value that is not finite",
                    static_cast<long long>(face));
    }

    Points stable_rows(const Points& points) const {
        Points rows(static_cast<Index>(stable_vertices.size()), 3);
        for (std::size_t k = 0; k < stable_vertices.size(); ++k)
            rows.row(static_cast<Index>(k)) = points.row(stable_vertices[k]);
        return rows;
    }

    /// Mean stable zone of the neutral faces: aligned to the first, averaged, and once again.
    void find_reference(const std::vector<std::uint32_t>& stable,
                        const std::map<int, Index>& faces) {
        for (std::size_t k = 0; k < stable.size(); ++k)
            if (stable[k] >= static_cast<std::uint64_t>(num_vertices))
                fail_at(Status::invalid_argument, static_cast<std::int64_t>(k),
                        "the stable zone names vertex %u of %lld", stable[k],
                        static_cast<long long>(num_vertices));
        stable_vertices = stable;
        std::vector<Points> zones;
        Points points;
        for (const auto& [subject, face] : faces) {
            dataset_->face(face, points);
            dataset_->release_face(face);
            zones.push_back(stable_rows(points));
            if (!zones.back().allFinite())
                fail_at(Status::corrupt, static_cast<std::int64_t>(face),
                        "face %lld of the data set holds a value that is not finite",
                        static_cast<long long>(face));
        }
        Points reference = zones[0];
        for (int round = 0; round < 2; ++round) {
            Points sum = Points::Zero(reference.rows(), 3);
            for (const Points& rows : zones)
                sum += align_points(rows, reference, Vector(), false).apply(PointsRef(rows));
            reference = sum / static_cast<double>(zones.size());
        }
        stable_reference = reference;
    }

    std::shared_ptr<const FaceDataset> dataset_;
    std::vector<std::vector<Index>> neutral_faces_;
    std::vector<Index> displacement_face_;
    std::vector<std::size_t> displacement_neutral_;
    mutable Vector face_, neutral_;
};

}  // namespace

std::unique_ptr<ColumnSource> dataset_columns(std::shared_ptr<const FaceDataset> dataset,
                                              const std::vector<int>& keep_subject,
                                              const std::vector<std::uint32_t>& stable_vertices) {
    return std::make_unique<DatasetColumns>(std::move(dataset), keep_subject, stable_vertices);
}

}  // namespace mien
