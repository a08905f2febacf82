#include "learning/hierarchy.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "base/error.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/decimation.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

RowSparse matrix_of(Index rows, Index cols, const Triplets& entries) {
    RowSparse matrix(rows, cols);
    matrix.setFromTriplets(entries.begin(), entries.end());
    matrix.makeCompressed();
    return matrix;
}

void check_levels(Index num_levels) {
    if (num_levels < 1 || num_levels > 32)
        fail(Status::invalid_argument, "%lld levels; 1 to 32 are possible",
             static_cast<long long>(num_levels));
}

MeshHierarchy with_finest(const TriMesh& mesh, const char* kind) {
    check_mesh(mesh, "the template");
    MeshHierarchy hierarchy;
    hierarchy.kind = kind;
    hierarchy.levels.emplace_back();
    hierarchy.levels[0].mesh.vertices = mesh.vertices;
    hierarchy.levels[0].mesh.triangles = mesh.triangles;
    return hierarchy;
}

/// More entries of a sampling matrix than this (4 GB) come of a mesh that is none of a face: a
/// vertex with thousands of neighbours is in everybody's neighbourhood.
constexpr std::size_t kMostEntries = std::size_t(1) << 28;

void check_entries(std::size_t count, const Context& context) {
    context.check_cancelled();
    if (count > kMostEntries)
        fail(Status::invalid_mesh,
             "the neighbourhoods of the hierarchy hold more than %zu vertices together; use a mesh "
             "without vertices of thousands of neighbours, or a smaller radius",
             kMostEntries);
}

void add_csr(std::vector<TensorToWrite>& tensors, const std::string& name, const RowSparse& m) {
    tensors.push_back(
        {name + ".values", DType::f64, {static_cast<std::uint64_t>(m.nonZeros())}, m.valuePtr()});
    tensors.push_back({name + ".rows",
                       DType::u32,
                       {static_cast<std::uint64_t>(m.rows()) + 1},
                       m.outerIndexPtr()});
    tensors.push_back({name + ".cols",
                       DType::u32,
                       {static_cast<std::uint64_t>(m.nonZeros())},
                       m.innerIndexPtr()});
}

RowSparse read_csr(const SafetensorsFile& file, const std::string& name, Index rows, Index cols) {
    const TensorView& values = file.tensor(name + ".values", DType::f64, {-1});
    const auto count = static_cast<std::int64_t>(values.count);
    const auto* starts = static_cast<const std::uint32_t*>(
        file.tensor(name + ".rows", DType::u32, {static_cast<std::int64_t>(rows) + 1}).data);
    const auto* columns =
        static_cast<const std::uint32_t*>(file.tensor(name + ".cols", DType::u32, {count}).data);
    const auto* data = static_cast<const double*>(values.data);
    Triplets entries;
    if (starts[0] != 0 || starts[rows] != values.count)
        fail(Status::bad_format, "the rows of '%s' do not cover its values", name.c_str());
    for (Index r = 0; r < rows; ++r) {
        if (starts[r + 1] < starts[r])
            fail(Status::bad_format, "the rows of '%s' do not ascend", name.c_str());
        for (std::uint32_t p = starts[r]; p < starts[r + 1] && p < values.count; ++p) {
            if (columns[p] >= static_cast<std::uint64_t>(cols))
                fail(Status::bad_format, "column %u of '%s' is out of range", columns[p],
                     name.c_str());
            entries.emplace_back(r, static_cast<Index>(columns[p]), data[p]);
        }
    }
    return matrix_of(rows, cols, entries);
}

}  // namespace

