// SPDX-License-Identifier: MIT
#include "lecture/documents/documents.h"

#include <algorithm>
#include <functional>
#include <map>
#include <regex>

#include "base/system/atomic_file.h"
#include "base/system/scratch_folder.h"
#include "lecture/deck/formulas.h"
#include "lecture/deck/line_finder.h"
#include "lecture/deck/own_pictures.h"
#include "lecture/deck/pandoc.h"
#include "lecture/documents/latex.h"
#include "lecture/documents/mathml.h"
#include "lecture/documents/office_lists.h"
#include "lecture/documents/office_slides.h"

namespace polhode {
namespace {

std::string without_spaces(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; });
  return text;
}

constexpr const char* kNoFormula = "[a formula that cannot be read]";

// A picture alone with its caption below, as this version of pandoc has figures.
Json figure(Json image, const Json& api_version) {
  const std::string place = image["c"][0][0];
  const Json caption = image["c"][1];
  const bool has_nodes = api_version >= Json::array({1, 23});
  if (caption.empty() || has_nodes) {
    image["c"][0][0] = "";
    describe(image);
  }
  const Json alone = Json::array({paragraph(Json::array({image}))});
  if (caption.empty()) return place.empty() ? alone[0] : named("Div", place, alone);
  if (has_nodes) {
    Json node = named("Figure", place, Json::array({nullptr, {paragraph(caption)}}));
    node["c"].push_back(alone);
    return node;
  }
  image["c"][2][1] = "fig:";
  return paragraph(Json::array({image}));
}

// Gives pictures alone their captions, but not inside tables and footnotes, which have no room.
void make_figures(Json& tree, const Json& api_version) {
  if (tree.is_array()) {
    for (Json& child : tree)
      make_figures(child, api_version);
  }
  if (!tree.is_object() || !tree.contains("c") || !may_hold_figures(tree)) return;
  if (is_image_alone(tree)) {
    tree = figure(tree["c"][0], api_version);
  } else {
    make_figures(tree["c"], api_version);
  }
}

// The deck's blocks with those that `blocks` makes of its pictures.
Json filled(const Deck& deck, const FigureOf& figure_of, Json (*blocks)(const Figure&)) {
  return with_pictures(
      deck.blocks, [&](const DeckPicture& picture) { return blocks(figure_of(picture)); }, deck);
}

Json with_captions(const Deck& deck, const FigureOf& figure_of, Json (*blocks)(const Figure&)) {
  Json all = filled(deck, figure_of, blocks);
  make_figures(all, deck.api_version);
  return all;
}

// Whether something in letters is raised or lowered twice: they have one height.
bool is_raised_twice(const Json& tree, bool inside = false) {
  if (tree.is_object() && tree.contains("c")) {
    const std::string type = tree.value("t", "");
    const bool is_raised = type == "Superscript" || type == "Subscript";
    return (is_raised && inside) || is_raised_twice(tree["c"], inside || is_raised);
  }
  return tree.is_array() && std::any_of(tree.begin(), tree.end(), [&](const Json& child) {
           return is_raised_twice(child, inside);
         });
}

// Whether a formula raises or lowers braces that end with such a thing, which letters run together:
// {x^2}^3 is no x^{23}.
bool raises_braces(const std::string& tex) {
  const auto last_before = [&](std::size_t at) {
    return at == 0 ? std::string::npos : tex.find_last_not_of(" \n", at - 1);
  };
  for (const char mark : {'^', '_'}) {
    for (std::size_t at = tex.find(mark); at != std::string::npos; at = tex.find(mark, at + 1)) {
      const std::size_t close = last_before(at);
      if (close == std::string::npos || tex[close] != '}') continue;
      const std::size_t end = last_before(close);
      if (end == std::string::npos) continue;
      const std::size_t open = tex[end] == '}' ? tex.rfind('{', end) : end;
      const std::size_t before = open == std::string::npos ? open : last_before(open);
      if (before != std::string::npos && tex[before] == mark) return true;
    }
  }
  return false;
}

