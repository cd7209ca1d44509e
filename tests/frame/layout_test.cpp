// SPDX-License-Identifier: MIT
#include "frame/layout.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Layout, PanelsCoverTheFrameOnce) {
  for (const PictureSize& size : {PictureSize{1920, 1080}, {640, 360}, {101, 999}}) {
    for (int count = 1; count <= 9; ++count) {
      std::vector<int> hits(static_cast<std::size_t>(size.width) * size.height, 0);
      const std::vector<PixelBox> places = panel_places(size, count);
      ASSERT_EQ(places.size(), static_cast<std::size_t>(count));
      for (const PixelBox& place : places) {
        for (int y = place.y; y < place.bottom(); ++y) {
          for (int x = place.x; x < place.right(); ++x)
            ++hits[static_cast<std::size_t>(y * size.width + x)];
        }
      }
      for (const int hit : hits)
        ASSERT_EQ(hit, 1);
    }
  }
}

TEST(Layout, SixPanelsAreThreeByTwo) {
  const std::vector<PixelBox> places = panel_places({1920, 1080}, 6);
  for (const PixelBox& place : places)
    EXPECT_EQ(place.width * place.height, 640 * 540);
}

// bars, plots and panels share the frame without overlap and leave nothing over
TEST(Layout, AreasCoverTheFrameOnce) {
  FilmText text;
  for (const PictureSize& size : {PictureSize{1920, 1080}, {640, 360}, {300, 700}}) {
    for (const char* title : {"", "A title"}) {
      for (const bool captions : {false, true}) {
        for (const double factor : {0.5, 1.0, 3.0}) {
          for (int panels = 1; panels <= 6; ++panels) {
            for (int plots = 0; plots <= 2; ++plots) {
              text.title = title;
              text.captions = captions;
              text.size = factor;
              const FrameAreas areas = frame_areas(text, size, panels, plots);
              std::vector<PixelBox> boxes = areas.panels;
              EXPECT_EQ(boxes.size(), static_cast<std::size_t>(panels));
              boxes.insert(boxes.end(), {areas.title, areas.caption, areas.plots});
              long all = 0;
              for (std::size_t i = 0; i < boxes.size(); ++i) {
                if (boxes[i].empty()) continue;
                all += static_cast<long>(boxes[i].width) * boxes[i].height;
                EXPECT_GE(boxes[i].x, 0);
                EXPECT_GE(boxes[i].y, 0);
                EXPECT_LE(boxes[i].right(), size.width);
                EXPECT_LE(boxes[i].bottom(), size.height);
                for (std::size_t k = i + 1; k < boxes.size(); ++k)
                  EXPECT_TRUE(common(boxes[i], boxes[k]).empty()) << i << ' ' << k;
              }
              EXPECT_EQ(all, static_cast<long>(size.width) * size.height);
            }
          }
        }
      }
    }
  }
}

TEST(Layout, OnePanelAloneIsTheWholeFrame) {
  FilmText text;
  text.title = "A title";
  text.captions = true;
  const FrameAreas areas = frame_areas(text, {640, 360}, 1, 0);
  EXPECT_TRUE(areas.title.empty());
  EXPECT_TRUE(areas.caption.empty());
  EXPECT_EQ(areas.panels, (std::vector<PixelBox>{{0, 0, 640, 360}}));
}

// in the last row of a hall: 28 pixels of 1080 in any panel, unless there is no room at all
TEST(Layout, TextInPanelsIsLegible) {
  const PictureSize hall{1920, 1080};
  const FilmText text;
  for (int count = 2; count <= 9; ++count) {
    for (const PixelBox& panel : frame_areas(text, hall, count, 0).panels) {
      const NoteSizes sizes = note_sizes(text, panel, hall, {true, true, true, 0});
      for (const double size : {sizes.name, sizes.figures, sizes.stamp})
        EXPECT_GE(size, 28.0) << count;
      EXPECT_GE(sizes.figures, sizes.name);
      EXPECT_LT(sizes.height, 0.41 * panel.height);
      EXPECT_GE(label_size(text, panel, hall), 28.0);
    }
  }
  EXPECT_GE(plot_text_size(text, hall), 28.0);
}

}  // namespace
}  // namespace polhode
