// SPDX-License-Identifier: MIT
// Films as a viewer sees them: text that can be read, plots, loops, shutters.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/commands/render.h"
#include "film/film_panels.h"
#include "film/film_plots.h"
#include "film/frame_times.h"
#include "image/compare.h"
#include "image/png.h"
#include "support/run.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::scene_names;
using test::scene_path;

class WholeFilm : public ::testing::TestWithParam<std::string> {};

// at every moment of every film no text runs over another, and none leaves the frame
TEST_P(WholeFilm, TextNeverRunsOverText) {
  Scene scene = load_scene(scene_path(GetParam()));
  scene.video.size = {640, 360};
  const Solved solved = solve(scene);
  const FrameTimes frames = plan_frame_times(solved, {});
  std::unique_ptr<Comparison> comparison;
  if (!scene.numerics.compare.empty()) comparison = std::make_unique<Comparison>(solved, 0.1);
  const Film film = make_film(solved, frames.timeline, comparison.get(), make_plots(solved), true);
  const double duration = frames.timeline.film_duration();
  constexpr int kLooks = 120;
  for (int i = 0; i <= kLooks; ++i) {
    const double now = duration * i / kLooks;
    const std::vector<TextRoom> rooms = film.text_rooms(now);
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

// what is revealed of a plot ends at the clock's column, and what is behind it is as before
TEST(Plots, AreRevealedUpToNow) {
  Scene scene = load_scene(scene_path("nutation_plots"));
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

Image still(const std::string& scene_text, double t) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml", scene_text);
  RenderJob job;
  job.scene = folder / "scene.toml";
  job.output = folder / "still.png";
  job.overrides.size = "320x180";
  job.still = t;
  render_film(job);
  return read_png(job.output);
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
clock = false
space_axes = false
omega = false
momentum = false
[video]
)";

// half a second of shutter at 30 turns a second: the stripe is spread round the disc
TEST(Shutter, SpreadsWhatMoves) {
  const Image sharp = still(kSpinning, 0.5);
  const Image blurred = still(kSpinning + "shutter_deg = 360\n", 0.5);
  // the ground is as it was; the disc is not
  EXPECT_TRUE(std::equal(sharp.at(2, 2), sharp.at(2, 2) + 4, blurred.at(2, 2)));
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
}

// the last frame of a loop is one step before its first
TEST(LoopedFilm, EndsWhereItBegan) {
  const test::TemporaryFolder folder;
  RenderJob job;
  job.scene = scene_path("closed_loop");
  job.output = folder / "frame_%03d.png";
  job.overrides.size = "160x90";
  job.overrides.fps = "12";
  job.report = folder / "report.json";
  render_film(job);
  const nlohmann::json report = nlohmann::json::parse(test::read_text(job.report));
  EXPECT_NEAR(report["loop"]["duration_s"].get<double>(), 10.0, 5.01);
  EXPECT_LT(report["loop"]["residual_rad"].get<double>(), 0.035);
  const int count = report["frames"];
  const auto frame = [&](int i) {
    return read_png(folder / fmt::format("frame_{:03d}.png", i));
  };
  const double step = compare(frame(1), frame(2), 3).rms;
  EXPECT_LT(compare(frame(count - 1), frame(0), 3).rms, 2.0 * step);
}

TEST(FilmPlan, BadStoriesAndShotsAreOneLineWithTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"[[story]]\nat = 9\n", "story[0].at"},
      {"[[story]]\nat = 1\nshow = [\"omga\"]\n", "did you mean 'omega'?"},
      {"[[shots]]\nat = 1\nfollow = \"me\"\n", "follow"},
      {"[[shots]]\nmove = 1\n", "at"},
      {"[show]\nplots = [\"tlt\"]\n", "did you mean 'tilt'?"},
      {"[show]\nviews = [\"space\", \"body\"]\nplots = [\"tilt\"]\n", "with a single panel"},
      {"[video]\nshutter_deg = 400\n", "shutter"},
      {"[numerics]\ncompare = [\"rk44\"]\n", "did you mean 'rk4'?"},
      {"[numerics]\ncompare = []\n", "compare"},
  };
  const std::string body =
      "[body]\nmoments = [1, 2, 2.5]\n[motion]\nduration = 2\nspin = { body = [1, 0, 1] }\n";
  for (const auto& [text, words] : cases) {
    SCOPED_TRACE(text);
    try {
      still(body + text, 0.5);
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
