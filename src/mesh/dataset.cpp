#include "mesh/dataset.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json.hpp"

namespace mien {
namespace {

double millimetres_per(const std::string& units) {
    static const struct {
        const char* name;
        double mm;
    } kUnits[] = {{"mm", 1.0},   {"millimetres", 1.0},  {"millimeters", 1.0},
                  {"cm", 10.0},  {"centimetres", 10.0}, {"centimeters", 10.0},
                  {"m", 1000.0}, {"metres", 1000.0},    {"meters", 1000.0}};
    for (const auto& unit : kUnits)
        if (units == unit.name) return unit.mm;
    fail(Status::bad_format, "the dataset's units '%s' are unknown; use mm, cm or m",
         shown_name(units).c_str());
}

int neutral_of(const std::vector<std::string>& names) {
    for (std::size_t k = 0; k < names.size(); ++k)
        if (names[k] == "neutral") return static_cast<int>(k);
    return -1;
}

}  // namespace

FaceDataset FaceDataset::open(const std::string& path, const SafetensorsReadOptions& options,
                              const Context& context) {
    const FileBytes bytes = context.copy_files ? read_whole_file(path, context) : map_file(path);
    try {
        SafetensorsReadOptions reading = options;
        reading.give_pages_back = !context.copy_files;
        const SafetensorsFile file =
            SafetensorsFile::from_memory(bytes.data, bytes.size, reading, context);
        // Other programs' datasets do not say what they are; ours, and our other files, do.
        if (file.metadata().count("kind") != 0) file.require_kind("mien-face-dataset");
        FaceDataset set;
        const DType dtype =
            file.has("vertices") && file.tensors().at("vertices").dtype == DType::f64 ? DType::f64
                                                                                      : DType::f32;
        set.vertices_ = file.tensor("vertices", dtype, {-1, -1, 3});
        constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
        if (set.vertices_.count == 0)
            fail(Status::bad_format, "tensor 'vertices' is empty; a dataset needs faces");
        if (set.vertices_.shape[0] > kMost || set.vertices_.shape[1] > kMost)
            fail(Status::bad_format, "tensor 'vertices' has more than 2^31 - 1 faces or vertices");
        set.num_faces_ = static_cast<Index>(set.vertices_.shape[0]);
        set.num_vertices_ = static_cast<Index>(set.vertices_.shape[1]);

        const TensorView& triangles = file.tensor("triangles", DType::u32, {-1, 3});
        set.triangles_ =
            Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(triangles.data),
                                        static_cast<Index>(triangles.shape[0]), 3);
        for (Index t = 0; t < set.triangles_.rows(); ++t)
            for (int k = 0; k < 3; ++k)
                if (set.triangles_(t, k) >= static_cast<std::uint64_t>(set.num_vertices_))
                    fail_at(Status::bad_format, t,
                            "tensor 'triangles': triangle %lld names vertex %lu of %lld",
                            static_cast<long long>(t),
                            static_cast<unsigned long>(set.triangles_(t, k)),
                            static_cast<long long>(set.num_vertices_));

        set.expression_names_ =
            parse_json_string_list(file.metadata("expression_names"), "expression_names");
        set.neutral_ = neutral_of(set.expression_names_);
        auto read_labels = [&](const char* name, std::size_t limit) {
            const TensorView& view = file.tensor(name, DType::i32, {set.num_faces_});
            const auto* values = static_cast<const std::int32_t*>(view.data);
            for (Index k = 0; k < set.num_faces_; ++k)
                if (values[k] < 0 || static_cast<std::size_t>(values[k]) >= limit)
                    fail_at(Status::bad_format, k, "tensor '%s': face %lld has the label %d", name,
                            static_cast<long long>(k), static_cast<int>(values[k]));
            return std::vector<int>(values, values + set.num_faces_);
        };
        set.subject_ = read_labels("subject", static_cast<std::size_t>(kMost));
        set.expression_ = read_labels("expression", set.expression_names_.size());

        const auto units = file.metadata().find("units");
        set.units_ = units == file.metadata().end() ? "millimetres" : units->second;
        set.to_mm_ = millimetres_per(set.units_);
        const auto* vertices = static_cast<const char*>(set.vertices_.data);
        // Pages of a copy do not come back once they are given up.
        set.mapped_ =
            !context.copy_files && vertices >= bytes.data && vertices < bytes.data + bytes.size;
        set.storage_ = std::make_shared<std::vector<std::shared_ptr<const void>>>(
            std::vector<std::shared_ptr<const void>>{bytes.storage, file.storage()});
        return set;
    } catch (const Error& error) {
        if (error.status() == Status::cancelled || error.status() == Status::memory_budget) throw;
        fail_at(error.status(), error.detail_index(), "'%s': %s", shown_path(path).c_str(),
                error.what());
    }
}

