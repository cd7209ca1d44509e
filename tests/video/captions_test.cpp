// SPDX-License-Identifier: MIT
// WebVTT beside a film.
#include "video/captions.h"

#include "base/error.h"
#include "support/expect_error.h"
#include "support/run.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

TEST(Captions, WebVttHasACueForEachCaptionAtTheTimesOfItsFrames) {
  const std::vector<FilmMetadata::Caption> captions = {
      {0, 30, "First"}, {30, 31, "Second"}, {60 * 3600, 60 * 3661, "An hour later"}};
  EXPECT_EQ(web_vtt(captions, {60, 1}),
            "WEBVTT - captions by polhode\n"
            "\n00:00:00.000 --> 00:00:00.500\nFirst\n"
            "\n00:00:00.500 --> 00:00:00.517\nSecond\n"
            "\n01:00:00.000 --> 01:01:01.000\nAn hour later\n");
  EXPECT_EQ(web_vtt({{30, 60, "a"}}, {30000, 1001}),
            "WEBVTT - captions by polhode\n\n00:00:01.001 --> 00:00:02.002\na\n");
}

// words cannot end their cue or begin another
TEST(Captions, WordsAreEscaped) {
  const std::string text = web_vtt({{0, 10, "a < b & c\n\n00:01 --> 00:02\r\nΩ <b>"}}, {10, 1});
  EXPECT_EQ(text,
            "WEBVTT - captions by polhode\n\n00:00:00.000 --> 00:00:01.000\n"
            "a &lt; b &amp; c\n00:01 --&gt; 00:02\nΩ &lt;b&gt;\n");
  EXPECT_EQ(web_vtt({{0, 10, " \n "}, {10, 10, "never shown"}}, {10, 1}),
            "WEBVTT - captions by polhode\n");
}

TEST(Captions, StandBesideFilmsThatPlayersShowThemWith) {
  EXPECT_EQ(captions_beside("dir.mp4/a.b.mp4"), "dir.mp4/a.b.vtt");
  EXPECT_EQ(captions_beside("a.webm"), "a.vtt");
  EXPECT_EQ(captions_beside("a.mov"), "a.vtt");
  for (const char* other : {"a.gif", "a.png", "-", "null", "hash:a.mp4", "a.y4m"}) {
    EXPECT_EQ(captions_beside(other), "") << other;
  }
}

TEST(Captions, FilmAndWordsAppearTogether) {
  const TemporaryFolder folder;
  SinkJob job;
  job.output = folder / "a.mp4";
  job.width = job.height = 32;
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  sink->describe({3, {}, {}, {{0, 3, "Words"}}});
  for (int i = 0; i < 3; ++i) {
    sink->push(Image(32, 32));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a.vtt"));
  sink->finish();
  EXPECT_EQ(test::read_text(folder / "a.vtt"),
            "WEBVTT - captions by polhode\n\n00:00:00.000 --> 00:00:00.050\nWords\n");
  EXPECT_EQ(folder.entries(), 2);
}

TEST(Captions, AFolderInTheWayStopsTheFilmToo) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.vtt");
  SinkJob job;
  job.output = folder / "a.mp4";
  job.width = job.height = 32;
  const auto make = [&] {
    make_sink(job)->describe({3, {}, {}, {{0, 3, "Words"}}});
  };
  EXPECT_THROW(make(), Error);
  EXPECT_EQ(folder.entries(), 1);
}

// a film of one frame, which has all but its end
std::unique_ptr<FrameSink> film_with(const SinkJob& job,
                                     const std::vector<FilmMetadata::Caption>& captions) {
  std::unique_ptr<FrameSink> sink = make_sink(job);
  sink->describe({1, {}, {}, captions});
  sink->push(Image(job.width, job.height));
  return sink;
}

