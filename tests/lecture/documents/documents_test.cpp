// SPDX-License-Identifier: MIT
#include "lecture/documents/documents.h"

#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "base/system/child_process.h"
#include "html/page_parts.h"
#include "image/png.h"
#include "lecture/deck/quotes.h"
#include "lecture/decks.h"
#include "lecture/documents/lost_words.h"
#include "support/flat_image.h"
#include "support/run.h"
#include "support/words.h"

namespace polhode {
namespace {

using test::deck_of;
using test::has;

constexpr const char* kText =
    "---\ntitle: The title\n---\n\n# Part\n\n## One\n\nSome words and $x = \\frac{1}{2}$.\n\n"
    "![A caption](s.toml){.film}\n\n::: notes\nSay this.\n:::\n\n## Two\n\nThe ω is 3 × 10⁻⁷.\n";

// what was made of the one film of a deck
Figure figure_of(const DeckPicture& picture) {
  const Json facts = {{"film", "film.mp4"},
                      {"poster", "poster.png"},
                      {"paper", "paper.png"},
                      {"poster_at", 0.5},
                      {"stills", Json::array()},
                      {"vtt", ""},
                      {"pauses", Json::array()},
                      {"frames", 10},
                      {"fps", 10.0},
                      {"width", 64},
                      {"height", 36},
                      {"title", "Top"}};
  Figure figure{&picture, facts, ""};
  if (picture.kind == PictureKind::inspect)
    figure.facts["table"] = deck_of("| a | b |\n|---|---|\n| c | d |\n").blocks;
  return figure;
}

// writes the poster of that film
void write_poster(const test::TemporaryFolder& folder) {
  std::filesystem::create_directory(folder / "media");
  write_png(folder / "media/poster.png", test::flat_image(64, 36, 1, 2, 3), false);
}

std::string pptx_of(const Deck& deck) {
  const test::TemporaryFolder folder;
  write_poster(folder);
  return make_pptx(deck, figure_of, folder.path());
}

// what Python says of the slides of a deck
std::string told_of_slides(const Deck& deck, const char* script) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "slides.pptx", pptx_of(deck));
  const ChildResult ran =
      run_child({"python3", "-c", script, folder / "slides.pptx"}, "", {.seconds = 60.0});
  EXPECT_TRUE(ended_well(ran)) << ran.err;
  return ran.out;
}

// the words of one XML file in the slides of a deck
std::string words_of_part(const Deck& deck, const std::string& part) {
  const std::string script = fmt::format(R"py(import re, sys, zipfile
xml = zipfile.ZipFile(sys.argv[1]).read("{}").decode()
print("".join(re.findall("<a:t[^>]*>([^<]*)", xml)))
)py",
                                         part);
  return told_of_slides(deck, script.c_str());
}

TEST(Documents, ThePageHasTextFilmsNotesAndContents) {
  const std::string page = make_page(deck_of(kText), figure_of);
  EXPECT_TRUE(has(page, "<h1>The title</h1>"));
  EXPECT_TRUE(has(page, "<h2>Part</h2>")) << "the deck's first level stands below the title";
  EXPECT_TRUE(has(page, "<h3>One</h3>"));
  EXPECT_TRUE(has(page, "<mfrac>"));
  EXPECT_TRUE(has(page, "<source src=\"media/film.mp4\""));
  EXPECT_TRUE(has(page, "A caption"));
  EXPECT_TRUE(has(page, "Say this.")) << "a student reads what the speaker says";
  EXPECT_FALSE(has(page, "class=\"notes\""));
  const std::string contents =
      page.substr(page.find("<nav class=\"contents\""), page.find("<main") - page.find("<nav"));
  for (const char* link : {"href=\"#part\"", "href=\"#one\"", "href=\"#two\""})
    EXPECT_TRUE(has(contents, link)) << contents;
}

