// SPDX-License-Identifier: MIT
#include "video/libav/film_header.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

std::string note(const AVDictionary* notes, const char* key) {
  const AVDictionaryEntry* entry = av_dict_get(notes, key, nullptr, 0);
  return entry == nullptr ? "" : entry->value;
}

// each chapter ends where the next begins, the last with the film; frames are times by the rate
TEST(FilmHeader, ChaptersFollowEachOther) {
  const TemporaryFolder folder;
  const FilmOutput output(folder / "a.mp4");
  const Owned<AVFormatContext> muxer = open_container(*find_film_format("a.mp4"), output);
  FilmMetadata metadata;
  metadata.frames = 100;
  metadata.chapters = {{0, "First"}, {30, "Second"}, {90, "Third"}};
  add_chapters(*muxer, metadata, {30000, 1001});
  ASSERT_EQ(muxer->nb_chapters, 3u);
  const std::int64_t bounds[] = {0, 30, 90, 100};
  for (unsigned i = 0; i < 3; ++i) {
    const AVChapter& chapter = *muxer->chapters[i];
    EXPECT_EQ(chapter.start, bounds[i]);
    EXPECT_EQ(chapter.end, bounds[i + 1]);
    EXPECT_EQ(av_cmp_q(chapter.time_base, {1001, 30000}), 0);
    EXPECT_EQ(note(chapter.metadata, "title"), metadata.chapters[i].title);
  }
}

TEST(FilmHeader, EmptyNotesAreLeftOut) {
  const TemporaryFolder folder;
  const FilmOutput output(folder / "a.mp4");
  const Owned<AVFormatContext> muxer = open_container(*find_film_format("a.mp4"), output);
  add_notes(*muxer, {{"title", "A title ü"}, {"comment", ""}});
  EXPECT_EQ(note(muxer->metadata, "title"), "A title ü");
  EXPECT_EQ(av_dict_count(muxer->metadata), 1);
}

// a raw film of grey frames: the least that has a header
Owned<AVFormatContext> raw_film(const FilmFormat& format, const FilmOutput& output) {
  Owned<AVFormatContext> muxer = open_container(format, output);
  AVStream* stream = made(avformat_new_stream(muxer.get(), nullptr));
  stream->codecpar->codec_type = AVMEDIA_TYPE_VIDEO;
  stream->codecpar->codec_id = AV_CODEC_ID_WRAPPED_AVFRAME;
  stream->codecpar->format = AV_PIX_FMT_YUV420P;
  stream->codecpar->width = 64;
  stream->codecpar->height = 48;
  stream->time_base = {1, 25};
  stream->avg_frame_rate = {25, 1};
  return muxer;
}

TEST(FilmHeader, IsWrittenFirst) {
  const TemporaryFolder folder;
  FilmOutput output(folder / "a.y4m");
  const FilmFormat& format = *find_film_format("a.y4m");
  const Owned<AVFormatContext> muxer = raw_film(format, output);
  begin_film(*muxer, format);
  check_libav(av_write_trailer(muxer.get()), "trailer");
  output.finish();
  EXPECT_TRUE(test::read_text(folder / "a.y4m").starts_with("YUV4MPEG2 W64 H48 F25:1"));
}

// a setting of the table that this FFmpeg does not know is an error, not a film without it
TEST(FilmHeader, OptionsMustBeUnderstood) {
  const TemporaryFolder folder;
  const FilmOutput output(folder / "a.y4m");
  FilmFormat format = *find_film_format("a.y4m");
  format.options = {{"nonsense", "1"}};
  const Owned<AVFormatContext> muxer = raw_film(format, output);
  test::expect_error([&] { begin_film(*muxer, format); },
                     Fault::environment,
                     "",
                     "the muxer yuv4mpegpipe does not know the option 'nonsense'");
  format.muxer = "no_such";
  test::expect_error(
      [&] { open_container(format, output); }, Fault::environment, "", "writes no .y4m");
}

}  // namespace
}  // namespace polhode
