// SPDX-License-Identifier: MIT
#include "lecture/deck/tree.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace polhode {
namespace {

template <class Node, class Visit>
void walk(Node& tree, const Visit& visit) {
  if (tree.is_object() && tree.contains("t")) {
    visit(tree);
    if (tree.contains("c")) walk(tree["c"], visit);
    return;
  }
  if (!tree.is_array() && !tree.is_object()) return;
  for (Node& child : tree)
    walk(child, visit);
}

// "xiv"; digits where Romans had no letters
std::string roman(std::size_t number) {
  constexpr std::pair<std::size_t, const char*> kLetters[] = {{1000, "m"},
                                                              {900, "cm"},
                                                              {500, "d"},
                                                              {400, "cd"},
                                                              {100, "c"},
                                                              {90, "xc"},
                                                              {50, "l"},
                                                              {40, "xl"},
                                                              {10, "x"},
                                                              {9, "ix"},
                                                              {5, "v"},
                                                              {4, "iv"},
                                                              {1, "i"}};
  if (number == 0 || number > 3999) return std::to_string(number);
  std::string out;
  for (const auto& [value, letters] : kLetters) {
    for (; number >= value; number -= value)
      out += letters;
  }
  return out;
}

// "a" to "z", then "aa"
std::string in_letters(std::size_t number) {
  if (number == 0) return "0";
  std::string out;
  for (; number > 0; number = (number - 1) / 26)
    out.insert(out.begin(), static_cast<char>('a' + (number - 1) % 26));
  return out;
}

// style: pandoc's name, such as "LowerRoman"
std::string number_in_style(std::size_t number, const std::string& style) {
  std::string out = style.ends_with("Roman")   ? roman(number)
                    : style.ends_with("Alpha") ? in_letters(number)
                                               : std::to_string(number);
  if (style.starts_with("Upper")) {
    for (char& c : out)
      c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return out;
}

template <class Node>
Node* find_attributes(Node& node) {
  static const std::set<std::string> first = {
      "Div", "Span", "Code", "CodeBlock", "Link", "Image", "Table"};
  const std::string type = node["t"];
  if (type == "Header") return &node["c"][1];
  return first.contains(type) ? &node["c"][0] : nullptr;
}

class Collector {
 public:
  explicit Collector(const Json& between) : between_(between) {}

  void add_blocks(const Json& blocks) {
    for (const Json& block : blocks)
      add(block);
  }
  Json all = Json::array();

 private:
  void add_line(const Json& inlines) {
    if (inlines.empty()) return;
    if (!all.empty()) all.push_back(between_);
    all.insert(all.end(), inlines.begin(), inlines.end());
  }

  void add(const Json& block) {
    const std::string type = block["t"];
    if (type == "Para" || type == "Plain") {
      add_line(block["c"]);
    } else if (type == "Header") {
      add_line(block["c"][2]);
    } else if (type == "LineBlock") {
      for (const Json& line : block["c"])
        add_line(line);
    } else if (type == "CodeBlock") {
      add_code(block["c"][1]);
    } else if (type == "BlockQuote") {
      add_blocks(block["c"]);
    } else if (type == "Div") {
      add_blocks(block["c"][1]);
    } else if (type == "BulletList" || type == "OrderedList") {
      add_list(block);
    } else if (type == "DefinitionList") {
      for (const Json& item : block["c"]) {
        add_line(item[0]);
        for (const Json& definition : item[1])
          add_blocks(definition);
      }
    } else if (type == "Table") {
      add_table(block["c"]);
    }
  }

  void add_code(const std::string& code) {
    const Json none = Json::array({"", Json::array(), Json::array()});
    for (std::size_t from = 0; from <= code.size();) {
      const std::size_t end = std::min(code.find('\n', from), code.size());
      const std::string line = code.substr(from, end - from);
      add_line(Json::array({{{"t", "Code"}, {"c", {none, line}}}}));
      from = end + 1;
    }
  }

  void add_list(const Json& list) {
    const Json& items = items_of(list);
    for (std::size_t i = 0; i < items.size(); ++i) {
      Json line = mark_of(list, i);
      const Json words = inlines_of(items[i], between_);
      line.insert(line.end(), words.begin(), words.end());
      add_line(line);
    }
  }

  // attributes, caption, columns, head, bodies, foot
  void add_table(const Json& table) {
    add_blocks(table[1][1]);
    add_rows(table[3][1]);
    for (const Json& body : table[4]) {
      add_rows(body[2]);
      add_rows(body[3]);
    }
    add_rows(table[5][1]);
  }

  void add_rows(const Json& rows) {
    for (const Json& row : rows) {
      Json line = Json::array();
      for (const Json& cell : row[1]) {
        if (!line.empty()) {
          const Json bar = string_inlines(" | ");
          line.insert(line.end(), bar.begin(), bar.end());
        }
        const Json words = inlines_of(cell[4], between_);
        line.insert(line.end(), words.begin(), words.end());
      }
      add_line(line);
    }
  }

  const Json& between_;
};

}  // namespace

void for_each_node(Json& tree, const std::function<void(Json&)>& visit) {
  walk(tree, visit);
}

void for_each_node(const Json& tree, const std::function<void(const Json&)>& visit) {
  walk(tree, visit);
}

bool has_node(const Json& tree, const std::function<bool(const Json&)>& is_it) {
  bool found = false;
  for_each_node(tree, [&](const Json& node) { found = found || is_it(node); });
  return found;
}

std::string plain_text(const Json& inlines) {
  std::string text;
  for_each_node(inlines, [&](const Json& node) {
    const std::string type = node["t"];
    if (type == "Str") text += node["c"].get<std::string>();
    if (type == "Space" || type == "SoftBreak" || type == "LineBreak") text += ' ';
    if (type == "Math" || type == "Code") text += node["c"][1].get<std::string>();
  });
  return text;
}

std::string words_of_field(const Json& value) {
  if (value["t"] == "MetaInlines") return plain_text(value["c"]);
  return value["t"] == "MetaString" ? value["c"].get<std::string>() : "";
}

Json inlines_of_field(const Json& value) {
  const std::string type = value["t"];
  if (type == "MetaInlines") return value["c"];
  if (type == "MetaString") return string_inlines(value["c"]);
  Json all = Json::array();
  if (type != "MetaList") return all;
  for (const Json& one : value["c"]) {
    if (!all.empty()) all.push_back(string_inlines(", ")[0]);
    const Json inlines = inlines_of_field(one);
    all.insert(all.end(), inlines.begin(), inlines.end());
  }
  return all;
}

Json string_inlines(const std::string& text) {
  return Json::array({{{"t", "Str"}, {"c", text}}});
}

Json raw_html(const std::string& html) {
  return {{"t", "RawBlock"}, {"c", {"html", html}}};
}

Json paragraph(const Json& inlines) {
  return {{"t", "Para"}, {"c", inlines}};
}

Json div(const std::string& name, const Json& blocks, const std::string& width) {
  Json settings = Json::array();
  if (!width.empty()) settings.push_back(Json::array({"width", width}));
  return {{"t", "Div"}, {"c", {{"", Json::array({name}), settings}, blocks}}};
}

Json* attributes_of(Json& node) {
  return find_attributes(node);
}

const Json* attributes_of(const Json& node) {
  return find_attributes(node);
}

Json named(const std::string& type, const std::string& place, const Json& contents) {
  return {{"t", type}, {"c", {Json::array({place, Json::array(), Json::array()}), contents}}};
}

bool is_image_alone(const Json& block) {
  return (block["t"] == "Para" || block["t"] == "Plain") && block["c"].size() == 1 &&
         block["c"][0]["t"] == "Image";
}

bool may_hold_figures(const Json& node) {
  return node["t"] != "Table" && node["t"] != "Note";
}

std::optional<std::string> alt_of_image(const Json& image) {
  for (const Json& pair : image["c"][0][2])
    if (pair[0] == "alt") return pair[1].get<std::string>();
  return std::nullopt;
}

void describe(Json& image) {
  const std::optional<std::string> alt = alt_of_image(image);
  if (!alt) return;
  image["c"][1] = alt->empty() ? Json::array() : string_inlines(*alt);
  std::erase_if(image["c"][0][2].get_ref<Json::array_t&>(),
                [](const Json& pair) { return pair[0] == "alt"; });
}

bool is_div(const Json& node, const char* name) {
  if (node["t"] != "Div") return false;
  const Json& names = node["c"][0][1];
  return std::find(names.begin(), names.end(), name) != names.end();
}

const Json& items_of(const Json& list) {
  return list["t"] == "OrderedList" ? list["c"][1] : list["c"];
}

Json mark_of(const Json& list, std::size_t item) {
  std::string mark = "•";
  if (list["t"] == "OrderedList") {
    // where its numbers begin, how they are written, and what is around them
    const Json& numbering = list["c"][0];
    const std::string around = numbering[2]["t"];
    mark = number_in_style(numbering[0].get<std::size_t>() + item, numbering[1]["t"]) +
           (around.find("Paren") != std::string::npos ? ")" : ".");
    if (around == "TwoParens") mark.insert(0, "(");
  }
  Json words = string_inlines(mark);
  words.push_back({{"t", "Space"}});
  return words;
}

bool begins_with_words(const Json& item) {
  return !item.empty() && (item[0]["t"] == "Plain" || item[0]["t"] == "Para");
}

Json blocks_of_list(const Json& list) {
  Json blocks = Json::array();
  const auto add = [&](const Json& all) {
    blocks.insert(blocks.end(), all.begin(), all.end());
  };
  if (list["t"] == "DefinitionList") {
    for (const Json& item : list["c"]) {
      blocks.push_back(paragraph(item[0]));
      for (const Json& definition : item[1])
        add(definition);
    }
    return blocks;
  }
  const Json& items = items_of(list);
  for (std::size_t i = 0; i < items.size(); ++i) {
    Json item = items[i], words = mark_of(list, i);
    if (begins_with_words(item)) {
      words.insert(words.end(), item[0]["c"].begin(), item[0]["c"].end());
      item[0] = paragraph(words);
    } else {
      item.insert(item.begin(), paragraph(words));
    }
    add(item);
  }
  return blocks;
}

Json title_as_words(const Json& header) {
  const Json strong = {{"t", "Strong"}, {"c", header["c"][2]}};
  return paragraph(Json::array({named("Span", header["c"][1][0], Json::array({strong}))}));
}

Json inlines_of(const Json& blocks, const Json& between) {
  Collector collector(between);
  collector.add_blocks(blocks);
  return std::move(collector.all);
}

Json said_footnote(const Json& note) {
  Json words = string_inlines(" (");
  const Json inlines = inlines_of(note["c"], {{"t", "Space"}});
  words.insert(words.end(), inlines.begin(), inlines.end());
  words.push_back(string_inlines(")")[0]);
  return named("Span", "", words);
}

}  // namespace polhode
