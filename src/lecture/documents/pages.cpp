// SPDX-License-Identifier: MIT
#include "lecture/documents/pages.h"

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <unistd.h>

#include "base/base64.h"
#include "base/hash.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "base/system/scratch_folder.h"
#include "base/version.h"
#include "html/escape.h"
#include "html/page_parts.h"
#include "lecture/documents/script_folder.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// Only the page's own script runs: the nonce depends on everything in it, so that no text of a deck
// can know it. Nothing comes from elsewhere.
// `computes`: the page has WebAssembly, which runs in a worker.
std::string head(const DeckWords& words,
                 const std::string& css,
                 const std::string& nonce,
                 bool computes = false) {
  return fmt::format(
             "<!doctype html>\n<html lang=\"{}\"{}>\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src "
             "'self' data: file:; "
             "media-src 'self' data: file:; font-src data:; style-src 'unsafe-inline'; script-src "
             "'nonce-{}'{}; "
             "base-uri 'none'; form-action 'none'\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<meta name=\"description\" content=\"{}\">\n<meta name=\"generator\" "
             "content=\"polhode {}\">\n"
             "<title>{}</title>\n<style>\n",
             escaped(words.lang),
             is_written_from_the_right(words.lang) ? " dir=\"rtl\"" : "",
             nonce,
             computes ? " 'wasm-unsafe-eval'; worker-src blob:" : "",
             escaped(words.description),
             escaped(program_version()),
             escaped(words.title)) +
         css + "</style>\n</head>\n";
}

bool computes(const std::string& viewers) {
  return viewers.find("\" data-core>") != std::string::npos;
}

std::string script(const std::string& nonce, const std::string& js) {
  return fmt::format("<script nonce=\"{}\">\n", nonce) + js + "\n</script>\n";
}

// a field as HTML; `plain` are its words
std::string shown(const DeckWords& words, const char* key, const std::string& plain) {
  const auto found = words.marked_up.find(key);
  return found == words.marked_up.end() ? escaped(plain) : found->second;
}

std::string title_block(const DeckWords& words) {
  std::string text = fmt::format("<h1>{}</h1>\n", shown(words, "title", words.title));
  const std::string subtitle = shown(words, "subtitle", words.subtitle);
  if (!subtitle.empty()) text += fmt::format("<p class=\"subtitle\">{}</p>\n", subtitle);
  std::string by = shown(words, "author", words.author);
  if (!words.date.empty()) by += (by.empty() ? "" : " · ") + shown(words, "date", words.date);
  if (!by.empty()) text += fmt::format("<p class=\"by\">{}</p>\n", by);
  return text;
}

}  // namespace

DeckWords words_of(const Deck& deck) {
  DeckWords words;
  const auto set = [&](const char* key, std::string& to) {
    if (deck.meta.contains(key)) to = plain_text(inlines_of_field(deck.meta[key]));
  };
  set("title", words.title);
  set("subtitle", words.subtitle);
  set("author", words.author);
  set("date", words.date);
  set("description", words.description);
  set("licence", words.licence);
  set("lang", words.lang);
  set("address", words.address);
  if (!words.address.empty() && !words.address.ends_with('/')) words.address += '/';
  if (words.title.empty()) words.title = fs::path(deck.file).stem().string();
  return words;
}

bool is_written_from_the_right(const std::string& lang) {
  static const std::regex tag(
      "(ar|arc|ckb|dv|fa|he|iw|ji|ks|ps|sd|syr|ug|ur|yi)(-.*)?"
      "|[a-z]{2,3}-(arab|hebr|syrc|thaa)(-.*)?",
      std::regex::icase);
  return std::regex_match(lang, tag);
}

std::optional<Reveal> find_reveal() {
  const std::optional<fs::path> place =
      find_script_folder("POLHODE_REVEAL", "reveal.js", {"dist/reveal.js", "dist/reveal.css"});
  if (!place) return {};
  return Reveal{version_of_scripts(*place),
                read_file(*place / "dist/reveal.css"),
                safe_in_script(read_file(*place / "dist/reveal.js")),
                licence_of_scripts(*place)};
}

std::string formula_font_css() {
  try {
    const ChildResult ran = run_child(
        {"fc-match", "-f", "%{family}\n%{file}", "Latin Modern Math"}, "", {.seconds = 10.0});
    const std::size_t end = ran.out.find('\n');
    if (!ended_well(ran) || end == std::string::npos || ran.out.find("Latin Modern Math") > end)
      return "";
    const std::string font = read_file(ran.out.substr(end + 1));
    return "@font-face { font-family: \"Latin Modern Math\"; src: url(data:font/otf;base64," +
           base64(font) + ") format(\"opentype\"); }\n";
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    return "";
  }
}

