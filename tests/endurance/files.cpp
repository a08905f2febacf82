// Files that are damaged, writers that are killed, disks that are full.
#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "endurance.hpp"

#if !defined(_WIN32)
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace endurance {
namespace {

/// A function that reads a safetensors file, and a good file of its kind.
struct Reader {
    const FunctionRow* row;
    std::string good;
};

std::vector<Reader> readers(Fixtures& fixtures) {
    std::vector<Reader> found;
    for (const FunctionRow& row : functions()) {
        const std::string name = row.name;
        std::vector<Argument> arguments;
        const bool loads =
            name.find("_load") != std::string::npos && name.find("mesh") == std::string::npos &&
            name.find("trusted") == std::string::npos && name.find("memory") == std::string::npos;
        if (loads && fixtures.good_arguments(row, arguments)) {
            std::string good = read_file(file_of(name));
            // Texts (landmarks, zones, norms) and what other programs wrote have no digest.
            if (good.find("\"digest\":\"") != std::string::npos)
                found.push_back({&row, std::move(good)});
        }
        if (name == "mien_expression_model_train")
            found.push_back({&row, read_file(Fixtures::kDataset)});
    }
    return found;
}

/// The status of reading these bytes.
std::int64_t read_bytes(Fixtures& fixtures, const Reader& reader, const std::string& bytes,
                        Verdict& verdict) {
    static const char* const path = "damaged.safetensors";
    write_file(path, bytes);
    std::vector<Argument> arguments;
    fixtures.good_arguments(*reader.row, arguments);
    begin_call(false);
    for (std::size_t i = 0; i < reader.row->parameters.size(); ++i)
        if (reader.row->parameters[i].kind == Kind::text)
            arguments[i].pointer = const_cast<char*>(path);
    return observed_call(*reader.row, arguments, "damaged", verdict);
}

// Every bit of every model file and dataset counts: names, zones and settings as well as numbers.
void damage_files(long count, std::uint64_t seed, bool truncate) {
    Fixtures fixtures;
    Verdict verdict;
    const std::vector<Reader> all = readers(fixtures);
    for (const Reader& reader : all)
        if (read_bytes(fixtures, reader, reader.good, verdict) != MIEN_OK)
            fault(std::string(reader.row->name) + " refuses its own file");
    Random random(seed);
    for (long k = 0; k < count; ++k) {
        const Reader& reader = all[static_cast<std::size_t>(k) % all.size()];
        std::string bytes = reader.good;
        // Half of the flips go to the header, which is small beside the tensors.
        const std::size_t header =
            8 + static_cast<unsigned char>(bytes[0]) + 256u * static_cast<unsigned char>(bytes[1]);
        const std::size_t place =
            random.below(random.below(2) == 0 ? std::min(header, bytes.size()) : bytes.size());
        if (truncate)
            bytes.resize(place);
        else
            bytes[place] = static_cast<char>(bytes[place] ^ (1 << random.below(8)));
        if (read_bytes(fixtures, reader, bytes, verdict) == MIEN_OK)
            fault(std::string(reader.row->name) + ": damage at byte " + std::to_string(place) +
                  " of " + std::to_string(bytes.size()) + " is not noticed");
    }
    for (const std::string& found : verdict.faults) fault(found);
    std::printf("%ld %s of %zu kinds of files\n", count, truncate ? "truncations" : "flipped bits",
                all.size());
}

std::size_t count_entries(const std::string& folder) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        count += !entry.path().empty();
    return count;
}

/// The files of a folder, by name.
std::map<std::string, std::string> folder_contents(const std::string& folder) {
    std::map<std::string, std::string> contents;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        contents[entry.path().filename().string()] = read_file(entry.path().string());
    return contents;
}

}  // namespace

void run_flips(long count, std::uint64_t seed) {
    damage_files(count, seed, false);
}

void run_truncations(long count, std::uint64_t seed) {
    damage_files(count, seed, true);
}

#if defined(_WIN32)

