// SPDX-License-Identifier: MIT
#include "film/prepared_film.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "film/film_metadata.h"
#include "film/film_plots.h"
#include "film/small_films.h"
#include "scene/scene_file.h"
#include "support/logged.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::plan_of;
using test::small_scene;

// what a film logs before it is drawn
std::string warnings_of(const Scene& scene) {
  const PreparedFilm film(plan_of(scene));
  return test::logged_by([&] { film.warn(); });
}

TEST(PreparedFilm, KnowsMotionTimesAndPanels) {
  const PreparedFilm film(plan_of(small_scene()));
  EXPECT_EQ(film.solved().simulation.report.method, "exact");
  EXPECT_EQ(film.frames().count, 10);
  EXPECT_EQ(film.film().panels().size(), 1U);
  EXPECT_EQ(film.comparison(), nullptr);
  EXPECT_EQ(film.shutter().open_s(), 0.0);
  EXPECT_EQ(film.shutter().moments(), 1);
}

TEST(PreparedFilm, ShowsTheRangeThatIsAskedFor) {
  RenderPlan plan = plan_of(small_scene());
  plan.range.from = 0.3;
  EXPECT_EQ(PreparedFilm(plan).frames().count, 7);
}

TEST(PreparedFilm, ComparesTheMethodsThatAreAskedForFrameByFrame) {
  const Scene scene =
      small_scene("[numerics]\ncompare = [\"explicit_euler\", \"exact\"]\nstep = 0.05\n");
  const PreparedFilm film(plan_of(scene));
  ASSERT_NE(film.comparison(), nullptr);
  EXPECT_EQ(film.film().panels().size(), 2U);
  // found at the times of frames
  const Contender& euler = film.comparison()->contenders()[0];
  ASSERT_TRUE(euler.untrusted_from);
  const double frames = *euler.untrusted_from * 10.0;
  EXPECT_NEAR(frames, std::round(frames), 1e-9);
}

// from one picture to the next the body turns by at most 3.4 degrees
TEST(PreparedFilm, AnOpenShutterHasAsManyMomentsAsTheTurnNeeds) {
  Scene scene = small_scene("shutter_deg = 180\n");
  scene.motion.spin.body = Vec3(0.0, 0.0, 10.0);
  const PreparedFilm film(plan_of(scene));
  EXPECT_DOUBLE_EQ(film.shutter().open_s(), 0.05) << "half of a tenth of a second";
  EXPECT_EQ(film.shutter().moments(), 9) << "half a radian in steps of 0.06";
  scene.video.time_scale = 10.0;
  EXPECT_EQ(PreparedFilm(plan_of(scene)).shutter().moments(), 48) << "the most";
  scene.motion.spin.body = Vec3(0.0, 0.0, 0.001);
  EXPECT_EQ(PreparedFilm(plan_of(scene)).shutter().moments(), 4) << "the least";
}

// however slow a film is, its clock is seen to go
TEST(PreparedFilm, ClocksHaveTheDigitsThatTheirFilmsNeed) {
  const auto clock = [](double time_scale) {
    Scene scene = small_scene();
    scene.video.time_scale = time_scale;
    scene.motion.duration = time_scale;
    RenderPlan plan = plan_of(scene);
    plan.text = true;
    for (const PlacedText& text : PreparedFilm(plan).film().placed(0.5).texts)
      if (text.role == TextRole::clock) return text.markup;
    return std::string();
  };
  EXPECT_EQ(clock(1.0), "<i>t</i> = 0.50 s");
  EXPECT_EQ(clock(0.999), "<i>t</i> = 0.50 s") << "as in life";
  EXPECT_EQ(clock(0.05), "<i>t</i> = 0.03 s   20× slower");
  EXPECT_EQ(clock(0.002), "<i>t</i> = 0.0010 s   500× slower");
  EXPECT_EQ(clock(1e-6), "<i>t</i> = 0.0000005 s   1000000× slower");
  EXPECT_EQ(clock(1500.0), "<i>t</i> = 0.21 hours   0.417 hours a second");
}

