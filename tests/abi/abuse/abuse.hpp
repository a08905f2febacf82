// Calls every function of the interface with arguments that no careful host would give. The tables
// of functions and structs are generated from the headers (tests/abi/generate_abuse.py).
#pragma once

#include <mien/mien.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

namespace abuse {

/// What a parameter is, and so how it can be abused.
enum class Kind {
    handle,
    handle_out,
    handle_list,
    struct_in,
    struct_out,
    text,
    text_list,
    array_in,
    array_out,
    value_out,
    view_out,
    whole,
    real,
    callback,
    user,
    error
};

enum class Result { status, nothing, pointer, value };

/// One argument in whichever form its parameter takes.
struct Argument {
    void* pointer = nullptr;
    std::int64_t whole = 0;
    double real = 0;
    void (*function)() = nullptr;
};

struct ParameterRow {
    const char* name;
    Kind kind;
    bool nullable;     // by its documentation
    const char* type;  // without const and stars
};

struct FunctionRow {
    const char* name;
    Result result;
    std::vector<ParameterRow> parameters;
    std::int64_t (*call)(const Argument*);
};

enum class Field { whole32, whole64, real32, real64, pointer, callback, nested, bytes };

struct FieldRow {
    const char* name;
    std::size_t offset, size;
    Field kind;
};

struct StructRow {
    const char* name;
    std::size_t size, alignment;
    bool tells_its_size;
    void (*init)(void*, std::size_t);  // null when there is none
    std::vector<FieldRow> fields;
};

const std::vector<FunctionRow>& functions();
const std::vector<StructRow>& structs();
const FunctionRow* find_function(const std::string& name);
const StructRow* find_struct(const std::string& name);

/// Live objects and good values to start from.
class Fixtures {
  public:
    Fixtures();
    ~Fixtures();
    /// A live object of a handle type, or null when none can be made here.
    void* handle(const std::string& type) const;
    /// A live object of any other type.
    void* other_handle(const std::string& type) const;
    /// A struct filled so that a call with it can succeed, `extra` zero bytes behind it. The role
    /// is the parameter's name.
    std::vector<std::uint64_t> structure(const StructRow& row, std::size_t extra = 0,
                                         const std::string& role = std::string()) const;
    /// Good values for all parameters of a function; false when a handle is missing.
    bool good_arguments(const FunctionRow& row, std::vector<Argument>& arguments);

    static constexpr int kSide = 12, kVertices = kSide * kSide, kFaces = 24;
    static constexpr int kCode = 5;  ///< numbers of the network's codes
    static constexpr const char* kDataset = "abuse_faces.safetensors";

  private:
    void write_files(mien_session* session) const;
    mien_mesh* symmetric_mesh(mien_session* session) const;
    std::vector<double> face(int subject, int expression) const;
    std::vector<std::pair<std::string, void*>> handles_;
    void* distances_ = nullptr;
    void* sides_ = nullptr;
    void* vertex_marks_ = nullptr;  // landmarks that are vertices
    mien_mesh* symmetric_ = nullptr;
    std::uint32_t identity_modes_ = 0, expression_modes_ = 0;
    std::vector<double> positions_;
    std::vector<std::uint32_t> triangles_, zone_;
    std::vector<std::vector<std::uint64_t>>
        kept_;  // structs and outputs of the last good_arguments()
};

// good_values.cpp: what a careful host would give.
std::string file_of(const std::string& function);
const char* good_text(const FunctionRow& row, const std::string& name);
std::int64_t good_whole(const FunctionRow& row, const std::string& name);
double good_real(const std::string& name);
void fill_array(const std::string& name, const std::string& type,
                std::vector<std::uint64_t>& words);
void shrink_settings(const StructRow& row, std::vector<std::uint64_t>& words);
/// Long calls end here: abuse may ask for millions of rounds. begin_call() starts the clock, which
/// counts computing time; a call with good arguments has no limit, since a late one is no fault.
std::int32_t MIEN_CALL stop_late(void*, std::int32_t, double);
void begin_call(bool limited = true);
void set_patience(int milliseconds);

/// Faults found so far; each is printed once at the end.
class Verdict {
  public:
    void check(bool good, const std::string& function, const std::string& what);
    int calls = 0;
    std::FILE* trace = nullptr;  // names every call before it runs: for finding a crash
    std::vector<std::string> faults;
};

/// One call with an error record of its own, checked against the promises that hold for every call:
/// a known status, the record in agreement, a message with a failure, null handles after one. What
/// the call made is released, unless it is to be kept.
std::int64_t observed_call(const FunctionRow& row, std::vector<Argument> arguments,
                           const std::string& how, Verdict& verdict, std::string* message = nullptr,
                           bool keep = false);

void abuse_parameters(Fixtures& fixtures, Verdict& verdict);
void abuse_structs(Fixtures& fixtures, Verdict& verdict);
void check_init_functions(Verdict& verdict);

}  // namespace abuse