// Titles, captions and tables with formulas in letters: for PowerPoint pandoc writes formulas there
// that are no XML, because their namespace is not declared. What letters cannot say, as fractions,
// roots and powers of powers, stays TeX.
Json with_lettered_formulas(Json tree) {
  std::vector<Json*> formulas;
  const auto collect = [&](Json& node) {
    if (node["t"] == "Math") formulas.push_back(&node);
  };
  for_each_node(tree["meta"], collect);
  for_each_node(tree["blocks"], [&](Json& node) {
    const std::string type = node["t"];
    if (type == "Header" || type == "Image" || type == "Table") for_each_node(node["c"], collect);
  });
  if (formulas.empty()) return tree;
  Json alone = tree;
  alone["meta"] = Json::object();
  alone["blocks"] = Json::array();
  // a word in front of each keeps the paragraphs of formulas without letters, such as $\,$
  const Json word = string_inlines("|")[0];
  for (const Json* formula : formulas)
    alone["blocks"].push_back(paragraph(Json::array({word, *formula})));
  const Json letters = read_html(write_document(alone, {"-t", "html5"}).text)["blocks"];
  if (letters.size() != formulas.size()) return tree;
  const Json none = Json::array({"", Json::array(), Json::array()});
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    Json inlines = letters[i]["c"];
    inlines.erase(0);
    const std::string tex = (*formulas[i])["c"][1];
    if (is_raised_twice(inlines) || raises_braces(tex)) inlines = string_inlines(tex);
    *formulas[i] = {{"t", "Span"}, {"c", {none, inlines}}};
  }
  return tree;
}

// whether a node is a link to a place in the document
bool leads_inside(const Json& node) {
  return node["t"] == "Link" && node["c"][2][0].get<std::string>().starts_with("#");
}

// PowerPoint leads to slides by their titles, and to nothing else; from tables, pandoc's links lead
// nowhere.
void lead_to_titles(Json& tree, const std::map<std::string, std::string>& titles) {
  for_each_node(tree["blocks"], [&](Json& node) {
    if (node["t"] == "Table") {
      for_each_node(node["c"], [](Json& inside) {
        if (leads_inside(inside)) inside = {{"t", "Span"}, {"c", {inside["c"][0], inside["c"][1]}}};
      });
    }
    if (!leads_inside(node)) return;
    Json& target = node["c"][2][0];
    const auto found = titles.find(percent_decoded(target.get<std::string>().substr(1)));
    if (found != titles.end()) target = "#" + found->second;
  });
}

// A picture in words, in brackets: its description or else its caption; behind a description, the
// caption.
Json said(Json image) {
  const Json caption = image["c"][1];
  const bool has_alt = alt_of_image(image).has_value();
  describe(image);
  Json words = string_inlines("[");
  const Json& description = image["c"][1];
  words.insert(words.end(), description.begin(), description.end());
  words.push_back(string_inlines(description.empty() ? "picture]" : "]")[0]);
  if (has_alt) {
    words.push_back({{"t", "Space"}});
    words.insert(words.end(), caption.begin(), caption.end());
  }
  return named("Span", image["c"][0][0], words);
}

void say_what_pages_show(Json& blocks) {
  for_each_node(blocks, [](Json& node) {
    if (node["t"] == "Image" && is_for_pages_only(node["c"][2][0])) node = said(node);
  });
}

// Slides would show footnotes of notes for the speaker to all.
void say_footnotes_of_notes(Json& blocks) {
  for_each_node(blocks, [](Json& node) {
    if (!is_div(node, "notes")) return;
    for_each_node(node["c"], [](Json& inside) {
      if (inside["t"] == "Note") inside = said_footnote(inside);
    });
  });
}

// In PowerPoint notes for the speaker are words alone: pandoc leaves out footnotes, tables,
// pictures and where links lead.
void say_notes(Json& blocks) {
  const auto say = [](Json& node) {
    const std::string type = node["t"];
    if (type == "Table") node = paragraph(inlines_of(Json::array({node}), {{"t", "LineBreak"}}));
    if (type == "Image") node = said(node);
    if (type == "Note") {
      node = said_footnote(node);
    } else if (type == "Link" && !leads_inside(node)) {
      Json words = node["c"][1];
      const std::string address = node["c"][2][0];
      if (plain_text(words) != address) words.push_back(string_inlines(" (" + address + ")")[0]);
      node = named("Span", "", words);
    }
  };
  for_each_node(blocks, [&](Json& node) {
    if (is_div(node, "notes")) for_each_node(node["c"], say);
  });
}

bool is_pause(const Json& block) {
  return block.is_object() && block.value("t", "") == "Para" && plain_text(block["c"]) == ". . .";
}

// ". . .": PowerPoint, pages and paper have no pauses, and pandoc would write the dots
void leave_out_pauses(Json& tree) {
  if (!tree.is_structured()) return;
  if (tree.is_array()) std::erase_if(tree.get_ref<Json::array_t&>(), is_pause);
  for (Json& child : tree)
    leave_out_pauses(child);
}

