// SPDX-License-Identifier: MIT
#include "video/gif_sink.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "video/every_format.h"
#include "video/film_reader.h"

namespace polhode {
namespace {

using test::decode;
using test::DecodedFilm;
using test::job_for;
using test::TemporaryFolder;
using test::walking;
using test::Way;
using test::write_film;

TEST(GifSink, HasAtMostFiftyFramesASecond) {
  EXPECT_EQ(gif_rate({50, 1}), (FrameRate{50, 1}));
  EXPECT_EQ(gif_rate({51, 1}), (FrameRate{51, 2}));
  EXPECT_EQ(gif_rate({60, 1}), (FrameRate{30, 1}));
  EXPECT_EQ(gif_rate({60000, 1001}), (FrameRate{30000, 1001}));
  EXPECT_EQ(gif_rate({1000, 1}), (FrameRate{50, 1}));
  EXPECT_EQ(gif_rate({999999937, 10000019}), (FrameRate{999999937, 20000038}));
}

TEST(GifSink, ShowsFramesAtTheirTimes) {
  const Way gif{find_film_format("a.gif"), &find_encoder(*find_film_format("a.gif"), "")};
  for (const FrameRate fps : {FrameRate{30, 1}, {30000, 1001}, {40, 1}, {50, 1}}) {
    SCOPED_TRACE(fps.value());
    const TemporaryFolder folder;
    const SinkJob job = job_for(folder, gif, fps);
    write_film(job, 31);
    const DecodedFilm film = decode(job.output);
    ASSERT_EQ(film.frames.size(), 31u);
    for (std::size_t k = 0; k < film.frames.size(); ++k) {
      const double shown = static_cast<double>(film.pts[k] - film.pts[0]) * av_q2d(film.time_base);
      EXPECT_NEAR(shown, static_cast<double>(k) / fps.value(), 0.005 + 1e-9);
      // frame k it is, and no neighbour
      const int x = (7 + 2 * static_cast<int>(k)) % 64;
      EXPECT_NEAR(film.frames[k].at(x, 23)[0], 240, 6) << k;
    }
  }
}

// the last row that has something is wider than those above, which libav would cut off
TEST(GifSink, KeepsTheLowestRowOfWhatIsThere) {
  const Way gif{find_film_format("a.gif"), &find_encoder(*find_film_format("a.gif"), "")};
  const TemporaryFolder folder;
  SinkJob job = job_for(folder, gif);
  job.transparent = true;
  Image image(job.width, job.height);
  for (int y = 10; y <= 30; ++y) {
    const int half = y == 30 ? 20 : 4;
    for (int x = 32 - half; x < 32 + half; ++x)
      std::fill_n(image.at(x, y), 4, std::uint8_t{255});
  }
  const std::unique_ptr<FrameSink> sink = make_gif_sink(job);
  sink->push(image);
  sink->finish();
  FilmReader reader(job.output);
  Image shown;
  double time = 0.0;
  ASSERT_TRUE(reader.next(shown, time));
  for (int y = 0; y < job.height; ++y) {
    for (int x = 0; x < job.width; ++x)
      ASSERT_EQ(shown.at(x, y)[3], image.at(x, y)[3]) << x << " " << y;
  }
}

// one palette for the whole film: its colours stay the same from frame to frame, and are at most
// 256, of which the few that the film has come back nearly as they were
TEST(GifSink, OnePaletteServesTheWholeFilm) {
  const Way gif{find_film_format("a.gif"), &find_encoder(*find_film_format("a.gif"), "")};
  const TemporaryFolder folder;
  const SinkJob job = job_for(folder, gif);
  write_film(job, 12);
  const DecodedFilm film = decode(job.output);
  ASSERT_EQ(film.frames.size(), 12u);
  std::set<std::array<int, 3>> first, all;
  for (std::size_t k = 0; k < film.frames.size(); ++k) {
    for (std::size_t i = 0; i < film.frames[k].pixels.size(); i += 4) {
      const std::uint8_t* p = &film.frames[k].pixels[i];
      all.insert({p[0], p[1], p[2]});
      if (k == 0) first.insert({p[0], p[1], p[2]});
    }
  }
  EXPECT_LE(all.size(), 256u);
  EXPECT_EQ(all, first);
}

}  // namespace
}  // namespace polhode
