#include "base/json.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace {

using namespace mien;

TEST(Json, StringListsSurviveQuotesControlCharactersAndEveryPlaneOfUnicode) {
    const std::vector<std::string> names = {"",
                                            "neutral",
                                            "a \"quoted\" \\ one",
                                            "tab\there\n\x01",
                                            "\xc3\xa9t\xc3\xa9",
                                            "\xf0\x9f\x98\x80"};
    EXPECT_EQ(parse_json_string_list(json_string_list(names), "names"), names);
}

TEST(Json, AListOfStringsIsNothingElse) {
    for (const char* text : {"", "[", "[1]", "{}", "[[\"a\"]]", "[\"a\",]", "[\"a\"] x", "null",
                             "[\"\\ud800\"]", "[\"\xff\"]", "\"a\"", "[-1]", "[0.5]", "[true]"}) {
        try {
            parse_json_string_list(text, "names");
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::bad_format) << text;
        }
    }
}

TEST(Json, DeepNestingIsRefusedBeforeItCostsAnything) {
    const std::string deep(10000000, '[');
    EXPECT_THROW(parse_json_string_list(deep, "names"), Error);
}

TEST(Json, TextThatIsNotUtf8IsNotWritten) {
    for (const char* text : {"\xff", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                             "abc\xc3", "\xf5\x80\x80\x80", "\x80"}) {
        EXPECT_FALSE(is_utf8(text));
        std::string json;
        EXPECT_THROW(append_json_string(json, text), Error);
    }
    for (const char* text :
         {"", "abc", "\xc3\xa9", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xf4\x8f\xbf\xbf"})
        EXPECT_TRUE(is_utf8(text));
}

TEST(Error, AMessageThatIsCutEndsWithAWholeCharacter) {
    for (int shift = 0; shift < 4; ++shift)
        for (const char* character : {"a", "\xc3\xa9", "\xe9\xa1\x94", "\xf0\x9f\x98\x80"}) {
            std::string text(static_cast<std::size_t>(shift), '.');
            while (text.size() < 400) text += character;
            const std::string cut = Error(Status::io, -1, text.c_str()).what();
            EXPECT_TRUE(is_utf8(cut)) << cut;
            EXPECT_GE(cut.size(), 252u);
            EXPECT_EQ(text.compare(0, cut.size(), cut), 0);
        }
    EXPECT_STREQ(Error(Status::io, -1, "short \xc3\xa9").what(), "short \xc3\xa9");
}

TEST(Json, NamesInMessagesAreShortPrintableAndNotCutWithinACharacter) {
    EXPECT_EQ(shown_name("jaw"), "jaw");
    EXPECT_EQ(shown_name("a\nb"), "a?b");
    EXPECT_EQ(shown_name("\xff"), "?");
    std::string accents;
    for (int i = 0; i < 100; ++i) accents += "a\xc3\xa9";
    const std::string shown = shown_name(accents);
    EXPECT_LE(shown.size(), 64u);
    EXPECT_TRUE(is_utf8(shown));
}

}  // namespace
