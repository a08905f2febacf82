#include "base/sha256.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using mien::Sha256;

std::string digest(Sha256 hash, const std::string& text) {
    hash.update(text.data(), text.size());
    return hash.hex_digest();
}

// FIPS 180-4 examples and the empty message.
TEST(Sha256, GivesTheStandardsDigests) {
    const struct {
        std::string text;
        const char* hex;
    } cases[] = {
        {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
         "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
        {std::string(1000000, 'a'),
         "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"},
    };
    for (const auto& c : cases) {
        EXPECT_EQ(digest(Sha256(), c.text), c.hex);
        EXPECT_EQ(digest(Sha256::portable(), c.text), c.hex);
    }
}

TEST(Sha256, HardwareAndPortableLoopsAgreeForEveryLengthAroundABlock) {
    std::string text;
    for (int length = 0; length < 300; ++length) {
        EXPECT_EQ(digest(Sha256(), text), digest(Sha256::portable(), text)) << length;
        text += static_cast<char>(length * 37 + 11);
    }
}

TEST(Sha256, DoesNotDependOnHowTheBytesArrive) {
    std::string text(1000, '\0');
    for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(i * i);
    const std::string whole = digest(Sha256(), text);
    for (std::size_t step : {1, 3, 63, 64, 65, 200}) {
        Sha256 hash;
        for (std::size_t begin = 0; begin < text.size(); begin += step)
            hash.update(text.data() + begin, std::min(step, text.size() - begin));
        EXPECT_EQ(hash.hex_digest(), whole) << step;
    }
}

}  // namespace