std::string lecture_page(const DeckWords& words,
                         const std::string& body,
                         const std::string& contents,
                         const std::string& viewers) {
  // names with a capital letter are none that pandoc gives to titles
  std::string inside =
      "<a class=\"skip\" href=\"#Polhode-text\">To the text</a>\n<header class=\"top\">\n" +
      title_block(words) +
      "<div class=\"tools\"><button type=\"button\" id=\"Polhode-look\" "
      "hidden>Look</button></div>\n</header>\n";
  inside +=
      "<nav class=\"contents\" aria-label=\"Contents\"><details "
      "open><summary>Contents</summary>\n" +
      contents + "</details></nav>\n";
  inside += "<main id=\"Polhode-text\">\n" + body + "</main>\n<footer>";
  if (!words.licence.empty())
    inside += fmt::format("{} · ", shown(words, "licence", words.licence));
  inside += fmt::format("polhode {}</footer>\n", escaped(program_version())) + viewers;
  const std::string nonce = content_hash(inside);
  const std::string css = lecture_css() + deck_css() + (viewers.empty() ? "" : turn_css());
  const std::string js = viewers.empty() ? "" : script(nonce, turn_core_js() + turn_js());
  return head(words, formula_font_css() + css, nonce, computes(viewers)) + "<body>\n" + inside +
         script(nonce, lecture_js()) + js + "</body>\n</html>\n";
}

std::string slides_page(const DeckWords& words,
                        const std::string& body,
                        const Reveal& reveal,
                        const std::string& viewers) {
  const std::string inside =
      "<div class=\"reveal\"><div class=\"slides\">\n<section class=\"slide first\">\n" +
      title_block(words) + "</section>\n" + body +
      "</div></div>\n<p class=\"hint\" aria-live=\"polite\"></p>\n" + viewers;
  const std::string nonce = content_hash(inside);
  const std::string css =
      reveal.css + slides_css() + deck_css() + (viewers.empty() ? "" : turn_css());
  const std::string js = viewers.empty() ? "" : script(nonce, turn_core_js() + turn_js());
  return head(words, formula_font_css() + css, nonce, computes(viewers)) + "<body>\n" + inside +
         script(nonce, reveal.js) + script(nonce, slides_js()) + js + "</body>\n</html>\n";
}

std::string handout_page(const DeckWords& words, const std::string& body) {
  const std::string inside =
      "<header>\n" + title_block(words) + "</header>\n<main>\n" + body + "</main>\n";
  const std::string nonce = content_hash(inside);
  return head(words, formula_font_css() + handout_css() + deck_css(), nonce) + "<body>\n" + inside +
         script(nonce, handout_js()) + "</body>\n</html>\n";
}

Printer find_printer() {
  ProgramFound why{"", "chromium is not installed", false};
  for (const std::string& name : {environment("POLHODE_CHROMIUM"),
                                  std::string("chromium"),
                                  std::string("chromium-browser"),
                                  std::string("google-chrome")}) {
    if (name.empty()) continue;
    ProgramFound found = find_program(name);
    if (found.why_not.empty()) return {name, std::move(found)};
    if (found.installed && !why.installed) why = std::move(found);
  }
  return {"", why};
}

std::string print_page(const std::string& printer, const fs::path& html) {
  const ScratchFolder scratch;
  const std::string pdf = scratch / "page.pdf";
  // what it leaves in the folder for temporary files when it is killed goes with ours
  const std::string temporary = scratch / "tmp";
  fs::create_directory(temporary);
  std::vector<std::string> command = {"env",
                                      "TMPDIR=" + temporary,
                                      printer,
                                      "--headless",
                                      "--disable-gpu",
                                      "--no-pdf-header-footer",
                                      "--disable-extensions",
                                      "--disable-background-networking",
                                      "--user-data-dir=" + (scratch / "profile"),
                                      "--virtual-time-budget=10000",
                                      "--print-to-pdf=" + pdf};
  // it refuses its own sandbox to root
  if (geteuid() == 0) command.emplace_back("--no-sandbox");
  command.push_back("file://" + percent_encoded(absolute_path(html).string()));
  const ChildResult ran = run_child(command, "");
  if (!ended_well(ran)) {
    throw environment_error("the handout cannot be printed: {} {}", printer, how_it_ended(ran));
  }
  std::error_code missing;
  std::string bytes = fs::exists(pdf, missing) ? read_file(pdf) : "";
  constexpr std::size_t kTrailer = 1024;  // bytes; it ends in there (PDF 1.7, implementation notes)
  const std::string_view end =
      std::string_view(bytes).substr(bytes.size() - std::min(bytes.size(), kTrailer));
  if (!bytes.starts_with("%PDF-") || end.find("%%EOF") == std::string_view::npos) {
    throw environment_error("the handout cannot be printed: {} wrote no whole PDF", printer);
  }
  return bytes;
}

}  // namespace polhode
