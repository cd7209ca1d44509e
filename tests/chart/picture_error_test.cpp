// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "chart/plot_picture_error.h"

namespace polhode::test {
namespace {

const PicturePanel kPanel = {
    "top", "A title", {{"plain", 0, 1, 1.5, 3.8, 200}, {"four samples", 4, 1, 5.0, 1.4, 90}}};

int count(const std::string& text, const std::string& word) {
  int found = 0;
  for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
    ++found;
  return found;
}

TEST(PictureError, EveryPointIsDrawnAndNamed) {
  const std::string svg = plot_picture_error({kPanel}, PlotFormat::svg);
  for (const char* words : {"A title", "plain", "four samples"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  // marks in the panel and in its key
  EXPECT_EQ(count(svg, "' transform='translate("), 4) << svg;
}

TEST(PictureError, Table) {
  EXPECT_EQ(picture_error_csv({kPanel}),
            "scene,setting,samples,supersampling,time_ms,rmse_levels,max_levels\n"
            "top,plain,0,1,1.5,3.8,200\ntop,four samples,4,1,5,1.4,90\n");
}

}  // namespace
}  // namespace polhode::test
