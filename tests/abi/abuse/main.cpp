// Runs all abuse, in silence: whatever the library would print shows up as a fault. An argument
// names a file for the trace of all calls ("-": none), a second one how many milliseconds a call
// may take before its progress callback ends it (for slow tools such as valgrind).
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#if defined(_WIN32)
#include <io.h>
#define dup _dup
#define dup2 _dup2
#define fileno _fileno
#else
#include <unistd.h>
#endif

#include "abuse.hpp"

namespace {

/// The files of one run lie apart from those of another one beside it, and go with it.
class OwnFolder {
  public:
    OwnFolder() : before_(std::filesystem::current_path()) {
        std::random_device chance;
        folder_ =
            std::filesystem::temp_directory_path() / ("mien_abuse_" + std::to_string(chance()));
        std::filesystem::create_directory(folder_);
        std::filesystem::current_path(folder_);
    }
    ~OwnFolder() {
        std::error_code ignored;
        std::filesystem::current_path(before_, ignored);
        std::filesystem::remove_all(folder_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

  private:
    std::filesystem::path before_, folder_;
};

}  // namespace

int main(int argc, char** argv) {
    using namespace abuse;
    // Standard output and error go to a file while the library runs.
    std::FILE* heard = std::tmpfile();
    std::fflush(stdout);
    const int out = dup(1), err = dup(2);
    if (heard != nullptr) {
        dup2(fileno(heard), 1);
        dup2(fileno(heard), 2);
    }
    Verdict verdict;
    if (argc > 1 && argv[1][0] != '-') verdict.trace = std::fopen(argv[1], "w");
    if (argc > 2) set_patience(std::atoi(argv[2]));
    std::string missing;
    {
        const OwnFolder folder;
        Fixtures fixtures;
        for (const FunctionRow& row : functions())
            for (const ParameterRow& parameter : row.parameters)
                if (parameter.kind == Kind::handle && fixtures.handle(parameter.type) == nullptr &&
                    missing.find(std::string(parameter.type) + " ") == std::string::npos)
                    missing += std::string(parameter.type) + " ";
        check_init_functions(verdict);
        abuse_parameters(fixtures, verdict);
        abuse_structs(fixtures, verdict);

        // After all that, the session that lived through it still works.
        std::vector<Argument> good;
        const FunctionRow& create = *find_function("mien_mesh_create");
        fixtures.good_arguments(create, good);
        verdict.check(observed_call(create, good, "afterwards", verdict) == MIEN_OK, create.name,
                      "fails after the abuse");
    }
    std::fflush(stdout);
    std::fflush(stderr);
    dup2(out, 1);
    dup2(err, 2);
    if (heard != nullptr) {
        std::fseek(heard, 0, SEEK_END);
        verdict.check(std::ftell(heard) == 0, "the library", "wrote to standard output or error");
        std::fclose(heard);
    }
    verdict.check(missing.empty(), "the fixtures", "make none of these: " + missing);
    for (const std::string& fault : verdict.faults) std::printf("FAILED: %s\n", fault.c_str());
    std::printf("%d calls of %zu functions over %zu structs, %zu faults\n", verdict.calls,
                functions().size(), structs().size(), verdict.faults.size());
    return verdict.faults.empty() ? 0 : 1;
}
