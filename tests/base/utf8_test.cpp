// SPDX-License-Identifier: MIT
#include "base/utf8.h"

#include <cstdint>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace polhode {
namespace {

// the bits of Unicode 15, table 3-6, in the fewest bytes
std::string encoded(std::uint32_t c) {
  const auto tail = [&](int k) {
    return static_cast<char>(0x80 | (c >> 6 * k & 0x3f));
  };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xc0 | c >> 6), tail(0)};
  if (c < 0x10000) return {static_cast<char>(0xe0 | c >> 12), tail(1), tail(0)};
  return {static_cast<char>(0xf0 | c >> 18), tail(2), tail(1), tail(0)};
}

bool is_scalar_value(std::uint32_t c) {
  return c <= 0x10ffff && (c < 0xd800 || c > 0xdfff);
}

TEST(Utf8Length, IsThatOfEveryCharacterAndOfNoSurrogate) {
  long wrong = 0;
  for (std::uint32_t c = 0; c < 0x200000; ++c) {
    const std::string bytes = encoded(c);
    const std::size_t wanted = is_scalar_value(c) ? bytes.size() : 0;
    wrong += utf8_length("x" + bytes + "x", 1) != wanted ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0);
}

// every pair of bytes in front of two that continue: only the fewest bytes of a character are one
TEST(Utf8Length, RefusesOverlongForms) {
  long wrong = 0;
  for (std::uint32_t lead = 0; lead < 256; ++lead) {
    for (std::uint32_t second = 0; second < 256; ++second) {
      const std::string bytes = {
          static_cast<char>(lead), static_cast<char>(second), '\x80', '\xbf'};
      const bool follows = second >> 6 == 2;
      std::size_t wanted = 0;
      const auto is_fewest = [&](std::uint32_t c, std::size_t length) {
        if (follows && is_scalar_value(c) && encoded(c).size() == length) wanted = length;
      };
      if (lead < 0x80) wanted = 1;
      if (lead >> 5 == 6) is_fewest((lead & 0x1f) << 6 | (second & 0x3f), 2);
      if (lead >> 4 == 14) is_fewest((lead & 0xf) << 12 | (second & 0x3f) << 6, 3);
      if (lead >> 3 == 30) is_fewest((lead & 7) << 18 | (second & 0x3f) << 12 | 0x3f, 4);
      wrong += utf8_length(bytes, 0) != wanted ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Utf8Length, RefusesWhatIsCutOff) {
  for (const std::uint32_t c : {0xe9U, 0x20acU, 0x1f600U}) {
    const std::string bytes = encoded(c);
    for (std::size_t n = 1; n < bytes.size(); ++n)
      EXPECT_EQ(utf8_length(bytes.substr(0, n), 0), 0U) << c << " after " << n;
  }
}

// production 2 of XML 1.0, by its ranges, and what TeX calls invalid
TEST(Unwritable, IsWhatXmlAndTexLeaveOut) {
  for (std::uint32_t c = 0; c <= 0x10ffff; ++c) {
    if (!is_scalar_value(c)) continue;
    const bool may_stand = c == 0x9 || c == 0xa || c == 0xd ||
                           (c >= 0x20 && c <= 0xd7ff && c != 0x7f) ||
                           (c >= 0xe000 && c <= 0xfffd) || c >= 0x10000;
    const std::string text = "é" + encoded(c);
    ASSERT_EQ(find_unwritable(text), may_stand ? std::string::npos : 2U) << c;
  }
  EXPECT_EQ(code_point("a\x0b", 1), "U+000B");
  EXPECT_EQ(code_point("\xef\xbf\xbf", 0), "U+FFFF");
  EXPECT_EQ(code_point("é", 0), "U+00E9");
  EXPECT_EQ(code_point("\xf0\x9f\x98\x80", 0), "U+1F600");
}

TEST(IsContinuation, SaysWhetherAByteIsThereAndNotTheFirst) {
  const std::string text = "aé";
  EXPECT_FALSE(is_continuation(text, 0));
  EXPECT_FALSE(is_continuation(text, 1));
  EXPECT_TRUE(is_continuation(text, 2));
  EXPECT_FALSE(is_continuation(text, 3));
}

}  // namespace
}  // namespace polhode
