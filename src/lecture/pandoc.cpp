// SPDX-License-Identifier: MIT
#include "lecture/pandoc.h"

#include "base/error.h"
#include "base/system/child_process.h"

namespace polhode {
namespace {

// what a deck is written in; smart quotes and citations would change what is quoted
constexpr const char* kMarkdown =
    "markdown-raw_html-raw_tex-raw_attribute-latex_macros-smart-citations-implicit_figures"
    "-markdown_in_html_blocks-native_divs-native_spans";

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

// Every level of a list, a quotation or emphasis is some levels of the tree. What walks over the
// tree is recursive.
nlohmann::ordered_json parsed(const std::string& text) {
  static constexpr int kDeepest = 400;
  const auto look = [](int depth, nlohmann::ordered_json::parse_event_t, nlohmann::ordered_json&) {
    if (depth > kDeepest)
      throw input_error("the deck is nested deeper than {} levels of pandoc's tree", kDeepest);
    return true;
  };
  return nlohmann::ordered_json::parse(text, look, false);
}

}  // namespace

std::string pandoc_version() {
  try {
    const ChildResult ran = run_child({"pandoc", "--version"}, "");
    return ran.status == 0 ? ran.out.substr(0, ran.out.find('\n')) : "";
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    return "";
  }
}

void require_pandoc() {
  if (pandoc_version().empty()) {
    throw environment_error(
        "pandoc, which reads decks, is not installed; install it (tools/install-dependencies --for "
        "lecture)");
  }
}

nlohmann::ordered_json read_markdown(const std::string& text) {
  // many times what a lecture of a hundred pages takes; aliases of YAML and brackets that nobody
  // closes can take all there is
  constexpr ChildLimits kLimits{.seconds = 30.0, .memory = 1U << 30U, .output = 64U << 20U};
  const ChildResult ran =
      run_child({"pandoc", "--sandbox", "-f", kMarkdown, "-t", "json"}, text, kLimits);
  // what the run-time system of pandoc says when it gets no more memory
  const bool no_memory = ran.status != 0 && ran.err.find("commit") != std::string::npos;
  if (!ran.exceeded.empty() || no_memory) {
    throw input_error(
        "pandoc {} to read this deck; are brackets left open, or is its metadata a list of lists?",
        no_memory ? "needs more than 1 GiB of memory" : ran.exceeded);
  }
  nlohmann::ordered_json tree = parsed(ran.out);
  if (ran.status == 0 && tree.is_object() && tree.contains("blocks")) return tree;
  const std::string words = ran.err.substr(0, ran.err.find('\n'));
  throw input_error("pandoc cannot read this deck: {}", words.empty() ? "no reason given" : words);
}

Written write_document(const nlohmann::ordered_json& tree,
                       const std::vector<std::string>& words,
                       bool sandbox) {
  std::vector<std::string> command = {"pandoc", "-f", "json"};
  if (sandbox) command.emplace_back("--sandbox");
  command.insert(command.end(), words.begin(), words.end());
  ChildResult ran = run_child(command, tree.dump());
  if (ran.status != 0) {
    throw environment_error(
        "pandoc failed: {}",
        ran.exceeded.empty() ? ran.err.substr(0, ran.err.find('\n')) : "it " + ran.exceeded);
  }
  return {std::move(ran.out), formulas_in(ran.err)};
}

}  // namespace polhode
