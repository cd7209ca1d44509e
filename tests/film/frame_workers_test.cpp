// SPDX-License-Identifier: MIT
#include "film/frame_workers.h"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "film/small_films.h"
#include "video/plain_sinks.h"

namespace polhode {
namespace {

// A process of its own for each case, begun anew: OpenGL that another case has opened here would
// not come along into processes that are forked.
class FrameWorkersTest : public ::testing::Test {
 protected:
  FrameWorkersTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

// the child's own check; what it says is the message of the test that fails
void require(bool holds, const char* words) {
  if (holds) return;
  std::fputs(words, stderr);
  std::exit(1);
}

std::vector<std::string> hashes_by(int jobs,
                                   const PreparedFilm& film,
                                   const std::vector<int>& frames,
                                   DrawingTimes* times = nullptr) {
  RenderSetup setup;
  setup.jobs = jobs;
  const std::unique_ptr<FrameRenderer> renderer = open_frame_renderer(film, setup, frames);
  require(!renderer->info().gl_renderer.empty(), "nothing is known of the renderer");
  std::vector<std::string> hashes;
  Image image;
  for (const int frame : frames) {
    renderer->render(frame, image);
    hashes.push_back(frame_hash(image));
  }
  if (times != nullptr) *times = renderer->times();
  return hashes;
}

TEST_F(FrameWorkersTest, PixelsDoNotDependOnTheNumberOfJobs) {
  const auto check = [] {
    const PreparedFilm film(test::plan_of(test::small_scene()));
    const std::vector<int> frames = {0, 2, 3, 5, 9};
    const std::vector<std::string> by_two = hashes_by(2, film, frames);
    const std::vector<std::string> here = hashes_by(1, film, frames);
    require(by_two == here, "two processes draw other pixels");
    require(std::adjacent_find(here.begin(), here.end()) == here.end(), "frames are alike");
    std::exit(0);
  };
  EXPECT_EXIT(check(), ::testing::ExitedWithCode(0), "");
}

// more jobs than frames, and no frame at all, are fine
TEST_F(FrameWorkersTest, JobsWithoutAFrameAreNotStarted) {
  const auto check = [] {
    const PreparedFilm film(test::plan_of(test::small_scene()));
    require(hashes_by(8, film, {5}).size() == 1, "one frame by eight");
    require(hashes_by(2, film, {}).empty(), "no frame by two");
    std::exit(0);
  };
  EXPECT_EXIT(check(), ::testing::ExitedWithCode(0), "");
}

TEST_F(FrameWorkersTest, TimesAreThoseOfAllProcesses) {
  const auto check = [] {
    const PreparedFilm film(test::plan_of(test::small_scene()));
    DrawingTimes times;
    hashes_by(2, film, {0, 1, 2, 3}, &times);
    require(times.compose.wall_s > 0.0, "no time to compose");
    require(times.render.draw.wall_s > 0.0, "no time to draw");
    require(times.render.read_back.wall_s > 0.0, "no time to read back");
    std::exit(0);
  };
  EXPECT_EXIT(check(), ::testing::ExitedWithCode(0), "");
}

// the order was promised when the processes began
TEST_F(FrameWorkersTest, FramesInAnotherOrderBreakAPromise) {
  const auto check = [] {
    const PreparedFilm film(test::plan_of(test::small_scene()));
    RenderSetup setup;
    setup.jobs = 2;
    const auto renderer = open_frame_renderer(film, setup, {0, 1, 2});
    Image image;
    renderer->render(1, image);
  };
  EXPECT_DEATH(check(), "");
}

TEST_F(FrameWorkersTest, AnUnknownBackEndIsAnErrorHere) {
  const auto check = [] {
    const PreparedFilm film(test::plan_of(test::small_scene()));
    RenderSetup setup;
    setup.jobs = 2;
    setup.backend = "osmsea";
    const std::string message = test::message_of([&] {
      Image image;
      open_frame_renderer(film, setup, {0, 1})->render(0, image);
    });
    require(message.find("did you mean 'osmesa'?") != std::string::npos, message.c_str());
    std::exit(0);
  };
  EXPECT_EXIT(check(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace polhode