// Behind a pause in a list, a quotation or a box the rest of that comes at the next press. pandoc
// makes this of pauses between the paragraphs of a slide, and dots of others.
void part_at_pauses(Json& tree) {
  if (!tree.is_structured()) return;
  if (tree.is_object() && (tree.value("t", "") == "Note" || is_div(tree, "notes"))) {
    leave_out_pauses(tree);
    return;
  }
  for (Json& child : tree)
    part_at_pauses(child);
  if (!tree.is_array()) return;
  Json::array_t& blocks = tree.get_ref<Json::array_t&>();
  for (std::size_t i = blocks.size(); i-- > 0;) {
    if (!is_pause(blocks[i])) continue;
    const auto rest = blocks.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    Json later = div("fragment", Json::array_t(rest, blocks.end()));
    blocks.resize(i);
    blocks.push_back(std::move(later));
  }
}

// pandoc writes \tfrac on one line there, without the brackets that this would need
void write_whole_fractions(Json& tree) {
  static const std::regex small(R"(\\tfrac(?![A-Za-z]))");
  for_each_node(tree["blocks"], [](Json& node) {
    if (node["t"] == "Math")
      node["c"][1] = std::regex_replace(node["c"][1].get<std::string>(), small, "\\frac");
  });
}

// pandoc describes pictures by their titles in PowerPoint
void describe_by_titles(Json& tree) {
  for_each_node(tree["blocks"], [](Json& node) {
    if (node["t"] != "Image") return;
    const std::string words = alt_of_image(node).value_or(plain_text(node["c"][1]));
    if (!words.empty()) node["c"][2][1] = words;
  });
}

// LaTeX has no captions in tables and footnotes: there those of scenes follow their pictures.
// Tables of numbers have theirs.
void add_captions(Json& tree, const Deck& deck, bool has_room = true) {
  if (tree.is_object() && tree.contains("c"))
    add_captions(tree["c"], deck, has_room && may_hold_figures(tree));
  if (!tree.is_array()) return;
  Json out = Json::array();
  for (Json& child : tree) {
    add_captions(child, deck, has_room);
    out.push_back(child);
    if (has_room || !child.is_object() || child.value("t", "") != kPictureNode) continue;
    const DeckPicture& picture = deck.pictures[child["c"].get<std::size_t>()];
    if (picture.kind != PictureKind::inspect && !picture.caption.empty())
      out.push_back(paragraph(picture.caption));
  }
  tree = std::move(out);
}

// What titles contain has no names in the contents, where it stands a second time.
Json with_plain_titles(Json tree) {
  for_each_node(tree["blocks"], [](Json& node) {
    if (node["t"] != "Header") return;
    for_each_node(node["c"][2], [](Json& inside) {
      if (Json* attributes = attributes_of(inside)) (*attributes)[0] = "";
    });
  });
  return tree;
}

// The brackets of the marks of a list by a name of deck.css, such as OneParen-LowerAlpha for a);
// empty for a full stop.
std::string brackets_of(const Json& list) {
  const std::string style = list["c"][0][1]["t"], around = list["c"][0][2]["t"];
  if (around != "OneParen" && around != "TwoParens") return "";
  const bool counts = style == "DefaultStyle" || style == "Example";
  return around + "-" + (counts ? "Decimal" : style);
}

// A box around a list says to pages what its marks are that are not those of browsers: in brackets,
// or with more signs than they leave room for, such as 1983., viii. and (a).
void describe_marks(Json& blocks) {
  constexpr std::size_t kRoom = 3, kRoomWithBrackets = 2;
  std::vector<std::pair<Json*, std::string>> lists;
  for_each_node(blocks, [&](Json& node) {
    if (node["t"] != "OrderedList") return;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < items_of(node).size(); ++i)
      longest = std::max(longest, mark_of(node, i)[0]["c"].get_ref<const std::string&>().size());
    const std::string brackets = brackets_of(node);
    std::string style;
    if (longest > (brackets.empty() ? kRoom : kRoomWithBrackets))
      style = fmt::format("--mark: {};", longest);
    if (!brackets.empty()) style += fmt::format("--brackets: {};", brackets);
    if (!style.empty()) lists.emplace_back(&node, style);
  });
  // lists in lists first
  std::for_each(lists.rbegin(), lists.rend(), [](const std::pair<Json*, std::string>& one) {
    Json box = named("Div", "", Json::array({*one.first}));
    box["c"][0][2].push_back(Json::array({"style", one.second}));
    *one.first = std::move(box);
  });
}

