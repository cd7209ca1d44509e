// SPDX-License-Identifier: MIT
#include "lecture/deck/quotes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/nearest.h"
#include "base/units.h"
#include "lecture/deck/formulas.h"
#include "lecture/deck/line_finder.h"

namespace polhode {
namespace {

constexpr const char* kHead = "{inspect:";

// How the end of a key tells its unit, and how a reader sees it.
struct KeyUnit {
  const char* suffix;
  const char* text;
};
constexpr std::array<KeyUnit, 10> kUnits = {{{"_kg_m2_per_s", "kg m²/s"},
                                             {"_kg_m2", "kg m²"},
                                             {"_rad_per_s", "rad/s"},
                                             {"_per_s", "1/s"},
                                             {"_rad", "rad"},
                                             {"_kg", "kg"},
                                             {"_m2", "m²"},
                                             {"_J", "J"},
                                             {"_s", "s"},
                                             {"_m", "m"}}};

// other units, and what a number of the key's unit is multiplied by
struct OtherUnit {
  const char* own;
  const char* name;  // in the quote
  const char* text;
  double factor;
};
constexpr std::array<OtherUnit, 17> kOtherUnits = {{{"rad", "deg", "°", 180.0 / kPi},
                                                    {"rad/s", "deg_per_s", "°/s", 180.0 / kPi},
                                                    {"rad/s", "rpm", "rpm", 30.0 / kPi},
                                                    {"rad/s", "hz", "Hz", 0.5 / kPi},
                                                    {"s", "ms", "ms", 1e3},
                                                    {"s", "us", "µs", 1e6},
                                                    {"s", "min", "min", 1.0 / 60.0},
                                                    {"s", "h", "h", 1.0 / 3600.0},
                                                    {"s", "d", "d", 1.0 / 86400.0},
                                                    {"m", "cm", "cm", 1e2},
                                                    {"m", "mm", "mm", 1e3},
                                                    {"kg", "g", "g", 1e3},
                                                    {"kg m²", "g_cm2", "g cm²", 1e7},
                                                    {"kg m²", "kg_cm2", "kg cm²", 1e4},
                                                    {"J", "mJ", "mJ", 1e3},
                                                    {"J", "kJ", "kJ", 1e-3},
                                                    {"1/s", "per_min", "1/min", 60.0}}};

// all paths into the answer, with its lists by number; for finding and for suggestions
void collect(const Json& value, const std::string& path, std::vector<std::string>& paths) {
  if (!path.empty()) paths.push_back(path);
  if (value.is_object()) {
    for (const auto& [key, inside] : value.items())
      collect(inside, path.empty() ? key : fmt::format("{}.{}", path, key), paths);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      collect(value[i], fmt::format("{}.{}", path, i), paths);
  }
}

// "principal_moments_kg_m2.0" has the unit of its list
std::string without_numbers(std::string path) {
  while (path.size() > 2 && path[path.size() - 2] == '.' &&
         std::isdigit(static_cast<unsigned char>(path.back())) != 0) {
    path.resize(path.size() - 2);
  }
  return path;
}

// does a full path say the same as the short one: without "derived.", without the unit
bool means(const std::string& full, const std::string& asked) {
  constexpr std::string_view kPrefix = "derived.";
  const bool is_derived = full.starts_with(kPrefix);
  const std::string path = is_derived ? full.substr(kPrefix.size()) : full;
  const std::string short_path =
      is_derived && asked.starts_with(kPrefix) ? asked.substr(kPrefix.size()) : asked;
  if (path == short_path) return true;
  const std::string head = without_numbers(path), numbers = path.substr(head.size());
  return split_unit(head).first + numbers == short_path;
}

const char* superscript(char c) {
  constexpr std::array<const char*, 10> kDigits = {
      "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return c == '-' ? "⁻" : kDigits[static_cast<std::size_t>(c - '0')];
}

// "-1.5e-07" as a reader writes it
Quoted number(double value, const std::string& format) {
  const char kind = format.back();
  const std::size_t dot = format.find('.');
  const int digits = dot == std::string::npos ? 6 : std::stoi(format.substr(dot + 1));
  std::string text = kind == 'f'   ? fmt::format("{:.{}f}", value, digits)
                     : kind == 'e' ? fmt::format("{:.{}e}", value, digits)
                                   : fmt::format("{:.{}g}", value, digits);
  std::string minus;
  if (text.front() == '-') {
    minus = "−";
    text.erase(0, 1);
  }
  const std::string sign = minus.empty() ? "" : "-";
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return {minus + text, sign + text};
  const std::string mantissa = text.substr(0, e),
                    power = std::to_string(std::stoi(text.substr(e + 1)));
  std::string raised;
  for (const char c : power)
    raised += superscript(c);
  return {fmt::format("{}{} × 10{}", minus, mantissa, raised),
          fmt::format("{}{}\\times 10^{{{}}}", sign, mantissa, power)};
}

std::string tex_unit(const std::string& unit) {
  // a power of ten has its own raised number
  return unit == "°" ? "{}^\\circ" : fmt::format("\\;\\text{{{}}}", unit);
}

// `key`: what is quoted, for messages
Quoted value_text(const std::string& key,
                  const Json& value,
                  double factor,
                  const std::string& format) {
  if (value.is_boolean()) {
    const std::string word = value.get<bool>() ? "yes" : "no";
    return {word, "\\text{" + word + "}"};
  }
  if (value.is_number()) return number(value.get<double>() * factor, format);
  if (value.is_string()) {
    std::string words;
    for (const char c : value.get<std::string>()) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '_' || c == '-')
        words += c == '_' ? ' ' : c;
    }
    return {value.get<std::string>(), "\\text{" + words + "}"};
  }
  if (!value.is_array() || value.empty())
    throw input_error("'{}' has no number here to be quoted", key);
  Quoted list;
  for (const Json& entry : value) {
    const Quoted one = value_text(key, entry, factor, format);
    list.text += list.text.empty() ? one.text : ", " + one.text;
    list.tex += list.tex.empty() ? one.tex : ",\\;" + one.tex;
  }
  return {"(" + list.text + ")", "(" + list.tex + ")"};
}

// Replaces all quotes of a text by what `answer` says of one and its place. One that does not end
// in this text, because something in it is no text for pandoc, is given as far as it goes.
std::string replaced(
    const std::string& text,
    const std::function<std::string(const std::string& words, std::size_t at)>& answer) {
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = text.find(kHead); at != std::string::npos; at = text.find(kHead, from)) {
    const std::size_t end = std::min(text.find('}', at), text.size() - 1) + 1;
    out += text.substr(from, at - from) + answer(text.substr(at, end - at), at);
    from = end;
  }
  return out + text.substr(from);
}

