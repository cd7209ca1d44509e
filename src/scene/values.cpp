// SPDX-License-Identifier: MIT
#include "scene/values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/at_place.h"
#include "base/color.h"
#include "base/nearest.h"
#include "base/one_line.h"
#include "base/utf8.h"
#include "scene/keys.h"
#include "scene/other_words.h"
#include "scene/toml_text.h"

namespace polhode {
namespace {

// what the user wrote, for messages
std::string described(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array: {
      const std::size_t size = node.as_array()->size();
      return size == 0 ? "an empty list" : fmt::format("a list of {}", size);
    }
    case toml::node_type::string:
      return fmt::format("the text \"{}\"", cut(node.as_string()->get()));
    case toml::node_type::integer:
      return fmt::format("the number {}", node.as_integer()->get());
    case toml::node_type::floating_point:
      return fmt::format("the number {}", node.as_floating_point()->get());
    case toml::node_type::boolean:
      return node.as_boolean()->get() ? "true" : "false";
    default:
      return "a date or time";
  }
}

// Bounds are kept in SI and compared in the unit that the user wrote, in which the schema has them.
void check_range(const Found& found, const Range& allowed, double written) {
  const Range range = in_unit(allowed, found.unit);
  const char* wrong = range.low == range.high && written != range.low ? ""
                      : range.low_open && !(written > range.low)      ? " greater than"
                      : written < range.low                           ? " at least"
                      : written > range.high                          ? " at most"
                                                                      : nullptr;
  if (wrong == nullptr) return;
  const double bound = written > range.high ? range.high : range.low;
  refuse(found, fmt::format("must be{} {:.6g}, got {}", wrong, bound, written));
}

// what no scene can mean would overflow later, far from its place
void check_magnitude(const Found& found, const Doc& doc, double written) {
  const Range range = in_unit(within_magnitude(doc.range, doc.unit), found.unit);
  const char* wrong = written > range.high   ? "large"
                      : written >= range.low ? nullptr
                      : written < 0.0        ? "large"
                                             : "small";
  if (wrong == nullptr) return;
  const double bound = written > range.high ? range.high : range.low;
  refuse(found,
         fmt::format("is too {} to be computed with (the limit is {:.6g}{}{}), got {}",
                     wrong,
                     bound,
                     *found.unit.symbol == '\0' ? "" : " ",
                     found.unit.symbol,
                     written));
}

double number(const Found& found, const Doc& doc, const std::string& wanted) {
  double written = 0.0;
  if (const auto* integer = found.node.as_integer()) {
    written = static_cast<double>(integer->get());
  } else if (const auto* floating = found.node.as_floating_point()) {
    written = floating->get();
  } else {
    refuse_type(found, wanted);
  }
  if (!std::isfinite(written))
    refuse(found, fmt::format("must be a finite number, got {}", written));
  check_range(found, doc.range, written);
  if (doc.whole && written != std::floor(written))
    refuse(found, fmt::format("must be a whole number, got {}", written));
  check_magnitude(found, doc, written);
  return to_si(written, found.unit);
}

template <class Vector>
void read_vector(const Found& found, const Doc& doc, const std::string& wanted, Vector& value) {
  const auto size = static_cast<std::size_t>(value.size());
  const toml::array& array = array_of(found, size, wanted);
  for (std::size_t i = 0; i < size; ++i) {
    value[static_cast<Eigen::Index>(i)] =
        number(element_of(found, array, i), doc, "a number, such as 1.5");
  }
}

}  // namespace

void refuse(const Found& found, const std::string& message) {
  throw Error(Fault::input, message, found.place);
}

void refuse_type(const Found& found, const std::string& wanted, const std::string& hint) {
  refuse(found, fmt::format("must be {}; found {}{}", wanted, described(found.node), hint));
}

const toml::array& array_of(const Found& found, std::size_t length, const std::string& wanted) {
  const toml::array* array = found.node.as_array();
  if (array == nullptr || array->empty()) refuse_type(found, wanted);
  if (length != 0 && array->size() != length) refuse_type(found, wanted);
  return *array;
}

Found element_of(const Found& found, const toml::array& array, std::size_t i) {
  const toml::node& node = array[i];
  Place place = found.place;
  place.line = static_cast<int>(node.source().begin.line);
  place.key += fmt::format("[{}]", i);
  return {node, place, found.unit};
}

void read_value(const Found& found, const Doc&, bool& value) {
  if (!found.node.is_boolean()) refuse_type(found, "true or false");
  value = found.node.as_boolean()->get();
}

void read_value(const Found& found, const Doc& doc, int& value) {
  if (!found.node.is_integer()) {
    const auto* floating = found.node.as_floating_point();
    const bool is_whole = floating != nullptr && floating->get() == std::floor(floating->get());
    refuse_type(found, "a whole number, such as 1", is_whole ? ", written with a point" : "");
  }
  const double wide = number(found, doc, "a whole number, such as 1");
  if (std::abs(wide) > std::numeric_limits<int>::max()) {
    refuse(found, fmt::format("is too large, got {}", found.node.as_integer()->get()));
  }
  value = static_cast<int>(wide);
}

void read_value(const Found& found, const Doc& doc, double& value) {
  value = number(found, doc, "a number, such as 1.5");
}

