// VTK PolyData in XML (.vtp): ascii, binary (base64) and appended arrays (raw or base64), with or
// without zlib. https://docs.vtk.org, "VTK XML File Formats".
#include <algorithm>
#include <map>

#if defined(MIEN_IMAGES)
#include <zlib.h>
#endif

#include "base/error.hpp"
#include "base/json.hpp"
#include "mesh/vtk_arrays.hpp"

namespace mien::formats {
namespace {

/// One tag: its name in lower case ("/piece" for an end) and its attributes.
struct Tag {
    std::string name;
    std::map<std::string, std::string> attributes;
    bool closed = false;  ///< <a/>
    std::string get(const char* key) const {
        const auto found = attributes.find(key);
        return found == attributes.end() ? std::string() : found->second;
    }
};

/// Scans tags one after another; comments and declarations are stepped over.
class TagScanner {
  public:
    TagScanner(const char* begin, const char* end) : at_(begin), end_(end) {}

    bool next(Tag& tag) {
        for (;;) {
            at_ = std::find(at_, end_, '<');
            if (end_ - at_ < 2) return false;
            if (at_[1] != '!' && at_[1] != '?') break;
            const std::string close = end_ - at_ >= 4 && at_[2] == '-' ? "-->" : ">";
            const char* stop = std::search(at_, end_, close.begin(), close.end());
            if (stop == end_) return false;
            at_ = stop + static_cast<std::ptrdiff_t>(close.size());
        }
        ++at_;
        tag = Tag();
        while (at_ != end_ && !is_blank(*at_) && *at_ != '>' && (*at_ != '/' || tag.name.empty()))
            tag.name += *at_++;
        tag.name = ply_lower_case(tag.name);
        for (;;) {
            while (at_ != end_ && is_blank(*at_)) ++at_;
            if (at_ == end_) fail(Status::bad_format, "the XML file ends within a tag");
            if (*at_ == '>') break;
            if (*at_ == '/') {
                tag.closed = true;
                ++at_;
                continue;
            }
            read_attribute(tag);
        }
        ++at_;
        return true;
    }
    const char* at() const { return at_; }
    const char* end() const { return end_; }

  private:
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    void read_attribute(Tag& tag) {
        std::string key;
        while (at_ != end_ && *at_ != '=' && *at_ != '>' && !is_blank(*at_)) key += *at_++;
        while (at_ != end_ && is_blank(*at_)) ++at_;
        if (at_ == end_ || *at_ != '=')
            fail(Status::bad_format, "the XML attribute '%s' has no value",
                 shown_name(key).c_str());
        ++at_;
        while (at_ != end_ && is_blank(*at_)) ++at_;
        if (at_ == end_ || (*at_ != '"' && *at_ != '\''))
            fail(Status::bad_format, "the XML attribute '%s' is not quoted",
                 shown_name(key).c_str());
        const char* stop = std::find(at_ + 1, end_, *at_);
        if (stop == end_) fail(Status::bad_format, "the XML file ends within a tag");
        tag.attributes[ply_lower_case(key)].assign(at_ + 1, stop);
        at_ = stop + 1;
    }

    const char* at_;
    const char* end_;
};

/// Base64 text of whole groups, perhaps several ends of "=" after one another.
class Base64 {
  public:
    Base64(const char* begin, const char* end) : at_(begin), end_(end) {}
    /// The next `count` bytes from a fresh group on.
    std::string take(std::size_t count) {
        if (count / 3 > static_cast<std::size_t>(end_ - at_) / 4 + 1) fail_short();
        std::string bytes;
        bytes.reserve(count + 3);
        while (bytes.size() < count) {
            std::uint32_t bits = 0;
            int padding = 0;
            for (int k = 0; k < 4; ++k) {
                while (at_ != end_ && static_cast<unsigned char>(*at_) <= ' ') ++at_;
                if (at_ == end_) fail_short();
                const int value = value_of(*at_++);
                padding += value < 0 ? 1 : 0;
                bits = bits << 6 | static_cast<std::uint32_t>(value < 0 ? 0 : value);
            }
            for (int k = 0; k < 3 - padding; ++k)
                bytes += static_cast<char>(bits >> (16 - 8 * k) & 0xff);
            if (padding != 0 && bytes.size() < count) fail_short();
        }
        bytes.resize(count);
        return bytes;
    }

