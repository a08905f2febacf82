// Deformation models as safetensors: the wide tensors first, then a filler so that the basis starts
// on a 64-byte boundary of the file and of any page-aligned mapping.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/json.hpp"
#include "model/deformation_model.hpp"
#include "model/model_json.hpp"

namespace mien {
namespace {

constexpr const char* kKind = "mien-deformation-model";
constexpr std::uint64_t kAlignment = 64;
const char* const kInfoPrefix = "info.";
const char* const kWallsKey = "walls_key";

std::uint64_t size_of(Index count) {
    return static_cast<std::uint64_t>(count);
}

Points read_points(const TensorView& view) {
    return Eigen::Map<const Points>(static_cast<const double*>(view.data),
                                    static_cast<Index>(view.shape[0]), 3);
}

void check_vertices(const std::uint32_t* values, std::uint64_t count, Index num_vertices,
                    const char* tensor) {
    for (std::uint64_t i = 0; i < count; ++i)
        if (static_cast<Index>(values[i]) >= num_vertices)
            fail_at(Status::bad_format, static_cast<std::int64_t>(i),
                    "tensor '%s' names vertex %lu of %lld", tensor,
                    static_cast<unsigned long>(values[i]), static_cast<long long>(num_vertices));
}

Triangles read_triangles(const TensorView& view) {
    return Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(view.data),
                                       static_cast<Index>(view.shape[0]), 3);
}

void read_template(const SafetensorsFile& file, TriMesh& mesh) {
    mesh.vertices = read_points(file.tensor("template_vertices", DType::f64, {-1, 3}));
    const Index n = mesh.vertices.rows();
    mesh.triangles = read_triangles(file.tensor("triangles", DType::u32, {-1, 3}));
    if (file.has("colors"))
        mesh.colors = Eigen::Map<const Colors>(
            static_cast<const std::uint8_t*>(file.tensor("colors", DType::u8, {n, 3}).data), n, 3);
    if (file.has("texture")) {
        const TensorView& texture = file.tensor("texture", DType::f32, {-1, 2});
        mesh.texture = Eigen::Map<const TextureCoordinates>(
            static_cast<const float*>(texture.data), static_cast<Index>(texture.shape[0]), 2);
        mesh.texture_triangles = read_triangles(
            file.tensor("texture_triangles", DType::u32, {mesh.triangles.rows(), 3}));
    }
    // Cheap against reading the file at all, and the rest of the library relies on it.
    check_mesh(mesh, "the model's template");
}

void read_names(const SafetensorsFile& file, DeformationModel& model) {
    const Index n = model.num_vertices();
    if (file.has("landmark_vertices")) {
        const TensorView& view = file.tensor("landmark_vertices", DType::u32, {-1});
        const auto names =
            parse_json_string_list(file.metadata("landmark_names"), "landmark_names");
        const auto* vertices = static_cast<const std::uint32_t*>(view.data);
        if (names.size() != view.count)
            fail(Status::bad_format, "%zu landmark names for %llu landmarks", names.size(),
                 static_cast<unsigned long long>(view.count));
        check_vertices(vertices, view.count, n, "landmark_vertices");
        for (std::size_t i = 0; i < names.size(); ++i)
            model.landmarks.push_back({names[i], vertices[i]});
    }
    if (file.has("zone_vertices")) {
        const TensorView& view = file.tensor("zone_vertices", DType::u32, {-1});
        const auto names = parse_json_string_list(file.metadata("zone_names"), "zone_names");
        const TensorView& sizes =
            file.tensor("zone_sizes", DType::u32, {static_cast<std::int64_t>(names.size())});
        const auto* vertices = static_cast<const std::uint32_t*>(view.data);
        check_vertices(vertices, view.count, n, "zone_vertices");
        std::uint64_t begin = 0;
        for (std::size_t z = 0; z < names.size(); ++z) {
            const std::uint64_t size = static_cast<const std::uint32_t*>(sizes.data)[z];
            if (size > view.count - begin)
                fail(Status::bad_format,
                     "tensor 'zone_sizes' asks for more than 'zone_vertices' has");
            model.zones.push_back({names[z], {vertices + begin, vertices + begin + size}});
            begin += size;
        }
    }
}

void read_walls(const SafetensorsFile& file, DeformationModel& model) {
    if (!file.has("walls")) return;
    const TensorView& view = file.tensor("walls", DType::u8, {model.num_vertices()});
    const auto* walls = static_cast<const std::uint8_t*>(view.data);
    for (std::uint64_t i = 0; i < view.count; ++i)
        if (walls[i] > 1)
            fail_at(Status::bad_format, static_cast<std::int64_t>(i),
                    "tensor 'walls': entry %llu is %d, neither 0 nor 1",
                    static_cast<unsigned long long>(i), walls[i]);
    model.walls.assign(walls, walls + view.count);
    model.walls_key = file.metadata(kWallsKey);
}

void read_left_out(DeformationModel& model) {
    const auto found = model.info.find(kLeftOutInfo);
    if (found == model.info.end()) return;
    constexpr double kMost_mm = 1000;
    double value = 0;
    if (!read_info_number(found->second, value) || !(value > 0) || !(value <= kMost_mm))
        fail(Status::bad_format, "info '%s' is '%.40s', not a length in mm", kLeftOutInfo,
             found->second.c_str());
    model.pca_left_out_mm = value;
}

}  // namespace

