// SPDX-License-Identifier: MIT
// Films, decoded again.
#include "video/film_sink.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/error.h"
#include "support/flat_image.h"
#include "support/full_disk.h"
#include "support/run.h"
#include "video/decoded_film.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::decode;
using test::DecodedFilm;
using test::TemporaryFolder;

SinkJob job_for(const std::string& output, FrameRate fps = {60, 1}) {
  SinkJob job;
  job.output = output;
  job.width = 64;
  job.height = 48;
  job.fps = fps;
  job.encoder.preset = "faster";  // with frames out of order, which "veryfast" has not
  job.title = "Title \"with\" <metadata> & umlauts ü";
  job.comment = "what made it";
  return job;
}

Image flat(const SinkJob& job, int r, int g, int b) {
  return test::flat_image(job.width, job.height, r, g, b);
}

// a white square that walks over grey
Image moving(const SinkJob& job, int index) {
  Image image = flat(job, 90, 100, 110);
  for (int y = 10; y < 20; ++y) {
    for (int x = 0; x < 10; ++x)
      std::fill_n(image.at((x + index) % job.width, y), 3, std::uint8_t{255});
  }
  return image;
}

DecodedFilm film_of(const SinkJob& job, int frames) {
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  for (int i = 0; i < frames; ++i)
    sink->push(moving(job, i));
  sink->finish();
  return decode(job.output);
}

class FilmSinkAtRates : public ::testing::TestWithParam<FrameRate> {};

TEST_P(FilmSinkAtRates, CountTimestampsAndRateAreExact) {
  const TemporaryFolder folder;
  const FrameRate fps = GetParam();
  for (const auto& [frames, preset] :
       {std::pair{1, "faster"}, {2, "faster"}, {61, "faster"}, {2, "veryfast"}, {61, "veryfast"}}) {
    SinkJob job = job_for(folder / "a.mp4", fps);
    job.encoder.preset = preset;
    const DecodedFilm film = film_of(job, frames);
    ASSERT_EQ(film.pts.size(), static_cast<std::size_t>(frames));
    EXPECT_EQ(film.start_time, 0);
    const AVRational exact{fps.numerator, fps.denominator};
    EXPECT_EQ(av_cmp_q(film.avg_frame_rate, exact), 0);
    if (frames > 2) {
      EXPECT_EQ(av_cmp_q(film.r_frame_rate, exact), 0);
    }
    // frame k is shown at exactly k / fps, and the film lasts exactly frames / fps
    const AVRational frame_time{fps.denominator, fps.numerator};
    for (int k = 0; k < frames; ++k) {
      EXPECT_EQ(av_compare_ts(film.pts[static_cast<std::size_t>(k)], film.time_base, k, frame_time),
                0)
          << k;
    }
    EXPECT_EQ(av_compare_ts(film.duration, film.time_base, frames, frame_time), 0);
  }
}
INSTANTIATE_TEST_SUITE_P(Rates,
                         FilmSinkAtRates,
                         ::testing::Values(FrameRate{60, 1},
                                           FrameRate{30000, 1001},
                                           FrameRate{25, 1},
                                           FrameRate{25, 2},
                                           FrameRate{1, 1},
                                           FrameRate{1000, 1},
                                           FrameRate{999999937, 10000019},
                                           FrameRate{24000, 1001}));

TEST(FilmSink, IsTaggedForEveryPlayer) {
  const TemporaryFolder folder;
  const DecodedFilm film = film_of(job_for(folder / "a.mp4"), 5);
  EXPECT_EQ(film.profile, FF_PROFILE_H264_HIGH);
  EXPECT_EQ(film.pixel_format, AV_PIX_FMT_YUV420P);
  EXPECT_EQ(film.range, AVCOL_RANGE_MPEG);
  EXPECT_EQ(film.matrix, AVCOL_SPC_BT709);
  EXPECT_EQ(film.primaries, AVCOL_PRI_BT709);
  EXPECT_EQ(film.transfer, AVCOL_TRC_BT709);
  EXPECT_EQ(film.chroma_location, AVCHROMA_LOC_LEFT);
  EXPECT_EQ(film.title, "Title \"with\" <metadata> & umlauts ü");
  EXPECT_EQ(film.comment, "what made it");
}

// the boxes of the file, in order: the index comes before the data
TEST(FilmSink, IndexIsInFront) {
  const TemporaryFolder folder;
  film_of(job_for(folder / "a.mp4"), 5);
  const std::string bytes = test::read_text(folder / "a.mp4");
  std::vector<std::string> boxes;
  for (std::size_t at = 0; at + 8 <= bytes.size();) {
    std::size_t size = 0;
    for (int i = 0; i < 4; ++i)
      size = size << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    boxes.push_back(bytes.substr(at + 4, 4));
    ASSERT_GE(size, 8u);
    at += size;
  }
  const auto moov = std::find(boxes.begin(), boxes.end(), "moov");
  const auto mdat = std::find(boxes.begin(), boxes.end(), "mdat");
  ASSERT_NE(moov, boxes.end());
  ASSERT_NE(mdat, boxes.end());
  EXPECT_LT(moov, mdat);
  EXPECT_EQ(boxes.front(), "ftyp");
}

