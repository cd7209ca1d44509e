// SPDX-License-Identifier: MIT
#include "lecture/deck/quantities.h"

#include <algorithm>
#include <iterator>
#include <regex>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "base/name_list.h"

namespace polhode {
namespace {

constexpr const char* kPrefixes =
    "yocto|zepto|atto|femto|pico|nano|micro|milli|centi|deci|hecto|kilo|mega|giga|tera|peta|exa"
    "|zetta|yotta";

void refuse_misread_units(const std::string& tex) {
  static const std::regex power(
      fmt::format(R"(\\(square|cubic)\s{{0,9}}\\({})(?![A-Za-z]))", kPrefixes));
  static const std::regex ten(R"(\\de[ck]a(?![A-Za-z]))");
  // units whose sign is that of a prefix
  static const std::regex metre(
      R"((^|[^a-z\s]|\\(?!square|cubic)[a-z]{1,20})\s{0,9}(\\(metre|meter|m|tesla|T|hour|day)))"
      R"(\s{0,9}\\(?!per|squared|cubed|tothe|raiseto|of|cancel)[A-Za-z]{1,20})");
  static const std::regex others(
      R"(\\(decibel|clight|electronmass|bohr|hartree|(num|SI|qty)(list|product))(?![A-Za-z]))");
  static const std::regex options(R"(\\(num|SI|qty|si|unit)\s{0,9}\[\s{0,9}[^\]\s])");
  static const std::regex complex(R"(\\(num|SI|qty)\{[^{}]{0,99}i\})");
  std::smatch found;
  if (std::regex_search(tex, found, power)) {
    throw input_error("'{}' is read as a power of the prefix alone; put \\{} behind the unit",
                      found.str(),
                      found.str(1) == "square" ? "squared" : "cubed");
  }
  if (std::regex_search(tex, found, ten))
    throw input_error("'{}' is read as a tenth; write the number without it", found.str());
  if (std::regex_search(tex, found, metre)) {
    const std::string unit = found.str(2), units = found.str().substr(found.str(1).size());
    throw input_error("'{}' would be shown as a prefix; put {} last", units, unit);
  }
  if (std::regex_search(tex, found, others))
    throw input_error("'{}' would be shown otherwise; write its sign or its list out", found.str());
  if (std::regex_search(tex, found, options)) {
    throw input_error("options of \\{} are not read; write the number as it is to be shown",
                      found.str(1));
  }
  if (std::regex_search(tex, found, complex)) {
    throw input_error(
        "'{}' is no number that can be read; write it without \\{}", found.str(), found.str(1));
  }
}

// \si of each unit, with its prefix and powers and what it is divided by: pandoc would put the
// signs of units side by side, where N m s would be taken for newtons times milliseconds. Throws
// Error (input), without a place, for units behind a fraction: \per is of the next unit alone, but
// they would look divided too, as in W/m²K.
std::string units_apart(const std::string& units) {
  static const std::regex command(R"(\\([A-Za-z]+)\s*)");
  static const std::regex before(
      fmt::format("{}|square|cubic|raiseto|cancel|highlight", kPrefixes));
  static const std::regex behind("squared|cubed|tothe|of");
  std::string out, one;
  bool has_unit = false, is_fraction = false;  // `one`
  bool is_divided = false;                     // the next unit
  for (std::sregex_iterator word(units.begin(), units.end(), command), end; word != end; ++word) {
    const std::string name = word->str(1);
    const bool is_before = std::regex_match(name, before);
    const bool is_unit = !is_before && name != "per" && !std::regex_match(name, behind);
    if (is_unit && is_fraction && !is_divided)
      throw input_error("'\\{}' behind \\per would look divided too; put it before \\per", name);
    if ((is_unit || is_before) && has_unit && !is_divided) {
      out += fmt::format("\\si{{{}}}\\,", one);
      one.clear();
      has_unit = false;
    }
    one += word->str();
    is_fraction = is_fraction || (is_unit && is_divided);
    has_unit = has_unit || is_unit;
    is_divided = name == "per" || (is_divided && !is_unit);
  }
  return out + fmt::format("\\si{{{}}}", one);
}

// Units that are letters, which siunitx sets upright and whose dots it takes for products: kg.m^2
// is \mathrm{kg}\,\mathrm{m}^2. Blanks stand apart too, so that nobody reads m s as ms. Empty: they
// are not of that kind. Throws Error (input), without a place, for commands of siunitx among them
// that would be of other letters than in TeX.
std::string letters_upright(const std::string& units) {
  static const std::regex hidden(R"(\\[A-Za-z]+|\{[^{}]*\})");
  static const std::regex letter(R"([A-Za-z]|[^\x01-\x7f])");
  static const std::regex part(
      R"(((?:[A-Za-z]|[^\x01-\x7f])+)|(\s*[.~]\s*|\s+)|\\([A-Za-z]+)(\{[^{}]*\}|\s*))"
      R"(|[\^_]\s*(\{[^{}]*\}|\\[A-Za-z]+|[0-9A-Za-z])|[-+/()0-9]|\\[^A-Za-z]|\{[^{}]*\})");
  static const std::regex of_mathematics("math[a-z]+|text[a-z]*|cdot|times|circ");
  static const std::regex of_others(
      fmt::format("{}|square|cubic|per|squared|cubed|tothe|raiseto|of", kPrefixes));
  if (!std::regex_search(std::regex_replace(units, hidden, ""), letter)) return "";
  const std::string whole(trimmed(units));
  std::string out;
  std::size_t seen = 0;
  for (std::sregex_iterator it(whole.begin(), whole.end(), part), end; it != end; ++it) {
    const std::smatch& found = *it;
    if (static_cast<std::size_t>(found.position(0)) != seen) return "";
    seen += static_cast<std::size_t>(found.length(0));
    const std::string command = found.str(3);
    if (std::regex_match(command, of_others)) {
      throw input_error("'\\{}' is not read among letters; write units as letters or as commands",
                        command);
    }
    if (found[1].matched) {
      out += fmt::format("\\mathrm{{{}}}", found.str());
    } else if (found[2].matched) {
      out += "\\,";
    } else if (command == "mu" || command == "Omega") {
      out += command == "mu" ? "\\mathrm{μ}" : "\\mathrm{Ω}";
    } else if (found[3].matched && !std::regex_match(command, of_mathematics)) {
      out += fmt::format("\\si{{\\{}}}", command);
    } else {
      out += found.str();
    }
  }
  return seen == whole.size() ? out : "";
}

// whether units are commands alone, without arguments
bool are_commands(const std::string& units) {
  static const std::regex commands(R"((\s*\\[A-Za-z]+)+\s*)");
  static const std::regex with_arguments(R"(\\(tothe|raiseto|of|cancel|highlight)(?![A-Za-z]))");
  return std::regex_match(units, commands) && !std::regex_search(units, with_arguments);
}

// A number whose doubt, exponent in capitals or missing digits pandoc would not read; empty: it
// reads the number. Throws Error (input), without a place, for what is none.
std::string number_written_out(const std::string& whole, bool has_units) {
  static const std::regex number(
      R"(\s*([+-]?[0-9]{0,40}[.,]?[0-9]{0,40})\s*(\([0-9.,]{1,40}\)|(\\pm|\+-)\s*([0-9.,]{1,40}))?\s*([eEdD]([+-]?[0-9]{1,9}))?\s*)");
  static const std::regex two_points(R"([0-9][.,][0-9]*[.,])");
  if (std::regex_search(whole, two_points))
    throw input_error("'{}' is no number; write it without what groups its digits", whole);
  std::smatch parts;
  if (!std::regex_match(whole, parts, number)) return "";
  std::string digits = parts.str(1), doubt = parts.str(2);
  const bool has_digits = digits.find_first_of("0123456789") != std::string::npos;
  const bool has_capital = parts[5].matched && parts.str(5)[0] != 'e';
  if (doubt.empty() && !has_capital && (has_digits || !parts[5].matched)) return "";
  if (parts[4].matched) doubt = "\\pm " + parts.str(4);
  std::string out = digits + doubt;
  std::replace(out.begin(), out.end(), ',', '.');
  if (parts[4].matched && (has_units || parts[5].matched)) out = "(" + out + ")";
  if (parts[6].matched)
    out += fmt::format("{}10^{{{}}}", has_digits ? "\\times " : "", parts.str(6));
  return "{" + out + "}";
}

}  // namespace

std::string plain_quantities(const std::string& tex) {
  static const std::regex quantity(
      R"(\\(num|SI|qty|si|unit)\s{0,9}\{((?:[^{}]|\{[^{}]{0,40}\}){0,300})\})"
      R"((\s{0,9}\{((?:[^{}]|\{[^{}]{0,40}\}){0,300})\})?)");
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator it(tex.begin(), tex.end(), quantity), end; it != end; ++it) {
    const std::smatch& found = *it;
    const std::string command = found.str(1), first = found.str(2);
    const bool is_unit = command == "si" || command == "unit", is_number = command == "num";
    if (!is_unit && !is_number && !found[3].matched) continue;
    const std::string units = is_unit ? first : is_number ? "" : found.str(4);
    const std::string apart = units_apart(units);
    const std::string number = is_unit ? "" : number_written_out(first, !is_number);
    std::string shown = letters_upright(units);  // empty: as pandoc shows them
    if (shown.empty() && are_commands(units) && apart.find("\\,") != std::string::npos)
      shown = apart;
    if (number.empty() && shown.empty()) continue;
    const auto at = static_cast<std::size_t>(found.position(0));
    out += tex.substr(from, at - from);
    from = at + static_cast<std::size_t>(found.length(0));
    const bool has_number = first.find_first_not_of(" \t\n") != std::string::npos;
    if (!is_unit && has_number) out += number.empty() ? "\\num{" + first + "}" : number;
    if (is_number) out += found.str(3);
    if (!is_number && !is_unit && has_number) out += "\\,";
    if (!is_number) out += shown.empty() ? "\\si{" + units + "}" : shown;
    if (is_unit) out += found.str(3);
  }
  out += tex.substr(from);
  refuse_misread_units(out);
  return out;
}

}  // namespace polhode