// Of a table with a long line pandoc gives the columns widths, by the number of dashes below their
// heads. Formulas cannot be broken: browsers find better ones.
void free_columns_of_formulas(Json& blocks) {
  for_each_node(blocks, [](Json& node) {
    if (node["t"] != "Table") return;
    if (!has_node(node["c"], [](const Json& inside) { return inside["t"] == "Math"; })) return;
    for (Json& column : node["c"][2])
      column[1] = {{"t", "ColWidthDefault"}};
  });
}

// The deck for pages, which write its title themselves and do not colour code: names of languages
// could be those of parts of the page.
Json for_page(const Deck& deck, Json blocks) {
  describe_marks(blocks);
  free_columns_of_formulas(blocks);
  for_each_node(blocks, [](Json& node) {
    if (node["t"] == "Code" || node["t"] == "CodeBlock") (*attributes_of(node))[1] = Json::array();
  });
  Deck plain = deck;
  plain.meta = Json::object();
  return plain.tree(blocks);
}

// The deck for a page that a student reads, all of it at once: words for the speaker are text
// there.
Json for_reading(const Deck& deck, Json blocks) {
  leave_out_pauses(blocks);
  for_each_node(blocks, [](Json& node) {
    if (node["t"] != "Div") return;
    for (Json& name : node["c"][0][1]) {
      if (name == "notes") name = "prose";
    }
  });
  return for_page(deck, std::move(blocks));
}

bool has_only_words(const Json& inlines) {
  return std::all_of(inlines.begin(), inlines.end(), [](const Json& one) {
    return one["t"] == "Str" || one["t"] == "Space" || one["t"] == "SoftBreak";
  });
}

// The words at the head of a page, with what is marked up.
DeckWords page_words(const Deck& deck) {
  DeckWords words = words_of(deck);
  std::vector<std::string> keys;
  Json paragraphs = Json::array();
  for (const char* key : {"title", "subtitle", "author", "date", "licence"}) {
    if (!deck.meta.contains(key)) continue;
    const Json inlines = inlines_of_field(deck.meta[key]);
    if (has_only_words(inlines)) continue;
    keys.emplace_back(key);
    paragraphs.push_back(paragraph(inlines));
  }
  if (keys.empty()) return words;
  Deck head = deck;
  head.meta = Json::object();
  const std::string html = formulas_for_browsers(
      write_document(head.tree(paragraphs), {"-t", "html5", "--mathml"}).text);
  constexpr std::string_view kBegin = "<p>", kEnd = "</p>";
  std::size_t from = html.find(kBegin);
  for (const std::string& key : keys) {
    const std::size_t end = from == std::string::npos ? from : html.find(kEnd, from);
    if (end == std::string::npos) return words;
    from += kBegin.size();
    words.marked_up[key] = html.substr(from, end - from);
    from = html.find(kBegin, end);
  }
  return words;
}

// never empty: of a deck without words pandoc writes an empty line
std::string whole_document(const Json& tree, const std::vector<std::string>& words) {
  std::string text = write_document(tree, words).text;
  if (text.empty()) throw environment_error("a document cannot be made: pandoc wrote nothing");
  return text;
}

std::string sections_html(const Json& tree) {
  return whole_document(
      tree, {"-t", "html5", "--mathml", "--section-divs", "--shift-heading-level-by=1"});
}

}  // namespace

void settle_formulas(Deck& deck, const std::string& deck_text) {
  LineFinder lines(deck_text, deck.blocks);
  const auto tell = [&](const std::string& tex, const Error& error) {
    const auto quoting = deck.with_numbers.find(tex);
    const std::string& written = quoting == deck.with_numbers.end() ? tex : quoting->second;
    deck.problems.push_back(error.at({deck.file, lines.next(written), {}}));
  };
  const auto for_each_formula = [&](const std::function<void(Json&)>& work) {
    const auto visit = [&](Json& node) {
      if (node["t"] == "Math") work(node);
    };
    for_each_node(deck.blocks, visit);
    for_each_node(deck.meta, visit);
    for (DeckPicture& picture : deck.pictures)
      for_each_node(picture.caption, visit);
  };
  std::map<std::string, std::string> written;  // as the deck has them
  for_each_formula([&](Json& node) {
    const std::string tex = node["c"][1];
    try {
      node["c"][1] = whole_formula(tex);
      written[node["c"][1]] = tex;
    } catch (const Error& error) {
      tell(tex, error);
      node = string_inlines(kNoFormula)[0];
    }
  });
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
  for_each_formula([&](Json& node) {
    const std::string tex = node["c"][1];
    if (std::find(bad.begin(), bad.end(), without_spaces(tex)) == bad.end()) return;
    const std::string& its = written.at(tex);
    tell(its, input_error("pandoc cannot read the formula '{}'", its.substr(0, 80)));
    node = string_inlines(kNoFormula)[0];
  });
}

