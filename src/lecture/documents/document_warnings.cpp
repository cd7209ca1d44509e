// SPDX-License-Identifier: MIT
#include "lecture/documents/document_warnings.h"

#include <algorithm>
#include <set>

#include "base/system/atomic_file.h"
#include "lecture/deck/characters.h"
#include "lecture/deck/own_pictures.h"
#include "lecture/deck/sandbox.h"
#include "lecture/deck/word_list.h"
#include "lecture/documents/latex.h"
#include "lecture/documents/pages.h"
#include "text/typesetter.h"
#include "video/picture_check.h"

namespace polhode {
namespace {

// The characters that no font here has, in words: a handout is set here, other documents where they
// are read.
std::vector<std::string> characters_without_font(const Deck& deck) {
  const Typesetter typesetter;
  std::vector<std::string> list = characters_of(deck);
  std::erase_if(list, [&](const std::string& one) {
    // behind a letter, on which accents may stand
    return one.size() == 1 || typesetter.missing_letters("a" + one) == 0;
  });
  for (std::string& one : list)
    one = with_code_point(one);
  return list;
}

// whether pictures of the deck's own or columns have a width
bool has_widths(const Json& blocks) {
  return has_node(blocks, [](const Json& node) {
    if (node["t"] != "Image" && !is_div(node, "column")) return false;
    const Json& settings = node["c"][0][2];
    return std::any_of(
        settings.begin(), settings.end(), [](const Json& pair) { return pair[0] == "width"; });
  });
}

// whether lines of code are to have numbers
bool has_numbered_lines(const Json& blocks) {
  return has_node(blocks, [](const Json& node) {
    if (node["t"] != "CodeBlock") return false;
    const Json& classes = node["c"][0][1];
    return std::any_of(classes.begin(), classes.end(), [](const Json& name) {
      return name == "numberLines" || name == "number-lines";
    });
  });
}

// Whether a picture of the deck was taken with the camera on its side.
bool is_turned_photo(const Deck& deck, const std::string& image) {
  return is_jpeg(image) && is_turned(read_file(trusted_file(deck.root, deck.root.folder, image)));
}

}  // namespace

std::vector<std::string> document_warnings(const Deck& deck, const std::string& output) {
  std::vector<std::string> list;
  if (output == "handout") {
    const std::vector<std::string> missing = characters_without_font(deck);
    if (!missing.empty()) {
      list.push_back(
          fmt::format("no font here has {}, which become boxes; install one that has them, such as "
                      "fonts-noto-cjk for Chinese, Japanese and Korean",
                      named_words(missing)));
    }
  }
  if (output != "beamer" && has_numbered_lines(deck.blocks))
    list.push_back("lines of code have no numbers (.numberLines): only LaTeX writes them");
  if (output != "beamer" && output != "pptx") return list;
  const std::string lang = words_of(deck).lang;
  if (is_written_from_the_right(lang)) {
    list.push_back(
        fmt::format("{} is written from right to left: only pages lay out lines so, here they "
                    "begin at the left",
                    lang));
  }
  const std::set<std::string> images(deck.images.begin(), deck.images.end());
  for (const std::string& image : images) {
    if (is_for_pages_only(image)) {
      list.push_back(
          fmt::format("{} is shown by its description: only browsers show .svg and .webp", image));
    }
  }
  for (const std::string& image : images) {
    if (is_turned_photo(deck, image)) {
      list.push_back(
          fmt::format("{} lies as its pixels do: only pages turn it as its camera was held; turn "
                      "the file, as `exiftran -ai` does",
                      image));
    }
  }
  if (output == "pptx" && has_widths(deck.blocks)) {
    list.push_back(
        "widths of pictures and columns are left out: in PowerPoint both fill their places");
  }
  if (output == "pptx") return list;
  for (const std::string& character : characters_without_latex(deck)) {
    list.push_back(
        fmt::format("pdflatex has no {}; lualatex has, with a font that has it", character));
  }
  return list;
}

}  // namespace polhode
