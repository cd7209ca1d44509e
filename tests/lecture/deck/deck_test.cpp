// SPDX-License-Identifier: MIT
#include "lecture/deck/deck.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "image/png.h"
#include "lecture/decks.h"
#include "support/flat_image.h"
#include "support/run.h"
#include "support/words.h"

namespace polhode {
namespace {

using test::deck_of;
using test::problem_of;

// the message begins with `start`: the deck, the line and what is wrong
void expect_refused(const std::string& text, const std::string& start) {
  try {
    deck_of(text);
    ADD_FAILURE() << "was taken; expected " << start;
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::input);
    EXPECT_TRUE(std::string(error.what()).starts_with(start)) << error.what();
  }
}

TEST(Deck, PicturesOfScenesAreFound) {
  const Deck deck = deck_of(
      "---\ntitle: T\n---\n\n# One\n\n![The *space* cone](a%20b.toml){.film from=0 to=8}\n\n"
      "![](c.toml){.compare with=\"d.toml e.toml\"}\n\n![x](c.toml){.still at=2.5}\n");
  ASSERT_TRUE(deck.problems.empty()) << deck.problems.front().what();
  ASSERT_EQ(deck.pictures.size(), 3U);
  EXPECT_EQ(deck.pictures[0].kind, PictureKind::film);
  EXPECT_EQ(deck.pictures[0].scenes, std::vector<std::string>{"a b.toml"});
  EXPECT_EQ(deck.pictures[0].settings.at("to"), "8");
  EXPECT_EQ(plain_text(deck.pictures[0].caption), "The space cone");
  EXPECT_EQ(deck.pictures[1].scenes, (std::vector<std::string>{"c.toml", "d.toml", "e.toml"}));
  EXPECT_EQ(deck.pictures[1].line, 9);
  EXPECT_EQ(deck.pictures[2].line, 11);
  EXPECT_EQ(deck.pictures[2].name, "c-2");
}

TEST(Deck, WrongWordsGetTheirLineAndTheNearestOne) {
  EXPECT_EQ(problem_of("# One\n\n![](a.toml){.filn}\n"),
            "deck.md:3: unknown kind of picture '.filn' (did you mean 'film'?)");
  EXPECT_EQ(problem_of("\n\n![](a.toml){.film form=2}\n"),
            "deck.md:3: a .film has no 'form' (did you mean 'from'?)");
  EXPECT_EQ(problem_of("# A\n\n![x](a.toml){.still at=0 at=1}\n"),
            "deck.md:3: a .still has 'at' twice here; leave one out");
  EXPECT_NE(problem_of("![](a.toml){.film .loop}\n").find("either"), std::string::npos);
  EXPECT_NE(problem_of("![](a.toml)\n").find("say what to make"), std::string::npos);
  EXPECT_NE(problem_of("x ![](a.toml){.film}\n").find("paragraph of its own"), std::string::npos);
  EXPECT_NE(problem_of("![](a.toml){.compare}\n").find("second scene"), std::string::npos);
  EXPECT_NE(problem_of("---\nheader-includes: x\n---\n").find("header-includes"),
            std::string::npos);
  EXPECT_NE(problem_of("---\nlang: '\"><script>'\n---\n").find("lang"), std::string::npos);
}

TEST(Deck, LinksWithinLeadSomewhere) {
  EXPECT_EQ(problem_of("# The top {#top}\n\n[up](#top) [film](#a) [slide](#/2)\n\n"
                       "![](a.toml){.film}\n\n[on](#the-end)\n\n# The end\n"),
            "none");
  EXPECT_EQ(problem_of("# The top {#top}\n\n[up](#tpo)\n"),
            "deck.md:3: no place is called '#tpo' (did you mean 'top'?)");
  EXPECT_EQ(problem_of("# One {#a}\n\n# Two {#a}\n"),
            "deck.md:3: a second '#a'; links lead to the first");
}

TEST(Deck, PicturesAreCalledAsTheDeckSays) {
  EXPECT_EQ(problem_of("![](a.toml){#\u00e9_1 .film}\n\n[on](#\u00e9_1)\n"), "none");
  // dots and other letters than those of files stay in them
  const Deck dots =
      deck_of("![](a.toml){#a.b .film}\n\n![](a.toml){#a .film}\n\n![](a.toml){#größe .film}\n");
  EXPECT_EQ(dots.pictures[0].place, "a.b");
  EXPECT_EQ(dots.pictures[1].place, "a");
  EXPECT_EQ(dots.pictures[2].place, "größe");
  // a picture without a name has that of its file, with a number if a place has it
  const Deck deck = deck_of(
      "# a\n\n![](a.toml){.film}\n\n![](b.toml){.film}\n\n"
      "![](b.toml){#x .film}\n\n![](b.toml){#x .film}\n");
  ASSERT_EQ(deck.pictures.size(), 4u);
  EXPECT_EQ(deck.pictures[0].place, "a-2");
  EXPECT_EQ(deck.pictures[1].place, "b");
  EXPECT_EQ(deck.pictures[2].place, "x");
  EXPECT_EQ(deck.pictures[3].place, "x-2");
}

TEST(Deck, OtherEncodingsAreRefusedWithTheirLine) {
  for (const auto& [text, start] : std::vector<std::pair<std::string, std::string>>{
           {"# One\n\nCaf\xE9\n", "deck.md:3: byte 0xe9 is not UTF-8"},
           {std::string("#\0 \0A\0", 6), "deck.md:1: byte 0x00 is not UTF-8"},
           {"\xFF\xFE#", "deck.md:1: byte 0xff is not UTF-8"}})
    expect_refused(text, start);
}

// slides that hold them are no XML
TEST(Deck, CharactersThatNoDocumentCanShowAreRefusedWithTheirLine) {
  for (const auto& [text, start] : std::vector<std::pair<std::string, std::string>>{
           {"# One\n\nb \x0b c\n", "deck.md:3: holds U+000B"},
           {"# One\n\nb &#11; c\n", "deck.md:3: holds U+000B"},
           {"# One\n\n`&#11;` &#xFFFE;\n", "deck.md:3: holds U+FFFE"},
           {"---\ntitle: \"a \\x01 b\"\n---\n\n# One\n", "deck.md: holds U+0001"}})
    expect_refused(text, start);
  EXPECT_NO_THROW(deck_of("# One\n\nA tab:\tand `&#11;` and &#233;\n"));
}

TEST(Deck, TextOfOthersStaysText) {
  for (const char* text : {"<script>alert(1)</script>\n",
                           "a <img src=x onerror=alert(1)> b\n",
                           "`<b>`{=html}\n",
                           "```{=latex}\n\\input{/etc/passwd}\n```\n",
                           "\\input{/etc/passwd}\n"}) {
    Deck deck = deck_of(text);
    for_each_node(deck.blocks, [](const Json& node) {
      EXPECT_NE(node["t"], "RawBlock");
      EXPECT_NE(node["t"], "RawInline");
    });
  }
  EXPECT_NE(problem_of("# A {onclick=\"alert(1)\"}\n").find("onclick"), std::string::npos);
  EXPECT_NE(problem_of("[a](b){style=\"x\"}\n"), "none");
  EXPECT_NE(problem_of("[x](javascript:alert(1))\n").find("link"), std::string::npos);
  EXPECT_NE(problem_of("[x](file:///etc/passwd)\n").find("link"), std::string::npos);
  EXPECT_EQ(problem_of("[x](https://example.org) [y](#film=a&t=2)\n"), "none");
  EXPECT_NE(problem_of("![x](http://example.org/a.png)\n"), "none");
  EXPECT_NE(problem_of("$\\input{/etc/passwd}$\n").find("\\input"), std::string::npos);
  EXPECT_NE(problem_of("$\\mbox{\\write18{ls}}$\n").find("\\write"), std::string::npos);
  EXPECT_NE(problem_of("$a^^5cb$\n").find("^^"), std::string::npos);
  EXPECT_EQ(problem_of("$\\left(\\frac{a}{b}\\right)\\letter$\n"), "none");
}

TEST(Deck, PicturesThatNobodyCanOpenGetTheirLine) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "words.png", "hello");
  test::write_text(folder / "short.png", "\x89PNG\r\n\x1a\n");
  test::write_text(folder / "words.jpg", "hello");
  test::write_text(folder / "words.webp", "RIFF");
  test::write_text(folder / "words.svg", "hello");
  write_png(folder / "right.png", test::flat_image(2, 2, 1, 2, 3), false);
  test::write_text(folder / "right.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  const auto problem = [&](const std::string& name) {
    const Deck deck =
        parse_deck(fmt::format("# A\n\n![x]({})\n", name), "deck.md", {folder.path(), false});
    return std::string(deck.problems.empty() ? "none" : deck.problems.front().what());
  };
  for (const std::string name : {"words.png", "short.png", "words.jpg", "words.webp", "words.svg"})
    EXPECT_TRUE(problem(name).starts_with(fmt::format("deck.md:3: '{}'", name))) << problem(name);
  EXPECT_EQ(problem("right.png"), "none");
  EXPECT_EQ(problem("right.svg"), "none");
}