// with its links, formulas and emphasis; a footnote has no place there
TEST(Documents, TheHeadOfPagesIsMarkedUp) {
  const Deck deck = deck_of(
      "---\ntitle: The $\\frac{a}{b}$ <p> top^[Or gyro.]\nauthor:\n- "
      "\"[Ann](https://example.org/ann)\"\n"
      "- Bo\ndate: \"*May* 2026\"\nlicence: \"[CC BY](https://example.org/by)\"\n---\n\n# One\n");
  ASSERT_TRUE(deck.problems.empty());
  const std::string page = make_page(deck, figure_of);
  EXPECT_TRUE(has(page, "</mfrac>"));
  EXPECT_TRUE(has(page, "&lt;p&gt; top<span> (Or gyro.)</span></h1>"));
  EXPECT_TRUE(has(page,
                  "<p class=\"by\"><a href=\"https://example.org/ann\">Ann</a>, Bo · "
                  "<em>May</em> 2026</p>"));
  EXPECT_TRUE(has(page, "<footer><a href=\"https://example.org/by\">CC BY</a> · "));
  EXPECT_TRUE(has(page, "<title>The \\frac{a}{b} &lt;p&gt; top (Or gyro.)</title>"));
  EXPECT_TRUE(has(make_handout_html(deck, figure_of), ">Ann</a>"));
  const std::string slides = make_slides(deck, figure_of, {"4", "css", "js", ""});
  EXPECT_TRUE(has(slides, ">Ann</a>"));
  EXPECT_EQ(lost_words(deck, slides, DocumentForm::html, 5), std::vector<std::string>());
}

// nor has it names twice, for links lead to the first
TEST(Documents, NothingOfADeckIsTakenForAPartOfThePage) {
  const Deck deck =
      deck_of("# Main\n\n## B [c]{#here}\n\n[d](#here)\n\n## Look\n\n~~~ controls\ne\n~~~\n");
  const std::string page = make_page(deck, figure_of);
  const std::regex name("id=\"([^\"]*)\"");
  std::multiset<std::string> names;
  for (auto i = std::sregex_iterator(page.begin(), page.end(), name); i != std::sregex_iterator();
       ++i)
    names.insert((*i)[1]);
  for (const char* place : {"main", "here", "look"})
    EXPECT_EQ(names.count(place), 1U) << place;
  EXPECT_FALSE(has(page, "<pre class"));
  EXPECT_FALSE(has(make_slides(deck, figure_of, {"4", "css", "js", ""}), "<pre class"));
}

TEST(Documents, SlidesHaveTheNotesForTheSpeaker) {
  const std::string slides = make_slides(deck_of(kText), figure_of, {"4", "css", "js", ""});
  EXPECT_TRUE(has(slides, "<aside class=\"notes\">"));
  EXPECT_TRUE(has(slides, "data-film=\"s\""));
  EXPECT_FALSE(has(slides, " controls ")) << "the speaker's keys play the film";
}

TEST(Documents, TheHandoutHasPicturesInPlaceOfFilms) {
  const std::string handout = make_handout_html(deck_of(kText), figure_of);
  EXPECT_TRUE(has(handout, "<img src=\"media/paper.png\""));
  EXPECT_TRUE(has(handout, "t = 0.5 s"));
  EXPECT_FALSE(has(handout, "<video"));
  EXPECT_TRUE(has(handout, "Say this."));
}

// fonts of TeX lack raised digits and Greek letters
TEST(Documents, BeamerHasPostersAndCharactersThatTexHas) {
  const std::string tex = make_beamer(deck_of(kText), figure_of);
  EXPECT_TRUE(has(tex, "\\documentclass"));
  EXPECT_TRUE(has(tex, "media/paper.png"));
  EXPECT_FALSE(has(tex, "film.mp4"));
  EXPECT_TRUE(has(tex, "\\frac{1}{2}"));
  EXPECT_TRUE(has(tex, "\\(\\omega\\)")) << tex.substr(tex.find("frame"));
  EXPECT_TRUE(has(tex, "^{-7}"));
  EXPECT_FALSE(has(tex, "⁻"));
  EXPECT_FALSE(has(tex, "ω"));
}

