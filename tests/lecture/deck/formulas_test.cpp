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
            "a \\% b \\text{5 \\%{} c \\%{} $d \n$}");
  EXPECT_EQ(whole_formula("a \\label{ \\] \\evil }b"), "a b");
  for (const char* end : {"a \\] b", "\\( a", "\\begin{x}\\)", "\\mathrm{\\[}"})
    EXPECT_THROW(whole_formula(end), Error) << end;
  EXPECT_NO_THROW(whole_formula("a \\\\[2pt] \\text{b \\(c\\)} \\left[ d \\right)"));
}

// pandoc reads them as other quantities
TEST(WholeFormula, HasNoUnitsThatWouldBeOthers) {
  for (const char* tex : {R"(\SI{7.9}{\gram\per\cubic\centi\metre})",
                          R"(\SI{9}{\square \kilo\metre})",
                          R"(\SI{5}{\deca\metre})",
                          R"(\SI{3}{\metre\newton\tothe{2}})",
                          R"(\num{1+2i})"})
    EXPECT_THROW(whole_formula(tex), Error) << tex;
  for (const char* tex : {R"(\SI{7.9}{\gram\per\centi\metre\cubed})",
                          R"(\SI{3}{\metre\per\second\squared})",
                          R"(\SI{3}{\square\metre})",
                          R"(\square x)",
                          R"(\num{1.5e3})"})
    EXPECT_EQ(whole_formula(tex), tex);
}

// siunitx prints them so, pandoc 1.2 ± .3 × 10⁻⁴ or nothing before the power
TEST(WholeFormula, HasNumbersWithDoubtsWrittenOut) {
  EXPECT_EQ(whole_formula(R"(\num{6.67430(15)e-11})"), R"({6.67430(15)\times 10^{-11}})");
  EXPECT_EQ(whole_formula(R"(a \num{1,2(3)}{b})"), R"(a {1.2(3)}{b})");
  EXPECT_EQ(whole_formula(R"(\SI{-1.2(3)e4}{\metre} b)"),
            R"({-1.2(3)\times 10^{4}}\,\si{\metre} b)");
  EXPECT_EQ(whole_formula(R"(\num{e5} + \num{-e5})"), R"({10^{5}} + {-10^{5}})");
  EXPECT_EQ(whole_formula(R"(\num{1.5 +- 0.2} \SI{1.2 \pm 0.3}{\kg})"),
            R"({1.5\pm 0.2} {(1.2\pm 0.3)}\,\si{\kg})");
  EXPECT_EQ(whole_formula(R"(\SI{1.2(3)}{\second\tothe{2}})"),
            R"({1.2(3)}\,\si{\second\tothe{2}})");
  EXPECT_EQ(whole_formula(R"(\num{1.5E3})"), R"({1.5\times 10^{3}})");
  for (const char* tex : {R"(\num{1.5e-3})", R"(\SI{2}{\kilo\gram})", R"(\num{1,5})", R"(\num{})"})
    EXPECT_EQ(whole_formula(tex), tex);
}

// newtons times metres times seconds are no newtons times milliseconds
TEST(WholeFormula, HasUnitsApart) {
  EXPECT_EQ(whole_formula(R"(\SI{3}{\newton\m \s})"),
            R"(\num{3}\,\si{\newton}\,\si{\m }\,\si{\s})");
  EXPECT_EQ(whole_formula(R"(a\si{\kilo\gram\metre\squared\per\second\squared}{b})"),
            R"(a\si{\kilo\gram}\,\si{\metre\squared\per\second\squared}{b})");
  EXPECT_EQ(whole_formula(R"(\SI{1.2(3)}{\square\metre\kelvin})"),
            R"({1.2(3)}\,\si{\square\metre}\,\si{\kelvin})");
  EXPECT_EQ(whole_formula(R"(\SI{}{\hour\watt})"), R"(\si{\hour}\,\si{\watt})");
}

// siunitx sets them upright, and their dots are products; for pandoc they are letters of a formula
TEST(WholeFormula, HasUnitsOfLettersUpright) {
  EXPECT_EQ(whole_formula(R"(\SI{9.81}{m/s^2} a)"), R"(\num{9.81}\,\mathrm{m}/\mathrm{s}^2 a)");
  EXPECT_EQ(whole_formula(R"(\unit{ kg.m^{2} . s^{-1}})"),
            R"(\mathrm{kg}\,\mathrm{m}^{2}\,\mathrm{s}^{-1})");
  EXPECT_EQ(whole_formula(R"(\SI{1.2(3)}{m s})"), R"({1.2(3)}\,\mathrm{m}\,\mathrm{s})");
  EXPECT_EQ(whole_formula(R"(\si{W/(m^2~K)})"), R"(\mathrm{W}/(\mathrm{m}^2\,\mathrm{K}))");
  EXPECT_EQ(whole_formula(R"(\si{\mu m})"), R"(\mathrm{μ}\mathrm{m})");
  EXPECT_EQ(whole_formula(R"(\si{°C})"), R"(\mathrm{°C})");
  EXPECT_EQ(whole_formula(R"(\si{\ohm m})"), R"(\si{\ohm}\mathrm{m})");
  EXPECT_EQ(whole_formula(R"(\si{{}^{\circ}C})"), R"({}^{\circ}\mathrm{C})");
  EXPECT_EQ(whole_formula(R"(\si{\mathrm{m}})"), R"(\si{\mathrm{m}})");
  for (const char* tex : {R"(\si{\kilo m})", R"(\si{m\per s})"})
    EXPECT_THROW(whole_formula(tex), Error) << tex;
}

