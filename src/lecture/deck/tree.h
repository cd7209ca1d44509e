// SPDX-License-Identifier: MIT
// Nodes of pandoc's tree: objects with a type "t" and contents "c".
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/json.h"

namespace polhode {

// Calls `visit`, which may change the node, for every node of the tree that has a type, parents
// before children.
void for_each_node(Json& tree, const std::function<void(Json&)>& visit);
void for_each_node(const Json& tree, const std::function<void(const Json&)>& visit);
// Whether one of them is what `is_it` looks for.
bool has_node(const Json& tree, const std::function<bool(const Json&)>& is_it);

// The text of inlines without formatting; formulas as TeX.
std::string plain_text(const Json& inlines);

// The text of a field of the header; "" of lists.
std::string words_of_field(const Json& value);
// A field as inlines, the texts of a list with commas between them.
Json inlines_of_field(const Json& value);

// Nodes of pandoc's tree. string_inlines() returns an array with one inline, the others return
// one block. div: a Div with the class `name`; width, such as "40%": its attribute of that name,
// if not empty.
Json string_inlines(const std::string& text);
Json raw_html(const std::string& html);
Json paragraph(const Json& inlines);
Json div(const std::string& name, const Json& blocks, const std::string& width = "");

// Where pandoc keeps identifier, classes and key-value pairs of a node; null if it has none.
Json* attributes_of(Json& node);
const Json* attributes_of(const Json& node);

// A node that links to `place` lead to: "Div" around blocks, "Span" around inlines.
Json named(const std::string& type, const std::string& place, const Json& contents);

// Whether a node of pandoc's tree is a Div with that class.
bool is_div(const Json& node, const char* name);

// Whether a block is one picture and nothing else, as a deck's own with a caption are; that is in
// the inlines of the Image, and a description for those who cannot see it in its attribute "alt".
bool is_image_alone(const Json& block);
// Whether such a block in `node` is a picture with a caption: in tables and footnotes it is none.
bool may_hold_figures(const Json& node);
std::optional<std::string> alt_of_image(const Json& image);
// Puts the description, where there is one, in the place of the caption.
void describe(Json& image);

// The items of a list with or without numbers, each an array of blocks, and the mark before one of
// them, an array of inlines: "2. " or "• ".
const Json& items_of(const Json& list);
Json mark_of(const Json& list, std::size_t item);
// Whether an item begins with words, which its mark can stand before.
bool begins_with_words(const Json& item);
// A list, one of definitions too, as blocks: its items with their marks before them.
Json blocks_of_list(const Json& list);
// A title as a paragraph of strong words, to which links lead.
Json title_as_words(const Json& header);

// Blocks as one paragraph, where a document has no room for more: the inlines of all, with
// `between` (an inline) between paragraphs, lines, items and rows; cells of tables have " | "
// between them. Rules and pictures without words are left out.
Json inlines_of(const Json& blocks, const Json& between);

// A footnote in words, in brackets, where there is no place for it.
Json said_footnote(const Json& note);

}  // namespace polhode
