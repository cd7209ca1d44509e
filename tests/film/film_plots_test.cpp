// SPDX-License-Identifier: MIT
#include "film/film_plots.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "film/small_films.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::small_scene;

TEST(FilmPlots, WithoutPlotsNothingIsTakenFromThePicture) {
  EXPECT_EQ(width_of_plots({}), 0.0);
  EXPECT_TRUE(make_plots(solve(small_scene())).empty());
  ShowSpec show;
  show.plots = {"tilt"};
  EXPECT_GT(width_of_plots(show), 0.2);
  EXPECT_LT(width_of_plots(show), 0.5);
}

// inside the part of the frame that is kept for them, under each other, none higher than wide
TEST(FilmPlots, StandUnderEachOtherOnTheRight) {
  Scene scene = small_scene("[show]\nplots = [\"tilt\", \"energy\", \"omega\"]\n");
  scene.video.size = {640, 360};
  const std::vector<FilmPlot> plots = make_plots(solve(scene));
  ASSERT_EQ(plots.size(), 3U);
  int free_from = 0;
  for (const FilmPlot& plot : plots) {
    EXPECT_GE(plot.place.x, 640.0 * (1.0 - width_of_plots(scene.show)));
    EXPECT_LE(plot.place.right(), 640);
    EXPECT_GE(plot.place.y, free_from);
    EXPECT_LE(plot.place.bottom(), 360);
    EXPECT_LE(plot.place.height, plot.place.width);
    free_from = plot.place.bottom();
    EXPECT_EQ(plot.axes->width, plot.place.width);
    EXPECT_EQ(plot.curves->height, plot.place.height);
    EXPECT_EQ(plot.begins, 0.0);
    EXPECT_EQ(plot.ends, 1.0);
    EXPECT_LT(plot.first, plot.last);
  }
}

// nothing of the curves is left of the first column or right of the last, which are times
TEST(FilmPlots, CurvesReachFromTheStartToTheEnd) {
  Scene scene = small_scene("[show]\nplots = [\"tilt\"]\n");
  scene.video.size = {640, 360};
  const FilmPlot plot = make_plots(solve(scene)).at(0);
  int left = plot.place.width, right = 0;
  for (int y = 0; y < plot.curves->height; ++y) {
    for (int x = 0; x < plot.curves->width; ++x) {
      if (plot.curves->pixels[4 * static_cast<std::size_t>(y * plot.curves->width + x) + 3] == 0)
        continue;
      left = std::min(left, x);
      right = std::max(right, x);
    }
  }
  EXPECT_NEAR(left, plot.first, 2);
  EXPECT_NEAR(right, plot.last, 2);
}

// what is revealed of a plot ends at the clock's column, and what is behind it is as before
TEST(FilmPlots, AreRevealedUpToNow) {
  Scene scene = load_scene(test::scene_path("nutation_plots"));
  scene.video.size = {640, 360};
  const Solved solved = solve(scene);
  const std::vector<FilmPlot> plots = make_plots(solved);
  ASSERT_EQ(plots.size(), 3U);
  // the curve of the tilt, read back from its pixels, is the tilt
  const FilmPlot& tilt = plots[0];
  const Sprite& curves = *tilt.curves;
  const auto height_at = [&](int column) {
    double sum = 0.0, rows = 0.0;
    for (int y = 0; y < curves.height; ++y) {
      const double alpha =
          curves.pixels[4 * static_cast<std::size_t>(y * curves.width + column) + 3];
      sum += alpha;
      rows += alpha * (y + 0.5);
    }
    return sum > 0.0 ? rows / sum : -1.0;
  };
  // between its least (30 degrees) and greatest value the curve's height is linear in the value
  const auto tilt_at = [&](double t) {
    const Vec3 axis = solved.simulation.motion.at(t).q_SB * Vec3::UnitZ();
    return std::acos(std::clamp(axis.z(), -1.0, 1.0));
  };
  double low_t = 0.0, high_t = 0.0;
  for (double t = 0.0; t < 0.19; t += 1e-4) {
    if (tilt_at(t) > tilt_at(high_t)) high_t = t;
  }
  const auto column_of = [&](double t) {
    return tilt.first + static_cast<int>(std::lround(t / tilt.ends * (tilt.last - tilt.first)));
  };
  const double bottom = height_at(column_of(low_t + 1e-3)), top = height_at(column_of(high_t));
  ASSERT_GT(bottom, top);
  for (const double t : {0.05, 0.3, 0.62, 1.1}) {
    const double part = (tilt_at(t) - tilt_at(low_t)) / (tilt_at(high_t) - tilt_at(low_t));
    EXPECT_NEAR(height_at(column_of(t)), bottom + part * (top - bottom), 0.12 * (bottom - top))
        << t;
  }
}

}  // namespace
}  // namespace polhode
