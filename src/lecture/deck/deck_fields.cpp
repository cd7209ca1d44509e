// SPDX-License-Identifier: MIT
#include "lecture/deck/deck_fields.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/nearest.h"
#include "base/numbers.h"
#include "lecture/deck/line_finder.h"
#include "lecture/deck/tree.h"

namespace polhode {
namespace {

// A field as one paragraph, or as a list of them for several authors. Throws Error (input), without
// a place, for what is neither.
Json one_paragraph(const std::string& key, const Json& value, bool may_be_list) {
  const std::string type = value["t"];
  if (type == "MetaString" || type == "MetaInlines") return value;
  if (type == "MetaBlocks") {
    for_each_node(value, [&](const Json& node) {
      if (is_div(node, "notes")) throw input_error("{} has no notes for the speaker", key);
    });
    return {{"t", "MetaInlines"}, {"c", inlines_of(value["c"], {{"t", "Space"}})}};
  }
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

// Part of a text: offsets in bytes.
struct Part {
  std::size_t from = 0, to = 0;
};

// The lines of a text, with their ends.
std::vector<Part> lines_of(const std::string& text) {
  std::vector<Part> lines;
  for (std::size_t from = 0; from < text.size(); from = lines.back().to) {
    const std::size_t end = text.find('\n', from);
    lines.push_back({from, end == std::string::npos ? text.size() : end + 1});
  }
  return lines;
}

// The parts of a deck's text that may have fields: title, authors and date behind "%" at its
// beginning, and the lines between "---" and "---" or "...", without these; the first of them is
// not empty, and before them nothing stands that they could belong to.
std::vector<Part> headers_in(const std::string& text) {
  const std::vector<Part> lines = lines_of(text);
  const auto words = [&](std::size_t i) {
    if (i >= lines.size()) return std::string_view();
    std::string_view line =
        std::string_view(text).substr(lines[i].from, lines[i].to - lines[i].from);
    if (i == 0 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    return line.substr(0, line.find_last_not_of(" \t\r\n") + 1);
  };
  std::vector<Part> headers;
  for (std::size_t i = 0; i < lines.size() && words(0).starts_with('%'); ++i) {
    if (!words(i).starts_with('%') && !words(i).starts_with(' ')) break;
    headers.push_back(lines[i]);
  }
  for (std::size_t i = headers.size(); i < lines.size(); ++i) {
    const bool is_alone = i == 0 || words(i - 1).empty() || words(i - 1).starts_with('#');
    if (!is_alone || words(i) != "---" || words(i + 1).empty()) continue;
    const std::size_t first = i + 1;
    while (++i < lines.size() && words(i) != "---" && words(i) != "...") {
    }
    if (i < lines.size()) headers.push_back({lines[first].from, lines[i].from});
  }
  return headers;
}

std::string headers_of(const std::string& text) {
  std::string headers;
  for (const Part& one : headers_in(text))
    headers += text.substr(one.from, one.to - one.from);
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

// pandoc keeps the last of two. Throws Error (input), without a place.
void require_once(const std::string& key, const std::string& headers) {
  int times = 0;
  for (const Part& line : lines_of(headers)) {
    std::string_view words = std::string_view(headers).substr(line.from, line.to - line.from);
    if (!words.starts_with(key)) continue;
    words.remove_prefix(key.size());
    words.remove_prefix(std::min(words.find_first_not_of(" \t"), words.size()));
    times += words.starts_with(':') ? 1 : 0;
  }
  if (times > 1) throw input_error("{} is given twice; leave one out", key);
}

// One field; throws as the functions above.
Json read_field(const std::string& key, const Json& value, const std::string& headers) {
  static const std::vector<std::string> known = {
      "title", "subtitle", "author", "date", "lang", "description", "licence", "address"};
  if (std::find(known.begin(), known.end(), key) == known.end())
    throw input_error("a deck has no '{}'{}", key, suggestion(key, known));
  Json field = one_paragraph(key, value, key == "author");
  for_each_node(field, [](Json& node) {
    if (node["t"] == "Note") node = said_footnote(node);
  });
  refuse_rewritten(key, field, headers);
  require_once(key, headers);
  if (key == "address") require_address(words_of_field(field));
  if (key == "lang") require_language(words_of_field(field));
  return field;
}

}  // namespace

std::string without_headers(std::string text) {
  for (const Part& one : headers_in(text)) {
    for (std::size_t i = one.from; i < one.to; ++i)
      if (text[i] != '\n') text[i] = ' ';
  }
  return text;
}

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
