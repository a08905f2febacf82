#include "mesh/gltf_document.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "base/json.hpp"
#include "mesh/companions.hpp"

namespace mien::formats {
namespace {

constexpr const char* kWhat = "glTF";
constexpr const char* kLists[] = {"accessors", "bufferViews", "buffers", "images",  "materials",
                                  "meshes",    "nodes",       "scenes",  "textures"};

std::uint32_t little32(const char* p) {
    const auto* raw = reinterpret_cast<const unsigned char*>(p);
    return std::uint32_t(raw[0]) | std::uint32_t(raw[1]) << 8 | std::uint32_t(raw[2]) << 16 |
           std::uint32_t(raw[3]) << 24;
}

int base64_value(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    if (c == '/' || c == '_') return 63;
    return -1;
}

/// The value at `p`; integers of a normalized accessor become fractions of their largest.
float component(const char* p, int type, bool normalized) {
    const auto fraction = [&](auto value, float largest) {
        const float number = static_cast<float>(value);
        return normalized ? std::max(number / largest, -1.f) : number;
    };
    const auto load = [&](auto value) {
        std::memcpy(&value, p, sizeof value);
        return value;
    };
    switch (type) {
        case 5120:
            return fraction(load(std::int8_t()), 127.f);
        case 5121:
            return fraction(load(std::uint8_t()), 255.f);
        case 5122:
            return fraction(load(std::int16_t()), 32767.f);
        case 5123:
            return fraction(load(std::uint16_t()), 65535.f);
        case 5125:
            return static_cast<float>(load(std::uint32_t()));
        default:
            return load(float());
    }
}

std::size_t bytes_of_component(std::uint64_t type) {
    switch (type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            fail(Status::bad_format, "glTF: an accessor has the unknown component type %llu",
                 static_cast<unsigned long long>(type));
    }
}

std::size_t columns_of_type(const std::string& type) {
    static const struct {
        const char* name;
        std::size_t columns;
    } kTypes[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                  {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& entry : kTypes)
        if (type == entry.name) return entry.columns;
    fail(Status::bad_format, "glTF: an accessor has the unknown type '%s'",
         shown_name(type).c_str());
}

std::uint32_t read_index(const char* p, int type) {
    std::uint32_t value = 0;
    if (type == 5121) return static_cast<unsigned char>(*p);
    if (type == 5123) {
        std::uint16_t small = 0;
        std::memcpy(&small, p, sizeof small);
        return small;
    }
    if (type != 5125) fail(Status::bad_format, "glTF: indices are not unsigned integers");
    std::memcpy(&value, p, sizeof value);
    return value;
}

}  // namespace

bool decode_data_uri(const std::string& uri, std::string& bytes) {
    const std::size_t comma = uri.find(',');
    if (uri.compare(0, 5, "data:") != 0 || comma == std::string::npos ||
        uri.rfind(";base64", comma) == std::string::npos)
        return false;
    bytes.clear();
    bytes.reserve((uri.size() - comma) / 4 * 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (std::size_t k = comma + 1; k < uri.size() && uri[k] != '='; ++k) {
        const int value = base64_value(uri[k]);
        if (value < 0) fail(Status::bad_format, "glTF: a data URI is no base64 text");
        bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xffffffu;
        if ((count += 6) < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xffu);
    }
    return true;
}

std::string decode_percent(const std::string& uri) {
    const auto digit = [](char c) {
        if (c >= '0' && c <= '9') return c - '0';
        const char lower = static_cast<char>(c | 0x20);
        return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
    };
    std::string text;
    for (std::size_t k = 0; k < uri.size(); ++k) {
        const bool coded =
            uri[k] == '%' && k + 2 < uri.size() && digit(uri[k + 1]) >= 0 && digit(uri[k + 2]) >= 0;
        text += coded ? static_cast<char>(16 * digit(uri[k + 1]) + digit(uri[k + 2])) : uri[k];
        if (coded) k += 2;
    }
    return text;
}

struct GltfDocument::Layout {
    Span span;  ///< of the elements; null data: zeros
    std::uint64_t count = 0;
    std::size_t columns = 0, component_bytes = 0;
    int component_type = 0;
    bool normalized = false;
    JsonTree::Value sparse;
    explicit Layout(JsonTree::Value s) : sparse(s) {}
};

GltfDocument::GltfDocument(const Source& source, const Context& context)
    : file_size_(source.bytes.size) {
    const char* data = source.bytes.data;
    const std::size_t size = source.bytes.size;
    const char* text = data;
    std::size_t text_size = size;
    if (size >= 4 && std::memcmp(data, "glTF", 4) == 0) {
        if (size < 20) fail(Status::bad_format, "the GLB file ends within its header");
        if (little32(data + 4) != 2)
            fail(Status::bad_format, "a GLB file of version %lu; version 2 is read",
                 static_cast<unsigned long>(little32(data + 4)));
        const std::size_t length = little32(data + 8), json_size = little32(data + 12);
        if (length > size || json_size > size - 20)
            fail(Status::bad_format, "the GLB file promises %zu bytes, it has %zu", length, size);
        if (std::memcmp(data + 16, "JSON", 4) != 0)
            fail(Status::bad_format, "the GLB file does not begin with its JSON chunk");
        text = data + 20;
        text_size = json_size;
        const std::size_t next = 20 + json_size;
        if (length >= next + 8 && std::memcmp(data + next + 4, "BIN\0", 4) == 0) {
            chunk_.size = little32(data + next);
            if (chunk_.size > length - next - 8)
                fail(Status::bad_format, "the GLB file ends within its binary chunk");
            chunk_.data = data + next + 8;
            chunk_.storage = source.bytes.storage;
        }
    } else if (size >= 3 && std::memcmp(data, "\xef\xbb\xbf", 3) == 0) {
        text += 3;
        text_size -= 3;
    }
    while (text_size != 0 && (text[text_size - 1] == '\0' || text[text_size - 1] == ' '))
        --text_size;
    context.require_memory(20 * text_size, "a glTF document");
    json_ = std::make_unique<JsonTree>(text, text_size, kWhat);
    const std::string version = root()["asset"]["version"].text("asset.version");
    if (version.compare(0, 2, "2.") != 0)
        fail(Status::bad_format, "a glTF document of version %s; version 2 is read",
             shown_name(version).c_str());
    for (const char* name : kLists) lists_.push_back(root()[name].items());
    take_buffers(source, context);
}

void GltfDocument::take_buffers(const Source& source, const Context& context) {
    for (std::uint64_t k = 0; k < size_of("buffers"); ++k) {
        const JsonTree::Value buffer = at("buffers", k);
        const std::uint64_t length = buffer["byteLength"].count("buffers.byteLength");
        FileBytes bytes;
        if (!buffer["uri"].exists()) {
            bytes = chunk_;
        } else {
            const std::string uri = buffer["uri"].text("buffers.uri");
            auto decoded = std::make_shared<std::string>();
            if (decode_data_uri(uri, *decoded)) {
                bytes.data = decoded->data();
                bytes.size = decoded->size();
                bytes.storage = std::move(decoded);
            } else if (!read_companion(source, decode_percent(uri), bytes, context)) {
                fail(Status::io, "the glTF document's buffer '%s' is not beside it",
                     shown_name(uri).c_str());
            }
        }
        if (bytes.size < length)
            fail(Status::bad_format, "glTF: buffer %llu promises %llu bytes and has %zu",
                 static_cast<unsigned long long>(k), static_cast<unsigned long long>(length),
                 bytes.size);
        bytes.size = static_cast<std::size_t>(length);
        file_size_ = std::max(file_size_, bytes.size);
        buffers_.push_back(std::move(bytes));
    }
}

std::uint64_t GltfDocument::size_of(const char* list) const {
    for (std::size_t k = 0; k < lists_.size(); ++k)
        if (std::strcmp(kLists[k], list) == 0) return lists_[k].size();
    return 0;
}

JsonTree::Value GltfDocument::at(const char* list, std::uint64_t index) const {
    for (std::size_t k = 0; k < lists_.size(); ++k)
        if (std::strcmp(kLists[k], list) == 0 && index < lists_[k].size())
            return lists_[k][static_cast<std::size_t>(index)];
    fail(Status::bad_format, "glTF: something names element %llu of '%s', which has %llu",
         static_cast<unsigned long long>(index), list,
         static_cast<unsigned long long>(size_of(list)));
}

GltfDocument::Span GltfDocument::buffer_view(std::uint64_t index) const {
    const JsonTree::Value view = at("bufferViews", index);
    const std::uint64_t buffer = view["buffer"].count("bufferViews.buffer");
    const std::uint64_t offset = view["byteOffset"].count("bufferViews.byteOffset", 0);
    const std::uint64_t length = view["byteLength"].count("bufferViews.byteLength");
    at("buffers", buffer);
    const FileBytes& bytes = buffers_[static_cast<std::size_t>(buffer)];
    if (offset > bytes.size || length > bytes.size - offset)
        fail(Status::bad_format, "glTF: buffer view %llu runs past the end of its buffer",
             static_cast<unsigned long long>(index));
    Span span;
    span.data = bytes.data + offset;
    span.size = static_cast<std::size_t>(length);
    span.stride = static_cast<std::size_t>(view["byteStride"].count("bufferViews.byteStride", 0));
    return span;
}

std::uint64_t GltfDocument::count_of(std::uint64_t accessor) const {
    return at("accessors", accessor)["count"].count("accessors.count");
}

GltfDocument::Layout GltfDocument::layout_of(std::uint64_t index) const {
    const JsonTree::Value accessor = at("accessors", index);
    Layout layout(accessor["sparse"]);
    const std::uint64_t type = accessor["componentType"].count("accessors.componentType");
    layout.component_bytes = bytes_of_component(type);
    layout.component_type = static_cast<int>(type);
    layout.columns = columns_of_type(accessor["type"].text("accessors.type"));
    layout.count = accessor["count"].count("accessors.count");
    layout.normalized = accessor["normalized"].boolean("accessors.normalized", false);
    if (!accessor["bufferView"].exists()) return layout;
    layout.span = buffer_view(accessor["bufferView"].count("accessors.bufferView"));
    const std::uint64_t offset = accessor["byteOffset"].count("accessors.byteOffset", 0);
    const std::size_t row = layout.columns * layout.component_bytes;
    if (layout.span.stride == 0) layout.span.stride = row;
    const std::uint64_t size = layout.span.size;
    const bool fits =
        layout.span.stride >= row && offset <= size &&
        (layout.count == 0 ||
         (row <= size - offset && layout.count - 1 <= (size - offset - row) / layout.span.stride));
    if (!fits)
        fail(Status::bad_format, "glTF: accessor %llu runs past the end of its buffer view",
             static_cast<unsigned long long>(index));
    layout.span.data += offset;
    return layout;
}

std::vector<float> GltfDocument::numbers(std::uint64_t accessor, int columns,
                                         std::uint64_t expected_count) const {
    const Layout layout = layout_of(accessor);
    if (layout.columns != static_cast<std::size_t>(columns))
        fail(Status::bad_format, "glTF: accessor %llu has %zu numbers an element, not %d",
             static_cast<unsigned long long>(accessor), layout.columns, columns);
    if (expected_count != 0 ? layout.count != expected_count : layout.span.data == nullptr)
        fail(Status::bad_format, "glTF: accessor %llu has %llu elements where %llu belong",
             static_cast<unsigned long long>(accessor),
             static_cast<unsigned long long>(layout.count),
             static_cast<unsigned long long>(expected_count));
    std::vector<float> values(static_cast<std::size_t>(layout.count) * layout.columns, 0.f);
    if (layout.span.data != nullptr)
        for (std::size_t i = 0; i < static_cast<std::size_t>(layout.count); ++i)
            for (std::size_t k = 0; k < layout.columns; ++k)
                values[i * layout.columns + k] = component(
                    layout.span.data + i * layout.span.stride + k * layout.component_bytes,
                    layout.component_type, layout.normalized);
    if (layout.sparse.exists()) fill_sparse(layout.sparse, layout, values);
    return values;
}

void GltfDocument::fill_sparse(JsonTree::Value sparse, const Layout& layout,
                               std::vector<float>& values) const {
    const std::uint64_t count = sparse["count"].count("sparse.count");
    const JsonTree::Value numbers = sparse["indices"], places = sparse["values"];
    const std::uint64_t type = numbers["componentType"].count("sparse.indices.componentType");
    const std::size_t index_bytes = bytes_of_component(type);
    const auto span_of = [&](JsonTree::Value part, std::size_t row) {
        Span span = buffer_view(part["bufferView"].count("sparse.bufferView"));
        const std::uint64_t offset = part["byteOffset"].count("sparse.byteOffset", 0);
        if (offset > span.size || count > (span.size - offset) / row)
            fail(Status::bad_format, "glTF: a sparse accessor runs past its buffer view");
        span.data += offset;
        return span;
    };
    const std::size_t row = layout.columns * layout.component_bytes;
    const Span at = span_of(numbers, index_bytes), from = span_of(places, row);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const std::uint32_t to = read_index(at.data + i * index_bytes, static_cast<int>(type));
        if (to >= layout.count)
            fail(Status::bad_format, "glTF: a sparse accessor replaces element %lu of %llu",
                 static_cast<unsigned long>(to), static_cast<unsigned long long>(layout.count));
        for (std::size_t k = 0; k < layout.columns; ++k)
            values[to * layout.columns + k] =
                component(from.data + i * row + k * layout.component_bytes, layout.component_type,
                          layout.normalized);
    }
}

std::vector<float> GltfDocument::colors(std::uint64_t accessor,
                                        std::uint64_t expected_count) const {
    if (layout_of(accessor).columns == 3) return numbers(accessor, 3, expected_count);
    const std::vector<float> all = numbers(accessor, 4, expected_count);
    std::vector<float> values;
    values.reserve(all.size() / 4 * 3);
    for (std::size_t i = 0; i < all.size(); i += 4)
        for (std::size_t k = 0; k < 3; ++k) values.push_back(all[i + k]);
    return values;
}

std::vector<std::uint32_t> GltfDocument::indices(std::uint64_t accessor) const {
    const Layout layout = layout_of(accessor);
    if (layout.columns != 1 || layout.span.data == nullptr || layout.sparse.exists())
        fail(Status::bad_format, "glTF: accessor %llu is no plain list of indices",
             static_cast<unsigned long long>(accessor));
    std::vector<std::uint32_t> values(static_cast<std::size_t>(layout.count));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = read_index(layout.span.data + i * layout.span.stride, layout.component_type);
    return values;
}

}  // namespace mien::formats
