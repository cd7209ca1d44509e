// SPDX-License-Identifier: MIT
// The fields of a deck's header.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "base/json.h"

namespace polhode {

// The fields that may stay (title, subtitle, author, date, lang, description, licence, address), as
// nodes of pandoc's metadata: each a single paragraph, the authors also a list of them. meta:
// pandoc's metadata of the deck `text`, whose file is named for messages. What is left out goes to
// `problems`, with its line.
Json read_fields(const Json& meta,
                 const std::string& text,
                 const std::string& deck_file,
                 std::vector<Error>& problems);

// The text of a deck with blanks in place of its headers, in YAML or behind "%".
std::string without_headers(std::string text);

}  // namespace polhode