TEST(Deck, FieldsOfSeveralParagraphsAreOne) {
  const Deck deck = deck_of("---\ntitle: |\n  a\n\n  b\nauthor:\n- |\n  c\n\n  d\n---\n\nText\n");
  EXPECT_EQ(deck.meta["title"]["t"], "MetaInlines");
  EXPECT_EQ(plain_text(deck.meta["title"]["c"]), "a b");
  EXPECT_EQ(plain_text(deck.meta["author"]["c"][0]["c"]), "c d");
}

TEST(Deck, FieldsAreTexts) {
  const auto problem = [](const std::string& field) {
    return problem_of("---\nlang: en\n" + field + "\n---\n\nText\n");
  };
  for (const char* field : {"author: A",
                            "author: [A, B]",
                            "author:\n- A\n- B",
                            "date: 2026 # or later",
                            "date: 2026-11-29",
                            "date: \"11.10\"",
                            "title: '1.50'",
                            "title: !!str 2024",
                            "author: [A, ~, B]",
                            "\"date\": 2024",
                            "title: 10^3^",
                            "title: 12 tops"}) {
    EXPECT_EQ(problem(field), "none") << field;
  }
  for (const auto& [field, words] : std::vector<std::pair<std::string, std::string>>{
           {"author: [{name: A, affiliation: B}, C]", "author must be a text"},
           {"author: [[A, B], C]", "author must be a text"},
           {"author: {name: A}", "author must be a text or a list of texts"},
           {"title: [a, b]", "title must be a text"},
           {"date: {day: 3}", "date must be a text"},
           {"title: yes", "title is no text; in quotes, as in title: \"yes\", it is one"},
           {"date: 11.10", "date is a number, which would be shown as 11.1; put it in quotes"},
           {"subtitle: A\nsubtitle: B", "subtitle is given twice; leave one out"},
           {"title: A\n---\n\nb\n\n---\ntitle: C", "title is given twice; leave one out"},
           {"title: 007", "title is a number, which would be shown as 7"},
           {"title: 12345678901234567890", "shown as 1."}}) {
    EXPECT_TRUE(problem(field).starts_with("deck.md:3: ")) << problem(field);
    EXPECT_TRUE(test::has(problem(field), words)) << problem(field);
  }
}

