// SPDX-License-Identifier: MIT
#include "film/film_panels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "film/film_plots.h"
#include "film/frame_times.h"
#include "film/small_films.h"
#include "scene/scene_file.h"
#include "support/expect_error.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::scene_names;
using test::scene_path;
using test::small_scene;

struct Panels {
  explicit Panels(const Scene& scene, bool with_text = true) : solved(solve(scene)) {
    if (!scene.numerics.compare.empty()) comparison = std::make_unique<Comparison>(solved, 0.1);
    film = std::make_unique<Film>(make_film({solved},
                                            plan_frame_times(solved, {}).timeline,
                                            comparison.get(),
                                            make_charts({solved}),
                                            with_text));
  }
  const std::vector<FilmPanel>& all() const { return film->panels(); }

  Solved solved;
  std::unique_ptr<Comparison> comparison;
  std::unique_ptr<Film> film;
};

// where a panel shows a point of the body at a moment of the film, pixels
Vec2 seen_in(const FilmPanel& panel, const Solved& solved, double t, const Vec3& r_B) {
  const Sample now = solved.simulation.motion.at(t);
  return panel.composer->camera_at(t).project(point_position(solved.model, now, r_B));
}

TEST(FilmPanels, OneViewIsOnePanelWithoutAHeading) {
  const Panels panels(small_scene());
  ASSERT_EQ(panels.all().size(), 1U);
  EXPECT_EQ(panels.all()[0].place, (PixelBox{0, 0, 64, 48}));
  EXPECT_EQ(panels.all()[0].end, 1.0);
  EXPECT_FALSE(panels.all()[0].notes);
}

// the second camera goes along with the body, which stands still before it
TEST(FilmPanels, TheBodysViewGoesAlongWithTheBody) {
  const std::string shots = "[[shots]]\nat = 0.6\ndirection = [1, 0, 1]\n";
  for (const std::string& more : {std::string(), shots}) {
    const Panels panels(small_scene("[show]\nviews = [\"space\", \"body\"]\n" + more));
    ASSERT_EQ(panels.all().size(), 2U);
    EXPECT_EQ(panels.all()[0].notes(0.3).name, "In space");
    EXPECT_EQ(panels.all()[1].notes(0.3).name, "In body axes");
    const Vec3 point(0.02, 0.05, 0.15);
    for (const double t : {0.0, 0.7}) {
      const double later = t + 0.29;
      const auto goes = [&](std::size_t i) {
        const FilmPanel& panel = panels.all()[i];
        return (seen_in(panel, panels.solved, later, point) -
                seen_in(panel, panels.solved, t, point))
            .norm();
      };
      EXPECT_GT(goes(0), 0.5) << t;
      EXPECT_LT(goes(1), 1e-9) << t;
    }
  }
}

// panels of methods and of scenes, too, and there is only one view of each
TEST(FilmPanels, AreSeenFromTheViewOfTheirScene) {
  const Vec3 point(0.02, 0.05, 0.15);
  const auto goes = [&](const FilmPanel& panel, const Solved& solved) {
    return (seen_in(panel, solved, 0.7, point) - seen_in(panel, solved, 0.2, point)).norm();
  };
  const std::string methods = "[numerics]\ncompare = [\"exact\", \"rk4\"]\nstep = 0.001\n";
  const Panels compared(small_scene("[show]\nviews = [\"body\"]\n" + methods));
  EXPECT_LT(goes(compared.all()[0], compared.solved), 1e-9);
  test::expect_input_error(
      [&] { Panels(small_scene("[show]\nviews = [\"space\", \"body\"]\n" + methods)); },
      "show.views",
      "methods are compared from one view");
  for (const bool same_cameras : {true, false}) {
    Scene space = small_scene();
    space.same_cameras = same_cameras;
    const std::vector<Solved> solved = {solve(space),
                                        solve(small_scene("[show]\nviews = [\"body\"]\n"))};
    const Film film =
        make_film(solved, plan_frame_times(solved[0], {}).timeline, nullptr, {}, false);
    EXPECT_GT(goes(film.panels()[0], solved[0]), 0.5);
    EXPECT_LT(goes(film.panels()[1], solved[1]), 1e-9);
  }
}

