// SPDX-License-Identifier: MIT
#include "scene/values.h"

#include <limits>

#include <gtest/gtest.h>

#include "base/units.h"
#include "scene/scene.h"
#include "scene/scene_texts.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

// the value that a line of TOML gives, with the key `x`
template <class T>
T value_of(const std::string& toml, const Doc& doc = {}, const char* suffix = "") {
  const toml::table tree = toml::parse("x = " + toml);
  UnitSuffix unit = suffixes_of(doc.unit).front();
  for (const UnitSuffix& one : suffixes_of(doc.unit)) {
    if (std::string(one.suffix) == suffix) unit = one;
  }
  T value{};
  read_value({*tree.get("x"), {"t", 1, "x"}, unit}, doc, value);
  return value;
}

template <class T>
void expect_refused(const std::string& toml,
                    const std::string& key,
                    const std::string& words,
                    const Doc& doc = {},
                    const char* suffix = "") {
  test::expect_input_error([&] { value_of<T>(toml, doc, suffix); }, key, words);
}

TEST(Values, AreConvertedToTheLastBit) {
  const Scene scene = read(
      "[body]\nparts = [{ kind = \"rod\", length_mm = 7, radius_cm = 35, mass_g = 12, turn_deg = "
      "[90, 0, "
      "-180], at_km = [1, 0.5, 0], density_g_per_cm3 = 2.7 }]\n[motion]\nduration_ms = 1500\nspin "
      "= { "
      "space_rpm = [60, 0, 0] }\n");
  const SolidSpec& rod = scene.body.parts.at(0);
  EXPECT_EQ(*rod.length, 0.007);
  EXPECT_EQ(*rod.radius, 0.35);
  EXPECT_EQ(*rod.mass, 0.012);
  EXPECT_EQ(rod.turn, Vec3(kPi / 2, 0, -kPi));
  EXPECT_EQ(rod.at, Vec3(1000, 500, 0));
  EXPECT_EQ(*rod.density, 2700.0);
  EXPECT_EQ(scene.motion.duration, 1.5);
  EXPECT_DOUBLE_EQ(scene.motion.spin.space->x(), 2 * kPi);
}

TEST(Values, MatricesKeepTheirRows) {
  const Scene scene = read("[body]\ntensor_g_cm2 = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]\n");
  EXPECT_DOUBLE_EQ((*scene.body.tensor)(0, 2), 3e-7);
  EXPECT_DOUBLE_EQ((*scene.body.tensor)(2, 0), 7e-7);
}

TEST(Values, SizesRatesAndAccuraciesHaveTwoForms) {
  EXPECT_EQ(read(kBody + "[video]\nsize = \"640x480\"").video.size, (PictureSize{640, 480}));
  EXPECT_EQ(read(kBody + "[video]\nsize = [640, 480]").video.size, (PictureSize{640, 480}));
  EXPECT_EQ(read(kBody + "[video]\nfps = 25").video.fps, (FrameRate{25, 1}));
  EXPECT_EQ(read(kBody + "[video]\nfps = \"30000/1001\"").video.fps, (FrameRate{30000, 1001}));
  const Scene radians = read(kBody + "[numerics]\naccuracy = 1e-6");
  EXPECT_EQ(radians.numerics.accuracy.value, 1e-6);
  EXPECT_FALSE(radians.numerics.accuracy.pixels);
  const Scene pixels = read(kBody + "[numerics]\naccuracy = \"0.25px\"");
  EXPECT_EQ(pixels.numerics.accuracy.value, 0.25);
  EXPECT_TRUE(pixels.numerics.accuracy.pixels);
}