TEST(FilmSink, HasAKeyframeAtLeastEverySecond) {
  for (const FrameRate fps : {FrameRate{24, 1}, {30000, 1001}, {3, 2}, {1, 1}}) {
    const TemporaryFolder folder;
    const DecodedFilm film = film_of(job_for(folder / "a.mp4", fps), 80);
    ASSERT_TRUE(film.key[0]);
    int since = 0;
    for (const bool key : film.key) {
      since = key ? 1 : since + 1;
      EXPECT_TRUE(since <= fps.value() || since == 1) << fps.value() << ": " << since;
    }
  }
}

// what comes after a keyframe in the file is never shown before it, so a film can be cut there;
// B-frames, which could break that, are there
TEST(FilmSink, GroupsAreClosed) {
  const TemporaryFolder folder;
  const DecodedFilm film = film_of(job_for(folder / "a.mp4", {24, 1}), 80);
  std::int64_t shown = INT64_MIN;
  std::int64_t key = INT64_MIN;
  int keys = 0;
  bool reordered = false;
  for (const DecodedFilm::Packet& packet : film.packets) {
    if (packet.key) {
      EXPECT_GT(packet.pts, shown) << "something of the last group is shown after the keyframe";
      EXPECT_TRUE(packet.idr) << "a recovery point is no closed group";
      key = packet.pts;
      ++keys;
    }
    EXPECT_GE(packet.pts, key);
    reordered = reordered || packet.pts < shown;
    shown = std::max(shown, packet.pts);
  }
  EXPECT_GE(keys, 4);
  EXPECT_TRUE(reordered) << "no B-frames: this test says nothing";
}

struct Color {
  int r, g, b;
};
class FilmSinkColours : public ::testing::TestWithParam<Color> {};

TEST_P(FilmSinkColours, ComeBackWithinTwoLevels) {
  const TemporaryFolder folder;
  const SinkJob job = job_for(folder / "a.mp4");
  const auto [r, g, b] = GetParam();
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  for (int i = 0; i < 3; ++i)
    sink->push(flat(job, r, g, b));
  sink->finish();
  const DecodedFilm film = decode(job.output);
  ASSERT_EQ(film.frames.size(), 3u);
  for (const auto& [x, y] : {std::pair{0, 0}, {63, 0}, {0, 47}, {63, 47}, {32, 24}}) {
    const std::uint8_t* pixel = film.frames[1].at(x, y);
    EXPECT_NEAR(pixel[0], r, 2);
    EXPECT_NEAR(pixel[1], g, 2);
    EXPECT_NEAR(pixel[2], b, 2);
  }
}
INSTANTIATE_TEST_SUITE_P(Flat,
                         FilmSinkColours,
                         ::testing::Values(Color{0, 0, 0},
                                           Color{255, 255, 255},
                                           Color{255, 0, 0},
                                           Color{0, 255, 0},
                                           Color{0, 0, 255},
                                           Color{128, 128, 128},
                                           Color{16, 20, 28},
                                           Color{240, 165, 30},
                                           Color{92, 184, 238}));

// H.264's colour samples lie on the left of the two pixels they cover: a ramp of blue comes back
// where it was, not half a pixel beside it
TEST(FilmSink, ColourLiesWherePlayersLookForIt) {
  const TemporaryFolder folder;
  SinkJob job = job_for(folder / "a.mp4");
  job.encoder.crf = 1;
  constexpr int kSlope = 3;  // levels a pixel
  Image ramp = flat(job, 100, 100, 0);
  for (int y = 0; y < job.height; ++y) {
    for (int x = 0; x < job.width; ++x)
      ramp.at(x, y)[2] = static_cast<std::uint8_t>(20 + kSlope * x);
  }
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  sink->push(ramp);
  sink->finish();
  const DecodedFilm film = decode(job.output);
  ASSERT_EQ(film.blue_difference.size(), 1u);

  // the blue that each colour sample stands for, away from the borders, in pixels of the ramp
  double shift = 0.0;
  int count = 0;
  for (int x = 4; x < job.width / 2 - 4; ++x, ++count) {
    const int sample = film.blue_difference[0][static_cast<std::size_t>(x)];
    const double blue = 100.0 + (sample - 128) * 255.0 / 224.0 * 2.0;
    shift += (blue - 20.0) / kSlope - 2 * x;
  }
  EXPECT_NEAR(shift / count, 0.0, 0.15);
}

