// SPDX-License-Identifier: MIT
// `polhode stability` as a user calls it.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "support/background.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

class Stability : public ::testing::Test {
 protected:
  Stability() { write_text(folder_ / "scene.toml", test::kSmallScene); }
  Ran stability(const std::string& options, const std::string& out = "out") const {
    return run_polhode(
        fmt::format("stability '{}' -o '{}' {}", folder_ / "scene.toml", folder_ / out, options));
  }
  std::string table(const std::string& out = "out") const {
    return read_text(folder_ / (out + "/stability.csv"));
  }

  TemporaryFolder folder_;
};

// where a free body starts changes nothing
TEST_F(Stability, TellsOfAnAxisThatChangesNothing) {
  const Ran ran = stability(
      "--methods rk4 --cells 2x2 --turns 2 --y 'motion.position[0]' --y-range 0:1 "
      "--set 'motion.position=[0, 0, 0]'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("--y motion.position[0]: changes nothing"), std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find("--x"), std::string::npos) << ran.err;
  // nor does how it is turned, but for rounding
  const Ran turned = stability(
      "--methods rk4 --cells 3x3 --turns 20 --y 'motion.attitude.zxz_deg[0]' --y-range 0:90 "
      "--set 'motion.attitude={ zxz_deg = [0, 20, 0] }'",
      "turned");
  ASSERT_EQ(turned.code, 0) << turned.err;
  EXPECT_NE(turned.err.find("zxz_deg[0]: changes nothing"), std::string::npos) << turned.err;
}

TEST_F(Stability, WritesTableAndMaps) {
  const Ran ran = stability("--methods rk4,explicit_euler --cells 8x4 --turns 5");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("rk4"), std::string::npos) << ran.out;
  const std::string csv = table();
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 8 * 4);
  for (const char* name : {"stability_scene.png",
                           "stability_scene.svg",
                           "stability_scene_rk4.png",
                           "stability_scene_explicit_euler.png"})
    EXPECT_GT(std::filesystem::file_size(folder_ / (std::string("out/") + name)), 1000U) << name;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {}), 5);
}

TEST_F(Stability, TakesAnyTwoKeys) {
  const Ran ran = stability(
      "--methods rk4 --cells 4x3 --turns 3 --x motion.spin.body[2] "
      "--y body.solid.semi_axes[0] --y-range 0.1:0.15");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(table().find("\nscene,rk4,0.3,0.1,"), std::string::npos) << table();
  EXPECT_NE(table().find("\nscene,rk4,30,0.15,"), std::string::npos) << table();
}

TEST_F(Stability, RefusesNumericsThatItHasNoUseFor) {
  for (const char* key : {"method=rk2", "accuracy=0.5", "max_steps=2", "step=0.5"}) {
    const Ran ran =
        stability(fmt::format("--methods rk4 --cells 2x2 --turns 2 --set numerics.{}", key));
    EXPECT_EQ(ran.code, 2) << key;
    EXPECT_NE(ran.err.find("is not for maps of stability"), std::string::npos) << ran.err;
  }
  const Ran ran = stability(
      "--methods rk4 --cells 2x2 --turns 2 --x motion.spin.body[2] --set numerics.step=0.01");
  EXPECT_EQ(ran.code, 0) << ran.err;
}

// cells of a table: verdict and error
std::vector<std::pair<std::string, double>> cells_of(const std::string& csv) {
  std::vector<std::pair<std::string, double>> cells;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string field, verdict, error;
    for (int i = 0; i < 4; ++i)
      std::getline(fields, field, ',');
    std::getline(fields, verdict, ',');
    std::getline(fields, error, ',');
    cells.emplace_back(verdict, std::strtod(error.c_str(), nullptr));
  }
  return cells;
}

// a body that points the opposite way is off by more than a right angle
TEST_F(Stability, WhatFlipsWronglyIsFarOff) {
  write_text(folder_ / "scene.toml", read_text(test::scene_path("satellite")));
  ASSERT_EQ(stability("--methods rk2,rk4 --cells 8x8 --turns 5").code, 0);
  int flips = 0;
  for (const auto& [verdict, error] : cells_of(table())) {
    if (verdict != "flips_wrongly") continue;
    ++flips;
    EXPECT_GT(error, 1.57);
  }
  EXPECT_GT(flips, 0);
}