std::string make_page(const Deck& deck, const FigureOf& figure_of, const std::string& viewers) {
  const Json tree = for_reading(deck, with_captions(deck, figure_of, page_blocks));
  const std::string body = sections_html(tree);
  // the contents come from pandoc's own template, which has nothing else here
  const ScratchFolder scratch;
  const std::string only_contents = scratch / "contents.html";
  write_file(only_contents, "$table-of-contents$\n");
  const std::string contents = write_document(with_plain_titles(tree),
                                              {"-t",
                                               "html5",
                                               "--mathml",
                                               "--toc",
                                               "--toc-depth=3",
                                               "--shift-heading-level-by=1",
                                               "-s",
                                               "--template=" + only_contents,
                                               "--metadata=title:-"},
                                              false)
                                   .text;
  return lecture_page(
      page_words(deck), formulas_for_browsers(body), formulas_for_browsers(contents), viewers);
}

std::string make_slides(const Deck& deck,
                        const FigureOf& figure_of,
                        const Reveal& reveal,
                        const std::string& viewers) {
  Json blocks = with_captions(deck, figure_of, slide_blocks);
  say_footnotes_of_notes(blocks);
  for (Json& block : blocks)
    part_at_pauses(block);
  const Json tree = for_page(deck, std::move(blocks));
  const std::string body = whole_document(tree, {"-t", "revealjs", "--mathml", "--slide-level=2"});
  return slides_page(page_words(deck), formulas_for_browsers(body), reveal, viewers);
}

std::string make_handout_html(const Deck& deck, const FigureOf& figure_of) {
  const Json tree = for_reading(deck, with_captions(deck, figure_of, handout_blocks));
  return handout_page(page_words(deck), formulas_for_browsers(sections_html(tree)));
}

std::string make_beamer(const Deck& deck, const FigureOf& figure_of) {
  Deck slides = deck;
  slides.blocks = latex_slides(deck);
  add_captions(slides.blocks, deck);
  Json blocks = filled(slides, figure_of, beamer_blocks);
  say_what_pages_show(blocks);
  leave_room_for_captions(blocks);
  make_figures(blocks, deck.api_version);
  const Json tree = for_latex(deck.tree(blocks));
  return whole_document(tree,
                        {"-t",
                         "beamer",
                         "-s",
                         "--slide-level=2",
                         "-V",
                         "aspectratio=169",
                         "-V",
                         "fonttheme=professionalfonts"});
}

std::string make_pptx(const Deck& deck,
                      const FigureOf& figure_of,
                      const std::filesystem::path& folder) {
  Deck slides = deck;
  say_what_pages_show(slides.blocks);
  leave_out_pauses(slides.blocks);
  const OfficeSlides layout = office_slides(slides);
  slides.blocks = layout.blocks;
  Json blocks = filled(slides, figure_of, office_blocks);
  say_what_pages_show(blocks);  // in captions, too
  say_notes(blocks);
  settle_numbers_of_lists(blocks);
  Json tree = with_lettered_formulas(deck.tree(blocks));
  write_whole_fractions(tree);
  describe_by_titles(tree);
  lead_to_titles(tree, layout.titles);
  const ScratchFolder scratch;
  const std::string file = scratch / "slides.pptx";
  // it reads the posters, which are ours, and copies of the deck's own pictures
  write_document(
      tree,
      {"-t", "pptx", "--slide-level=2", "--resource-path=" + folder.string(), "-o", file},
      false);
  std::error_code missing;
  std::string bytes = std::filesystem::exists(file, missing) ? read_file(file) : "";
  // a ZIP archive
  if (!bytes.starts_with("PK")) {
    throw environment_error("slides.pptx cannot be made: pandoc wrote no such document");
  }
  return bytes;
}

}  // namespace polhode
