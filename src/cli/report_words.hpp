// What the report says, in the languages that it speaks: one table of texts, and names of zones in
// words.
#pragma once

#include <string>
#include <vector>

namespace mien::cli {

/// Two letters each, the first is the default.
const std::vector<std::string>& report_languages();

/// The texts of one language.
class Words {
  public:
    /// Throws std::invalid_argument for a language that the table does not have.
    explicit Words(const std::string& language);
    const std::string& language() const { return language_; }
    /// The text called `key`, with {0}, {1}, ... replaced; throws std::logic_error for a key that
    /// the table does not have.
    std::string operator()(const char* key, const std::vector<std::string>& values = {}) const;
    /// A zone's name in words: "cheek_left" is the left cheek. Names that the table does not know
    /// are shown with spaces; "cheek_left and 10 mm around" is understood.
    std::string zone(const std::string& name) const;
    /// What the library says of a fit or of a zone, in this language where the table knows the
    /// sentence, else as it was said.
    std::string sentence(const std::string& english) const;
    /// A number with the language's decimal sign; not a number is a dash.
    std::string number(double value, int digits) const;
    std::string number(std::string text) const;
    /// A field of a patient's or a visit's file in words; unknown ones as they are.
    std::string field(const std::string& key) const;

  private:
    std::string language_;
    std::size_t column_ = 0;
};

/// Text with every byte that is not UTF-8 replaced by U+FFFD.
std::string valid_utf8(const std::string& text);
/// At most `count` characters of a text, "..." after them when it was longer; never half a
/// character.
std::string shortened(const std::string& text, std::size_t count);
/// Text as it may stand in HTML.
std::string html_text(const std::string& text);

}  // namespace mien::cli
