// What each parameter and setting would be given by a careful host: abuse changes one of them at a
// time.
#include <cstring>
#include <ctime>
#include <deque>

#include "abuse.hpp"

namespace abuse {
namespace {

// The time that this process has computed, so that a busy machine ends no call early.
std::clock_t call_began;
bool call_is_limited = true;
int patience_ms = 400;

struct Setting {
    const char *structure, *field;
    std::int32_t value;
};

/// Small models of small sheets.
constexpr Setting kSettings[] = {
    {"mien_model_options", "num_modes", 60},
    {"mien_train_options", "identity_modes", 4},
    {"mien_train_options", "expression_modes", 3},
    {"mien_spectral_basis_options", "mode_count", 20},
    {"mien_register_options", "iterations", 3},
    {"mien_register_options", "start", MIEN_START_POSE},
    {"mien_tune_options", "num_modes", 30},
    {"mien_neutralize_options", "uncertainty", 1},
    {"mien_score_options", "folds", 3},
    {"mien_score_options", "max_components", 2},
    {"mien_follow_options", "rounds", 1},
};

struct Number {
    const char *function, *parameter;  // function: a part of its name
    std::int64_t value;
};

/// The first row that fits counts; what no row names is 0.
constexpr Number kNumbers[] = {
    {"", "dtype", MIEN_DTYPE_F64},
    {"", "abi_version", MIEN_ABI_VERSION},
    {"", "struct_size", 4},
    {"", "capacity", std::int64_t{1} << 16},
    {"landmarks_create", "landmark_count", 1},
    {"zones_create", "zone_count", 1},
    {"score_model_train", "grade_count", Fixtures::kFaces},
    {"statistics_agreement", "grade_count", 4},
    {"statistics", "subject_count", 8},
    {"statistics", "value_count", 12},
    {"statistics", "blank_count", 12},
    {"representation", "row_count", Fixtures::kVertices},
    {"hierarchy", "row_count", Fixtures::kVertices},
    {"network", "code_count", Fixtures::kCode},
    {"", "coefficient_count", 3},
    {"", "vertex_count", 9},
    {"", "level", 1},
    {"", "direction", MIEN_MAP_DOWN},
    {"", "stride", 2},
    {"", "radius", 2},
    {"", "k", 10},
    {"follower_fit", "width", Fixtures::kSide},
    {"follower_fit", "height", Fixtures::kVertices / Fixtures::kSide},
    {"", "metric", MIEN_METRIC_L1},
    {"", "what", MIEN_TRANSFER_LANDMARKS},
    {"", "close_rims", 1},
    {"", "carry", MIEN_CARRY_CLOSEST_POINT},
    {"", "kind", MIEN_FEATURES_EUCLIDEAN_STANDARDISED},
    {"registration", "field", MIEN_REGISTRATION_RESIDUAL_MM},
    {"measurement", "field", MIEN_FIELD_POSITIVE_VOLUME_MM3},
    {"study", "field", MIEN_STUDY_FIELD_WEIGHT},
    {"study", "second", 1},
    {"measurement", "zone", MIEN_ZONE_WHOLE},
};

}  // namespace

std::int32_t MIEN_CALL stop_late(void*, std::int32_t, double) {
    const double ms = 1e3 * static_cast<double>(std::clock() - call_began) / CLOCKS_PER_SEC;
    return call_is_limited && ms > patience_ms ? 1 : 0;
}

void set_patience(int milliseconds) {
    patience_ms = milliseconds;
}

void begin_call(bool limited) {
    call_began = std::clock();
    call_is_limited = limited;
}

std::string file_of(const std::string& function) {
    // mien_score_model_load_trusted -> abuse_score_model.safetensors
    const std::size_t end = std::min(function.rfind("_load"), function.rfind("_save"));
    const std::string kind = end == std::string::npos ? function : function.substr(5, end - 5);
    if (kind == "mesh")
        return function.find("target") == std::string::npos ? "abuse_mesh.ply" : "abuse_mesh.glb";
    const bool text = kind == "landmarks" || kind == "zones" || kind == "norms";
    return "abuse_" + kind + (text ? ".json" : ".safetensors");
}

const char* good_text(const FunctionRow& row, const std::string& name) {
    static std::deque<std::string> kept;
    if (name == "dataset_path" || name == "dataset") return Fixtures::kDataset;
    if (std::strcmp(row.name, "mien_session_hash_file") == 0) return Fixtures::kDataset;
    if (name == "shard_path") return "abuse_shard.safetensors";
    if (name == "zone" && std::strcmp(row.name, "mien_registration_get_expected_error") == 0)
        return nullptr;  // the whole face: a registration without a model knows no zone
    if (name != "path") return "grin";
    kept.push_back(file_of(row.name));
    return kept.back().c_str();
}

std::int64_t good_whole(const FunctionRow& row, const std::string& name) {
    for (const Number& number : kNumbers)
        if (name == number.parameter && std::strstr(row.name, number.function) != nullptr)
            return number.value;
    return name.find("count") != std::string::npos ? 2 : 0;
}

double good_real(const std::string& name) {
    return name == "factor" || name == "max_distance_mm" ? 4 : 1;
}

void fill_array(const std::string& name, const std::string& type,
                std::vector<std::uint64_t>& words) {
    char* const bytes = reinterpret_cast<char*>(words.data());
    const auto put = [&](std::size_t i, auto value) {
        std::memcpy(bytes + i * sizeof value, &value, sizeof value);
    };
    for (std::size_t i = 0; i < 512; ++i) {
        const auto number = static_cast<std::int32_t>(i);
        if (name == "direction")
            put(i, i == 2 ? 1.0 : 0.0);
        else if (name == "matrix")
            put(i, i < 16 && i % 5 == 0 ? 1.0 : 0.0);
        else if (name == "motion")
            put(i, i == 0 || i == 4 || i == 8 ? 1.0 : 0.0);
        else if (name == "ratings")
            put(i, (number + number / 7) % 4);
        else if (name == "subjects")
            put(i, number / 2);
        else if (type == "int32_t" || type == "uint32_t")
            put(i, number);
        else if (type == "uint64_t")
            put(i, std::uint64_t{5 * (i + 1)});
        else if (type == "double")
            put(i, static_cast<double>(i % 7) + 0.01 * number);
    }
}

void shrink_settings(const StructRow& row, std::vector<std::uint64_t>& words) {
    char* const bytes = reinterpret_cast<char*>(words.data());
    for (const Setting& setting : kSettings)
        for (const FieldRow& field : row.fields)
            if (std::strcmp(row.name, setting.structure) == 0 &&
                std::strcmp(field.name, setting.field) == 0)
                std::memcpy(bytes + field.offset, &setting.value, sizeof setting.value);
    if (std::strcmp(row.name, "mien_model_options") == 0) {
        static const mien_landmark landmark{"zone", 13, 0};  // what lists of landmarks hold, too
        const auto* data = &landmark;
        const std::uint64_t count = 1;
        std::memcpy(bytes + offsetof(mien_model_options, landmarks), &data, sizeof data);
        std::memcpy(bytes + offsetof(mien_model_options, landmark_count), &count, sizeof count);
    }
    if (std::strcmp(row.name, "mien_study_options") == 0) {
        static const std::uint32_t vertices[] = {13, 14, 15, 16, 25, 26, 27, 28, 37, 38, 39, 40};
        static const mien_zone zones[] = {{"zone", vertices, 12}};
        static const char* const names[] = {"zone"};
        const auto* zone = zones;
        const auto* name = names;
        const std::uint64_t count = 1;
        std::memcpy(bytes + offsetof(mien_study_options, zones), &zone, sizeof zone);
        std::memcpy(bytes + offsetof(mien_study_options, zone_count), &count, sizeof count);
        std::memcpy(bytes + offsetof(mien_study_options, stable_zones), &name, sizeof name);
        std::memcpy(bytes + offsetof(mien_study_options, stable_count), &count, sizeof count);
    }
    if (std::strcmp(row.name, "mien_follow_options") == 0) {  // the sheet is no camera's frame
        const double focal = 100;
        std::memcpy(bytes + offsetof(mien_follow_options, focal_x), &focal, sizeof focal);
        std::memcpy(bytes + offsetof(mien_follow_options, focal_y), &focal, sizeof focal);
    }
    if (std::strcmp(row.name, "mien_tune_options") == 0) {
        static const double sigmas[] = {20, 40};
        const auto* data = sigmas;
        const std::uint64_t count = 2;
        std::memcpy(bytes + offsetof(mien_tune_options, sigmas_mm), &data, sizeof data);
        std::memcpy(bytes + offsetof(mien_tune_options, sigma_count), &count, sizeof count);
    }
}

}  // namespace abuse
