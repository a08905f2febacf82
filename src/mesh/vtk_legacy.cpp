// VTK PolyData, legacy format: ASCII or BINARY (big-endian), cells of version 5 (OFFSETS and
// CONNECTIVITY) and before. https://docs.vtk.org, "VTK File Formats".
#include <algorithm>

#include "base/error.hpp"
#include "base/json.hpp"
#include "mesh/vtk_arrays.hpp"

namespace mien::formats {
namespace {

bool is_little_endian() {
    const std::uint16_t one = 1;
    char first = 0;
    std::memcpy(&first, &one, 1);
    return first == 1;
}

class LegacyReader {
  public:
    LegacyReader(const Source& source, const Context& context)
        : text_(source.bytes.data, source.bytes.data + source.bytes.size), context_(context) {}

    TriMesh read() {
        text_.skip_line();  // the version
        text_.skip_line();  // a title
        const std::string encoding = ply_lower_case(word());
        if (encoding != "ascii" && encoding != "binary")
            fail_line("neither ASCII nor BINARY but", encoding);
        binary_ = encoding == "binary";
        while (next_keyword()) {
            context_.check_cancelled();
            read_section();
        }
        return data_.finish();
    }

  private:
    [[noreturn]] void fail_line(const char* what, const std::string& found) const {
        fail_at(Status::bad_format, text_.line(), "VTK file, line %lld: %s '%s'",
                static_cast<long long>(text_.line()), what, shown_name(found).c_str());
    }

    std::string word() {
        text_.skip_space();
        const char* begin = nullptr;
        std::size_t size = 0;
        text_.word(begin, size);
        if (size == 0 && !text_.at_end()) fail_line("a control character after", keyword_);
        return std::string(begin, size);
    }
    bool next_keyword() {
        keyword_ = ply_lower_case(word());
        return !keyword_.empty();
    }
    std::size_t count() {
        std::int64_t value = 0;
        text_.skip_space();
        if (!text_.integer(value) || value < 0) fail_line("a count belongs after", keyword_);
        return static_cast<std::size_t>(value);
    }
    VtkType type() {
        VtkType type;
        const std::string name = word();
        if (!parse_vtk_type(name, type)) fail_line("unknown type", name);
        return type;
    }

    /// `count` values; binary ones begin on the next line. Held against the file's size first.
    std::vector<double> values(std::size_t count, const VtkType& type) {
        const std::size_t least = binary_ ? type.bytes() : 1;
        if (binary_) text_.skip_line();
        if (count > text_.remaining() / least + 1 || count * least > text_.remaining() + 1)
            fail_line("more values than the file holds in", keyword_);
        context_.require_memory(8 * count, "a VTK file's values");
        std::vector<double> all(count);
        if (!binary_) {
            for (double& value : all) {
                text_.skip_space();
                if (!text_.number(value)) fail_line("not a number in", keyword_);
            }
            return all;
        }
        if (count * least > text_.remaining()) fail_line("the file ends within", keyword_);
        const char* raw = text_.at();
        for (std::size_t k = 0; k < count; ++k)
            all[k] = load_vtk(raw + k * least, type, is_little_endian());
        text_.advance(count * least);
        return all;
    }

    void read_section() {
        if (keyword_ == "dataset") {
            const std::string kind = word();
            if (ply_lower_case(kind) != "polydata") fail_line("only POLYDATA is read, not", kind);
        } else if (keyword_ == "points") {
            const std::size_t number = count();
            const VtkType kind = type();
            if (number > text_.remaining())
                fail_line("more points than the file holds in", keyword_);
            data_.points = values(3 * number, kind);
        } else if (keyword_ == "polygons" || keyword_ == "triangle_strips" || keyword_ == "lines" ||
                   keyword_ == "vertices") {
            read_cells();
        } else if (keyword_ == "point_data" || keyword_ == "cell_data") {
            of_points_ = keyword_ == "point_data";
            num_tuples_ = count();
        } else if (keyword_ == "metadata") {
            // Until an empty line, in both encodings.
            text_.skip_line();
            for (text_.skip_blanks(); !text_.at_line_end(); text_.skip_blanks()) text_.skip_line();
        } else {
            read_attribute();
        }
    }

