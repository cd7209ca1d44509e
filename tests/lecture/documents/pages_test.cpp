// SPDX-License-Identifier: MIT
#include "lecture/documents/pages.h"

#include <cmath>
#include <cstdlib>
#include <unistd.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/system/child_process.h"
#include "frame/theme.h"
#include "html/page_parts.h"
#include "lecture/decks.h"
#include "support/in_child.h"
#include "support/run.h"
#include "support/words.h"

namespace polhode {
namespace {

using test::count_of;
using test::has;
using test::TemporaryFolder;
using test::write_text;

// what stands between two words
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return "";
  const std::size_t from = at + before.size();
  return text.substr(from, text.find(after, from) - from);
}

DeckWords hostile_words() {
  DeckWords words;
  words.title = "T <script>alert(1)</script>";
  words.subtitle = "\"quoted\"";
  words.author = "A & B";
  words.date = "today";
  words.description = "\"><script>";
  words.licence = "CC <0>";
  words.lang = "de";
  return words;
}

TEST(Pages, OfLanguagesFromRightToLeftSaySo) {
  DeckWords words;
  for (const char* lang : {"he", "ar-EG", "FA", "az-Arab"}) {
    words.lang = lang;
    EXPECT_TRUE(has(handout_page(words, ""), fmt::format("<html lang=\"{}\" dir=\"rtl\">", lang)));
  }
  for (const char* lang : {"de", "en", "haw", "arn", "az"}) {
    words.lang = lang;
    EXPECT_TRUE(has(handout_page(words, ""), fmt::format("<html lang=\"{}\">", lang)));
  }
}

TEST(WordsOf, AreThoseOfTheDecksHead) {
  const DeckWords words = words_of(test::deck_of(
      "---\ntitle: The *title*\nauthor: [One, Two]\ndate: 2026\nlicence: CC0\nlang: de\n---\n"));
  EXPECT_EQ(words.title, "The title");
  EXPECT_EQ(words.author, "One, Two");
  EXPECT_EQ(words.date, "2026");
  EXPECT_EQ(words.licence, "CC0");
  EXPECT_EQ(words.lang, "de");
  EXPECT_EQ(words.subtitle, "");
  const DeckWords none = words_of(test::deck_of("words\n"));
  EXPECT_EQ(none.title, "deck") << "its file's name";
  EXPECT_EQ(none.lang, "en");
}

// the page's own script has a word that depends on the page, and nothing else runs or is fetched
TEST(Pages, RunTheirOwnScriptsAlone) {
  const Reveal reveal{"4", "/* reveal */", "reveal()", ""};
  const std::string body = "<p>body</p>\n";
  for (const std::string& page : {lecture_page(hostile_words(), body, "<ul></ul>"),
                                  slides_page(hostile_words(), body, reveal),
                                  handout_page(hostile_words(), body)}) {
    const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
    EXPECT_EQ(policy.rfind("default-src 'none'; ", 0), 0U) << policy;
    EXPECT_FALSE(has(policy, "http"));
    const std::string nonce = between(policy, "'nonce-", "'");
    EXPECT_GE(nonce.size(), 16U);
    EXPECT_EQ(count_of(page, "<script nonce=\"" + nonce + "\">"), count_of(page, "<script"));
    EXPECT_TRUE(has(page, body));
    EXPECT_TRUE(has(page, "<html lang=\"de\">"));
    EXPECT_TRUE(has(page, "<h1>T &lt;script&gt;alert(1)&lt;/script&gt;</h1>"));
    EXPECT_TRUE(has(page, "<p class=\"subtitle\">&quot;quoted&quot;</p>"));
    EXPECT_TRUE(has(page, "<p class=\"by\">A &amp; B · today</p>"));
    EXPECT_TRUE(has(page, "name=\"description\" content=\"&quot;&gt;&lt;script&gt;\""));
  }
  const std::string one = lecture_page({}, "one", ""), other = lecture_page({}, "other", "");
  EXPECT_NE(between(one, "'nonce-", "'"), between(other, "'nonce-", "'"));
}

// a browser would print all pages smaller, and cut off what is wider still
TEST(Pages, FormulasAndTablesAreAsWideAsPaperAtMost) {
  const Printer printer = find_printer();
  if (printer.program.empty()) GTEST_SKIP() << printer.found.why_not;
  const auto formula = [](int letters, const char* display) {
    std::string text = fmt::format("<math display=\"{}\"><mrow>", display);
    for (int i = 0; i < letters; ++i)
      text += "<mi>m</mi><mo>+</mo>";
    return text + "<mi>n</mi></mrow></math>";
  };
  std::string body = "<p>" + formula(3, "block") + "</p><p>" + formula(200, "block") +
                     "</p><ul><li>a " + formula(100, "inline") + " b</li></ul><table><tr>";
  for (int i = 0; i < 10; ++i)
    body += "<td>" + formula(6, "inline") + "</td>";
  const TemporaryFolder folder;
  const std::string file = folder / "handout.html";
  write_text(file, handout_page({}, body + "</tr></table>\n"));
  std::vector<std::string> command = {printer.program,
                                      "--headless",
                                      "--disable-gpu",
                                      "--user-data-dir=" + (folder / "profile"),
                                      "--virtual-time-budget=2000",
                                      "--dump-dom"};
  if (geteuid() == 0) command.emplace_back("--no-sandbox");
  command.push_back("file://" + file);
  const std::string shown = run_child(command, "").out;
  EXPECT_TRUE(has(shown, "<math display=\"block\"><mrow>")) << shown;
  EXPECT_EQ(count_of(shown, "<math display=\"block\" style=\"font-size: "), 1) << shown;
  EXPECT_EQ(count_of(shown, "<math display=\"inline\" style=\"font-size: "), 1) << shown;
  EXPECT_EQ(count_of(shown, "<table style=\"font-size: "), 1) << shown;
}

TEST(Pages, HaveWhatTheirReadersNeed) {
  const std::string page = lecture_page(hostile_words(), "<p>b</p>", "<ul>contents</ul>");
  EXPECT_LT(page.find("<ul>contents</ul>"), page.find("<main id=\"main\">"));
  EXPECT_TRUE(has(page, "href=\"#Polhode-text\""));
  EXPECT_TRUE(has(page, "CC &lt;0&gt; · polhode "));
  const std::string slides = slides_page({}, "b", {"4", "/* reveal */", "reveal()", ""});
  EXPECT_LT(slides.find("/* reveal */"), slides.find("</style>"));
  EXPECT_LT(slides.find("reveal()"), slides.rfind("<script nonce")) << "ours comes behind it";
}

// page, slide and film are one ground: a letterbox between them would be a third dark
TEST(Pages, HaveTheGroundOfTheirFilms) {
  const glm::vec3 ground = 255.0f * find_theme("dark").background;
  const std::string color = fmt::format(
      "#{:02x}{:02x}{:02x}", std::lround(ground.r), std::lround(ground.g), std::lround(ground.b));
  for (const std::string& css : {lecture_css(), slides_css()}) {
    EXPECT_TRUE(has(css, "video { ")) << "films have a rule";
    EXPECT_TRUE(has(css, "background: " + color));
  }
  EXPECT_TRUE(has(lecture_css(), "--paper: " + color));
  EXPECT_TRUE(has(slides_css(),
                  ".reveal-viewport, html, body { margin: 0; height: 100%; background: " + color));
}

// a child has its own environment: is reveal.js found, and is it this one?
int found_reveal(const std::string& own, const std::string& data, const std::string& version) {
  return test::exit_code_in_child([&] {
    setenv("HOME", "/nowhere", 1);
    setenv("POLHODE_REVEAL", own.c_str(), 1);
    setenv("XDG_DATA_HOME", data.c_str(), 1);
    const std::optional<Reveal> reveal = find_reveal();
    if (!reveal) return 1;
    return reveal->version == version && reveal->css == "css" && !has(reveal->js, "</script") ? 0
                                                                                              : 2;
  });
}

TEST(FindReveal, LooksWhereTheUserSaysThenWhereItIsInstalled) {
  const TemporaryFolder folder;
  const auto install = [&](const std::string& where, const std::string& package) {
    std::filesystem::create_directories(folder / (where + "/dist"));
    write_text(folder / (where + "/dist/reveal.js"), "a = '</script>';");
    write_text(folder / (where + "/dist/reveal.css"), "css");
    if (!package.empty()) write_text(folder / (where + "/package.json"), package);
  };
  install("own", "{\"version\": \"4.6.1\"}");
  install("data/polhode/reveal.js", "");
  EXPECT_EQ(found_reveal(folder / "own", folder / "data", "4.6.1"), 0);
  EXPECT_EQ(found_reveal("", folder / "data", "of unknown version"), 0);
  EXPECT_EQ(found_reveal(folder / "none", folder / "data", "of unknown version"), 0);
  install("data/polhode/reveal.js", "no JSON");
  EXPECT_EQ(found_reveal("", folder / "data", "of unknown version"), 0);
  for (const char* odd : {"{\"version\": 4}", "{\"version\": null}", "[\"version\"]"}) {
    install("data/polhode/reveal.js", odd);
    EXPECT_EQ(found_reveal("", folder / "data", "of unknown version"), 0) << odd;
  }
  std::filesystem::remove(folder / "own/dist/reveal.css");
  if (!std::filesystem::exists("/usr/share/polhode/reveal.js") &&
      !std::filesystem::exists("/usr/local/share/polhode/reveal.js")) {
    EXPECT_EQ(found_reveal(folder / "own", "", ""), 1) << "half of it is none";
  }
}

// what fontconfig finds in its place is not the font
TEST(FormulaFontCss, HoldsTheFontOnlyWhereItIsInstalled) {
  const TemporaryFolder folder;
  write_text(folder / "font.otf", "font");
  const auto css_is = [&](const std::string& family, const std::string& inside) {
    write_text(folder / "fc-match",
               "#!/bin/sh\nprintf '" + family + "\\n" + (folder / "font.otf") + "'\n");
    std::filesystem::permissions(folder / "fc-match", std::filesystem::perms::owner_all);
    return test::exit_code_in_child([&] {
      setenv("PATH", folder.path().c_str(), 1);
      const std::string css = formula_font_css();
      return inside.empty() ? !css.empty() : !has(css, inside);
    });
  };
  EXPECT_EQ(css_is("Latin Modern Math", ";base64,Zm9udA=="), 0);
  EXPECT_EQ(css_is("DejaVu", ""), 0);
  std::filesystem::remove(folder / "font.otf");
  EXPECT_EQ(css_is("Latin Modern Math", ""), 0);
}

TEST(FindPrinter, IsTheOneThatTheUserNamesIfItRuns) {
  const TemporaryFolder folder;
  write_text(folder / "print", "#!/bin/sh\necho print 1\n");
  std::filesystem::permissions(folder / "print", std::filesystem::perms::owner_all);
  EXPECT_EQ(test::exit_code_in_child([&] {
              setenv("POLHODE_CHROMIUM", (folder / "print").c_str(), 1);
              return find_printer().program == folder / "print" ? 0 : 1;
            }),
            0);
  EXPECT_EQ(test::exit_code_in_child([&] {
              setenv("POLHODE_CHROMIUM", (folder / "none").c_str(), 1);
              setenv("PATH", "/nowhere", 1);
              return find_printer().program.empty() ? 0 : 1;
            }),
            0);
}

// a printer that copies the address of the page into the PDF, and one that fails
TEST(PrintPage, GivesTheBytesThatThePrinterMakes) {
  const TemporaryFolder folder;
  write_text(
      folder / "print",
      "#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) pdf=${word#*=};; esac; "
      "last=$word; done\nprintf '%%PDF-of %s %s\n%%%%EOF' \"$TMPDIR\" \"$last\" >\"$pdf\"\n");
  write_text(folder / "idle", "#!/bin/sh\nexit 0\n");
  write_text(folder / "half",
             "#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) pdf=${word#*=};; esac; "
             "done\nprintf '%%PDF-1.7' >\"$pdf\"\n");
  write_text(folder / "fail", "#!/bin/sh\necho 'no screen' >&2\necho more >&2\nexit 1\n");
  for (const char* name : {"print", "fail", "idle", "half"})
    std::filesystem::permissions(folder / name, std::filesystem::perms::owner_all);
  const std::string pdf = print_page(folder / "print", folder / "a b.html");
  // what it leaves there when it is killed is removed with our own folder
  EXPECT_EQ(
      pdf.rfind("%PDF-of " + (std::filesystem::temp_directory_path() / "polhode-").string(), 0), 0U)
      << pdf;
  EXPECT_NE(pdf.find("/tmp file:///"), std::string::npos) << pdf;
  EXPECT_TRUE(pdf.ends_with("/a%20b.html\n%%EOF")) << pdf;
  try {
    print_page(folder / "fail", folder / "a.html");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::environment);
    EXPECT_TRUE(error.message().ends_with("fail ended with exit code 1: no screen"))
        << error.what();
  }
  for (const char* name : {"idle", "half"}) {
    try {
      print_page(folder / name, folder / "a.html");
      FAIL();
    } catch (const Error& error) {
      EXPECT_TRUE(error.message().ends_with(std::string(name) + " wrote no whole PDF"))
          << error.what();
    }
  }
}

}  // namespace
}  // namespace polhode
