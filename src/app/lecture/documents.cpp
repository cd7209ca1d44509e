// SPDX-License-Identifier: MIT
#include "app/lecture/documents.h"

#include <algorithm>

#include "app/lecture/pandoc.h"
#include "app/scratch_folder.h"
#include "base/atomic_file.h"

namespace polhode {
namespace {

std::string without_spaces(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; });
  return text;
}

Json filled(const Deck& deck, const FigureOf& figure_of, Json (*blocks)(const Figure&)) {
  return with_pictures(
      deck.blocks, [&](const DeckPicture& picture) { return blocks(figure_of(picture)); }, deck);
}

// Words for the speaker are text on the page: the page is what a student reads.
Json with_notes_as_text(Json blocks) {
  for_each_node(blocks, [](Json& node) {
    if (node["t"] != "Div") return;
    for (Json& name : node["c"][0][1]) {
      if (name == "notes") name = "prose";
    }
  });
  return blocks;
}

}  // namespace

void drop_bad_formulas(Deck& deck, const std::string& deck_text) {
  // captions too
  Json all = deck.blocks;
  for (const DeckPicture& picture : deck.pictures)
    all.push_back(paragraph(picture.caption));
  std::erase_if(all.get_ref<Json::array_t&>(),
                [](const Json& block) { return block["t"] == kPictureNode; });
  all = with_pictures(
      all, [](const DeckPicture&) { return Json::array(); }, deck);
  std::vector<std::string> bad =
      write_document(deck.tree(all), {"-t", "html5", "--mathml"}).bad_formulas;
  if (bad.empty()) return;
  for (std::string& formula : bad)
    formula = without_spaces(formula);
  LineFinder lines(deck_text);
  const auto drop = [&](Json& node) {
    if (node["t"] != "Math") return;
    const std::string tex = node["c"][1];
    if (std::find(bad.begin(), bad.end(), without_spaces(tex)) == bad.end()) return;
    deck.problems.push_back(input_error("pandoc cannot read the formula '{}'", tex.substr(0, 80))
                                .at({deck.file, lines.next(tex), {}}));
    node = string_inlines("[a formula that cannot be read]")[0];
  };
  for_each_node(deck.blocks, drop);
  for_each_node(deck.meta, drop);
  for (DeckPicture& picture : deck.pictures)
    for_each_node(picture.caption, drop);
}

std::string make_page(const Deck& deck, const FigureOf& figure_of) {
  Deck plain = deck;
  plain.meta = Json::object();
  const Json tree = plain.tree(with_notes_as_text(filled(deck, figure_of, page_blocks)));
  const std::string body =
      write_document(tree,
                     {"-t", "html5", "--mathml", "--section-divs", "--shift-heading-level-by=1"})
          .text;
  // the contents come from pandoc's own template, which has nothing else here
  const ScratchFolder scratch;
  const std::string only_contents = scratch / "contents.html";
  write_file(only_contents, "$table-of-contents$\n");
  const std::string contents = write_document(tree,
                                              {"-t",
                                               "html5",
                                               "--toc",
                                               "--toc-depth=2",
                                               "--shift-heading-level-by=1",
                                               "-s",
                                               "--template=" + only_contents,
                                               "--metadata=title:-"},
                                              false)
                                   .text;
  return lecture_page(words_of(deck), body, contents);
}

std::string make_slides(const Deck& deck, const FigureOf& figure_of, const Reveal& reveal) {
  Deck plain = deck;
  plain.meta = Json::object();
  const Json tree = plain.tree(filled(deck, figure_of, slide_blocks));
  const std::string body =
      write_document(tree, {"-t", "revealjs", "--mathml", "--slide-level=2"}).text;
  return slides_page(words_of(deck), body, reveal);
}

std::string make_handout_html(const Deck& deck, const FigureOf& figure_of) {
  Deck plain = deck;
  plain.meta = Json::object();
  const Json tree = plain.tree(with_notes_as_text(filled(deck, figure_of, handout_blocks)));
  const std::string body =
      write_document(tree,
                     {"-t", "html5", "--mathml", "--section-divs", "--shift-heading-level-by=1"})
          .text;
  return handout_page(words_of(deck), body);
}

std::string make_beamer(const Deck& deck, const FigureOf& figure_of) {
  const Json tree = deck.tree(filled(deck, figure_of, beamer_blocks));
  return write_document(tree, {"-t", "beamer", "-s", "--slide-level=2", "-V", "aspectratio=169"})
      .text;
}

std::string make_pptx(const Deck& deck,
                      const FigureOf& figure_of,
                      const std::filesystem::path& folder) {
  const Json tree = deck.tree(filled(deck, figure_of, office_blocks));
  const ScratchFolder scratch;
  const std::string file = scratch / "slides.pptx";
  // it reads the posters, which are ours, and copies of the deck's own pictures
  write_document(
      tree,
      {"-t", "pptx", "--slide-level=2", "--resource-path=" + folder.string(), "-o", file},
      false);
  return read_file(file);
}

}  // namespace polhode