void run_full_disk(long, std::uint64_t) {}
void run_kills(long, std::uint64_t) {}

#else

// Every function that writes a file, where the disk takes only the first bytes of it: an error, the
// old file whole, and nothing beside it. A limit on the size of files stands in for the disk: both
// make write() fail after some bytes.
void run_full_disk(long count, std::uint64_t seed) {
    Fixtures fixtures;
    Verdict verdict;
    struct Writer {
        const FunctionRow* row;
        std::size_t path;
    };
    std::vector<Writer> writers;
    for (const FunctionRow& row : functions()) {
        const std::string name = row.name;
        if (name.find("_save") == std::string::npos && name != "mien_expression_shard_create")
            continue;
        for (std::size_t i = 0; i < row.parameters.size(); ++i)
            if (row.parameters[i].kind == Kind::text &&
                std::strstr(row.parameters[i].name, "path") != nullptr &&
                std::strcmp(row.parameters[i].name, "dataset_path") != 0)
                writers.push_back({&row, i});
    }
    struct rlimit before;
    getrlimit(RLIMIT_FSIZE, &before);
    Random random(seed);
    for (long k = 0; k < count; ++k) {
        const Writer& writer = writers[static_cast<std::size_t>(k) % writers.size()];
        std::vector<Argument> arguments;
        if (!fixtures.good_arguments(*writer.row, arguments)) continue;
        const std::string good = static_cast<const char*>(arguments[writer.path].pointer);
        const std::string extension = good.substr(good.rfind('.'));
        std::filesystem::remove_all("full");
        std::filesystem::create_directory("full");
        const std::string path = "full/file" + extension;
        arguments[writer.path].pointer = const_cast<char*>(path.c_str());
        begin_call(false);
        if (observed_call(*writer.row, arguments, "written", verdict) != MIEN_OK)
            fault(std::string(writer.row->name) + " cannot write");
        const auto whole = folder_contents("full");
        struct rlimit small = before;
        small.rlim_cur = random.below(read_file(path).size());
        setrlimit(RLIMIT_FSIZE, &small);
        const std::int64_t status = observed_call(*writer.row, arguments, "full disk", verdict);
        setrlimit(RLIMIT_FSIZE, &before);
        if (status != MIEN_E_IO)
            fault(std::string(writer.row->name) + " ends as " +
                  mien_status_name(static_cast<mien_status>(status)) + " where the disk is full");
        if (folder_contents("full") != whole)
            fault(std::string(writer.row->name) + " leaves other files where the disk is full");
    }
    for (const std::string& found : verdict.faults) fault(found);
    std::printf("%ld full disks under %zu functions\n", count, writers.size());
}

// A killed writer leaves the old file or the new one, whole, and what else it leaves the next
// writer removes.
void run_kills(long count, std::uint64_t seed) {
    Fixtures fixtures;
    const auto* model = static_cast<const mien_model*>(fixtures.handle("mien_model"));
    mien_session* session = new_session();
    std::filesystem::create_directory("killed");
    const std::string path = "killed/model.safetensors";
    if (mien_model_save(session, model, path.c_str(), nullptr) != MIEN_OK) fault("cannot save");
    const std::string whole = read_file(path);
    Random random(seed);
    std::size_t most = 0;
    for (long k = 0; k < count; ++k) {
        const pid_t child = fork();
        if (child == 0) {
            for (;;) mien_model_save(session, model, path.c_str(), nullptr);
        }
        usleep(static_cast<useconds_t>(500 + random.below(20000)));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        if (read_file(path) != whole) fault("a killed writer left a damaged file");
        most = std::max(most, count_entries("killed"));
    }
    if (mien_model_save(session, model, path.c_str(), nullptr) != MIEN_OK)
        fault("cannot save again");
    if (count_entries("killed") != 1) fault("files of killed writers were left behind");
    if (most > 2) fault("killed writers left more than one file");
    mien_session_release(session);
    std::printf("%ld killed writers, at most %zu files at a time\n", count, most);
}

#endif

}  // namespace endurance