  private:
    [[noreturn]] static void fail_short() {
        fail(Status::bad_format, "the VTP file ends within an array");
    }
    static int value_of(char c) {
        if (c >= 'A' && c <= 'Z') return c - 'A';
        if (c >= 'a' && c <= 'z') return c - 'a' + 26;
        if (c >= '0' && c <= '9') return c - '0' + 52;
        if (c == '+') return 62;
        if (c == '/') return 63;
        if (c == '=') return -1;
        fail(Status::bad_format, "a VTP array is no base64 text");
    }
    const char* at_;
    const char* end_;
};

class VtpReader {
  public:
    VtpReader(const Source& source, const Context& context)
        : source_(source), context_(context), size_(source.bytes.size) {}

    TriMesh read() {
        check_end();
        find_appended();
        TagScanner tags(source_.bytes.data, body_end_);
        Tag tag;
        while (tags.next(tag)) {
            context_.check_cancelled();
            if (tag.name == "vtkfile") {
                start_file(tag);
            } else if (tag.name == "piece") {
                first_ = data_.points.size() / 3;
                num_points_ = static_cast<std::size_t>(whole(tag.get("numberofpoints")));
            } else if (tag.name == "/piece") {
                end_piece();
            } else if (tag.name == "dataarray") {
                read_array(tag, tags);
            } else if (!tag.name.empty() && tag.name[0] != '/') {
                section_ = tag.name;
                if (section_ == "pointdata") {
                    texture_name_ = tag.get("tcoords");
                    color_name_ = tag.get("scalars");
                }
            } else if (tag.name == "/pointdata" || tag.name == "/celldata") {
                section_.clear();
            }
        }
        if (data_.colors.size() != data_.points.size()) data_.colors.clear();
        if (3 * data_.texture.size() != 2 * data_.points.size()) data_.texture.clear();
        return data_.finish();
    }

  private:
    static double whole(const std::string& text) {
        double value = 0.0;
        TextCursor cursor(text.data(), text.data() + text.size());
        cursor.skip_space();
        if (!cursor.number(value) || !(value >= 0.0 && value < 1e15) || value != std::floor(value))
            fail(Status::bad_format, "'%s' is no count in a VTP file", shown_name(text).c_str());
        return value;
    }

    /// A file that was cut between two pieces would be read as a smaller mesh.
    void check_end() const {
        const char *const begin = source_.bytes.data, *const end = begin + size_;
        const char* last = end;
        while (last != begin && *(last - 1) != '<') --last;
        static constexpr std::ptrdiff_t kName = 8;  // what stands behind the last <
        if (last == begin || end - last < kName ||
            ply_lower_case(std::string(last, last + kName)) != "/vtkfile")
            fail(Status::bad_format, "the VTP file does not end with </VTKFile>: it was cut short");
    }

    /// Raw appended data may hold anything, also what looks like a tag: the tags end before it.
    void find_appended() {
        const char* end = source_.bytes.data + size_;
        body_end_ = end;
        const std::string word = "<AppendedData";
        const char* at = std::search(source_.bytes.data, end, word.begin(), word.end());
        if (at == end) return;
        body_end_ = at;
        TagScanner scanner(at, end);
        Tag tag;
        if (!scanner.next(tag)) return;
        appended_raw_ = ply_lower_case(tag.get("encoding")) == "raw";
        const char* begin = std::find(scanner.at(), end, '_');
        if (begin == end) return;
        appended_ = begin + 1;
        const std::string close = "</AppendedData>";
        appended_end_ =
            appended_raw_ ? end : std::search(appended_, end, close.begin(), close.end());
    }

    void start_file(const Tag& tag) {
        const std::string type = tag.get("type");
        if (ply_lower_case(type) != "polydata")
            fail(Status::bad_format, "a VTK XML file of type '%s'; PolyData is read",
                 shown_name(type).c_str());
        const std::uint16_t one = 1;
        char first = 0;
        std::memcpy(&first, &one, 1);
        swapped_ = (ply_lower_case(tag.get("byte_order")) == "bigendian") == (first == 1);
        wide_header_ = ply_lower_case(tag.get("header_type")) == "uint64";
        const std::string compressor = tag.get("compressor");
        compressed_ = !compressor.empty();
        if (compressed_ && compressor != "vtkZLibDataCompressor")
            fail(Status::bad_format, "a VTP file compressed by '%s'; zlib is read, or none",
                 shown_name(compressor).c_str());
    }

    std::uint64_t header_value(const std::string& bytes, std::size_t number) const {
        const std::size_t size = wide_header_ ? 8 : 4;
        return wide_header_ ? load_ply<std::uint64_t>(bytes.data() + size * number, swapped_)
                            : load_ply<std::uint32_t>(bytes.data() + size * number, swapped_);
    }