// those of a page and of reveal.js hide what has them
TEST(Deck, ClassesThatMeanNothingAreLeftOut) {
  const Deck deck = deck_of(
      "## A {.progress .columns}\n\n::: {.notes .controls}\na [b]{.skip} `c`{.python}\n:::\n\n"
      ":::: columns\n::: column\nd\n:::\n::::\n");
  EXPECT_TRUE(deck.problems.empty());
  EXPECT_EQ(deck.blocks[0]["c"][1][1], Json::array());
  EXPECT_TRUE(is_div(deck.blocks[1], "notes"));
  const Json& words = deck.blocks[1]["c"][1][0]["c"];
  EXPECT_EQ(words[2]["c"][0][1], Json::array());
  EXPECT_EQ(words[4]["c"][0][1], Json::array({"python"}));
  EXPECT_TRUE(is_div(deck.blocks[2], "columns"));
}

// which may show what elsewhere is a mistake
TEST(Deck, LinesAreNotThoseOfCode) {
  const char* mistake = "[a](#nowhere)";
  for (const std::string code : {"`[a](#nowhere)`",
                                 "``[a](#nowhere)``",
                                 "`` [a](#nowhere) ``",
                                 "a `b [a](#nowhere)\nc`",
                                 "` [a](#nowhere) ` `[a](#nowhere)`",
                                 "a[^1]\n\n[^1]: b `[a](#nowhere)`",
                                 "```\n\n[a](#nowhere)\n```",
                                 "- a\n\n  ~~~\n  [a](#nowhere)\n  ~~~",
                                 "> ```\n> [a](#nowhere)\n> ```",
                                 "    [a](#nowhere)"}) {
    const std::string text = code + "\n\nb\n\n";
    const auto line = 1 + std::count(text.begin(), text.end(), '\n');
    EXPECT_EQ(problem_of(text + mistake + "\n"),
              fmt::format("deck.md:{}: no place is called '#nowhere' (there are none)", line))
        << code;
    // nor where it stands behind
    EXPECT_EQ(problem_of(std::string(mistake) + "\n\nb\n\n" + code + "\n"),
              "deck.md:1: no place is called '#nowhere' (there are none)")
        << code;
  }
}

