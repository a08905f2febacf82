// mien spectral encode|decode|coefficients|synthesize|mode, mien spectral hierarchy --apply: faces
// as numbers in safetensors files, and back.
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "fields.hpp"
#include "spectral_commands.hpp"
#include "tensor_file.hpp"

namespace mien::cli {
namespace {

struct Coding {
    Common common;
    std::string file, in, out, field, picture;
    std::uint64_t modes = 500, mode = 0, first = 0;
};
using SharedCoding = std::shared_ptr<Coding>;

CLI::App& add_coding_command(CLI::App& group, const char* name, const char* text,
                             const char* example, const SharedCoding& o,
                             void (*run)(const Coding&)) {
    CLI::App& command = *group.add_subcommand(name, text);
    add_common_options(command, o->common);
    command.footer(std::string("Example:\n  ") + example);
    command.callback([o, run] { run(*o); });
    return command;
}

std::vector<double> flat(const std::vector<Position>& rows) {
    std::vector<double> values;
    for (const Position& row : rows) values.insert(values.end(), row.begin(), row.end());
    return values;
}

void run_encode(const Coding& o) {
    const Session session(o.common.num_threads);
    const Representation learned = Representation::load(session, o.file);
    Representation::Motion motion{};
    Tensor features, moved;
    features.values = learned.encode(session, Mesh(session, o.in), &motion);
    const std::uint64_t channels = learned.channel_count();
    features.shape = {features.values.size() / channels, channels};
    moved.shape = {12};
    moved.values.assign(motion.begin(), motion.end());
    write_tensors(o.out, {{"features", features}, {"motion", moved}},
                  {{"kind", "mien-face-features"}, {"face", o.in}});
    std::printf("%llu vertices of %llu features\n",
                static_cast<unsigned long long>(features.shape[0]),
                static_cast<unsigned long long>(channels));
    write_report(o.common, {{"vertices", features.shape[0]}, {"channels", channels}});
}

void run_decode(const Coding& o) {
    const Session session(o.common.num_threads);
    const Representation learned = Representation::load(session, o.file);
    const auto tensors = read_tensors(o.in);
    const Tensor features = take_matrix(tensors, o.in, "features", learned.channel_count());
    Representation::Motion motion{};
    const auto moved = tensors.find("motion");
    if (moved != tensors.end()) {
        if (moved->second.values.size() != motion.size())
            throw std::runtime_error(o.in + ": tensor 'motion' has " +
                                     std::to_string(moved->second.values.size()) +
                                     " values, 12 are needed");
        std::copy(moved->second.values.begin(), moved->second.values.end(), motion.begin());
    }
    learned.decode(session, features.values, moved != tensors.end() ? &motion : nullptr)
        .save(session, o.out);
    write_report(o.common, {{"out", o.out}, {"moved_back", moved != tensors.end()}});
}

void run_coefficients(const Coding& o) {
    const Session session(o.common.num_threads);
    const SpectralBasis basis = SpectralBasis::load(session, o.file);
    const auto rows = basis.project(session, Mesh(session, o.in), o.modes);
    write_tensors(o.out, {{"coefficients", {{rows.size(), 3}, flat(rows)}}},
                  {{"kind", "mien-spectral-coefficients"}, {"face", o.in}});
    double square = 0;
    for (const Position& row : rows)
        for (const double value : row) square += value * value;
    std::printf("%zu modes, norm %.6g mm^2\n", rows.size(), std::sqrt(square));
    write_report(o.common, {{"modes", rows.size()}, {"norm", std::sqrt(square)}});
}

void run_synthesize(const Coding& o) {
    const Session session(o.common.num_threads);
    const Tensor rows = take_matrix(read_tensors(o.in), o.in, "coefficients", 3);
    std::vector<Position> coefficients(static_cast<std::size_t>(rows.shape[0]));
    for (std::size_t j = 0; j < coefficients.size(); ++j)
        for (std::size_t c = 0; c < 3; ++c) coefficients[j][c] = rows.values[3 * j + c];
    SpectralBasis::load(session, o.file)
        .synthesize(session, coefficients, o.first)
        .save(session, o.out);
    write_report(o.common, {{"modes", coefficients.size()}, {"out", o.out}});
}

void run_mode(const Coding& o) {
    const Session session(o.common.num_threads);
    const SpectralBasis basis = SpectralBasis::load(session, o.file);
    const std::vector<double> vector = basis.vector(o.mode);
    const double value = basis.eigenvalues()[static_cast<std::size_t>(o.mode)];
    const double wavelength = value > 0 ? 2 * 3.14159265358979 / std::sqrt(value) : HUGE_VAL;
    std::printf("mode %llu: eigenvalue %.6g", static_cast<unsigned long long>(o.mode), value);
    std::printf(std::isfinite(wavelength) ? ", wavelength %.4g mm\n" : ", constant\n", wavelength);
    if (!o.field.empty()) write_json(o.field, vector);
    draw_field(o.picture, basis.mean(), vector,
               {"eigenvector",
                "mode " + std::to_string(o.mode),
                true,
                std::numeric_limits<double>::quiet_NaN(),
                {}});
    write_report(o.common, {{"mode", o.mode}, {"eigenvalue", value}});
}

}  // namespace

void apply_hierarchy(const HierarchyApplication& o) {
    const Session session(o.num_threads);
    const Hierarchy levels = Hierarchy::load(session, o.file);
    if (o.level < 1 || o.level >= levels.level_count())
        throw CLI::ValidationError("--level", "the hierarchy has levels 1 to " +
                                                  std::to_string(levels.level_count() - 1) +
                                                  " below the finest");
    const bool down = o.direction == "down";
    const std::size_t from = levels.level(down ? 0 : o.level).vertex_count();
    std::vector<double> values;
    std::uint64_t channels = 1;
    if (o.field.empty()) {
        values = flat(Mesh(session, o.in).positions());
        channels = 3;
    } else {
        values = read_field(o.field);
    }
    if (values.size() != from * channels)
        throw std::runtime_error((o.field.empty() ? o.in : o.field) + ": has " +
                                 std::to_string(values.size() / channels) + " vertices, the map " +
                                 "begins at " + std::to_string(from));
    // A map joins two neighbouring levels: one after the other.
    for (std::uint32_t k = 1; k <= o.level; ++k)
        values = levels.apply(down ? k : o.level + 1 - k, down ? MIEN_MAP_DOWN : MIEN_MAP_UP,
                              values, channels);
    if (!o.field.empty()) {
        write_json(o.out, values);
        std::printf("%zu values\n", values.size());
        return;
    }
    std::vector<Position> positions(values.size() / 3);
    for (std::size_t v = 0; v < positions.size(); ++v)
        for (std::size_t c = 0; c < 3; ++c) positions[v][c] = values[3 * v + c];
    Mesh(session, positions, levels.level(down ? o.level : 0).triangles()).save(session, o.out);
    std::printf("%zu vertices\n", positions.size());
}

void add_coding_commands(CLI::App& group) {
    auto o = std::make_shared<Coding>();
    CLI::App* command = &add_coding_command(
        group, "encode", "A face as features of a representation, safetensors",
        "mien spectral encode --features features.safetensors --in face.ply --out "
        "code.safetensors",
        o, &run_encode);
    command->add_option("--features", o->file, "Representation file")->required();
    command->add_option("--in", o->in, "Face in the representation's topology")->required();
    command->add_option("--out", o->out, "Features [vertices, channels] and motion [12], f64")
        ->required();

    o = std::make_shared<Coding>();
    command = &add_coding_command(
        group, "decode", "The face that has these features",
        "mien spectral decode --features features.safetensors --in code.safetensors "
        "--out face.ply",
        o, &run_decode);
    command->add_option("--features", o->file, "Representation file")->required();
    command
        ->add_option("--in", o->in,
                     "Tensor features [vertices, channels]; motion [12] brings the face back to "
                     "where it was")
        ->required();
    command->add_option("--out", o->out, "Mesh to write")->required();

    o = std::make_shared<Coding>();
    command = &add_coding_command(
        group, "coefficients", "Spectral coefficients of a face, safetensors",
        "mien spectral coefficients --basis basis.safetensors --in face.ply --modes 300 "
        "--out c.safetensors",
        o, &run_coefficients);
    command->add_option("--basis", o->file, "Basis file")->required();
    command->add_option("--in", o->in, "Face in the basis' topology")->required();
    command->add_option("--modes", o->modes, "The first of them")->capture_default_str();
    command->add_option("--out", o->out, "Coefficients [modes, 3], f64")->required();

    o = std::make_shared<Coding>();
    command = &add_coding_command(
        group, "synthesize", "The face of spectral coefficients",
        "mien spectral synthesize --basis basis.safetensors --in c.safetensors --out "
        "face.ply",
        o, &run_synthesize);
    command->add_option("--basis", o->file, "Basis file")->required();
    command->add_option("--in", o->in, "Tensor coefficients [modes, 3]")->required();
    command->add_option("--first", o->first, "Mode of the first row")->capture_default_str();
    command->add_option("--out", o->out, "Mesh to write")->required();

    o = std::make_shared<Coding>();
    command = &add_coding_command(
        group, "mode", "An eigenvector of a basis, as numbers and as a picture",
        "mien spectral mode --basis basis.safetensors --mode 12 --picture mode12.png", o,
        &run_mode);
    command->add_option("--basis", o->file, "Basis file")->required();
    command->add_option("--mode", o->mode, "From 0, by rising frequency")->required();
    command->add_option("--field", o->field, "JSON list of one number per vertex");
    command->add_option("--picture", o->picture, "PNG on the mean shape");
}

}  // namespace mien::cli
