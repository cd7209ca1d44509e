// SPDX-License-Identifier: MIT
#include "html/escape.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Escape, MarkupBecomesCharacters) {
  EXPECT_EQ(escaped("<b class=\"x\">Tom & 'Ann'</b>"),
            "&lt;b class=&quot;x&quot;&gt;Tom &amp; &#39;Ann&#39;&lt;/b&gt;");
  EXPECT_EQ(escaped("&lt;"), "&amp;lt;") << "never taken for escaped already";
  EXPECT_EQ(escaped(""), "");
}

TEST(Escape, Utf8StaysAsItIs) {
  EXPECT_EQ(escaped("Ω ê₁ 漢字 🎡"), "Ω ê₁ 漢字 🎡");
}

// each byte that belongs to no character becomes a replacement character (U+FFFD)
TEST(Escape, BrokenBytesAreReplaced) {
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ(escaped("a\xff"
                    "b"),
            "a" + mark + "b");
  EXPECT_EQ(escaped("\xe2\x82"), mark + mark) << "cut off";
  EXPECT_EQ(escaped("\xc0\xaf"), mark + mark) << "an overlong slash";
}

TEST(Escape, ControlCharactersBecomeSpaces) {
  EXPECT_EQ(escaped(std::string("a\0b\n\x1b\x7f", 6)), "a b   ");
}

// no byte of any text can begin or end a tag, an attribute or an entity
TEST(Escape, NoByteOpensMarkup) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text = escaped(std::string(3, static_cast<char>(byte)));
    EXPECT_EQ(text.find_first_of("<>\"'"), std::string::npos) << byte;
    EXPECT_EQ(text.find('&') != std::string::npos,
              std::string("<>&\"'").find(static_cast<char>(byte)) != std::string::npos && byte != 0)
        << byte;
  }
}

}  // namespace
}  // namespace polhode
