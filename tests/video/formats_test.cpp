// SPDX-License-Identifier: MIT
// Every kind of film, decoded again: the tables of video/encoders.h are gone through, so that a new
// row is tested by being there.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "base/error.h"
#include "support/full_disk.h"
#include "support/run.h"
#include "video/decoded_film.h"
#include "video/encoders.h"
#include "video/gif_sink.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::decode;
using test::DecodedFilm;
using test::TemporaryFolder;

// A way to make a film: an ending with one of its codecs.
struct Way {
  const FilmFormat* format;
  const FilmEncoder* encoder;

  std::string name() const { return encoder->codec + format->ending; }
  bool lossless() const { return encoder->codec == "apng"; }
};

std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (const FilmFormat& format : film_formats()) {
    for (const std::string& codec : format.codecs) {
      ways.push_back({&format, &find_encoder(format, codec)});
    }
  }
  return ways;
}

SinkJob job_for(const TemporaryFolder& folder, const Way& way, FrameRate fps = {25, 1}) {
  SinkJob job;
  job.output = folder / ("a" + way.format->ending);
  job.width = 64;
  job.height = 48;
  job.fps = fps;
  job.encoder.codec = way.encoder->codec;
  job.encoder.crf = way.encoder->crf[1];
  job.title = "A <title> & \"quotes\" ü";
  job.comment = "what made it";
  return job;
}

void paint(Image& image, int x, int y, int r, int g, int b, int a) {
  std::uint8_t* pixel = image.at(x, y);
  pixel[0] = static_cast<std::uint8_t>(r);
  pixel[1] = static_cast<std::uint8_t>(g);
  pixel[2] = static_cast<std::uint8_t>(b);
  pixel[3] = static_cast<std::uint8_t>(a);
}

// an orange square of 16 pixels that walks over blue; the ground is clear when there is alpha
Image walking(const SinkJob& job, int index) {
  Image image(job.width, job.height);
  for (int y = 0; y < job.height; ++y) {
    for (int x = 0; x < job.width; ++x) {
      const bool inside = y >= 16 && y < 32 && (x - 2 * index + 640) % 64 < 16;
      if (inside) {
        paint(image, x, y, 240, 165, 30, 255);
      } else {
        paint(image, x, y, 20, 60, 140, job.transparent ? 0 : 255);
      }
    }
  }
  return image;
}

void write_film(const SinkJob& job, int frames, const FilmMetadata& metadata = {}) {
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  sink->describe(metadata);
  for (int i = 0; i < frames; ++i) {
    sink->push(walking(job, i));
  }
  sink->finish();
}

std::string alpha_decoder(const Way& way) {
  return way.encoder->codec == "vp9" ? "libvpx-vp9" : "";
}

// the unit in which the container keeps times, s; 0: exact
double unit_of(const Way& way) {
  if (way.format->ending == ".webm") return 1e-3;
  if (way.format->ending == ".gif") return 1e-2;
  return 0.0;
}

TEST(Formats, CountSizeAndTimesAreExact) {
  for (const Way& way : all_ways()) {
    for (const FrameRate fps : {FrameRate{25, 1}, {30000, 1001}, {50, 1}}) {
      SCOPED_TRACE(way.name() + " " + std::to_string(fps.value()));
      const TemporaryFolder folder;
      write_film(job_for(folder, way, fps), 31);
      const DecodedFilm film = decode(folder / ("a" + way.format->ending));
      ASSERT_EQ(film.pts.size(), 31u);
      EXPECT_EQ(film.width, 64);
      EXPECT_EQ(film.height, 48);
      // to the half of the container's unit, and not a hair more where it can tell the rate
      for (std::size_t k = 0; k < film.pts.size(); ++k) {
        // FFmpeg reads the exact delays of an .apng as tens of microseconds and adds them up
        const double reading = way.lossless() ? 5e-6 * static_cast<double>(k) : 0.0;
        const double allowed = 0.5 * unit_of(way) + reading + 1e-9;
        const double shown =
            static_cast<double>(film.pts[k] - film.pts[0]) * av_q2d(film.time_base);
        EXPECT_NEAR(shown, static_cast<double>(k) / fps.value(), allowed) << k;
      }
      if (way.format->ending == ".gif" || way.format->ending == ".apng") {
        const double end = static_cast<double>(film.pts[30] - film.pts[0] + film.durations[30]) *
                           av_q2d(film.time_base);
        EXPECT_NEAR(end, 31 / fps.value(), 0.5 * unit_of(way) + 2e-4) << "so is the last frame";
      }
      EXPECT_EQ(folder.entries(), 1);
    }
  }
}

