// JSON without a document tree: nlohmann's DOM values allocate in their destructors, which ends the
// process when memory is short. Readers derive from StrictJson and take what they expect;
// everything else is a typed error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/detail/exceptions.hpp>
#include <string>
#include <vector>

namespace mien {

/// A SAX receiver that refuses everything. Override what may come; positions are the caller's own
/// business. Refusals throw Status::bad_format with `what` in front.
class StrictJson {
  public:
    using number_integer_t = std::int64_t;
    using number_unsigned_t = std::uint64_t;
    using number_float_t = double;
    using string_t = std::string;
    using binary_t = std::vector<std::uint8_t>;

    explicit StrictJson(const char* what) : what_(what) {}
    virtual ~StrictJson() = default;

    virtual bool null() { refuse("null"); }
    virtual bool boolean(bool) { refuse("a boolean"); }
    virtual bool number_integer(number_integer_t) { refuse("a negative number"); }
    virtual bool number_unsigned(number_unsigned_t) { refuse("a number"); }
    virtual bool number_float(number_float_t, const string_t&) { refuse("a fraction"); }
    virtual bool string(string_t&) { refuse("a string"); }
    virtual bool start_object(std::size_t) { refuse("an object"); }
    virtual bool key(string_t&) { refuse("a key"); }
    virtual bool end_object() { refuse("the end of an object"); }
    virtual bool start_array(std::size_t) { refuse("a list"); }
    virtual bool end_array() { refuse("the end of a list"); }
    bool binary(binary_t&) { refuse("binary data"); }
    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception& error);

  protected:
    [[noreturn]] void refuse(const char* found) const;
    const char* what_;
};

/// Parses the whole text; throws Status::bad_format when it is not one JSON value.
void parse_json(const char* text, std::size_t size, StrictJson& receiver);

/// ["a", "b", ...] and nothing else.
std::vector<std::string> parse_json_string_list(const std::string& text, const char* what);

/// Appends a quoted JSON string. Throws Status::invalid_argument when `text` is not UTF-8.
void append_json_string(std::string& json, const std::string& text);
std::string json_string_list(const std::vector<std::string>& texts);

bool is_utf8(const std::string& text);

/// A name from a file as it may stand in a message: shortened, control characters replaced.
std::string shown_name(const std::string& name);

}  // namespace mien
