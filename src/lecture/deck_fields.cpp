// SPDX-License-Identifier: MIT
#include "lecture/deck_fields.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "base/nearest.h"
#include "base/numbers.h"
#include "lecture/line_finder.h"
#include "lecture/tree.h"

namespace polhode {
namespace {

// A field as one paragraph, or as a list of them for several authors. Throws Error (input), without
// a place, for what is neither.
Json one_paragraph(const std::string& key, const Json& value, bool may_be_list) {
  const std::string type = value["t"];
  if (type == "MetaString" || type == "MetaInlines") return value;
  if (type == "MetaBlocks")
    return {{"t", "MetaInlines"}, {"c", inlines_of(value["c"], {{"t", "Space"}})}};
  if (type == "MetaBool")
    throw input_error("{} is no text; in quotes, as in {}: \"yes\", it is one", key, key);
  if (type != "MetaList" || !may_be_list)
    throw input_error("{} must be a text{}", key, key == "author" ? " or a list of texts" : "");
  constexpr std::size_t kMost = 200;
  if (value["c"].size() > kMost) throw input_error("{} has more than {} texts", key, kMost);
  Json list = {{"t", "MetaList"}, {"c", Json::array()}};
  for (const Json& one : value["c"]) {
    Json text = one_paragraph(key, one, false);
    if (!words_of_field(text).empty()) list["c"].push_back(std::move(text));
  }
  return list;
}

// The parts of a deck's text that may have fields: between lines "---" and "---" or "...", and
// title, authors and date behind "%" at its beginning.
std::string headers_of(const std::string& text) {
  std::istringstream lines(text);
  std::string headers;
  bool is_inside = false, is_beginning = text.starts_with('%');
  for (std::string line; std::getline(lines, line);) {
    is_beginning = is_beginning && (line.starts_with('%') || line.starts_with(' '));
    if (is_beginning) headers += line + "\n";
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const bool is_mark = line == "---" || (is_inside && line == "...") || line == "\xEF\xBB\xBF---";
    if (is_mark) is_inside = !is_inside;
    if (is_inside && !is_mark) headers += line + "\n";
  }
  return headers;
}

// YAML writes numbers in its own way: 1.50 as 1.5, 007 as 7. Throws Error (input), without a place,
// for a field that is a number and does not stand so in the headers.
void refuse_rewritten(const std::string& key, const Json& field, const std::string& headers) {
  if (field["t"] == "MetaList") {
    for (const Json& one : field["c"])
      refuse_rewritten(key, one, headers);
    return;
  }
  const bool is_word =
      field["t"] == "MetaString" ||
      (field["t"] == "MetaInlines" && field["c"].size() == 1 && field["c"][0]["t"] == "Str");
  const std::string shown = words_of_field(field);
  if (!is_word || !parse_number(shown)) return;
  const auto is_part = [&](std::size_t at) {
    return at < headers.size() &&
           (std::isalnum(static_cast<unsigned char>(headers[at])) != 0 ||
            std::string_view("+-._").find(headers[at]) != std::string_view::npos);
  };
  for (std::size_t at = headers.find(shown); at != std::string::npos;
       at = headers.find(shown, at + 1)) {
    const bool is_alone = (at == 0 || !is_part(at - 1)) && !is_part(at + shown.size());
    if (is_alone) return;
  }
  throw input_error("{} is a number, which would be shown as {}; put it in quotes", key, shown);
}

// Throws Error (input), without a place, unless it is where a lecture may be on the web.
void require_address(const std::string& address) {
  constexpr std::size_t kLongest = 300;
  const bool good = (address.starts_with("https://") || address.starts_with("http://")) &&
                    address.size() <= kLongest &&
                    std::all_of(address.begin(), address.end(), [](char c) {
                      return c > ' ' && c < 0x7f && c != '#' && c != '?';
                    });
  if (!good) {
    throw input_error(
        "address is where the folder of the lecture will be, such as "
        "https://example.org/tops/, without # and ?, at most {} characters",
        kLongest);
  }
}

// Throws Error (input), without a place, unless it may be the tag of a language.
void require_language(const std::string& tag) {
  const bool good =
      tag.size() >= 2 && tag.size() <= 12 && std::all_of(tag.begin(), tag.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-';
      });
  if (!good) throw input_error("lang is a tag such as en or de-CH");
}

// One field; throws as the functions above.
Json read_field(const std::string& key, const Json& value, const std::string& headers) {
  static const std::vector<std::string> known = {
      "title", "subtitle", "author", "date", "lang", "description", "licence", "address"};
  if (std::find(known.begin(), known.end(), key) == known.end())
    throw input_error("a deck has no '{}'{}", key, suggestion(key, known));
  Json field = one_paragraph(key, value, key == "author");
  refuse_rewritten(key, field, headers);
  if (key == "address") require_address(words_of_field(field));
  if (key == "lang") require_language(words_of_field(field));
  return field;
}

}  // namespace

Json read_fields(const Json& meta,
                 const std::string& text,
                 const std::string& deck_file,
                 std::vector<Error>& problems) {
  LineFinder lines(text);
  const std::string headers = headers_of(text);
  Json fields = Json::object();
  for (const auto& [key, value] : meta.items()) {
    try {
      fields[key] = read_field(key, value, headers);
    } catch (const Error& error) {
      problems.push_back(error.at({deck_file, lines.next(key), {}}));
    }
  }
  return fields;
}

}  // namespace polhode
