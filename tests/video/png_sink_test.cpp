// SPDX-License-Identifier: MIT
// PNG pictures and sequences.
#include "video/png_sink.h"

#include "base/error.h"
#include "image/png.h"
#include "support/full_disk.h"
#include "support/run.h"
#include "video/sink_kinds.h"
#include "video/small_frames.h"

namespace polhode {
namespace {

using test::small_frame;
using test::small_job;
using test::TemporaryFolder;

TEST(PngSink, ANumberedNameHasOneNumber) {
  EXPECT_EQ(parse_numbered_name("a_%05d.png").of(42), "a_00042.png");
  EXPECT_EQ(parse_numbered_name("%d.png").of(42), "42.png");
  EXPECT_EQ(parse_numbered_name("50%/%d/a_%d.png").of(42), "50%/%d/a_42.png");
  EXPECT_TRUE(has_percent("a/%.png"));
  EXPECT_FALSE(has_percent("a%d/b.png"));
  EXPECT_EQ(parse_numbered_name("a_%01d.png").of(1234567), "a_1234567.png");
  for (const char* pattern : {"a.png",
                              "%s.png",
                              "%d%d.png",
                              "%n.png",
                              "%999999d.png",
                              "%5d.png",
                              "%%d.png",
                              "%05d%.png",
                              "%0d.png",
                              "%-5d.png",
                              "%05ld.png",
                              "%x.png",
                              "%*d.png",
                              "%"}) {
    EXPECT_THROW(parse_numbered_name(pattern), Error) << pattern;
  }
}

TEST(PngSink, ASequenceIsWholeOrNotThere) {
  const TemporaryFolder folder;
  {
    const auto sink = make_sink(small_job(folder / "f_%03d.png"));
    for (int i = 0; i < 4; ++i)
      sink->push(small_frame(i));
    EXPECT_EQ(folder.entries(), 4);
  }
  EXPECT_EQ(folder.entries(), 0) << "not finished";
  const auto sink = make_sink(small_job(folder / "f_%03d.png"));
  for (int i = 0; i < 4; ++i)
    sink->push(small_frame(i));
  sink->finish();
  EXPECT_EQ(folder.entries(), 4);
  EXPECT_EQ(read_png(folder / "f_003.png").pixels, small_frame(3).pixels);
}

// a run that fails must not take the frames of the last one with it
TEST(PngSink, AnAbandonedSequenceKeepsTheOldFrames) {
  const TemporaryFolder folder;
  test::write_text(folder / "f_001.png", "an older frame");
  {
    const auto sink = make_sink(small_job(folder / "f_%03d.png"));
    for (int i = 0; i < 4; ++i)
      sink->push(small_frame(i));
    EXPECT_FALSE(std::filesystem::exists(folder / "f_000.png")) << "before finish()";
  }
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(test::read_text(folder / "f_001.png"), "an older frame");
}

TEST(PngSink, AFrameThatCannotBeWrittenRemovesTheOthers) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "f_002.png");
  const auto make = [&] {
    const auto sink = make_sink(small_job(folder / "f_%03d.png"));
    for (int i = 0; i < 4; ++i)
      sink->push(small_frame(i));
  };
  EXPECT_THROW(make(), Error);
  EXPECT_EQ(folder.entries(), 1) << "only the folder in the way";
}

// as on a mount point, which only the system knows of
TEST(PngSink, AFrameThatCannotGetItsNameGivesTheOldOnesBack) {
  const TemporaryFolder folder;
  for (int i = 0; i < 4; ++i)
    test::write_text(folder / fmt::format("f_{:03}.png", i), fmt::format("older frame {}", i));
  const auto make = [&] {
    const auto sink = make_sink(small_job(folder / "f_%03d.png"));
    for (int i = 0; i < 6; ++i)
      sink->push(small_frame(i));
    std::filesystem::create_directory(folder / "f_005.png");
    sink->finish();
  };
  EXPECT_THROW(make(), Error);
  EXPECT_EQ(folder.entries(), 5) << "and the folder in the way";
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(test::read_text(folder / fmt::format("f_{:03}.png", i)),
              fmt::format("older frame {}", i));
}

TEST(PngSink, AFullDiskIsAnErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "f_%d.png"}) {
    SinkJob job = small_job(folder / name);
    job.still = std::string(name) == "a.png";
    const auto make = [&] {
      const auto sink = make_sink(job);
      sink->push(small_frame(0));
      if (!job.still) sink->push(small_frame(1));
      sink->finish();
    };
    EXPECT_EQ(test::with_full_disk(20, make), test::Outcome::environment) << name;
    EXPECT_EQ(folder.entries(), 0) << name;
    EXPECT_EQ(test::with_full_disk(100000, make), test::Outcome::done) << name;
    EXPECT_GT(folder.entries(), 0) << name;
    for (const auto& made : std::filesystem::directory_iterator(folder.path()))
      std::filesystem::remove(made.path());
  }
}

TEST(PngSink, AStillIsWrittenAtTheEndAndKeepsAlpha) {
  const TemporaryFolder folder;
  SinkJob job = small_job(folder / "a.png");
  job.still = true;
  const auto sink = make_sink(job);
  sink->push(small_frame(1));
  EXPECT_FALSE(std::filesystem::exists(job.output));
  sink->finish();
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(read_png(job.output).pixels, small_frame(1).pixels);
}

TEST(PngSink, NeedsToBeToldThatItIsOnePicture) {
  const TemporaryFolder folder;
  try {
    make_sink(small_job(folder / "a.png"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("name_%05d.png"), std::string::npos);
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(PngSink, APercentSignAloneIsNoNumber) {
  for (const char* name : {"a_%d.png", "%03d%.png", "50%_%05d.png"})
    EXPECT_TRUE(has_frame_number(name)) << name;
  for (const char* name : {"a.png", "50%.png", "%5d.png", "%00d.png", "%s"})
    EXPECT_FALSE(has_frame_number(name)) << name;
}

// a piece of a film numbers its pictures as the whole does
TEST(PngSink, APieceBeginsAtItsOwnNumber) {
  const TemporaryFolder folder;
  const auto sink = make_sink(small_job(folder / "f_%02d.png"));
  FilmMetadata metadata;
  metadata.first = 41;
  sink->describe(metadata);
  sink->push(small_frame(0));
  sink->push(small_frame(1));
  sink->finish();
  EXPECT_EQ(read_png(folder / "f_42.png").pixels, small_frame(1).pixels);
  EXPECT_EQ(folder.entries(), 2);
}

}  // namespace
}  // namespace polhode
