// SPDX-License-Identifier: MIT
#include "lecture/documents/latex.h"

#include <gtest/gtest.h>

#include "lecture/deck/pandoc.h"
#include "lecture/decks.h"
#include "lecture/documents/documents.h"
#include "support/words.h"

namespace polhode {
namespace {

using test::count_of;
using test::deck_of;
using test::has;

// a deck as LaTeX, with its preamble
std::string tex_of(const std::string& text) {
  Deck deck = deck_of(text);
  settle_formulas(deck, text);
  EXPECT_TRUE(deck.problems.empty()) << deck.problems.front().what();
  return write_document(for_latex(deck.tree(deck.blocks)), {"-t", "beamer", "-s"}).text;
}

TEST(Latex, HasCharactersThatItsFontsLackAsMathematics) {
  const std::string tex = tex_of("A ω₁₂ ≠ 10⁻² ± 3 °C, x³\n\n`Ω ≤ 1` and $θ²$\n");
  EXPECT_TRUE(has(tex, "A \\(\\omega\\)\\({}_{12}\\) \\(\\neq\\) 10\\({}^{-2}\\) ± 3 °C,"))
      << tex.substr(tex.find("begin{document}"));
  for (const char* declared : {"{03A9}{\\ensuremath{\\Omega}}",
                               "{2264}{\\ensuremath{\\le}}",
                               "{03B8}{\\ensuremath{\\theta}}",
                               "{00B2}{\\ensuremath{{}^{2}}}"})
    EXPECT_TRUE(has(tex, std::string("\\DeclareUnicodeCharacter") + declared)) << declared;
}

TEST(Latex, TellsCharactersThatItDoesNotHave) {
  EXPECT_EQ(characters_without_latex(deck_of("- [ ] a\n- [x] b\n")), std::vector<std::string>());
  EXPECT_EQ(characters_without_latex(deck_of("# é ω中\n\n`中` $x$ “a” – ½ 😀\n")),
            (std::vector<std::string>{"中 (U+4E2D)", "😀 (U+1F600)"}));
}

// what pandoc takes as characters are commands of TeX
TEST(Latex, HasFormulasThatItCanSet) {
  const std::string tex = tex_of(
      "$\\text{50 % of a_b & c^d # $e_1$} f_1 \\%$ and $g % h\n+ i$\n\n"
      "$$\\begin{align*} a &= b\\\\ c &= d\\end{align*}$$\n\n"
      "$$\\begin{eqnarray} a &=& b\\end{eqnarray}$$\n\n$\\bm{a} = \\mathscr{L}$\n");
  EXPECT_TRUE(has(tex, "\\(\\text{50 \\%{} of a\\_b \\& c\\^{}d \\# $e_1$} f_1 \\%\\)"));
  EXPECT_TRUE(has(tex, "\\(g") && !has(tex, "% h"));
  EXPECT_TRUE(has(tex, "\\[\\begin{aligned} a &= b\\\\ c &= d\\end{aligned}\\]"));
  EXPECT_TRUE(has(tex, "\\[\\begin{array}{rcl} a &=& b\\end{array}\\]"));
  EXPECT_TRUE(has(tex, "\\usepackage{bm}"));
  EXPECT_TRUE(has(tex, "\\providecommand{\\mathscr}{\\mathcal}"));
}

// the first line that is the end of a frame ends it, also among lines of code
TEST(Latex, HasCodeThatEndsNoSlide) {
  const std::string tex = tex_of("## A\n\n```\n\\end{frame}\n\\input{a}\n```\n");
  EXPECT_EQ(count_of(tex, "\\end{frame}"), 1U);
  EXPECT_FALSE(has(tex, "\\input{a}"));
  EXPECT_TRUE(has(tex, "\\textbackslash{}end\\{frame\\}"));
}

// arguments of commands hold neither lines as they are nor, in footnotes, paragraphs
TEST(Latex, HasCodeInNotesAndFootnotesAsWords) {
  const std::string tex = tex_of(
      "## A\n\na[^1]\n\n[^1]: b\n\n    > c\n\n        d e\n\n::: notes\n```c\nf\n g\n```\n:::\n");
  EXPECT_TRUE(has(tex, "{b\\\\\n  c\\\\\n  \\texttt{d\\ e}}")) << tex.substr(tex.find("{A}"));
  EXPECT_TRUE(has(tex, "\\note{\\texttt{f}\\strut \\\\\n\\texttt{\\ g}}"));
  EXPECT_FALSE(has(tex, "erbatim}"));
}

TEST(Latex, HasCodeToWhichLinksLead) {
  const std::string tex = tex_of("## A\n\n`a`{#b .c} [d](#b)\n");
  EXPECT_TRUE(has(tex, "\\hypertarget{b}{\\texttt{a}}") ||
              has(tex, "\\protect\\hypertarget{b}{}{\\texttt{a}}") ||
              has(tex, "\\phantomsection\\label{b}{\\texttt{a}}"))
      << tex.substr(tex.find("{A}"));
}

TEST(Latex, HasOnlyLanguagesThatBabelHas) {
  EXPECT_TRUE(has(tex_of("---\nlang: de-CH\n---\n\nA\n"), "german"));
  EXPECT_TRUE(has(tex_of("---\nlang: fr-CA\n---\n\nA\n"), "french"));
  EXPECT_FALSE(has(tex_of("---\nlang: zh\n---\n\nA\n"), "babel"));
}

// they are written to files
// a title of the frame, and a star or an argument of the line break
TEST(Latex, HasWordsThatAreNoArgumentsOfCommands) {
  const std::string tex = tex_of(
      "## A\n\nb\n\n---\n\n[c] d\n\ne\\\n\\* f\n\n| g\n| [h]\n\n"
      "| i | j |\n|---|---|\n| \\*\\* | k |\n\n---\n\n[l]{#m} *n*\n");
  EXPECT_TRUE(has(tex, "\\begin{frame}\n\\relax{[}c{]} d")) << tex.substr(tex.find("begin{doc"));
  EXPECT_TRUE(has(tex, "e\\\\\n\\relax* f"));
  EXPECT_TRUE(has(tex, "g\\\\\n\\relax{[}h{]}"));
  EXPECT_TRUE(has(tex, "\\relax** & k"));
  EXPECT_TRUE(has(tex, "\\begin{frame}\n\\relax\\protect\\hypertarget{m}") ||
              has(tex, "\\begin{frame}\n\\relax\\phantomsection\\label{m}"));
}

// beamer shows no sections within a slide
TEST(Latex, HasTitlesWithinWhatIsOnSlidesAsWords) {
  const std::string tex = tex_of(
      "## A\n\n> ### B {#b}\n>\n> c\n\n- #### D\n\n  e\n\nF\n\n:   ### G\n\n    [h](#b)\n\n"
      "+---------+\n| i       |\n+=========+\n| ### J   |\n|         |\n| k       "
      "|\n+---------+\n");
  const std::string slides = tex.substr(tex.find("begin{document}"));
  EXPECT_FALSE(has(slides, "section{") || has(slides, "paragraph{")) << slides;
  for (const char* title : {"B", "D", "G", "J"})
    EXPECT_TRUE(has(tex, "\\textbf{" + std::string(title) + "}")) << title;
}

// lines in cells do not wrap, and stand beyond the page
TEST(Latex, HasFootnotesOfTablesInOneLine) {
  const std::string tex =
      tex_of("| A | b |\n|---|---|\n| c[^1] | d |\n\n[^1]: E:\n\n    1. f\\\n       g\n    2. h\n");
  EXPECT_TRUE(has(tex, "\\footnotetext<.->{E: 1. f g 2. h}") || has(tex, "{E: 1. f g 2. h}"))
      << tex.substr(tex.find("begin{doc"));
  EXPECT_FALSE(has(tex, "vtop"));
}

TEST(Latex, HasNumbersThatItDoesNotCount) {
  std::string list;
  for (int i = 0; i < 28; ++i)
    list += i == 0 ? "a) x\n" : "b) x\n";
  const std::string tex = tex_of(list + "\nB\n\n99999999999. y\n");
  EXPECT_TRUE(has(tex, "z) x") && has(tex, "aa) x") && has(tex, "ab) x"));
  EXPECT_TRUE(has(tex, "99999999999. y"));
}

TEST(Latex, HasTitlesThatCanBeCopied) {
  const std::string tex =
      tex_of("# A $\\begin{array}{c}a\\\\\\hline b\\end{array}$ $\\underline{c}$\n");
  EXPECT_TRUE(has(tex, "\\(\\begin{array}{c}a\\\\ b\\end{array}\\)")) << tex;
  EXPECT_TRUE(has(tex, "\\robustify{\\underline}"));
}

// there ] would end the argument
TEST(Latex, HasBracketsOfFormulasInBracesWhereTheyAreArguments) {
  const std::string tex = tex_of(
      "# Part $[a]$^[foot]\n\n## A\n\n$x \\in [0,1]$\n:   closed\n\n"
      "| a | b |\n|---|---|\n| c | d |\n\n: Table $[c]$^[foot]\n");
  for (const char* hidden : {"\\item[\\({x \\in [0,1]}\\)]", "\\({[a]}\\)", "\\({[c]}\\)"})
    EXPECT_TRUE(has(tex, hidden)) << hidden << tex.substr(tex.find("begin{document}"));
}

// pandoc leaves words that have a name out of running heads
TEST(Latex, HasTitlesWithAllTheirWords) {
  const std::string tex = tex_of("# [alpha]{#a} beta\n\n## [gamma]{#b}\n\n[c](#a)\n");
  const std::size_t part = tex.find("\\section[");
  ASSERT_NE(part, std::string::npos);
  const std::string short_title = tex.substr(part, tex.find("]{", part) - part);
  EXPECT_TRUE(has(short_title, "alpha") && has(short_title, "beta")) << short_title;
  EXPECT_TRUE(has(tex, "{a}"));
}

TEST(Latex, HasTablesAndListsOfFootnotesAsWords) {
  const std::string tex = tex_of(
      "## A\n\na[^1]\n\n[^1]: b\n\n    | c | d |\n    |---|---|\n    | e | f |\n\n    1. g\n\n    "
      "# h\n");
  EXPECT_TRUE(has(tex, "{b\\\\\n  c \\textbar{} d\\\\\n  e \\textbar{} f\\\\\n  1. g\\\\\n  h}"))
      << tex.substr(tex.find("{A}"));
}

TEST(Latex, HasQuotationsThatAreNoDeeperThanThree) {
  const std::string tex = tex_of("## A\n\n> > > > > > > > a\n");
  EXPECT_EQ(count_of(tex, "\\begin{quote}"), 3U);
  EXPECT_TRUE(has(tex, "a\n"));
}

TEST(Latex, HasListsThatAreNoDeeperThanThree) {
  const std::string tex = tex_of("## A\n\n- a\n  - b\n    - c\n      - d\n        1. e\n");
  EXPECT_EQ(count_of(tex, "\\begin{itemize}"), 3U);
  EXPECT_EQ(count_of(tex, "\\begin{enumerate}"), 0U);
  EXPECT_TRUE(has(tex, "• d\n") && has(tex, "1. e\n")) << tex.substr(tex.find("{A}"));
}

}  // namespace
}  // namespace polhode
