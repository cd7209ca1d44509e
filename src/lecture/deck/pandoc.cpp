// SPDX-License-Identifier: MIT
#include "lecture/deck/pandoc.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/json.h"

namespace polhode {
namespace {

using Tree = Json;  // of pandoc

// what a deck is written in; smart quotes and citations would change what is quoted
constexpr const char* kMarkdown =
    "markdown-raw_html-raw_tex-raw_attribute-latex_macros-smart-citations-implicit_figures"
    "-markdown_in_html_blocks-native_divs-native_spans";

// many times what a lecture of a hundred pages takes
constexpr double kMostSeconds = 30.0;          // to read a deck, which may be hostile
constexpr double kMostSecondsToWrite = 300.0;  // what it could read

// pandoc tells formulas that it cannot read as "Could not convert TeX math FORMULA, rendering as
// TeX", over several lines if need be
std::vector<std::string> formulas_in(const std::string& warnings) {
  const std::string head = "Could not convert TeX math", tail = ", rendering as TeX";
  std::vector<std::string> found;
  for (std::size_t at = warnings.find(head); at != std::string::npos;
       at = warnings.find(head, at)) {
    at += head.size();
    const std::size_t end = std::min(warnings.find(tail, at), warnings.size());
    std::string formula = warnings.substr(at, end - at);
    formula.erase(0, std::min(formula.find_first_not_of(" \n'"), formula.size()));
    found.push_back(formula);
  }
  return found;
}

// What the "c" of a node holds, one letter for each entry of its list: a text (s), a list of nodes
// (l), attributes (a: name, classes, pairs), a link (k: target, title), anything (.). A "*" is a
// list of any number of nodes, and "" a text that is no list. Nodes that are not here are never
// looked into.
struct NodeShape {
  const char* type;
  const char* content;
};
constexpr NodeShape kShapes[] = {{"Str", ""},
                                 {"MetaString", ""},
                                 {"MetaInlines", "*"},
                                 {"MetaBlocks", "*"},
                                 {"MetaList", "*"},
                                 {"Para", "*"},
                                 {"Plain", "*"},
                                 {"Header", ".al"},
                                 {"Div", "al"},
                                 {"Span", "al"},
                                 {"Code", "as"},
                                 {"CodeBlock", "as"},
                                 {"RawBlock", ".s"},
                                 {"RawInline", ".s"},
                                 {"Link", "alk"},
                                 {"Image", "alk"},
                                 {"Math", ".s"},
                                 {"Table", "a....."}};

bool is_node(const Tree& value) {
  return value.is_object() && value.contains("t");
}

bool has_nodes(const Tree& list) {
  return list.is_array() && std::all_of(list.begin(), list.end(), is_node);
}

bool has_texts(const Tree& list) {
  return list.is_array() &&
         std::all_of(list.begin(), list.end(), [](const Tree& one) { return one.is_string(); });
}

bool is_pair(const Tree& value) {
  return has_texts(value) && value.size() == 2;
}

bool fits(const Tree& value, char kind) {
  switch (kind) {
    case 's':
      return value.is_string();
    case 'l':
      return has_nodes(value);
    case 'k':
      return is_pair(value);
    case 'a':
      return value.is_array() && value.size() == 3 && value[0].is_string() && has_texts(value[1]) &&
             value[2].is_array() && std::all_of(value[2].begin(), value[2].end(), is_pair);
    default:
      return true;
  }
}

bool has_shape(const Tree& content, std::string_view shape) {
  if (shape.empty()) return content.is_string();
  if (shape == "*") return has_nodes(content);
  if (!content.is_array() || content.size() != shape.size()) return false;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (!fits(content[i], shape[i])) return false;
  }
  return true;
}

// whether every node that is looked into is as pandoc writes it
bool is_tree(const Tree& value) {
  if (is_node(value)) {
    if (!value["t"].is_string()) return false;
    const std::string type = value["t"];
    for (const NodeShape& shape : kShapes) {
      if (type == shape.type && !(value.contains("c") && has_shape(value["c"], shape.content)))
        return false;
    }
  }
  return !value.is_structured() || std::all_of(value.begin(), value.end(), is_tree);
}

// Every level of a list, a quotation or emphasis is some levels of the tree. What walks over the
// tree is recursive; this is not.
void refuse_deep(const Tree& tree) {
  constexpr int kDeepest = 400;
  std::vector<std::pair<const Tree*, int>> open = {{&tree, 1}};
  while (!open.empty()) {
    const auto [node, depth] = open.back();
    open.pop_back();
    if (!node->is_structured()) continue;
    if (depth > kDeepest)
      throw input_error("the deck is nested deeper than {} levels of pandoc's tree", kDeepest);
    for (const Tree& child : *node)
      open.emplace_back(&child, depth + 1);
  }
}

// pandoc as it is installed: templates and designs that a user keeps for it would change documents
std::vector<std::string> pandoc(const std::vector<std::string>& words) {
  std::vector<std::string> command = {"pandoc", "--data-dir=/dev/null"};
  command.insert(command.end(), words.begin(), words.end());
  return command;
}

// pandoc's answer to what Polhode has written itself
ChildResult converted(const std::vector<std::string>& words, const std::string& text) {
  ChildResult ran = run_child(pandoc(words), text, {.seconds = kMostSecondsToWrite});
  if (!ran.exceeded.empty())
    throw environment_error("a document cannot be made: pandoc {}; divide the deck", ran.exceeded);
  if (!ended_well(ran)) {
    throw environment_error("a document cannot be made: pandoc {}", how_it_ended(ran));
  }
  return ran;
}

}  // namespace

