// SPDX-License-Identifier: MIT
// Converts single values to JSON, in SI units and in the form that scene files accept.
#pragma once

#include <string>

#include <fmt/format.h>

#include "base/json.h"
#include "math/notation.h"
#include "motion/motion_spec.h"
#include "video/video_spec.h"

namespace polhode {

// Minus zero becomes zero, so that both have the same hash.
inline Json to_json_value(double value) {
  return value == 0.0 ? 0.0 : value;
}
inline Json to_json_value(int value) {
  return value;
}
inline Json to_json_value(bool value) {
  return value;
}
inline Json to_json_value(const std::string& value) {
  return value;
}

// Vectors become lists of numbers.
template <int N>
Json to_json_value(const Eigen::Matrix<double, N, 1>& value) {
  Json list = Json::array();
  for (const double component : value)
    list.push_back(to_json_value(component));
  return list;
}

// Matrices become lists of rows.
inline Json to_json_value(const Mat3& value) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i)
    rows.push_back(to_json_value(Vec3(value.row(i).transpose())));
  return rows;
}

// [width, height] in pixels.
inline Json to_json_value(const PictureSize& value) {
  return Json::array({value.width, value.height});
}

// A whole number, or a text such as "30000/1001".
inline Json to_json_value(const FrameRate& value) {
  if (value.denominator == 1) return value.numerator;
  return fmt::format("{}/{}", value.numerator, value.denominator);
}

// A number of radians, or a text such as "0.1px".
inline Json to_json_value(const Accuracy& value) {
  if (!value.pixels) return value.value;
  return fmt::format("{}px", value.value);
}

}  // namespace polhode
