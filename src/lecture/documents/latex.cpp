// SPDX-License-Identifier: MIT
#include "lecture/documents/latex.h"

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "base/utf8.h"
#include "lecture/deck/characters.h"
#include "lecture/deck/formulas.h"

namespace polhode {
namespace {

// What TeX writes in mathematics for characters that its fonts of text lack, or have in text only.
const std::map<std::string, std::string>& math_of_characters() {
  static const std::map<std::string, std::string> table = [] {
    std::map<std::string, std::string> all = {{"−", "-"},
                                              {"±", "\\pm"},
                                              {"∓", "\\mp"},
                                              {"×", "\\times"},
                                              {"÷", "\\div"},
                                              {"·", "\\cdot"},
                                              {"⋅", "\\cdot"},
                                              {"∘", "\\circ"},
                                              {"°", "{}^\\circ"},
                                              {"′", "{}'"},
                                              {"″", "{}''"},
                                              {"∞", "\\infty"},
                                              {"≈", "\\approx"},
                                              {"≃", "\\simeq"},
                                              {"≅", "\\cong"},
                                              {"∼", "\\sim"},
                                              {"≠", "\\neq"},
                                              {"≡", "\\equiv"},
                                              {"≤", "\\le"},
                                              {"≥", "\\ge"},
                                              {"⩽", "\\leqslant"},
                                              {"⩾", "\\geqslant"},
                                              {"≪", "\\ll"},
                                              {"≫", "\\gg"},
                                              {"∝", "\\propto"},
                                              {"∂", "\\partial"},
                                              {"∇", "\\nabla"},
                                              {"∆", "\\Delta"},
                                              {"∑", "\\sum"},
                                              {"∏", "\\prod"},
                                              {"∫", "\\int"},
                                              {"∮", "\\oint"},
                                              {"√", "\\surd"},
                                              {"∈", "\\in"},
                                              {"∉", "\\notin"},
                                              {"⊂", "\\subset"},
                                              {"⊆", "\\subseteq"},
                                              {"∪", "\\cup"},
                                              {"∩", "\\cap"},
                                              {"∅", "\\emptyset"},
                                              {"∀", "\\forall"},
                                              {"∃", "\\exists"},
                                              {"∧", "\\wedge"},
                                              {"∨", "\\vee"},
                                              {"¬", "\\neg"},
                                              {"⊥", "\\perp"},
                                              {"⟂", "\\perp"},
                                              {"∥", "\\parallel"},
                                              {"∠", "\\angle"},
                                              {"⊗", "\\otimes"},
                                              {"⊕", "\\oplus"},
                                              {"⊙", "\\odot"},
                                              {"†", "\\dagger"},
                                              {"←", "\\leftarrow"},
                                              {"→", "\\rightarrow"},
                                              {"↑", "\\uparrow"},
                                              {"↓", "\\downarrow"},
                                              {"↔", "\\leftrightarrow"},
                                              {"⇐", "\\Leftarrow"},
                                              {"⇒", "\\Rightarrow"},
                                              {"⇔", "\\Leftrightarrow"},
                                              {"↦", "\\mapsto"},
                                              {"⟶", "\\longrightarrow"},
                                              {"⟨", "\\langle"},
                                              {"⟩", "\\rangle"},
                                              {"ℓ", "\\ell"},
                                              {"ħ", "\\hbar"},
                                              {"ℏ", "\\hbar"},
                                              {"ℝ", "\\mathbb{R}"},
                                              {"✓", "\\checkmark"},
                                              {"☐", "\\square"},
                                              {"☒", "\\boxtimes"},
                                              {"…", "\\ldots"},
                                              {"⋯", "\\cdots"},
                                              {"µ", "\\mu"},
                                              {"ε", "\\epsilon"},
                                              {"ϵ", "\\epsilon"},
                                              {"φ", "\\varphi"},
                                              {"ϕ", "\\phi"},
                                              {"ϑ", "\\vartheta"},
                                              {"ς", "\\varsigma"},
                                              {"ο", "o"}};
    const auto add = [&](const std::vector<std::string>& characters, const auto& tex_of) {
      for (std::size_t i = 0; i < characters.size(); ++i)
        all[characters[i]] = tex_of(i);
    };
    const std::vector<std::string> raised = {
        "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "⁺", "⁻"};
    const std::vector<std::string> lowered = {
        "₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉", "₊", "₋"};
    const std::string signs = "0123456789+-";
    add(raised, [&](std::size_t i) { return fmt::format("{{}}^{{{}}}", signs[i]); });
    add(lowered, [&](std::size_t i) { return fmt::format("{{}}_{{{}}}", signs[i]); });
    const std::vector<std::string> small = {"alpha", "beta", "gamma", "delta",  "zeta", "eta",
                                            "theta", "iota", "kappa", "lambda", "mu",   "nu",
                                            "xi",    "pi",   "rho",   "sigma",  "tau",  "upsilon",
                                            "chi",   "psi",  "omega"};
    add({"α", "β", "γ", "δ", "ζ", "η", "θ", "ι", "κ", "λ", "μ",
         "ν", "ξ", "π", "ρ", "σ", "τ", "υ", "χ", "ψ", "ω"},
        [&](std::size_t i) { return "\\" + small[i]; });
    const std::vector<std::string> large = {
        "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega"};
    add({"Γ", "Δ", "Θ", "Λ", "Ξ", "Π", "Σ", "Υ", "Φ", "Ψ", "Ω"},
        [&](std::size_t i) { return "\\" + large[i]; });
    // those that look like Latin letters
    const std::string latin = "ABEZHIKMNOPTX";
    add({"Α", "Β", "Ε", "Ζ", "Η", "Ι", "Κ", "Μ", "Ν", "Ο", "Ρ", "Τ", "Χ"},
        [&](std::size_t i) { return fmt::format("\\mathrm{{{}}}", latin[i]); });
    return all;
  }();
  return table;
}

// Whether pdflatex with the encodings T1 and TS1 has it in text.
bool is_in_fonts(const std::string& character) {
  struct Span {
    const char *first, *last;
  };
  constexpr Span kRanges[] = {
      {"\x01", "\x7f"},     {"\u00a0", "\u017e"}, {"\u0192", "\u0192"}, {"\u01c4", "\u01d4"},
      {"\u0218", "\u021b"}, {"\u02c6", "\u02c7"}, {"\u02d8", "\u02d9"}, {"\u02db", "\u02dd"},
      {"\u1e9e", "\u1e9e"}, {"\u2010", "\u2016"}, {"\u2018", "\u201a"}, {"\u201c", "\u201e"},
      {"\u2020", "\u2022"}, {"\u2026", "\u2026"}, {"\u2030", "\u2031"}, {"\u2039", "\u203b"},
      {"\u20ac", "\u20ac"}, {"\u2103", "\u2103"}, {"\u2116", "\u2117"}, {"\u2122", "\u2122"},
      {"\u2126", "\u2127"}, {"\u2190", "\u2193"}, {"\u27e8", "\u27e9"}, {"\ufb00", "\ufb06"}};
  return std::any_of(std::begin(kRanges), std::end(kRanges), [&](const Span& range) {
    return character >= range.first && character <= range.last;
  });
}

// One slide: where words and one picture share it, they stand side by side.
void add_slide(Json& blocks, const Json& slide, const Deck& deck) {
  Json words = Json::array(), pictures = Json::array(), notes = Json::array();
  bool several = false;
  for (const Json& block : slide) {
    const std::string type = block["t"];
    if (type == kPictureNode) {
      pictures.push_back(block);
      const DeckPicture& picture = deck.pictures[block["c"].get<std::size_t>()];
      several = several || picture.kind == PictureKind::inspect;
    } else if (is_div(block, "notes")) {
      notes.push_back(block);
    } else {
      several = several || type == "Div";
      words.push_back(block);
    }
  }
  if (pictures.size() == 1 && !words.empty() && !several) {
    blocks.push_back(
        div("columns", Json::array({div("column", words, "40%"), div("column", pictures, "60%")})));
    blocks.insert(blocks.end(), notes.begin(), notes.end());
  } else {
    blocks.insert(blocks.end(), slide.begin(), slide.end());
  }
}

Json formula(const std::string& tex) {
  return {{"t", "Math"}, {"c", {{{"t", "InlineMath"}}, tex}}};
}

// Words, with what the fonts lack as mathematics; raised digits that follow one another are one.
Json latex_words(const std::string& text) {
  Json words = Json::array();
  std::string plain, tex;
  const auto end_plain = [&] {
    if (!plain.empty()) words.push_back(string_inlines(plain)[0]);
    plain.clear();
  };
  const auto end_tex = [&] {
    if (!tex.empty()) words.push_back(formula(tex));
    tex.clear();
  };
  for_each_character(text, [&](const std::string& one) {
    const auto found = math_of_characters().find(one);
    const std::string is = found == math_of_characters().end() ? "" : found->second;
    const bool is_script = is.starts_with("{}^{") || is.starts_with("{}_{");
    if (is.empty() || (is_in_fonts(one) && !is_script)) {
      end_tex();
      plain += one;
      return;
    }
    end_plain();
    if (is_script && tex.starts_with(is.substr(0, 4))) {
      tex.insert(tex.size() - 1, 1, is[4]);
    } else {
      end_tex();
      tex = is;
    }
  });
  end_tex();
  end_plain();
  return words;
}

// Environments that stand in text, and what they are inside a formula.
constexpr std::pair<const char*, const char*> kEnvironments[] = {{"equation", "aligned"},
                                                                 {"align", "aligned"},
                                                                 {"flalign", "aligned"},
                                                                 {"gather", "gathered"},
                                                                 {"multline", "gathered"},
                                                                 {"alignat", "alignedat"}};

std::string with_inner_environments(std::string tex) {
  for (const auto& [name, inside] : kEnvironments) {
    const std::regex outer(fmt::format(R"(\\(begin|end)\{{{}\*?\}})", name));
    tex = std::regex_replace(tex, outer, fmt::format(R"(\$1{{{}}})", inside));
  }
  tex = std::regex_replace(tex, std::regex(R"(\\begin\{eqnarray\*?\})"), R"(\begin{array}{rcl})");
  return std::regex_replace(tex, std::regex(R"(\\end\{eqnarray\*?\})"), R"(\end{array})");
}

// Pandoc takes these as characters: everywhere in a formula, and in the words inside it.
std::string with_escapes(const std::string& tex) {
  const std::vector<bool> words = words_in(tex);
  std::string out;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    const char c = tex[i];
    if (c == '\\' && i + 1 < tex.size()) {
      out += tex.substr(i++, 2);
    } else if (words[i] && c == '^') {
      out += "\\^{}";
    } else {
      if (c == '#' || (words[i] && (c == '_' || c == '&'))) out += '\\';
      out += c;
    }
  }
  return out;
}

constexpr const char* kLineBreak = "LineBreak";

// Whether LaTeX would read an inline as an argument of what stands before it: of \\ ([, *) or, as
// a title, of \begin{frame} ({).
bool is_like_an_argument(const Json& inline_node) {
  const std::string type = inline_node["t"];
  if (type == "Span") return true;
  if (type != "Str") return false;
  const std::string words = inline_node["c"];
  return words.starts_with('[') || words.starts_with('*');
}

// ends what stands before it
Json end_of_command() {
  return {{"t", "RawInline"}, {"c", {"latex", "\\relax"}}};
}

// Walks through a tree and makes of it what pdflatex can set.
class Setter {
 public:
  void set(Json& tree) {
    if (tree.is_array()) {
      set_list(tree);
    } else if (tree.is_object()) {
      set_node(tree);
    }
  }

