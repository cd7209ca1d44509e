// SPDX-License-Identifier: MIT
#include "film/film_plots.h"

#include <cmath>

#include <gtest/gtest.h>

#include "film/small_films.h"
#include "math/so3.h"
#include "scene/scene_file.h"
#include "support/expect_error.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::small_scene;

TEST(FilmPlots, WithoutPlotsThereAreNone) {
  EXPECT_TRUE(make_charts({solve(small_scene())}).count() == 0);
}

TEST(FilmPlots, AreThoseOfTheListInItsOrder) {
  const Scene scene = small_scene("[show]\nplots = [\"tilt\", \"energy\", \"omega\"]\n");
  const std::vector<FilmPlot> plots = make_charts({solve(scene)}).plots;
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_EQ(plots[0].title, "tilt of the axis");
  EXPECT_EQ(plots[1].unit, "J");
  EXPECT_EQ(plots[2].curves.size(), 3U);
}

// the values of a curve are those of the moments at which they stand
TEST(FilmPlots, CurvesAreSampledOverTheWholeMotion) {
  const Solved solved = solve(load_scene(test::scene_path("nutation_plots")));
  for (const FilmPlot& plot : make_charts({solved}).plots) {
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

// one curve through all motions, with a gap where the next begins
TEST(FilmPlots, MotionsInTurnFollowOneAnother) {
  const Solved slow = solve(load_scene(test::scene_path("heavy_top")));
  Scene faster = slow.scene;
  (*faster.motion.spin.rates)[2] *= 2.0;
  const Solved fast = solve(faster);
  Solved first = slow;
  first.scene.show.plots = {"tilt"};
  first.scene.in_turn = true;
  const FilmPlot plot = make_charts({first, fast}).plots.at(0);
  const double each = slow.scene.motion.duration;
  ASSERT_EQ(plot.curves.size(), 1U);
  EXPECT_EQ(plot.ends, 2.0 * each);
  const auto tilt = [](const Motion& motion, double t) {
    return angle_between(motion.at(t).q_SB * Vec3::UnitZ(), Vec3::UnitZ()) / kDegree;
  };
  EXPECT_NEAR(plot.now(0.4)[0], tilt(slow.simulation.motion, 0.4), 1e-9);
  EXPECT_NEAR(plot.now(each + 0.4)[0], tilt(fast.simulation.motion, 0.4), 1e-9);
  const std::vector<double>& values = plot.curves[0].values;
  const std::size_t half = (values.size() - 1) / 2;
  EXPECT_EQ(values.size(), 2 * half + 1);
  EXPECT_TRUE(std::isnan(values[half]));
  EXPECT_NEAR(values.front(), plot.now(0.0)[0], 1e-9);
  EXPECT_NEAR(values.back(), plot.now(2.0 * each)[0], 1.0);
}

TEST(FilmPlots, PanelsWithoutTheQuantityHaveNoCurve) {
  const auto for_a_second = [](const char* name) {
    Scene scene = load_scene(test::scene_path(name));
    scene.motion.duration = 1.0;
    return solve(scene);
  };
  const Solved free = for_a_second("heavy_top"), on_a_table = for_a_second("tippe_top");
  Solved asked = free;
  asked.scene.show.plots = {"slip"};
  test::expect_input_error(
      [&] { make_charts({asked}); }, "show.plots", "'slip' needs a body on a table");

  asked.scene.panels.resize(2);
  asked.scene.panels[1].caption = "tippe top";
  const FilmPlot plot = make_charts({asked, on_a_table}).plots.at(0);
  ASSERT_EQ(plot.curves.size(), 1U);
  EXPECT_EQ(plot.curves[0].name, "tippe top");
  ASSERT_EQ(plot.now(0.1).size(), 1U);
  EXPECT_GT(plot.now(0.1)[0], 0.0);

  // one after the other: nothing while the body is not on a table
  asked.scene.panels.clear();
  asked.scene.in_turn = true;
  const FilmPlot in_turn = make_charts({asked, on_a_table}).plots.at(0);
  EXPECT_TRUE(std::isnan(in_turn.now(0.1)[0]));
  EXPECT_GT(in_turn.now(1.1)[0], 0.0);
  EXPECT_TRUE(std::isnan(in_turn.curves[0].values.front()));
}

TEST(FilmPlots, DiagramsStandBesideThem) {
  const Solved solved = solve(load_scene(test::scene_path("nutation_plots")));
  Solved asked = solved;
  asked.scene.show.plots = {"tilt", "phase", "potential"};
  const FilmCharts charts = make_charts({asked});
  EXPECT_EQ(charts.plots.size(), 1U);
  ASSERT_EQ(charts.diagrams.size(), 2U);
  ASSERT_EQ(charts.diagrams[0].size(), 1U);
  EXPECT_EQ(charts.diagrams[0][0].title, "phase portrait");

  asked.scene.show.plots = {"polhode_map"};
  test::expect_input_error([&] { make_charts({asked}); },
                           "show.plots",
                           "'polhode_map' needs a turning body on which no torque");
}

// one for each, under its caption, on the same axes; as many as can be read
TEST(FilmPlots, DiagramsOfPanelsSideBySideStandBelowOneAnother) {
  Solved slow = solve(load_scene(test::scene_path("nutation_plots")));
  Scene faster = slow.scene;
  faster.motion.spin.rates->z() *= 1.5;
  Solved fast = solve(faster);
  slow.scene.panels.resize(2);
  slow.scene.panels[0].caption = "slow";
  slow.scene.panels[1].caption = "fast";
  slow.scene.show.plots = {"tilt", "phase"};
  const FilmCharts charts = make_charts({slow, fast});
  EXPECT_EQ(charts.count(), 3);
  ASSERT_EQ(charts.diagrams.size(), 2U);
  const Diagram &first = charts.diagrams[0].at(0), &second = charts.diagrams[1].at(0);
  EXPECT_EQ(first.title, "slow: phase portrait");
  EXPECT_EQ(second.title, "fast: phase portrait");
  EXPECT_EQ(first.across.low, second.across.low);
  EXPECT_EQ(first.up.high, second.up.high);
  EXPECT_GT((first.now(0.03) - second.now(0.03)).norm(), 0.01);
  slow.scene.show.plots = {"phase", "potential"};
  test::expect_input_error(
      [&] {
        make_charts({slow, fast});
      },
      "show.plots",
      "'potential' of 2 panels side by side");
}

// one for each, on the same axes, with its own point
TEST(FilmPlots, DiagramsOfPanelsInTurnFollowOneAnother) {
  Solved slow = solve(load_scene(test::scene_path("nutation_plots")));
  Scene faster = slow.scene;
  faster.motion.spin.rates->z() *= 1.5;
  Solved fast = solve(faster);
  for (Solved* one : {&slow, &fast}) {
    one->scene.show.plots = {"potential"};
    one->scene.in_turn = true;
  }
  const FilmCharts charts = make_charts({slow, fast});
  EXPECT_EQ(charts.count(), 1);
  ASSERT_EQ(charts.diagrams.at(0).size(), 2U);
  const Diagram &first = charts.diagrams[0][0], &second = charts.diagrams[0][1];
  EXPECT_EQ(first.across.low, second.across.low);
  EXPECT_EQ(first.across.high, second.across.high);
  EXPECT_EQ(first.up.high, second.up.high);
  const auto tilt = [](const Motion& motion, double t) {
    return angle_between(motion.at(t).q_SB * Vec3::UnitZ(), Vec3::UnitZ()) / kDegree;
  };
  EXPECT_NEAR(first.now(0.03).x(), tilt(slow.simulation.motion, 0.03), 1e-9);
  EXPECT_NEAR(second.now(0.03).x(), tilt(fast.simulation.motion, 0.03), 1e-9);
  EXPECT_GT(std::abs(first.now(0.03).x() - second.now(0.03).x()), 0.01);
}

}  // namespace
}  // namespace polhode
