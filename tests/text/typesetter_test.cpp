// SPDX-License-Identifier: MIT
#include "text/typesetter.h"

#include <cmath>
#include <glib.h>
#include <sched.h>

#include <gtest/gtest.h>
#include <sys/mount.h>

#include "base/system/child_process.h"
#include "support/in_child.h"

namespace polhode {
namespace {

TextStyle style(double size) {
  TextStyle one;
  one.size = size;
  return one;
}

// the middle of the ink of a stamp, in pixels of the picture
std::pair<double, double> middle(const Stamp& stamp) {
  double sum = 0.0, across = 0.0, down = 0.0;
  const Sprite& sprite = *stamp.sprite;
  for (int y = 0; y < sprite.height; ++y) {
    for (int x = 0; x < sprite.width; ++x) {
      const double alpha = sprite.pixels[4 * static_cast<std::size_t>(y * sprite.width + x) + 3];
      sum += alpha;
      across += alpha * (stamp.x + x + 0.5);
      down += alpha * (stamp.y + y + 0.5);
    }
  }
  return {across / sum, down / sum};
}

TEST(Typesetter, WantedFontsAreInstalled) {
  for (const FontFound& font : examine_fonts())
    EXPECT_TRUE(font.there) << font.wanted << ": " << font.found;
}

// as after a copy that was cut off: it is listed, but has no letters
TEST(Typesetter, FontsThatCannotBeReadAreTold) {
  constexpr int kNotAllowed = 77;
  const ChildResult found = run_child({"fc-match", "-f", "%{file}", "Inter"}, "");
  ASSERT_TRUE(ended_well(found)) << found.err;
  const int damaged = test::exit_code_in_child([&] {
    const bool alone = unshare(CLONE_NEWNS) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
    if (!alone || mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("/dev/null", found.out.c_str(), nullptr, MS_BIND, nullptr) != 0)
      return kNotAllowed;
    int count = 0;
    for (const FontFound& font : examine_fonts())
      count += font.damaged ? 1 : 0;
    return count;
  });
  if (damaged == kNotAllowed) GTEST_SKIP() << "namespaces are not allowed here";
  EXPECT_EQ(damaged, 1);
}

TEST(Typesetter, InkIsWhereMeasureSays) {
  const Typesetter typesetter;
  for (const char* text : {"L", "g", "<b>ê</b><sub>3</sub>", "<i>φ̇</i>", "t = 11.25 s"}) {
    const TextBox box = typesetter.measure(text, style(60.0));
    const Stamp stamp = typesetter.set(text, style(60.0), 100.0, 50.0);
    int left = 10000, right = -1, top = 10000, bottom = -1;
    const Sprite& sprite = *stamp.sprite;
    for (int y = 0; y < sprite.height; ++y) {
      for (int x = 0; x < sprite.width; ++x) {
        if (sprite.pixels[4 * static_cast<std::size_t>(y * sprite.width + x) + 3] == 0) continue;
        left = std::min(left, stamp.x + x);
        right = std::max(right, stamp.x + x + 1);
        top = std::min(top, stamp.y + y);
        bottom = std::max(bottom, stamp.y + y + 1);
      }
    }
    EXPECT_NEAR(left, 100.0 + box.ink_left, 1.1) << text;
    EXPECT_NEAR(right, 100.0 + box.ink_right, 1.1) << text;
    EXPECT_NEAR(top, 50.0 + box.ink_top, 1.1) << text;
    EXPECT_NEAR(bottom, 50.0 + box.ink_bottom, 1.1) << text;
  }
}

// text that moves slowly does not jump from pixel to pixel
TEST(Typesetter, PlacesAreKeptToAQuarterOfAPixel) {
  const Typesetter typesetter;
  const auto start = middle(typesetter.set("L", style(40.0), 10.0, 20.0));
  for (const double by : {0.25, 0.5, 1.75, 3.0}) {
    const auto moved = middle(typesetter.set("L", style(40.0), 10.0 + by, 20.0 + by));
    EXPECT_NEAR(moved.first - start.first, by, 0.05);
    EXPECT_NEAR(moved.second - start.second, by, 0.05);
  }
}

TEST(Typesetter, WhatWasSetBeforeDoesNotMatter) {
  const Typesetter fresh;
  const Typesetter used;
  for (int i = 0; i < 3000; ++i)
    (void)used.set(std::to_string(i), style(9.0), 0.1 * i, 0.0);
  const Stamp a = fresh.set("Ω L", style(33.0), 1.3, 2.6);
  const Stamp b = used.set("Ω L", style(33.0), 1.3, 2.6);
  EXPECT_EQ(a.sprite->pixels, b.sprite->pixels);
  EXPECT_EQ(a.x, b.x);
}

// text is put together from kept strips, one per letter; where lines may be broken it is drawn
// whole
TEST(Typesetter, StripsAreAsTheWhole) {
  const Typesetter typesetter;
  for (const double size : {9.0, 14.3, 36.7, 90.0}) {
    for (const Face face : {Face::sans, Face::math}) {
      TextStyle strips = style(size);
      strips.face = face;
      strips.halo = 0.075 * size;
      strips.color = {250, 200, 20};
      strips.halo_color = {10, 20, 60};
      TextStyle whole = strips;
      whole.width = 1e5;
      for (const char* text : {"<i>t</i> = 3.25 s   4.5× slower",
                               "<i>t</i> = 13.70 s",
                               "AVAToyfjf 1.23 –7.77 (ffi)",
                               "<b>ê</b><sub>3</sub>",
                               "<i>φ̇</i>",
                               "<i>m</i><b>g</b>",
                               "<u>under</u> and <s>through</s>",
                               "",
                               "two\nlines"}) {
        for (const double x : {100.0, 3.25, 7.62}) {
          const Stamp a = typesetter.set(text, strips, x, 20.5);
          const Stamp b = typesetter.set(text, whole, x, 20.5);
          EXPECT_EQ(a.x, b.x) << text;
          EXPECT_EQ(a.y, b.y) << text;
          ASSERT_EQ(a.sprite->width, b.sprite->width) << text;
          int most = 0;
          for (std::size_t i = 0; i < a.sprite->pixels.size(); ++i)
            most = std::max(most, std::abs(a.sprite->pixels[i] - b.sprite->pixels[i]));
          EXPECT_LE(most, 17) << text << ' ' << size << ' ' << x;
        }
      }
    }
  }
}

// blanks beside the ink are as wide as those within, and no pixels of the picture
TEST(Typesetter, BlanksAtTheEndAreNotDrawn) {
  const Typesetter typesetter;
  for (const std::string text : {"error 0.0000°", "t"}) {
    const Stamp alone = typesetter.set(text, style(33.0), 0.0, 0.0);
    for (const int count : {1, 4, 300}) {
      const Stamp with = typesetter.set(text + std::string(count, ' '), style(33.0), 0.0, 0.0);
      EXPECT_EQ(with.sprite->width, alone.sprite->width) << text << count;
      EXPECT_EQ(with.sprite->pixels, alone.sprite->pixels) << text << count;
    }
  }
  // to the left of what is read from the right
  EXPECT_LE(typesetter.set("אב    ", style(33.0), 0.0, 0.0).sprite->width,
            typesetter.set("אב", style(33.0), 0.0, 0.0).sprite->width + 1);
  EXPECT_LE(typesetter.set("        ", style(33.0), 0.0, 0.0).sprite->width, 4);
}

TEST(Typesetter, PlainTextIsNoMarkup) {
  const Typesetter typesetter;
  for (const char* text : {"<b>", "a & b", "</span><span size='900%'>", "\"'<i>", "&#x41;", ""}) {
    const TextBox box = typesetter.measure(plain_text(text), style(20.0));
    EXPECT_LT(box.height, 40.0) << text;
    if (*text != 0) {
      EXPECT_GT(box.ink_width(), 0.0) << text;
    }
  }
}

TEST(Typesetter, LongLinesAreBroken) {
  const Typesetter typesetter;
  TextStyle narrow = style(20.0);
  narrow.width = 200.0;
  const std::string words(60, 'w');
  EXPECT_LE(typesetter.measure("many words that do not fit into one line", narrow).width, 200.5);
  EXPECT_LE(typesetter.measure(words, narrow).width, 200.5);
  EXPECT_GT(typesetter.measure(words, style(20.0)).width, 500.0);
}

// digits are equally wide, so that a clock does not shake
TEST(Typesetter, DigitsAreEquallyWide) {
  const Typesetter typesetter;
  const double width = typesetter.measure("0.00", style(30.0)).width;
  for (int i = 1; i < 10; ++i) {
    const std::string digit = std::to_string(i);
    EXPECT_NEAR(typesetter.measure(digit + "." + digit + digit, style(30.0)).width, width, 0.01);
  }
}

TEST(Typesetter, ARimStandsAroundTheLetters) {
  const Typesetter typesetter;
  TextStyle rimmed = style(40.0);
  rimmed.halo = 3.0;
  rimmed.color = {255, 0, 0};
  rimmed.halo_color = {0, 0, 255};
  const Stamp stamp = typesetter.set("I", rimmed, 0.0, 0.0);
  const Sprite& sprite = *stamp.sprite;
  EXPECT_EQ(sprite.rim.color, rimmed.halo_color);
  EXPECT_EQ(sprite.rim.ink, rimmed.color);
  ASSERT_EQ(4 * sprite.rim.coverage.size(), sprite.pixels.size());
  bool inked = false, rim_alone = false;
  for (std::size_t i = 0; i < sprite.rim.coverage.size(); ++i) {
    inked = inked || sprite.pixels[4 * i] > 200;
    rim_alone = rim_alone || (sprite.pixels[4 * i + 3] == 0 && sprite.rim.coverage[i] > 200);
  }
  EXPECT_TRUE(inked && rim_alone);
}

// Whatever the place of a letter, all pixels beside its ink are of its rim.
TEST(Typesetter, RimsHaveNoHoles) {
  constexpr int kWhole = 250;  // alpha; the narrowest rims, of 2.1 px, end a little sooner
  const Typesetter typesetter;
  for (const char* text :
       {"<b>v</b><sub>P</sub>", "<b>Ω</b>", "<b>ê</b><sub>3</sub>", "θ̇", "<b>r̃</b>"}) {
    for (double size = 28.0; size <= 60.0; size += 4.0) {
      for (int part = 0; part < 16; ++part) {
        TextStyle bare = style(size);
        bare.face = Face::math;
        TextStyle rimmed = bare;
        rimmed.halo = 0.075 * size;
        const double x = 10.0 + 0.25 * (part % 4), y = 10.0 + 0.25 * (part / 4.0);
        const Stamp ink = typesetter.set(text, bare, x, y);
        const Stamp all = typesetter.set(text, rimmed, x, y);
        // of ink and rim together
        const auto alpha = [](const Stamp& stamp, int column, int row) -> int {
          const int i = column - stamp.x, j = row - stamp.y;
          const Sprite& sprite = *stamp.sprite;
          if (i < 0 || j < 0 || i >= sprite.width || j >= sprite.height) return 0;
          const auto at = static_cast<std::size_t>(j * sprite.width + i);
          const int rim = sprite.rim.coverage.empty() ? 0 : sprite.rim.coverage[at];
          return std::max<int>(sprite.pixels[4 * at + 3], rim);
        };
        int least = 255;
        for (int row = ink.y; row < ink.y + ink.sprite->height; ++row) {
          for (int column = ink.x; column < ink.x + ink.sprite->width; ++column) {
            if (alpha(ink, column, row) == 0) continue;
            for (const auto& [i, j] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
              least = std::min(least, alpha(all, column + i, row + j));
          }
        }
        EXPECT_GE(least, kWhole) << text << " of " << size << " px, " << part;
      }
    }
  }
}

TEST(Typesetter, WhatGlibCannotDoEndsTheProcessInOneLine) {
  Typesetter typesetter;
  typesetter.measure("a", style(20));
  EXPECT_EXIT(g_error("no memory"), ::testing::ExitedWithCode(3), "text cannot be set: no memory");
}

}  // namespace
}  // namespace polhode
