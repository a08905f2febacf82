// Random input through the shared library: files, options and sequences of calls. The functions,
// their good arguments and their structs come from tests/abi/abuse, whose tables are made from the
// headers.
//
//   fuzz_abi files|options|calls|sequences [iterations] [seed]
//     files      damaged files to every reader (models, expression, score, spectral, network and
//                memory files, meshes); half of them with their digest put right again, so that the
//                damage is met behind it
//     options    random values in the fields of options structs
//     calls      random functions on random live objects, good and wrong ones mixed
//     sequences  the same, eight in a row, whose objects are used by those that follow and given
//                back in any order
//   fuzz_abi seeds FOLDER
//     writes a good file of every kind to FOLDER/FUNCTION
// A known status with a message, a null handle after a failure, and no crash is right. Compiled
// with MIEN_FUZZER it is driven by libFuzzer: libfuzz_mien_model_load reads what the fuzzer makes
// as a model file, libfuzz_options, libfuzz_calls and libfuzz_sequences take their choices from its
// bytes (tests/fuzz/run.sh makes the links).
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "abi/abuse/abuse.hpp"
#include "base/sha256.hpp"
#include "fuzz/mutate.hpp"
#include "fuzz/own_folder.hpp"

namespace {

using namespace abuse;
using mien::fuzz::OwnFolder;
using mien::fuzz::Random;
using mien::fuzz::read_file;
using mien::fuzz::write_file;

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

/// The digest of the damaged file in its place, where that place is still to be found.
std::string signed_again(std::string bytes) {
    const std::string key = "\"digest\":\"";
    const std::size_t place = bytes.find(key);
    if (place == std::string::npos || place + key.size() + 64 > bytes.size()) return bytes;
    std::memset(&bytes[place + key.size()], '0', 64);
    mien::Sha256 hash;
    hash.update(bytes.data(), bytes.size());
    return bytes.replace(place + key.size(), 64, hash.hex_digest());
}

class Target {
  public:
    Target() {
        for (const FunctionRow& row : functions()) {
            const std::string name = row.name;
            const bool reads_file = contains(name, "_load");
            if (reads_file) loaders_.push_back({&row, read_file(file_of(name))});
            if (row.result != Result::status || contains(name, "_save")) continue;
            std::vector<Argument> arguments;
            if (fixtures_.good_arguments(row, arguments)) callable_.push_back(&row);
        }
        // Whatever reads a dataset reads this one.
        for (const FunctionRow& row : functions())
            for (const ParameterRow& p : row.parameters)
                if (std::strncmp(p.name, "dataset", 7) == 0 && p.kind == Kind::text)
                    loaders_.push_back({&row, read_file(Fixtures::kDataset)});
        set_patience(100);
    }

    /// Damages one file and reads it.
    void damage_file(Random& random) {
        const Loader& loader = loaders_[random.below(loaders_.size())];
        const Loader& other = loaders_[random.below(loaders_.size())];
        std::string bytes = mien::fuzz::mutate(loader.good, other.good, random);
        if (random.below(2) == 0) bytes = signed_again(std::move(bytes));
        read_bytes(loader, bytes);
    }

    void random_options(Random& random) {
        const FunctionRow& row = *callable_[random.below(callable_.size())];
        std::vector<Argument> arguments;
        fixtures_.good_arguments(row, arguments);
        bool changed = false;
        for (std::size_t i = 0; i < row.parameters.size(); ++i) {
            if (row.parameters[i].kind != Kind::struct_in || arguments[i].pointer == nullptr)
                continue;
            const StructRow& layout = *find_struct(row.parameters[i].type);
            for (std::size_t k = 1 + random.below(3); k != 0; --k)
                randomise_field(layout, static_cast<char*>(arguments[i].pointer), random);
            changed = true;
        }
        if (changed) call(row, arguments, "options");
    }

    /// Good arguments, some of them replaced.
    void random_call(Random& random) {
        const FunctionRow& row = *callable_[random.below(callable_.size())];
        std::vector<Argument> arguments;
        fixtures_.good_arguments(row, arguments);
        for (std::size_t i = 0; i < row.parameters.size(); ++i) {
            if (random.below(4) != 0) continue;
            const ParameterRow& p = row.parameters[i];
            if (p.kind == Kind::handle)
                arguments[i].pointer =
                    random.below(8) == 0 ? nullptr : fixtures_.other_handle(p.type);
            if (p.kind == Kind::whole && std::strcmp(p.name, "capacity") != 0 &&
                !contains(p.name, "count") && !contains(p.name, "size"))
                arguments[i].whole = static_cast<std::int64_t>(random_word(random));
            if (p.kind == Kind::real) arguments[i].real = random_real(random);
        }
        call(row, arguments, "calls");
    }

