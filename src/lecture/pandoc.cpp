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
  const ChildResult ran = run_child({"pandoc", "--sandbox", "-f", kMarkdown, "-t", "json"}, text);
  nlohmann::ordered_json tree = nlohmann::ordered_json::parse(ran.out, nullptr, false);
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
    throw environment_error("pandoc failed: {}", ran.err.substr(0, ran.err.find('\n')));
  }
  return {std::move(ran.out), formulas_in(ran.err)};
}

}  // namespace polhode