std::shared_ptr<const DeformationModel> load_deformation_model(
    const std::string& path, const SafetensorsReadOptions& options, const Context& context) {
    return read_deformation_model(SafetensorsFile::open(path, options, context));
}

std::shared_ptr<const DeformationModel> read_deformation_model(const SafetensorsFile& file) {
    file.require_kind(kKind);
    auto model = std::make_shared<DeformationModel>();
    read_template(file, model->template_mesh);
    const std::int64_t n = model->num_vertices();
    const TensorView& eigenvalues = file.tensor("eigenvalues", DType::f64, {-1});
    const auto r = static_cast<std::int64_t>(eigenvalues.count);
    model->eigenvalues = Eigen::Map<const Vector>(static_cast<const double*>(eigenvalues.data), r);
    for (Index j = 0; j < r; ++j)
        if (!(model->eigenvalues[j] >= 0))
            fail_at(Status::bad_format, j, "tensor 'eigenvalues': entry %lld is not a number >= 0",
                    static_cast<long long>(j));
    model->basis = {static_cast<const float*>(file.tensor("basis", DType::f32, {r, n}).data), n, r};
    if (file.has("mean_displacement"))
        model->mean_displacement =
            read_points(file.tensor("mean_displacement", DType::f64, {n, 3}));
    if (file.has("prior_variance")) {
        const TensorView& view = file.tensor("prior_variance", DType::f64, {3, r});
        model->prior_variance =
            Eigen::Map<const Matrix>(static_cast<const double*>(view.data), r, 3);
        if (r != 0 && !(model->prior_variance.minCoeff() >= 0))
            fail(Status::bad_format, "tensor 'prior_variance' holds a value below zero");
    }
    model->pca_modes = {nullptr, 3 * n, 0};
    if (file.has("pca_modes")) {
        const TensorView& view = file.tensor("pca_modes", DType::f32, {-1, 3 * n});
        model->pca_modes = {static_cast<const float*>(view.data), 3 * n,
                            static_cast<Index>(view.shape[0])};
    }
    if (r == 0 && model->pca_modes.cols == 0)
        fail(Status::bad_format, "the model has no mode at all");
    read_names(file, *model);
    read_walls(file, *model);
    const std::string prefix = kInfoPrefix;
    for (const auto& [key, value] : file.metadata())
        if (key.compare(0, prefix.size(), prefix) == 0)
            model->info[key.substr(prefix.size())] = value;
    read_left_out(*model);
    if (!file.warning().empty()) model->info[kFileWarning] = file.warning();
    model->storage = file.storage();
    return model;
}

