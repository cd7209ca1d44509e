// SPDX-License-Identifier: MIT
// Every kind of film, decoded again.
#include "video/encoders.h"

#include <algorithm>
#include <cstdlib>

#include "base/error.h"
#include "support/full_disk.h"
#include "video/every_format.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::all_ways;
using test::decode;
using test::DecodedFilm;
using test::job_for;
using test::paint;
using test::some_metadata;
using test::TemporaryFolder;
using test::walking;
using test::Way;
using test::write_film;

std::string alpha_decoder(const Way& way) {
  return way.encoder->codec == "vp9" ? "libvpx-vp9" : "";
}

// the unit in which the container keeps times, s; 0: exact
double unit_of(const Way& way) {
  if (way.format->ending == ".webm") return 1e-3;
  if (way.format->ending == ".gif") return 1e-2;
  return 0.0;
}

TEST(Encoders, CountSizeAndTimesAreExact) {
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
TEST(Encoders, DelaysOfAnApngAreExactFractions) {
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

TEST(Encoders, PicturesComeBack) {
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

TEST(Encoders, AlphaIsKeptStraight) {
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
TEST(Encoders, HalfClearIsHalfClear) {
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

TEST(Encoders, SameFramesGiveTheSamePictures) {
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

// wherever it becomes full
TEST(Encoders, AFullDiskIsAnErrorAndLeavesNothing) {
  for (const Way& way : all_ways()) {
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const SinkJob job = job_for(folder, way);
    const auto make = [&] {
      write_film(job, 12, some_metadata());
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

TEST(Encoders, AbandonedLeavesNothingAndKeepsTheOldOnes) {
  for (const Way& way : all_ways()) {
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    const SinkJob job = job_for(folder, way);
    test::write_text(job.output, "an older film");
    test::write_text(folder / "a.vtt", "WEBVTT - captions by polhode\nolder");
    {
      const std::unique_ptr<FrameSink> sink = make_sink(job);
      sink->describe(some_metadata());
      for (int i = 0; i < 20; ++i) {
        sink->push(walking(job, i));
      }
    }
    EXPECT_EQ(folder.entries(), 2);
    EXPECT_EQ(test::read_text(job.output), "an older film");
    EXPECT_EQ(test::read_text(folder / "a.vtt"), "WEBVTT - captions by polhode\nolder");
  }
}

TEST(Encoders, EveryPresetOpens) {
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
TEST(Encoders, EveryEncoderOfTheTableIsThereOrSaysWhatToInstall) {
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

}  // namespace
}  // namespace polhode