 private:
  static constexpr int kDeepest = 3;  // lists in lists, and quotations in quotations

  void set_list(Json& list) {
    Json out = Json::array();
    for (Json& child : list) {
      const std::string type = child.is_object() ? child.value("t", "") : "";
      const bool is_first =
          out.empty() || (out.back().is_object() && out.back()["t"] == kLineBreak);
      if (is_first && titles_ == 0 && !type.empty() && is_like_an_argument(child))
        out.push_back(end_of_command());
      if (type == "Str") {
        for (Json& word : latex_words(child["c"].get<std::string>()))
          out.push_back(std::move(word));
      } else if (is_list(type) && (lists_ >= kDeepest || !can_be_counted(child))) {
        Json items = blocks_of_list(child);
        add_blocks(out, items);
      } else if (type == "BlockQuote" && quotations_ >= kDeepest) {
        add_blocks(out, child["c"]);
      } else if (titles_ > 0 && type == "Span" && child["c"][0][0] != "") {
        // running heads leave out words that have a name
        set(child["c"][1]);
        const Json words = std::exchange(child["c"][1], Json::array());
        out.push_back(std::move(child));
        out.insert(out.end(), words.begin(), words.end());
      } else {
        set(child);
        out.push_back(std::move(child));
      }
    }
    list = std::move(out);
  }