TEST(FilmPanels, ComparedMethodsHaveAPanelEach) {
  const Panels panels(small_scene("[numerics]\ncompare = [\"rk4\", \"exact\"]\nstep = 0.3\n"));
  ASSERT_EQ(panels.all().size(), 2U);
  int across = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Contender& one = panels.comparison->contenders()[i];
    const FilmPanel& panel = panels.all()[i];
    EXPECT_EQ(panel.end, one.end);
    EXPECT_EQ(panel.notes(0.5).figures, panels.comparison->notes(one, 0.5, false).figures);
    EXPECT_TRUE(panel.notes(0.5).details.empty());
    EXPECT_EQ(panel.composer->scenery().motion.at(0.9).q_SB.coeffs(),
              one.motion.at(0.9).q_SB.coeffs());
    across += panel.place.width;
  }
  EXPECT_EQ(across, 64) << "side by side";
  // what is compared is seen from one place
  EXPECT_EQ(panels.all()[0].composer->camera().eye(), panels.all()[1].composer->camera().eye());
}

// steps of five seconds have no solution, so that the first panel shows the start alone
TEST(FilmPanels, AMethodThatFailsEndsItsOwnPanel) {
  const Panels panels(small_scene("[numerics]\ncompare = [\"dmv2\", \"exact\"]\nstep = 5.0\n"));
  EXPECT_EQ(panels.all()[0].end, 0.0);
  EXPECT_EQ(panels.all()[1].end, 1.0);
}

TEST(FilmPanels, WithoutTextThereAreNoNotes) {
  for (const char* more : {"[show]\nviews = [\"space\", \"body\"]\n",
                           "[numerics]\ncompare = [\"rk4\", \"exact\"]\nstep = 0.3\n"}) {
    const Panels panels(small_scene(more), false);
    for (const FilmPanel& panel : panels.all())
      EXPECT_FALSE(panel.notes);
  }
}

TEST(FilmPanels, DetailsAreShownWhereAsked) {
  const Panels panels(small_scene(
      "[numerics]\ncompare = [\"rk4\", \"exact\"]\nstep = 0.3\n[show]\ndetails = true\n"));
  EXPECT_EQ(panels.all()[0].notes(0.5).details.size(), 2U);
  EXPECT_EQ(panels.all()[0].notes(0.5).details[0].substr(0, 10), "step 0.3 s");
  EXPECT_EQ(panels.all()[1].notes(0.5).details[0].substr(0, 8), "no steps");
}

TEST(FilmPanels, PlotsShowOneMotion) {
  Scene scene = small_scene(
      "[numerics]\ncompare = [\"rk4\", \"exact\"]\nstep = 0.3\n[show]\nplots = [\"tilt\"]\n");
  test::expect_input_error([&] { const Panels panels(scene); }, "show.plots", "compared");
}

TEST(FilmPanels, TwoViewsStandBesideThePlots) {
  Scene scene = small_scene("[show]\nplots = [\"tilt\"]\nviews = [\"space\", \"body\"]\n");
  scene.video.size = {640, 360};
  const Panels panels(scene);
  ASSERT_EQ(panels.all().size(), 2U);
  for (const FilmPanel& panel : panels.all()) {
    EXPECT_LE(panel.place.right(), 380);
    EXPECT_GE(panel.place.width * panel.place.height, 640 * 360 / 5);
  }
  EXPECT_FALSE(panels.film->at(0.5).stamps.empty());
}

// an automatic camera leaves room for what is laid over the picture
TEST(FilmPanels, TheBodyMakesRoomForPlotsAndCaptions) {
  const auto centre = [](const std::string& more, bool with_text = true) {
    Scene scene = small_scene(more);
    scene.video.size = {640, 360};
    const Panels panels(scene, with_text);
    return panels.all()[0].composer->camera().project(Vec3::Zero());
  };
  const Vec2 alone = centre("");
  const Vec2 plotted = centre("[show]\nplots = [\"tilt\"]\n");
  EXPECT_LT(plotted.x(), 0.7 * alone.x());
  const std::string story = "[[story]]\nat = 0.5\ncaption = \"words\"\n";
  EXPECT_LT(centre(story).y(), alone.y() - 3.0) << "words are at the bottom";
  EXPECT_NEAR(centre(story, false).y(), alone.y(), 1e-9);
}

