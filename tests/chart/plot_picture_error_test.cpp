// SPDX-License-Identifier: MIT
#include "chart/plot_picture_error.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include <gtest/gtest.h>

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

TEST(PlotPictureError, EveryPointIsDrawnAndNamed) {
  const std::string svg = plot_picture_error({kPanel}, PlotFormat::svg);
  for (const char* words : {"A title", "plain", "four samples"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  // marks in the panel and in its key
  EXPECT_EQ(count(svg, "' transform='translate("), 4) << svg;
}

// on logarithmic axes equal ratios are equal distances
TEST(PlotPictureError, EqualRatiosAreEqualDistances) {
  const PicturePanel panel = {
      "top",
      "A title",
      {{"a", 0, 1, 1.0, 8.0, 9}, {"b", 0, 1, 2.0, 4.0, 9}, {"c", 0, 1, 4.0, 2.0, 9}}};
  const std::string svg = plot_picture_error({panel}, PlotFormat::svg);
  // each mark of the panel comes before its like in the key
  const std::string word = "' transform='translate(";
  std::vector<double> x, y;
  for (std::size_t i = svg.find(word); i != std::string::npos; i = svg.find(word, i + 1)) {
    char* end = nullptr;
    x.push_back(std::strtod(svg.c_str() + i + word.size(), &end));
    y.push_back(std::strtod(end + 1, nullptr));
  }
  ASSERT_EQ(x.size(), 6u);
  // the key stands to the right of the panel
  std::vector<std::size_t> panel_marks;
  const double right = *std::max_element(x.begin(), x.end());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < right - 1.0) panel_marks.push_back(i);
  }
  ASSERT_EQ(panel_marks.size(), 3u);
  const auto [a, b, c] = std::tuple{panel_marks[0], panel_marks[1], panel_marks[2]};
  EXPECT_NEAR(x[b] - x[a], x[c] - x[b], 0.2);
  EXPECT_NEAR(y[b] - y[a], y[c] - y[b], 0.2);
  EXPECT_GT(x[b], x[a]) << "time to the right";
  EXPECT_GT(y[b], y[a]) << "smaller errors below";
}

TEST(PlotPictureError, TheTableHasARowForEachPoint) {
  EXPECT_EQ(picture_error_csv({kPanel}),
            "scene,setting,samples,supersampling,time_ms,rmse_levels,max_levels\n"
            "top,plain,0,1,1.5,3.8,200\ntop,four samples,4,1,5,1.4,90\n");
}

// settings and scenes are words of people, and a row must keep its seven fields
TEST(PlotPictureError, NamesWithCommasAreOneField) {
  const PicturePanel panel = {"top, heavy", "A title", {{"two, three", 0, 1, 1.0, 2.0, 3}}};
  const std::string csv = picture_error_csv({panel});
  EXPECT_EQ(csv.substr(csv.find('\n') + 1), "\"top, heavy\",\"two, three\",0,1,1,2,3\n");
}

}  // namespace
}  // namespace polhode::test