  void set_node(Json& node) {
    const std::string type = node.value("t", "");
    if (type == "Math") {
      std::string tex = with_escapes(with_inner_environments(node["c"][1].get<std::string>()));
      // titles of parts are written to files, where rules of tables do not survive
      if (titles_ > 0) tex = std::regex_replace(tex, std::regex(R"(\\hline)"), "");
      node["c"][1] = tex;
    } else if (type == "Code") {
      // that of a language cannot stand in titles, captions and notes
      const std::string place = node["c"][0][0];
      node["c"][0] = Json::array({"", Json::array(), Json::array()});
      // pandoc gives code no name there
      if (!place.empty()) node = named("Span", place, Json::array({node}));
    } else if (type == "CodeBlock") {
      set_code(node);
    } else if (type == "Header" && lists_ + quotations_ + tables_ > 0) {
      // sections are not shown there
      node = title_as_words(node);
      set(node["c"]);
    } else {
      if (type == "Note") set_footnote(node);
      hide_brackets(node);
      int* const around = depth_of(node);
      if (around != nullptr) ++*around;
      for (auto& [key, value] : node.items()) {
        if (key != "t") set(value);
      }
      if (around != nullptr) --*around;
    }
  }

  // How deep what is in a node stands in its kind; null: that does not count.
  int* depth_of(const Json& node) {
    const std::string type = node.value("t", "");
    if (type == "Div" && is_div(node, "notes")) return &arguments_;
    if (is_list(type)) return &lists_;
    if (type == "Header") return &titles_;
    if (type == "BlockQuote") return &quotations_;
    return type == "Table" ? &tables_ : nullptr;
  }