// text of a panel stays in it, whatever its size
TEST(FilmPanels, NotesAndLabelsStayInTheirPanel) {
  for (const char* name : {"compare_engines", "compare_euler", "compare_fast_top", "two_views"}) {
    for (const double size : {0.6, 1.0, 1.8}) {
      for (const bool details : {false, true}) {
        Scene scene = load_scene(scene_path(name));
        scene.video.size = {640, 360};
        scene.show.text_size = size;
        scene.show.details = details;
        const Panels panels(scene);
        const double end = scene.motion.duration / scene.video.time_scale;
        for (const double part : {0.0, 0.2, 0.6, 1.0}) {
          const std::vector<TextRoom> rooms = panels.film->placed(part * end).rooms;
          ASSERT_GE(rooms.size(), 2U + panels.all().size());
          // the first two are clock and title, which have a bar above all panels
          for (std::size_t i = 0; i < rooms.size(); ++i) {
            const bool in_bar = rooms[i].bottom <= panels.all()[0].place.y;
            EXPECT_EQ(in_bar, i < 2) << name << ' ' << i;
            if (in_bar) continue;
            int homes = 0;
            for (const FilmPanel& panel : panels.all()) {
              const PixelBox& place = panel.place;
              homes += rooms[i].left >= place.x && rooms[i].right <= place.right() &&
                       rooms[i].top >= place.y && rooms[i].bottom <= place.bottom();
            }
            EXPECT_EQ(homes, 1) << name << ' ' << size << ' ' << i << " at " << part;
          }
        }
      }
    }
  }
}

class WholeFilm : public ::testing::TestWithParam<std::string> {};