void save_deformation_model(const std::string& path, const DeformationModel& model,
                            const Context& context) {
    const TriMesh& mesh = model.template_mesh;
    const std::uint64_t n = size_of(mesh.vertices.rows());
    std::vector<TensorToWrite> tensors;
    std::uint64_t bytes = 0;
    const auto add = [&](const char* name, DType dtype, std::vector<std::uint64_t> shape,
                         const void* data) {
        std::uint64_t count = dtype_bytes(dtype);
        for (const std::uint64_t extent : shape) count *= extent;
        bytes += count;
        tensors.push_back({name, dtype, std::move(shape), data});
    };
    add("template_vertices", DType::f64, {n, 3}, mesh.vertices.data());
    add("eigenvalues", DType::f64, {size_of(model.eigenvalues.size())}, model.eigenvalues.data());
    if (model.mean_displacement.rows() != 0)
        add("mean_displacement", DType::f64, {n, 3}, model.mean_displacement.data());
    if (model.prior_variance.rows() != 0)
        add("prior_variance", DType::f64, {3, size_of(model.prior_variance.rows())},
            model.prior_variance.data());
    static const std::uint8_t kFiller[kAlignment] = {};
    if (bytes % kAlignment != 0)
        add("filler", DType::u8, {kAlignment - bytes % kAlignment}, kFiller);
    add("basis", DType::f32, {size_of(model.basis.cols), n}, model.basis.data);
    if (model.pca_modes.cols != 0)
        add("pca_modes", DType::f32, {size_of(model.pca_modes.cols), 3 * n}, model.pca_modes.data);
    add("triangles", DType::u32, {size_of(mesh.triangles.rows()), 3}, mesh.triangles.data());

    std::map<std::string, std::string> metadata;
    metadata["kind"] = kKind;
    metadata["units"] = "millimetres";
    for (const auto& [key, value] : model.info)
        if (key != kFileWarning)
            metadata[kInfoPrefix + key] = value;  // the new file is a better one

    std::vector<std::uint32_t> landmark_vertices, zone_vertices, zone_sizes;
    std::vector<std::string> landmark_names, zone_names;
    for (const Landmark& landmark : model.landmarks) {
        landmark_vertices.push_back(landmark.vertex);
        landmark_names.push_back(landmark.name);
    }
    for (const Zone& zone : model.zones) {
        zone_vertices.insert(zone_vertices.end(), zone.vertices.begin(), zone.vertices.end());
        zone_sizes.push_back(static_cast<std::uint32_t>(zone.vertices.size()));
        zone_names.push_back(zone.name);
    }
    if (!landmark_vertices.empty()) {
        add("landmark_vertices", DType::u32, {landmark_vertices.size()}, landmark_vertices.data());
        metadata["landmark_names"] = json_string_list(landmark_names);
    }
    if (!zone_sizes.empty()) {
        add("zone_vertices", DType::u32, {zone_vertices.size()}, zone_vertices.data());
        add("zone_sizes", DType::u32, {zone_sizes.size()}, zone_sizes.data());
        metadata["zone_names"] = json_string_list(zone_names);
    }
    if (mesh.texture_triangles.rows() != 0) {
        add("texture", DType::f32, {size_of(mesh.texture.rows()), 2}, mesh.texture.data());
        add("texture_triangles", DType::u32, {size_of(mesh.texture_triangles.rows()), 3},
            mesh.texture_triangles.data());
    }
    if (mesh.colors.rows() != 0) add("colors", DType::u8, {n, 3}, mesh.colors.data());
    if (!model.walls.empty()) {
        add("walls", DType::u8, {n}, model.walls.data());
        metadata[kWallsKey] = model.walls_key;
    }
    write_safetensors(path, tensors, std::move(metadata), context);
}

}  // namespace mien
