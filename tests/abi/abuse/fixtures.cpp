#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "../small_network.hpp"
#include "abuse.hpp"

namespace abuse {
#include "abuse_tables.inc"

namespace {

#if defined(MIEN_IMAGES)
constexpr bool kEncodesImages = true;
#else
constexpr bool kEncodesImages = false;
#endif

template <typename T>
void put(std::vector<std::uint64_t>& bytes, std::size_t offset, const T& value) {
    std::memcpy(reinterpret_cast<char*>(bytes.data()) + offset, &value, sizeof value);
}

std::vector<std::uint64_t> read_file(const std::string& path, std::int64_t& size) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    size = static_cast<std::int64_t>(bytes.size());
    std::vector<std::uint64_t> words(bytes.size() / 8 + 1);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

}  // namespace

const std::vector<FunctionRow>& functions() {
    static const std::vector<FunctionRow> rows(std::begin(kFunctions), std::end(kFunctions));
    return rows;
}

const std::vector<StructRow>& structs() {
    static const std::vector<StructRow> rows(std::begin(kStructs), std::end(kStructs));
    return rows;
}

const FunctionRow* find_function(const std::string& name) {
    for (const FunctionRow& row : functions())
        if (name == row.name) return &row;
    return nullptr;
}

const StructRow* find_struct(const std::string& name) {
    for (const StructRow& row : structs())
        if (name == row.name) return &row;
    return nullptr;
}

Fixtures::Fixtures() {
    positions_ = face(3, 0);
    for (std::uint32_t y = 0; y + 1 < kSide; ++y)
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const std::uint32_t a = y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
            triangles_.insert(triangles_.end(), {a, b, d, a, d, c});
        }
    zone_ = {13, 14, 15, 16, 25, 26, 27, 28, 37, 38, 39, 40};

    mien_session_options options;
    mien_session_options_init(&options, sizeof options);
    options.max_bytes = std::uint64_t{256} << 20;
    mien_session* session = nullptr;
    mien_session_create_with_options(MIEN_ABI_VERSION, &options, &session, nullptr);
    handles_.emplace_back("mien_session", session);

    mien_cancel* cancel = nullptr;
    mien_cancel_create(&cancel, nullptr);
    handles_.emplace_back("mien_cancel", cancel);

    mien_mesh* mesh = nullptr;
    const auto arrays = structure(*find_struct("mien_mesh_arrays"));
    mien_mesh_create(session, reinterpret_cast<const mien_mesh_arrays*>(arrays.data()), &mesh,
                     nullptr);
    handles_.emplace_back("mien_mesh", mesh);

    write_files(session);
    symmetric_ = symmetric_mesh(session);
    std::ofstream("abuse_marks.json")
        << R"({"vertices": {"nose_bridge_3": 77, "nose_base_2": 53, "mouth_outer_09": 41,
               "jaw_08": 5, "eye_right_3": 88, "eye_left_0": 91}})";
    mien_landmarks* marks = nullptr;
    mien_landmarks_load(session, "abuse_marks.json", &marks, nullptr);
    vertex_marks_ = marks;
    // Whatever else can be made from what exists, by its own create function with good arguments.
    for (int round = 0; round < 4; ++round)
        for (const FunctionRow& row : functions()) {
            std::vector<Argument> arguments;
            for (std::size_t i = 0; i < row.parameters.size(); ++i) {
                const ParameterRow& parameter = row.parameters[i];
                if (parameter.kind != Kind::handle_out || handle(parameter.type) != nullptr)
                    continue;
                void* made = nullptr;
                if (std::string(row.name).find("_load") != std::string::npos)
                    break;  // nothing is saved yet
                if (!good_arguments(row, arguments)) break;
                arguments[i].pointer = &made;
                if (row.call(arguments.data()) == MIEN_OK && made != nullptr)
                    handles_.emplace_back(parameter.type, made);
                break;
            }
        }
    mien_network* network = nullptr;  // no function of the interface makes one
    mien_network_load(session, "abuse_network.safetensors", &network, nullptr);
    handles_.emplace_back("mien_network", network);
    mien_expression_model_get_counts(
        static_cast<mien_expression_model*>(handle("mien_expression_model")), nullptr,
        &identity_modes_, &expression_modes_, nullptr);
    mien_measurement* distances = nullptr;  // the other kind of measurement
    mien_measure_distance(session, mesh, mesh, nullptr, &distances, nullptr);
    distances_ = distances;
    handles_.emplace_back("mien_measurement", distances);
    mien_measurement* sides = nullptr;  // and the third
    mien_measure_asymmetry(session, symmetric_, symmetric_, nullptr, &sides, nullptr);
    sides_ = sides;
    handles_.emplace_back("mien_measurement", sides);
    const FunctionRow& add = *find_function("mien_dataset_writer_add");
    std::vector<Argument> face_of_writer;
    if (good_arguments(add, face_of_writer)) add.call(face_of_writer.data());
    for (const char* name : {"mien_batch_add", "mien_batch_run"}) {  // a batch with a fit
        const FunctionRow& row = *find_function(name);
        std::vector<Argument> arguments;
        if (good_arguments(row, arguments)) row.call(arguments.data());
    }
    // What the loading functions read.
    for (const FunctionRow& row : functions()) {
        std::vector<Argument> arguments;
        if (std::string(row.name).find("_save") != std::string::npos &&
            good_arguments(row, arguments))
            row.call(arguments.data());
    }
}

