// SPDX-License-Identifier: MIT
#include "film/output/resumed_film.h"

#include <gtest/gtest.h>

#include "film/drawn_frames.h"
#include "film/small_films.h"
#include "support/logged.h"
#include "video/film_reader.h"
#include "video/plain_sinks.h"

namespace polhode {
namespace {

using test::NumberedFrames;
using test::read_text;
using test::write_text;

// Twelve seconds of film, 120 frames: three segments of 40 frames.
class FilmInSegments : public ::testing::Test {
 protected:
  static constexpr int kFrames = 120, kPerSegment = 40;

  FilmInSegments() : plan_(test::plan_of(slow_scene(), folder_ / "a.mp4")), film_(plan_) {
    plan_.resume = true;
  }
  static Scene slow_scene() {
    Scene scene = test::small_scene();
    scene.video.time_scale = 1.0 / 12.0;
    return scene;
  }
  // pushes so many of the frames that are wanted; finishes the film if those are all
  void push(ResumedFilm& output, std::size_t count) const {
    NumberedFrames renderer({64, 48});
    Image image;
    for (std::size_t i = 0; i < count; ++i) {
      renderer.render(output.frames().at(i), image);
      output.sink().push(image);
    }
    if (count == output.frames().size()) output.sink().finish();
  }
  // a run that ends after so many frames
  void run_until(std::size_t count) const {
    ResumedFilm output(plan_);
    output.begin(film_);
    push(output, count);
  }
  std::string piece(int number) const {
    return folder_ / fmt::format(".a.mp4.parts/{:05}.mp4", number);
  }
  bool has(int number) const { return std::filesystem::exists(piece(number)); }
  // brightness of red in each frame of the film, which is its number but for encoding
  std::vector<int> reds() const {
    FilmReader reader(folder_ / "a.mp4");
    std::vector<int> reds;
    Image image;
    for (double time = 0.0; reader.next(image, time);)
      reds.push_back(image.at(32, 24)[0]);
    return reds;
  }
  void expect_whole_film() const {
    const std::vector<int> found = reds();
    ASSERT_EQ(found.size(), static_cast<std::size_t>(kFrames));
    for (int i = 0; i < kFrames; ++i)
      EXPECT_NEAR(found[static_cast<std::size_t>(i)], i, 6) << i;
  }

  test::TemporaryFolder folder_;
  RenderPlan plan_;
  PreparedFilm film_;
};

TEST_F(FilmInSegments, IsJoinedAndItsFolderRemoved) {
  run_until(kFrames);
  EXPECT_EQ(folder_.entries(), 1);
  expect_whole_film();
}

TEST_F(FilmInSegments, GoesOnFromTheSegmentsThatAreWhole) {
  run_until(kPerSegment + 7);
  EXPECT_TRUE(has(1));
  EXPECT_FALSE(has(2)) << "seven frames are no segment";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.mp4"));
  ::testing::internal::CaptureStderr();
  ResumedFilm(plan_).begin(film_);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "quiet";
  plan_.progress = ProgressKind::automatic;
  ::testing::internal::CaptureStderr();
  ResumedFilm output(plan_);
  output.begin(film_);
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("1 of 3 pieces are already complete"),
            std::string::npos);
  EXPECT_EQ(output.already_there(), kPerSegment);
  EXPECT_EQ(output.range().count, kFrames);
  ASSERT_EQ(output.frames().size(), 80U);
  EXPECT_EQ(output.frames().front(), kPerSegment);
  push(output, 80);
  expect_whole_film();
  // hashes of the earlier run, too
  ASSERT_EQ(output.hashes().size(), static_cast<std::size_t>(kFrames));
  NumberedFrames renderer({64, 48});
  Image image;
  for (const int frame : {0, 39, 40, 119}) {
    renderer.render(frame, image);
    EXPECT_EQ(output.hashes()[static_cast<std::size_t>(frame)], frame_hash(image)) << frame;
  }
}

TEST_F(FilmInSegments, MakesADamagedOrMisplacedSegmentAgain) {
  run_until(2 * kPerSegment);
  std::string bytes = read_text(piece(1));
  bytes[bytes.size() / 2] ^= 1;
  write_text(piece(3), read_text(piece(2)));
  write_text(piece(1), bytes);
  ResumedFilm output(plan_);
  ::testing::internal::CaptureStderr();
  const std::string said = test::logged_by([&] { output.begin(film_); });
  ::testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("00001.mp4: is damaged and made again"), std::string::npos) << said;
  ASSERT_EQ(output.frames().size(), 80U);
  EXPECT_EQ(output.frames()[0], 0);
  EXPECT_EQ(output.frames()[39], 39);
  EXPECT_EQ(output.frames()[40], 80);
  push(output, 80);
  expect_whole_film();
}

TEST_F(FilmInSegments, RefusesSegmentsOfAnotherFilm) {
  run_until(kPerSegment);
  RenderPlan other = plan_;
  other.sink.encoder.crf = 30;
  ResumedFilm output(other);
  const std::string message = test::message_of([&] { output.begin(film_); });
  EXPECT_EQ(message.rfind("--resume: ", 0), 0U) << message;
  EXPECT_NE(message.find("settings differ (crf 30 and 18)"), std::string::npos) << message;
  EXPECT_TRUE(has(1)) << "hours of work stay";
}

// before work is done that could not be joined with that of the others
TEST_F(FilmInSegments, AShardRefusesSegmentsOfAnotherFilmInOtherShards) {
  run_until(kPerSegment);
  RenderPlan other = plan_;
  other.shard = Shard{2, 3};
  other.pieces = 3;
  other.sink.encoder.crf = 30;
  ResumedFilm output(other);
  const std::string message = test::message_of([&] { output.begin(film_); });
  EXPECT_NE(message.find("settings differ (crf 30 and 18)"), std::string::npos) << message;
  other.sink.encoder.crf = plan_.sink.encoder.crf;
  ResumedFilm same(other);
  EXPECT_EQ(test::message_of([&] { same.begin(film_); }), "");
}

TEST_F(FilmInSegments, AnEarlyEndSaysWhatIsKept) {
  ResumedFilm output(plan_);
  output.begin(film_);
  const Error interrupted(Fault::interrupted, "interrupted");
  EXPECT_NE(output.explained(interrupted).message().find("nothing is kept"), std::string::npos);
  push(output, kPerSegment);
  const Error full = output.explained(environment_error("the disk is full"));
  EXPECT_EQ(full.fault(), Fault::environment);
  EXPECT_EQ(full.message().rfind("the disk is full; kept in ", 0), 0U) << full.message();
  EXPECT_NE(full.message().find("1 of 3 pieces"), std::string::npos) << full.message();
  EXPECT_EQ(output.explained(interrupted).fault(), Fault::interrupted);
  EXPECT_EQ(output.explained(input_error("no such key")).message(), "no such key");
}

TEST_F(FilmInSegments, LeavesNothingWithoutAWholeSegment) {
  run_until(3);
  EXPECT_EQ(folder_.entries(), 0);
}

}  // namespace
}  // namespace polhode
