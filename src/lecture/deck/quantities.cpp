// SPDX-License-Identifier: MIT
#include "lecture/deck/quantities.h"

#include <algorithm>
#include <iterator>
#include <regex>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"

namespace polhode {
namespace {

constexpr const char* kPrefixes =
    "yocto|zepto|atto|femto|pico|nano|micro|milli|centi|deci|hecto|kilo|mega|giga|tera|peta|exa|"
    "zetta"
    "|yotta";

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
  if (std::regex_search(tex, found, options))
    throw input_error("options of \\{} are not read; write the number as it is to be shown",
                      found.str(1));
  if (std::regex_search(tex, found, complex)) {
    throw input_error(
        "'{}' is no number that can be read; write it without \\{}", found.str(), found.str(1));
  }
}

// \per is of the next unit alone, but what stands behind a fraction looks divided too: W/m²K.
void refuse_units_behind_fractions(const std::string& units) {
  static const std::regex command(R"(\\([A-Za-z]+))");
  static const std::regex no_unit(
      fmt::format("{}|squared|cubed|square|cubic|tothe|raiseto|of|cancel|highlight", kPrefixes));
  bool is_divided = false, is_fraction = false;  // the next unit; what came before
  for (std::sregex_iterator word(units.begin(), units.end(), command), end; word != end; ++word) {
    const std::string name = word->str(1);
    if (name == "per") {
      is_divided = true;
    } else if (!std::regex_match(name, no_unit)) {
      if (is_fraction && !is_divided)
        throw input_error("'\\{}' behind \\per would look divided too; put it before \\per", name);
      is_fraction = is_fraction || is_divided;
      is_divided = false;
    }
  }
}

std::string written_out(const std::string& digits,
                        const std::string& doubt,
                        const std::string& power) {
  std::string out = digits + doubt;
  if (power.empty()) return out;
  const bool has_digits = digits.find_first_of("0123456789") != std::string::npos;
  return out + fmt::format("{}10^{{{}}}", has_digits ? "\\times " : "", power);
}

}  // namespace

std::string plain_quantities(const std::string& tex) {
  refuse_misread_units(tex);
  static const std::regex quantity(
      R"(\\(num|SI|qty|si|unit)\s{0,9}(\[[^\]\[]{0,200}\])?\s{0,9}\{([^{}]{0,200})\}(\{([^{}]{0,300})\})?)");
  static const std::regex number(
      R"(\s{0,9}([+-]?[0-9]{0,40}[.,]?[0-9]{0,40})\s{0,9}(\([0-9.,]{1,40}\))?\s{0,9}([eEdD]([+-]?[0-9]{1,9}))?\s{0,9})");
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator it(tex.begin(), tex.end(), quantity), end; it != end; ++it) {
    const std::smatch& found = *it;
    const std::string command = found.str(1);
    const bool has_units = command == "SI" || command == "qty";
    if (command == "si" || command == "unit") {
      refuse_units_behind_fractions(found.str(3));
      continue;
    }
    if (has_units) refuse_units_behind_fractions(found.str(5));
    const std::string whole = found.str(3);
    std::smatch parts;
    if (!std::regex_match(whole, parts, number)) continue;
    std::string digits = parts.str(1);
    const bool has_digits = digits.find_first_of("0123456789") != std::string::npos;
    if (!parts[2].matched && (has_digits || !parts[3].matched)) continue;
    std::replace(digits.begin(), digits.end(), ',', '.');
    const auto at = static_cast<std::size_t>(found.position(0));
    out +=
        tex.substr(from, at - from) + "{" + written_out(digits, parts.str(2), parts.str(4)) + "}";
    from = at + static_cast<std::size_t>(found.length(0));
    if (has_units) {
      out += "\\,\\si{" + found.str(5) + "}";
    } else {
      out += found.str(4);
    }
  }
  return out + tex.substr(from);
}

}  // namespace polhode
