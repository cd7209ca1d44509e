// SPDX-License-Identifier: MIT
#include "image/sprite.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

Image filled(int width, int height, const std::array<std::uint8_t, 4>& rgba) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = rgba[i % 4];
  return image;
}

std::array<int, 4> pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = image.at(x, y);
  return {p[0], p[1], p[2], p[3]};
}

TEST(Sprite, OpaqueReplacesAndHalfMixes) {
  Image image = filled(4, 3, {0, 100, 200, 255});
  lay_over(image, {std::make_shared<Sprite>(filled_sprite(1, 1, {200, 0, 50}, 1.0)), 1, 1});
  EXPECT_EQ(pixel(image, 1, 1), (std::array{200, 0, 50, 255}));
  EXPECT_EQ(pixel(image, 2, 1), (std::array{0, 100, 200, 255}));

  // source over (Porter and Duff 1984): a s + (1 - a) d
  Image mixed = filled(1, 1, {0, 100, 200, 255});
  lay_over(mixed, {std::make_shared<Sprite>(filled_sprite(1, 1, {200, 0, 50}, 1.0)), 0, 0, 0.5});
  EXPECT_NEAR(mixed.at(0, 0)[0], 100, 1);
  EXPECT_NEAR(mixed.at(0, 0)[1], 50, 1);
  EXPECT_NEAR(mixed.at(0, 0)[2], 125, 1);
  EXPECT_EQ(mixed.at(0, 0)[3], 255);
}

// over nothing a translucent sprite keeps its colour, and its alpha is the picture's
TEST(Sprite, ColoursOfATransparentPictureStayStraight) {
  Image image = filled(1, 1, {0, 0, 0, 0});
  lay_over(image, {std::make_shared<Sprite>(filled_sprite(1, 1, {200, 40, 80}, 0.25)), 0, 0});
  EXPECT_NEAR(image.at(0, 0)[0], 200, 2);
  EXPECT_NEAR(image.at(0, 0)[1], 40, 2);
  EXPECT_NEAR(image.at(0, 0)[2], 80, 2);
  EXPECT_EQ(image.at(0, 0)[3], 64);
}

TEST(Sprite, WhatLiesOutsideIsCutOff) {
  const auto sprite = std::make_shared<Sprite>(filled_sprite(3, 3, {255, 255, 255}, 1.0));
  for (const auto& [x, y] : {std::pair{-2, -2}, {3, 2}, {-9, 0}, {0, 9}, {2, -1}}) {
    Image image = filled(4, 3, {0, 0, 0, 255});
    lay_over(image, {sprite, x, y});
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        const bool inside = column >= x && column < x + 3 && row >= y && row < y + 3;
        EXPECT_EQ(image.at(column, row)[0], inside ? 255 : 0) << x << ' ' << y;
      }
    }
  }
}

TEST(Sprite, ColumnsRevealItFromTheLeft) {
  Image image = filled(4, 1, {0, 0, 0, 255});
  Stamp stamp{std::make_shared<Sprite>(filled_sprite(4, 1, {255, 255, 255}, 1.0)), 0, 0};
  stamp.columns = 2;
  lay_over(image, stamp);
  EXPECT_EQ(image.at(1, 0)[0], 255);
  EXPECT_EQ(image.at(2, 0)[0], 0);
}

// grey ink with a dark rim, as on a dark page
TEST(Sprite, ARimIsAsStrongAsContrastNeeds) {
  Sprite sprite(1, 1);
  sprite.rim = {{16, 20, 28}, {139, 147, 167}, {255}};
  const auto pixel_over = [&](std::array<std::uint8_t, 4> ground) {
    Image image(1, 1);
    image.fill({0, 0, 1, 1}, ground);
    lay_over(image, {std::make_shared<Sprite>(sprite), 0, 0});
    return std::array<int, 4>{
        image.at(0, 0)[0], image.at(0, 0)[1], image.at(0, 0)[2], image.at(0, 0)[3]};
  };
  // dark enough: 5.5 : 1
  EXPECT_EQ(pixel_over({20, 25, 34, 255}), (std::array<int, 4>{20, 25, 34, 255}));
  // a floor: a little darker, not as dark as the rim
  const std::array<int, 4> floor = pixel_over({42, 47, 58, 255});
  EXPECT_LT(floor[1], 44);
  EXPECT_GT(floor[1], 28);
  // a light body: nearly the colour of the rim
  const std::array<int, 4> body = pixel_over({226, 221, 208, 255});
  EXPECT_LT(body[1], 48);
  EXPECT_GT(body[1], 20);
  // where nothing is known of the ground, all of it
  EXPECT_EQ(pixel_over({0, 0, 0, 0}), (std::array<int, 4>{16, 20, 28, 255}));
}

// the other way round on a light page
TEST(Sprite, ALightRimLightens) {
  Sprite sprite(1, 1);
  sprite.rim = {{245, 244, 240}, {90, 90, 100}, {255}};
  const auto red_over = [&](std::uint8_t grey) {
    Image image(1, 1);
    image.fill({0, 0, 1, 1}, {grey, grey, grey, 255});
    lay_over(image, {std::make_shared<Sprite>(sprite), 0, 0});
    return int{image.at(0, 0)[0]};
  };
  EXPECT_GT(red_over(160), 215);
  EXPECT_LT(red_over(160), 245);
  EXPECT_EQ(red_over(238), 238);
  // ink so light that no ground is light enough: the rim is whole, but does not darken
  sprite.rim.ink = {180, 84, 0};
  EXPECT_EQ(red_over(160), 245);
  EXPECT_EQ(red_over(250), 250);
}

}  // namespace
}  // namespace polhode