Scene twice_in_turn(const Scene& scene) {
  ScenePanel panel;
  panel.scene = scene;
  Scene film = scene;
  film.panels = {panel, panel};
  film.in_turn = true;
  return film;
}

// where an open shutter closes
TEST(PreparedFilm, KnowsItsCuts) {
  const std::string shots =
      "[[shots]]\nat = 0.47\ndirection = [1, 0, 0]\n"
      "[[shots]]\nat = 0.7\nmove = 0.1\ndirection = [0, 1, 0]\n";
  Scene scene = small_scene(shots);
  const PreparedFilm cut(plan_of(scene));
  EXPECT_DOUBLE_EQ(cut.film().next_cut(0.4), 0.47);
  EXPECT_TRUE(std::isinf(cut.film().next_cut(0.47))) << "the camera moves";
  scene = twice_in_turn(scene);
  const PreparedFilm turns(plan_of(scene));
  EXPECT_DOUBLE_EQ(turns.film().next_cut(0.5), 1.0);
  EXPECT_DOUBLE_EQ(turns.film().next_cut(1.2), 1.47);
  EXPECT_TRUE(std::isinf(turns.film().next_cut(1.5)));
}

TEST(PreparedFilm, ShotsAreChaptersInEachPanelInTurn) {
  const Scene scene = twice_in_turn(
      small_scene("[[shots]]\nat = 0.4\nname = \"from above\"\ndirection = [0, 0, 1]\n"));
  const PreparedFilm turns(plan_of(scene));
  std::vector<int> starts;
  for (const auto& chapter : film_metadata(scene, scene.story, turns.frames()).chapters)
    if (chapter.title == "from above") starts.push_back(chapter.start);
  EXPECT_EQ(starts, (std::vector<int>{4, 14}));
}

TEST(PreparedFilm, PanelsInTurnAreChaptersWhateverTheStorySays) {
  Scene scene = twice_in_turn(small_scene("[[story]]\nat = 0\ncaption = \"start\"\n"));
  scene.panels[0].caption = "one";
  scene.panels[1].caption = "two";
  const PreparedFilm turns(plan_of(scene));
  const auto chapters = film_metadata(scene, scene.story, turns.frames()).chapters;
  ASSERT_EQ(chapters.size(), 2u);
  EXPECT_EQ(chapters[0].title, "one");
  EXPECT_EQ(chapters[1].title, "two");
  EXPECT_EQ(chapters[1].start, 10);
}

// each panel in turn begins without the words with which the one before has ended
TEST(PreparedFilm, PanelsInTurnBeginTheirStoryAnew) {
  Scene scene = small_scene("[[story]]\nat = 0.8\ncaption = \"late\"\n");
  scene = twice_in_turn(scene);
  RenderPlan plan = plan_of(scene);
  plan.text = true;
  const PreparedFilm turns(plan);
  const auto words = [&](double film) {
    std::string found;
    for (const PlacedText& text : turns.film().placed(film).texts)
      if (text.role == TextRole::caption) found += text.markup;
    return found;
  };
  EXPECT_EQ(words(0.9), "late");
  EXPECT_EQ(words(1.05), "");
  EXPECT_EQ(words(1.9), "late");
  const FilmMetadata told = film_metadata(scene, scene.story, turns.frames());
  ASSERT_EQ(told.captions.size(), 2U);
  EXPECT_EQ(told.captions[0].end, 10);
}

