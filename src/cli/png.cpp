// PNG through libpng's simplified interface, and base64 for pictures inside HTML.
#include <png.h>

#include <stdexcept>

#include "image.hpp"

namespace mien::cli {

std::string encode_png(const Image& image) {
    if (image.width <= 0 || image.height <= 0)
        throw std::runtime_error("cannot encode an empty picture");
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    std::string bytes;
    if (png_image_write_to_memory(&header, nullptr, &size, 0, image.rgb.data(), 0, nullptr) != 0) {
        bytes.resize(size);
        if (png_image_write_to_memory(&header, &bytes[0], &size, 0, image.rgb.data(), 0, nullptr) !=
            0) {
            bytes.resize(size);
            return bytes;
        }
    }
    throw std::runtime_error(std::string("PNG encoder: ") + header.message);
}

std::string base64(const std::string& bytes) {
    static const char kAlphabet[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group =
                group << 8 | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i)
            text += k + i <= bytes.size() ? kAlphabet[group >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

std::string png_data_uri(const Image& image) {
    return "data:image/png;base64," + base64(encode_png(image));
}

}  // namespace mien::cli
