// SPDX-License-Identifier: MIT
// `polhode chart` as a user calls it.
#include <filesystem>

#include <fmt/format.h>

#include "support/background.h"

namespace polhode {
namespace {

using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

class Chart : public ::testing::Test {
 protected:
  Chart() { write_text(folder_ / "scene.toml", test::kSmallScene); }
  Ran chart(const std::string& options, const std::string& before = "") const {
    return run_polhode(
        fmt::format("chart '{}' -o '{}' {}", folder_ / "scene.toml", folder_ / "out", options),
        before);
  }

  TemporaryFolder folder_;
};

TEST_F(Chart, WritesTableAndPictures) {
  const Ran ran = chart("--methods rk4,dop853");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("closed form (symmetric)"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("  within 1e-12    rad: "), std::string::npos) << ran.out;
  const std::string csv = read_text(folder_ / "out/chart.csv");
  EXPECT_NE(csv.find("\nscene,rk4,4,"), std::string::npos);
  EXPECT_NE(csv.find("\nscene,dop853,8,"), std::string::npos);
  EXPECT_EQ(csv.find("gauss"), std::string::npos);
  for (const char* name : {"chart.svg", "chart.png", "chart.pdf"})
    EXPECT_GT(std::filesystem::file_size(folder_ / (std::string("out/") + name)), 2000U) << name;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {}), 4);
}

TEST_F(Chart, DrawsPictureErrors) {
  const Ran ran = chart("--pictures --size 64x36");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("4 samples"), std::string::npos) << ran.out;
  const std::string csv = read_text(folder_ / "out/chart.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "scene,setting,samples,supersampling,time_ms,rmse_levels,max_levels");
}

TEST_F(Chart, BadInputIsOneLine) {
  EXPECT_EQ(chart("--methods rk44").code, 2);
  EXPECT_NE(chart("--methods rk44").err.find("did you mean 'rk4'?"), std::string::npos);
  EXPECT_NE(chart("--methods kick_strong").err.find("--methods"), std::string::npos);
  EXPECT_EQ(chart("--pictures --size 1920x1080").code, 2);
  write_text(folder_ / "out", "a file where the folder goes");
  EXPECT_EQ(chart("").code, 2);
  EXPECT_EQ(read_text(folder_ / "out"), "a file where the folder goes");
}

// a second run that fails leaves the first one's files
TEST_F(Chart, WithoutGnuplotNothingChanges) {
  ASSERT_EQ(chart("--methods rk4").code, 0);
  const std::string before = read_text(folder_ / "out/chart.csv");
  const Ran ran = chart("--methods rk2", "PATH=/nowhere");
  EXPECT_EQ(ran.code, 3);
  EXPECT_NE(ran.err.find("gnuplot"), std::string::npos) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_EQ(read_text(folder_ / "out/chart.csv"), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {}), 4);
}

TEST_F(Chart, AnInterruptLeavesNothingButFinishedMethods) {
  test::Background run(
      {"chart", folder_ / "scene.toml", "-o", folder_ / "out", "--progress", "json"});
  run.await_progress();
  const Ran ran = run.end(SIGINT);
  EXPECT_EQ(ran.code, 130) << ran.err;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out"))
    EXPECT_EQ(entry.path().filename(), "chart.resume");
}

// in the table and the legend they would be one
TEST_F(Chart, ScenesOfOneNameAreRefused) {
  std::filesystem::create_directory(folder_ / "b");
  write_text(folder_ / "b/scene.toml", test::kSmallScene);
  const std::string second = fmt::format(" '{}'", folder_ / "b/scene.toml");
  for (const std::string& options : {second, second + " --pictures --size 64x36"}) {
    const Ran ran = chart(options);
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("scene.toml and "), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("/b/scene.toml are both called 'scene'"), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  }
}

}  // namespace
}  // namespace polhode