// words_in() of a formula, whose quotes are letters
std::vector<bool> words_around_quotes(const std::string& formula) {
  return words_in(replaced(formula, [](const std::string& words, std::size_t) {
    const bool is_whole = words.ends_with('}');
    return "{" + std::string(words.size() - (is_whole ? 2 : 1), 'a') + (is_whole ? "}" : "");
  }));
}

// Calls `work` on every text that may hold quotes, with whether it is a formula.
void for_each_text(Deck& deck, const std::function<void(Json& text, bool formula)>& work) {
  const auto visit = [&](Json& node) {
    if (node["t"] == "Str") work(node["c"], false);
    if (node["t"] == "Math") work(node["c"][1], true);
    if (node["t"] != "Image") return;
    for (Json& pair : node["c"][0][2])
      if (pair[0] == "alt") work(pair[1], false);
  };
  for_each_node(deck.meta, visit);
  for_each_node(deck.blocks, visit);
  for (DeckPicture& picture : deck.pictures) {
    for_each_node(picture.caption, visit);
    const auto alt = picture.settings.find("alt");
    if (alt == picture.settings.end()) continue;
    Json words = alt->second;
    work(words, false);
    alt->second = words.get<std::string>();
  }
}

}  // namespace

std::pair<std::string, std::string> split_unit(const std::string& key) {
  for (const KeyUnit& unit : kUnits) {
    const std::string_view suffix = unit.suffix;
    if (key.size() > suffix.size() && key.ends_with(suffix)) {
      return {key.substr(0, key.size() - suffix.size()), unit.text};
    }
  }
  return {key, ""};
}

Quote parse_quote(const std::string& words) {
  std::string inside = words.substr(std::string_view(kHead).size(),
                                    words.size() - std::string_view(kHead).size() - 1);
  // formulas in tables keep the stroke before a bar
  const std::size_t stroke = inside.find("\\|");
  if (stroke != std::string::npos) inside.erase(stroke, 1);
  std::size_t hash = inside.rfind('#', inside.rfind('|'));  // a format may have one by mistake
  if (hash == std::string::npos) hash = inside.rfind('#');
  if (hash == std::string::npos || hash == 0)
    throw input_error("'{}' does not name a number; write {{inspect:scene.toml#key}}", words);
  Quote quote;
  quote.scene = inside.substr(0, hash);
  quote.key = inside.substr(hash + 1);
  const std::size_t bar = quote.key.find('|');
  if (bar != std::string::npos) {
    const std::string how = quote.key.substr(bar + 1);
    quote.key.resize(bar);
    const std::size_t comma = how.find(',');
    if (comma != std::string::npos) quote.unit = how.substr(comma + 1);
    if (comma != 0) quote.format = how.substr(0, comma);
  }
  const std::string& f = quote.format;
  const bool good =
      f.empty() ||
      (f.size() >= 2 && f.size() <= 5 && f[0] == '%' &&
       std::string_view("efg").find(f.back()) != std::string_view::npos &&
       (f.size() == 2 ||
        (f[1] == '.' && f.size() > 3 &&
         std::all_of(f.begin() + 2, f.end() - 1, [](char c) { return c >= '0' && c <= '9'; }))));
  if (!good) throw input_error("'{}' is not a number format; write %.3g, %.2f or %.1e", f);
  if (quote.key.empty()) throw input_error("'{}' does not name a number", words);
  return quote;
}