    /// Calls in a row: what one made the next may take, also after its session is gone, and all are
    /// given back in a random order.
    void random_sequence(Random& random) {
        constexpr int kCalls = 8;
        std::vector<Made> made;
        for (int k = 0; k < kCalls && !random.exhausted(); ++k) {
            const FunctionRow& row = *callable_[random.below(callable_.size())];
            std::vector<Argument> arguments;
            fixtures_.good_arguments(row, arguments);
            for (std::size_t i = 0; i < row.parameters.size(); ++i)
                if (row.parameters[i].kind == Kind::handle)
                    choose_handle(row.parameters[i], arguments[i], made, random);
            begin_call();
            const std::int64_t status =
                observed_call(row, arguments, "sequences", verdict_, nullptr, true);
            for (std::size_t i = 0; status == MIEN_OK && i < row.parameters.size(); ++i)
                if (row.parameters[i].kind == Kind::handle_out && arguments[i].pointer != nullptr) {
                    void* handle = nullptr;
                    std::memcpy(&handle, arguments[i].pointer, sizeof handle);
                    if (handle != nullptr) made.push_back({row.parameters[i].type, handle});
                }
            if (random.below(4) == 0) give_back(made, random);
        }
        while (!made.empty()) give_back(made, random);
    }

    /// These bytes, to the reader of that name (and with their digest put right, where `sign`).
    bool read_as(const std::string& name, std::string bytes, bool sign) {
        for (const Loader& loader : loaders_)
            if (name == loader.row->name) {
                read_bytes(loader, sign ? signed_again(std::move(bytes)) : bytes);
                return true;
            }
        return false;
    }

    void write_seeds(const std::filesystem::path& into) const {
        for (const Loader& loader : loaders_) {
            std::filesystem::create_directories(into / loader.row->name);
            write_file((into / loader.row->name / "good").string(), loader.good);
        }
    }

    const Verdict& verdict() const { return verdict_; }

  private:
    struct Made {
        std::string type;
        void* handle;
    };
    void choose_handle(const ParameterRow& parameter, Argument& argument,
                       const std::vector<Made>& made, Random& random) const {
        std::vector<void*> fitting;
        for (const Made& one : made)
            if (one.type == parameter.type) fitting.push_back(one.handle);
        if (!fitting.empty() && random.below(4) != 0)
            argument.pointer = fitting[random.below(fitting.size())];
        else if (random.below(16) == 0)
            argument.pointer = fixtures_.other_handle(parameter.type);
    }
    static void give_back(std::vector<Made>& made, Random& random) {
        if (made.empty()) return;
        const auto one = made.begin() + static_cast<std::ptrdiff_t>(random.below(made.size()));
        Argument argument;
        argument.pointer = one->handle;
        find_function(one->type + "_release")->call(&argument);
        made.erase(one);
    }

    struct Loader {
        const FunctionRow* row;
        std::string good;
    };

    void read_bytes(const Loader& loader, const std::string& bytes) {
        std::vector<Argument> arguments;
        if (!fixtures_.good_arguments(*loader.row, arguments)) return;
        const std::string path =
            contains(loader.row->name, "mesh_load") ? extension_path(bytes) : "damaged.safetensors";
        // Exactly so long, so that a sanitizer sees the first byte too far.
        const std::vector<char> exact(bytes.begin(), bytes.end());
        for (std::size_t i = 0; i < loader.row->parameters.size(); ++i) {
            const ParameterRow& p = loader.row->parameters[i];
            if (p.kind == Kind::text &&
                (std::strcmp(p.name, "path") == 0 || std::strncmp(p.name, "dataset", 7) == 0)) {
                write_file(path, bytes);
                arguments[i].pointer = const_cast<char*>(path.c_str());
            }
            if (p.kind == Kind::array_in && std::strcmp(p.name, "data") == 0)
                arguments[i].pointer = const_cast<char*>(exact.data());
            if (p.kind == Kind::whole && std::strcmp(p.name, "size") == 0)
                arguments[i].whole = static_cast<std::int64_t>(exact.size());
        }
        const std::size_t before = verdict_.faults.size();
        call(*loader.row, arguments, "files");
        if (verdict_.faults.size() != before) write_file("../fuzz_abi_fault.bin", bytes);
    }
    /// Any of the four formats, chosen by the bytes themselves.
    static std::string extension_path(const std::string& bytes) {
        static const char* const kPaths[] = {"damaged.ply", "damaged.obj", "damaged.stl",
                                             "damaged.off"};
        return kPaths[(bytes.size() / 8) % 16 < 13 ? 0 : 1 + bytes.size() % 3];
    }

