// SPDX-License-Identifier: MIT
// Runs pandoc, which reads the deck and writes the documents. Decks are untrusted: raw HTML,
// raw TeX and macros are disabled, and pandoc runs with --sandbox unless write_document() is
// told otherwise. All functions throw Error (interrupted) as run_child
// (base/system/child_process.h) does.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "base/system/child_process.h"

namespace polhode {

// The pandoc of this machine, with a version such as "pandoc 2.17.1.1".
ProgramFound find_pandoc();

// Throws Error (environment), with the reason and what to install, if pandoc does not run.
void require_pandoc();

// The syntax tree of a text in pandoc's Markdown (without raw HTML, raw TeX, macros, smart quotes
// and citations), as pandoc's JSON: "pandoc-api-version", "meta", "blocks". Throws Error (input),
// without a place, if pandoc cannot read it; (environment) if pandoc is missing or fails otherwise.
Json read_markdown(const std::string& text);

// Such a tree from the text of its JSON. Throws Error without a place: (input) if it is nested too
// deeply, (environment) if it is not JSON or lacks what the nodes that decks are made of have in
// pandoc's syntax tree. Nodes of unknown types may contain anything.
Json parse_tree(const std::string& json);

// The syntax tree of HTML that pandoc has written. Throws Error (environment) if pandoc is missing
// or fails, and as parse_tree() does.
Json read_html(const std::string& html);

// A document written by pandoc.
struct Written {
  std::string text;                       // pandoc's output; empty if `words` name a file (-o)
  std::vector<std::string> bad_formulas;  // formulas that pandoc could not convert
};

// Writes a document from a syntax tree. `words` are further options of pandoc, with the format of
// the document among them ("-t", "html5"). With `sandbox`, pandoc reads no files. Formats that
// embed pictures and options that name files need sandbox = false; the tree must then name only
// files made by Polhode. Throws Error (environment) if pandoc is missing or fails.
Written write_document(const Json& tree,
                       const std::vector<std::string>& words,
                       bool sandbox = true);

}  // namespace polhode
