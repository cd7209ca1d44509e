// SPDX-License-Identifier: MIT
#include "lecture/documents/document_warnings.h"

#include <gtest/gtest.h>

#include "image/png.h"
#include "lecture/decks.h"
#include "lecture/tiny_pictures.h"
#include "support/flat_image.h"
#include "support/run.h"
#include "support/words.h"

namespace polhode {
namespace {

using test::deck_of;
using test::has;

TEST(DocumentWarnings, PicturesForPagesAndLettersWithoutLatex) {
  Deck deck = deck_of("A \u4e2d\n");
  deck.images = {"a.png", "b.svg", "c.webp", "b.svg"};
  EXPECT_TRUE(document_warnings(deck, "html").empty());
  EXPECT_EQ(document_warnings(deck, "pptx").size(), 2U);
  EXPECT_EQ(document_warnings(deck, "beamer"),
            (std::vector<std::string>{
                "b.svg is shown by its description: only browsers show .svg and .webp",
                "c.webp is shown by its description: only browsers show .svg and .webp",
                "pdflatex has no \u4e2d (U+4E2D); lualatex has, with a font that has it"}));
}

TEST(DocumentWarnings, PowerPointHasNoWidths) {
  const std::vector<std::string> told = {
      "widths of pictures and columns are left out: in PowerPoint both fill their places"};
  const test::TemporaryFolder folder;
  write_png(folder / "a.png", test::flat_image(64, 36, 1, 2, 3), false);
  const Deck small = parse_deck("![A](a.png){width=20%}\n", "deck.md", {folder.path(), false});
  EXPECT_EQ(document_warnings(small, "pptx"), told);
  EXPECT_TRUE(document_warnings(small, "html").empty());
  const Deck columns = deck_of(
      ":::: columns\n\n::: {.column width=\"30%\"}\nA\n:::\n\n::: {.column width=\"70%\"}\nB\n:::"
      "\n\n::::\n");
  EXPECT_EQ(document_warnings(columns, "pptx"), told);
}

TEST(DocumentWarnings, NumbersOfLinesAreForLatex) {
  const Deck deck = deck_of("```{.cpp .numberLines}\nint a;\n```\n");
  EXPECT_TRUE(document_warnings(deck, "beamer").empty());
  for (const char* output : {"html", "slides", "handout", "pptx"}) {
    EXPECT_EQ(document_warnings(deck, output),
              std::vector<std::string>{
                  "lines of code have no numbers (.numberLines): only LaTeX writes them"});
  }
}

TEST(DocumentWarnings, LanguagesFromRightToLeftAreForPages) {
  Deck deck = deck_of("---\nlang: he\n---\n\nA\n");
  const std::vector<std::string> told = {
      "he is written from right to left: only pages lay out lines so, here they begin at the left"};
  EXPECT_EQ(document_warnings(deck, "pptx"), told);
  EXPECT_EQ(document_warnings(deck, "beamer"), told);
  EXPECT_TRUE(document_warnings(deck, "html").empty());
}

// a photo of a camera that was held on its side: Exif with an orientation before the picture
TEST(DocumentWarnings, PhotosAreTurnedInPagesAlone) {
  const test::TemporaryFolder folder;
  const auto warnings = [&](int orientation, const char* output) {
    test::write_text(folder / "a.jpg", test::tiny_jpeg(orientation));
    const Deck deck = parse_deck("![A](a.jpg)\n", "deck.md", {folder.path(), false});
    return document_warnings(deck, output);
  };
  constexpr int kUpright = 1, kOnItsSide = 6;
  for (const char* output : {"pptx", "beamer"}) {
    EXPECT_TRUE(warnings(kUpright, output).empty());
    EXPECT_EQ(warnings(kOnItsSide, output),
              std::vector<std::string>{
                  "a.jpg lies as its pixels do: only pages turn it as its camera was held; turn "
                  "the file, as `exiftran -ai` does"});
  }
  EXPECT_TRUE(warnings(kOnItsSide, "html").empty());
}

// a letter of no script has no font anywhere
TEST(DocumentWarnings, LettersThatNoFontHasAreBoxesInHandouts) {
  EXPECT_TRUE(document_warnings(deck_of("Ä é e\u0301 Ω → x\n"), "handout").empty());
  const std::string told =
      "no font here has \U000ffffd (U+FFFFD), which become boxes; install one that has them, such "
      "as fonts-noto-cjk for Chinese, Japanese and Korean";
  EXPECT_EQ(document_warnings(deck_of("a \U000ffffd \U000ffffd\n"), "handout"),
            std::vector<std::string>{told});
  std::string many;
  for (int i = 0; i < 12; ++i)
    many += "\xf3\xbf\xbe" + std::string(1, static_cast<char>(0x80 + i)) + " ";
  const std::vector<std::string> of_many = document_warnings(deck_of(many), "handout");
  ASSERT_EQ(of_many.size(), 1U);
  EXPECT_TRUE(has(of_many[0], "(U+FFF89) and 2 more, which")) << of_many[0];
}

}  // namespace
}  // namespace polhode
