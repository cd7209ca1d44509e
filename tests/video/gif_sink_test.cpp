// SPDX-License-Identifier: MIT
#include "video/gif_sink.h"

#include <set>

#include <gtest/gtest.h>

#include "video/every_format.h"

namespace polhode {
namespace {

using test::decode;
using test::DecodedFilm;
using test::job_for;
using test::TemporaryFolder;
using test::walking;
using test::Way;
using test::write_film;

TEST(GifSink, AFasterFilmLosesFramesAndNoTime) {
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

// the program that follows learns which frames are kept
TEST(GifSink, KeepsEveryNthFrame) {
  const Way gif{find_film_format("a.gif"), &find_encoder(*find_film_format("a.gif"), "")};
  const TemporaryFolder folder;
  EXPECT_EQ(make_gif_sink(job_for(folder, gif, {60, 1}))->keeps_every(), 2);
  EXPECT_EQ(make_gif_sink(job_for(folder, gif, {25, 1}))->keeps_every(), 1);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace polhode