// as text of a slide, words for the speaker would be shown to all
TEST(Deck, BoxesThatAreNoneAreRefusedWithTheirLine) {
  const std::string good = "# A\n\n::: notes\nSay.\n:::\n\n";
  EXPECT_EQ(problem_of(good + "Write `:::` or ::: here.\n\n\\# one\n\n#1 is good\n"), "none");
  EXPECT_EQ(problem_of(good + "::: warning\nB\n:::\n"), "none");
  EXPECT_EQ(deck_of(good + "::: warning\nB\n:::\n\n::: warning\nC\n:::\n").remarks.size(), 1U);
  for (const char* open :
       {"::: notes\nB is said\n", "C\n::: notes\nB\n:::\n", "- C\n::: notes\nB is\n"})
    EXPECT_TRUE(test::has(problem_of(good + open), ": ':::' would be shown as it stands")) << open;
  for (const char* open : {":::\u00a0notes\nB\n:::\n",
                           "::: \"notes\"\nB\n:::\n",
                           "::: {.notes,}\nB\n:::\n",
                           "::: {.notes\nB\n:::\n",
                           "::: {#notes}\nB\n:::\n",
                           "::: `notes`\nB\n:::\n",
                           "#\u00a0Title\n"})
    EXPECT_NE(problem_of(good + open), "none") << open;
  for (const char* classes : {".notes .incremental", ".fragment .notes", ".notes .notes"}) {
    const Deck deck = deck_of(fmt::format("::: {{{}}}\nB\n:::\n", classes));
    EXPECT_EQ(deck.blocks[0]["c"][0][1], Json::array({"notes"})) << classes;
  }
  // where no box can begin
  for (const char* bad : {"| ::: notes\n| B\n| :::\n",
                          "**::: notes**\n\nB\n",
                          "C | ::: {.notes} |\n",
                          "A\u2028::: notes\u2028B\u2028:::\n",
                          "A\u0085:::{.notes}\u0085B\n",
                          "*a ::: note*\n"})
    EXPECT_TRUE(test::has(problem_of(bad), "would be shown as it stands")) << bad;
  EXPECT_EQ(problem_of("`::: notes` begins a box. ::: x\n"), "none");
  // or where LaTeX would show it
  EXPECT_EQ(problem_of("A[^1]\n\n[^1]: B\n\n    ::: notes\n    C is said\n    :::\n"),
            "deck.md:6: a footnote has no notes for the speaker; put their box behind it");
  EXPECT_TRUE(test::has(problem_of(good + "::: notes\nB is said\n"), "deck.md:7:"));
  EXPECT_EQ(problem_of(good + "::: note\nB\n:::\n"),
            "deck.md:7: 'note' means nothing to a deck (did you mean 'notes'?)");
  EXPECT_EQ(problem_of(good + "::: {.colmns}\nB\n:::\n"),
            "deck.md:7: 'colmns' means nothing to a deck (did you mean 'columns'?)");
}

