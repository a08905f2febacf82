// Writes JSON text piece by piece, without a document tree. Numbers that are not finite become
// null.
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <type_traits>

#include "base/json.hpp"

namespace mien {

class JsonText {
  public:
    JsonText& begin_object() { return open('{'); }
    JsonText& end_object() { return close('}'); }
    JsonText& begin_array() { return open('['); }
    JsonText& end_array() { return close(']'); }
    JsonText& key(const std::string& name) {
        separate();
        append_json_string(text_, name);
        text_ += ':';
        fresh_ = true;
        return *this;
    }
    JsonText& number(double value) { return std::isfinite(value) ? digits(value) : null(); }
    JsonText& integer(std::int64_t value) { return digits(value); }
    JsonText& string(const std::string& value) {
        separate();
        append_json_string(text_, value);
        return *this;
    }
    JsonText& boolean(bool value) { return raw(value ? "true" : "false"); }
    JsonText& null() { return raw("null"); }
    /// Text that is JSON already.
    JsonText& raw(const std::string& json) {
        separate();
        text_ += json;
        return *this;
    }

    /// A truth value, a number, a text, or a list of these.
    template <typename Value>
    JsonText& value(const Value& value) {
        if constexpr (std::is_same_v<Value, bool>) {
            return boolean(value);
        } else if constexpr (std::is_integral_v<Value>) {
            return integer(static_cast<std::int64_t>(value));
        } else if constexpr (std::is_floating_point_v<Value>) {
            return number(value);
        } else if constexpr (std::is_convertible_v<Value, std::string>) {
            return string(value);
        } else {
            begin_array();
            for (const auto& one : value) this->value(one);
            return end_array();
        }
    }
    template <typename Value>
    JsonText& field(const std::string& name, const Value& value) {
        return key(name).value(value);
    }

    std::string take() { return std::move(text_); }

  private:
    template <typename Number>
    JsonText& digits(Number value) {
        separate();
        char text[32];
        text_.append(text, std::to_chars(text, text + sizeof text, value).ptr);
        return *this;
    }
    void separate() {
        if (!fresh_) text_ += ',';
        fresh_ = false;
    }
    JsonText& open(char bracket) {
        separate();
        text_ += bracket;
        fresh_ = true;
        return *this;
    }
    JsonText& close(char bracket) {
        text_ += bracket;
        fresh_ = false;
        return *this;
    }
    std::string text_;
    bool fresh_ = true;
};

}  // namespace mien