std::shared_ptr<const MeshHierarchy> quadric_hierarchy(const TriMesh& mesh, Index num_levels,
                                                       double factor, const Context& context) {
    check_levels(num_levels);
    if (!(factor > 1) || !std::isfinite(factor))
        fail(Status::invalid_argument, "a reduction factor of %g a level; it must be above 1",
             factor);
    auto hierarchy = std::make_shared<MeshHierarchy>(with_finest(mesh, "quadric"));
    for (Index l = 1; l <= num_levels; ++l) {
        const TriMesh& fine = hierarchy->levels.back().mesh;
        const Index n = fine.vertices.rows();
        const auto wanted = static_cast<Index>(std::ceil(static_cast<double>(n) / factor));
        if (wanted < 4) break;
        DecimatedMesh coarse = decimate(fine, wanted, context);
        if (coarse.mesh.vertices.rows() >= n || coarse.mesh.triangles.rows() == 0) break;
        MeshLevel level;
        Triplets down, up;
        for (std::size_t i = 0; i < coarse.kept.size(); ++i)
            down.emplace_back(static_cast<Index>(i), coarse.kept[i], 1.0);
        const TriangleTree tree(coarse.mesh.vertices, coarse.mesh.triangles, context);
        std::vector<SurfaceHit> hits;
        tree.closest(fine.vertices, std::numeric_limits<double>::infinity(), hits, context);
        std::vector<Index> coarse_of(static_cast<std::size_t>(n), -1);
        for (std::size_t i = 0; i < coarse.kept.size(); ++i)
            coarse_of[coarse.kept[i]] = static_cast<Index>(i);
        for (Index v = 0; v < n; ++v) {
            if (coarse_of[v] >= 0) {  // a kept vertex comes back exactly
                up.emplace_back(v, coarse_of[v], 1.0);
                continue;
            }
            const SurfaceHit& hit = hits[static_cast<std::size_t>(v)];
            for (int c = 0; c < 3; ++c)
                if (hit.barycentric[c] != 0)
                    up.emplace_back(v, coarse.mesh.triangles(hit.triangle, c), hit.barycentric[c]);
        }
        level.down = matrix_of(coarse.mesh.vertices.rows(), n, down);
        level.up = matrix_of(n, coarse.mesh.vertices.rows(), up);
        level.mesh = std::move(coarse.mesh);
        level.kept = std::move(coarse.kept);
        hierarchy->levels.push_back(std::move(level));
    }
    return hierarchy;
}

std::shared_ptr<const MeshHierarchy> connectivity_hierarchy(const TriMesh& mesh, Index num_levels,
                                                            Index stride, Index radius,
                                                            const Context& context) {
    check_levels(num_levels);
    if (stride < 1 || radius < stride - 1 || radius > 64)
        fail(Status::invalid_argument,
             "stride %lld with radius %lld: stride is at least 1, radius stride - 1 to 64",
             static_cast<long long>(stride), static_cast<long long>(radius));
    auto hierarchy = std::make_shared<MeshHierarchy>(with_finest(mesh, "connectivity"));
    VertexRings rings = build_rings(mesh.vertices.rows(), mesh.triangles);
    for (Index l = 1; l <= num_levels; ++l) {
        context.check_cancelled();
        const TriMesh& fine = hierarchy->levels.back().mesh;
        const Index n = fine.vertices.rows();
        RingWalker ball(rings);
        MeshLevel level;
        std::vector<char> covered(static_cast<std::size_t>(n), 0);
        std::vector<Index> coarse_of(static_cast<std::size_t>(n), -1);
        for (Index v = 0; v < n; ++v) {
            if (covered[static_cast<std::size_t>(v)]) continue;
            coarse_of[static_cast<std::size_t>(v)] = static_cast<Index>(level.kept.size());
            level.kept.push_back(static_cast<std::uint32_t>(v));
            for (const std::uint32_t w : ball.within(static_cast<std::uint32_t>(v), stride - 1))
                covered[w] = 1;
        }
        if (static_cast<Index>(level.kept.size()) == n && stride > 1) break;
        const auto m = static_cast<Index>(level.kept.size());
        Triplets down, up;
        std::vector<double> received(static_cast<std::size_t>(n), 0);
        for (Index i = 0; i < m; ++i) {
            const auto& members = ball.within(level.kept[static_cast<std::size_t>(i)], radius);
            check_entries(down.size() + members.size(), context);
            for (const std::uint32_t w : members) {
                down.emplace_back(i, w, 1.0 / static_cast<double>(members.size()));
                received[w] += 1;
            }
        }
        for (const auto& entry : down)
            up.emplace_back(entry.col(), entry.row(),
                            1.0 / received[static_cast<std::size_t>(entry.col())]);
        level.down = matrix_of(m, n, down);
        level.up = matrix_of(n, m, up);
        // Two kept vertices are neighbours when their neighbourhoods of `stride` edges meet.
        VertexRings coarse;
        coarse.begin.push_back(0);
        for (Index i = 0; i < m; ++i) {
            for (const std::uint32_t w :
                 ball.within(level.kept[static_cast<std::size_t>(i)], 2 * stride - 1))
                if (coarse_of[w] >= 0 && coarse_of[w] != i)
                    coarse.neighbours.push_back(static_cast<std::uint32_t>(coarse_of[w]));
            std::sort(coarse.neighbours.begin() + coarse.begin.back(), coarse.neighbours.end());
            coarse.begin.push_back(static_cast<std::uint32_t>(coarse.neighbours.size()));
            check_entries(coarse.neighbours.size(), context);
        }
        level.mesh.vertices.resize(m, 3);
        for (Index i = 0; i < m; ++i)
            level.mesh.vertices.row(i) = fine.vertices.row(level.kept[static_cast<std::size_t>(i)]);
        rings = std::move(coarse);
        level.graph = rings;
        hierarchy->levels.push_back(std::move(level));
    }
    return hierarchy;
}

