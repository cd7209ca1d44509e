// SPDX-License-Identifier: MIT
#include "film/film_plots.h"

#include <gtest/gtest.h>

#include "film/small_films.h"
#include "scene/scene_file.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::small_scene;

TEST(FilmPlots, WithoutPlotsThereAreNone) {
  EXPECT_TRUE(make_plots({solve(small_scene())}).empty());
}

TEST(FilmPlots, AreThoseOfTheListInItsOrder) {
  const Scene scene = small_scene("[show]\nplots = [\"tilt\", \"energy\", \"omega\"]\n");
  const std::vector<FilmPlot> plots = make_plots({solve(scene)});
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_EQ(plots[0].title, "tilt of the axis");
  EXPECT_EQ(plots[1].unit, "J");
  EXPECT_EQ(plots[2].curves.size(), 3U);
}

// the values of a curve are those of the moments at which they stand
TEST(FilmPlots, CurvesAreSampledOverTheWholeMotion) {
  const Solved solved = solve(load_scene(test::scene_path("nutation_plots")));
  for (const FilmPlot& plot : make_plots({solved})) {
    EXPECT_EQ(plot.begins, 0.0);
    EXPECT_EQ(plot.ends, solved.simulation.motion.duration());
    for (std::size_t k = 0; k < plot.curves.size(); ++k) {
      const std::vector<double>& values = plot.curves[k].values;
      for (const std::size_t i : {std::size_t{0}, std::size_t{700}, values.size() - 1}) {
        const double t =
            plot.ends * static_cast<double>(i) / static_cast<double>(values.size() - 1);
        EXPECT_EQ(values[i], plot.now(t)[k]) << plot.title << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace polhode