// what comes in their way at the end is told, and that there is a film
TEST(Captions, AFilmIsCompleteWithoutThem) {
  const TemporaryFolder folder;
  SinkJob job;
  job.output = folder / "a.mp4";
  job.width = job.height = 32;
  const std::unique_ptr<FrameSink> sink = film_with(job, {{0, 1, "Words"}});
  std::filesystem::create_directories(folder / "a.vtt/something");
  try {
    sink->finish();
    FAIL() << "a folder has the name";
  } catch (const Error& error) {
    EXPECT_TRUE(error.message().ends_with("; the film is complete")) << error.what();
  }
  EXPECT_TRUE(std::filesystem::exists(job.output));
}

// the words of an earlier film are not those of this one
TEST(Captions, AFilmWithoutWordsHasNoneOfAnEarlierFilm) {
  const TemporaryFolder folder;
  SinkJob job;
  job.output = folder / "a.mp4";
  job.width = job.height = 32;
  const auto make = [&](const std::vector<FilmMetadata::Caption>& captions) {
    const std::unique_ptr<FrameSink> sink = film_with(job, captions);
    const bool before = std::filesystem::exists(folder / "a.vtt");
    sink->finish();
    return before;
  };
  make({{0, 1, "Words"}});
  EXPECT_EQ(folder.entries(), 2);
  EXPECT_TRUE(make({})) << "they stay until the new film is complete";
  EXPECT_FALSE(std::filesystem::exists(folder / "a.vtt"));
  // also where captions were expected, and did not come
  make({{0, 1, "Words"}});
  job.captions = true;
  EXPECT_TRUE(make({}));
  EXPECT_EQ(folder.entries(), 1);
  // what others wrote is theirs
  job.captions = false;
  for (const char* other : {"WEBVTT\n\n00:00:00.000 --> 00:00:01.000\nMine\n", "", "WEBVTT - c"}) {
    test::write_text(folder / "a.vtt", other);
    make({});
    EXPECT_EQ(test::read_text(folder / "a.vtt"), other);
  }
  // and a film with words does not go over it
  test::expect_input_error([&] { make({{0, 1, "Words"}}); }, "", "no file of captions by polhode");
  EXPECT_EQ(test::read_text(folder / "a.vtt"), "WEBVTT - c");
}

// two films of one stem have one file of captions
TEST(Captions, OfAnotherFormatStay) {
  const TemporaryFolder folder;
  const auto make = [&](const char* name, const std::vector<FilmMetadata::Caption>& captions) {
    SinkJob job;
    job.output = folder / name;
    job.width = job.height = 32;
    film_with(job, captions)->finish();
  };
  make("a.mp4", {{0, 1, "Words"}});
  make("a.webm", {});
  EXPECT_NE(test::read_text(folder / "a.vtt").find("Words"), std::string::npos);
  make("a.webm", {{0, 1, "Others"}});  // with a warning
  EXPECT_NE(test::read_text(folder / "a.vtt").find("Others"), std::string::npos);
  std::filesystem::remove(folder / "a.webm");
  make("a.mp4", {});
  EXPECT_FALSE(std::filesystem::exists(folder / "a.vtt")) << "no other film has them";
}

TEST(Captions, OfAnEarlierFilmGoWithAPieceOfItsName) {
  const TemporaryFolder folder;
  SinkJob job;
  job.output = folder / "a.mp4";
  job.width = job.height = 32;
  for (const bool segment : {false, true}) {
    job.segment = segment;
    const std::unique_ptr<FrameSink> film = make_sink(job);
    FilmMetadata metadata;
    metadata.frames = 1;
    if (!segment) metadata.captions = {{0, 1, "words"}};
    film->describe(metadata);
    film->push(Image(32, 32));
    film->finish();
    EXPECT_EQ(std::filesystem::exists(folder / "a.vtt"), !segment);
  }
}

TEST(Captions, ThatAreExpectedAreClaimedAtOnce) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.vtt");
  SinkJob job;
  job.output = folder / "a.mp4";
  job.width = job.height = 32;
  EXPECT_NO_THROW(make_sink(job));
  job.captions = true;
  EXPECT_THROW(make_sink(job), Error);
  job.segment = true;
  EXPECT_NO_THROW(make_sink(job)) << "a piece has no captions beside it";
  EXPECT_EQ(folder.entries(), 1);
}

}  // namespace
}  // namespace polhode
