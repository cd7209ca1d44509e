// SPDX-License-Identifier: MIT
#include "film/local_renderer.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "film/small_films.h"
#include "image/compare.h"
#include "scene/scene_file.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::plan_of;
using test::small_scene;

// one frame of a film
Image frame_of(const PreparedFilm& film, int index, const RenderSetup& setup = {}) {
  Image image;
  open_local_renderer(film, setup)->render(index, image);
  return image;
}

// as the film says for that moment, drawn by hand
TEST(LocalRenderer, AFrameIsTheFilmAtItsTime) {
  const PreparedFilm film(plan_of(small_scene()));
  Image drawn, expected;
  {
    const std::unique_ptr<Context> context = open_context("auto");
    Renderer renderer(*context, {64, 48, 4, false});
    renderer.draw(film.film().at(0.7), expected);
  }
  drawn = frame_of(film, 7);
  EXPECT_EQ(drawn.width, 64);
  EXPECT_EQ(drawn.height, 48);
  EXPECT_EQ(drawn.pixels, expected.pixels);
}

TEST(LocalRenderer, FramesComeInAnyOrderIntoTheSameBuffer) {
  const PreparedFilm film(plan_of(small_scene()));
  const std::unique_ptr<FrameRenderer> renderer = open_local_renderer(film, {});
  Image first, other, again;
  renderer->render(2, first);
  renderer->render(9, other);
  EXPECT_NE(first.pixels, other.pixels);
  renderer->render(2, other);
  EXPECT_EQ(first.pixels, other.pixels);
}

TEST(LocalRenderer, TellsWhatDrawsAndHowLongItTook) {
  const PreparedFilm film(plan_of(small_scene()));
  const std::unique_ptr<FrameRenderer> renderer = open_local_renderer(film, {});
  EXPECT_FALSE(renderer->info().backend.empty());
  EXPECT_FALSE(renderer->info().gl_renderer.empty());
  EXPECT_EQ(renderer->times().compose.wall_s, 0.0);
  Image image;
  renderer->render(0, image);
  EXPECT_GT(renderer->times().compose.wall_s, 0.0);
  EXPECT_GT(renderer->times().render.draw.wall_s, 0.0);
}

TEST(LocalRenderer, ATransparentFilmHasNoGround) {
  const PreparedFilm film(plan_of(small_scene()));
  RenderSetup clear;
  clear.transparent = true;
  EXPECT_EQ(frame_of(film, 0).at(1, 1)[3], 255);
  EXPECT_EQ(frame_of(film, 0, clear).at(1, 1)[3], 0);
}

TEST(LocalRenderer, AnUnknownBackEndIsRefused) {
  const PreparedFilm film(plan_of(small_scene()));
  RenderSetup wrong;
  wrong.backend = "osmsea";
  EXPECT_NE(test::message_of([&] { open_local_renderer(film, wrong); }).find("'osmesa'"),
            std::string::npos);
}

const std::string kSpinning = R"(
[body]
solid = { kind = "disc", radius_cm = 10, thickness_cm = 1, mass = 1 }
[motion]
duration = 2
spin = { body = [0, 0, 60] }
[camera]
direction = [0, 0.01, 1]
[show]
labels = false
space_axes = false
omega = false
momentum = false
[video]
size = "320x180"
)";

Image spinning_disc(const std::string& more) {
  RenderPlan plan = plan_of(parse_scene(kSpinning + more, "scene.toml"));
  plan.text = true;
  return frame_of(PreparedFilm(plan), 30);
}

// a sixtieth of a second of shutter at ten turns a second: the stripe is spread round the disc
TEST(LocalRenderer, AnOpenShutterSpreadsWhatMovesAndNothingElse) {
  const Image sharp = spinning_disc("");
  const Image blurred = spinning_disc("shutter_deg = 360\n");
  const auto reddest = [](const Image& image) {
    int most = 0;
    for (int x = 0; x < image.width; ++x) {
      for (int y = 0; y < image.height; ++y) {
        // in the middle the stripe is as wide as its circle
        if (std::hypot(x - image.width / 2, y - image.height / 2) < 40.0) continue;
        most = std::max(most, image.at(x, y)[0] - image.at(x, y)[1]);
      }
    }
    return most;
  };
  EXPECT_GT(reddest(sharp), 90);
  EXPECT_LT(reddest(blurred), 60);
  // the clock stands still on a ground that is as it was
  int clock = 0;
  for (int x = 270; x < 320; ++x) {
    for (int y = 160; y < 180; ++y) {
      EXPECT_TRUE(std::equal(sharp.at(x, y), sharp.at(x, y) + 4, blurred.at(x, y)));
      clock += std::equal(sharp.at(x, y), sharp.at(x, y) + 3, sharp.at(0, 0)) ? 0 : 1;
    }
  }
  EXPECT_GT(clock, 50);
}

// the last frame of a loop is one step before its first
TEST(LocalRenderer, AClosedLoopGoesOnWithItsFirstFrame) {
  Scene scene = load_scene(test::scene_path("closed_loop"));
  scene.video.size = {160, 90};
  scene.video.fps = {12, 1};
  const PreparedFilm film(plan_of(scene));
  const auto apart = [&](int i, int k) {
    return compare(frame_of(film, i), frame_of(film, k), 3).rms;
  };
  EXPECT_LT(apart(film.frames().count - 1, 0), 2.0 * apart(1, 2));
}

}  // namespace
}  // namespace polhode
