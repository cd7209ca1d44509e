// SPDX-License-Identifier: MIT
// Single values out of a TOML tree: every type that a spec may hold, except tables.
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

// A value of the file: what was written, where, and in which unit.
struct Found {
  const toml::node& node;
  Place place;
  UnitSuffix unit;
};

// Throws the error at the value's place.
[[noreturn]] void refuse(const Found& found, const std::string& message);

// "must be a number, such as 1.5; found the text "abc"", thrown.
[[noreturn]] void refuse_type(const Found& found, const std::string& wanted);

// An array of the given length (0: any, but not empty), else refuse_type.
const toml::array& array_of(const Found& found, std::size_t length, const std::string& wanted);

// One element of an array, as a value of its own: "moments[2]".
Found element_of(const Found& found, const toml::array& array, std::size_t i);

// Each stores the value in SI, or throws Error (input): wrong type, wrong length, not finite, out
// of doc.range, not one of doc.choices.
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

}  // namespace polhode