#ifdef __GLIBC__
// fills the memory that malloc gives, and that free takes, with one byte
class FilledMemory {
 public:
  explicit FilledMemory(int byte) { mallopt(M_PERTURB, byte); }
  FilledMemory(const FilledMemory&) = delete;
  FilledMemory& operator=(const FilledMemory&) = delete;
  ~FilledMemory() { mallopt(M_PERTURB, 0); }
};
#else
struct FilledMemory {
  explicit FilledMemory(int) {}
};
#endif

// waves that run, so that no block is like another
Image waves(const SinkJob& job, int index) {
  Image image = flat(job, 0, 0, 0);
  for (int y = 0; y < job.height; ++y) {
    for (int x = 0; x < job.width; ++x) {
      const double level = 128.0 + 60.0 * std::sin(0.004 * x * y + index) +
                           60.0 * std::sin(0.3 * x - 0.2 * y - 2.0 * index);
      std::fill_n(image.at(x, y), 3, static_cast<std::uint8_t>(level));
    }
  }
  return image;
}

// whatever lay in the memory that the encoder takes
TEST(FilmSink, SameFramesGiveTheSameFile) {
  const TemporaryFolder folder;
  for (const int width : {64, 96, 160, 256, 480, 720}) {
    SinkJob job = job_for(folder / "a.mp4");
    job.width = width;
    job.height = width * 9 / 16 / 2 * 2;
    std::string first;
    for (const int byte : {0, 1, 85, 200}) {
      const FilledMemory filled(byte);
      const std::unique_ptr<FrameSink> sink = make_sink(job);
      for (int i = 0; i < 4; ++i)
        sink->push(waves(job, i));
      sink->finish();
      const std::string file = test::read_text(job.output);
      if (first.empty()) first = file;
      EXPECT_TRUE(file == first) << width << " pixels wide, memory of " << byte;
    }
  }
}

double own_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// x264 works in threads of its own: what they use is counted beside what this one does
TEST(FilmSink, TheEncodersThreadsAreCounted) {
  const TemporaryFolder folder;
  SinkJob job = job_for(folder / "a.mp4");
  job.width = 256;
  job.height = 256;
  job.encoder.preset = "medium";
  std::mt19937 random(1);
  Image noise(job.width, job.height);
  for (std::uint8_t& value : noise.pixels)
    value = static_cast<std::uint8_t>(random() & 255);
  const double before = own_cpu_seconds();
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  for (int i = 0; i < 16; ++i)
    sink->push(noise);
  sink->finish();
  const double own = own_cpu_seconds() - before;
  const SinkTimes times = sink->times();
  EXPECT_GT(times.encode.wall_s, 0.0);
  EXPECT_GT(times.convert.cpu_s, 0.0);
  EXPECT_GT(times.encode.cpu_s + times.convert.cpu_s, own);
}

TEST(FilmSink, AbandonedLeavesNothingAndKeepsTheOldOne) {
  const TemporaryFolder folder;
  test::write_text(folder / "a.mp4", "an older film");
  {
    const SinkJob job = job_for(folder / "a.mp4");
    const std::unique_ptr<FrameSink> sink = make_sink(job);
    for (int i = 0; i < 20; ++i)
      sink->push(moving(job, i));
  }
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(test::read_text(folder / "a.mp4"), "an older film");
}

// wherever the disk becomes full: at the first byte, amid the frames, while the index moves to the
// front, near the end
TEST(FilmSink, AFullDiskIsAnErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  const SinkJob job = job_for(folder / "a.mp4");
  film_of(job, 30);
  const auto whole = static_cast<rlim_t>(std::filesystem::file_size(job.output));
  std::filesystem::remove(job.output);
  const auto make = [&] {
    const std::unique_ptr<FrameSink> sink = make_sink(job);
    for (int i = 0; i < 30; ++i)
      sink->push(moving(job, i));
    sink->finish();
  };
  for (const rlim_t most :
       {rlim_t{0}, rlim_t{1}, rlim_t{40}, whole / 4, whole / 2, whole * 9 / 10}) {
    EXPECT_EQ(test::with_full_disk(most, make), test::Outcome::environment) << most;
    EXPECT_EQ(folder.entries(), 0) << most;
  }
  EXPECT_EQ(test::with_full_disk(whole + 4096, make), test::Outcome::done);
  EXPECT_EQ(folder.entries(), 1);
}

// libav would take what stands before a colon for a protocol
TEST(FilmSink, ANameIsAFileEvenIfItLooksLikeAnAddress) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  for (const char* name : {"take:1.mp4", "http:a.mp4", "pipe:1.mp4", "file:a.mp4", "%s 50%.mp4"}) {
    try {
      film_of(job_for(name), 2);
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  EXPECT_EQ(folder.entries(), 5);
  std::filesystem::current_path(before);
}

TEST(FilmSink, EveryPresetOpens) {
  const TemporaryFolder folder;
  for (const std::string& preset : encoder_presets()) {
    SinkJob job = job_for(folder / "a.mp4");
    job.encoder.preset = preset;
    EXPECT_NO_THROW(make_sink(job)) << preset;
  }
}

}  // namespace
}  // namespace polhode
