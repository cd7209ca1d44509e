// SPDX-License-Identifier: MIT
#include "image/stroke.h"

#include <cmath>

#include <gtest/gtest.h>

namespace polhode {
namespace {

double length_of(const Polyline& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return sum;
}

double covered(const Sprite& sprite) {
  double sum = 0.0;
  for (std::size_t i = 3; i < sprite.pixels.size(); i += 4)
    sum += sprite.pixels[i] / 255.0;
  return sum;
}

// a wave of many short segments, shorter than any dash
Polyline wave() {
  Polyline line;
  for (int i = 0; i <= 1000; ++i)
    line.push_back({0.3 * i, 50.0 + 40.0 * std::sin(0.05 * i)});
  return line;
}

TEST(Stroke, DashesAreMeasuredAlongTheLine) {
  const double whole = length_of(wave());
  const std::vector<Polyline> dashes = dashes_of(wave(), {20.0, 8.0});
  EXPECT_EQ(dashes.size(), static_cast<std::size_t>(std::ceil(whole / 28.0)));
  for (std::size_t i = 0; i + 1 < dashes.size(); ++i) {
    EXPECT_NEAR(length_of(dashes[i]), 20.0, 1e-9) << i;
    EXPECT_GT(dashes[i].size(), 10U) << "a dash goes on over the corners";
  }
}

TEST(Stroke, APatternMayEndInALongSegment) {
  const std::vector<Polyline> dashes = dashes_of({{0.0, 0.0}, {100.0, 0.0}}, {10.0, 5.0, 2.0, 5.0});
  ASSERT_EQ(dashes.size(), 9U);
  EXPECT_NEAR(dashes[1][0].x, 15.0, 1e-12);
  EXPECT_NEAR(dashes[1][1].x, 17.0, 1e-12);
  EXPECT_NEAR(dashes[2][0].x, 22.0, 1e-12);
}

TEST(Stroke, WithoutAPatternTheLineIsWhole) {
  const std::vector<Polyline> lines = dashes_of(wave(), {});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), wave().size());
}

TEST(Stroke, CoversWhatALineWithRoundEndsCovers) {
  for (const double width : {1.0, 3.0, 6.5}) {
    Sprite sprite(120, 80);
    stroke(sprite, {{{20.3, 20.7}, {90.1, 60.2}}}, width, {200, 100, 50});
    const double area = width * std::hypot(69.8, 39.5) + 0.25 * std::acos(-1.0) * width * width;
    EXPECT_NEAR(covered(sprite), area, 0.02 * area + 1.0) << width;
  }
  Sprite disc(40, 40);
  stroke(disc, {{{20.2, 19.6}}}, 20.0, {200, 100, 50});
  EXPECT_NEAR(covered(disc), 100.0 * std::acos(-1.0), 3.0);
}

TEST(Stroke, WhatMeetsIsNotDrawnTwice) {
  Sprite once(60, 20);
  Sprite twice(60, 20);
  const Polyline line{{5.0, 10.3}, {55.0, 10.3}};
  stroke(once, {line}, 2.0, {10, 20, 30});
  stroke(twice, {line, line}, 2.0, {10, 20, 30});
  EXPECT_EQ(once.pixels, twice.pixels);
}

TEST(Stroke, IsClippedAtTheBorders) {
  Sprite sprite(10, 10);
  stroke(sprite, {{{-50.0, 5.0}, {50.0, 5.0}}}, 4.0, {255, 255, 255});
  EXPECT_NEAR(covered(sprite), 40.0, 0.5);
}

}  // namespace
}  // namespace polhode
