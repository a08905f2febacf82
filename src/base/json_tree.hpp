// A JSON document in flat arrays: nothing in it allocates when it is destroyed, so a failed
// allocation ends in an exception and not in the process's end (see base/json.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mien {

class JsonTree {
  public:
    enum class Kind : std::uint8_t { null, boolean, number, string, array, object };

  private:
    friend class JsonTreeBuilder;
    static constexpr std::uint32_t kNone = 0xffffffffu;
    struct Node {
        double number = 0.0;
        std::uint32_t text = 0, text_size = 0;  ///< in texts_
        std::uint32_t key = 0, key_size = 0;
        std::uint32_t first = kNone, next = kNone;
        Kind kind = Kind::null;
    };

  public:
    /// A place in the document, or a place that is not there: its members are not there either.
    class Value {
      public:
        bool exists() const { return tree_ != nullptr; }
        bool is(Kind kind) const { return exists() && node().kind == kind; }
        /// The member of an object; the first of several with one name.
        Value operator[](const char* key) const;
        /// The elements of an array or an object, in order; nothing for other kinds.
        std::vector<Value> items() const;
        std::string key() const;  ///< of an object's member

        /// Each throws Status::bad_format with the document's name and `what` when the value is
        /// there and of another kind; the second form gives `otherwise` when it is not there.
        double number(const char* what) const;
        double number(const char* what, double otherwise) const;
        /// A whole number of 0 to 2^53.
        std::uint64_t count(const char* what) const;
        std::uint64_t count(const char* what, std::uint64_t otherwise) const;
        std::string text(const char* what) const;
        std::string text(const char* what, const char* otherwise) const;
        bool boolean(const char* what, bool otherwise) const;

      private:
        friend class JsonTree;
        Value() = default;
        Value(const JsonTree* tree, std::uint32_t node) : tree_(tree), node_(node) {}
        const Node& node() const { return tree_->nodes_[node_]; }
        [[noreturn]] void refuse(const char* what, const char* expected) const;
        const JsonTree* tree_ = nullptr;
        std::uint32_t node_ = 0;
    };

    /// Throws Status::bad_format with `what` in front when the text is not one JSON value. O(size)
    /// time; 40 bytes a value and the texts.
    JsonTree(const char* text, std::size_t size, const char* what);
    Value root() const { return Value(this, 0); }

  private:
    std::vector<Node> nodes_;
    std::string texts_;
    const char* what_;
};

}  // namespace mien
