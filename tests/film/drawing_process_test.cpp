// SPDX-License-Identifier: MIT
#include "film/drawing_process.h"

#include <csignal>
#include <numeric>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "base/error.h"
#include "film/drawn_frames.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::number_of;
using test::NumberedFrames;

constexpr PictureSize kPaper{32, 24};

std::unique_ptr<FrameRenderer> open_paper() {
  return std::make_unique<NumberedFrames>(kPaper);
}

// what `Draw::draw` does to a frame is done in the other process
template <class Draw>
class DrawnBy final : public NumberedFrames {
 public:
  explicit DrawnBy(Draw draw) : NumberedFrames(kPaper), draw_(std::move(draw)) {}
  void render(int index, Image& image) override {
    NumberedFrames::render(index, image);
    draw_(index, image);
  }

 private:
  Draw draw_;
};

template <class Draw>
DrawingProcess process_that(const std::vector<int>& frames, Draw draw) {
  return {kPaper, frames, [draw] {
            return std::make_unique<DrawnBy<Draw>>(draw);
          }};
}

// more frames than may be ahead, in any order
TEST(DrawingProcess, GivesItsFramesInTheirOrder) {
  const std::vector<int> frames = {7, 3, 3, 200, 0, 9, 4, 1};
  DrawingProcess process(kPaper, frames, open_paper);
  Image image;
  for (const int frame : frames) {
    process.next(image);
    EXPECT_EQ(image.width, 32);
    EXPECT_EQ(image.height, 24);
    EXPECT_EQ(number_of(image), frame);
  }
}

TEST(DrawingProcess, TellsWhatDrawsThereAndHowLongItTook) {
  DrawingProcess process(kPaper, {1, 2, 3}, open_paper);
  const RendererInfo& info = process.info();
  EXPECT_EQ(info.backend, "paper");
  EXPECT_EQ(info.gl_renderer, "by hand");
  EXPECT_EQ(info.gl_version, "0.1");
  EXPECT_EQ(info.samples, 3);
  EXPECT_TRUE(info.by_outlines);
  Image image;
  process.next(image);
  process.next(image);
  EXPECT_EQ(process.times().compose.wall_s, 2.0);
  EXPECT_EQ(process.times().render.draw.cpu_s, 8.0);
  EXPECT_EQ(process.times().render.smooth.cpu_s, 16.0);
}

// with a ground, only what differs from it is handed over; it must arrive all the same
TEST(DrawingProcess, PicturesArriveWithTheirGroundAndBoxes) {
  const auto paint = [](int index, Image& image) {
    const PixelBox box{2, 3, 4, 5};
    image.fill(box, {9, static_cast<std::uint8_t>(index), 7, 6});
    image.painted = {box};
    if (index == 2) {
      image.fill({0, 0, 32, 24}, {1, 2, 3, 4});
      image.ground.reset();
      image.painted.clear();
    }
  };
  DrawingProcess process = process_that({1, 2, 3}, paint);
  Image image;
  for (const int index : {1, 2, 3}) {
    Image expected;
    NumberedFrames(kPaper).render(index, expected);
    paint(index, expected);
    process.next(image);
    EXPECT_EQ(image.pixels, expected.pixels) << index;
    EXPECT_EQ(image.ground, expected.ground) << index;
    EXPECT_EQ(image.painted.size(), expected.painted.size()) << index;
  }
}

// boxes that overlap may have more pixels than the picture, or be too many
TEST(DrawingProcess, PicturesOfManyBoxesArriveWhole) {
  for (const int boxes : {2, 300}) {
    DrawingProcess process = process_that({5}, [=](int, Image& image) {
      image.painted.assign(static_cast<std::size_t>(boxes),
                           boxes == 2 ? PixelBox{0, 0, 32, 24} : PixelBox{1, 1, 1, 1});
      image.at(1, 1)[0] = 77;
    });
    Image image;
    process.next(image);
    EXPECT_EQ(image.at(1, 1)[0], 77) << boxes;
    EXPECT_EQ(image.at(31, 23)[0], 5) << boxes;
  }
}

TEST(DrawingProcess, AnErrorArrivesWithItsFaultAndPlace) {
  DrawingProcess process = process_that({1, 2}, [](int index, Image&) {
    if (index == 2) throw Error(Fault::check_failed, "no number", {"scene.toml", 7, "body.mass"});
  });
  Image image;
  process.next(image);
  try {
    process.next(image);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::check_failed);
    EXPECT_STREQ(error.what(), "scene.toml:7: body.mass: no number");
    EXPECT_EQ(error.place().line, 7);
  }
}

TEST(DrawingProcess, WhatCannotBeOpenedIsAnErrorOfTheFirstLook) {
  DrawingProcess process(
      kPaper, {1}, []() -> std::unique_ptr<FrameRenderer> { throw environment_error("no GL"); });
  test::expect_error([&] { process.info(); }, Fault::environment, "", "no GL");
  DrawingProcess other(
      kPaper, {1}, []() -> std::unique_ptr<FrameRenderer> { throw std::logic_error("odd"); });
  test::expect_error([&] { other.info(); }, Fault::environment, "", "unexpected: odd");
  DrawingProcess full(
      kPaper, {1}, []() -> std::unique_ptr<FrameRenderer> { throw std::bad_alloc(); });
  test::expect_error([&] { full.info(); }, Fault::environment, "", "out of memory");
}

TEST(DrawingProcess, OneThatIsKilledOrEndsIsAnErrorOfTheEnvironment) {
  DrawingProcess killed = process_that({1}, [](int, Image&) { kill(getpid(), SIGKILL); });
  Image image;
  test::expect_error([&] { killed.next(image); }, Fault::environment, "", "ended by signal 9");
  DrawingProcess ended = process_that({1}, [](int, Image&) { _exit(4); });
  test::expect_error([&] { ended.next(image); }, Fault::environment, "", "exit code 4");
}

// one that nobody reads from waits, and ends with its object
TEST(DrawingProcess, EndsWithItsObject) {
  std::vector<int> many(1000);
  std::iota(many.begin(), many.end(), 0);
  const auto started = [&] {
    DrawingProcess process(kPaper, many, open_paper);
    process.info();
  };
  started();
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "it has been reaped";
}

}  // namespace
}  // namespace polhode