    /// The bytes of an array whose encoded form `take` serves in order.
    template <typename Take>
    std::string unpack(Take&& take) {
        const std::size_t word = wide_header_ ? 8 : 4;
        if (!compressed_) {
            const std::uint64_t count = header_value(take(word, true), 0);
            return take_after(take, word, count);
        }
        const std::uint64_t blocks = header_value(take(word, true), 0);
        if (blocks > size_) fail(Status::bad_format, "a VTP array has more blocks than the file");
        // The header is one run of base64 of its own; asked for again in full.
        const std::string header = take(word * static_cast<std::size_t>(3 + blocks), true);
        const std::uint64_t block = header_value(header, 1), last = header_value(header, 2);
        std::uint64_t packed = 0;
        for (std::uint64_t k = 0; k < blocks; ++k) {
            const std::uint64_t size = header_value(header, static_cast<std::size_t>(3 + k));
            if (size > size_) fail(Status::bad_format, "the VTP file ends within an array");
            packed += size;
        }
        if (packed > size_) fail(Status::bad_format, "the VTP file ends within an array");
        const std::string data = take(static_cast<std::size_t>(packed), false);
        std::string bytes;
        std::size_t at = 0;
        for (std::uint64_t k = 0; k < blocks; ++k) {
            const auto size =
                static_cast<std::size_t>(header_value(header, static_cast<std::size_t>(3 + k)));
            const std::uint64_t whole = k + 1 == blocks && last != 0 ? last : block;
            inflate_block(data.data() + at, size, whole, bytes);
            at += size;
        }
        return bytes;
    }

    template <typename Take>
    std::string take_after(Take&& take, std::size_t word, std::uint64_t count) {
        if (count > size_) fail(Status::bad_format, "the VTP file ends within an array");
        // Without compression header and data are one run.
        return take(word + static_cast<std::size_t>(count), true).substr(word);
    }

    void inflate_block(const char* data, std::size_t size, std::uint64_t whole, std::string& out) {
        // One byte of deflate holds at most 1032 others.
        if (whole > 1032 * std::uint64_t(size) + 64)
            fail(Status::bad_format, "a block of a VTP array promises more than it can hold");
        context_.require_memory(static_cast<std::size_t>(whole), "a VTP file's array");
        const std::size_t before = out.size();
        out.resize(before + static_cast<std::size_t>(whole));
#if defined(MIEN_IMAGES)
        uLongf length = static_cast<uLongf>(whole);
        const int code = uncompress(reinterpret_cast<Bytef*>(&out[before]), &length,
                                    reinterpret_cast<const Bytef*>(data), static_cast<uLong>(size));
        if (code == Z_MEM_ERROR) fail(Status::no_memory, "no memory to unpack a VTP array");
        if (code != Z_OK || length != whole)
            fail(Status::bad_format, "a block of a VTP array is damaged");
#else
        (void)data;
        fail(Status::unsupported_option,
             "this build has no zlib (MIEN_IMAGES=OFF): save the VTP file without compression");
#endif
    }

    /// The array's bytes, from the appended data or the text between its tags.
    std::string array_bytes(const Tag& tag, const std::string& format, const char* begin,
                            const char* end) {
        if (format == "appended") {
            if (appended_ == nullptr)
                fail(Status::bad_format, "a VTP array is appended, and nothing is");
            const double offset = whole(tag.get("offset"));
            if (offset > static_cast<double>(appended_end_ - appended_))
                fail(Status::bad_format, "a VTP array begins after the end of the appended data");
            begin = appended_ + static_cast<std::size_t>(offset);
            end = appended_end_;
            if (appended_raw_) return unpack(RawRuns{begin, end});
        }
        return unpack(TextRuns{begin, end, begin});
    }

    /// Serves runs of bytes: `fresh` starts at the header again, else after the last fresh run.
    struct RawRuns {
        const char* begin;
        const char* end;
        std::size_t header = 0;
        std::string operator()(std::size_t count, bool fresh) {
            const char* from = fresh ? begin : begin + header;
            if (count > static_cast<std::size_t>(end - from))
                fail(Status::bad_format, "the VTP file ends within an array");
            if (fresh) header = count;
            return std::string(from, count);
        }
    };
    struct TextRuns {
        const char* begin;
        const char* end;
        const char* data;
        std::string operator()(std::size_t count, bool fresh) {
            Base64 runs(fresh ? begin : data, end);
            std::string bytes = runs.take(count);
            // A run ends with its group: data begins with a fresh one.
            if (fresh) data = after_groups(begin, (count + 2) / 3);
            return bytes;
        }
        const char* after_groups(const char* at, std::size_t groups) const {
            for (std::size_t letters = 4 * groups; letters != 0 && at != end; ++at)
                if (static_cast<unsigned char>(*at) > ' ') --letters;
            return at;
        }
    };

