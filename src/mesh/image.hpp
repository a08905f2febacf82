// Texture images: what an encoded file is, how large, and its pixels. JPEG by libjpeg-turbo, PNG by
// libpng; a build without them (MIEN_IMAGES=OFF, for firmware) still knows kinds and sizes, and
// keeps images as bytes. Files are hostile: a picture may be at most as large as its bytes could
// hold in that format, and never larger than kMostPixels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// 134 million pixels, 400 MB: more than four of the largest textures that scanners write.
constexpr Index kMostPixels = Index(1) << 27;

/// Red green blue, rows from the top, tightly packed.
struct Image {
    Index width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< height x width x 3
};

enum class ImageKind { pixels, jpeg, png, other };

/// By the first bytes.
ImageKind kind_of_image(const TextureImage& image);

struct ImageSize {
    Index width = 0, height = 0;
};

/// From the header alone. Throws Status::bad_format for a broken header, unsupported_option for
/// another kind of image.
ImageSize size_of_image(const TextureImage& image);

/// False in a build without decoders: decode_image() then serves pixels of a host's alone.
bool images_are_decoded();

/// The pixels; transparency is left away, grey becomes three equal channels, 16 bits become 8.
/// Throws Status::bad_format for a damaged or truncated file, unsupported_option for a kind (a
/// TIFF, a CMYK JPEG) or a build without decoder, memory_budget, no_memory, cancelled. O(width
/// height) time and memory.
Image decode_image(const TextureImage& image, const Context& context);

/// A PNG file of the pixels (kind pixels). Throws unsupported_option in a build without libpng.
std::string encode_png(const TextureImage& image, const Context& context);

namespace images {

/// The decoders behind decode_image(), in files of their own.
Image decode_jpeg(const std::string& bytes, ImageSize size, const Context& context);
Image decode_png(const std::string& bytes, ImageSize size, const Context& context);

}  // namespace images
}  // namespace mien
