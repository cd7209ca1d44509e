// SPDX-License-Identifier: MIT
#include "lecture/documents/lost_words.h"

#include <gtest/gtest.h>

#include "lecture/decks.h"
#include "lecture/documents/documents.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::deck_of;
using Lost = std::vector<std::string>;

constexpr std::size_t kMost = 5;

Figure no_figure(const DeckPicture& picture) {
  return {&picture, {}, "there is none"};
}

TEST(LostWords, AreNoneInAnyDocument) {
  const Deck deck = deck_of(test::kAllKinds);
  ASSERT_TRUE(deck.problems.empty());
  const test::TemporaryFolder folder;
  const Reveal reveal = {"4", "css", "js", ""};
  EXPECT_EQ(lost_words(deck, make_page(deck, no_figure), DocumentForm::html, kMost), Lost());
  EXPECT_EQ(lost_words(deck, make_slides(deck, no_figure, reveal), DocumentForm::html, kMost),
            Lost());
  EXPECT_EQ(lost_words(deck, make_handout_html(deck, no_figure), DocumentForm::html, kMost),
            Lost());
  EXPECT_EQ(lost_words(deck, make_beamer(deck, no_figure), DocumentForm::latex, kMost), Lost());
  EXPECT_EQ(
      lost_words(deck, make_pptx(deck, no_figure, folder.path()), DocumentForm::office, kMost),
      Lost());
}

TEST(LostWords, AreThoseOfTheDeckThatADocumentLacks) {
  const Deck deck = deck_of("---\ntitle: Tops\n---\n\nA top *spins* and spins.\n\n`x = 5kg`\n");
  const auto lost = [&](const std::string& html) {
    return lost_words(deck, html, DocumentForm::html, kMost);
  };
  const std::string all = "<h1>Tops</h1><p>A top <b>spins</b> and spins.</p><pre>x = 5kg</pre>";
  EXPECT_EQ(lost(all), Lost());
  EXPECT_EQ(lost(""), (Lost{"Tops", "A", "top", "spins", "and"}));
  EXPECT_EQ(lost("<h1>Tops</h1><p>A top spins.</p><pre>x = 5</pre>"), (Lost{"spins", "and", "kg"}));
  EXPECT_EQ(lost("<script>x = 5kg</script><h1>Tops</h1><p>A top spins and spins.</p>"),
            (Lost{"x", "5", "kg"}));
  EXPECT_EQ(lost_words(deck, "<p>Tops</p>", DocumentForm::html, 1), Lost{"A"});
  const Deck code = deck_of("1. > ```cpp\n   > a = \"\\nbc94\";\n   > ```\n");
  EXPECT_EQ(lost_words(code, "> a = \"\\nbc94\";", DocumentForm::latex, kMost), Lost());
  EXPECT_EQ(lost_words(deck, "\\title{Tops}A top \\emph{spins} x = 5kg", DocumentForm::latex, 9),
            (Lost{"spins", "and"}));
}

TEST(LostWords, AreAlsoSymbolsFormulasAndLinks) {
  const Deck deck = deck_of("A → $x$ and $y$ [b](https://a.org/b%20c?d=1&e) ✓\n");
  const auto lost = [&](const std::string& html) {
    return lost_words(deck, html, DocumentForm::html, kMost);
  };
  const std::string link = "<a href=\"https://a.org/b%20c?d=1&amp;e\">b</a>";
  EXPECT_EQ(lost("<p>A → <math>x</math> and <math>y</math> " + link + " ✓</p>"), Lost());
  EXPECT_EQ(lost("<p>A <math>x</math> and b</p>"),
            (Lost{"→", "✓", "1 of 2 formulas", "the link to https://a.org/b%20c?d=1&e"}));
}

// pandoc writes U+FE0E behind some arrows in pages
TEST(LostWords, AreNoArrowsThatTouchLetters) {
  const Deck deck = deck_of("The reaction A↔B. ↩x\n");
  EXPECT_EQ(lost_words(deck, make_page(deck, no_figure, ""), DocumentForm::html, kMost), Lost());
}

TEST(LostWords, AreReadFromWholeSlides) {
  const Deck deck = deck_of("Words.\n");
  const test::TemporaryFolder folder;
  const std::string slides = make_pptx(deck, no_figure, folder.path());
  EXPECT_EQ(lost_words(deck_of("Words and more.\n"), slides, DocumentForm::office, kMost),
            (Lost{"and", "more"}));
  for (const std::string& broken : {slides.substr(0, slides.size() / 2), std::string("PK")})
    EXPECT_THROW(lost_words(deck, broken, DocumentForm::office, kMost), Error);
}

}  // namespace
}  // namespace polhode
