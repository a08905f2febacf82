#include "base/json_value.hpp"

#include <cstring>

#include "base/error.hpp"
#include "base/json.hpp"

namespace mien {
namespace {

constexpr std::size_t kDeepest = 64;  // values are destroyed recursively: bounded by this

class TreeReceiver : public StrictJson {
  public:
    using StrictJson::StrictJson;
    JsonValue root;

    bool null() override { return put(JsonValue()); }
    bool boolean(bool value) override { return number_of(JsonValue::Kind::boolean, value ? 1 : 0); }
    bool number_integer(number_integer_t value) override {
        return number_of(JsonValue::Kind::number, static_cast<double>(value));
    }
    bool number_unsigned(number_unsigned_t value) override {
        return number_of(JsonValue::Kind::number, static_cast<double>(value));
    }
    bool number_float(number_float_t value, const string_t&) override {
        return number_of(JsonValue::Kind::number, value);
    }
    bool string(string_t& text) override {
        JsonValue value;
        value.kind = JsonValue::Kind::string;
        value.text = std::move(text);
        return put(std::move(value));
    }
    bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
    bool key(string_t& name) override {
        open_.back().keys.push_back(std::move(name));
        return true;
    }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

  private:
    bool number_of(JsonValue::Kind kind, double number) {
        JsonValue value;
        value.kind = kind;
        value.number = number;
        return put(std::move(value));
    }
    bool open(JsonValue::Kind kind) {
        if (open_.size() == kDeepest)
            fail(Status::bad_format, "%s: nested more than %zu deep", what_, kDeepest);
        open_.emplace_back();
        open_.back().kind = kind;
        return true;
    }
    bool close() {
        JsonValue done = std::move(open_.back());
        open_.pop_back();
        return put(std::move(done));
    }
    bool put(JsonValue&& value) {
        if (open_.empty())
            root = std::move(value);
        else
            open_.back().items.push_back(std::move(value));
        return true;
    }
    std::vector<JsonValue> open_;
};

/// The text with the words that are no JSON replaced by null of the same meaning.
std::string without_nan(const char* text, std::size_t size) {
    static constexpr const char* kWords[] = {"-Infinity", "Infinity", "-NaN", "NaN", "nan"};
    std::string clean;
    clean.reserve(size);
    bool quoted = false;
    for (std::size_t i = 0; i < size;) {
        if (quoted && text[i] == '\\' && i + 1 < size) {
            clean.append(text + i, 2);
            i += 2;
            continue;
        }
        if (text[i] == '"') quoted = !quoted;
        bool replaced = false;
        for (const char* word : kWords) {
            const std::size_t length = std::strlen(word);
            if (quoted || size - i < length || std::memcmp(text + i, word, length) != 0) continue;
            clean += "null";
            i += length;
            replaced = true;
            break;
        }
        if (!replaced) clean += text[i++];
    }
    return clean;
}

}  // namespace

const JsonValue* JsonValue::find(const char* key) const {
    for (std::size_t i = 0; i < keys.size() && i < items.size(); ++i)
        if (keys[i] == key) return &items[i];
    return nullptr;
}

JsonValue parse_json_value(const char* text, std::size_t size, const char* what) {
    TreeReceiver receiver(what);
    const std::string clean = without_nan(text, size);
    parse_json(clean.data(), clean.size(), receiver);
    return std::move(receiver.root);
}

}  // namespace mien