void FaceDataset::face(Index k, Points& out) const {
    if (k < 0 || k >= num_faces_)
        fail(Status::invalid_argument, "face %lld of a dataset of %lld faces",
             static_cast<long long>(k), static_cast<long long>(num_faces_));
    const std::size_t offset =
        static_cast<std::size_t>(k) * 3 * static_cast<std::size_t>(num_vertices_);
    if (vertices_.dtype == DType::f64) {
        out = Eigen::Map<const Points>(static_cast<const double*>(vertices_.data) + offset,
                                       num_vertices_, 3);
    } else {
        using PointsF = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
        out = Eigen::Map<const PointsF>(static_cast<const float*>(vertices_.data) + offset,
                                        num_vertices_, 3)
                  .cast<double>();
    }
    if (to_mm_ != 1.0) out *= to_mm_;
}

void FaceDataset::release_face(Index k) const {
    if (!mapped_ || k < 0 || k >= num_faces_) return;
    const std::size_t bytes =
        3 * static_cast<std::size_t>(num_vertices_) * dtype_bytes(vertices_.dtype);
    release_pages(static_cast<const char*>(vertices_.data) + static_cast<std::size_t>(k) * bytes,
                  bytes);
}

FaceDatasetWriter::FaceDatasetWriter(Triangles triangles, Index num_vertices,
                                     std::vector<std::string> expression_names)
    : triangles_(std::move(triangles)),
      num_vertices_(num_vertices),
      expression_names_(std::move(expression_names)) {
    if (num_vertices < 1) fail(Status::invalid_argument, "a dataset needs at least one vertex");
    if (expression_names_.empty())
        fail(Status::invalid_argument, "a dataset needs at least one expression name");
    for (Index t = 0; t < triangles_.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            if (triangles_(t, k) >= static_cast<std::uint64_t>(num_vertices))
                fail_at(Status::invalid_mesh, t, "triangle %lld names a vertex that is not there",
                        static_cast<long long>(t));
}

void FaceDatasetWriter::add(const PointsRef& vertices_mm, int subject, int expression) {
    if (vertices_mm.rows() != num_vertices_)
        fail(Status::mismatch, "the face has %lld vertices, the dataset %lld",
             static_cast<long long>(vertices_mm.rows()), static_cast<long long>(num_vertices_));
    if (subject < 0) fail(Status::invalid_argument, "subject %d: numbers begin at zero", subject);
    if (expression < 0 || static_cast<std::size_t>(expression) >= expression_names_.size())
        fail(Status::invalid_argument, "expression %d of %zu names", expression,
             expression_names_.size());
    // Also refuses what float32 cannot hold.
    for (Index v = 0; v < num_vertices_; ++v)
        if (!vertices_mm.row(v).cast<float>().allFinite())
            fail_at(Status::invalid_mesh, v, "vertex %lld of the face is not finite",
                    static_cast<long long>(v));
    const std::size_t before = vertices_.size();
    vertices_.resize(before + 3 * static_cast<std::size_t>(num_vertices_));
    using PointsF = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
    Eigen::Map<PointsF>(vertices_.data() + before, num_vertices_, 3) = vertices_mm.cast<float>();
    subject_.push_back(subject);
    expression_.push_back(expression);
}

void FaceDatasetWriter::save(const std::string& path, const Context& context) const {
    if (subject_.empty()) fail(Status::invalid_argument, "the dataset has no face yet");
    const std::uint64_t faces = subject_.size();
    write_safetensors(path,
                      {{"vertices",
                        DType::f32,
                        {faces, static_cast<std::uint64_t>(num_vertices_), 3},
                        vertices_.data()},
                       {"subject", DType::i32, {faces}, subject_.data()},
                       {"expression", DType::i32, {faces}, expression_.data()},
                       {"triangles",
                        DType::u32,
                        {static_cast<std::uint64_t>(triangles_.rows()), 3},
                        triangles_.data()}},
                      {{"kind", "mien-face-dataset"},
                       {"units", "millimetres"},
                       {"expression_names", json_string_list(expression_names_)}},
                      context);
}

}  // namespace mien
