// SPDX-License-Identifier: MIT
#include "frame/plot.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace polhode {
namespace {

constexpr double kDuration = 1.2;

double wave(std::size_t curve, double t, double low, double high) {
  const double part = 0.5 - 0.5 * std::cos((7.0 + 4.0 * static_cast<double>(curve)) * t);
  return low + part * (high - low);
}

FilmPlot plot(double low, double high, std::size_t curves, const std::string& title = "energy") {
  FilmPlot one;
  one.title = title;
  one.unit = "J";
  one.ends = kDuration;
  for (std::size_t k = 0; k < curves; ++k) {
    one.curves.push_back({k == 0 ? "total" : k == 1 ? "kinetic" : "potential", {}});
    for (int i = 0; i <= 300; ++i)
      one.curves.back().values.push_back(wave(k, kDuration * i / 300, low, high));
  }
  one.now = [=](double t) {
    std::vector<double> now;
    for (std::size_t k = 0; k < curves; ++k)
      now.push_back(wave(k, t, low, high));
    return now;
  };
  return one;
}

PlotStack stack(std::vector<FilmPlot> plots,
                const Typesetter& typesetter,
                double size = 32.0,
                const PixelBox& room = {1094, 95, 826, 985}) {
  return {std::move(plots), room, size, make_theme({}), {}, typesetter};
}

bool inside(const TextRoom& text, const PixelBox& box) {
  return text.left >= box.x && text.top >= box.y && text.right <= box.right() &&
         text.bottom <= box.bottom();
}

TextRoom room_of(const PixelBox& box) {
  return {static_cast<double>(box.x),
          static_cast<double>(box.y),
          static_cast<double>(box.right()),
          static_cast<double>(box.bottom())};
}

// for ranges and sizes of all kinds: labels, titles and names of curves neither touch each other
// nor cover a curve, and all text lies in the room of the plots
TEST(Plot, NoTextTouchesTextOrCurves) {
  const Typesetter typesetter;
  const PixelBox room{1094, 95, 826, 985};
  for (const double size : {12.0, 32.0, 48.0, 130.0}) {
    for (const std::size_t count : {1U, 2U, 3U, 5U}) {
      for (const auto& [low, high] : std::vector<std::pair<double, double>>{{0.0, 1.0},
                                                                            {30.0, 42.3},
                                                                            {-90.0, 110.0},
                                                                            {-3e-16, 2e-15},
                                                                            {0.0, 1.7e7},
                                                                            {0.034590, 0.034591},
                                                                            {5.0, 5.0},
                                                                            {0.0, 0.0},
                                                                            {-0.002, -0.0001}}) {
        SCOPED_TRACE(testing::Message() << size << " " << count << " " << low << ".." << high);
        std::vector<FilmPlot> plots;
        for (std::size_t i = 0; i < count; ++i)
          plots.push_back(
              plot(low, high, 1 + i % 3, i == 1 ? "angular velocity in space axes" : "energy"));
        const PlotStack made = stack(plots, typesetter, size, room);
        const std::vector<PlacedText>& fixed = made.fixed_text();
        for (std::size_t a = 0; a < fixed.size(); ++a) {
          EXPECT_TRUE(inside(fixed[a].room, room)) << a;
          for (std::size_t b = a + 1; b < fixed.size(); ++b)
            EXPECT_FALSE(overlap(fixed[a].room, fixed[b].room)) << a << " and " << b;
          for (const PixelBox& axes : made.axes())
            EXPECT_FALSE(overlap(fixed[a].room, room_of(axes))) << a;
        }
        for (double t = 0.0; t <= kDuration; t += 0.1) {
          const std::vector<PlacedText> values = made.values(t);
          for (std::size_t a = 0; a < values.size(); ++a) {
            EXPECT_TRUE(inside(values[a].room, room)) << t;
            for (std::size_t b = a + 1; b < values.size(); ++b)
              EXPECT_FALSE(overlap(values[a].room, values[b].room)) << t;
            for (const PlacedText& text : fixed)
              EXPECT_FALSE(overlap(values[a].room, text.room)) << t;
          }
        }
      }
    }
  }
}

// a single plot takes more than a third of the height of a frame, several together more
TEST(Plot, IsLargeEnoughToBeRead) {
  const Typesetter typesetter;
  double before = 0.33 * 1080;
  for (const std::size_t count : {1U, 2U, 3U}) {
    const PlotStack made = stack(std::vector<FilmPlot>(count, plot(0.0, 1.0, 3)), typesetter);
    double heights = 0.0;
    for (const PixelBox& axes : made.axes())
      heights += axes.height;
    EXPECT_GT(heights, before) << count;
    before = 0.5 * 1080;
    for (const PlacedText& text : made.fixed_text())
      EXPECT_LT(text.room.width(), 826);
  }
}

// from moment to moment all is the same but the present, the dots and the values
TEST(Plot, OnlyWhatMovesIsDrawnAnew) {
  const Typesetter typesetter;
  const PlotStack made = stack({plot(0.0, 1.0, 3), plot(-2.0, 5.0, 1)}, typesetter);
  std::vector<Stamp> first, second;
  made.draw(0.3, first);
  made.draw(0.31, second);
  ASSERT_EQ(first.size(), second.size());
  std::set<SpritePtr> seen;
  for (const Stamp& stamp : first)
    seen.insert(stamp.sprite);
  std::size_t fresh = 0;
  for (const Stamp& stamp : second)
    fresh += seen.count(stamp.sprite) == 0 ? 1 : 0;
  EXPECT_LE(fresh, 10U)
      << "a dot and a value for each of four curves, the last columns of each plot";
}

// the curve, read back from its pixels, is the function, up to the dot and no further
TEST(Plot, CurvesAreTheirValues) {
  const Typesetter typesetter;
  const PlotStack made = stack({plot(30.0, 42.0, 1)}, typesetter);
  const PixelBox axes = made.axes()[0];
  std::vector<Stamp> stamps;
  const double now = 0.9;
  made.draw(now, stamps);
  const auto found = std::find_if(
      stamps.begin(), stamps.end(), [](const Stamp& stamp) { return stamp.columns >= 0; });
  ASSERT_NE(found, stamps.end());
  const double end = axes.x + axes.width * now / kDuration;
  EXPECT_EQ(found[1].x, found->x + found->columns) << "the last columns go on where it is cut";
  EXPECT_NEAR(found->x + found->columns, end, 5.0);
  EXPECT_NEAR(found[1].x + found[1].sprite->width, end, 5.0);
  // the rightmost pixel of the curve, whose end is round, is within a line's width of the dot
  int rightmost = 0;
  const Sprite& last = *found[1].sprite;
  for (int i = 0; i < last.width * last.height; ++i)
    if (last.pixels[4 * static_cast<std::size_t>(i) + 3] > 0)
      rightmost = std::max(rightmost, i % last.width);
  EXPECT_NEAR(found[1].x + rightmost, end, 2.0);
  const auto row_at = [&](double t) {
    const int column = static_cast<int>(axes.x + axes.width * t / kDuration) - found->x;
    double sum = 0.0, rows = 0.0;
    for (int y = 0; y < found->sprite->height; ++y) {
      const double alpha =
          found->sprite->pixels[4 * (static_cast<std::size_t>(y) *
                                         static_cast<std::size_t>(found->sprite->width) +
                                     static_cast<std::size_t>(column)) +
                                3];
      sum += alpha;
      rows += alpha * (y + 0.5);
    }
    return rows / sum;
  };
  const double least = row_at(1e-3), most = row_at(std::acos(-1.0) / 7.0);
  for (const double t : {0.1, 0.3, 0.55, 0.8}) {
    const double part = wave(0, t, 0.0, 1.0);
    EXPECT_NEAR(row_at(t), least + part * (most - least), 0.02 * (least - most)) << t;
  }
}

// A line has a width: what comes within half of it, and goes far up, is not shown before its time.
TEST(Plot, SteepCurvesEndAtTheirDots) {
  constexpr std::size_t kSteps = 3000, kJump = 1500;
  const Typesetter typesetter;
  FilmPlot jump = plot(0.0, 1.0, 1);
  jump.curves[0].values.assign(kSteps + 1, 1.0);
  std::fill_n(jump.curves[0].values.begin(), kJump, 0.0);
  const PlotStack made = stack({jump}, typesetter);
  const PixelBox axes = made.axes()[0];
  const auto highest = [&](double t) {
    std::vector<Stamp> stamps;
    made.draw(t, stamps);
    const auto whole = std::find_if(
        stamps.begin(), stamps.end(), [](const Stamp& stamp) { return stamp.columns >= 0; });
    int least = axes.bottom();
    for (const Stamp& stamp : {whole[0], whole[1]}) {
      const Sprite& sprite = *stamp.sprite;
      const int columns = stamp.columns < 0 ? sprite.width : stamp.columns;
      for (int y = 0; y < sprite.height; ++y) {
        for (int x = 0; x < columns; ++x) {
          const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(sprite.width) +
                             static_cast<std::size_t>(x);
          if (sprite.pixels[4 * pixel + 3] > 0) least = std::min(least, stamp.y + y);
        }
      }
    }
    return (least - axes.y) / static_cast<double>(axes.height);
  };
  EXPECT_GT(highest(kDuration * (kJump - 1.0) / kSteps), 0.8);
  EXPECT_LT(highest(kDuration * (kJump + 1.0) / kSteps), 0.2);
}

// where a value is not defined the curve has a gap, and no dot
TEST(Plot, UndefinedValuesAreLeftOut) {
  const Typesetter typesetter;
  FilmPlot broken = plot(0.0, 1.0, 1);
  for (std::size_t i = 100; i < 200; ++i)
    broken.curves[0].values[i] = NAN;
  broken.now = [](double) {
    return std::vector<double>{NAN};
  };
  EXPECT_TRUE(stack({broken}, typesetter).values(0.5).empty());
  for (double& value : broken.curves[0].values)
    value = NAN;
  EXPECT_FALSE(stack({broken}, typesetter).fixed_text().empty());
}

// what is 0 all the time has its own unit
// the angles of Euler of an upright axis, for one
TEST(Plot, ACurveWithoutValuesHasNoName) {
  const Typesetter typesetter;
  FilmPlot one = plot(0.0, 1.0, 2);
  one.curves[1].values.assign(one.curves[1].values.size(), NAN);
  const PlotStack made = stack({one}, typesetter);
  for (const PlacedText& text : made.fixed_text())
    EXPECT_NE(text.markup, "kinetic");
}

// long captions of panels leave headings that can be read
TEST(Plot, LongNamesAreCut) {
  const Typesetter typesetter;
  FilmPlot one = plot(0.0, 1.0, 3);
  for (PlotCurve& curve : one.curves)
    curve.name += ", with a wheel of brass that is turned by a thread";
  std::vector<std::string> names;
  const PlotStack made = stack({one}, typesetter, 32.0);
  for (const PlacedText& text : made.fixed_text()) {
    if (text.markup.find("…") == std::string::npos) continue;
    names.push_back(text.markup);
    EXPECT_GE(text.style.size, 0.49 * 32.0);
    EXPECT_TRUE(text.markup.ends_with("thread")) << text.markup;
  }
  ASSERT_EQ(names.size(), 3);
  // the last stands first
  EXPECT_TRUE(names[0].starts_with("poten")) << names[0];
  EXPECT_TRUE(names[2].starts_with("total")) << names[2];
}

TEST(Plot, ZeroHasOrdinaryNumbers) {
  const Typesetter typesetter;
  const PlotStack zero = stack({plot(0.0, 0.0, 1)}, typesetter);
  bool headed = false;
  for (const PlacedText& text : zero.fixed_text()) {
    EXPECT_EQ(text.markup.find("10^"), std::string::npos) << text.markup;
    headed = headed || text.markup.ends_with(", J");
  }
  EXPECT_TRUE(headed);
}

TEST(Plot, TimesOfPlanetsAreInDays) {
  const Typesetter typesetter;
  FilmPlot one = plot(0.0, 1.0, 1);
  one.ends = 5.0 * 86400.0;
  const auto text = [&](const TimeUnit& unit) {
    return PlotStack({one}, {0, 0, 800, 900}, 32.0, make_theme({}), unit, typesetter)
        .fixed_text()
        .size();
  };
  // 0 to 5 days in steps of 1, instead of 0 to 432 thousand seconds in steps of 100 thousand
  EXPECT_EQ(text(time_unit(86400.0)), text({}) + 1);
}

TEST(Plot, HeightsApartNeverOverlapAndKeepTheirOrder) {
  for (const std::vector<double>& wished : std::vector<std::vector<double>>{
           {10.0, 12.0, 50.0}, {95.0, 95.0, 95.0}, {-20.0, 0.0, 3.0}, {60.0, 20.0, 25.0}}) {
    const std::vector<double> at = heights_apart(wished, 20.0, 0.0, 100.0);
    for (std::size_t a = 0; a < at.size(); ++a) {
      EXPECT_GE(at[a], 0.0);
      EXPECT_LE(at[a] + 20.0, 100.0);
      for (std::size_t b = 0; b < at.size(); ++b) {
        if (a == b) continue;
        EXPECT_GE(std::abs(at[a] - at[b]), 20.0 - 1e-9);
        if (wished[a] < wished[b]) {
          EXPECT_LT(at[a], at[b]);
        }
      }
    }
  }
  // curves on each other do not change places by rounding errors
  for (const double error : {-1e-12, 0.0, 1e-12})
    EXPECT_NEAR(heights_apart({50.0, 50.0 + error}, 20.0, 0.0, 100.0)[0], 40.0, 1e-9);
  EXPECT_EQ(heights_apart({10.0, 70.0}, 20.0, 0.0, 100.0), (std::vector<double>{10.0, 70.0}));
}

}  // namespace
}  // namespace polhode