TEST(Deck, AddressesOfLinksQuoteNoNumbers) {
  EXPECT_EQ(problem_of("# A\n\n[b](https://c.d/?e={inspect:f.toml#mass|%.3f})\n"),
            "deck.md:3: the address of a link quotes no numbers; write them there");
  EXPECT_EQ(problem_of("# A\n\n[b](https://c.d \"E {inspect:f.toml#mass}\")\n"),
            "deck.md:3: the title of a link quotes no numbers; write them there");
}

// elsewhere they would be shown to all
TEST(Deck, WordsForTheSpeakerAreInBoxesAlone) {
  const std::string good = "## A\n\n::: {.notes}\nSay.\n:::\n\n";
  for (const char* slip : {"## B {.notes}\n\nC\n",
                           "### B {.note}\n",
                           "``` {.notes}\nB\n```\n",
                           "[B]{.notes}\n",
                           "[B](https://example.org){.notes}\n",
                           "`B`{.notes}\n",
                           "<!-- B -->\n",
                           "<aside class=\"notes\">\n\nB\n\n</aside>\n",
                           "<div class=\"notes\">B</div>\n",
                           "## B<BR/>C\n",
                           "<notes>B</notes>\n",
                           "<? B ?>\n",
                           "B {.notes}\n",
                           "\\note{B}\n",
                           "\\pause\n",
                           "C.\\note{B}\n",
                           "C\\note{B}\n",
                           "C.\\note {B}\n",
                           "**C.\\note{B}**\n",
                           "\"\\note{B}\"\n",
                           "(\\note{B})\n",
                           "[\\note{B}](https://example.org)\n",
                           "C\\only<2>{B}\n",
                           "C.\\pause\n",
                           "C^[D.\\note{B}]\n",
                           "- C.\\note{B}\n",
                           "## C\\note{B}\n",
                           "| C\\note{B} |\n|---|\n| d |\n",
                           "C \\\\alpha\\note{B}\n",
                           ":: notes\nB\n::\n"})
    EXPECT_TRUE(problem_of(good + slip).starts_with("deck.md:7: '")) << problem_of(good + slip);
  EXPECT_EQ(problem_of(good + "a < b, <p> = <x>, a<b, <1>, `<br>`, <https://example.org>, <-, "
                              "<omega>, \\<br\\>, &lt;br&gt;, \\<aside>, `\\note`, $\\pi$, \\*, "
                              "C:\\note, {.5} and x::y, ..\\run, .\\run, \\\\host\\share, "
                              "\\\\alpha is written \\\\note{B}\n"),
            "none");
}

// each is looked for in all of the deck
TEST(Deck, WordsOfHtmlAndLatexAreLimited) {
  std::string deck;
  for (int i = 0; i < 1000; ++i)
    deck += "\\\\alpha\n";
  EXPECT_EQ(problem_of(deck), "none");
  EXPECT_EQ(problem_of(deck + "\n\\\\beta\n\\<br\\>\n"),
            "deck.md:1002: a deck may show 1000 words of HTML and LaTeX; show '\\beta' and what "
            "follows as code");
}

