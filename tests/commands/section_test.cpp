// SPDX-License-Identifier: MIT
// `polhode section` as a user calls it.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "support/background.h"

namespace polhode {
namespace {

using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

class Section : public ::testing::Test {
 protected:
  Section() {
    write_text(folder_ / "scene.toml",
               "format = 1\n[body]\n"
               "solid = { kind = \"box\", size_cm = [24, 11.5, 7], mass = 3 }\n"
               "pivot_cm = [12, 5.75, 3.5]\n"
               "[motion]\nhold = \"pivot\"\nduration = 1\n"
               "attitude = { zxz_deg = [20, 100, 30] }\nspin = { body = [6, 12, -4] }\n");
  }
  Ran section(const std::string& options, const std::string& out = "out") const {
    return run_polhode(
        fmt::format("section '{}' -o '{}' {}", folder_ / "scene.toml", folder_ / out, options));
  }
  std::string table(const std::string& out = "out") const {
    return read_text(folder_ / (out + "/section.csv"));
  }

  TemporaryFolder folder_;
};

TEST_F(Section, WritesTableAndPicture) {
  const Ran ran = section("--starts 4 --crossings 20");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("5 motions: "), std::string::npos) << ran.out;
  const std::string csv = table();
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 5 * 20);
  EXPECT_GT(std::filesystem::file_size(folder_ / "out/section.png"), 1000U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {}), 2);
}

// a body that hangs in the least of its energy has no crossings, and no region around them
TEST_F(Section, OfAMotionThatCannotBeAnotherIsEmpty) {
  const Ran ran = section(
      "--starts 2 --crossings 20 --set 'body.solid={ kind = \"box\", size_cm = [10, 6, 2], mass = "
      "0.5 }' "
      "--set 'body.pivot_cm=[5, 0, 0]' --set 'motion.attitude={ zxz_deg = [0, 90, 90] }' "
      "--set 'motion.spin.body=[5, 0, 0]'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_GT(std::filesystem::file_size(folder_ / "out/section.png"), 1000U);
}

// the method of a section is its own
TEST_F(Section, RefusesNumerics) {
  const Ran ran = section("--starts 2 --set numerics.method=rk4");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("--set numerics.method: is not for sections"), std::string::npos)
      << ran.err;
}

