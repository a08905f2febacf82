#include "mesh/image.hpp"

#include <algorithm>
#include <cstring>

#include "base/error.hpp"
#include "base/json.hpp"

namespace mien {
namespace {

using Bytes = const unsigned char*;

std::uint32_t big32(Bytes p) {
    return std::uint32_t(p[0]) << 24 | std::uint32_t(p[1]) << 16 | std::uint32_t(p[2]) << 8 | p[3];
}

std::uint32_t big16(Bytes p) {
    return std::uint32_t(p[0]) << 8 | p[1];
}

[[noreturn]] void fail_broken(const TextureImage& image, const char* what) {
    fail(Status::bad_format, "the image '%s' %s", shown_name(image.name).c_str(), what);
}

/// Bits of a pixel by PNG's colour type, or 0.
std::uint64_t png_bits(unsigned depth, unsigned type) {
    constexpr unsigned kChannels[] = {1, 0, 3, 1, 2, 0, 4};
    return type < 7 ? std::uint64_t(depth) * kChannels[type] : 0;
}

ImageSize png_size(const TextureImage& image) {
    const Bytes p = reinterpret_cast<Bytes>(image.encoded.data());
    if (image.encoded.size() < 33 || std::memcmp(p + 12, "IHDR", 4) != 0)
        fail_broken(image, "is no whole PNG file");
    const std::uint64_t width = big32(p + 16), height = big32(p + 20);
    const std::uint64_t bits = png_bits(p[24], p[25]);
    if (bits == 0 || bits > 64) fail_broken(image, "has an unknown kind of pixels");
    // One byte of deflate holds at most 1032 others.
    const std::uint64_t row = (width * bits + 7) / 8 + 1, most = 1032;
    if (height > (std::uint64_t(image.encoded.size()) * most) / row)
        fail_broken(image, "is smaller than so many pixels could be");
    return {static_cast<Index>(width), static_cast<Index>(height)};
}

/// The first frame header among the segments before the data.
ImageSize jpeg_size(const TextureImage& image) {
    const Bytes p = reinterpret_cast<Bytes>(image.encoded.data());
    const std::size_t size = image.encoded.size();
    for (std::size_t at = 2; at + 9 < size;) {
        if (p[at] != 0xff) break;
        const unsigned marker = p[at + 1];
        if (marker == 0xff) {
            ++at;
            continue;
        }
        if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {
            at += 2;
            continue;
        }
        const bool frame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (!frame) {
            if (marker == 0xda || marker == 0xd9) break;
            at += 2 + big16(p + at + 2);
            continue;
        }
        const std::uint64_t height = big16(p + at + 5), width = big16(p + at + 7);
        // A block of 8 x 8 pixels needs at least one bit, and a thumbnail scale leaves 4 x 4 of it.
        if (width * height > std::uint64_t(size) * 8 * 64)
            fail_broken(image, "is smaller than so many pixels could be");
        return {static_cast<Index>(width), static_cast<Index>(height)};
    }
    fail_broken(image, "has no frame header");
}

}  // namespace

ImageKind kind_of_image(const TextureImage& image) {
    const std::string& bytes = image.encoded;
    if (bytes.empty()) return ImageKind::pixels;
    if (bytes.compare(0, 3, "\xff\xd8\xff") == 0) return ImageKind::jpeg;
    if (bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0) return ImageKind::png;
    return ImageKind::other;
}

ImageSize size_of_image(const TextureImage& image) {
    ImageSize size{image.width, image.height};
    switch (kind_of_image(image)) {
        case ImageKind::pixels:
            break;
        case ImageKind::jpeg:
            size = jpeg_size(image);
            break;
        case ImageKind::png:
            size = png_size(image);
            break;
        case ImageKind::other:
            fail(Status::unsupported_option,
                 "the image '%s' is neither JPEG nor PNG; convert it first",
                 shown_name(image.name).c_str());
    }
    if (size.width < 1 || size.height < 1) fail_broken(image, "has no pixels");
    if (size.width > kMostPixels / size.height)
        fail(Status::unsupported_option,
             "the image '%s' of %lld x %lld pixels is larger than %lld pixels; make it smaller",
             shown_name(image.name).c_str(), static_cast<long long>(size.width),
             static_cast<long long>(size.height), static_cast<long long>(kMostPixels));
    return size;
}

Image decode_image(const TextureImage& image, const Context& context) {
    const ImageSize size = size_of_image(image);
    const std::size_t bytes =
        3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    const ImageKind kind = kind_of_image(image);
    // A PNG passes through four channels, a progressive JPEG through 16-bit coefficients.
    context.require_memory(kind == ImageKind::pixels ? bytes : 3 * bytes, "a texture image");
    if (kind == ImageKind::pixels) {
        Image decoded;
        decoded.width = size.width;
        decoded.height = size.height;
        decoded.rgb = image.pixels;
        return decoded;
    }
    try {
        return kind == ImageKind::jpeg ? images::decode_jpeg(image.encoded, size, context)
                                       : images::decode_png(image.encoded, size, context);
    } catch (const Error& error) {
        if (error.status() != Status::bad_format) throw;
        fail_broken(image, error.what());
    }
}

}  // namespace mien