ProgramFound find_pandoc() {
  return find_program("pandoc");
}

void require_pandoc() {
  require_program(
      "pandoc", "the deck cannot be read", "install it (tools/install-dependencies --for lecture)");
}

Json read_markdown(const std::string& text) {
  // aliases of YAML and brackets that nobody closes can take all memory there is
  constexpr ChildLimits kLimits{.seconds = kMostSeconds, .memory = 1U << 30U, .output = 64U << 20U};
  const ChildResult ran =
      run_child(pandoc({"--sandbox", "-f", kMarkdown, "-t", "json"}), text, kLimits);
  // what the run-time system of pandoc says when it gets no more memory
  const bool no_memory = ran.status != 0 && ran.err.find("commit") != std::string::npos;
  if (!ran.exceeded.empty() || no_memory) {
    throw input_error(
        "pandoc {} to read this deck; are brackets left open, or is its metadata a list of lists?",
        no_memory ? "needs more than 1 GiB of memory" : ran.exceeded);
  }
  if (ran.status == 0) return parse_tree(ran.out);
  // parse errors, also of YAML, and loops of macros
  constexpr int kOfTheText[] = {64, 65, 91};
  const bool of_the_text =
      std::find(std::begin(kOfTheText), std::end(kOfTheText), ran.status) != std::end(kOfTheText);
  throw Error(of_the_text ? Fault::input : Fault::environment,
              "this deck cannot be read: pandoc " + how_it_ended(ran));
}

Json parse_tree(const std::string& json) {
  // A callback of the parser could stop earlier, but takes a time that grows as the square of the
  // length of a paragraph.
  Tree tree = Tree::parse(json, nullptr, false);
  refuse_deep(tree);
  const bool whole = tree.is_object() && tree.contains("pandoc-api-version") &&
                     tree.contains("meta") && tree["meta"].is_object() &&
                     std::all_of(tree["meta"].begin(), tree["meta"].end(), is_node) &&
                     tree.contains("blocks") && tree["blocks"].is_array();
  if (!whole || !is_tree(tree["meta"]) || !is_tree(tree["blocks"])) {
    throw environment_error(
        "pandoc gave a syntax tree of an unknown kind; does `pandoc --version` say 2.17 or later?");
  }
  return tree;
}

Json read_html(const std::string& html) {
  return parse_tree(converted({"--sandbox", "-f", "html", "-t", "json"}, html).out);
}

Written write_document(const Json& tree, const std::vector<std::string>& words, bool sandbox) {
  std::vector<std::string> all = {"-f", "json"};
  if (sandbox) all.emplace_back("--sandbox");
  all.insert(all.end(), words.begin(), words.end());
  ChildResult ran = converted(all, tree.dump());
  return {std::move(ran.out), formulas_in(ran.err)};
}

}  // namespace polhode
