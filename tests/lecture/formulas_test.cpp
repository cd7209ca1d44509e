// SPDX-License-Identifier: MIT
#include "lecture/formulas.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Formulas, HaveTheirNumbersAtTheEndOfTheirRows) {
  const auto words = with_tags_as_words;
  EXPECT_EQ(words("a \\tag{1}"), "a \\qquad\\text{(1)}");
  EXPECT_EQ(words("\\tag{1} a"), " a\\qquad\\text{(1)}");
  EXPECT_EQ(words("a \\tag*{b}"), "a \\qquad\\text{b}");
  EXPECT_EQ(words("a \\tag{\\text{b}}"), "a \\qquad\\text{(b)}");
  EXPECT_EQ(words("a \\tag{\\star}"), "a \\qquad (\\star) ");
  EXPECT_EQ(words("\\begin{align} \\tag{1} a &= b\\\\ c \\tag{2}\\end{align}"),
            "\\begin{align}  a &= b\\qquad\\text{(1)}\\\\ c \\qquad\\text{(2)}\\end{align}");
  EXPECT_EQ(words("\\tag{1} \\begin{matrix}a\\\\b\\end{matrix}"),
            " \\begin{matrix}a\\\\b\\end{matrix}\\qquad\\text{(1)}");
  // none at all
  for (const char* same : {"\\tag", "\\tag 1", "\\tag{1", "\\tagged{1}", "a_{\\tag"})
    EXPECT_EQ(words(same), same);
}

TEST(Formulas, HaveUprightLettersOneByOne) {
  EXPECT_EQ(
      formulas_for_browsers("<p><mi>a</mi></p><math><mi>a</mi><mstyle mathvariant=\"normal\">"
                            "<mi>b</mi><mstyle><mi>c</mi></mstyle></mstyle><mi>d</mi></math>"),
      "<p><mi>a</mi></p><math><mi>a</mi><mstyle mathvariant=\"normal\"><mi "
      "mathvariant=\"normal\">b</mi><mstyle><mi "
      "mathvariant=\"normal\">c</mi></mstyle></mstyle><mi>d</mi></math>");
}

}  // namespace
}  // namespace polhode