// words and one picture stand side by side
TEST(Documents, SlidesThatPlaceThingsThemselvesHaveColumns) {
  const std::string tex = make_beamer(deck_of(kText), figure_of);
  EXPECT_TRUE(has(tex, "\\begin{columns}"));
  const Deck alone = deck_of("# Part\n\n![A caption](s.toml){.film}\n");
  EXPECT_FALSE(has(make_beamer(alone, figure_of), "\\begin{columns}"));
}

// a .pptx is a ZIP archive with the posters inside
TEST(Documents, PowerPointHasThePosters) {
  const std::string pptx = pptx_of(deck_of(kText));
  EXPECT_EQ(pptx.substr(0, 2), "PK");
  EXPECT_TRUE(has(pptx, "ppt/media/image1.png"));
  EXPECT_TRUE(has(pptx, "ppt/slides/slide1.xml"));
}

// wherever formulas stand
TEST(Documents, PowerPointHasNoDotsForPauses) {
  const Deck deck = deck_of("## A\n\none\n\n. . .\n\ntwo ...\n");
  EXPECT_EQ(words_of_part(deck, "ppt/slides/slide1.xml"), "Aonetwo ...\n");
}

// pandoc makes dots of those that do not stand between the paragraphs of a slide
TEST(Documents, PausesInListsAndColumnsAreSteps) {
  const Deck deck = deck_of(
      "## A\n\n- one\n\n    . . .\n\n    two\n\n    . . .\n\n    three\n\n:::: columns\n\n"
      "::: column\nfour\n\n. . .\n\nfive\n:::\n\n::::\n\n::: notes\nsix\n\n. . .\n\nseven\n"
      ":::\n");
  const std::string slides = make_slides(deck, figure_of, {"4", "css", "js", ""});
  for (const char* step :
       {"<div class=\"fragment\">\n<p>two</p>\n<div class=\"fragment\">\n<p>three",
        "<p>four</p>\n<div class=\"fragment\">\n<p>five</p>",
        "<p>six</p>\n<p>seven</p>"})
    EXPECT_TRUE(has(slides, step)) << slides;
  for (const std::string& page :
       {slides, make_page(deck, figure_of), make_handout_html(deck, figure_of)})
    EXPECT_FALSE(has(page, ". . .")) << page;
}

TEST(Documents, PowerPointIsXml) {
  const Deck deck = deck_of(
      "---\ntitle: On $\\Omega$\n---\n\n# Part $x^2$\n\n## Slide $y_1 = \\frac{1}{2}$\n\n"
      "![A caption with $L_3$](s.toml){.film}\n\n## Table\n\n| a $b$ | c |\n|---|---|\n| $d$ | e "
      "|\n\n"
      "## Blank $\\,$ and $\\Theta$\n\n"
      "## Words\n\n- $f$ and **$g$**\n\n$$h = \\sqrt{i}$$\n");
  const char* script = R"(import sys, zipfile, xml.dom.minidom as xml
parts = zipfile.ZipFile(sys.argv[1])
for name in parts.namelist():
    if not name.endswith((".xml", ".rels")): continue
    texts = xml.parseString(parts.read(name)).getElementsByTagName("a:t")
    if name.startswith("ppt/slides/slide"): print("".join(t.firstChild.data for t in texts if t.firstChild))
)";
  const std::string told = told_of_slides(deck, script);
  EXPECT_TRUE(has(told, "On Ω") && has(told, "and Θ")) << told;
}

