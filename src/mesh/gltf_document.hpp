// glTF 2.0 files below the level of meshes: the GLB container or JSON text, buffers and accessors.
// Khronos Group, glTF 2.0 specification, chapters 3.6 (binary data) and 4 (GLB).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "mesh/formats.hpp"

namespace mien::formats {

/// A name or text of a file in an image or buffer: "data:...;base64,...". False for another URI.
bool decode_data_uri(const std::string& uri, std::string& bytes);

/// "a%20b.png" -> "a b.png".
std::string decode_percent(const std::string& uri);

class GltfDocument {
  public:
    /// Throws Status::bad_format; io when a buffer's file is not beside the document.
    GltfDocument(const Source& source, const Context& context);

    JsonTree::Value root() const { return json_->root(); }
    /// The element of one of the document's lists ("meshes", "accessors", ...). Throws
    /// Status::bad_format for an index past its end.
    JsonTree::Value at(const char* list, std::uint64_t index) const;
    std::uint64_t size_of(const char* list) const;

    /// An accessor's values as #count x `columns`: integers as they are or, when normalized, as
    /// 0..1 or -1..1; sparse ones are filled in. `expected_count` is the number that other arrays
    /// ask for (0: any, and then it must have a buffer).
    std::vector<float> numbers(std::uint64_t accessor, int columns,
                               std::uint64_t expected_count) const;
    /// The same of float values for all types with 3 and 4 columns, of which the first 3 are given.
    std::vector<float> colors(std::uint64_t accessor, std::uint64_t expected_count) const;
    std::vector<std::uint32_t> indices(std::uint64_t accessor) const;
    std::uint64_t count_of(std::uint64_t accessor) const;

    struct Span {
        const char* data = nullptr;
        std::size_t size = 0, stride = 0;
    };
    Span buffer_view(std::uint64_t index) const;

    std::size_t file_size() const { return file_size_; }

  private:
    struct Layout;
    Layout layout_of(std::uint64_t accessor) const;
    void fill_sparse(JsonTree::Value sparse, const Layout& layout,
                     std::vector<float>& values) const;
    void take_buffers(const Source& source, const Context& context);

    std::unique_ptr<JsonTree> json_;
    std::vector<std::vector<JsonTree::Value>> lists_;
    std::vector<FileBytes> buffers_;
    FileBytes chunk_;  ///< the binary chunk of a GLB
    std::size_t file_size_ = 0;
};

}  // namespace mien::formats