std::vector<double> Fixtures::face(int subject, int expression) const {
    std::vector<double> positions;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double lift =
                expression == 0 ? 0 : (5 + 0.5 * std::sin(3.1 * subject)) * std::exp(-0.3 * y);
            double z = 8.0 * std::sin(0.5 * x) * std::cos(0.4 * y) + 0.1 * x * y;
            for (int k = 1; k < 5; ++k)
                z += std::sin(7.3 * subject + k) * std::sin(0.25 * k * x + 0.1 * k * y);
            positions.insert(positions.end(), {10.0 * x, 10.0 * y + lift, z});
        }
    return positions;
}

/// The same sheet with x = 0 in its middle, where two columns of vertices lie.
mien_mesh* Fixtures::symmetric_mesh(mien_session* session) const {
    std::vector<double> positions;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            positions.insert(positions.end(), {10.0 * (x < kSide / 2 ? x - 5 : x - 6), 10.0 * y,
                                               5.0 * std::cos(0.9 * y) + (x == 6 ? 3.0 : 0.0)});
    mien_mesh_arrays arrays{};
    arrays.struct_size = sizeof arrays;
    arrays.positions = {positions.data(), kVertices, 0, MIEN_DTYPE_F64, 0};
    arrays.triangles = triangles_.data();
    arrays.triangle_count = triangles_.size() / 3;
    mien_mesh* mesh = nullptr;
    mien_mesh_create(session, &arrays, &mesh, nullptr);
    return mesh;
}

/// A dataset of twelve subjects with two expressions, its two shards, and a network.
void Fixtures::write_files(mien_session* session) const {
    const char* const names[] = {"neutral", "grin"};
    mien_dataset_writer* writer = nullptr;
    mien_dataset_writer_create(session, static_cast<mien_mesh*>(handle("mien_mesh")), names, 2,
                               &writer, nullptr);
    for (int k = 0; k < kFaces; ++k) {
        const std::vector<double> positions = face(k / 2, k % 2);
        const mien_array_view view{positions.data(), kVertices, 0, MIEN_DTYPE_F64, 0};
        mien_dataset_writer_add(writer, &view, k / 2, k % 2, nullptr);
    }
    mien_dataset_writer_save(session, writer, kDataset, nullptr);
    mien_dataset_writer_release(writer);
    const mien_test::SmallNetwork network(face(3, 0), triangles_, kCode);
    std::ofstream("abuse_network.safetensors", std::ios::binary) << network.bytes();
    mien_shard_options options;
    mien_shard_options_init(&options, sizeof options);
    options.part_count = 2;
    for (options.part = 0; options.part < 2; ++options.part)
        mien_expression_shard_create(
            session, kDataset, &options,
            options.part == 0 ? "abuse_shard0.safetensors" : "abuse_shard1.safetensors", nullptr);
}