// readers would take W/m²K for W/(m²K)
TEST(WholeFormula, HasNoUnitsBehindFractions) {
  for (const char* tex : {R"(\SI{5}{\watt\per\metre\squared\kelvin})",
                          R"(\si{\joule\per\kilo\gram\kelvin})",
                          R"(\unit{\per\second\metre})"})
    EXPECT_THROW(whole_formula(tex), Error) << tex;
  for (const char* tex :
       {R"(\SI{5}{\watt\per\metre\squared\per\kelvin})", R"(\unit{\per\milli\second})"})
    EXPECT_EQ(whole_formula(tex), tex);
}

// pandoc shows stars and positions, and takes brackets of a row for its distance
TEST(WholeFormula, HasRowsAsTexReadsThem) {
  EXPECT_EQ(whole_formula(R"(a \\* b)"), R"(a \\ b)");
  EXPECT_EQ(whole_formula(R"(a \\ [b,c] \\  *d)"), R"(a \\ {}[b,c] \\ {}*d)");
  EXPECT_EQ(whole_formula("a \\\\\n[b,c]"), "a \\\\ {}[b,c]");
  EXPECT_EQ(whole_formula(R"(a \\[\omega] b)"), R"(a \\ {}[\omega] b)");
  EXPECT_EQ(whole_formula(R"(a \\ [2 mm] b \\[-1.5ex] c \\ [\jot] d)"),
            R"(a \\[2 mm] b \\[-1.5ex] c \\[\jot] d)");
  EXPECT_EQ(whole_formula(R"(\begin{aligned}[t] a \end{aligned})"),
            R"(\begin{aligned} a \end{aligned})");
  EXPECT_EQ(whole_formula(R"(\begin{alignedat}[b]{2} a \end{alignedat})"),
            R"(\begin{alignedat}{2} a \end{alignedat})");
  EXPECT_EQ(whole_formula(R"(\begin{aligned} [t] &= b \end{aligned})"),
            R"(\begin{aligned} {}[t] &= b \end{aligned})");
  EXPECT_EQ(whole_formula(R"(\text{a \\ [b]})"), R"(\text{a \\ [b]})");
  EXPECT_THROW(whole_formula(R"(\begin{bmatrix*}[r] 1 \end{bmatrix*})"), Error);
}

TEST(WholeFormula, HasNothingThatPandocReadsInPart) {
  for (const char* tex : {R"(\mathop{\frac{a}{b}})",
                          R"(\mathop{a_1})",
                          R"(\text{Mart\'\i nez})",
                          R"(\text{a\~{}b})",
                          R"(\num[round-precision=2]{0.0123})",
                          R"(\SI{3}{\decibel})",
                          R"(\num{1,234.5})",
                          R"(\numlist{1;2})"})
    EXPECT_THROW(whole_formula(tex), Error) << tex;
  for (const char* tex : {R"(\mathop{\mathrm{grad}} f)", R"(\mathop{max}_x)", R"(\text{a}\i)"})
    EXPECT_EQ(whole_formula(tex), tex);
  EXPECT_EQ(whole_formula(R"(\bigl.f\bigr|_0 \Bigl<x\Bigr>)"),
            R"({}f\bigr|_0 \Big\langle x\Big\rangle )");
  EXPECT_EQ(whole_formula(R"(\Bigl\{a\bigm|b\Bigr\})"), R"(\Big\{a\big|b\Big\})");
}

// pandoc forgets it
TEST(WholeFormula, HasBlanksBehindCharactersInWords) {
  EXPECT_EQ(whole_formula(R"(\text{50\% of a \& b} \% c)"), R"(\text{50\%{} of a \&{} b} \% c)");
}

TEST(WholeFormula, KeepsCommasInNumbers) {
  EXPECT_EQ(whole_formula("f(1{,}25, x) = 1{,}5"), "f(1\\text{,}25, x) = 1\\text{,}5");
  for (const char* tex : {"a{,}b", "1,5", "{,}", "\\text{1{,}5}"})
    EXPECT_EQ(whole_formula(tex), tex);
}

}  // namespace
}  // namespace polhode