  // what pandoc may write as an optional argument, \item[…] or \caption[…], ends at the first ]
  // that is not in braces
  static void hide_brackets(Json& node) {
    const std::string type = node.value("t", "");
    const auto hide = [](Json& words) {
      for_each_node(words, [](Json& inside) {
        if (inside["t"] != "Math") return;
        std::string& tex = inside["c"][1].get_ref<std::string&>();
        if (tex.find(']') != std::string::npos) tex = "{" + tex + "}";
      });
    };
    if (type == "Header") hide(node["c"][2]);
    if (type == "Image" || type == "Table") hide(node["c"][1]);
    if (type != "DefinitionList") return;
    for (Json& item : node["c"])
      hide(item[0]);
  }

  // footnotes of beamer are one paragraph, and in tables lines of their own do not wrap
  void set_footnote(Json& note) const {
    const Json space = {{"t", "Space"}}, line_break = {{"t", kLineBreak}};
    note["c"] = Json::array({paragraph(inlines_of(note["c"], tables_ > 0 ? space : line_break))});
    if (tables_ == 0) return;
    for_each_node(note, [&](Json& inside) {
      if (inside["t"] == kLineBreak) inside = space;
    });
  }

  // what is an argument of TeX holds no lines as they are; what would end a slide has a language,
  // for then no character of it is a command
  void set_code(Json& node) const {
    const std::string code = node["c"][1];
    if (arguments_ > 0) {
      node = paragraph(inlines_of(Json::array({node}), {{"t", kLineBreak}}));
    } else if (code.find("\\end{frame}") != std::string::npos) {
      node["c"][0][1] = Json::array({"default"});
    }
  }

  // letters end at z, and numbers where those of TeX do
  static bool can_be_counted(const Json& list) {
    if (list["t"] != "OrderedList") return true;
    constexpr std::size_t kLetters = 26, kMost = 100'000'000;
    const std::string style = list["c"][0][1]["t"];
    const std::size_t end = list["c"][0][0].get<std::size_t>() + items_of(list).size();
    return end <= (style.ends_with("Alpha") ? kLetters + 1 : kMost);
  }

  static bool is_list(const std::string& type) {
    return type == "BulletList" || type == "OrderedList" || type == "DefinitionList";
  }

  void add_blocks(Json& out, Json& blocks) {
    set(blocks);
    out.insert(out.end(), blocks.begin(), blocks.end());
  }