void read_value(const Found& found, const Doc& doc, std::string& value) {
  const std::string example =
      doc.choices.empty() ? doc.color ? "#ff8800" : "a title" : doc.choices.front();
  if (!found.node.is_string()) {
    refuse_type(found,
                fmt::format("text, such as \"{}\"", example),
                found.node.is_value() ? ", without quotes" : "");
  }
  value = found.node.as_string()->get();
  if (value.size() > kLongestText) {
    refuse(
        found,
        fmt::format("is a text of {} bytes; at most {} are allowed", value.size(), kLongestText));
  }
  if (const std::size_t i = find_unwritable(value); i != std::string::npos)
    refuse(found, fmt::format("holds {}, which no document can show", code_point(value, i)));
  if (!doc.choices.empty() &&
      std::find(doc.choices.begin(), doc.choices.end(), value) == doc.choices.end()) {
    const std::string hint = suggestion(value, doc.choices) + instead_hint(value);
    refuse(found, fmt::format("'{}' is not known{}", cut(value), hint));
  }
  if (!doc.color) return;
  at_place(found.place, [&] { parse_color(value); });
}

void read_value(const Found& found, const Doc& doc, Vec2& value) {
  read_vector(found, doc, "a list of two numbers, such as [0.1, 0.2]", value);
}

void read_value(const Found& found, const Doc& doc, Vec3& value) {
  read_vector(found, doc, "a list of three numbers, such as [1, 0, 0.5]", value);
}

void read_value(const Found& found, const Doc& doc, Eigen::Vector4d& value) {
  read_vector(found, doc, "a list of four numbers, such as [1, 0, 0, 0]", value);
  if (value == Eigen::Vector4d::Zero()) refuse(found, "must not be zero in all four numbers");
}

void read_value(const Found& found, const Doc& doc, Mat3& value) {
  const std::string wanted =
      "three rows of three numbers, such as [[1, 0, 0], [0, 1, 0], [0, 0, 1]]";
  const toml::array& rows = array_of(found, 3, wanted);
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3 row;
    read_value(element_of(found, rows, i), doc, row);
    value.row(static_cast<Eigen::Index>(i)) = row.transpose();
  }
}

void read_value(const Found& found, const Doc& doc, std::vector<Vec2>& value) {
  const toml::array& points = array_of(found, 0, "a list of points, such as [[0, 0], [0.1, 0.2]]");
  value.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    read_value(element_of(found, points, i), doc, value[i]);
}

void read_value(const Found& found, const Doc& doc, std::vector<Vec3>& value) {
  const toml::array& points =
      array_of(found, 0, "a list of points, such as [[0, 0, 0.1], [0.1, 0, 0]]");
  value.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    read_value(element_of(found, points, i), doc, value[i]);
}

void read_value(const Found& found, const Doc& doc, std::vector<std::string>& value) {
  const std::string example = doc.choices.empty() ? "a" : doc.choices.back();
  const toml::array& names =
      array_of(found, 0, fmt::format("a list of names, such as [\"{}\"]", example));
  if (names.size() > kMostNames)
    refuse(found, fmt::format("has {} names; at most {} are allowed", names.size(), kMostNames));
  value.resize(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    read_value(element_of(found, names, i), doc, value[i]);
}

void read_value(const Found& found, const Doc&, PictureSize& value) {
  const std::string wanted = "a picture size, such as \"1920x1080\" or [1920, 1080]";
  if (const auto* text = found.node.as_string()) {
    value = at_place(found.place, [&] { return parse_picture_size(text->get()); });
    return;
  }
  const toml::array& sides = array_of(found, 2, wanted);
  const Doc side{.text = "", .range = Range{kSmallestSide, kLargestSide}};
  read_value(element_of(found, sides, 0), side, value.width);
  read_value(element_of(found, sides, 1), side, value.height);
  at_place(found.place, [&] { check_picture_size(value); });
}

void read_value(const Found& found, const Doc&, FrameRate& value) {
  std::string text;
  if (const auto* integer = found.node.as_integer()) {
    text = fmt::format("{}", integer->get());
  } else if (const auto* ratio = found.node.as_string()) {
    text = ratio->get();
  } else if (const auto* rate = found.node.as_floating_point()) {
    text = fmt::format("{}", rate->get());
  } else {
    refuse_type(found, "a whole number, such as 60, or an exact ratio, such as \"30000/1001\"");
  }
  value = at_place(found.place, [&] { return parse_frame_rate(text); });
}

void read_value(const Found& found, const Doc&, Accuracy& value) {
  if (const auto* text = found.node.as_string()) {
    value = at_place(found.place, [&] { return parse_accuracy(text->get()); });
    return;
  }
  const Doc radians{.text = "", .range = kPositive};
  value = {number(found, radians, "radians, such as 1e-6, or pixels, such as \"0.1px\""), false};
}

void read_value(const Found& found, const Doc&, toml::table& value) {
  const toml::table* table = found.node.as_table();
  if (table == nullptr) refuse_type(found, "a table, such as { \"motion.duration\" = 5 }");
  value = *table;
}

void read_value(const Found& found, const Doc&, toml::array& value) {
  const toml::array& array = array_of(found, 0, "a list of values");
  if (array.size() > kMostNames)
    refuse(found, fmt::format("has {} values; at most {} are allowed", array.size(), kMostNames));
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (!array.get(i)->is_value()) refuse_type(element_of(found, array, i), "a number or a text");
  }
  value = array;
}

}  // namespace polhode