TEST(Deck, FieldsHaveNoNotesAndNoHtml) {
  for (const char* field : {"title: T <!-- B -->",
                            "title: T.\\note{B}",
                            "author: [A, B<br>C]",
                            "date: 2024 <aside class=\"notes\">B</aside>",
                            "title: |\n  A\n\n  ::: notes\n  B\n  :::"})
    EXPECT_TRUE(problem_of(fmt::format("---\n{}\n---\n\n# A\n", field)).starts_with("deck.md:2: "))
        << field;
  // what YAML has unescaped stands otherwise in the deck
  EXPECT_TRUE(
      problem_of("---\ntitle: \"T.\\\\note{B}\"\n---\n").starts_with("deck.md: 'T.\\note{B}'"));
}

TEST(Deck, WhatYamlReadsInItsOwnWayIsNotTold) {
  const Deck deck = deck_of(
      "---\ntitle: A # draft\nauthor: &ann \"Gr\\xFC\\u00dfe\"\ndate: |\n  a\n\n  b\n...\n\nc\n\n"
      "---\nlang: en # British\n---\n\n---\n\nd\n\n[1]: Landau\n\n---\n");
  EXPECT_TRUE(deck.problems.empty());
  ASSERT_EQ(deck.remarks.size(), 1U);
  EXPECT_TRUE(test::has(deck.remarks[0].what(), "deck.md:20: ")) << deck.remarks[0].what();
}

TEST(Deck, LinksKeepTheirTitles) {
  EXPECT_EQ(deck_of("[a](https://example.org \"b c\")\n").blocks[0]["c"][0]["c"][2][1], "b c");
}

// pandoc would end the box there
TEST(Deck, TitlesInBoxesBeginNoSlides) {
  const Deck deck = deck_of(
      "## A\n\n::: notes\n## B {#b}\n\nC\n:::\n\n::: incremental\n# D\n\n- e\n:::\n\n[f](#b)\n");
  EXPECT_TRUE(deck.problems.empty());
  const Json& title = deck.blocks[1]["c"][1][0];
  EXPECT_EQ(title["t"], "Para");
  EXPECT_EQ(title["c"][0]["c"][0][0], "b");
  EXPECT_EQ(title["c"][0]["c"][1][0]["t"], "Strong");
  EXPECT_EQ(deck.blocks[2]["c"][1][0]["c"][0], 3);
}

TEST(Deck, QuotesThatAreNoneAreRefusedWithTheirLine) {
  for (const char* quote : {"{Inspect:a.toml#b}", "{ inspect:a.toml#b }", "{insepct:a.toml#b}"})
    EXPECT_TRUE(test::has(problem_of(fmt::format("A\n\nB {} c\n", quote)),
                          "would be shown as it stands: a number is quoted by {inspect:…}"))
        << quote;
  EXPECT_EQ(problem_of("See <https://example.org/a.toml#b> and `{Inspect:a.toml#b}`.\n"), "none");
}

TEST(Deck, PicturesThatAreNoneAreRefusedWithTheirLine) {
  EXPECT_TRUE(test::has(problem_of("A\n\n![b](c.toml {.still}\n"),
                        "[b](c.toml' would be shown as it stands"));
  EXPECT_TRUE(test::has(problem_of("A\n\n![b](c.toml){.still\n"),
                        "deck.md:3: a picture of a scene needs a paragraph of its own, with"));
}

