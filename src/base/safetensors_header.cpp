#include "base/safetensors_header.hpp"

#include <set>

#include "base/error.hpp"
#include "base/json.hpp"

namespace mien {
namespace {

constexpr const char* kWhat = "safetensors header";
/// More is no tensor, but an attempt to make the reader work.
constexpr std::size_t kMostDimensions = 16;

/// A machine of five places; whatever does not fit its place is refused, so nesting is bounded.
class HeaderReceiver : public StrictJson {
  public:
    explicit HeaderReceiver(SafetensorsHeader& header) : StrictJson(kWhat), header_(header) {}

    bool start_object(std::size_t) override {
        if (place_ == Place::start) {
            place_ = Place::top;
        } else if (place_ == Place::top) {
            const bool is_metadata = key_ == "__metadata__";
            if (!names_.insert(key_).second)
                fail(Status::bad_format, "%s: '%s' occurs twice", kWhat, shown_name(key_).c_str());
            place_ = is_metadata ? Place::metadata : Place::tensor;
            if (!is_metadata) {
                header_.entries.emplace_back();
                header_.entries.back().name = key_;
            }
            has_dtype_ = has_shape_ = has_offsets_ = false;
            key_.clear();
        } else {
            refuse("an object");
        }
        return true;
    }

    bool key(string_t& text) override {
        key_ = text;
        return true;
    }

    bool end_object() override {
        if (place_ == Place::tensor && !(has_dtype_ && has_shape_ && has_offsets_))
            fail(Status::bad_format, "%s: tensor '%s' lacks dtype, shape or data_offsets", kWhat,
                 shown_name(entry().name).c_str());
        place_ = place_ == Place::top ? Place::end : Place::top;
        return true;
    }

    bool string(string_t& text) override {
        if (place_ == Place::metadata) {
            if (!header_.metadata.emplace(key_, text).second)
                fail(Status::bad_format, "%s: metadata key '%s' occurs twice", kWhat,
                     shown_name(key_).c_str());
        } else if (place_ == Place::tensor && key_ == "dtype") {
            once(has_dtype_);
            entry().dtype = text;
        } else {
            refuse("a string");
        }
        return true;
    }

    bool start_array(std::size_t) override {
        if (place_ != Place::tensor) refuse("a list");
        if (key_ == "shape") {
            once(has_shape_);
        } else if (key_ == "data_offsets") {
            once(has_offsets_);
        } else {
            refuse("a list");
        }
        place_ = Place::list;
        num_offsets_ = 0;
        return true;
    }

    bool end_array() override {
        if (key_ == "data_offsets" && num_offsets_ != 2)
            fail(Status::bad_format, "%s: tensor '%s' needs two data_offsets", kWhat,
                 shown_name(entry().name).c_str());
        place_ = Place::tensor;
        return true;
    }

    bool number_unsigned(number_unsigned_t value) override {
        if (place_ != Place::list) refuse("a number");
        if (key_ == "shape") {
            if (entry().shape.size() == kMostDimensions)
                fail(Status::bad_format, "%s: tensor '%s' has more than %zu dimensions", kWhat,
                     shown_name(entry().name).c_str(), kMostDimensions);
            entry().shape.push_back(value);
        } else {
            if (num_offsets_ < 2) (num_offsets_ == 0 ? entry().begin : entry().end) = value;
            if (++num_offsets_ > 2) refuse("a third data offset");
        }
        return true;
    }

  private:
    enum class Place { start, top, metadata, tensor, list, end };

    SafetensorsEntry& entry() { return header_.entries.back(); }
    void once(bool& seen) {
        if (seen)
            fail(Status::bad_format, "%s: tensor '%s' has '%s' twice", kWhat,
                 shown_name(entry().name).c_str(), shown_name(key_).c_str());
        seen = true;
    }

    SafetensorsHeader& header_;
    std::set<std::string> names_;
    std::string key_;
    Place place_ = Place::start;
    bool has_dtype_ = false, has_shape_ = false, has_offsets_ = false;
    int num_offsets_ = 0;
};

}  // namespace

SafetensorsHeader parse_safetensors_header(const char* text, std::size_t size) {
    SafetensorsHeader header;
    HeaderReceiver receiver(header);
    parse_json(text, size, receiver);
    return header;
}

}  // namespace mien
