// SPDX-License-Identifier: MIT
#include "lecture/documents/lost_words.h"

#include <gtest/gtest.h>

#include "lecture/deck/dropped_words.h"
#include "lecture/deck/pandoc.h"
#include "lecture/decks.h"
#include "lecture/documents/documents.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::deck_of;
using Lost = std::vector<std::string>;

constexpr std::size_t kMost = 5;

// every kind of words that a deck has
constexpr const char* kAllKinds = R"(---
title: A *title*
author: [Ann One, Bo Two]
---

# Part[^1]

## Slide with `code_word` and 10⁻⁷

Words un*joined*, "quoted ~~struck~~", café, Ω and 3² [@cited, p. 3], naïve…dots – and so_on → [there](https://example.org/a%20b?c=d&e=f#g).

- One
  - Two^raised^ [small]{.smallcaps}

> Said

```cpp
std::puts("\nabout 5kg");  // \alpha
```

| Head^[inside] | more |
|---|---|
| cell | `other` |

: What it shows

Term
:   Meaning

$$x^2$$

::: notes
Say [this](https://example.org) and $y$.

| a1 | b2 |
|---|---|
| c3 | d4 |
:::

[^1]: The footnote.
)";

Figure no_figure(const DeckPicture& picture) {
  return {&picture, {}, "there is none"};
}

TEST(LostWords, AreNoneInAnyDocument) {
  const Deck deck = deck_of(kAllKinds);
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

std::vector<std::string> dropped(const std::string& text) {
  std::vector<std::string> list;
  for (const DroppedWord& one : dropped_words(text, read_markdown(text), kMost))
    list.push_back(fmt::format("{} {}", one.line, one.word));
  return list;
}

TEST(DroppedWords, AreThoseThatPandocDoesNotRead) {
  EXPECT_EQ(dropped("A [b].\n\n[1]: Landau, Mechanics\n"), (Lost{"3 Landau", "3 Mechanics"}));
  EXPECT_EQ(dropped("| a | b |\n|---|---|\n| c | d | extra |\n"), Lost{"3 extra"});
  EXPECT_EQ(dropped("A[^1]\n\n[^1]: b\n\n[^2]: never used\n"), (Lost{"5 never", "5 used"}));
}

// as names of titles, of units and of what trees of pandoc are made of; also where other words hold
// them
TEST(DroppedWords, AreFoundWhateverElseHasTheirLetters) {
  const std::string row = "\n\n| a1 | b2 |\n|---|---|\n| c3 | d4 | ";
  for (const char* word :
       {"coin", "a",     "c",       "m",     "s",   "A",   "C",   "I",    "ab",    "able", "table",
        "t",    "width", "default", "Plain", "Str", "$m$", "`c`", "head", "plain", "e",    "½",
        "ℏ",    "ℝ³",    "µ",       "°",     "€",   "№",   "０",  "⁻",    "𝐱"}) {
    const std::string bare = std::string(word) == "$m$"   ? "m"
                             : std::string(word) == "`c`" ? "c"
                                                          : word;
    const std::string before =
        std::string("# The coin {-}\n\nOf the [coin](#the-coin), [The coin], ") +
        "<https://example.org/coin>, a1 able, heads, tables[^1] and `class`.\n\n" +
        "[^1]: A footnote.";
    EXPECT_EQ(dropped(before + row + word + " |\n"), Lost{"9 " + bare}) << word;
  }
  EXPECT_EQ(dropped("## The coin\n\n[^n]: coin\n"), Lost{"3 coin"});
  EXPECT_EQ(dropped("## Plain\n\nOne\ncoin. Two[^m]\n\n[^m]: A coin.\n\n[^n]: Plain coin\n"),
            (Lost{"8 Plain", "8 coin"}));
  // which of several is lost is seen by pandoc alone
  EXPECT_EQ(dropped("The red fox.[^1]\n\n[^1]: The red fox runs.\n\n[^2]: The red fox "
                    "sleeps.\n\nThe red fox again.\n"),
            (Lost{"5 The", "5 red", "5 fox", "5 sleeps"}));
  EXPECT_EQ(dropped("| a | b |\n|---|---|\n| c | 100 | and 100 |\n| c | 100 | exact |\n\nand\n"),
            (Lost{"3 and", "3 100", "4 exact"}));
  EXPECT_EQ(dropped("---\ntitle: no\n---\n\n| a | b |\n|---|---|\n| yes | no | no |\n\nno\n"),
            Lost{"7 no"});
  EXPECT_EQ(dropped("[a](https://b.org/c) of c\n\n[d]: https://b.org/c\n\n[e](https://b.org/c)\n"),
            (Lost{"3 https", "3 b", "3 org", "3 c"}));
}

// what is used twice is in pandoc's tree twice
TEST(DroppedWords, AreFoundBesideFootnotesAndReferencesThatAreUsedTwice) {
  EXPECT_EQ(dropped("A[^a] b[^a].\n\n[^a]: The spin.\n\n[^b]: The spin.\n"),
            (Lost{"5 The", "5 spin"}));
  EXPECT_EQ(
      dropped("[a][r] [b][r] [r]\n\n[r]: https://c.org/x \"t\"\n\n[s]: https://c.org/x 't'\n"),
      (Lost{"5 https", "5 c", "5 org", "5 x", "5 t"}));
  EXPECT_EQ(
      dropped("[spin] [spin]\n\n[spin]: https://c.org\n\n| a | b |\n|---|---|\n| d | e | spin |\n"),
      Lost{"7 spin"});
  EXPECT_EQ(dropped("![a][i] ![b][i] [c](d.org) [c](d.org)[^a] e[^a]^[f g] ^[f g]\n\n[i]: <p.png> "
                    "\"t\"\n\n[^a]: - a\n"),
            Lost());
  EXPECT_EQ(dropped("Old K&ouml;nig 50\\%\n\n[^b]: König 50%\n\n[^c]: Old K\n"),
            (Lost{"3 50", "5 Old", "5 K"}));
  // what touches a space stays a word, and places of references are their own words
  EXPECT_EQ(dropped("a&nbsp;b\n\n[^b]: a c\n\n| b |\n|---|\n| http://d.org | b |\n"),
            (Lost{"3 a", "3 c", "7 b"}));
  EXPECT_EQ(dropped("[a][0] [b][0] http://c.org\n\n[0]: http://d.org\n\n[1]: https://e.org\n"),
            (Lost{"5 https", "5 e", "5 org"}));
}

TEST(DroppedWords, AreNoneInAWholeDeck) {
  EXPECT_EQ(dropped(kAllKinds), Lost());
  EXPECT_EQ(
      dropped("---\n# a comment\ntitle: A\n---\n\n12. b\n13. c\n\n(@good) d\n\nAs in (@good), "
              "&alpha; [e]{.underline} [f]{.smallcaps} [g][h]\n\n- [x] i\n\n"
              "[h]: https://example.org \"j k\"\n\n"
              "| l |\n|---|\n| m |\n\nTable: n\n"),
      Lost());
  // lists and references inside others
  EXPECT_EQ(dropped("Term\n:   7. a\n\nb[^1]\n\n[^1]: 1986. c\n\n-   8. d\n\n1.  (iv) e\n\n"
                    "> [f][key]\n>\n> [key]: https://example.org \"g\"\n"),
            Lost());
  // keys over two lines
  EXPECT_EQ(dropped("[a][long\nkey] b\n\n[long key]: https://example.org\n"), Lost());
  // names of titles, and links to them
  EXPECT_EQ(
      dropped("% Title of *a*\n  coin\n% B\n\n# Größe {-}\n\n## Coin {#the-coin .unlisted}\n\n"
              "[Größe] [a](#größe) [b](#gr%C3%B6%C3%9Fe) [c](#the-coin) [d][Coin]\n\n"
              "[e]{.ul} [f]{.underline} <a@example.org> [g](#film=a&t=2)\n"),
      Lost());
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
