// JPEG by libjpeg-turbo. Its errors leave through longjmp, so the frame that it returns to holds
// nothing that would need a destructor; the exact integer transform gives the same bits everywhere.
#if defined(MIEN_IMAGES)

#include "mesh/image.hpp"

#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <jpeglib.h>

#include <jerror.h>

#include "base/error.hpp"

namespace mien {
namespace {

/// So many passes over a progressive picture are more than any program writes; files with thousands
/// are made to keep a reader busy.
constexpr int kMostScans = 100;

struct Decoder {
    jpeg_decompress_struct info;
    jpeg_error_mgr errors;
    std::jmp_buf leave;
    int code;  ///< of the error that ended the reading, 0: none
    char message[JMSG_LENGTH_MAX];

    Decoder() {
        std::memset(&info, 0, sizeof info);
        code = 0;
        message[0] = '\0';
    }
    ~Decoder() { jpeg_destroy_decompress(&info); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
};

Decoder& decoder_of(j_common_ptr info) {
    return *static_cast<Decoder*>(info->client_data);
}

void leave_with_error(j_common_ptr info) {
    Decoder& decoder = decoder_of(info);
    decoder.code = info->err->msg_code;
    (*info->err->format_message)(info, decoder.message);
    std::longjmp(decoder.leave, 1);
}

void say_nothing(j_common_ptr) {}

/// Damaged data is a warning of the library's, which would go on with grey pixels.
void judge_message(j_common_ptr info, int level) {
    if (level >= 0) return;
    const int code = info->err->msg_code;
    if (code == JWRN_EXTRANEOUS_DATA || code == JWRN_JFIF_MAJOR || code == JWRN_ADOBE_XFORM) return;
    leave_with_error(info);
}

void limit_scans(j_common_ptr info) {
    const auto* decompress = reinterpret_cast<j_decompress_ptr>(info);
    if (decompress->input_scan_number <= kMostScans) return;
    Decoder& decoder = decoder_of(info);
    decoder.code = JERR_EOI_EXPECTED;
    std::snprintf(decoder.message, sizeof decoder.message, "more than %d scans", kMostScans);
    std::longjmp(decoder.leave, 1);
}

/// Each step returns false when the library left through its error handler.
bool start(Decoder& decoder, jpeg_progress_mgr& progress, const std::string& bytes) {
    if (setjmp(decoder.leave) != 0) return false;
    decoder.info.err = jpeg_std_error(&decoder.errors);
    decoder.info.client_data = &decoder;
    decoder.errors.error_exit = leave_with_error;
    decoder.errors.output_message = say_nothing;
    decoder.errors.emit_message = judge_message;
    jpeg_create_decompress(&decoder.info);
    // Creating wipes the struct but for these.
    decoder.info.client_data = &decoder;
    std::memset(&progress, 0, sizeof progress);
    progress.progress_monitor = limit_scans;
    decoder.info.progress = &progress;
    jpeg_mem_src(&decoder.info, reinterpret_cast<const unsigned char*>(bytes.data()),
                 static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&decoder.info, TRUE);
    decoder.info.dct_method = JDCT_ISLOW;
    decoder.info.out_color_space = JCS_RGB;
    return true;
}

bool is_cmyk(const Decoder& decoder) {
    return decoder.info.jpeg_color_space == JCS_CMYK || decoder.info.jpeg_color_space == JCS_YCCK;
}

bool begin_pixels(Decoder& decoder) {
    if (setjmp(decoder.leave) != 0) return false;
    jpeg_start_decompress(&decoder.info);
    return true;
}

bool read_rows(Decoder& decoder, std::uint8_t* rgb, std::size_t row_bytes, int most) {
    if (setjmp(decoder.leave) != 0) return false;
    for (int k = 0; k < most && decoder.info.output_scanline < decoder.info.output_height; ++k) {
        JSAMPROW row = rgb + decoder.info.output_scanline * row_bytes;
        jpeg_read_scanlines(&decoder.info, &row, 1);
    }
    return true;
}

bool finish(Decoder& decoder) {
    if (setjmp(decoder.leave) != 0) return false;
    jpeg_finish_decompress(&decoder.info);
    return true;
}

void require(bool went_well, const Decoder& decoder) {
    if (went_well) return;
    fail(decoder.code == JERR_OUT_OF_MEMORY ? Status::no_memory : Status::bad_format,
         "is no sound JPEG: %s", decoder.message);
}

}  // namespace

Image images::decode_jpeg(const std::string& bytes, ImageSize size, const Context& context) {
    Decoder decoder;
    jpeg_progress_mgr progress;
    require(start(decoder, progress, bytes), decoder);
    if (is_cmyk(decoder))
        fail(Status::unsupported_option,
             "a texture image is a JPEG in CMYK, for printing; convert it to RGB");
    if (static_cast<Index>(decoder.info.image_width) != size.width ||
        static_cast<Index>(decoder.info.image_height) != size.height)
        fail(Status::bad_format, "has two sizes");
    require(begin_pixels(decoder), decoder);
    Image decoded;
    decoded.width = size.width;
    decoded.height = size.height;
    const std::size_t row_bytes = 3 * static_cast<std::size_t>(size.width);
    decoded.rgb.resize(row_bytes * static_cast<std::size_t>(size.height));
    constexpr int kRowsBetweenChecks = 64;
    while (decoder.info.output_scanline < decoder.info.output_height) {
        context.check_cancelled();
        require(read_rows(decoder, decoded.rgb.data(), row_bytes, kRowsBetweenChecks), decoder);
    }
    require(finish(decoder), decoder);
    return decoded;
}

}  // namespace mien

#endif
