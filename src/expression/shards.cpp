#include "expression/shards.hpp"

#include <algorithm>
#include <set>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json.hpp"

namespace mien {
namespace {

constexpr const char* kKind = "mien-expression-shard";
constexpr double kSameReferenceMm = 1e-6;

/// One shard's mapped tensors.
struct Shard {
    std::shared_ptr<const void> storage;
    Eigen::Map<const Matrix> basis{nullptr, 0, 0};          ///< 3#V x r
    Eigen::Map<const Matrix> neutrals{nullptr, 0, 0};       ///< r x m
    Eigen::Map<const Matrix> displacements{nullptr, 0, 0};  ///< r x s
    Eigen::Map<const Vector> mean{nullptr, 0};
};

Eigen::Map<const Matrix> matrix_view(const TensorView& view, Index rows, Index cols) {
    return {static_cast<const double*>(view.data), rows, cols};
}

std::vector<int> labels(const SafetensorsFile& file, const char* name, Index count, int limit) {
    const TensorView& view = file.tensor(name, DType::i32, {count});
    const auto* values = static_cast<const std::int32_t*>(view.data);
    for (Index k = 0; k < count; ++k)
        if (values[k] < 0 || (limit >= 0 && values[k] >= limit))
            fail_at(Status::corrupt, k, "the shard's tensor '%s' holds the label %d", name,
                    values[k]);
    return std::vector<int>(values, values + count);
}

class ShardColumns final : public ColumnSource {
  public:
    void append(const std::string& path, const SafetensorsReadOptions& options,
                const Context& context) {
        const SafetensorsFile file = SafetensorsFile::open(path, options, context);
        file.require_kind(kKind);
        const TensorView& basis = file.tensor("basis", DType::f64, {-1, -1, 3});
        const Index rank = static_cast<Index>(basis.shape[0]),
                    n = static_cast<Index>(basis.shape[1]);
        const TensorView& shape = file.tensor("triangles", DType::u32, {-1, 3});
        const Triangles own = Eigen::Map<const Triangles>(
            static_cast<const std::uint32_t*>(shape.data), static_cast<Index>(shape.shape[0]), 3);
        const std::vector<std::string> names =
            parse_json_string_list(file.metadata("expression_names"), "expression_names");
        std::vector<std::uint32_t> stable;
        Points reference;
        if (file.has("stable_vertices")) {
            const TensorView& zone = file.tensor("stable_vertices", DType::u32, {-1});
            const auto* first = static_cast<const std::uint32_t*>(zone.data);
            stable.assign(first, first + zone.count);
            const auto count = static_cast<std::int64_t>(zone.count);
            reference = Eigen::Map<const Points>(
                static_cast<const double*>(
                    file.tensor("stable_reference", DType::f64, {count, 3}).data),
                static_cast<Index>(count), 3);
        }
        if (shards_.empty()) {
            num_vertices = n;
            triangles = own;
            expression_names = names;
            stable_vertices = stable;
            stable_reference = reference;
        } else if (n != num_vertices || own.rows() != triangles.rows() || own != triangles ||
                   names != expression_names) {
            fail(Status::mismatch,
                 "'%s' was made from faces of another topology or with other expression names",
                 shown_path(path).c_str());
        } else if (stable != stable_vertices ||
                   (reference.rows() != 0 &&
                    (reference - stable_reference).cwiseAbs().maxCoeff() > kSameReferenceMm)) {
            fail(Status::mismatch,
                 "the faces of '%s' were aligned in another way than those of the first shard: "
                 "make all shards "
                 "from one data set with one stable zone",
                 shown_path(path).c_str());
        }
        const TensorView& neutrals = file.tensor("neutrals", DType::f64, {-1, rank});
        const TensorView& displacements = file.tensor("displacements", DType::f64, {-1, rank});
        const Index m = static_cast<Index>(neutrals.shape[0]);
        const Index s = static_cast<Index>(displacements.shape[0]);
        Shard shard;
        shard.storage = file.storage();
        new (&shard.basis) Eigen::Map<const Matrix>(matrix_view(basis, 3 * n, rank));
        new (&shard.neutrals) Eigen::Map<const Matrix>(matrix_view(neutrals, rank, m));
        new (&shard.displacements) Eigen::Map<const Matrix>(matrix_view(displacements, rank, s));
        new (&shard.mean) Eigen::Map<const Vector>(
            static_cast<const double*>(file.tensor("mean", DType::f64, {n, 3}).data), 3 * n);

        const std::vector<int> subjects = labels(file, "neutral_subject", m, -1);
        for (int subject : subjects)
            if (!known_subjects_.insert(subject).second)
                fail(Status::invalid_argument,
                     "subject %d is in two shards ('%s' is the second); split a study by subject",
                     subject, shown_path(path).c_str());
        append_to(neutral_subject, subjects);
        append_to(displacement_subject, labels(file, "displacement_subject", s, -1));
        append_to(displacement_expression,
                  labels(file, "displacement_expression", s, static_cast<int>(names.size())));
        shards_.push_back(std::move(shard));
    }