// a spin of whole turns between 48 equal steps would stand still, blurred as it is
TEST(PreparedFilm, MomentsOfAFastSpinAreSpread) {
  Scene scene = small_scene("shutter_deg = 360\n");
  scene.motion.spin.body = Vec3(0.0, 0.0, 2.0 * kPi * 480.0);  // 48 turns in a tenth of a second
  const PreparedFilm film(plan_of(scene));
  ASSERT_EQ(film.shutter().moments(), 48);
  std::vector<double> turns;
  for (int k = 0; k < 48; ++k) {
    EXPECT_GE(film.shutter().moment(k), k / 480.0);
    EXPECT_LT(film.shutter().moment(k), (k + 1) / 480.0);
    turns.push_back(std::fmod(480.0 * film.shutter().moment(k), 1.0));
  }
  std::sort(turns.begin(), turns.end());
  for (std::size_t k = 1; k < turns.size(); ++k)
    EXPECT_LT(turns[k] - turns[k - 1], 0.06);
}

TEST(PreparedFilm, AnOpenShutterFollowsWhatFliesAndTheCamera) {
  Scene scene = small_scene("shutter_deg = 360\n");
  scene.motion.spin.body = Vec3::Zero();
  scene.motion.velocity = Vec3(3.0, 0.0, 0.0);
  scene.camera.follow = "none";
  EXPECT_GT(PreparedFilm(plan_of(scene)).shutter().moments(), 15);
  scene.motion.velocity = Vec3::Zero();
  EXPECT_EQ(PreparedFilm(plan_of(scene)).shutter().moments(), 4);
  scene.camera.orbit = 4.0;
  EXPECT_GT(PreparedFilm(plan_of(scene)).shutter().moments(), 15);
}

// the wheels of coaches: more than half a turn from frame to frame
TEST(PreparedFilm, WarnsOfABodyThatSeemsToTurnBackwards) {
  Scene scene = small_scene();
  EXPECT_EQ(warnings_of(scene), "");
  scene.motion.spin.body = Vec3(0.0, 0.0, 40.0);
  const std::string words = warnings_of(scene);
  EXPECT_NE(words.find("scene.toml:11: video.fps: "), std::string::npos) << words;
  EXPECT_NE(words.find("video.shutter_deg = 360"), std::string::npos) << words;
  scene.video.shutter = 2.0 * kPi;
  EXPECT_EQ(warnings_of(scene), "") << "what is blurred has no direction";
}

// With its centre at rest, the contact of a disc of the radius a runs round at
// sqrt(4 g / (a sin(tilt))), 55.2 rad/s at first and 6 % more after 0.3 s: by half a turn
// in 0.0569 s. The body itself hardly turns.
TEST(PreparedFilm, WarnsOfAContactThatRunsRoundTooFast) {
  Scene scene = load_scene(test::scene_path("euler_disc"));
  scene.motion.duration = 0.3;
  scene.story.clear();
  scene.show.plots.clear();
  scene.video.time_scale = 1.0;
  scene.video.fps = {187, 10};
  EXPECT_EQ(warnings_of(scene), "");
  scene.video.fps = {174, 10};
  const std::string words = warnings_of(scene);
  EXPECT_NE(words.find("from 0 s on the contact runs round"), std::string::npos) << words;
  EXPECT_NE(words.find("at most 0.916"), std::string::npos) << words;
  scene.show.asked["contact"] = false;
  EXPECT_EQ(warnings_of(scene), "") << "nothing runs";
}

// rolling takes energy and tilt, so that the contact runs ever faster, and needs ever more
// friction; the story hides it before its rate is half a turn in a frame, and friction half of the
// weight
TEST(PreparedFilm, EulersDiscHidesItsContactBeforeItFlickers) {
  Scene scene = load_scene(test::scene_path("euler_disc"));
  scene.show.plots.clear();
  const PreparedFilm film(plan_of(scene));
  EXPECT_EQ(test::logged_by([&] { film.warn(); }), "");
  const double film_second = scene.video.time_scale;  // s of motion
  const double hidden = scene.story.front().at + 0.5 * film_second;
  const Motion& motion = film.solved().simulation.motion;
  const double tilt = std::acos((motion.at(hidden).q_SB * Vec3::UnitZ()).z());
  const double rate = std::sqrt(4.0 * 9.80665 / (0.0375 * std::sin(tilt)));
  EXPECT_LT(rate * film_second / 60.0, kPi);
  const Reaction reaction = reaction_at(motion, hidden).value();
  EXPECT_LT(reaction.friction_S.norm(), 0.55 * reaction.normal);
  EXPECT_GT(reaction.friction_S.norm(), 0.45 * reaction.normal) << "but not long before";
}