// pandoc leaves out what has no place on a slide
TEST(Documents, PowerPointHasAllWordsAndPictures) {
  const std::string table = "| ALPHA | b |\n|---|---|\n| BETA | d |\n\n",
                    film = "![CAPTION](s.toml){.film}\n\n";
  const Deck deck = deck_of(
      "## First\n\n" + film + table + "GAMMA\n\n## Second\n\n" + table + "DELTA\n\n" + table +
      "EPSILON\n\n## Third\n\n:::: columns\n::: column\nZETA\n:::\n::: column\nETA\n:::\n"
      "::: column\nTHETA\n:::\n::::\n\n## Fourth\n\n- IOTA\n\n  " +
      film);
  const char* script = R"py(import re, sys, zipfile
parts = zipfile.ZipFile(sys.argv[1])
slides = "".join(parts.read(n).decode() for n in parts.namelist() if n.startswith("ppt/slides/slide"))
words = "".join(re.findall("<a:t[^>]*>([^<]*)", slides))
for word in "ALPHA BETA GAMMA DELTA EPSILON ZETA ETA THETA IOTA CAPTION".split(): assert word in words, (word, words)
assert words.count("ALPHA") == 3 and slides.count("<p:pic>") == 2, slides.count("<p:pic>")
print("all")
)py";
  EXPECT_EQ(told_of_slides(deck, script), "all\n");
}

TEST(Documents, LinksLeadToPicturesInEachOfThem) {
  const Deck deck = deck_of(
      "## First\n\nSee [it](#mov) and [that](#s).\n\n## Second\n\n![A caption](s.toml){#mov "
      ".film}\n\n"
      "## Third\n\n![Another](s.toml){.film}\n");
  EXPECT_TRUE(has(make_page(deck, figure_of, ""), "id=\"mov\""));
  EXPECT_TRUE(has(make_slides(deck, figure_of, {"4", "css", "js", ""}), "id=\"mov\""));
  EXPECT_TRUE(has(make_handout_html(deck, figure_of), "id=\"mov\""));
  const std::string tex = make_beamer(deck, figure_of);
  for (const char* place : {"mov", "s"}) {
    EXPECT_TRUE(has(tex, fmt::format("\\hyperlink{{{}}}", place))) << tex;
    // beamer makes targets of labels, too
    EXPECT_TRUE(has(tex, fmt::format("\\hypertarget{{{}}}", place)) ||
                has(tex, fmt::format("\\label{{{}}}", place)))
        << tex;
  }
  const char* script = R"py(import re, sys, zipfile
links = zipfile.ZipFile(sys.argv[1]).read("ppt/slides/_rels/slide1.xml.rels").decode()
print(*sorted(re.findall(r'Target="(slide[0-9]+.xml)"', links)))
)py";
  EXPECT_EQ(told_of_slides(deck, script), "slide2.xml slide3.xml\n");
}

