// SPDX-License-Identifier: MIT
// Reads single values from a TOML tree: every type that a member of a spec may have, except tables.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "base/error.h"
#include "base/fields.h"
#include "math/notation.h"
#include "motion/motion_spec.h"
#include "video/video_spec.h"

namespace polhode {

// A value in the file, with its place and its unit.
struct Found {
  const toml::node& node;  // part of the TOML tree, which must outlive this
  Place place;
  UnitSuffix unit;  // of the suffix of its key
};

// Throws Error (input) with the place (file, line, key) of the value.
[[noreturn]] void refuse(const Found& found, const std::string& message);

// Throws Error (input) such as: must be a number, such as 1.5; found the text "abc". `wanted` is
// the part after "must be"; `hint` is put at the end.
[[noreturn]] void refuse_type(const Found& found,
                              const std::string& wanted,
                              const std::string& hint = "");

// The value as an array of the given length (0: any length but 0), valid as long as the TOML tree;
// for other values calls refuse_type() with `wanted`.
const toml::array& array_of(const Found& found, std::size_t length, const std::string& wanted);

// Element i of `array`, the array of `found`, as a value with its own key: "moments[2]".
Found element_of(const Found& found, const toml::array& array, std::size_t i);

// Each stores the value in SI units. A picture size is "1920x1080" or [1920, 1080], a frame rate a
// whole number or "30000/1001", an accuracy a number of radians or "0.1px". Throws Error (input),
// with the value's place, for a wrong type or length, an empty list, more than kMostNames names, a
// text of more than kLongestText bytes (scene/keys.h), a number that is not finite, outside
// doc.range or outside the magnitudes of its unit (within_magnitude in base/fields.h), a text that
// is not in doc.choices or, with doc.color, no colour; and as check_picture_size,
// parse_picture_size, parse_frame_rate and parse_accuracy do.
void read_value(const Found& found, const Doc& doc, bool& value);
void read_value(const Found& found, const Doc& doc, int& value);
void read_value(const Found& found, const Doc& doc, double& value);
void read_value(const Found& found, const Doc& doc, std::string& value);
void read_value(const Found& found, const Doc& doc, Vec2& value);
void read_value(const Found& found, const Doc& doc, Vec3& value);
void read_value(const Found& found, const Doc& doc, Eigen::Vector4d& value);  // not all zero
void read_value(const Found& found, const Doc& doc, Mat3& value);
void read_value(const Found& found, const Doc& doc, std::vector<Vec2>& value);
void read_value(const Found& found, const Doc& doc, std::vector<Vec3>& value);
void read_value(const Found& found, const Doc& doc, std::vector<std::string>& value);
void read_value(const Found& found, const Doc& doc, PictureSize& value);
void read_value(const Found& found, const Doc& doc, FrameRate& value);
void read_value(const Found& found, const Doc& doc, Accuracy& value);
void read_value(const Found& found, const Doc& doc, toml::table& value);  // of anything
void read_value(const Found& found, const Doc& doc, toml::array& value);  // of values

}  // namespace polhode
