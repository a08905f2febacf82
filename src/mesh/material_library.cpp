#include "mesh/material_library.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesh/companions.hpp"
#include "mesh/text_cursor.hpp"

namespace mien::formats {
namespace {

constexpr std::size_t kMostMaterials = 65536;

/// How many words follow an option of a map, at most; -1 for a word that is none.
int words_of_option(const std::string& word) {
    static const struct {
        const char* name;
        int words;
    } kOptions[] = {{"-blendu", 1}, {"-blendv", 1},    {"-cc", 1},    {"-clamp", 1},
                    {"-texres", 1}, {"-bm", 1},        {"-boost", 1}, {"-imfchan", 1},
                    {"-type", 1},   {"-mm", 2},        {"-o", 3},     {"-s", 3},
                    {"-t", 3},      {"-colorspace", 1}};
    for (const auto& option : kOptions)
        if (word == option.name) return option.words;
    return -1;
}

std::string next_word(TextCursor& text) {
    const char* word = nullptr;
    std::size_t size = 0;
    text.skip_blanks();
    text.word(word, size);
    return std::string(word, size);
}

/// The file's name after the options of a map line; it may hold blanks.
std::string map_file(TextCursor& text) {
    for (;;) {
        const TextCursor before = text;
        const int words = words_of_option(next_word(text));
        if (words < 0) {
            text = before;
            break;
        }
        for (int k = 0; k < words; ++k) {
            // The vectors have one to three numbers.
            const TextCursor here = text;
            double value = 0.0;
            text.skip_blanks();
            if (words > 1 ? !text.number(value) : next_word(text).empty()) {
                text = here;
                break;
            }
        }
    }
    const char* begin = nullptr;
    std::size_t size = 0;
    text.rest_of_line(begin, size);
    return std::string(begin, size);
}

std::string lower_word(std::string word) {
    for (char& c : word)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return word;
}

}  // namespace

void parse_material_library(const char* begin, const char* end,
                            std::vector<LibraryMaterial>& materials) {
    TextCursor text(begin, end);
    bool open = false;
    for (; !text.at_end(); text.skip_line()) {
        const std::string word = lower_word(next_word(text));
        if (word == "newmtl") {
            const char* name = nullptr;
            std::size_t size = 0;
            text.rest_of_line(name, size);
            open = materials.size() < kMostMaterials;
            if (!open) continue;
            materials.emplace_back();
            materials.back().name.assign(name, size);
        } else if (open && word == "kd") {
            std::array<float, 3> color{};
            bool whole = true;
            for (float& value : color) {
                double number = 0.0;
                text.skip_blanks();
                whole = whole && text.number(number) && std::isfinite(number);
                value = static_cast<float>(std::min(std::max(number, 0.0), 1.0));
            }
            if (whole) materials.back().color = color;
        } else if (open && word == "map_kd") {
            materials.back().image = map_file(text);
        }
    }
}

void read_material_library(const Source& source, const std::string& names,
                           std::vector<LibraryMaterial>& materials, const Context& context) {
    // One name with blanks is more usual than several names: tried first, without a word when it
    // fails and there may be several.
    std::vector<std::string> files{names};
    const std::string extension = ".mtl ";
    std::size_t begin = 0;
    std::vector<std::string> several;
    for (std::size_t at; (at = lower_word(names).find(extension, begin)) != std::string::npos;) {
        several.push_back(names.substr(begin, at + 4 - begin));
        begin = at + extension.size();
    }
    if (!several.empty()) {
        several.push_back(names.substr(begin));
        files = several;
    }
    for (const std::string& file : files) {
        FileBytes bytes;
        if (read_companion(source, file, bytes, context))
            parse_material_library(bytes.data, bytes.data + bytes.size, materials);
    }
}

std::vector<std::string> write_material_library(Target& target, const TriMesh& mesh,
                                                std::string& out, const Context& context) {
    const std::vector<std::string> images = write_companion_images(target, mesh, context);
    std::vector<std::string> names;
    std::string text = "# millimetres\n";
    for (std::size_t k = 0; k < mesh.materials.size(); ++k) {
        const Material& material = mesh.materials[k];
        std::string name = material.name;
        for (char& c : name)
            if (static_cast<unsigned char>(c) < 0x20) c = '_';
        if (name.find_first_not_of(' ') == std::string::npos)
            name = "material_" + std::to_string(k + 1);
        while (std::find(names.begin(), names.end(), name) != names.end()) name += "_";
        text += "newmtl " + name + "\nKd";
        for (float value : material.color) append_number(text, static_cast<double>(value));
        text += '\n';
        if (material.image >= 0)
            text += "map_Kd " + images[static_cast<std::size_t>(material.image)] + "\n";
        names.push_back(std::move(name));
    }
    const std::string library = stem_of(target.path) + ".mtl";
    const std::size_t slash = target.path.find_last_of("/\\");
    const std::string folder =
        slash == std::string::npos ? std::string() : target.path.substr(0, slash + 1);
    auto file = std::make_unique<AtomicFile>(folder + library);
    file->write(text);
    target.companions.push_back(std::move(file));
    out += "mtllib " + library + "\n";
    return names;
}

}  // namespace mien::formats