TEST(PreparedFilm, WarnsOfASlipThatTheMethodDoesNotTell) {
  Scene scene = load_scene(test::scene_path("tippe_top"));
  scene.motion.duration = 0.05;
  scene.story.clear();
  scene.show.plots.clear();
  scene.video.time_scale = 0.1;
  scene.show.asked["slip"] = true;
  EXPECT_EQ(warnings_of(scene), "");
  scene.numerics.method = "table_rk4";
  scene.numerics.step = 1e-4;
  const char* untold = "show.slip: shows nothing: only the method dop853";
  EXPECT_NE(warnings_of(scene).find(untold), std::string::npos);
  // one of the panels shows it
  scene.numerics.compare = {"table_rk4", "dop853"};
  EXPECT_EQ(warnings_of(scene).find(untold), std::string::npos);
  scene.numerics.compare = {"table_rk4"};
  EXPECT_NE(warnings_of(scene).find(untold), std::string::npos);
}

TEST(PreparedFilm, WarnsOfALoopThatDoesNotClose) {
  Scene scene = small_scene("loop = true\n");
  scene.motion.spin.body = Vec3(0.0, 0.0, 10.0);
  EXPECT_EQ(warnings_of(scene), "");
  scene.motion.spin.body = Vec3(0.0, 0.0, 1.0);
  EXPECT_NE(warnings_of(scene).find("returns to its start only to within"), std::string::npos);
}

TEST(PreparedFilm, WarnsOfAPartOfALoop) {
  Scene scene = small_scene("loop = true\n");
  scene.motion.spin.body = Vec3(0.0, 0.0, 10.0);
  RenderPlan plan = plan_of(scene);
  const auto said = [&] {
    const PreparedFilm film(plan);
    return test::logged_by([&] { film.warn(); });
  };
  plan.range.from = 0.0;
  EXPECT_EQ(said(), "");
  plan.range.to = 0.3;
  EXPECT_NE(said().find("the film shows 0 to 0.3 s of a loop of 0.6283 s, so it jumps"),
            std::string::npos);
  plan.range = {{}, {}, 0.3, true};
  EXPECT_EQ(said(), "") << "a picture repeats nothing";
}

TEST(PreparedFilm, WarnsOfAShortLoopWhoseClockIsStretched) {
  Scene scene = small_scene("loop = true\n");
  scene.video.fps = {60, 1};
  const double turns_per_s = 40.0;  // one and a half frames
  scene.motion.spin.body = Vec3(0.0, 0.0, 2.0 * kPi * turns_per_s);
  const PreparedFilm film(plan_of(scene));
  const double faster = (1.0 / turns_per_s) / (film.frames().count / 60.0);
  EXPECT_GT(std::abs(faster - 1.0), 0.2);
  const std::string said = test::logged_by([&] { film.warn(); });
  EXPECT_NE(said.find(fmt::format("shown {:.3g} times as fast", faster)), std::string::npos)
      << said;
}

