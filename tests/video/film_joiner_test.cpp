// SPDX-License-Identifier: MIT
#include "video/film_joiner.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "video/every_format.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::decode;
using test::DecodedFilm;
using test::TemporaryFolder;
using test::walking;

// a segment of a walk, from frame `first` on
FilmJoiner::Part segment(
    const TemporaryFolder& folder, const std::string& name, int first, int frames, int width = 64) {
  SinkJob job;
  job.output = folder / name;
  job.width = width;
  job.height = 48;
  job.fps = {30000, 1001};
  job.segment = true;
  const FilmFormat& format = *find_film_format(name);
  job.encoder.crf = find_encoder(format, "").crf[1];
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  for (int i = 0; i < frames; ++i)
    sink->push(walking(job, first + i));
  sink->finish();
  return {job.output, frames};
}

void join(const std::string& output, const std::vector<FilmJoiner::Part>& parts) {
  FilmMetadata metadata;
  for (const FilmJoiner::Part& part : parts)
    metadata.frames += part.frames;
  metadata.chapters = {{0, "One"}, {9, "Two"}};
  metadata.captions = {{0, 5, "Words"}};
  FilmJoiner(output).join(parts, {30000, 1001}, "Title", "Comment", metadata);
}

// the pixels are those of the parts, one after another, each frame a step of the rate later
TEST(FilmJoiner, TheWholeIsItsPartsInOrder) {
  for (const std::string ending : {".mp4", ".webm", ".mov"}) {
    SCOPED_TRACE(ending);
    const TemporaryFolder folder;
    const std::vector<FilmJoiner::Part> parts = {segment(folder, "p1" + ending, 0, 9),
                                                 segment(folder, "p2" + ending, 9, 1),
                                                 segment(folder, "p3" + ending, 10, 12)};
    join(folder / ("whole" + ending), parts);
    const DecodedFilm whole = decode(folder / ("whole" + ending));
    ASSERT_EQ(whole.frames.size(), 22u);
    std::size_t at = 0;
    for (const FilmJoiner::Part& part : parts) {
      for (const Image& frame : decode(part.file).frames)
        EXPECT_EQ(whole.frames[at++].pixels, frame.pixels) << at;
    }
    const double unit = ending == ".webm" ? 5e-4 : 0.0;
    for (std::size_t k = 0; k < 22; ++k) {
      const double shown =
          static_cast<double>(whole.pts[k] - whole.pts[0]) * av_q2d(whole.time_base);
      EXPECT_NEAR(shown, static_cast<double>(k) * 1001.0 / 30000.0, unit + 1e-9) << k;
    }
    EXPECT_EQ(whole.title, "Title");
    EXPECT_EQ(comment_of_film(folder / ("whole" + ending)), "Comment");
    ASSERT_EQ(whole.chapters.size(), 2u);
    EXPECT_NEAR(whole.chapters[1].start_s, 9.0 * 1001.0 / 30000.0, 1e-3);
    EXPECT_NE(test::read_text(folder / "whole.vtt").find("Words"), std::string::npos);
    // another film of that name, without captions
    FilmMetadata plain;
    plain.frames = 22;
    FilmJoiner(folder / ("whole" + ending)).join(parts, {30000, 1001}, "", "", plain);
    EXPECT_FALSE(std::filesystem::exists(folder / "whole.vtt"));
  }
}

// nothing appears when a part does not fit, and the part is named
TEST(FilmJoiner, PartsThatDoNotFitAreNamed) {
  const TemporaryFolder folder;
  const FilmJoiner::Part good = segment(folder, "good.mp4", 0, 5);
  const FilmJoiner::Part wide = segment(folder, "wide.mp4", 0, 5, 128);
  test::write_text(folder / "text.mp4", "this is no film");
  const auto joined = [&](const FilmJoiner::Part& second) {
    return [&, second] {
      join(folder / "whole.mp4", {good, second});
    };
  };
  test::expect_input_error(joined({good.file, 6}), "", "holds 5 frames instead of 6");
  test::expect_input_error(joined(wide), "", "encoded otherwise");
  test::expect_input_error(joined({folder / "text.mp4", 5}), "", "not a readable film");
  test::expect_input_error(joined({folder / "none.mp4", 5}), "", "does not exist");
  EXPECT_EQ(folder.entries(), 3) << "the parts alone";
}

TEST(FilmJoiner, OnlyFilmsWithMetadataAreJoined) {
  const TemporaryFolder folder;
  for (const char* name : {"a.gif", "a.png", "a.hash", "a.y4m"})
    test::expect_input_error([&] { FilmJoiner{folder / name}; }, "", ".mp4, .webm or .mov");
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace polhode