  int arguments_ = 0;  // of commands of TeX, around what is set
  int lists_ = 0, quotations_ = 0, tables_ = 0, titles_ = 0;  // around it
};

// What commands need in the preamble, beside amsmath and amssymb.
constexpr const char* kSiunitx = "\\IfFileExists{siunitx.sty}{\\usepackage{siunitx}}{}";
constexpr std::pair<const char*, const char*> kNeeds[] = {
    {"SI", kSiunitx},
    {"si", kSiunitx},
    {"qty", kSiunitx},
    {"unit", kSiunitx},
    {"num", kSiunitx},
    {"ang", kSiunitx},
    {"bm", "\\usepackage{bm}"},
    // titles of parts are written to files
    {"underline", "\\AtBeginDocument{\\robustify{\\underline}}"},
    {"mathscr", "\\providecommand{\\mathscr}{\\mathcal}"},
    {"coloneqq", "\\providecommand{\\coloneqq}{\\mathrel{:=}}"}};

bool has_command(const std::string& tex, const std::string& name) {
  const std::string command = "\\" + name;
  for (std::size_t at = tex.find(command); at != std::string::npos;
       at = tex.find(command, at + 1)) {
    const std::size_t end = at + command.size();
    if (end == tex.size() || std::isalpha(static_cast<unsigned char>(tex[end])) == 0) return true;
  }
  return false;
}

// Babel ends at the languages that it has no file of. "": none.
std::string language_of(const std::string& tag) {
  constexpr std::string_view kLanguages[] = {
      "en", "de", "fr", "es", "it", "pt", "nl", "sv", "da", "nb", "nn", "no", "fi",
      "is", "pl", "cs", "sk", "sl", "hr", "hu", "ro", "tr", "et", "lv", "lt", "ca",
      "eu", "gl", "ga", "cy", "la", "eo", "id", "vi", "ja", "ko", "hi", "af", "sq"};
  constexpr std::string_view kVariants[] = {"en-GB", "en-US", "de-AT", "de-CH", "pt-BR"};
  const std::string language = tag.substr(0, tag.find('-'));
  if (std::find(std::begin(kVariants), std::end(kVariants), tag) != std::end(kVariants)) return tag;
  return std::find(std::begin(kLanguages), std::end(kLanguages), language) != std::end(kLanguages)
             ? language
             : "";
}

// what stands in front of the document
std::string preamble_for(const Json& tree) {
  std::set<std::string> needs, characters;
  for_each_set_text(tree, [&](const std::string& text) {
    for (const auto& [command, line] : kNeeds)
      if (has_command(text, command)) needs.insert(line);
    for_each_character(text, [&](const std::string& one) {
      if (one.size() > 1 && math_of_characters().contains(one)) characters.insert(one);
    });
  });
  std::string lines;
  for (const std::string& line : needs)
    lines += line + "\n";
  if (characters.empty()) return lines;
  lines += "\\ifPDFTeX\n";
  for (const std::string& one : characters) {
    lines += fmt::format("\\DeclareUnicodeCharacter{{{}}}{{\\ensuremath{{{}}}}}\n",
                         code_point(one, 0).substr(2),
                         math_of_characters().at(one));
  }
  return lines + "\\fi\n";
}

}  // namespace

Json latex_slides(const Deck& deck) {
  Json blocks = Json::array(), slide = Json::array();
  for (const Json& block : deck.blocks) {
    if (block["t"] == "Header" || block["t"] == "HorizontalRule") {
      add_slide(blocks, slide, deck);
      slide = Json::array();
      blocks.push_back(block);
    } else {
      slide.push_back(block);
    }
  }
  add_slide(blocks, slide, deck);
  return blocks;
}

void leave_room_for_captions(Json& blocks) {
  for_each_node(blocks, [](Json& node) {
    if (!is_image_alone(node)) return;
    Json& settings = node["c"][0]["c"][0][2];
    const bool has_width = std::any_of(
        settings.begin(), settings.end(), [](const Json& pair) { return pair[0] == "width"; });
    if (!has_width) settings.push_back(Json::array({"height", "62%"}));
  });
}

Json for_latex(Json tree) {
  Setter setter;
  setter.set(tree["meta"]);
  setter.set(tree["blocks"]);
  if (Json& meta = tree["meta"]; meta.contains("lang")) {
    const std::string language = language_of(words_of_field(meta["lang"]));
    if (language.empty()) {
      meta.erase("lang");
    } else {
      meta["lang"] = {{"t", "MetaString"}, {"c", language}};
    }
  }
  // after words have become formulas
  const std::string lines = preamble_for(tree);
  if (!lines.empty()) {
    tree["meta"]["header-includes"] = {
        {"t", "MetaBlocks"}, {"c", Json::array({{{"t", "RawBlock"}, {"c", {"latex", lines}}}})}};
  }
  return tree;
}

std::vector<std::string> characters_without_latex(const Deck& deck) {
  std::vector<std::string> list = characters_of(deck);
  std::erase_if(list, [](const std::string& one) {
    return is_in_fonts(one) || math_of_characters().contains(one);
  });
  for (std::string& one : list)
    one = with_code_point(one);
  return list;
}

}  // namespace polhode
