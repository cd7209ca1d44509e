// SPDX-License-Identifier: MIT
// Runs pandoc, which reads the deck and writes the documents. Nothing in a deck reaches it
// as more than text: raw HTML, raw TeX and macros are off, and it runs in its sandbox.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace polhode {

// "pandoc 2.17.1.1"; empty when there is none.
std::string pandoc_version();

// Throws Error (environment) that says what to install when there is none.
void require_pandoc();

// The syntax tree of Markdown text. Throws Error (input) for what pandoc cannot read, (environment)
// when it is missing.
nlohmann::ordered_json read_markdown(const std::string& text);

struct Written {
  std::string text;                       // or bytes
  std::vector<std::string> bad_formulas;  // that pandoc could not read
};

// A document from a syntax tree; `words` are further options. A format that needs files (pictures)
// is written without the sandbox: the tree must name only files of our own. Throws Error
// (environment).
Written write_document(const nlohmann::ordered_json& tree,
                       const std::vector<std::string>& words,
                       bool sandbox = true);

}  // namespace polhode