Quoted quoted(const Json& inspection, const Quote& quote) {
  std::vector<std::string> paths;
  collect(inspection, "", paths);
  const auto found = std::find_if(
      paths.begin(), paths.end(), [&](const std::string& path) { return means(path, quote.key); });
  if (found == paths.end()) {
    // as a deck would write them
    for (std::string& path : paths)
      path = split_unit(path.starts_with("derived.") ? path.substr(8) : path).first;
    const std::string nearest = nearest_name(quote.key, paths);
    throw input_error("{} has no '{}'{}",
                      quote.scene,
                      quote.key,
                      nearest.empty()
                          ? fmt::format("; `polhode inspect {} --json` has all keys", quote.scene)
                          : fmt::format(" (did you mean '{}'?)", nearest));
  }
  std::string pointer = "/" + *found;
  std::replace(pointer.begin(), pointer.end(), '.', '/');
  const Json& value = inspection.at(Json::json_pointer(pointer));
  std::string unit = split_unit(without_numbers(*found)).second;
  double factor = 1.0;
  if (quote.unit == "none") {
    unit.clear();
  } else if (!quote.unit.empty()) {
    std::vector<std::string> names = {"none"};
    const OtherUnit* other = nullptr;
    for (const OtherUnit& row : kOtherUnits) {
      if (row.own != unit) continue;
      names.emplace_back(row.name);
      if (row.name == quote.unit) other = &row;
    }
    if (other == nullptr) {
      throw input_error("'{}' cannot be converted to '{}'{}",
                        quote.key,
                        quote.unit,
                        suggestion(quote.unit, names));
    }
    unit = other->text;
    factor = other->factor;
  }
  const bool word = value.is_string() || value.is_boolean();
  if (word && !quote.format.empty())
    throw input_error("'{}' is no number; leave out '|{}'", quote.key, quote.format);
  Quoted out = value_text(quote.key, value, factor, quote.format.empty() ? "%.4g" : quote.format);
  if (unit.empty()) return out;
  // a degree stands by its number, but not by the raised one of a power
  const bool joined = unit.starts_with("°") && out.text.find("× 10") == std::string::npos;
  out.text += (joined ? "" : "\u00A0") + unit;
  out.tex += tex_unit(unit);
  return out;
}

void fill_quotes(Deck& deck,
                 const std::string& deck_text,
                 const std::function<const Json&(const std::string& scene)>& inspect) {
  LineFinder lines(deck_text, deck.blocks);
  for_each_text(deck, [&](Json& text, bool formula) {
    const std::string written = text;
    const std::vector<bool> is_word = formula ? words_around_quotes(written) : std::vector<bool>();
    // among words a number is a formula of its own; its braces may be those around the words
    const auto in_place = [&](const std::string& tex, const std::string& words, std::size_t at) {
      const std::string_view all = written;
      const bool among_words = is_word[at + 1];
      std::string part =
          part_of_formula(tex, all.substr(0, at), all.substr(at + words.size()), among_words);
      if (!among_words) return part;
      return is_word[at] ? "$" + part + "$" : "{$" + part + "$}";
    };
    text = replaced(written, [&](const std::string& words, std::size_t at) -> std::string {
      const bool is_whole = words.ends_with('}');
      int line = lines.next(is_whole ? words : words + " ");
      if (line == 0) line = lines.next(words);
      try {
        if (!is_whole) {
          throw input_error(
              "'{}' does not end in }}, or has a space or markup in it, which a quote cannot have; "
              "in a table write \\| for |",
              words);
        }
        const Quote quote = parse_quote(words);
        const Quoted value = quoted(inspect(quote.scene), quote);
        return formula ? in_place(value.tex, words, at) : value.text;
      } catch (const Error& error) {
        if (error.fault() == Fault::interrupted) throw;
        deck.problems.push_back(error.fault() == Fault::input
                                    ? input_error("{}", error.what()).at({deck.file, line, {}})
                                    : error.at({deck.file, line, {}}));
        return formula ? in_place("\\text{[?]}", words, at) : "[?]";
      }
    });
    if (formula && text != written) deck.with_numbers[text] = written;
  });
}

std::set<std::string> quoted_scenes(const Deck& deck) {
  std::set<std::string> scenes;
  Deck copy = deck;
  for_each_text(copy, [&](const Json& text, bool) {
    replaced(text.get<std::string>(), [&](const std::string& words, std::size_t) {
      const std::size_t start = std::string_view(kHead).size(), hash = words.rfind('#');
      if (hash != std::string::npos && hash > start && words.ends_with('}'))
        scenes.insert(words.substr(start, hash - start));
      return std::string();
    });
  });
  return scenes;
}

}  // namespace polhode
