// SPDX-License-Identifier: MIT
#include "app/compare/diff_page.h"

#include <gtest/gtest.h>

#include "base/base64.h"
#include "image/png.h"
#include "support/flat_image.h"
#include "support/words.h"

namespace polhode {
namespace {

using test::count_of;
using test::has;

constexpr int kWide = 40, kHigh = 30;

// a grey picture of which one pixel is brighter by so much
ShownFrame shown_frame(int brighter) {
  ShownFrame shown;
  shown.reference = test::flat_image(kWide, kHigh, 100, 100, 100);
  shown.actual = shown.reference;
  shown.actual.at(20, 15)[1] = static_cast<std::uint8_t>(100 + brighter);
  shown.flip = flip(shown.reference, shown.actual);
  shown.score.values = compare(shown.actual, shown.reference, 3);
  if (brighter > 3) shown.score.reason = "it is brighter";
  return shown;
}

std::string page_of(const std::vector<ShownFrame>& shown,
                    const std::vector<FrameScore>& scores,
                    const Thresholds& thresholds = {},
                    bool film = false) {
  const DiffSummary summary = summarise(scores);
  return diff_page({"a<b>.png",
                    "ref & co",
                    summary.different == 0,
                    "because <it> is",
                    thresholds,
                    summary,
                    scores,
                    shown,
                    film});
}

TEST(DiffPage, HoldsThePicturesThemselves) {
  const ShownFrame shown = shown_frame(90);
  const std::string page = page_of({shown}, {shown.score});
  EXPECT_TRUE(has(page, base64(encode_png(shown.reference, false))));
  EXPECT_TRUE(has(page, base64(encode_png(shown.actual, false))));
  EXPECT_TRUE(
      has(page, base64(encode_png(difference_picture(shown.reference, shown.actual, 16), false))));
  // four pictures of the whole, four of its worst region
  EXPECT_EQ(count_of(page, "src=\"data:image/png;base64,"), 8U);
  EXPECT_TRUE(has(page, "Worst region: 32×18 pixels at "));
  EXPECT_FALSE(has(page, "http")) << "no page may need a network";
}

TEST(DiffPage, PicturesThatAreTheSameHaveNoWorstRegion) {
  const ShownFrame shown = shown_frame(0);
  const std::string page = page_of({shown}, {shown.score});
  EXPECT_EQ(count_of(page, "src=\"data:image/png;base64,"), 4U);
  EXPECT_FALSE(has(page, "Worst region"));
  EXPECT_TRUE(has(page, "<p class=\"verdict good\">Same</p>"));
  EXPECT_TRUE(has(page, "<title>Same: "));
  EXPECT_FALSE(has(page, "class=\"bad\""));
}

TEST(DiffPage, NamesAndReasonsStayText) {
  const ShownFrame shown = shown_frame(90);
  const std::string page = page_of({shown}, {shown.score});
  EXPECT_TRUE(has(page, "<h1>a&lt;b&gt;.png against ref &amp; co</h1>"));
  EXPECT_TRUE(has(page, "<p class=\"verdict bad\">Different: because &lt;it&gt; is</p>"));
  EXPECT_FALSE(has(page, "a<b>"));
}

// each number beside what is allowed, red where it is more
TEST(DiffPage, NumbersBeyondTheirThresholdAreMarked) {
  ShownFrame shown = shown_frame(90);
  Thresholds thresholds;
  std::string page = page_of({shown}, {shown.score}, thresholds);
  EXPECT_TRUE(has(page, "<td class=\"bad\">90 levels of 255</td><td class=\"soft\">limit 70</td>"));
  EXPECT_TRUE(has(page, "<td class=\"bad\">" + percent(1.0 / (kWide * kHigh)) + "</td>"));
  EXPECT_FALSE(has(page, "SSIM</th>")) << "nobody has measured it";
  shown.score.ssim = 0.5;
  shown.score.flip = 0.25;
  thresholds.limit = 90;
  thresholds.fraction = 0.1;
  thresholds.ssim = 0.6;
  thresholds.flip = 0.3;
  page = page_of({shown}, {shown.score}, thresholds);
  EXPECT_TRUE(has(page, "<td>90 levels of 255</td><td class=\"soft\">limit 90</td>"));
  EXPECT_TRUE(has(page, "<td class=\"bad\">0.500000</td><td class=\"soft\">least 0.6</td>"));
  EXPECT_TRUE(has(page, "<td>0.250000</td><td class=\"soft\">most 0.3</td>"));
  EXPECT_EQ(count_of(page, "class=\"bad\""), 1U);
}

// of four frames the third is different: a red column at its place, as high as its difference
TEST(DiffPage, FilmsHaveAStripOfAllFrames) {
  std::vector<FrameScore> scores(4);
  for (int i = 0; i < 4; ++i) {
    scores[static_cast<std::size_t>(i)].index = i;
    scores[static_cast<std::size_t>(i)].time = 0.5 * i;
  }
  scores[1].values.largest = 51;
  scores[2].values.largest = 255;
  scores[2].reason = "worse";
  const std::string page = page_of({}, scores, {}, true);
  EXPECT_TRUE(has(page, "<path class=\"fine\" d=\"M1 100v-20h1v20z\"/>"));
  EXPECT_TRUE(has(page, "<path class=\"over\" d=\"M2 100v-100h1v100z\"/>"));
  EXPECT_TRUE(has(page, "<span>0 s</span><span>1.5 s</span>"));
  EXPECT_TRUE(has(page, "1 of 4 frames are different"));
  // the limit of 70 levels is a line at its height
  EXPECT_TRUE(has(page, "y1=\"72.55\" y2=\"72.55\""));
  EXPECT_TRUE(has(page_of({}, scores), "<span>first</span><span>last of 4</span>"));
}

// no wider than a screen: of the frames that share a column the worst shows
TEST(DiffPage, LongFilmsShareColumns) {
  std::vector<FrameScore> scores(6000);
  scores[5995].values.largest = 255;
  const std::string page = page_of({}, scores, {}, true);
  EXPECT_TRUE(has(page, "viewBox=\"0 0 600 100\""));
  EXPECT_TRUE(has(page, "d=\"M599 100v-100h1v100z\""));
}

TEST(DiffPage, SeveralFramesHaveTheirTitleAndVerdict) {
  ShownFrame bad = shown_frame(90), good = shown_frame(2);
  bad.title = "frame <7>";
  good.title = "frame 9";
  const std::string page = page_of({bad, good}, {bad.score, good.score});
  EXPECT_TRUE(
      has(page, "<h2>Worst: frame &lt;7&gt;</h2>\n<p class=\"verdict bad\">it is brighter"));
  EXPECT_TRUE(has(page, "<h2>Worst: frame 9</h2>\n<p class=\"verdict good\">Same</p>"));
}

TEST(GoldenPage, ListsAllCasesAndShowsThoseWithPictures) {
  GoldenSection good{"top", "same", true, "", {}, {}};
  GoldenSection bad{"plane <x>", "different", false, "it & more", {}, {shown_frame(90)}};
  const std::string page = golden_page("Our <pictures>", {good, bad});
  EXPECT_TRUE(has(page, "<h1>Our &lt;pictures&gt;</h1>"));
  EXPECT_TRUE(has(page, "<p class=\"verdict bad\">1 of 2 cases failed</p>"));
  EXPECT_TRUE(has(page, "<td>top</td><td class=\"good\">same</td>"));
  EXPECT_TRUE(has(page, "<a href=\"#case-1\">plane &lt;x&gt;</a></td><td class=\"bad\">different"));
  EXPECT_TRUE(has(page,
                  "<section id=\"case-1\"><h2>plane &lt;x&gt;</h2>\n"
                  "<p class=\"verdict bad\">it &amp; more</p>"));
  EXPECT_EQ(count_of(page, "src=\"data:image/png;base64,"), 8U);
  EXPECT_TRUE(has(golden_page("t", {good, good}), "All 2 cases are the same"));
}

}  // namespace
}  // namespace polhode