// those of scenes and the deck's own, alone, in lists and in quotations
TEST(Documents, PicturesHaveTheirCaptionsInEachOfThem) {
  const test::TemporaryFolder folder;
  write_poster(folder);
  const Deck deck = parse_deck(
      "## First\n\n![ALPHA](s.toml){.film}\n\n## Second\n\n![BETA](media/poster.png){#b "
      "alt=GAMMA width=40%}\n\n- ![DELTA](media/poster.png)\n\n> ![EPSILON](media/poster.png)\n\n"
      "| a ![ZETA](media/poster.png) | ![ETA](media/poster.png){#e} |\n|---|---|\n\n"
      "![](media/poster.png){#t alt=THETA}\n\n[b](#b) [e](#e) [t](#t)\n",
      "deck.md",
      {folder.path(), false});
  ASSERT_TRUE(deck.problems.empty()) << deck.problems[0].what();
  for (const std::string& html : {make_page(deck, figure_of, ""),
                                  make_slides(deck, figure_of, {"4", "css", "js", ""}, ""),
                                  make_handout_html(deck, figure_of)}) {
    for (const char* caption : {"ALPHA", "BETA", "DELTA", "EPSILON"})
      EXPECT_TRUE(std::regex_search(
          html, std::regex(fmt::format("<figcaption[^>]*>\\s*(<p>)?{}\\s*</", caption))))
          << html;
    for (const char* alt : {"GAMMA", "DELTA", "EPSILON", "ZETA", "ETA", "THETA"})
      EXPECT_TRUE(has(html, fmt::format("alt=\"{}\"", alt))) << alt;
    for (const char* place : {"b", "e", "t"})
      EXPECT_TRUE(has(html, fmt::format("id=\"{}\"", place))) << place;
  }
  const std::string tex = make_beamer(deck, figure_of);
  for (const char* caption : {"ALPHA", "BETA", "DELTA", "EPSILON"})
    EXPECT_TRUE(has(tex, fmt::format("\\caption{{{}}}", caption))) << tex;
  EXPECT_TRUE(has(tex, "width=0.4\\textwidth"));
  Deck with_numbers = deck_of("![IOTA](s.toml){.inspect}\n");
  EXPECT_TRUE(has(make_beamer(with_numbers, figure_of), "\\caption{IOTA}"));
  const Deck in_footnotes = deck_of("a[^1]\n\n[^1]: ![KAPPA](s.toml){.film}\n");
  const std::string footnote = make_beamer(in_footnotes, figure_of);
  EXPECT_TRUE(has(footnote.substr(footnote.find("\\footnote")), "KAPPA")) << footnote;
  const char* script = R"py(import re, sys, zipfile
parts = zipfile.ZipFile(sys.argv[1])
slides = "".join(parts.read(n).decode() for n in parts.namelist() if n.startswith("ppt/slides/slide"))
words = "".join(re.findall("<a:t[^>]*>([^<]*)", slides))
for word in "ALPHA BETA DELTA EPSILON".split(): assert word in words, (word, words)
for word in "GAMMA DELTA EPSILON THETA".split(): assert re.search('descr="%s' % word, slides), (word, slides)
print("all")
)py";
  EXPECT_EQ(told_of_slides(deck, script), "all\n");
}

TEST(Documents, PicturesThatOnlyBrowsersShowAreWords) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  const Deck deck = parse_deck("## First\n\n![ALPHA](a.svg){#a alt=BETA}\n\n[to](#a) ![](a.svg)\n",
                               "deck.md",
                               {folder.path(), false});
  EXPECT_TRUE(has(make_page(deck, figure_of), "src=\"a.svg\" id=\"a\"") ||
              has(make_page(deck, figure_of), "<figure id=\"a\">"));
  const std::string tex = make_beamer(deck, figure_of);
  EXPECT_TRUE(has(tex, "{\\relax{[}BETA{]} ALPHA}") && has(tex, "{\\relax{[}picture{]}}")) << tex;
  EXPECT_FALSE(has(tex, "includegraphics{"));
  const char* script = R"py(import sys, zipfile
slide = zipfile.ZipFile(sys.argv[1]).read("ppt/slides/slide1.xml").decode()
print("[BETA] ALPHA" in slide.replace("</a:t></a:r><a:r><a:rPr /><a:t>", ""), "<p:pic>" in slide)
)py";
  EXPECT_EQ(told_of_slides(deck, script), "True False\n");
}

// what has failed says so in its place
TEST(Documents, APictureThatCouldNotBeMadeIsWords) {
  const auto failed = [](const DeckPicture& picture) {
    return Figure{&picture, {}, "no <such> scene"};
  };
  const std::string page = make_page(deck_of(kText), failed);
  EXPECT_TRUE(has(page, "[s.toml could not be made: no &lt;such&gt;"));
  EXPECT_FALSE(has(page, "<video"));
}

