// SPDX-License-Identifier: MIT
#include "chart/plot_stability.h"

#include <array>
#include <map>

#include <gtest/gtest.h>

#include "image/png.h"
#include "support/run.h"
#include "support/words.h"

namespace polhode::test {
namespace {

const MapAxis kStep{"numerics.step", 0.01, 1.0, 3};
const MapAxis kPlace{"motion.position[0]", -1.0, 1.0, 2};

// three cells by two: all fine but the middle one of the upper row
StabilityMap some_map() {
  StabilityMap map;
  map.scene = "top";
  map.method = "rk4";
  map.title = "Title";
  map.limit = {{0.05, -1.0}, {0.2, 1.0}};
  map.cells.resize(6);
  map.cells[4].outcome = RunOutcome::phase_wrong;
  return map;
}

TEST(PlotStability, AxesAreEvenlyDivided) {
  EXPECT_TRUE(kStep.logarithmic());
  EXPECT_FALSE(kPlace.logarithmic());
  EXPECT_NEAR(kStep.at(1), 0.1, 1e-15);
  EXPECT_EQ(kPlace.at(0), -1.0);
  EXPECT_EQ(kPlace.at(1), 1.0);
  EXPECT_EQ((MapAxis{"x", 3.0, 9.0, 1}.at(0)), 3.0);
}

TEST(PlotStability, TheTableHasARowForEachCell) {
  const std::string csv = stability_csv({some_map()}, kStep, kPlace);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "scene,method,x,y,verdict,error_rad,energy_drift,momentum_drift");
  EXPECT_NE(csv.find("top,rk4,0.1,1,phase_wrong,0,0,0\n"), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
}

TEST(PlotStability, PicturesNameWhatTheyShow) {
  const StabilityMap map = some_map();
  for (const std::vector<const StabilityMap*>& maps :
       {std::vector<const StabilityMap*>{&map}, {&map, &map}}) {
    const std::string svg = plot_stability(maps, kStep, kPlace, PlotFormat::svg);
    for (const char* words : {"Title", "rk4", "phase wrong", "numerics.step", "limit of theory"})
      EXPECT_NE(svg.find(words), std::string::npos) << words;
  }
}

// neither colours between two cells nor a key to a curve that is not there
TEST(PlotStability, PicturesShowNothingThatIsNotThere) {
  StabilityMap map = some_map();
  const auto drawn = [&] {
    return plot_stability({&map}, kStep, kPlace, PlotFormat::svg) +
           plot_stability({&map, &map}, kStep, kPlace, PlotFormat::svg);
  };
  EXPECT_EQ(count_of(drawn(), "<image image-rendering='pixelated' "), 3);
  EXPECT_EQ(count_of(drawn(), "<image "), 3);
  EXPECT_GT(count_of(drawn(), "limit of theory"), 0);
  for (LimitPoint& point : map.limit)
    point.x = 2.0 * kStep.to;
  EXPECT_EQ(count_of(drawn(), "limit of theory"), 0);
}

// the pixels of the picture: each cell has a sixth of the map, and the odd one is where it belongs
TEST(PlotStability, CellsHaveTheColourOfTheirOutcomeInTheirPlace) {
  StabilityMap map = some_map();
  map.limit.clear();
  const TemporaryFolder folder;
  write_text(folder / "a.png", plot_stability({&map}, kStep, kPlace, PlotFormat::png));
  const Image image = read_png(folder / "a.png");
  struct PixelBox {
    double count = 0.0, x = 0.0, y = 0.0;
  };
  std::map<std::array<int, 3>, PixelBox> regions;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      PixelBox& region = regions[{p[0], p[1], p[2]}];
      ++region.count;
      region.x += x;
      region.y += y;
    }
  }
  const PixelBox& fine = regions[{0xe8, 0xf1, 0xe4}];
  const PixelBox& wrong = regions[{0x9c, 0xc3, 0xe6}];
  ASSERT_GT(wrong.count, 1000.0);
  EXPECT_NEAR(fine.count / wrong.count, 5.0, 0.1);
  // the middle of the whole map, from both; the odd cell is as far left of it as right, and above
  const double total = fine.count + wrong.count;
  EXPECT_NEAR(wrong.x / wrong.count, (fine.x + wrong.x) / total, 2.0);
  EXPECT_LT(wrong.y / wrong.count, (fine.y + wrong.y) / total - 50.0);
}

}  // namespace
}  // namespace polhode::test
