// PNG by libpng's simplified interface: it catches its own errors, prints nothing and brings every
// kind of pixel to eight bits.
#include "mesh/image.hpp"

#include "base/error.hpp"

#if defined(MIEN_IMAGES)

#include <png.h>

#include <cstring>

namespace mien {
namespace {

/// Frees what libpng holds, however the function is left.
struct PngImage {
    png_image image{};
    PngImage() { image.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&image); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;

    [[noreturn]] void raise() const {
        const bool memory = std::strstr(image.message, "memory") != nullptr;
        fail(memory ? Status::no_memory : Status::bad_format, "is no sound PNG: %s", image.message);
    }
};

}  // namespace

bool images_are_decoded() {
    return true;
}

Image images::decode_png(const std::string& bytes, ImageSize size, const Context& context) {
    PngImage png;
    if (png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()) == 0) png.raise();
    if (static_cast<Index>(png.image.width) != size.width ||
        static_cast<Index>(png.image.height) != size.height)
        fail(Status::bad_format, "has two sizes");
    context.check_cancelled();
    // Sixteen bits without a gamma of their own are taken as the eight bits of a photograph are.
    png.image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    png.image.format = PNG_FORMAT_RGBA;
    const std::size_t count =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    std::vector<std::uint8_t> rgba(4 * count);
    if (png_image_finish_read(&png.image, nullptr, rgba.data(), 0, nullptr) == 0) png.raise();
    context.check_cancelled();
    Image decoded;
    decoded.width = size.width;
    decoded.height = size.height;
    decoded.rgb.resize(3 * count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k) decoded.rgb[3 * i + k] = rgba[4 * i + k];
    return decoded;
}

std::string encode_png(const TextureImage& image, const Context& context) {
    const ImageSize size = size_of_image(image);
    context.require_memory(image.pixels.size() + image.pixels.size() / 8, "writing an image");
    PngImage png;
    png.image.width = static_cast<png_uint_32>(size.width);
    png.image.height = static_cast<png_uint_32>(size.height);
    png.image.format = PNG_FORMAT_RGB;
    png_alloc_size_t room = PNG_IMAGE_PNG_SIZE_MAX(png.image);
    std::string bytes(room, '\0');
    if (png_image_write_to_memory(&png.image, &bytes[0], &room, 0, image.pixels.data(), 0,
                                  nullptr) == 0)
        png.raise();
    bytes.resize(room);
    return bytes;
}

}  // namespace mien

#else

namespace mien {
namespace {

[[noreturn]] void fail_unsupported() {
    fail(Status::unsupported_option,
         "this build has no image decoders (MIEN_IMAGES=OFF): hand the pixels over by arrays");
}

}  // namespace

bool images_are_decoded() {
    return false;
}

Image images::decode_png(const std::string&, ImageSize, const Context&) {
    fail_unsupported();
}

Image images::decode_jpeg(const std::string&, ImageSize, const Context&) {
    fail_unsupported();
}

std::string encode_png(const TextureImage&, const Context&) {
    fail_unsupported();
}

}  // namespace mien

#endif
