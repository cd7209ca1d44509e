// SPDX-License-Identifier: MIT
#include "film/output/open_output.h"

#include <numeric>

#include <gtest/gtest.h>

#include "film/drawn_frames.h"
#include "film/output/segments.h"
#include "film/small_films.h"
#include "video/film_reader.h"
#include "video/plain_sinks.h"

namespace polhode {
namespace {

using test::NumberedFrames;
using test::plan_of;
using test::small_scene;
using test::TemporaryFolder;

std::vector<int> frames_from(int first, int count) {
  std::vector<int> frames(static_cast<std::size_t>(count));
  std::iota(frames.begin(), frames.end(), first);
  return frames;
}

// the hashes of the frames of that number
std::vector<std::string> hashes_of(const std::vector<int>& frames) {
  NumberedFrames renderer({64, 48});
  std::vector<std::string> hashes;
  Image image;
  for (const int frame : frames) {
    renderer.render(frame, image);
    hashes.push_back(frame_hash(image));
  }
  return hashes;
}

TEST(OpenOutput, AWholeFilmHasAllFramesInTheirOrder) {
  const TemporaryFolder folder;
  const RenderPlan plan = plan_of(small_scene(), folder / "a.mp4");
  const std::unique_ptr<RenderOutput> output = open_output(plan, true);
  output->begin(PreparedFilm(plan));
  EXPECT_EQ(output->frames(), frames_from(0, 10));
  EXPECT_EQ(output->range().count, 10);
  EXPECT_EQ(output->already_there(), 0);
  NumberedFrames renderer({64, 48});
  std::vector<int> told;
  render_frames(*output, renderer, [&](const PipelineStep& step) { told.push_back(step.done); });
  EXPECT_EQ(renderer.drawn, frames_from(0, 10));
  EXPECT_EQ(output->hashes(), hashes_of(frames_from(0, 10)));
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back(), 10);

  FilmReader film(folder / "a.mp4");
  EXPECT_EQ(film.info().frames, 10);
  EXPECT_EQ(film.info().fps, (FrameRate{10, 1}));
  EXPECT_THROW(record_in(folder / "a.mp4"), Error) << "a whole film is no piece";
}

TEST(OpenOutput, AShardHasItsFramesAndSaysOfWhatItIsAPart) {
  const TemporaryFolder folder;
  RenderPlan plan = plan_of(small_scene(), folder / "a.mp4");
  plan.shard = Shard{2, 3};
  const std::unique_ptr<RenderOutput> output = open_output(plan, true);
  const PreparedFilm film(plan);
  output->begin(film);
  EXPECT_EQ(output->frames(), frames_from(3, 3));
  NumberedFrames renderer({64, 48});
  render_frames(*output, renderer, [](const PipelineStep&) {});
  EXPECT_EQ(output->hashes(), hashes_of({3, 4, 5}));
  const SegmentRecord record = record_in(folder / "a.mp4");
  EXPECT_EQ(record.shard.number, 2);
  EXPECT_EQ(record.shard.of, 3);
  EXPECT_EQ(record.range.first, 3);
  EXPECT_EQ(record.range.count, 3);
  EXPECT_EQ(record.film.frames, 10);
}

TEST(OpenOutput, AShardOfNothingIsRefused) {
  const TemporaryFolder folder;
  RenderPlan plan = plan_of(small_scene(), folder / "a.mp4");
  plan.shard = Shard{2, 11};
  const std::unique_ptr<RenderOutput> output = open_output(plan, false);
  EXPECT_NE(test::message_of([&] { output->begin(PreparedFilm(plan)); }).find("only 10 frames"),
            std::string::npos);
}

// a list of hashes is told the numbers of its frames in the film
TEST(OpenOutput, AShardOfHashesCountsFromItsOwnFirstFrame) {
  const TemporaryFolder folder;
  RenderPlan plan = plan_of(small_scene(), folder / "a.hash");
  plan.shard = Shard{2, 5};
  const std::unique_ptr<RenderOutput> output = open_output(plan, false);
  output->begin(PreparedFilm(plan));
  NumberedFrames renderer({64, 48});
  render_frames(*output, renderer, [](const PipelineStep&) {});
  EXPECT_EQ(test::read_text(folder / "a.hash").rfind("2 64x48 ", 0), 0U);
  EXPECT_TRUE(output->hashes().empty()) << "they were not asked for";
}

TEST(OpenOutput, AResumedFilmIsMadeOfSegments) {
  const TemporaryFolder folder;
  RenderPlan plan = plan_of(small_scene(), folder / "a.mp4");
  plan.resume = true;
  const std::unique_ptr<RenderOutput> output = open_output(plan, false);
  output->begin(PreparedFilm(plan));
  EXPECT_TRUE(std::filesystem::is_directory(folder / ".a.mp4.parts"));
}

// an error of the renderer stops the film, and nothing is left
TEST(OpenOutput, AFrameThatCannotBeDrawnLeavesNothing) {
  struct Broken final : NumberedFrames {
    using NumberedFrames::NumberedFrames;
    void render(int index, Image& image) override {
      if (index == 4) throw environment_error("no more memory");
      NumberedFrames::render(index, image);
    }
  };
  const TemporaryFolder folder;
  {
    const RenderPlan plan = plan_of(small_scene(), folder / "a.mp4");
    const std::unique_ptr<RenderOutput> output = open_output(plan, false);
    output->begin(PreparedFilm(plan));
    Broken renderer({64, 48});
    EXPECT_EQ(
        test::message_of([&] { render_frames(*output, renderer, [](const PipelineStep&) {}); }),
        "no more memory");
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(LimitingStage, IsTheOneThatTheOtherWaitsFor) {
  RenderPlan plan = plan_of(small_scene());
  PipelineStep step;
  step.writer_waits = true;
  EXPECT_EQ(limiting_stage(plan, step), "drawing");
  step.writer_waits = false;
  EXPECT_EQ(limiting_stage(plan, step), "writing");
  plan.sink.encoder.codec = "raw";
  EXPECT_EQ(limiting_stage(plan, step), "writing");
  plan.sink.encoder.codec = "h264";
  EXPECT_EQ(limiting_stage(plan, step), "encoding");
}

}  // namespace
}  // namespace polhode
