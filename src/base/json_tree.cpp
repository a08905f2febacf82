#include "base/json_tree.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "base/json.hpp"

namespace mien {

/// Receives the parser's events; the open containers are a stack of node numbers.
class JsonTreeBuilder : public StrictJson {
  public:
    JsonTreeBuilder(JsonTree& tree, const char* what) : StrictJson(what), tree_(tree) {}

    bool null() override { return add(JsonTree::Kind::null), true; }
    bool boolean(bool value) override {
        add(JsonTree::Kind::boolean).number = value ? 1.0 : 0.0;
        return true;
    }
    bool number_integer(number_integer_t value) override {
        add(JsonTree::Kind::number).number = static_cast<double>(value);
        return true;
    }
    bool number_unsigned(number_unsigned_t value) override {
        add(JsonTree::Kind::number).number = static_cast<double>(value);
        return true;
    }
    bool number_float(number_float_t value, const string_t&) override {
        add(JsonTree::Kind::number).number = value;
        return true;
    }
    bool string(string_t& text) override {
        const std::uint32_t at = keep(text);
        JsonTree::Node& node = add(JsonTree::Kind::string);
        node.text = at;
        node.text_size = static_cast<std::uint32_t>(text.size());
        return true;
    }
    bool key(string_t& text) override {
        key_ = keep(text);
        key_size_ = static_cast<std::uint32_t>(text.size());
        return true;
    }
    bool start_object(std::size_t) override { return open(JsonTree::Kind::object); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(JsonTree::Kind::array); }
    bool end_array() override { return close(); }

  private:
    struct Open {
        std::uint32_t node, last;
    };

    std::uint32_t keep(const std::string& text) {
        const std::size_t at = tree_.texts_.size();
        if (at + text.size() > std::numeric_limits<std::uint32_t>::max()) refuse("so much text");
        tree_.texts_ += text;
        return static_cast<std::uint32_t>(at);
    }

    JsonTree::Node& add(JsonTree::Kind kind) {
        const auto number = static_cast<std::uint32_t>(tree_.nodes_.size());
        if (number == JsonTree::kNone) refuse("so many values");
        tree_.nodes_.emplace_back();
        tree_.nodes_.back().kind = kind;
        tree_.nodes_.back().key = key_;
        tree_.nodes_.back().key_size = key_size_;
        key_size_ = 0;
        if (!open_.empty()) {
            Open& parent = open_.back();
            if (parent.last == JsonTree::kNone)
                tree_.nodes_[parent.node].first = number;
            else
                tree_.nodes_[parent.last].next = number;
            parent.last = number;
        }
        return tree_.nodes_.back();
    }

    bool open(JsonTree::Kind kind) {
        const auto number = static_cast<std::uint32_t>(tree_.nodes_.size());
        add(kind);
        open_.push_back({number, JsonTree::kNone});
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    JsonTree& tree_;
    std::vector<Open> open_;
    std::uint32_t key_ = 0, key_size_ = 0;
};

JsonTree::JsonTree(const char* text, std::size_t size, const char* what) : what_(what) {
    JsonTreeBuilder builder(*this, what);
    parse_json(text, size, builder);
    if (nodes_.empty()) fail(Status::bad_format, "%s: no JSON value", what);
}

JsonTree::Value JsonTree::Value::operator[](const char* key) const {
    if (!is(Kind::object)) return Value();
    const std::size_t size = std::strlen(key);
    for (std::uint32_t at = node().first; at != kNone; at = tree_->nodes_[at].next) {
        const Node& member = tree_->nodes_[at];
        if (member.key_size == size && tree_->texts_.compare(member.key, size, key) == 0)
            return Value(tree_, at);
    }
    return Value();
}

std::vector<JsonTree::Value> JsonTree::Value::items() const {
    std::vector<Value> all;
    if (!is(Kind::array) && !is(Kind::object)) return all;
    for (std::uint32_t at = node().first; at != kNone; at = tree_->nodes_[at].next)
        all.push_back(Value(tree_, at));
    return all;
}

std::string JsonTree::Value::key() const {
    return exists() ? tree_->texts_.substr(node().key, node().key_size) : std::string();
}

void JsonTree::Value::refuse(const char* what, const char* expected) const {
    fail(Status::bad_format, "%s: %s is %s", exists() ? tree_->what_ : "JSON", what,
         exists() ? expected : "missing");
}

double JsonTree::Value::number(const char* what) const {
    if (!is(Kind::number)) refuse(what, "not a number");
    return node().number;
}

double JsonTree::Value::number(const char* what, double otherwise) const {
    return exists() ? number(what) : otherwise;
}

std::uint64_t JsonTree::Value::count(const char* what) const {
    constexpr double kMost = 9007199254740992.0;
    const double value = number(what);
    if (!(value >= 0.0 && value <= kMost && value == std::floor(value)))
        refuse(what, "not a whole number from 0 on");
    return static_cast<std::uint64_t>(value);
}

std::uint64_t JsonTree::Value::count(const char* what, std::uint64_t otherwise) const {
    return exists() ? count(what) : otherwise;
}

std::string JsonTree::Value::text(const char* what) const {
    if (!is(Kind::string)) refuse(what, "not a text");
    return tree_->texts_.substr(node().text, node().text_size);
}

std::string JsonTree::Value::text(const char* what, const char* otherwise) const {
    return exists() ? text(what) : std::string(otherwise);
}

bool JsonTree::Value::boolean(const char* what, bool otherwise) const {
    if (!exists()) return otherwise;
    if (!is(Kind::boolean)) refuse(what, "neither true nor false");
    return node().number != 0.0;
}

}  // namespace mien