// brackets that need not grow keep their width; those of \left and matrices grow
TEST(Documents, BracketsGrowOnlyWhereTheyAreAskedTo) {
  const std::string plain = make_handout_html(deck_of("$(a)$\n"), figure_of);
  EXPECT_FALSE(has(plain, "stretchy=\"true\""));
  const std::string tall = make_handout_html(deck_of("$\\left(\\frac{a}{b}\\right)$\n"), figure_of);
  EXPECT_FALSE(has(tall, "stretchy=\"false\""));
  const std::string text = make_handout_html(deck_of("`stretchy=\"true\"` and $(a)$\n"), figure_of);
  EXPECT_TRUE(has(text, "<code>stretchy=\"true\"</code>")) << "words about it stay";
}

// browsers have upright letters only one by one
TEST(Documents, UprightLettersStandUpright) {
  const std::string html =
      make_handout_html(deck_of("$a + \\mathrm{bc} + \\text{d}$\n"), figure_of);
  EXPECT_TRUE(has(html, "<mi>a</mi>")) << html;
  EXPECT_TRUE(has(html, "<mi mathvariant=\"normal\">b</mi><mi mathvariant=\"normal\">c</mi>"));
}

// pandoc leaves them out
TEST(Documents, NumbersOfFormulasAreWordsBehindThem) {
  Deck deck = deck_of("$$\\tag{17} a = b$$\n\nand $c \\tag*{A}$ and more\n");
  settle_formulas(deck, "");
  ASSERT_TRUE(deck.problems.empty());
  const std::string html = make_handout_html(deck, figure_of);
  EXPECT_TRUE(has(html, "<mtext mathvariant=\"normal\">(17)</mtext>")) << html;
  EXPECT_TRUE(has(make_beamer(deck, figure_of), "b\\qquad\\text{(17)}"));
}

// letters are raised once
TEST(Documents, PowersOfPowersInTitlesOfPowerPointAreTex) {
  const Deck deck = deck_of("## $a^{b^c}$ $d^{e}f$ ${g^2}^3$ $h_{i^2}$\n\nA\n");
  const std::string told = words_of_part(deck, "ppt/slides/slide1.xml");
  for (const char* formula : {"a^{b^c}", "def", "{g^2}^3", "h_{i^2}"})
    EXPECT_TRUE(has(told, formula)) << told;
}

TEST(Documents, FormulasWithQuotesHaveTheLineOfTheDeck) {
  const std::string text = "A\n\n$\\frac{inspect:s.toml#kind}$\n";
  Deck deck = deck_of(text);
  const Json answer = {{"kind", "symmetric"}};
  fill_quotes(deck, text, [&](const std::string&) -> const Json& { return answer; });
  settle_formulas(deck, text);
  ASSERT_EQ(deck.problems.size(), 1U);
  EXPECT_EQ(deck.problems[0].place().line, 3);
}

// where pandoc leaves out all but words
TEST(Documents, NotesOfSlidesHaveFootnotesTablesAndPicturesInWords) {
  const Deck deck = deck_of(
      "## A\n\nB\n\n::: notes\nC[^1] [L](https://m.n)\n\n| F | G |\n|---|---|\n| H | I |\n\n: J\n\n"
      "![K](s.toml){.film}\n:::\n\n[^1]: D\n\n    E\n");
  const std::string notes = words_of_part(deck, "ppt/notesSlides/notesSlide1.xml");
  for (const char* words : {"C (D E) L (https://m.n)", "JF | GH | I", "[K]"})
    EXPECT_TRUE(has(notes, words)) << notes;
}

TEST(Documents, SlidesDoNotShowFootnotesOfNotes) {
  const Deck deck = deck_of("## A\n\nB\n\n::: notes\nC[^1]\n:::\n\n[^1]: D\n");
  const std::string slides = make_slides(deck, figure_of, {"4", "css", "js", ""});
  EXPECT_TRUE(has(slides, "C<span> (D)</span>"));
  EXPECT_FALSE(has(slides, "class=\"footnotes"));
}