TEST(Values, EachTypeTakesItsOwn) {
  EXPECT_TRUE(value_of<bool>("true"));
  EXPECT_EQ(value_of<int>("-3"), -3);
  EXPECT_EQ(value_of<double>("2"), 2.0);
  EXPECT_EQ(value_of<std::string>("\"words\""), "words");
  EXPECT_EQ(value_of<Vec2>("[1, 2.5]"), Vec2(1, 2.5));
  EXPECT_EQ(value_of<Eigen::Vector4d>("[0, 0, 0, -1]"), Eigen::Vector4d(0, 0, 0, -1));
  EXPECT_EQ(value_of<std::vector<Vec3>>("[[1, 2, 3], [4, 5, 6]]").at(1), Vec3(4, 5, 6));
  EXPECT_EQ(value_of<std::vector<std::string>>("[\"a\", \"b\"]").size(), 2u);
}

// the message says what is wanted and what was found, at the element at fault
TEST(Values, AnotherTypeIsRefusedWithWhatWasFound) {
  expect_refused<bool>("1", "x", "must be true or false; found the number 1");
  expect_refused<int>("1.5", "x", "a whole number, such as 1; found the number 1.5");
  expect_refused<int>("1.0", "x", "found the number 1, written with a point");
  expect_refused<std::string>("5", "x", "such as \"a title\"; found the number 5, without quotes");
  expect_refused<double>("\"1\"", "x", "found the text \"1\"");
  expect_refused<std::string>("[]", "x", "found an empty list");
  expect_refused<std::string>("\"a\\u0001\"", "x", "holds U+0001, which no document can show");
  expect_refused<Vec3>("[1, 2]", "x", "found a list of 2");
  expect_refused<Vec3>("[1, true, 2]", "x[1]", "found true");
  expect_refused<Mat3>("[[1, 2, 3], [4, 5, {}], [7, 8, 9]]", "x[1][2]", "found a table");
  expect_refused<double>("1979-05-27", "x", "found a date or time");
  expect_refused<Eigen::Vector4d>("[0, 0, 0, 0]", "x", "must not be zero");
}

// bounds hold in SI, and are told in the unit that was written
TEST(Values, BoundsAreToldInTheUnitOfTheKey) {
  const Doc angle{.text = "", .unit = Unit::angle, .range = Range{0.0, kPi / 2}};
  EXPECT_DOUBLE_EQ(value_of<double>("90", angle, "_deg"), kPi / 2);
  expect_refused<double>("91", "x", "must be at most 90, got 91", angle, "_deg");
  const Doc length{.text = "", .unit = Unit::length, .range = kPositive};
  expect_refused<double>("0", "x", "must be greater than 0, got 0", length, "_cm");
  expect_refused<double>("inf", "x", "must be a finite number", length);
  expect_refused<double>("nan", "x", "must be a finite number", length);
}

// what is accepted is what the magnitudes of the unit say, to the last bit on both sides
TEST(Values, WhatWouldOverflowIsRefused) {
  const Doc length{.text = "", .unit = Unit::length};
  const double most = magnitude_of(Unit::length).most;
  EXPECT_EQ(value_of<double>(fmt::format("{:.17g}", most), length), most);
  const double more = std::nextafter(most, std::numeric_limits<double>::infinity());
  expect_refused<double>(fmt::format("{:.17g}", more), "x", "too large", length);
  expect_refused<int>("4294967296", "x", "too large");
}

TEST(Values, NamesAreThoseOfTheList) {
  const Doc doc{.text = "", .choices = {"sphere", "box"}};
  EXPECT_EQ(value_of<std::string>("\"box\"", doc), "box");
  expect_refused<std::string>("\"spere\"", "x", "did you mean 'sphere'?", doc);
  const Doc color{.text = "", .color = true};
  EXPECT_EQ(value_of<std::string>("\"#ff8800\"", color), "#ff8800");
  expect_refused<std::string>("\"orange\"", "x", "#", color);
}

// a decimal rate is refused with the ratio that it most likely means
TEST(Values, DecimalRatesNameTheirRatio) {
  for (const auto& [written, ratio] :
       {std::pair{"29.97", "\"30000/1001\""}, {"23.976", "\"24000/1001\""}, {"12.5", "\"25/2\""}})
    expect_refused<FrameRate>(written, "x", ratio);
}

}  // namespace
}  // namespace polhode
