// SPDX-License-Identifier: MIT
#include "lecture/documents/qr_code.h"

#include <gtest/gtest.h>

#include "lecture/decks.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::deck_of;

bool is_dark(const std::string& svg, int x, int y) {
  return svg.find(fmt::format("M{} {}h1v1h-1z", x, y)) != std::string::npos;
}

// ISO/IEC 18004: three squares of 7 modules mark the corners, inside a quiet zone of 4
TEST(QrCode, HasItsThreeSquares) {
  const std::string svg = qr_code_svg("https://example.org/tops/index.html#turn=top");
  EXPECT_NE(svg.find("viewBox=\"0 0 41 41\""), std::string::npos)
      << svg.substr(0, 120);  // version 4
  constexpr int kFirst = 4, kLast = 4 + 33 - 7;
  for (const auto& [left, top] :
       {std::pair(kFirst, kFirst), std::pair(kLast, kFirst), std::pair(kFirst, kLast)}) {
    for (int y = 0; y < 7; ++y) {
      for (int x = 0; x < 7; ++x) {
        const int ring = std::max(std::abs(x - 3), std::abs(y - 3));
        EXPECT_EQ(is_dark(svg, left + x, top + y), ring != 2) << x << ' ' << y;
      }
    }
  }
}

TEST(QrCode, TooMuchIsAnError) {
  test::expect_input_error([] { qr_code_svg(std::string(5000, 'a')); }, "", "shorter");
  test::expect_input_error([] { qr_code_svg(""); }, "", "QR");
}

// the address leads to the web and nowhere else
TEST(QrCode, OfADecksAddress) {
  const auto problem = [](const std::string& address) {
    return test::problem_of("---\naddress: \"" + address + "\"\n---\nText\n");
  };
  EXPECT_EQ(problem("https://example.org/tops"), "none");
  EXPECT_NE(problem("javascript:alert(1)").find("address"), std::string::npos);
  EXPECT_NE(problem("https://example.org/a#b").find("address"), std::string::npos);
}

}  // namespace
}  // namespace polhode