// the delays that the file holds, each a fraction of a second in a chunk of its own (fcTL)
TEST(Formats, DelaysOfAnApngAreExactFractions) {
  const Way apng{find_film_format("a.apng"), &find_encoder(*find_film_format("a.apng"), "")};
  const TemporaryFolder folder;
  const SinkJob job = job_for(folder, apng, {30000, 1001});
  write_film(job, 5);
  const std::string bytes = test::read_text(job.output);
  const auto number = [&](std::size_t at, int count) {
    int value = 0;
    for (int i = 0; i < count; ++i) {
      value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    }
    return value;
  };
  int delays = 0;
  for (std::size_t at = bytes.find("fcTL"); at != std::string::npos;
       at = bytes.find("fcTL", at + 1)) {
    EXPECT_EQ(number(at + 4 + 20, 2), 1001) << delays;
    EXPECT_EQ(number(at + 4 + 22, 2), 30000) << delays;
    ++delays;
  }
  EXPECT_EQ(delays, 5);
}

TEST(Formats, PicturesComeBack) {
  for (const Way& way : all_ways()) {
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const SinkJob job = job_for(folder, way);
    write_film(job, 6);
    const DecodedFilm film = decode(job.output);
    ASSERT_EQ(film.frames.size(), 6u);
    const int allowed = way.lossless() ? 0 : 6;
    for (const int index : {0, 5}) {
      const Image sent = walking(job, index);
      // the middle of the square and of the ground; edges are for the lossless ones
      for (const auto& [x, y] : {std::pair{7 + 2 * index, 23}, {45, 8}, {32, 42}}) {
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(
              film.frames[static_cast<std::size_t>(index)].at(x, y)[c], sent.at(x, y)[c], allowed)
              << index << " " << x << " " << c;
        }
      }
      if (way.lossless()) {
        EXPECT_EQ(film.frames[static_cast<std::size_t>(index)].pixels, sent.pixels);
      }
    }
  }
}

TEST(Formats, AlphaIsKeptStraight) {
  int kept = 0;
  for (const Way& way : all_ways()) {
    if (!way.encoder->alpha) continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    SinkJob job = job_for(folder, way);
    job.transparent = true;
    write_film(job, 6);
    const DecodedFilm film = decode(job.output, alpha_decoder(way));
    ASSERT_EQ(film.frames.size(), 6u);
    for (const int index : {0, 5}) {
      const Image& frame = film.frames[static_cast<std::size_t>(index)];
      EXPECT_NEAR(frame.at(7 + 2 * index, 23)[3], 255, 2);
      EXPECT_NEAR(frame.at(45, 8)[3], 0, 2);
      EXPECT_NEAR(frame.at(7 + 2 * index, 23)[0], 240, 6) << "the colour is not dimmed";
    }
    if (way.encoder->codec == "vp9") {
      EXPECT_EQ(film.alpha_mode, "1") << "players ask the container";
    }
    ++kept;
  }
  EXPECT_EQ(kept, 4);
}

// half-clear pixels keep their full colour, where alpha has more than one bit
TEST(Formats, HalfClearIsHalfClear) {
  for (const Way& way : all_ways()) {
    if (!way.encoder->alpha || way.encoder->codec == "gif") continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    SinkJob job = job_for(folder, way);
    job.transparent = true;
    Image image(job.width, job.height);
    for (int y = 0; y < job.height; ++y) {
      for (int x = 0; x < job.width; ++x) {
        paint(image, x, y, 200, 100, 50, 128);
      }
    }
    const std::unique_ptr<FrameSink> sink = make_sink(job);
    sink->push(image);
    sink->push(image);
    sink->finish();
    const DecodedFilm film = decode(job.output, alpha_decoder(way));
    ASSERT_EQ(film.frames.size(), 2u);
    const int sent[] = {200, 100, 50, 128};
    for (int c = 0; c < 4; ++c) {
      EXPECT_NEAR(film.frames[1].at(30, 20)[c], sent[c], 4) << c;
    }
  }
}

TEST(Formats, ColoursAreTagged) {
  for (const Way& way : all_ways()) {
    if (way.format->ending == ".gif" || way.format->ending == ".apng") continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    write_film(job_for(folder, way), 3);
    const DecodedFilm film = decode(folder / ("a" + way.format->ending));
    EXPECT_EQ(film.range, AVCOL_RANGE_MPEG);
    if (way.format->ending == ".y4m") continue;  // has no words for the rest
    EXPECT_EQ(film.matrix, AVCOL_SPC_BT709);
    EXPECT_EQ(film.primaries, AVCOL_PRI_BT709);
    EXPECT_EQ(film.transfer, AVCOL_TRC_BT709);
    if (way.encoder->codec == "hevc") {
      EXPECT_EQ(film.tag, MKTAG('h', 'v', 'c', '1')) << "QuickTime looks for it";
    }
  }
}