    void call(const FunctionRow& row, const std::vector<Argument>& arguments, const char* how) {
        begin_call();
        observed_call(row, arguments, how, verdict_);
    }

    static std::uint64_t random_word(Random& random) {
        static const std::uint64_t kWords[] = {0,
                                               1,
                                               2,
                                               3,
                                               100,
                                               0x7fffffff,
                                               0x80000000,
                                               0xffffffff,
                                               0x7fffffffffffffff,
                                               0xffffffffffffffff};
        return random.below(3) == 0 ? random.below(64)
                                    : kWords[random.below(sizeof kWords / sizeof kWords[0])];
    }
    static double random_real(Random& random) {
        static const double kReals[] = {0,
                                        -0.0,
                                        1e-300,
                                        1e-9,
                                        0.5,
                                        1,
                                        1e3,
                                        1e9,
                                        1e300,
                                        -1,
                                        -1e30,
                                        std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::quiet_NaN()};
        return kReals[random.below(sizeof kReals / sizeof kReals[0])];
    }
    /// Numbers only: a wrong pointer is the host's own doing, and so is a count of what lies behind
    /// it.
    static void randomise_field(const StructRow& layout, char* bytes, Random& random) {
        const FieldRow& field = layout.fields[random.below(layout.fields.size())];
        const std::string name = field.name;
        if (name == "struct_size" || contains(name, "count") || contains(name, "stride") ||
            name == "dtype")
            return;
        if (field.kind == Field::whole32 || field.kind == Field::whole64) {
            const std::uint64_t word = random_word(random);
            std::memcpy(bytes + field.offset, &word, field.kind == Field::whole32 ? 4 : 8);
        } else if (field.kind == Field::real64) {
            const double real = random_real(random);
            std::memcpy(bytes + field.offset, &real, sizeof real);
        }
    }

    Fixtures fixtures_;
    Verdict verdict_;
    std::vector<Loader> loaders_;
    std::vector<const FunctionRow*> callable_;
};

void run_one(Target& target, const std::string& mode, Random& random) {
    if (mode == "files")
        target.damage_file(random);
    else if (mode == "options")
        target.random_options(random);
    else if (mode == "sequences")
        target.random_sequence(random);
    else
        target.random_call(random);
}

}  // namespace

#if defined(MIEN_FUZZER)

namespace {
std::string fuzzed;

/// Made before the first input, whose time is limited: it builds a model of every kind.
Target& target() {
    static const OwnFolder folder;
    static Target made;
    return made;
}
}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char*** argv) {
    const std::string name = (*argv)[0];
    fuzzed = name.substr(name.rfind("libfuzz_") + 8);
    target();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    Random random(data, size);
    if (fuzzed == "options" || fuzzed == "calls" || fuzzed == "sequences")
        run_one(target(), fuzzed, random);
    else if (!target().read_as(fuzzed, std::string(data, data + size), true)) {
        std::fprintf(stderr, "no function '%s' reads a file\n", fuzzed.c_str());
        std::abort();
    }
    if (!target().verdict().faults.empty()) {
        std::fprintf(stderr, "%s\n", target().verdict().faults.front().c_str());
        std::abort();
    }
    return 0;
}

#else

int main(int argc, char** argv) {
    const std::string mode = argc > 1 ? argv[1] : "files";
    if (mode == "seeds" && argc == 3) {
        const std::filesystem::path into = std::filesystem::absolute(argv[2]);
        const OwnFolder folder;
        Target().write_seeds(into);
        return 0;
    }
    const long iterations = argc > 2 ? std::atol(argv[2]) : 3000;
    const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
    const OwnFolder folder;
    Target target;
    double slowest = 0;
    for (long k = 0; k < iterations && target.verdict().faults.size() < 10; ++k) {
        Random random(seed * 0x100000001b3ULL + static_cast<std::uint64_t>(k));
        const auto begin = std::chrono::steady_clock::now();
        run_one(target, mode, random);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        slowest = std::max(slowest, taken.count());
        static std::size_t told = 0;
        for (; told < target.verdict().faults.size(); ++told)
            std::printf("iteration %ld: %s\n", k, target.verdict().faults[told].c_str());
    }
    std::printf("%s: %d calls, %zu faults, slowest %.0f ms\n", mode.c_str(), target.verdict().calls,
                target.verdict().faults.size(), 1e3 * slowest);
    return target.verdict().faults.empty() ? 0 : 1;
}

#endif