Fixtures::~Fixtures() {
    mien_landmarks_release(static_cast<mien_landmarks*>(vertex_marks_));
    mien_mesh_release(symmetric_);
    for (auto row = handles_.rbegin(); row != handles_.rend(); ++row) {
        Argument argument;
        argument.pointer = row->second;
        find_function(row->first + "_release")->call(&argument);
    }
}

void* Fixtures::handle(const std::string& type) const {
    for (const auto& row : handles_)
        if (row.first == type) return row.second;
    return nullptr;
}

void* Fixtures::other_handle(const std::string& type) const {
    return handle(type == "mien_mesh" ? "mien_session" : "mien_mesh");
}

std::vector<std::uint64_t> Fixtures::structure(const StructRow& row, std::size_t extra,
                                               const std::string& role) const {
    std::vector<std::uint64_t> bytes((row.size + extra + 7) / 8, 0);
    if (row.init != nullptr)
        row.init(bytes.data(), row.size + extra);
    else if (row.tells_its_size)
        put(bytes, 0, static_cast<std::uint32_t>(row.size + extra));
    mien_array_view points{positions_.data(), kVertices, 0, MIEN_DTYPE_F64, 0};
    static const std::vector<double> ones(2 * kVertices, 1.0);
    const bool of_two_faces = role == "normal_sd" || role == "weights";
    if (of_two_faces || role == "weight" || role == "residual" || role == "standard_deviation")
        points = {ones.data(), of_two_faces ? ones.size() : ones.size() / 2, 0, MIEN_DTYPE_F64, 0};
    if (role == "identity") points.count = identity_modes_;
    if (role == "expression") points.count = expression_modes_;
    const std::string name = row.name;
    if (name == "mien_array_view") put(bytes, 0, points);
    if (name == "mien_mesh_arrays") {
        put(bytes, offsetof(mien_mesh_arrays, positions), points);
        put(bytes, offsetof(mien_mesh_arrays, triangles), triangles_.data());
        put(bytes, offsetof(mien_mesh_arrays, triangle_count),
            std::uint64_t{triangles_.size() / 3});
        static const std::vector<std::uint8_t> colors(3 * kVertices, 150);
        put(bytes, offsetof(mien_mesh_arrays, colors), colors.data());
        static const std::uint8_t pixels[12] = {};
        static const mien_image image{"skin.png", pixels, 0, 2, 2, nullptr, 0};
        static const mien_material material{"skin", 0, 0, 1, 1, 1};
        put(bytes, offsetof(mien_mesh_arrays, images), &image);
        put(bytes, offsetof(mien_mesh_arrays, image_count), std::uint64_t{1});
        put(bytes, offsetof(mien_mesh_arrays, materials), &material);
        put(bytes, offsetof(mien_mesh_arrays, material_count), std::uint64_t{1});
    }
    for (const FieldRow& field : row.fields) {
        const std::string label = field.name;
        if (name == "mien_neutralize_options" && label == "treated")
            put(bytes, field.offset, zone_.data());
        if (name == "mien_neutralize_options" && label == "treated_count")
            put(bytes, field.offset, std::uint64_t{zone_.size()});
        if (label == "progress" && field.kind == Field::callback)
            put(bytes, field.offset, &stop_late);
        // Structs without an init function: a named set of vertices, a place with its noise.
        if (row.init == nullptr && label == "name" && std::string(row.fields[1].name) != "vertex")
            put(bytes, field.offset, static_cast<const char*>("zone"));
        if (row.init == nullptr && !row.tells_its_size && field.kind == Field::real64)
            for (std::size_t k = 0; k < field.size; k += sizeof(double))
                put(bytes, field.offset + k, 1.0);
        if (row.init == nullptr && label == "vertices") put(bytes, field.offset, zone_.data());
        if (row.init == nullptr && label == "vertex_count" && field.kind == Field::whole64 &&
            !row.tells_its_size)
            put(bytes, field.offset, std::uint64_t{zone_.size()});
    }
    shrink_settings(row, bytes);
    // Functions that take one such struct may take an array of them.
    if (!row.tells_its_size && row.size % sizeof(std::uint64_t) == 0) {
        const std::vector<std::uint64_t> one = bytes;
        for (int copy = 1; copy < 4; ++copy) bytes.insert(bytes.end(), one.begin(), one.end());
    }
    return bytes;
}