TEST(Formats, TheFinestHasAsMuchColourAsPlayersTake) {
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

FilmMetadata some_glyphs() {
  FilmMetadata metadata;
  metadata.frames = 40;
  metadata.key_frames = {7, 18, 33};
  metadata.chapters = {{0, "First <one>"}, {18, "Second & last ü"}};
  metadata.captions = {{0, 18, "Words"}};
  return metadata;
}

DecodedFilm marked_film(const TemporaryFolder& folder, const Way& way) {
  const SinkJob job = job_for(folder, way);
  write_film(job, 40, some_glyphs());
  return decode(job.output);
}

TEST(Formats, TitleChaptersAndEncoderAreInTheContainer) {
  for (const Way& way : all_ways()) {
    if (!way.format->keeps_metadata) continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const DecodedFilm film = marked_film(folder, way);
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

TEST(Formats, KeyFramesAreWhereTheStoryStopsAndEverySecond) {
  for (const Way& way : all_ways()) {
    if (!way.format->keeps_metadata) continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const DecodedFilm film = marked_film(folder, way);
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
TEST(Formats, AGroupIsAtMostASecond) {
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

TEST(Formats, SameFramesGiveTheSamePictures) {
  for (const Way& way : all_ways()) {
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    SinkJob job = job_for(folder, way);
    job.transparent = way.encoder->alpha;
    write_film(job, 30);
    const DecodedFilm first = decode(job.output, alpha_decoder(way));
    write_film(job, 30);
    const DecodedFilm second = decode(job.output, alpha_decoder(way));
    ASSERT_EQ(first.frames.size(), 30u);
    ASSERT_EQ(second.frames.size(), 30u);
    for (std::size_t i = 0; i < 30; ++i) {
      EXPECT_EQ(first.frames[i].pixels, second.frames[i].pixels) << i;
    }
  }
}

TEST(Formats, OddSidesWhereColourHasAllOfThem) {
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

// wherever it becomes full; x264's bytes, unlike its pixels, may vary by a few
TEST(Formats, AFullDiskIsAnErrorAndLeavesNothing) {
  for (const Way& way : all_ways()) {
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const SinkJob job = job_for(folder, way);
    const auto make = [&] {
      write_film(job, 12, some_glyphs());
    };
    make();
    const auto whole = static_cast<rlim_t>(std::filesystem::file_size(job.output));
    std::filesystem::remove(job.output);
    std::filesystem::remove(folder / "a.vtt");
    // the last: all fits but what the trailer writes
    for (const rlim_t most : {rlim_t{0}, rlim_t{30}, whole / 4, whole / 2, whole * 95 / 100}) {
      EXPECT_EQ(test::with_full_disk(most, make), test::Outcome::environment) << most;
      EXPECT_EQ(folder.entries(), 0) << most;
    }
    EXPECT_EQ(test::with_full_disk(4 * whole + 65536, make), test::Outcome::done);
    EXPECT_EQ(folder.entries(), way.format->keeps_metadata ? 2 : 1);
  }
}

TEST(Formats, AbandonedLeavesNothingAndKeepsTheOldOnes) {
  for (const Way& way : all_ways()) {
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const SinkJob job = job_for(folder, way);
    test::write_text(job.output, "an older film");
    test::write_text(folder / "a.vtt", "older words");
    {
      const std::unique_ptr<FrameSink> sink = make_sink(job);
      sink->describe(some_glyphs());
      for (int i = 0; i < 20; ++i) {
        sink->push(walking(job, i));
      }
    }
    EXPECT_EQ(folder.entries(), 2);
    EXPECT_EQ(test::read_text(job.output), "an older film");
    EXPECT_EQ(test::read_text(folder / "a.vtt"), "older words");
  }
}

TEST(Formats, EveryPresetOpens) {
  for (const Way& way : all_ways()) {
    if (!way.encoder->presets) continue;
    for (const std::string& preset : encoder_presets()) {
      SCOPED_TRACE(way.name() + " " + preset);
      const TemporaryFolder folder;
      SinkJob job = job_for(folder, way);
      job.encoder.preset = preset;
      try {
        write_film(job, 2);
      } catch (const Error& error) {
        ADD_FAILURE() << error.what();
      }
    }
  }
}

// the encoder that serves where the first is missing
TEST(Formats, EveryEncoderOfTheTableIsThereOrSaysWhatToInstall) {
  for (const FilmEncoder& encoder : film_encoders()) {
    EXPECT_TRUE(has_encoder(encoder.name)) << encoder.name;
  }
  EXPECT_FALSE(has_encoder("libx999"));
}

struct Asked {
  std::string output;
  EncoderWish wish;
  std::string says;  // empty: it is taken
};

TEST(Encoders, WhatIsAskedOfThemIsChecked) {
  const auto wish = [](std::optional<std::string> codec,
                       std::optional<std::string> preset,
                       std::optional<int> crf) {
    EncoderWish made;
    made.codec = std::move(codec);
    made.forced = std::move(preset);
    made.crf = crf;
    return made;
  };
  const Asked cases[] = {
      {"a.mp4", wish("hevc", {}, {}), ""},
      {"a.mp4", wish("av1", {}, 63), ""},
      {"a.mp4", wish({}, {}, 52), "--crf: must be 1 (best) to 51 for H.264, got 52"},
      {"a.webm", wish({}, {}, 52), ""},
      {"a.webm", wish({}, {}, 64), "1 (best) to 63 for VP9"},
      {"a.webm", wish({}, {}, 0), "1 (best) to 63 for VP9"},
      {"a.mp4", wish("h265", {}, {}), "--codec: .mp4 films take no codec 'h265'"},
      {"a.mp4", wish("hecv", {}, {}), "did you mean 'hevc'?"},
      {"a.webm", wish("h264", {}, {}), ".webm films take no codec 'h264'"},
      {"a.mov", wish({}, "slow", {}), "--preset: this format has none"},
      {"a.gif", wish({}, {}, 20), "--crf: this format has none; omit it, or write one of .mp4"},
      {"a.png", wish("h264", {}, {}), "--codec"},
      {"a.png", wish({}, {}, 3), "--crf"},
      {"-", wish({}, "fast", {}), "--preset"},
      {"null", wish("h264", "fast", 18), ""},
      {"hash:a.mp4", wish({}, "fast", 18), ""},
      {"a.mp4", wish({}, "fst", {}), "did you mean 'fast'?"},
  };
  for (const Asked& asked : cases) {
    std::string said;
    try {
      settle_encoder(asked.output, asked.wish);
    } catch (const Error& error) {
      said = error.what();
      EXPECT_EQ(error.fault(), Fault::input);
    }
    EXPECT_EQ(said.empty(), asked.says.empty()) << asked.output << ": " << said;
    EXPECT_NE(said.find(asked.says), std::string::npos) << said;
  }
}

TEST(Encoders, GradesAreEachCodecsOwn) {
  EncoderWish wish;
  wish.grade = Grade::archive;
  wish.preset = "slow";
  EXPECT_EQ(settle_encoder("a.mp4", wish).crf, 12);
  EXPECT_EQ(settle_encoder("a.mp4", wish).preset, "slow");
  EXPECT_TRUE(settle_encoder("a.webm", wish).finest);
  EXPECT_EQ(settle_encoder("a.mov", wish).preset, "");
  wish.codec = "av1";
  EXPECT_EQ(settle_encoder("a.mp4", wish).crf, 18);
}

TEST(Gif, AFasterFilmLosesFramesAndNoTime) {
  EXPECT_EQ(gif_step({50, 1}), 1);
  EXPECT_EQ(gif_step({51, 1}), 2);
  EXPECT_EQ(gif_step({60, 1}), 2);
  EXPECT_EQ(gif_step({60000, 1001}), 2);
  EXPECT_EQ(gif_step({1000, 1}), 20);
  EXPECT_EQ(gif_step({999999937, 10000019}), 2);

  const Way gif{find_film_format("a.gif"), &find_encoder(*find_film_format("a.gif"), "")};
  for (const FrameRate fps : {FrameRate{60, 1}, {60000, 1001}, {120, 1}, {1000, 1}}) {
    SCOPED_TRACE(fps.value());
    const TemporaryFolder folder;
    const SinkJob job = job_for(folder, gif, fps);
    const int step = gif_step(fps);
    write_film(job, 61);
    const DecodedFilm film = decode(job.output);
    ASSERT_EQ(film.frames.size(), static_cast<std::size_t>(60 / step + 1));
    for (std::size_t k = 0; k < film.frames.size(); ++k) {
      const double shown = static_cast<double>(film.pts[k] - film.pts[0]) * av_q2d(film.time_base);
      EXPECT_NEAR(shown, static_cast<double>(k) * step / fps.value(), 0.005 + 1e-9);
      // frame k * step it is, and no neighbour
      const int x = (7 + 2 * static_cast<int>(k) * step) % 64;
      EXPECT_NEAR(film.frames[k].at(x, 23)[0], 240, 6) << k;
    }
  }
}

}  // namespace
}  // namespace polhode
