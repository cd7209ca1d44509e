// SPDX-License-Identifier: MIT
#include "lecture/deck/formulas.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Formulas, HaveTheirNumbersAtTheEndOfTheirRows) {
  const auto words = whole_formula;
  EXPECT_EQ(words("a \\tag{1}"), "a \\qquad\\text{(1)}");
  EXPECT_EQ(words("\\tag{1} a"), " a\\qquad\\text{(1)}");
  EXPECT_EQ(words("a \\tag*{b}"), "a \\qquad\\text{b}");
  EXPECT_EQ(words("a \\tag{\\text{b}}"), "a \\qquad\\text{(b)}");
  EXPECT_EQ(words("a \\tag{\\star}"), "a \\qquad (\\star) ");
  EXPECT_EQ(words("\\begin{align} \\tag{1} a &= b\\\\ c \\tag{2}\\end{align}"),
            "\\begin{align}  a &= b\\qquad\\text{(1)}\\\\ c \\qquad\\text{(2)}\\end{align}");
  EXPECT_EQ(words("\\tag{1} \\begin{matrix}a\\\\b\\end{matrix}"),
            " \\begin{matrix}a\\\\b\\end{matrix}\\qquad\\text{(1)}");
  EXPECT_EQ(words("a \\tag{$b$\\%}"), "a \\qquad\\text{($b$\\%)}");
  EXPECT_EQ(words("\\tagged{1}"), "\\tagged{1}");
  for (const char* open : {"\\tag", "\\tag 1", "\\tag{1", "a_{\\tag", "\\label 1"})
    EXPECT_THROW(words(open), Error) << open;
}

// what it does not read it cannot refuse
TEST(Formulas, HaveNothingThatPandocSkips) {
  EXPECT_EQ(whole_formula("a % } \\] \\input{b}\n+ c % d"), "a \n+ c ");
  EXPECT_EQ(whole_formula("a \\% b \\text{5 % c \\% $d % e\n$}"),
            "a \\% b \\text{5 \\% c \\% $d \n$}");
  EXPECT_EQ(whole_formula("a \\label{ \\] \\evil }b"), "a b");
  for (const char* end : {"a \\] b", "\\( a", "\\begin{x}\\)", "\\mathrm{\\[}"})
    EXPECT_THROW(whole_formula(end), Error) << end;
  EXPECT_NO_THROW(whole_formula("a \\\\[2pt] \\text{b \\(c\\)} \\left[ d \\right)"));
}

TEST(Formulas, HaveUprightLettersOneByOne) {
  EXPECT_EQ(
      formulas_for_browsers("<p><mi>a</mi></p><math><mi>a</mi><mstyle mathvariant=\"normal\">"
                            "<mi>b</mi><mstyle><mi>c</mi></mstyle></mstyle><mi>d</mi></math>"),
      "<p><mi>a</mi></p><math><mi>a</mi><mstyle mathvariant=\"normal\"><mi "
      "mathvariant=\"normal\">b</mi><mstyle><mi "
      "mathvariant=\"normal\">c</mi></mstyle></mstyle><mi>d</mi></math>");
}

// pandoc reads them as other quantities
TEST(WholeFormula, HasNoUnitsThatWouldBeOthers) {
  for (const char* tex : {R"(\SI{7.9}{\gram\per\cubic\centi\metre})",
                          R"(\SI{9}{\square \kilo\metre})",
                          R"(\SI{5}{\deca\metre})",
                          R"(\SI{3}{\metre\newton})",
                          R"(\SI{3}{\meter \second})",
                          R"(\num{1+2i})"})
    EXPECT_THROW(whole_formula(tex), Error) << tex;
  for (const char* tex : {R"(\SI{7.9}{\gram\per\centi\metre\cubed})",
                          R"(\SI{3}{\metre\per\second\squared})",
                          R"(\SI{3}{\newton\metre})",
                          R"(\SI{3}{\square\metre})",
                          R"(\square x)",
                          R"(\num{1.5e3})"})
    EXPECT_EQ(whole_formula(tex), tex);
}

TEST(WholeFormula, KeepsCommasInNumbers) {
  EXPECT_EQ(whole_formula("f(1{,}25, x) = 1{,}5"), "f(1\\text{,}25, x) = 1\\text{,}5");
  for (const char* tex : {"a{,}b", "1,5", "{,}", "\\text{1{,}5}"})
    EXPECT_EQ(whole_formula(tex), tex);
}

}  // namespace
}  // namespace polhode