bool Fixtures::good_arguments(const FunctionRow& row, std::vector<Argument>& arguments) {
    static const char* const names[] = {"neutral", "grin", nullptr};
    static const char* const shards[] = {"abuse_shard0.safetensors", "abuse_shard1.safetensors",
                                         nullptr};
    begin_call();
    std::int64_t file_size = 0;
    kept_.clear();
    arguments.assign(row.parameters.size() + 1, Argument{});
    bool complete = true;
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
        const ParameterRow& parameter = row.parameters[i];
        const std::string name = parameter.name;
        Argument& argument = arguments[i];
        switch (parameter.kind) {
            case Kind::handle:
                argument.pointer =
                    name == "cancel" && parameter.nullable ? nullptr : handle(parameter.type);
                if (std::string(row.name) == "mien_template_check" && name == "landmarks")
                    argument.pointer = nullptr;  // those at hand are places, not vertices
                if (name == "landmarks" && (std::string(row.name) == "mien_norms_create" ||
                                            std::string(row.name) == "mien_landmarks_add_profile"))
                    argument.pointer = vertex_marks_;
                if (name == "template_mesh" &&
                    (std::string(row.name) == "mien_measure_asymmetry" ||
                     std::string(row.name) == "mien_landmarks_add_profile"))
                    argument.pointer = symmetric_;
                if (!kEncodesImages && std::string(parameter.type) == "mien_mesh" &&
                    std::string(row.name) == "mien_mesh_save_targets")
                    argument.pointer = symmetric_;  // it has no image
                if (std::string(row.name) == "mien_measurement_get_distance")
                    argument.pointer = distances_;
                if (std::string(row.name) == "mien_measurement_get_mirror_plane")
                    argument.pointer = sides_;
                complete = complete && (argument.pointer != nullptr || parameter.nullable);
                break;
            case Kind::struct_in:
            case Kind::struct_out:
                kept_.push_back(structure(*find_struct(parameter.type), 0, name));
                argument.pointer = kept_.back().data();
                break;
            case Kind::handle_list:
                kept_.emplace_back(
                    8, reinterpret_cast<std::uintptr_t>(
                           !kEncodesImages && std::string(row.name) == "mien_mesh_save_targets"
                               ? symmetric_
                               : handle(parameter.type)));
                argument.pointer = kept_.back().data();
                break;
            case Kind::text:
                argument.pointer = const_cast<char*>(good_text(row, name));
                break;
            case Kind::text_list:
                argument.pointer = const_cast<char**>(name == "shard_paths" ? shards : names);
                break;
            case Kind::array_out:
                kept_.emplace_back(std::size_t{1} << 19);
                argument.pointer = kept_.back().data();
                break;
            case Kind::array_in:
                if (name == "data") {  // the bytes of a file
                    kept_.push_back(read_file(file_of(row.name), file_size));
                    argument.pointer = kept_.back().data();
                    break;
                }
                kept_.emplace_back(4096);
                fill_array(name, parameter.type, kept_.back());
                argument.pointer = kept_.back().data();
                break;
            case Kind::handle_out:
            case Kind::value_out:
            case Kind::view_out:
                kept_.emplace_back(4096);  // coordinates and matrices come without a capacity
                argument.pointer = kept_.back().data();
                break;
            case Kind::whole:
                argument.whole = name == "size" ? file_size : good_whole(row, name);
                break;
            case Kind::real:
                argument.real = good_real(name);
                break;
            case Kind::callback:
                argument.function = reinterpret_cast<void (*)()>(&stop_late);
                break;
            case Kind::user:
            case Kind::error:
                break;
        }
    }
    return complete;
}

}  // namespace abuse
