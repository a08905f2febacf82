// mien spectral basis|split|merge|edit|mix|features|hierarchy, mien metric, mien
// transfer-expression.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>

#include "band_choice.hpp"
#include "commands.hpp"
#include "fields.hpp"
#include "spectral_commands.hpp"
#include "topology.hpp"

namespace mien::cli {
namespace {

const std::map<std::string, std::int32_t> kMassNames = {{"voronoi", MIEN_MASS_MIXED_VORONOI},
                                                        {"barycentric", MIEN_MASS_BARYCENTRIC},
                                                        {"none", MIEN_MASS_NONE}};
const std::map<std::string, std::int32_t> kCotangentNames = {
    {"delaunay", MIEN_COTANGENTS_INTRINSIC_DELAUNAY},
    {"clamp", MIEN_COTANGENTS_CLAMP},
    {"keep", MIEN_COTANGENTS_KEEP}};
const std::map<std::string, std::int32_t> kMetricNames = {{"l1", MIEN_METRIC_L1},
                                                          {"l2", MIEN_METRIC_L2},
                                                          {"hausdorff", MIEN_METRIC_HAUSDORFF},
                                                          {"dame", MIEN_METRIC_DAME},
                                                          {"fmpd", MIEN_METRIC_FMPD}};
const std::map<std::string, std::int32_t> kFeatureNames = {
    {"euclidean", MIEN_FEATURES_EUCLIDEAN},
    {"euclidean-std", MIEN_FEATURES_EUCLIDEAN_STANDARDISED},
    {"euclidean-norm", MIEN_FEATURES_EUCLIDEAN_NORMALISED},
    {"dr", MIEN_FEATURES_DEFORMATION},
    {"dr-norm", MIEN_FEATURES_DEFORMATION_NORMALISED},
    {"dr-std", MIEN_FEATURES_DEFORMATION_STANDARDISED}};

/// Everything that a command of this file may be given.
struct Arguments {
    Common common;
    std::string mean, basis, in, other, third, out, second_out, data, expression, validate, picture,
        model, field;
    std::uint32_t modes = 500, levels = 4, stride = 2, radius = 2;
    std::uint64_t k = 500;
    double factor = 4.0, ridge = 0.0;
    std::string mass = "voronoi", cotangents = "delaunay", kind = "dr-norm", sampling = "quadric";
    std::vector<std::string> sources, networks;
    std::vector<std::uint64_t> limits, candidates;
    std::vector<double> values;
    bool face_tracking = false;
};
using Shared = std::shared_ptr<Arguments>;

CLI::App* command(CLI::App& parent, const char* name, const char* text, const char* example,
                  const Shared& a, const std::function<void()>& run) {
    CLI::App* sub = parent.add_subcommand(name, text);
    sub->footer(std::string("Example:\n  ") + example);
    add_common_options(*sub, a->common);
    sub->callback(run);
    return sub;
}

std::vector<std::string> keys(const std::map<std::string, std::int32_t>& names) {
    std::vector<std::string> result;
    result.reserve(names.size());
    for (const auto& entry : names) result.push_back(entry.first);
    return result;
}

void add_basis(CLI::App& group) {
    auto a = std::make_shared<Arguments>();
    auto* sub =
        command(group, "basis", "Computes the spectral basis of a mean shape",
                "mien spectral basis --mean mean.ply --modes 500 --out basis.safetensors", a, [a] {
                    const Session session(a->common.num_threads);
                    SpectralBasisOptions options;
                    options.mode_count = a->modes;
                    options.mass = kMassNames.at(a->mass);
                    options.cotangents = kCotangentNames.at(a->cotangents);
                    options.progress = progress_bar();
                    const SpectralBasis basis =
                        SpectralBasis::build(session, Mesh(session, a->mean), options);
                    basis.save(session, a->out);
                    write_report(a->common, {{"modes", basis.mode_count()},
                                             {"eigenvalues", basis.eigenvalues()},
                                             {"mass", a->mass},
                                             {"cotangents", a->cotangents}});
                });
    sub->add_option("--mean", a->mean, "Mean shape, a mesh")->required();
    sub->add_option("--modes", a->modes, "Number of modes k")->capture_default_str();
    sub->add_option("--mass", a->mass, "Mass matrix")
        ->check(CLI::IsMember(keys(kMassNames)))
        ->capture_default_str();
    sub->add_option("--cotangents", a->cotangents, "What to do with negative cotangents")
        ->check(CLI::IsMember(keys(kCotangentNames)))
        ->capture_default_str();
    sub->add_option("--out", a->out, "Basis file")->required();
}

void add_bands(CLI::App& group) {
    auto a = std::make_shared<Arguments>();
    auto* sub =
        command(group, "split", "Splits a face into low and high frequencies",
                "mien spectral split --basis basis.safetensors --in face.ply --k 500 --low low.ply "
                "--high high.ply",
                a, [a] {
                    const Session session(a->common.num_threads);
                    const SpectralBasis basis = SpectralBasis::load(session, a->basis);
                    const Mesh face(session, a->in);
                    if (!a->out.empty()) basis.low(session, face, a->k).save(session, a->out);
                    if (!a->second_out.empty())
                        basis.high(session, face, a->k).save(session, a->second_out);
                });
    sub->add_option("--basis", a->basis, "Basis file")->required();
    sub->add_option("--in", a->in, "Face in the basis' topology")->required();
    sub->add_option("--k", a->k, "Modes of the low band")->capture_default_str();
    sub->add_option("--low", a->out, "Mesh of the mean with the low frequencies");
    sub->add_option("--high", a->second_out, "Mesh of the mean with the high frequencies");

    auto b = std::make_shared<Arguments>();
    sub = command(
        group, "merge", "Joins the low frequencies of one face with the high ones of another",
        "mien spectral merge --basis basis.safetensors --low low.ply --high high.ply --k 500 "
        "--out face.ply",
        b, [b] {
            const Session session(b->common.num_threads);
            SpectralBasis::load(session, b->basis)
                .assemble(session, Mesh(session, b->in), Mesh(session, b->other), b->k)
                .save(session, b->out);
        });
    sub->add_option("--basis", b->basis, "Basis file")->required();
    sub->add_option("--low", b->in, "Face that gives the low frequencies")->required();
    sub->add_option("--high", b->other, "Face that gives the high frequencies")->required();
    sub->add_option("--k", b->k, "Modes of the low band")->capture_default_str();
    sub->add_option("--out", b->out, "Mesh to write")->required();

    auto c = std::make_shared<Arguments>();
    sub = command(group, "edit",
                  "Multiplies each band of a face by a gain: 0 smooths, more than 1 exaggerates",
                  "mien spectral edit --basis basis.safetensors --in face.ply --limits 100 500 "
                  "--gains 1 1.5 0 --out edited.ply",
                  c, [c] {
                      const Session session(c->common.num_threads);
                      SpectralBasis::load(session, c->basis)
                          .edit(session, Mesh(session, c->in), c->limits, c->values)
                          .save(session, c->out);
                  });
    sub->add_option("--basis", c->basis, "Basis file")->required();
    sub->add_option("--in", c->in, "Face")->required();
    sub->add_option("--limits", c->limits, "Ascending mode numbers between the bands")
        ->required()
        ->delimiter(',');
    sub->add_option("--gains", c->values,
                    "One gain a band; the last band is all beyond the last limit")
        ->required()
        ->delimiter(',');
    sub->add_option("--out", c->out, "Mesh to write")->required();
}

/// Also by a network of two bands: codes are moved instead of displacements.
void mix_by_network(const Arguments& d, const Session& session) {
    if (d.values.size() != 2)
        throw CLI::ValidationError("--weights", "with --network: of the low and the high band");
    Network::load(session, d.model)
        .mix(session, Mesh(session, d.in), Mesh(session, d.other), d.values[0], d.values[1])
        .save(session, d.out);
}

void add_band_mix(CLI::App& group) {
    auto d = std::make_shared<Arguments>();
    auto* sub = command(
        group, "mix", "Moves each band of a face towards another's by its own weight",
        "mien spectral mix --basis basis.safetensors --in a.ply --with b.ply --limits 100 "
        "--weights 0 1 --out mixed.ply",
        d, [d] {
            const Session session(d->common.num_threads);
            if (!d->model.empty()) return mix_by_network(*d, session);
            if (d->basis.empty()) throw CLI::RequiredError("--basis");
            if (d->limits.empty()) throw CLI::RequiredError("--limits");
            SpectralBasis::load(session, d->basis)
                .mix(session, Mesh(session, d->in), Mesh(session, d->other), d->limits, d->values)
                .save(session, d->out);
        });
    auto* basis = sub->add_option("--basis", d->basis, "Basis file");
    auto* trained = sub->add_option("--network", d->model,
                                    "network file with two bands instead: codes are moved")
                        ->excludes(basis);
    sub->add_option("--in", d->in, "First face, weight 0")->required();
    sub->add_option("--with", d->other, "Second face, weight 1")->required();
    sub->add_option("--limits", d->limits, "Ascending mode numbers between the bands")
        ->excludes(trained)
        ->delimiter(',');
    sub->add_option("--weights", d->values, "One weight a band")->required()->delimiter(',');
    sub->add_option("--out", d->out, "Mesh to write")->required();
}

void add_learning(CLI::App& group) {
    auto a = std::make_shared<Arguments>();
    auto* sub = command(
        group, "features", "Learns a representation of faces: mean, scale and statistics",
        "mien spectral features --data faces.safetensors --kind dr-norm --out features.safetensors",
        a, [a] {
            const Session session(a->common.num_threads);
            const auto learned = Representation::train(session, a->data, kFeatureNames.at(a->kind));
            learned.save(session, a->out);
            write_report(a->common, {{"kind", a->kind}, {"channels", learned.channel_count()}});
        });
    sub->add_option("--data", a->data, "Dataset")->required();
    sub->add_option("--kind", a->kind, "Representation")
        ->check(CLI::IsMember(keys(kFeatureNames)))
        ->capture_default_str();
    sub->add_option("--out", a->out, "Representation file")->required();

    auto b = std::make_shared<Arguments>();
    auto application = std::make_shared<HierarchyApplication>();
    sub = command(
        group, "hierarchy",
        "Builds coarser levels of a template with maps between them, or applies the maps",
        "mien spectral hierarchy --template T.ply --levels 4 --factor 4 --out levels.safetensors\n"
        "  mien spectral hierarchy --apply levels.safetensors --level 2 --direction down --in "
        "face.ply --out coarse.ply",
        b, [b, application] {
            if (!application->file.empty()) {
                if (application->in.empty() == application->field.empty())
                    throw CLI::ValidationError("--apply", "give either --in or --field");
                application->out = b->out;
                application->num_threads = b->common.num_threads;
                apply_hierarchy(*application);
                return;
            }
            if (b->in.empty()) throw CLI::RequiredError("--template");
            const Session session(b->common.num_threads);
            const Mesh mesh(session, b->in);
            const Hierarchy levels =
                b->sampling == "quadric"
                    ? Hierarchy::quadric(session, mesh, b->levels, b->factor)
                    : Hierarchy::connectivity(session, mesh, b->levels, b->stride, b->radius);
            levels.save(session, b->out);
            nlohmann::json counts = nlohmann::json::array();
            for (std::uint32_t l = 0; l < levels.level_count(); ++l)
                counts.push_back(levels.level(l).vertex_count());
            write_report(b->common, {{"sampling", b->sampling}, {"vertices", counts}});
        });
    auto* finest = sub->add_option("--template", b->in, "Finest mesh");
    auto* apply = sub->add_option("--apply", application->file,
                                  "Hierarchy file whose maps are applied, instead of building one")
                      ->excludes(finest);
    sub->add_option("--level", application->level, "with --apply: the coarser end of the maps")
        ->capture_default_str();
    sub->add_option("--direction", application->direction,
                    "with --apply: down from the finest level, or up to it")
        ->check(CLI::IsMember(std::vector<std::string>{"down", "up"}))
        ->capture_default_str();
    sub->add_option("--in", application->in, "with --apply: mesh whose vertices are mapped")
        ->needs(apply);
    sub->add_option("--field", application->field,
                    "with --apply: one number per vertex, mapped instead")
        ->needs(apply);
    sub->add_option("--sampling", b->sampling, "How levels are made")
        ->check(CLI::IsMember(std::vector<std::string>{"quadric", "connectivity"}))
        ->capture_default_str();
    sub->add_option("--levels", b->levels, "Levels below the template")->capture_default_str();
    sub->add_option("--factor", b->factor, "quadric: vertices are divided by this a level")
        ->capture_default_str();
    sub->add_option("--stride", b->stride, "connectivity: least distance of kept vertices in edges")
        ->capture_default_str();
    sub->add_option("--radius", b->radius, "connectivity: edges over which the maps reach")
        ->capture_default_str();
    sub->add_option("--out", b->out,
                    "Hierarchy file; with --apply: the mesh, or a JSON list of numbers")
        ->required();
}

/// Where a metric comes from, as numbers and as a picture.
void show_field(const Arguments& a, const Mesh& mesh, const std::vector<double>& field,
                bool is_signed, const std::string& name) {
    if (!a.field.empty()) write_json(a.field, field);
    const bool angle = name == "dame" || name == "roughness";
    FieldPicture picture;
    picture.label =
        name == "fmpd" ? "rougher (+), smoother (-)" : name + (angle ? ", rad" : ", mm");
    picture.is_signed = is_signed;
    if (!is_signed) picture.low = 0;
    draw_field(a.picture, mesh, field, picture);
}

void add_field_options(CLI::App& command, const Shared& a) {
    command.add_option("--field", a->field, "JSON list of one number per vertex of the reference");
    command.add_option("--picture", a->picture, "PNG of where it comes from");
}

void add_metric(CLI::App& app) {
    CLI::App* group =
        app.add_subcommand("metric", "Distances between two faces, geometric and perceptual");
    group->require_subcommand(1);
    const std::map<std::string, const char*> texts = {
        {"l1", "Mean of |dx| + |dy| + |dz| over the vertices, mm"},
        {"l2", "Mean Euclidean distance over the vertices, mm"},
        {"hausdorff", "Largest distance between the surfaces, mm"},
        {"dame", "Dihedral Angle Mesh Error, rad: change of creases, same triangles"},
        {"fmpd", "Fast Mesh Perceptual Distance, 0 to 1: difference of roughness, any triangles"}};
    for (const auto& entry : kMetricNames) {
        auto a = std::make_shared<Arguments>();
        const std::string name = entry.first;
        const std::int32_t kind = entry.second;
        const std::string example = "mien metric " + name + " reference.ply other.ply";
        auto* sub =
            command(*group, name.c_str(), texts.at(name), example.c_str(), a, [a, name, kind] {
                const Session session(a->common.num_threads);
                const Mesh reference(session, a->in), other(session, a->other);
                const double value = metric(session, kind, reference, other);
                std::printf("%.9g\n", value);
                if (!a->field.empty() || !a->picture.empty())
                    show_field(*a, reference, metric_field(session, kind, reference, other),
                               kind == MIEN_METRIC_FMPD, name);
                write_report(a->common, {{"metric", name}, {"value", value}});
            });
        sub->add_option("reference", a->in, "Reference mesh")->required();
        sub->add_option("other", a->other, "Other mesh")->required();
        add_field_options(*sub, a);
    }
    auto a = std::make_shared<Arguments>();
    auto* sub = command(*group, "roughness", "Local roughness of one mesh, rad: what fmpd is of",
                        "mien metric roughness face.ply --picture roughness.png", a, [a] {
                            const Session session(a->common.num_threads);
                            const Mesh mesh(session, a->in);
                            const std::vector<double> field = roughness(session, mesh);
                            const FieldSummary summary = summary_of(field);
                            std::printf("mean %.9g, largest %.9g\n", summary.mean, summary.most);
                            show_field(*a, mesh, field, false, "roughness");
                            write_report(a->common, {{"roughness_rad", summary_json(summary)}});
                        });
    sub->add_option("mesh", a->in, "Mesh")->required();
    add_field_options(*sub, a);
}

std::string stem_of(const std::string& path) {
    return std::filesystem::u8path(path).stem().u8string();
}

/// One face as it is, or any number as the named morph targets of their neutral face in a GLB file.
void save_expressions(const Session& session, const Mesh& neutral, const std::vector<Mesh>& faces,
                      const std::vector<std::string>& names, const std::string& out) {
    std::string extension = std::filesystem::u8path(out).extension().u8string();
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (extension != ".glb") {
        if (faces.size() != 1)
            throw CLI::ValidationError("--out", "several expressions go into one .glb file");
        faces.front().save(session, out);
        return;
    }
    std::vector<const mien_mesh*> targets;
    std::vector<const char*> texts;
    targets.reserve(faces.size());
    for (const Mesh& face : faces) targets.push_back(face.get());
    texts.reserve(names.size());
    for (const std::string& name : names) texts.push_back(name.c_str());
    detail::call(mien_mesh_save_targets, session.get(), neutral.get(), targets.data(), texts.data(),
                 std::uint64_t{targets.size()}, out.c_str());
}

/// The expression that a network was trained on, as mien-train wrote it down, or its name.
std::string expression_of(const Network& network) {
    const nlohmann::json report = nlohmann::json::parse(network.json());
    if (report["task"] != "displacement")
        throw CLI::ValidationError("--network",
                                   "'" + report["name"].get<std::string>() +
                                       "' gives faces back; one that adds an expression is needed");
    const auto* training = report.contains("training") ? &report["training"] : nullptr;
    if (training != nullptr && training->is_object() && training->contains("data") &&
        (*training)["data"].is_object() && (*training)["data"].contains("expression") &&
        (*training)["data"]["expression"].is_string())
        return (*training)["data"]["expression"];
    return report["name"];
}

/// One network an expression, onto one neutral face.
void transfer_by_networks(const Arguments& a, const Session& session, bool own_limit) {
    if (a.third.empty()) throw CLI::RequiredError("--target");
    const Mesh target(session, a.third);
    std::vector<Mesh> faces;
    std::vector<std::string> names;
    for (const std::string& path : a.networks) {
        const Network network = Network::load(session, path);
        names.push_back(expression_of(network));
        // --k 0 are deformations alone, which the options say by a negative number.
        const std::int64_t limit = own_limit ? 0 : a.k == 0 ? -1 : static_cast<std::int64_t>(a.k);
        faces.push_back(network.apply(session, target, nullptr, limit));
    }
    save_expressions(session, target, faces, names, a.out);
    write_report(a.common, {{"expressions", names}, {"out", a.out}});
}

void run_transfer(const Arguments& a) {
    const Session session(a.common.num_threads);
    if (!a.in.empty()) {
        const std::vector<std::string> sources =
            a.face_tracking ? in_tracking_order(a.sources) : a.sources;
        const Mesh source(session, a.in), target(session, a.third);
        std::vector<Mesh> faces;
        std::vector<std::string> names;
        for (const std::string& expression : sources) {
            faces.push_back(
                transfer_expression(session, source, Mesh(session, expression), target));
            names.push_back(stem_of(expression));
        }
        save_expressions(session, target, faces, names, a.out);
        return;
    }
    if (a.data.empty() && a.model.empty())
        throw CLI::ValidationError(
            "transfer-expression",
            "give --source-neutral and --source-expression, or --data, or --model");
    BlendshapeOptions options;
    options.ridge = a.ridge;
    options.progress = progress_bar();
    const BlendshapeModel model =
        a.model.empty() ? BlendshapeModel::train(session, a.data, a.expression, options)
                        : BlendshapeModel::load(session, a.model);
    if (!a.second_out.empty()) model.save(session, a.second_out);
    std::uint64_t k = a.k;
    nlohmann::json report = {{"expression", a.expression}, {"k", k}};
    std::unique_ptr<SpectralBasis> basis;
    if (!a.basis.empty())
        basis = std::make_unique<SpectralBasis>(SpectralBasis::load(session, a.basis));
    if (!a.validate.empty()) {
        if (!basis) throw CLI::ValidationError("--validate", "a search over k needs --basis");
        const BandSearch search = search_bands(session, model, *basis, a.data, a.validate,
                                               a.expression, a.candidates, options);
        for (const mien_band_choice& choice : search.choices)
            if (choice.chosen != 0) k = choice.k;
        print_bands(search);
        report.update(bands_json(search));
        report["k"] = k;
        if (!a.picture.empty()) draw_bands(a.picture, search, a.expression);
        if (k > basis->mode_count()) k = std::uint64_t{0x7fffffff};  // coordinates alone
    }
    if (!a.third.empty() && !a.out.empty()) {
        const Mesh target(session, a.third);
        save_expressions(session, target, {model.predict(session, target, basis.get(), k)},
                         {a.expression}, a.out);
    }
    write_report(a.common, report);
}

void add_transfer(CLI::App& app) {
    auto a = std::make_shared<Arguments>();
    a->candidates = {0, 10, 20, 50, 100, 200, 300, 500, 1000000000};
    auto* sub = command(
        app, "transfer-expression",
        "Carries an expression onto a neutral face: from one source face (deformation "
        "transfer), or learned from a dataset (blendshape regression in two bands)",
        "mien transfer-expression --source-neutral a.ply --source-expression a_smile.ply "
        "--target b.ply --out b_smile.ply\n  mien transfer-expression --data faces.safetensors "
        "--expression smile --basis basis.safetensors --k 300 --target b.ply --out b_smile.ply\n  "
        "mien transfer-expression --network grin.safetensors pucker.safetensors --target b.ply "
        "--out b.glb",
        a, [] {});
    auto* networks = sub->add_option("--network", a->networks,
                                     "network files of mien-train, one an expression, instead of "
                                     "--data; several go into one GLB file");
    auto* neutral = sub->add_option("--source-neutral", a->in, "Neutral face of the source");
    auto* source =
        sub->add_option("--source-expression", a->sources,
                        "The source with the expression; several give one GLB file with a morph "
                        "target each, named as their files");
    neutral->needs(source);
    source->needs(neutral);
    sub->add_flag("--face-tracking", a->face_tracking,
                  "The files must be called as the 52 shapes that face trackers drive "
                  "(jawOpen.ply, ...); the targets stand in their order")
        ->needs(source);
    networks->excludes(neutral);
    sub->add_option("--data", a->data, "Dataset to learn from")
        ->excludes(neutral)
        ->excludes(networks);
    sub->add_option("--model", a->model, "Blendshape model file instead of --data")
        ->excludes(neutral)
        ->excludes(networks);
    sub->add_option("--expression", a->expression, "Name of the expression in the dataset");
    sub->add_option("--ridge", a->ridge,
                    "Ridge of the regression; 0 chooses by leave-one-out error")
        ->capture_default_str();
    sub->add_option("--basis", a->basis,
                    "Basis file; without it one band: k = 0 deformations, else coordinates");
    auto* k = sub->add_option("--k", a->k,
                              "Modes of the low band; with --network default: each file's own")
                  ->capture_default_str();
    sub->callback([a, k] {
        if (a->networks.empty()) return run_transfer(*a);
        transfer_by_networks(*a, Session(a->common.num_threads), k->empty());
    });
    sub->add_option("--validate", a->validate, "Dataset of other subjects on which k is chosen");
    sub->add_option("--candidates", a->candidates, "Values of k to try, blanks or commas between")
        ->capture_default_str()
        ->delimiter(',');
    sub->add_option(
        "--plot", a->picture,
        "PNG of L1 against FMPD and DAME with the Pareto fronts and the mean displacement");
    sub->add_option("--model-out", a->second_out, "Blendshape model file to write");
    sub->add_option("--target", a->third, "Neutral face of the target")
        ->needs(sub->add_option("--out", a->out,
                                "Mesh to write; .glb: the neutral face with the expression as a "
                                "named morph target"));
}

}  // namespace

void add_spectral_commands(CLI::App& app) {
    CLI::App* group =
        app.add_subcommand("spectral", "Frequency bands, representations and levels of faces");
    group->require_subcommand(1);
    add_basis(*group);
    add_bands(*group);
    add_band_mix(*group);
    add_learning(*group);
    add_coding_commands(*group);
    add_metric(app);
    add_transfer(app);
}

}  // namespace mien::cli