// a chaotic motion for which nobody knows the truth, under loads that conserve nothing
TEST_F(Stability, NothingIsFineThatWasNotLookedAt) {
  write_text(folder_ / "scene.toml",
             "[body]\ntensor = [[3.8, 0.35, -0.56], [0.35, 3.03, -0.63], [-0.56, -0.63, 3.01]]\n"
             "mass = 3\n[motion]\nduration = 2\nattitude = { tilt_deg = 40 }\n"
             "spin = { body = [0.16, -0.84, 2.16] }\n"
             "torque = [{ kind = \"gravity_gradient\", rate = 1.9 },\n"
             "          { kind = \"constant\", space = [0.19, -0.42, -0.27], rate = 1.93 }]\n");
  ASSERT_EQ(
      stability("--methods rk4 --cells 2x2 --x-range 0.1:0.2 --y-range 0.9:1 --turns 2000").code,
      0);
  for (const auto& [verdict, error] : cells_of(table())) {
    EXPECT_EQ(verdict, "unchecked");
    EXPECT_TRUE(std::isnan(error));
  }
}

TEST_F(Stability, RefusesAxesThatChangeNothing) {
  for (const char* key : {"camera.zoom", "numerics.tolerance", "motion.duration"}) {
    const Ran ran = stability(fmt::format("--cells 2x2 --x {}", key));
    EXPECT_EQ(ran.code, 2) << key;
    EXPECT_NE(ran.err.find("changes nothing"), std::string::npos) << ran.err;
  }
}

// the same table for any number of threads, and from a run that was stopped and taken up again
TEST_F(Stability, GoesOnWhereItWasStopped) {
  const std::string options = "--methods rk4,gauss6 --cells 24x24 --turns 12";
  ASSERT_EQ(stability(options + " --jobs 2", "whole").code, 0);
  // stopped when a row is finished
  std::vector<std::string> arguments = {
      "stability", folder_ / "scene.toml", "-o", folder_ / "out", "--jobs", "1"};
  for (const std::string& word : test::words_of(options))
    arguments.push_back(word);
  test::Background run(arguments);
  EXPECT_TRUE(test::becomes([&] {
    const std::string kept = read_text(folder_ / "out/stability.resume");
    return std::count(kept.begin(), kept.end(), '\n') > 1;
  }));
  const Ran stopped = run.end(SIGINT);
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/stability.csv"));
  ASSERT_EQ(stability(options).code, 0);
  EXPECT_TRUE(table() == table("whole"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/stability.resume"));
}

// a row whose words are damaged is computed again, and so are those behind it
TEST_F(Stability, ComputesADamagedRowAgain) {
  const std::string options = "--methods rk4,gauss6 --cells 24x24 --turns 12";
  ASSERT_EQ(stability(options + " --jobs 2", "whole").code, 0);
  std::vector<std::string> arguments = {
      "stability", folder_ / "scene.toml", "-o", folder_ / "out", "--jobs", "1"};
  for (const std::string& word : test::words_of(options))
    arguments.push_back(word);
  const std::string file = folder_ / "out/stability.resume";
  test::Background run(arguments);
  EXPECT_TRUE(test::becomes([&] {
    const std::string kept = read_text(file);
    return std::count(kept.begin(), kept.end(), '\n') > 1;
  }));
  ASSERT_EQ(run.end(SIGINT).code, 130);
  const std::string kept = read_text(file);
  const std::size_t row = kept.find('\n') + 1;
  const std::size_t word = kept.find(' ', kept.find(' ', row) + 1) + 1;
  const std::size_t number = kept.find(' ', word) + 1;
  std::string other_word = kept, other_number = kept;
  other_word.insert(word, "un");
  other_number.insert(number, "x");
  for (const std::string& damaged : {other_word, other_number}) {
    SCOPED_TRACE(damaged.substr(row, 60));
    write_text(file, damaged);
    const Ran ran = stability(options);
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(table() == table("whole"));
  }
}

// what is left of other words, or is nonsense, is not believed
TEST_F(Stability, DoesNotTakeUpAnotherRun) {
  const std::string options = "--methods rk4 --cells 6x3 --turns 3";
  ASSERT_EQ(stability(options, "whole").code, 0);
  std::filesystem::create_directory(folder_ / "out");
  write_text(folder_ / "out/stability.resume", "something else\n0 0 not_a_number 0 0 0\n");
  ASSERT_EQ(stability(options).code, 0);
  EXPECT_EQ(table(), table("whole"));
}

TEST_F(Stability, BadInputIsOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"--methods rk44", "did you mean 'rk4'?"},
      {"--cells 0x5", "--cells"},
      {"--cells 5", "--cells"},
      {"--x-range 3:1", "--x-range"},
      {"--x-range abc", "--x-range"},
      {"--x-range=-1:1", "greater than 0"},
      {"--y motion.spin.body[9]", "no number at"},
      {"--y motion.spn --y-range 1:2", "motion.spn"},
      {"--x spin", "two different keys"},
      {"--turns 0", "--turns"},
      {"--turns 1e9", "--turns: a run would take"},
      {"--x-range 1e-300:1e-299", "--turns: a run would take"},
      {"--allowed -1", "--allowed"},
  };
  for (const auto& [options, words] : cases) {
    SCOPED_TRACE(options);
    const Ran ran = stability(std::string("--cells 4x4 ") + options);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace polhode