    void neutrals(Index begin, Eigen::Ref<Matrix> block) const override {
        fill(begin, block, true);
    }
    void displacements(Index begin, Eigen::Ref<Matrix> block) const override {
        fill(begin, block, false);
    }

  private:
    static void append_to(std::vector<int>& all, const std::vector<int>& more) {
        all.insert(all.end(), more.begin(), more.end());
    }

    void fill(Index begin, Eigen::Ref<Matrix> block, bool identity) const {
        Index first = 0, done = 0;
        for (const Shard& shard : shards_) {
            const auto& coordinates = identity ? shard.neutrals : shard.displacements;
            const Index last = first + coordinates.cols();
            const Index from = std::max(begin + done, first);
            const Index to = std::min(begin + block.cols(), last);
            if (from < to) {
                auto part = block.middleCols(done, to - from);
                dense::multiply(Context(), 1.0, shard.basis, dense::Op::none,
                                coordinates.middleCols(from - first, to - from), dense::Op::none,
                                0.0, part);
                if (identity) part.colwise() += shard.mean;
                done += to - from;
            }
            first = last;
        }
    }

    std::vector<Shard> shards_;
    std::set<int> known_subjects_;
};

}  // namespace

ShardReport write_expression_shard(const std::string& path, const ColumnSource& source,
                                   const ShardOptions& options, const Context& context) {
    if (options.max_rank < 1) fail(Status::invalid_argument, "a shard needs a rank of at least 1");
    JointSpanOptions span_options;
    span_options.identity_rank = span_options.expression_rank = options.max_rank;
    span_options.passes = options.passes;
    const JointSpan span = find_joint_span(context, source, span_options);
    const std::uint64_t n = static_cast<std::uint64_t>(source.num_vertices);
    const std::uint64_t rank = static_cast<std::uint64_t>(span.basis.cols());
    const std::uint64_t m = static_cast<std::uint64_t>(source.num_neutrals());
    const std::uint64_t s = static_cast<std::uint64_t>(source.num_displacements());
    std::vector<TensorToWrite> tensors = {
        {"basis", DType::f64, {rank, n, 3}, span.basis.data()},
        {"mean", DType::f64, {n, 3}, span.mean.data()},
        {"neutrals", DType::f64, {m, rank}, span.neutrals.data()},
        {"displacements", DType::f64, {s, rank}, span.displacements.data()},
        {"neutral_subject", DType::i32, {m}, source.neutral_subject.data()},
        {"displacement_subject", DType::i32, {s}, source.displacement_subject.data()},
        {"displacement_expression", DType::i32, {s}, source.displacement_expression.data()},
        {"triangles",
         DType::u32,
         {static_cast<std::uint64_t>(source.triangles.rows()), 3},
         source.triangles.data()}};
    if (!source.stable_vertices.empty()) {
        const std::uint64_t count = source.stable_vertices.size();
        tensors.insert(
            tensors.begin(),
            {"stable_reference", DType::f64, {count, 3}, source.stable_reference.data()});
        tensors.push_back({"stable_vertices", DType::u32, {count}, source.stable_vertices.data()});
    }
    write_safetensors(path, tensors,
                      {{"kind", kKind},
                       {"units", "millimetres"},
                       {"expression_names", json_string_list(source.expression_names)}},
                      context);
    ShardReport report;
    report.subjects = source.num_neutrals();
    report.faces = source.num_neutrals() + source.num_displacements();
    report.rank = span.basis.cols();
    report.cut = (span.neutral_energy_cut + span.displacement_energy_cut) /
                 (span.neutral_energy + span.displacement_energy);
    return report;
}

std::unique_ptr<ColumnSource> shard_columns(const std::vector<std::string>& paths,
                                            const SafetensorsReadOptions& options,
                                            const Context& context) {
    if (paths.empty()) fail(Status::invalid_argument, "no shard to merge");
    auto columns = std::make_unique<ShardColumns>();
    for (const std::string& path : paths) columns->append(path, options, context);
    return columns;
}

std::vector<int> subjects_of_part(const FaceDataset& dataset, int part, int count) {
    if (count < 1 || part < 0 || part >= count)
        fail(Status::invalid_argument, "part %d of %d: parts count from 0", part, count);
    std::set<int> subjects;
    for (Index face = 0; face < dataset.num_faces(); ++face) subjects.insert(dataset.subject(face));
    std::vector<int> kept;
    int place = 0;
    for (int subject : subjects)
        if (place++ % count == part) kept.push_back(subject);
    if (kept.empty())
        fail(Status::invalid_argument, "part %d of %d is empty: the data set has %zu subjects",
             part, count, subjects.size());
    return kept;
}

}  // namespace mien