// what begins anew with each round is told, and a loop without any of it has no warning
TEST(PreparedFilm, WarnsOfLoopsThatShowWhereTheyRepeat) {
  Scene scene = small_scene("loop = true\n");
  scene.motion.spin.body = Vec3(0.0, 0.0, 10.0);
  ASSERT_EQ(warnings_of(scene), "");
  Scene orbits = scene;
  orbits.camera.orbit = 1.0;
  EXPECT_NE(warnings_of(orbits).find("the camera is not where it was"), std::string::npos);
  Scene cut = small_scene("loop = true\n[[shots]]\nat = 0.1\ntarget = [0.2, 0, 0]\n");
  cut.motion.spin.body = scene.motion.spin.body;
  EXPECT_NE(warnings_of(cut).find("the camera is not where it was"), std::string::npos)
      << "the body stays where it is, and the second shot sees it elsewhere";
  Scene flies = scene;
  flies.motion.velocity = Vec3(0.3, 0.0, 0.0);
  flies.camera.follow = "none";
  EXPECT_NE(warnings_of(flies).find("pixels from its start"), std::string::npos)
      << warnings_of(flies);
  Scene traced = scene;
  traced.show.plots = {"omega"};
  traced.show["trail"] = true;
  EXPECT_NE(warnings_of(traced).find("a jump: paths, plots"), std::string::npos);
  Scene followed = scene;
  followed.show["ghosts"] = true;
  EXPECT_NE(warnings_of(followed).find("a jump: ghosts"), std::string::npos);
  Scene told = scene;
  StoryStep step;
  step.at = 0.1;
  step.caption = "It turns";
  told.story = {step};
  EXPECT_NE(warnings_of(told).find("a jump: captions"), std::string::npos);
  step.caption.reset();
  step.hide = {"body"};
  told.story = {step};
  EXPECT_NE(warnings_of(told).find("a jump: what the story shows or hides"), std::string::npos);
  // a satellite that is back, while the Earth is elsewhere
  Scene round = scene;
  LoadSpec gradient;
  gradient.kind = "gravity_gradient";
  gradient.rate = 1.0;
  round.body.solid.reset();
  round.body.moments = Vec3(1.0, 1.0, 1.5);
  round.motion.torque = {gradient};
  round.motion.attitude = {};
  EXPECT_NE(warnings_of(round).find("loads that depend on time"), std::string::npos)
      << warnings_of(round);
}

// lengths of arrows, axes of plots and warnings are of what is seen: a load after it plays no part
TEST(PreparedFilm, OfALoopIsOfOneRound) {
  Scene scene = small_scene("loop = true\n");
  scene.motion.spin.body = Vec3(0.0, 0.0, 10.0);  // once round in 0.628 s
  scene.show.plots = {"omega"};
  const auto scale = [](const PreparedFilm& film) {
    return film.film().panels().front().composer->scenery().scale.omega;
  };
  const PreparedFilm alone(plan_of(scene));
  LoadSpec load;
  load.kind = "constant";
  load.body = Vec3(0.0, 0.0, 1e4 * alone.solved().model.moments.maxCoeff());
  load.from = 0.8;
  scene.motion.torque = {load};
  const PreparedFilm film(plan_of(scene));
  EXPECT_NEAR(scale(film), scale(alone), 1e-9 * scale(alone));
  EXPECT_NEAR(make_charts(film.all_solved()).plots.front().ends, 2.0 * kPi / 10.0, 1e-6);
  const std::string said = test::logged_by([&] { film.warn(); });
  EXPECT_NE(said.find("the motion ends before it, at 0.6283 s"), std::string::npos) << said;
}

// ten frames of one second: the last is at 0.9 s
TEST(PreparedFilm, WarnsOfWhatComesAfterTheLastFrame) {
  for (const double at : {0.9, 0.95}) {
    Scene scene = small_scene();
    StoryStep step;
    step.at = at;
    step.caption = "At last";
    scene.story = {step};
    ShotSpec shot;
    shot.at = at;
    shot.camera.direction = Vec3(1.0, 1.0, 1.0);
    scene.shots = {shot};
    const std::string said = warnings_of(scene);
    for (const char* key : {"story[0].at: is never seen", "shots[0].at: is never seen"})
      EXPECT_EQ(said.find(key) != std::string::npos, at > 0.9) << said;
    scene.story.front().hold = 1.0;
    EXPECT_EQ(warnings_of(scene).find("story[0].at"), std::string::npos);
  }
}

