#include "mesh/companions.hpp"

#include <algorithm>
#include <cstring>

#include "base/error.hpp"
#include "base/json.hpp"
#include "mesh/image.hpp"

namespace mien::formats {
namespace {

/// Separators of any system as '/', quotes and blanks around it away.
std::string tidy(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    const char* around = " \t\"'";
    const std::size_t first = path.find_first_not_of(around);
    if (first == std::string::npos) return std::string();
    return path.substr(first, path.find_last_not_of(around) - first + 1);
}

/// A path that stays below the folder it starts from.
bool stays_below(const std::string& path) {
    if (path.empty() || path[0] == '/' || path.find(':') != std::string::npos) return false;
    for (std::size_t at = 0; at <= path.size();) {
        const std::size_t end = std::min(path.find('/', at), path.size());
        if (path.compare(at, end - at, "..") == 0) return false;
        at = end + 1;
    }
    return true;
}

bool try_to_read(const std::string& path, FileBytes& bytes, const Context& context) {
    try {
        bytes = read_whole_file(path, context);
        return bytes.size != 0;
    } catch (const Error& error) {
        if (error.status() == Status::io || error.status() == Status::invalid_argument)
            return false;
        throw;
    }
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.find_last_of("/\\");
    return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

/// A name that every file system takes, with the extension of the image's kind.
std::string file_name(const TextureImage& image, std::size_t number, const std::string& stem) {
    const ImageKind kind = kind_of_image(image);
    const bool png = kind == ImageKind::pixels || kind == ImageKind::png;
    const bool jpeg = kind == ImageKind::jpeg;
    std::string name = last_part(image.name);
    for (char& c : name)
        if (static_cast<unsigned char>(c) < 0x20 || std::strchr("<>:\"|?*#", c) != nullptr) c = '_';
    if (name.empty() || name == "." || name == "..") name = stem + "_" + std::to_string(number + 1);
    const std::size_t dot = name.rfind('.');
    const std::string extension = dot == std::string::npos ? "" : lower(name.substr(dot));
    if (png && extension != ".png") name += ".png";
    if (jpeg && extension != ".jpg" && extension != ".jpeg") name += ".jpg";
    return name;
}

}  // namespace

std::string last_part(const std::string& path) {
    const std::string tidied = tidy(path);
    return tidied.substr(tidied.find_last_of('/') + 1);
}

std::string stem_of(const std::string& path) {
    const std::string name = path.substr(path.find_last_of("/\\") + 1);
    const std::size_t dot = name.rfind('.');
    return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

bool read_companion(const Source& source, const std::string& reference, FileBytes& bytes,
                    const Context& context) {
    if (source.path.empty()) {
        context.log(LogLevel::warning, "a mesh in memory names the file '%s': left out",
                    shown_name(reference).c_str());
        return false;
    }
    const std::string folder = folder_of(source.path), named = tidy(reference);
    if (stays_below(named) && try_to_read(folder + named, bytes, context)) return true;
    const std::string last = last_part(named);
    if (stays_below(last) && last != named && try_to_read(folder + last, bytes, context))
        return true;
    context.log(LogLevel::warning, "'%s' names the file '%s', which is not beside it: left out",
                shown_path(source.path).c_str(), shown_name(reference).c_str());
    return false;
}

std::int32_t add_companion_image(TriMesh& mesh, const Source& source, const std::string& reference,
                                 KnownImages& known, const Context& context) {
    for (std::size_t k = 0; k < known.references.size(); ++k)
        if (known.references[k] == reference) return known.numbers[k];
    std::int32_t number = -1;
    FileBytes bytes;
    if (read_companion(source, reference, bytes, context)) {
        auto image = std::make_shared<TextureImage>();
        const std::string name = last_part(reference);
        image->name = is_utf8(name) ? name : shown_name(name);
        image->encoded.assign(bytes.data, bytes.size);
        number = static_cast<std::int32_t>(mesh.images.size());
        mesh.images.push_back(std::move(image));
    }
    known.references.push_back(reference);
    known.numbers.push_back(number);
    return number;
}

std::vector<std::string> write_companion_images(Target& target, const TriMesh& mesh,
                                                const Context& context) {
    std::vector<std::string> names;
    const std::string folder = folder_of(target.path), stem = stem_of(target.path);
    auto is_taken = [&](const std::string& name) {
        return std::any_of(names.begin(), names.end(),
                           [&](const std::string& other) { return lower(other) == lower(name); });
    };
    for (std::size_t k = 0; k < mesh.images.size(); ++k) {
        const TextureImage& image = *mesh.images[k];
        const bool pixels = kind_of_image(image) == ImageKind::pixels;
        const std::string made = pixels ? encode_png(image, context) : std::string();
        const std::string& bytes = pixels ? made : image.encoded;
        std::string name = file_name(image, k, stem);
        FileBytes there;
        bool same = false;
        if (try_to_read(folder + name, there, context)) {
            same = there.size == bytes.size() &&
                   std::memcmp(there.data, bytes.data(), bytes.size()) == 0;
            if (!same && name.compare(0, stem.size(), stem) != 0) name = stem + "_" + name;
        }
        for (int count = 2; is_taken(name); ++count) {
            name = stem + "_" + std::to_string(count) + "_" + file_name(image, k, stem);
            same = false;
        }
        names.push_back(name);
        if (same) continue;
        auto file = std::make_unique<AtomicFile>(folder + name);
        file->write(bytes);
        target.companions.push_back(std::move(file));
    }
    return names;
}

}  // namespace mien::formats
