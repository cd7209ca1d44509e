// SPDX-License-Identifier: MIT
#include "text/markup.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Markup, PlainTextStaysPlain) {
  EXPECT_EQ(plain_text("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(plain_text("Ω\tL\n"), "Ω\tL\n");
  EXPECT_EQ(plain_text(std::string_view("\x01", 1)), "&#x1;");
}

}  // namespace
}  // namespace polhode