    void read_cells() {
        const std::string kind = keyword_;
        const std::size_t first = count(), second = count();
        std::vector<double> offsets, connectivity;
        // What follows may be bytes already: looked at without being read.
        TextCursor line = text_;
        line.skip_line();
        const std::string word_there(line.at(), std::min<std::size_t>(line.remaining(), 7));
        if (ply_lower_case(word_there) == "offsets") {
            keyword_ = ply_lower_case(word());
            const VtkType offset_type = type();
            offsets = values(first, offset_type);
            if (!next_keyword() || keyword_ != "connectivity")
                fail_line("CONNECTIVITY belongs here, not", keyword_);
            const VtkType number_type = type();
            connectivity = values(second, number_type);
            if (!offsets.empty()) offsets.erase(offsets.begin());
        } else {
            const std::vector<double> all = values(second, VtkType{PlyType::i32});
            for (std::size_t at = 0; at < all.size();) {
                const double length = all[at++];
                if (!(length >= 0.0 && length <= static_cast<double>(all.size() - at)))
                    fail_line("a cell is longer than the list in", kind);
                const auto end = at + static_cast<std::size_t>(length);
                for (; at < end; ++at) connectivity.push_back(all[at]);
                offsets.push_back(static_cast<double>(connectivity.size()));
            }
        }
        if (kind == "polygons" || kind == "triangle_strips")
            data_.add_cells(offsets, connectivity, kind == "triangle_strips");
    }

    void take(const std::string& name, const VtkType& kind, std::size_t columns, std::size_t tuples,
              bool texture, bool color) {
        if (columns != 0 && tuples > text_.remaining() / columns + 1)
            fail_line("more values than the file holds in", keyword_);
        const std::vector<double> all = values(columns * tuples, kind);
        if (of_points_) data_.add_point_array(name, kind, columns, all, texture, color);
    }

    void read_attribute() {
        if (keyword_ == "scalars") {
            const std::string name = word();
            const VtkType kind = type();
            std::size_t columns = 1;
            text_.skip_blanks();
            if (!text_.at_line_end()) columns = count();
            const TextCursor before = text_;
            if (ply_lower_case(word()) == "lookup_table")
                word();
            else
                text_ = before;
            take(name, kind, columns, num_tuples_, false, false);
        } else if (keyword_ == "color_scalars") {
            const std::string name = word();
            const std::size_t columns = count();
            take(name, VtkType{binary_ ? PlyType::u8 : PlyType::f32}, columns, num_tuples_, false,
                 true);
        } else if (keyword_ == "texture_coordinates") {
            const std::string name = word();
            const std::size_t columns = count();
            take(name, type(), columns, num_tuples_, true, false);
        } else if (keyword_ == "normals" || keyword_ == "vectors") {
            const std::string name = word();
            take(name, type(), 3, num_tuples_, false, false);
        } else if (keyword_ == "tensors") {
            const std::string name = word();
            take(name, type(), 9, num_tuples_, false, false);
        } else if (keyword_ == "lookup_table") {
            const std::string name = word();
            take(std::string(), VtkType{binary_ ? PlyType::u8 : PlyType::f32}, 4, count(), false,
                 false);
        } else if (keyword_ == "field") {
            read_field();
        } else {
            fail_line("unknown keyword", keyword_);
        }
    }

    void read_field() {
        word();  // its name
        for (std::size_t left = count(); left != 0; --left) {
            if (text_.at_end()) fail_line("the file ends within", "FIELD");
            const std::string name = word();
            if (ply_lower_case(name) == "metadata") {
                keyword_ = "metadata";
                read_section();
                ++left;
                continue;
            }
            const std::size_t columns = count(), tuples = count();
            const VtkType kind = type();
            take(name, kind, columns, tuples, false, false);
        }
    }

    TextCursor text_;
    const Context& context_;
    std::string keyword_;
    bool binary_ = false, of_points_ = false;
    std::size_t num_tuples_ = 0;
    VtkPolyData data_;
};

}  // namespace

TriMesh read_vtk(const Source& source, const Context& context) {
    return LegacyReader(source, context).read();
}

}  // namespace mien::formats
