// SPDX-License-Identifier: MIT
#include "app/commands/chart_pictures.h"

#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

class ChartOfPictures : public ::testing::Test {
 protected:
  ChartOfPictures() {
    test::write_text(folder_ / "scene.toml", test::kSmallScene);
    job_.scenes = {folder_ / "scene.toml"};
    job_.output = folder_ / "out";
    job_.progress = ProgressKind::none;
  }
  // setting -> the cells of its row, one by one
  std::map<std::string, std::vector<std::string>> rows() const {
    std::istringstream csv(test::read_text(folder_ / "out/chart.csv"));
    std::map<std::string, std::vector<std::string>> rows;
    std::string line;
    for (std::getline(csv, line); std::getline(csv, line);) {
      // names with commas are in quotes
      std::vector<std::string> cells;
      std::string cell;
      bool quoted = false;
      for (const char c : line + ",") {
        if (c == '"') quoted = !quoted;
        if (c != ',' || quoted) {
          if (c != '"') cell += c;
          continue;
        }
        cells.push_back(cell);
        cell.clear();
      }
      EXPECT_EQ(cells.size(), 7U) << line;
      rows[cells.at(1)] = cells;
    }
    return rows;
  }

  test::TemporaryFolder folder_;
  ChartJob job_;
};

// every way to smooth edges is nearer to the truth than none, the finest the nearest
TEST_F(ChartOfPictures, FinerSettingsAreNearerToTheTruth) {
  job_.overrides.size = "48x36";
  const std::string text = chart_pictures(job_);
  EXPECT_EQ(text.rfind("scene at 48x36: error against 8x8 pictures of 4 samples\n", 0), 0U) << text;
  const auto found = rows();
  EXPECT_EQ(found.size(), 8U);
  const auto error = [&](const std::string& setting) {
    return std::stod(found.at(setting).at(5));
  };
  const double none = error("no anti-aliasing"), finest = error("4x4 pictures of 4 samples");
  for (const auto& [setting, cells] : found) {
    EXPECT_EQ(cells.at(0), "scene");
    EXPECT_GT(std::stod(cells.at(4)), 0.0) << setting << " took time";
    EXPECT_GT(std::stoi(cells.at(6)), 0) << setting;
    EXPECT_LE(std::stod(cells.at(5)), none) << setting;
    EXPECT_GE(std::stod(cells.at(5)), finest) << setting;
  }
  EXPECT_LT(finest, 0.3 * none);
  EXPECT_LT(std::stoi(found.at("4x4 pictures of 4 samples").at(6)),
            std::stoi(found.at("no anti-aliasing").at(6)));
  EXPECT_LT(error("2x2 pictures of 4 samples"), error("2x2 pictures"));
  for (const char* name : {"chart.svg", "chart.png", "chart.pdf"})
    EXPECT_GT(std::filesystem::file_size(folder_ / (std::string("out/") + name)), 1000U) << name;
}

// the reference has 64 times as many pixels
TEST_F(ChartOfPictures, TooLargePicturesAreRefused) {
  job_.overrides.size = "962x540";
  test::expect_input_error([&] { chart_pictures(job_); }, "--size", "at most 960x540");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

}  // namespace
}  // namespace polhode
