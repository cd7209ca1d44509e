// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "base/error.h"
#include "frame/compose.h"
#include "image/compare.h"
#include "render/renderer.h"
#include "support/edge_truth.h"
#include "support/motions.h"

namespace polhode {
namespace {

constexpr PictureSize kWideSize{320, 180};

DrawList example(double t) {
  const BodySpec body = test::prolate_body();
  return Composer(test::moving(body, test::wobbling()),
                  body,
                  CameraSpec{},
                  ShowSpec{},
                  ThemeSpec{},
                  kWideSize)
      .at(t);
}

Image draw(const DrawList& list,
           const std::string& backend,
           bool transparent = false,
           Edges edges = Edges::by_size) {
  const std::unique_ptr<Context> context = open_context(backend);
  Renderer renderer(*context, {kWideSize.width, kWideSize.height, 4, transparent, edges});
  Image image;
  renderer.draw(list, image);
  return image;
}

TEST(Renderer, BothBackEndsGiveTheSameBytes) {
  for (const Edges edges : {Edges::samples, Edges::outlines}) {
    EXPECT_EQ(draw(example(0.4), "osmesa", false, edges).pixels,
              draw(example(0.4), "egl", false, edges).pixels);
  }
}

TEST(Renderer, OrderOfFramesDoesNotMatter) {
  const std::unique_ptr<Context> context = open_context("auto");
  Renderer renderer(*context, {kWideSize.width, kWideSize.height, 4, false});
  Image first;
  Image other;
  Image again;
  renderer.draw(example(0.4), first);
  renderer.draw(example(3.1), other);
  renderer.draw(example(0.4), again);
  EXPECT_EQ(first.pixels, again.pixels);
  EXPECT_NE(first.pixels, other.pixels);
}

// a renderer in the middle of a film draws what a fresh one would, into a picture of its own or
// into one that was drawn before
TEST(Renderer, AFilmIsItsFramesDrawnAlone) {
  // a film, then another background, then nothing but background
  std::vector<DrawList> lists;
  for (double t = 0.0; t < 4.0; t += 0.41)
    lists.push_back(example(t));
  lists.push_back(example(1.0));
  lists.back().background = glm::vec3(0.5f);
  lists.push_back({});
  lists.back().background = glm::vec3(0.5f);
  for (const bool transparent : {false, true}) {
    for (const Edges edges : {Edges::samples, Edges::outlines}) {
      std::vector<Image> alone;
      for (const DrawList& list : lists)
        alone.push_back(draw(list, "auto", transparent, edges));

      const std::unique_ptr<Context> context = open_context("auto");
      Renderer renderer(*context, {kWideSize.width, kWideSize.height, 4, transparent, edges});
      Image used;
      for (std::size_t i = 0; i < lists.size(); ++i) {
        Image fresh;
        renderer.draw(lists[i], fresh);
        ASSERT_TRUE(fresh.pixels == alone[i].pixels) << i;
        renderer.draw(lists[i], used);
        ASSERT_TRUE(used.pixels == alone[i].pixels) << i;
      }
    }
  }
}

// what a picture says of itself: outside the painted boxes there is nothing but ground
TEST(Renderer, NothingIsOutsideThePaintedBoxes) {
  Image image = draw(example(0.4), "auto");
  ASSERT_TRUE(image.ground);
  ASSERT_FALSE(image.painted.empty());
  for (const PixelBox& box : image.painted)
    image.fill(box, *image.ground);
  Image plain;
  plain.wipe(image.width, image.height, *image.ground);
  EXPECT_EQ(image.pixels, plain.pixels);
}

// against the mean of 64 pictures, each a part of a pixel aside: outlines serve at least as well as
// four samples from the size on at which they are taken
TEST(Renderer, OutlinesAreNoWorseThanFourSamples) {
  constexpr PictureSize kLarge{960, 540};
  const BodySpec body = test::prolate_body();
  const Composer composer(
      test::moving(body, test::wobbling()), body, CameraSpec{}, ShowSpec{}, ThemeSpec{}, kLarge);
  const DrawList list = composer.at(0.7);
  const std::unique_ptr<Context> context = open_context("auto");
  const auto drawn = [&](const DrawList& what, int samples, Edges edges) {
    Renderer renderer(*context, {kLarge.width, kLarge.height, samples, false, edges});
    EXPECT_EQ(renderer.info().by_outlines, edges == Edges::outlines);
    Image image;
    renderer.draw(what, image);
    return image;
  };
  Picture picture;
  picture.panels.push_back({{0, 0, kLarge.width, kLarge.height}, list});
  const std::vector<double> truth =
      test::edge_truth(*context, picture, kLarge.width, kLarge.height);
  const auto error = [&](const Image& image) {
    return std::sqrt(test::mean_square_error(image, truth));
  };
  const double none = error(drawn(list, 0, Edges::samples));
  const double four = error(drawn(list, 4, Edges::samples));
  const double outlines = error(drawn(list, 4, Edges::outlines));
  EXPECT_LT(outlines, four);
  EXPECT_LT(four, 0.5 * none);
}

// a panel is drawn as if it were a picture by itself, whatever its neighbours do
TEST(Renderer, PanelsAreTheirPicturesSideBySide) {
  const std::vector<double> times = {0.4, 0.7, 3.1};
  const std::unique_ptr<Context> context = open_context("auto");
  std::vector<Image> alone(2 * times.size());
  Renderer small(*context, {kWideSize.width, kWideSize.height, 4, false});
  for (std::size_t i = 0; i < times.size(); ++i) {
    small.draw(example(times[i]), alone[2 * i]);
    small.draw(example(2.0 * times[i]), alone[2 * i + 1]);
  }
  Renderer whole(*context, {2 * kWideSize.width, kWideSize.height, 4, false});
  for (std::size_t i = 0; i < times.size(); ++i) {
    Picture picture;
    picture.panels.push_back({{0, 0, kWideSize.width, kWideSize.height}, example(times[i])});
    picture.panels.push_back(
        {{kWideSize.width, 0, kWideSize.width, kWideSize.height}, example(2.0 * times[i])});
    Image together;
    whole.draw(picture, together);
    for (std::size_t side = 0; side < 2; ++side) {
      // places are rounded to 1/256 of a pixel elsewhere: a sample on an edge may fall otherwise
      Image part(kWideSize.width, kWideSize.height);
      for (int y = 0; y < kWideSize.height; ++y) {
        const std::uint8_t* from = together.at(static_cast<int>(side) * kWideSize.width, y);
        std::copy_n(from, 4 * kWideSize.width, part.at(0, y));
      }
      const Difference difference = compare(alone[2 * i + side], part, 3);
      EXPECT_LT(difference.fraction_over, 2e-4) << times[i] << ' ' << side;
      EXPECT_LE(difference.largest, 70) << times[i] << ' ' << side;
    }
  }
}

TEST(Renderer, CornersAreTheBackground) {
  DrawList list = example(0.4);
  list.background = glm::vec3(16, 32, 200) / 255.0f;
  const Image image = draw(list, "auto");
  for (const auto& [x, y] : {std::pair{0, 0}, {319, 0}, {0, 179}, {319, 179}}) {
    EXPECT_EQ(image.at(x, y)[0], 16);
    EXPECT_EQ(image.at(x, y)[1], 32);
    EXPECT_EQ(image.at(x, y)[2], 200);
    EXPECT_EQ(image.at(x, y)[3], 255);
  }
}

// a transparent picture laid over the background is the opaque picture
TEST(Renderer, TransparentPictureCompositesToTheOpaqueOne) {
  const DrawList list = example(0.4);
  const Image opaque = draw(list, "auto");
  const Image clear = draw(list, "auto", true);
  EXPECT_EQ(clear.at(0, 0)[3], 0);
  int worst = 0;
  for (int y = 0; y < kWideSize.height; ++y) {
    for (int x = 0; x < kWideSize.width; ++x) {
      const double alpha = clear.at(x, y)[3] / 255.0;
      for (int c = 0; c < 3; ++c) {
        const double over = clear.at(x, y)[c] * alpha + 255.0 * list.background[c] * (1.0 - alpha);
        worst = std::max(worst, static_cast<int>(std::abs(over - opaque.at(x, y)[c])));
      }
    }
  }
  EXPECT_LE(worst, 2);
}

// the mark shows the spin: the same solid half a turn later is another picture
TEST(Renderer, MarkTellsHalfATurn) {
  BodySpec body = test::ellipsoid_body({0.1, 0.1, 0.1});
  MotionSpec motion;
  motion.spin.body = Vec3(0, 0, 3.14159265358979);
  motion.duration = 2.0;
  ShowSpec show;
  show["omega"] = show["momentum"] = show["space_axes"] = false;
  const Composer composer(
      test::moving(body, motion), body, CameraSpec{}, show, ThemeSpec{}, kWideSize);
  const Image now = draw(composer.at(0.0), "auto");
  const Image half = draw(composer.at(1.0), "auto");
  const Image full = draw(composer.at(2.0), "auto");
  int differs_half = 0;
  int differs_full = 0;
  for (std::size_t i = 0; i < now.pixels.size(); ++i) {
    differs_half += std::abs(now.pixels[i] - half.pixels[i]) > 12 ? 1 : 0;
    differs_full += std::abs(now.pixels[i] - full.pixels[i]) > 12 ? 1 : 0;
  }
  EXPECT_GT(differs_half, 2000);
  EXPECT_LT(differs_full, 20);
}

// edges are smooth: a slanted edge has several levels between inside and outside
TEST(Renderer, SmallPicturesHaveFourSamples) {
  const std::unique_ptr<Context> context = open_context("auto");
  const Renderer renderer(*context, {64, 64, 4, false});
  EXPECT_EQ(renderer.info().samples, 4);
  const Image image = draw(example(0.4), "auto", true);
  int partial = 0;
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
    partial += image.pixels[i] > 40 && image.pixels[i] < 70 ? 1 : 0;
  }
  EXPECT_GT(partial, 20) << "pixels a quarter covered";
}

TEST(Renderer, AbsurdSizeIsAnInputError) {
  const std::unique_ptr<Context> context = open_context("auto");
  try {
    const Renderer renderer(*context, {200000, 16, 4, false});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::input);
  }
}

}  // namespace
}  // namespace polhode