// the same table for any number of threads, and from a run that was stopped and taken up again
TEST_F(Section, GoesOnWhereItWasStopped) {
  const std::string options = "--starts 60 --crossings 500";
  ASSERT_EQ(section(options + " --jobs 2", "whole").code, 0);
  std::vector<std::string> arguments = {
      "section", folder_ / "scene.toml", "-o", folder_ / "out", "--jobs", "1"};
  for (const std::string& word : test::words_of(options))
    arguments.push_back(word);
  test::Background run(arguments);
  EXPECT_TRUE(test::becomes([&] {
    const std::string kept = read_text(folder_ / "out/section.resume");
    return std::count(kept.begin(), kept.end(), '\n') > 1;
  }));
  const Ran stopped = run.end(SIGINT);
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/section.csv"));
  ASSERT_EQ(section(options).code, 0);
  EXPECT_TRUE(table() == table("whole"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/section.resume"));
}

// what another job has kept in the folder waits until that is run again
TEST_F(Section, LeavesTheWorkOfAnotherJob) {
  const std::string options = "--starts 60 --crossings 500";
  std::vector<std::string> arguments = {
      "section", folder_ / "scene.toml", "-o", folder_ / "out", "--jobs", "1"};
  for (const std::string& word : test::words_of(options))
    arguments.push_back(word);
  const std::filesystem::path file = folder_ / "out/section.resume";
  test::Background run(arguments);
  EXPECT_TRUE(test::becomes([&] {
    const std::string kept = read_text(file);
    return std::count(kept.begin(), kept.end(), '\n') > 1;
  }));
  ASSERT_EQ(run.end(SIGINT).code, 130);
  const std::string kept = read_text(file);
  ASSERT_EQ(section("--starts 2 --crossings 3").code, 0);
  EXPECT_FALSE(std::filesystem::exists(file));
  std::string waiting;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out")) {
    if (entry.path().filename().string().starts_with("section.resume-"))
      waiting = read_text(entry.path());
  }
  EXPECT_EQ(waiting, kept);
  ASSERT_EQ(section(options).code, 0);
  const auto left = std::filesystem::directory_iterator(folder_ / "out");
  EXPECT_EQ(std::distance(begin(left), end(left)), 2);  // table and picture
}

// a cell is the motion of the scene with its values: the same verdict and exponent
TEST_F(Section, AMapHasTheMotionsOfItsScenes) {
  const std::string axes =
      "--x motion.spin.body[1] --x-range 8:12 --y motion.spin.body[0] --y-range 4:6 --cells 3x2";
  const Ran map = section(axes + " --crossings 100", "map");
  ASSERT_EQ(map.code, 0) << map.err;
  EXPECT_NE(map.out.find("6 motions: "), std::string::npos) << map.out;
  const std::string cells = read_text(folder_ / "map/section_map.csv");
  EXPECT_EQ(std::count(cells.begin(), cells.end(), '\n'), 7);
  ASSERT_EQ(section("--starts 1 --crossings 100 --set motion.spin.body[1]=12 --set "
                    "motion.spin.body[0]=6")
                .code,
            0);
  // of the table: orbit, verdict, exponent; of the map: x, y, verdict, exponent
  const auto word = [](const std::string& line, int n) {
    std::istringstream in(line);
    std::string found;
    for (int i = 0; i <= n; ++i)
      std::getline(in, found, ',');
    return found;
  };
  const std::string alone = table().substr(table().find('\n') + 1);
  const std::string last = cells.substr(cells.rfind('\n', cells.size() - 2) + 1);
  EXPECT_EQ(word(last, 0) + word(last, 1), "126");
  EXPECT_EQ(word(last, 2), word(alone, 1));
  EXPECT_NEAR(std::stod(word(last, 3)), std::stod(word(alone, 2)), 1e-4);
}

TEST_F(Section, FewCrossingsAreTooFewToJudge) {
  const Ran ran = section("--starts 2 --crossings 3");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("0 regular, 0 chaotic, 3 undecided"), std::string::npos) << ran.out;
}

TEST_F(Section, WhatIsWrongIsTold) {
  const struct {
    const char* options;
    const char* says;
  } cases[] = {{"--starts 0", "--starts: must be a whole number from 1 to 10000, got 0"},
               {"--crossings 1000000", "--crossings: must be a whole number from 1 to 100000"},
               {"--starts 10000 --crossings 10000", "more than 1e+07 in all"},
               {"--jobs 0", "--jobs: must be greater than 0"},
               {"--x motion.duration", "--y: a map needs two keys"},
               {"--x-range 1:2", "--x-range: is for maps"},
               {"--x motion.spin.body[0] --y motion.spin.body[0]", "--y: is the key of --x"},
               {"--x motion.spin.body[0] --y motion.spin.body[00]", "is not a key"},
               {"--x motion.spin.body[0] --y motion.spin.body[1] --cells 1x1", "--cells: '1x1'"},
               {"--x motion.spin.body[0] --y motion.spn --y-range 1:2", "motion.spn"},
               {"--x numerics.step --x-range 1:2 --y motion.spin.body[1]",
                "--x: a section does not depend on 'numerics.step'"},
               {"--x body.mass --x-range=-1:2 --y motion.spin.body[1]", "body.mass = -1: must be"},
               {"--set motion.hold=free", "motion.hold: a section needs a body on a pivot"},
               {"--set motion.gravity=[0,0,0]", "motion.gravity: a section needs gravity"},
               {"--set 'motion.torque=[{kind=\"damping\",c=1}]'",
                "motion.torque: a section takes no torques"}};
  for (const auto& one : cases) {
    const Ran ran = section(one.options);
    EXPECT_EQ(ran.code, 2) << one.options;
    EXPECT_NE(ran.err.find(one.says), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  }
}

}  // namespace
}  // namespace polhode