// at every moment of every film no text runs over another, and none leaves the frame
TEST_P(WholeFilm, TextNeverRunsOverText) {
  Scene scene = load_scene(scene_path(GetParam()));
  scene.video.size = {640, 360};
  const Solved solved = solve(scene);
  const FrameTimes frames = plan_frame_times(solved, {});
  std::unique_ptr<Comparison> comparison;
  if (!scene.numerics.compare.empty()) comparison = std::make_unique<Comparison>(solved, 0.1);
  const Film film =
      make_film({solved}, frames.timeline, comparison.get(), make_charts({solved}), true);
  const double duration = frames.timeline.film_duration();
  constexpr int kLooks = 120;
  for (int i = 0; i <= kLooks; ++i) {
    const double now = duration * i / kLooks;
    const std::vector<TextRoom> rooms = film.placed(now).rooms;
    for (std::size_t a = 0; a < rooms.size(); ++a) {
      EXPECT_GE(rooms[a].left, -1.0) << now;
      EXPECT_GE(rooms[a].top, -1.0) << now;
      EXPECT_LE(rooms[a].right, 641.0) << now;
      EXPECT_LE(rooms[a].bottom, 361.0) << now;
      for (std::size_t b = a + 1; b < rooms.size(); ++b)
        EXPECT_FALSE(overlap(rooms[a], rooms[b])) << now << ": " << a << " and " << b;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Scenes,
                         WholeFilm,
                         ::testing::ValuesIn(scene_names()),
                         [](const auto& row) { return row.param; });

// two scenes, the second with twice the spin and a body half as large
std::vector<Solved> small_and_smaller(const std::string& film = "") {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.toml", test::kSmallScene);
  test::write_text(folder / "film.toml",
                   film + "[[panel]]\nscene = \"a.toml\"\n[[panel]]\nscene = \"a.toml\"\n" +
                       "set = { motion.spin.body = [2, 0, 6], body.solid.semi_axes = [0.05, 0.05, "
                       "0.1] }\n");
  const Scene scene = load_scene(folder / "film.toml");
  return {solve(scene), solve(scene.panels[1].scene)};
}

Film film_of(const std::vector<Solved>& solved) {
  const FrameTimes frames = plan_frame_times(solved.front(), {});
  return make_film(solved, frames.timeline, nullptr, make_charts(solved), true);
}

TEST(FilmPanels, SeveralScenesHaveOneScaleAndOneCamera) {
  const std::vector<Solved> solved = small_and_smaller();
  const Film film = film_of(solved);
  ASSERT_EQ(film.panels().size(), 2U);
  const Composer &large = *film.panels()[0].composer, &small = *film.panels()[1].composer;
  const Vec3 point(0.1, -0.05, 0.2);
  EXPECT_LT((large.camera().project(point) - small.camera().project(point)).norm(), 1e-9);
  EXPECT_EQ(large.scenery().scale.omega, small.scenery().scale.omega);
  EXPECT_EQ(large.scenery().scale.momentum, small.scenery().scale.momentum);
  EXPECT_EQ(large.scenery().scale.body, small.scenery().scale.body);
  // the faster one fills the scale
  const auto length = [](const Composer& picture) {
    const Sample now = picture.scenery().motion.at(0.0);
    return (omega_tip(picture.scenery(), now) - now.reference_S).norm();
  };
  EXPECT_NEAR(length(small), 2.0 * length(large), 1e-9);
  // and all of both is in the picture
  for (const FilmPanel& panel : film.panels()) {
    for (const double t : {0.0, 0.5, 1.0}) {
      const Sample now = panel.composer->scenery().motion.at(t);
      for (const Vec3& tip : {omega_tip(panel.composer->scenery(), now),
                              momentum_tip(panel.composer->scenery(), now)}) {
        const Vec2 at = panel.composer->camera().project(tip);
        EXPECT_TRUE(at.x() > 0 && at.x() < panel.place.width) << at.transpose();
        EXPECT_TRUE(at.y() > 0 && at.y() < panel.place.height) << at.transpose();
      }
    }
  }
  EXPECT_EQ(film.panels()[1].notes(0.0).name, "test");
}

TEST(FilmPanels, SeveralScenesMayHaveTheirOwn) {
  const Film film = film_of(small_and_smaller("cameras = \"own\"\nscales = \"own\"\n"));
  const Composer &large = *film.panels()[0].composer, &small = *film.panels()[1].composer;
  EXPECT_NEAR(2.0 * small.scenery().scale.body, large.scenery().scale.body, 1e-9);
  EXPECT_GT(small.camera().pixels_per_metre(Vec3::Zero()),
            1.5 * large.camera().pixels_per_metre(Vec3::Zero()));
}

// a point for each motion of an ensemble, where its axis is
TEST(FilmPanels, AnEnsembleIsSeenAsPoints) {
  const Panels panels(
      small_scene("[motion.ensemble]\nmembers = 7\ntilt_deg = 3\n[show]\nbody = false\n"));
  const Composer& picture = *panels.all().front().composer;
  const Scenery& scenery = picture.scenery();
  EXPECT_TRUE(picture.shows("ensemble"));
  ASSERT_EQ(scenery.ensemble.size(), 7U);
  ASSERT_EQ(panels.solved.ensemble.size(), 7U);
  const Glyphs glyphs = picture.glyphs_at(scenery.motion.at(0.5));
  ASSERT_EQ(glyphs.meshes.size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    const Sample now = scenery.ensemble[i].at(0.5);
    const Vec3 tip = now.reference_S + now.q_SB * Vec3(0, 0, kTrailRadius * scenery.scale.body);
    EXPECT_LT((glyphs.meshes[i].space_from_mesh.translation() - tip).norm(), 1e-12);
  }
}

TEST(FilmPanels, PlotsHaveTheCurvesOfAllScenes) {
  const std::vector<FilmPlot> plots =
      make_charts(small_and_smaller("show.plots = [\"tilt\", \"omega\"]\n")).plots;
  ASSERT_EQ(plots.size(), 2U);
  ASSERT_EQ(plots[0].curves.size(), 2U);
  EXPECT_EQ(plots[0].curves[0].name, "test");
  ASSERT_EQ(plots[1].curves.size(), 6U);
  const std::vector<double> now = plots[1].now(0.3);
  EXPECT_NEAR(now[5], 2.0 * now[2], 1e-9) << "the spin of the second is twice as fast";
}

}  // namespace
}  // namespace polhode
