// Writes JSON text piece by piece, without a document tree. Numbers that are not finite become
// null.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

#include "base/json.hpp"

namespace mien {

class JsonText {
  public:
    void begin_object() { open('{'); }
    void end_object() { close('}'); }
    void begin_array() { open('['); }
    void end_array() { close(']'); }
    void key(const char* name) {
        separate();
        append_json_string(text_, name);
        text_ += ':';
        fresh_ = true;
    }
    void number(double value) {
        separate();
        if (!std::isfinite(value)) {
            text_ += "null";
            return;
        }
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, value);
        text_.append(digits, end.ptr);
    }
    void string(const std::string& value) {
        separate();
        append_json_string(text_, value);
    }
    void boolean(bool value) {
        separate();
        text_ += value ? "true" : "false";
    }
    void null() {
        separate();
        text_ += "null";
    }
    void field(const char* name, double value) {
        key(name);
        number(value);
    }
    void field(const char* name, const std::string& value) {
        key(name);
        string(value);
    }
    std::string take() { return std::move(text_); }

  private:
    void separate() {
        if (!fresh_) text_ += ',';
        fresh_ = false;
    }
    void open(char bracket) {
        separate();
        text_ += bracket;
        fresh_ = true;
    }
    void close(char bracket) {
        text_ += bracket;
        fresh_ = false;
    }
    std::string text_;
    bool fresh_ = true;
};

}  // namespace mien