void save_mesh_hierarchy(const std::string& path, const MeshHierarchy& hierarchy,
                         const Context& context) {
    std::vector<TensorToWrite> tensors;
    for (std::size_t l = 0; l < hierarchy.levels.size(); ++l) {
        const MeshLevel& level = hierarchy.levels[l];
        const std::string number = std::to_string(l);
        tensors.push_back({"vertices_" + number,
                           DType::f64,
                           {static_cast<std::uint64_t>(level.mesh.vertices.rows()), 3},
                           level.mesh.vertices.data()});
        if (l > 0) {
            add_csr(tensors, "down_" + number, level.down);
            add_csr(tensors, "up_" + number, level.up);
            tensors.push_back(
                {"kept_" + number, DType::u32, {level.kept.size()}, level.kept.data()});
        }
        tensors.push_back({"triangles_" + number,
                           DType::u32,
                           {static_cast<std::uint64_t>(level.mesh.triangles.rows()), 3},
                           level.mesh.triangles.data()});
    }
    std::stable_sort(tensors.begin(), tensors.end(),
                     [](const TensorToWrite& a, const TensorToWrite& b) {
                         return dtype_bytes(a.dtype) > dtype_bytes(b.dtype);
                     });
    write_safetensors(path, tensors,
                      {{"kind", "mien-mesh-hierarchy"},
                       {"units", "millimetres"},
                       {"sampling", hierarchy.kind},
                       {"levels", std::to_string(hierarchy.levels.size())}},
                      context);
}

std::shared_ptr<const MeshHierarchy> load_mesh_hierarchy(const std::string& path,
                                                         const SafetensorsReadOptions& options,
                                                         const Context& context) {
    const SafetensorsFile file = SafetensorsFile::open(path, options, context);
    file.require_kind("mien-mesh-hierarchy");
    auto hierarchy = std::make_shared<MeshHierarchy>();
    hierarchy->kind = file.metadata("sampling");
    for (int l = 0; l <= 32 && file.has("vertices_" + std::to_string(l)); ++l) {
        const std::string number = std::to_string(l);
        MeshLevel level;
        const TensorView& vertices = file.tensor("vertices_" + number, DType::f64, {-1, 3});
        const TensorView& triangles = file.tensor("triangles_" + number, DType::u32, {-1, 3});
        level.mesh.vertices = Eigen::Map<const Points>(static_cast<const double*>(vertices.data),
                                                       static_cast<Index>(vertices.shape[0]), 3);
        level.mesh.triangles =
            Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(triangles.data),
                                        static_cast<Index>(triangles.shape[0]), 3);
        check_mesh(level.mesh, "a level of the hierarchy");
        if (l > 0) {
            const Index fine = hierarchy->levels.back().mesh.vertices.rows();
            const Index coarse = level.mesh.vertices.rows();
            level.down = read_csr(file, "down_" + number, coarse, fine);
            level.up = read_csr(file, "up_" + number, fine, coarse);
            const TensorView& kept =
                file.tensor("kept_" + number, DType::u32, {static_cast<std::int64_t>(coarse)});
            const auto* data = static_cast<const std::uint32_t*>(kept.data);
            level.kept.assign(data, data + kept.count);
        }
        hierarchy->levels.push_back(std::move(level));
    }
    if (hierarchy->levels.empty()) fail(Status::bad_format, "a mesh hierarchy without levels");
    return hierarchy;
}

}  // namespace mien