TEST(Documents, ColumnsHaveTheirWidthsInPages) {
  const Deck deck = deck_of(":::: columns\n\n::: {.column width=\"30%\"}\nA\n:::\n\n::::\n");
  EXPECT_TRUE(has(make_page(deck, figure_of), "class=\"column\" style=\"width:30%;\""));
}

TEST(Documents, LinesOfCodeHaveNumbersInLatex) {
  const Deck deck = deck_of("```{.cpp .numberLines}\nint a;\n```\n");
  EXPECT_TRUE(has(make_beamer(deck, figure_of), "numbers=left"));
}

// of 1983. its first digits would be cut off, and a) would be a.
TEST(Documents, PagesAreToldOfUnusualMarksOfLists) {
  const Deck deck = deck_of(
      "1. a\n2. b\n\n    100. c\n    101. d\n\nA\n\nxxxvii. e\nxxxviii. f\n\nB\n\n(viii) g\n"
      "\nC\n\na) h\n\nD\n\n(@) i\n");
  const std::string page = make_page(deck, figure_of);
  EXPECT_TRUE(has(page, "<div style=\"--mark: 4;\">\n<ol start=\"100\"")) << page;
  EXPECT_TRUE(has(page, "<div style=\"--mark: 8;\">\n<ol start=\"37\"")) << page;
  EXPECT_TRUE(
      has(page, "<div style=\"--mark: 6;--brackets: TwoParens-LowerRoman;\">\n<ol start=\"8\""))
      << page;
  EXPECT_TRUE(has(page, "<div style=\"--brackets: OneParen-LowerAlpha;\">\n<ol")) << page;
  EXPECT_TRUE(has(page, "<div style=\"--mark: 3;--brackets: TwoParens-Decimal;\">\n<ol")) << page;
  EXPECT_EQ(test::count_of(page, "<div style=\"--"), 5) << page;
}

// each name that a list of a deck can have is one that the pages know
TEST(Documents, PagesKnowAllBracketsOfMarks) {
  for (const char* delimiter : {"OneParen", "TwoParens"}) {
    for (const char* style : {"Decimal", "LowerAlpha", "UpperAlpha", "LowerRoman", "UpperRoman"})
      EXPECT_TRUE(has(deck_css(), fmt::format("@counter-style {}-{} {{", delimiter, style)));
  }
}

// in half of the page the end of the formula would be cut off
TEST(Documents, ColumnsOfFormulasAreAsWideAsTheyNeed) {
  const std::string words(80, 'w');
  const auto page_with = [&](const std::string& cell) {
    return make_page(deck_of("| a | b |\n|---|---|\n| " + cell + " | " + words + " |\n"),
                     figure_of);
  };
  EXPECT_TRUE(has(page_with("c"), "<col style=\"width: 50%\""));
  EXPECT_FALSE(has(page_with("$c$"), "<col"));
}

TEST(Documents, FormulasThatNobodyCanReadAreTakenOut) {
  const std::string text = "Fine: $x^2$\n\nBad: $\\frac{1}$\n\n![c $\\frac{2}$](s.toml){.film}\n";
  Deck deck = deck_of(text);
  ASSERT_TRUE(deck.problems.empty());
  settle_formulas(deck, text);
  ASSERT_EQ(deck.problems.size(), 2U);
  EXPECT_STREQ(deck.problems[0].what(), "deck.md:3: pandoc cannot read the formula '\\frac{1}'");
  EXPECT_EQ(deck.problems[1].place().line, 5);
  EXPECT_EQ(plain_text(deck.blocks[0]["c"]), "Fine: x^2");
  EXPECT_EQ(plain_text(deck.blocks[1]["c"]), "Bad: [a formula that cannot be read]");
  EXPECT_EQ(plain_text(deck.pictures[0].caption), "c [a formula that cannot be read]");
  Deck good = deck_of("$x^2$\n");
  settle_formulas(good, "$x^2$\n");
  EXPECT_TRUE(good.problems.empty());
}

}  // namespace
}  // namespace polhode
