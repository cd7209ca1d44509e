// SPDX-License-Identifier: MIT
// What stands in the container, and how frames are grouped, for every kind of film.
#include "video/libav/film_writer.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/system/stage_clock.h"
#include "video/every_format.h"
#include "video/libav/converter.h"

namespace polhode {
namespace {

using test::all_ways;
using test::decode;
using test::DecodedFilm;
using test::job_for;
using test::some_metadata;
using test::TemporaryFolder;
using test::walking;
using test::Way;
using test::write_film;

TEST(FilmWriter, ColoursAreTagged) {
  for (const Way& way : all_ways()) {
    if (way.format->ending == ".gif" || way.format->ending == ".apng") continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    write_film(job_for(folder, way), 3);
    const DecodedFilm film = decode(folder / ("a" + way.format->ending));
    // neither ProRes nor the 'nclc' box of QuickTime states a range: it is always the limited one,
    // which the decoder of FFmpeg 5 fills in and that of FFmpeg 7 leaves open
    if (way.encoder->codec != "prores" || film.range != AVCOL_RANGE_UNSPECIFIED) {
      EXPECT_EQ(film.range, AVCOL_RANGE_MPEG);
    }
    if (way.format->ending == ".y4m") continue;  // has no words for the rest
    EXPECT_EQ(film.matrix, AVCOL_SPC_BT709);
    EXPECT_EQ(film.primaries, AVCOL_PRI_BT709);
    EXPECT_EQ(film.transfer, AVCOL_TRC_BT709);
    if (way.encoder->codec == "hevc") {
      EXPECT_EQ(film.tag, MKTAG('h', 'v', 'c', '1')) << "QuickTime looks for it";
    }
  }
}

TEST(FilmWriter, TheFinestHasAsMuchColourAsPlayersTake) {
  for (const Way& way : all_ways()) {
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    SinkJob job = job_for(folder, way);
    job.encoder.finest = true;
    write_film(job, 3);
    const int format = decode(job.output).pixel_format;
    const std::string& codec = way.encoder->codec;
    if (codec == "vp9" || codec == "raw") {
      EXPECT_EQ(format, AV_PIX_FMT_YUV444P);
    }
    if (codec == "h264" || codec == "hevc" || codec == "av1") {
      EXPECT_EQ(format, AV_PIX_FMT_YUV420P) << "4:4:4 stays blank in many players";
    }
  }
}

DecodedFilm film_with_metadata(const TemporaryFolder& folder, const Way& way) {
  const SinkJob job = job_for(folder, way);
  write_film(job, 40, some_metadata());
  return decode(job.output);
}

TEST(FilmWriter, TitleChaptersAndEncoderAreInTheContainer) {
  for (const Way& way : all_ways()) {
    if (!way.format->keeps_metadata) continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const DecodedFilm film = film_with_metadata(folder, way);
    EXPECT_EQ(film.title, job_for(folder, way).title);
    EXPECT_EQ(film.comment, job_for(folder, way).comment);
    ASSERT_EQ(film.chapters.size(), 2u);
    EXPECT_EQ(film.chapters[0].title, "First <one>");
    EXPECT_EQ(film.chapters[1].title, "Second & last ü");
    EXPECT_NEAR(film.chapters[1].start_s, 18 / 25.0, 1e-3);
    EXPECT_NEAR(film.chapters[1].end_s, 40 / 25.0, 1e-3);
    EXPECT_EQ(film.pts.size(), 40u);
    EXPECT_NE(test::read_text(folder / "a.vtt").find("Words"), std::string::npos);
  }
}

TEST(FilmWriter, KeyFramesAreWhereTheStoryStopsAndEverySecond) {
  for (const Way& way : all_ways()) {
    if (!way.format->keeps_metadata) continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const DecodedFilm film = film_with_metadata(folder, way);
    ASSERT_EQ(film.packets.size(), 40u);
    std::set<int> keys;
    for (const DecodedFilm::Packet& packet : film.packets) {
      const double frame = static_cast<double>(packet.pts) * av_q2d(film.time_base) * 25.0;
      if (packet.key) keys.insert(static_cast<int>(std::lround(frame)));
    }
    for (const int wanted : {0, 7, 18, 33}) {
      EXPECT_TRUE(keys.contains(wanted)) << wanted;
    }
  }
}

// without metadata no group is longer than a second
TEST(FilmWriter, AGroupIsAtMostASecond) {
  for (const Way& way : all_ways()) {
    if (!way.format->keeps_metadata) continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    write_film(job_for(folder, way, {12, 1}), 40);
    const DecodedFilm film = decode(folder / ("a" + way.format->ending));
    int since = 0;
    for (const bool key : film.key) {
      since = key ? 1 : since + 1;
      EXPECT_LE(since, 12);
    }
  }
}

TEST(FilmWriter, OddSidesWhereColourHasAllOfThem) {
  for (const Way& way : all_ways()) {
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    SinkJob job = job_for(folder, way);
    job.width = 63;
    job.height = 47;
    const std::string& codec = way.encoder->codec;
    const bool takes = codec == "prores" || codec == "gif" || codec == "apng";
    try {
      write_film(job, 2);
      EXPECT_TRUE(takes);
      const DecodedFilm film = decode(job.output);
      EXPECT_EQ(film.width, 63);
      EXPECT_EQ(film.height, 47);
    } catch (const Error& error) {
      EXPECT_FALSE(takes) << error.what();
      EXPECT_EQ(error.fault(), Fault::input);
      EXPECT_NE(std::string(error.what()).find("64x48"), std::string::npos) << error.what();
      EXPECT_EQ(folder.entries(), 0);
    }
  }
}

// frames keep the times that they are given: a gap stays a gap
TEST(FilmWriter, FramesKeepTheirTimes) {
  const TemporaryFolder folder;
  const Way h264{find_film_format("a.mp4"), &find_encoder(*find_film_format("a.mp4"), "")};
  const SinkJob job = job_for(folder, h264);
  FilmWriter writer(job);
  Converter converter(job.width, job.height, writer.pixels());
  const std::vector<std::int64_t> times = {0, 1, 5, 6, 20};
  for (const std::int64_t time : times) {
    AVFrame* frame = converter.convert(walking(job, static_cast<int>(time)));
    frame->pts = time;
    writer.write(*frame, time == 5);
  }
  EXPECT_FALSE(std::filesystem::exists(job.output));
  writer.finish();
  const DecodedFilm film = decode(job.output);
  ASSERT_EQ(film.pts.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_EQ(av_compare_ts(film.pts[i], film.time_base, times[i], {1, 25}), 0) << i;
  EXPECT_TRUE(film.key[2]);
  EXPECT_FALSE(film.key[1]);
}

// what the encoder works with is known, so that its time can be counted, and ends with it
TEST(FilmWriter, TheEncodersThreadsAreKnown) {
  const TemporaryFolder folder;
  const Way h264{find_film_format("a.mp4"), &find_encoder(*find_film_format("a.mp4"), "")};
  const std::set<int> before = thread_ids();
  std::set<int> own;
  {
    const FilmWriter writer(job_for(folder, h264));
    own = writer.threads();
    const std::set<int> now = thread_ids();
    std::set<int> wanted;
    std::set_difference(
        now.begin(), now.end(), before.begin(), before.end(), std::inserter(wanted, wanted.end()));
    EXPECT_EQ(own, wanted);
  }
  EXPECT_GE(own.size(), 2u) << "two threads were asked for";
}

}  // namespace
}  // namespace polhode