// ten frames a second: none is between 0.21 and 0.29 s
TEST(PreparedFilm, WarnsOfWordsThatNoFrameShows) {
  for (const double until : {0.29, 0.31}) {
    Scene scene = small_scene();
    StoryStep next, first;
    next.at = until;
    next.caption = "Next";
    first.at = 0.21;
    first.caption = "First";
    scene.story = {next, first};
    EXPECT_EQ(warnings_of(scene).find("story[1].caption: is never seen") != std::string::npos,
              until < 0.3)
        << warnings_of(scene);
  }
}

TEST(PreparedFilm, WarnsOfStoriesThatShowWhatNeverAppears) {
  Scene scene = small_scene();
  StoryStep step;
  step.show = {"contact"};
  scene.story = {step};
  EXPECT_NE(warnings_of(scene).find("story[0].show: 'contact' will not appear: it needs a body on"),
            std::string::npos)
      << warnings_of(scene);
  scene.story.front().show = {"ellipsoid"};
  EXPECT_NE(warnings_of(scene).find("it needs show.ellipsoid = true"), std::string::npos);
  scene.show["ellipsoid"] = true;
  EXPECT_EQ(warnings_of(scene), "");
}

// a letter of no script has no font anywhere
TEST(PreparedFilm, WarnsOfLettersThatNoFontHas) {
  RenderPlan plan = plan_of(small_scene());
  plan.text = true;
  plan.scene.show.caption = "from \xCE\xA9 to L, slowly";
  const auto warnings = [&] {
    const PreparedFilm film(plan);
    return test::logged_by([&] { film.warn(); });
  };
  EXPECT_EQ(warnings().find("no font here has"), std::string::npos);
  plan.scene.show.caption = "from \xF3\xBF\xBF\xBD to L";  // U+FFFFD, of private use
  EXPECT_NE(warnings().find("show.caption: no font here has 1 of the letters"), std::string::npos);
  plan.scene = twice_in_turn(small_scene());
  plan.scene.panels[1].caption = "\xF3\xBF\xBF\xBD";
  EXPECT_NE(warnings().find("caption of its panel: no font here has 1 of the letters"),
            std::string::npos)
      << warnings();
}

TEST(PreparedFilm, WarnsOfShotsThatNobodySees) {
  Scene scene = small_scene();
  ShotSpec shot;
  shot.at = 0.5;
  shot.move = 0.1;
  scene.shots = {shot};
  EXPECT_EQ(warnings_of(scene), "");
  scene.shots.push_back(shot);
  EXPECT_NE(warnings_of(scene).find("shots[0].at: another shot begins at the same time"),
            std::string::npos);
  scene.shots = {shot};
  scene.shots.front().move = 100.0;
  EXPECT_NE(warnings_of(scene).find("shots[0].move: the camera needs 100 s"), std::string::npos);
}

TEST(PreparedFilm, BadStoriesAndShotsAreOneLineWithTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"[[story]]\nat = 9\n", "story[0].at"},
      {"[[story]]\nat = 1\nshow = [\"omga\"]\n", "did you mean 'omega'?"},
      {"[[shots]]\nat = 1\nfollow = \"me\"\n", "follow"},
      {"[[shots]]\nmove = 1\n", "at"},
      {"[show]\nplots = [\"tlt\"]\n", "did you mean 'tilt'?"},
      {"[numerics]\ncompare = [\"rk4\", \"exact\"]\nstep = 0.1\n[show]\nplots = [\"tilt\"]\n",
       "compared"},
      {"[video]\nshutter_deg = 400\n", "shutter"},
      {"[numerics]\ncompare = [\"rk44\"]\n", "did you mean 'rk4'?"},
      {"[numerics]\ncompare = []\n", "compare"},
  };
  const std::string body =
      "[body]\nmoments = [1, 2, 2.5]\n[motion]\nduration = 2\nspin = { body = [1, 0, 1] }\n";
  for (const auto& [text, words] : cases) {
    SCOPED_TRACE(text);
    try {
      const Scene scene = parse_scene(body + text, "scene.toml");
      const PreparedFilm film(plan_of(scene));
      FAIL() << "was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("scene.toml:"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace polhode
