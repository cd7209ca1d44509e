// SPDX-License-Identifier: MIT
#include "lecture/deck/dropped_words.h"

#include <gtest/gtest.h>

#include "lecture/deck/pandoc.h"
#include "lecture/decks.h"

namespace polhode {
namespace {

using Lost = std::vector<std::string>;

constexpr std::size_t kMost = 5;

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
  EXPECT_EQ(dropped(test::kAllKinds), Lost());
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
  // references to examples
  EXPECT_EQ(
      dropped("(@mass) a\n(@) b\n\nAs @mass says [@mass] (see @mass, @mass; @mass-energy).\n"),
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

}  // namespace
}  // namespace polhode