TEST(Deck, ClassesBehindPlainWordsAreRefusedWithTheirLine) {
  for (const char* words : {"Word{.film}", "a {inspect:a.toml#mass}{.film}, b", "(brackets){#b}"}) {
    const std::string problem = problem_of(fmt::format("A\n\n{}\n", words));
    EXPECT_TRUE(test::has(problem, "deck.md:3: '{")) << problem;
    EXPECT_TRUE(test::has(problem, "words that have a class stand in brackets")) << problem;
  }
  for (const char* words :
       {"{inspect:a.toml#mass}", "f{.5} g{} }h{ {.", "[word]{.underline}", "`a{.b}`"})
    EXPECT_EQ(problem_of(words), "none") << words;
}

TEST(Deck, FormulasThatAnEmptyLineEndsAreToldSo) {
  EXPECT_TRUE(test::has(problem_of("$$\n\\begin{aligned}\na\n\nb\n\\end{aligned}\n$$\n"),
                        "LaTeX is for formulas ($…$), in which no line is empty"));
}

TEST(Deck, FieldsMayStandBehindPercentSigns) {
  EXPECT_EQ(problem_of("% Lecture\n% A. Author\n% 2024\n\nText\n"), "none");
}

TEST(Deck, NamesOfPicturesAreTheirsAlone) {
  for (const std::string text :
       {"## Spin\n\n![t](s.toml){#spin .film}\n", "![t](s.toml){#spin .film}\n\n## Spin\n"}) {
    const std::string problem = problem_of(text);
    EXPECT_TRUE(test::has(problem, "'#spin' is a heading or other words")) << problem;
    EXPECT_FALSE(test::has(problem, "deck.md:0")) << problem;
  }
  EXPECT_EQ(problem_of("## Spin\n\n![t](s.toml){#film .film}\n\n[l](#film)\n"), "none");
}

// a picture alone keeps its caption, one among words has what describes it there
TEST(Deck, ItsOwnPicturesHaveADescriptionAWidthAndAPlace) {
  const test::TemporaryFolder folder;
  write_png(folder / "a.png", test::flat_image(2, 2, 1, 2, 3), false);
  const auto read = [&](const std::string& text) {
    return parse_deck(text, "deck.md", {folder.path(), false});
  };
  const Deck deck = read("![Cap](a.png){#here alt=\"It shows b\" width=40%}\n\n[to](#here)\n");
  EXPECT_TRUE(deck.problems.empty());
  const Json& alone = deck.blocks[0]["c"][0];
  EXPECT_EQ(alone["c"][0][0], "here");
  EXPECT_EQ(plain_text(alone["c"][1]), "Cap");
  EXPECT_EQ(alt_of_image(alone), "It shows b");
  const Deck among = read("A ![b](a.png){#here alt=\"c d\"} e ![f](a.png)\n\n[to](#here)\n");
  EXPECT_TRUE(among.problems.empty());
  EXPECT_EQ(plain_text(among.blocks[0]["c"]), "A c d e f");
  for (const std::string width : {"100%", "0.5%", "33.3333%"}) {
    EXPECT_TRUE(read("![b](a.png){width=" + width + "}\n").problems.empty()) << width;
  }
  for (const std::string width : {"0%", "0.0%", "..%", "%", "101%", "1e1%", "-5%"}) {
    EXPECT_EQ(read("![b](a.png){width=" + width + "}\n").problems.size(), 1U) << width;
  }
  for (const auto& [given, problem] : std::vector<std::pair<std::string, std::string>>{
           {".big", "deck.md:3: a picture of the deck's own has no class '.big'"},
           {"height=3",
            "deck.md:3: a picture of the deck's own may have alt=\"…\" and width=N%, not "
            "'height=3'"},
           {"width=3cm",
            "deck.md:3: a picture of the deck's own may have alt=\"…\" and width=N%, not "
            "'width=3cm'"}}) {
    const Deck wrong = read("# A\n\n![x](a.png){" + given + "}\n");
    ASSERT_EQ(wrong.problems.size(), 1U);
    EXPECT_STREQ(wrong.problems[0].what(), problem.c_str());
  }
}

}  // namespace
}  // namespace polhode