    void read_array(const Tag& tag, const TagScanner& tags) {
        const std::string name = ply_lower_case(tag.get("name"));
        const bool wanted = section_ == "points" || section_ == "polys" || section_ == "strips" ||
                            section_ == "pointdata";
        VtkType type;
        if (!wanted) return;
        if (!parse_vtk_type(tag.get("type"), type)) return;  // texts and bits are no geometry
        const std::string columns_text = tag.get("numberofcomponents");
        const std::size_t columns =
            columns_text.empty() ? 1 : static_cast<std::size_t>(whole(columns_text));
        const std::string format = ply_lower_case(tag.get("format"));
        const char* text_end = std::find(tags.at(), tags.end(), '<');
        std::vector<double> values;
        if (format == "ascii" || format.empty()) {
            TextCursor text(tags.at(), text_end);
            for (text.skip_space(); !text.at_end(); text.skip_space()) {
                double value = 0.0;
                if (!text.number(value))
                    fail(Status::bad_format, "not a number in the VTP array '%s'",
                         shown_name(name).c_str());
                values.push_back(value);
            }
        } else {
            const std::string bytes = array_bytes(tag, format, tags.at(), text_end);
            context_.require_memory(8 * (bytes.size() / type.bytes()), "a VTP file's array");
            values.resize(bytes.size() / type.bytes());
            for (std::size_t k = 0; k < values.size(); ++k)
                values[k] = load_vtk(bytes.data() + k * type.bytes(), type, swapped_);
        }
        take(name, type, columns, std::move(values));
    }

    void take(const std::string& name, const VtkType& type, std::size_t columns,
              std::vector<double>&& values) {
        if (section_ == "points") {
            if (values.size() != 3 * num_points_)
                fail(Status::bad_format, "a VTP piece promises %zu points and has %zu numbers",
                     num_points_, values.size());
            data_.points.insert(data_.points.end(), values.begin(), values.end());
        } else if (section_ == "pointdata") {
            point_arrays_.push_back({name, type, columns, std::move(values)});
        } else if (name == "connectivity" || name == "offsets") {
            Cells& cells = section_ == "polys" ? polys_ : strips_;
            (name == "offsets" ? cells.offsets : cells.connectivity) = std::move(values);
        }
    }

    /// A piece's cells count its own points, and may come before them.
    void end_piece() {
        VtkPolyData piece;
        piece.points.assign(data_.points.begin() + static_cast<std::ptrdiff_t>(3 * first_),
                            data_.points.end());
        for (Cells* cells : {&polys_, &strips_}) {
            for (double& number : cells->connectivity) {
                if (!(number >= 0.0 && number < static_cast<double>(num_points_)))
                    fail(Status::bad_format, "a VTP cell names point %g of %zu", number,
                         num_points_);
                number += static_cast<double>(first_);
            }
            data_.add_cells(cells->offsets, cells->connectivity, cells == &strips_);
            *cells = Cells();
        }
        for (const PointArray& array : point_arrays_)
            piece.add_point_array(array.name, array.type, array.columns, array.values,
                                  array.name == ply_lower_case(texture_name_),
                                  array.columns >= 3 && array.name == ply_lower_case(color_name_));
        point_arrays_.clear();
        data_.colors.insert(data_.colors.end(), piece.colors.begin(), piece.colors.end());
        data_.texture.insert(data_.texture.end(), piece.texture.begin(), piece.texture.end());
    }

    struct Cells {
        std::vector<double> offsets, connectivity;
    };
    struct PointArray {
        std::string name;
        VtkType type;
        std::size_t columns;
        std::vector<double> values;
    };

    const Source& source_;
    const Context& context_;
    std::size_t size_;
    const char* body_end_ = nullptr;
    const char* appended_ = nullptr;
    const char* appended_end_ = nullptr;
    bool appended_raw_ = false, swapped_ = false, wide_header_ = false, compressed_ = false;
    std::string section_, texture_name_, color_name_;
    std::size_t first_ = 0, num_points_ = 0;
    Cells polys_, strips_;
    std::vector<PointArray> point_arrays_;
    VtkPolyData data_;
};

}  // namespace

TriMesh read_vtp(const Source& source, const Context& context) {
    return VtpReader(source, context).read();
}

}  // namespace mien::formats
