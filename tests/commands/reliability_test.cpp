// SPDX-License-Identifier: MIT
// What a user hears of a motion that cannot be trusted.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/run.h"

namespace polhode {
namespace {

using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

// a symmetric body, spun so that rk4 ends at a step of 1.41 s
constexpr const char* kTop =
    "format = 1\n[body]\nmoments = {}\n[motion]\nduration = 40\n"
    "attitude = {{ zxz_deg = [0, 30, 0] }}\nspin = {{ body = [0.5, 0, 2] }}\n"
    "[numerics]\nmethod = \"{}\"\nstep = {}\n[video]\nsize = \"64x36\"\nfps = 5\n";

class Reliability : public ::testing::Test {
 protected:
  Ran render(const std::string& method,
             double step,
             const std::string& out,
             const std::string& moments = "[1, 1, 2]") const {
    write_text(folder_ / "top.toml",
               fmt::format(fmt::runtime(std::string(kTop)), moments, method, step));
    return run_polhode(fmt::format("render -q '{}' -o '{}' --to 1 --report '{}'",
                                   folder_ / "top.toml",
                                   out == "null" ? out : folder_ / out,
                                   folder_ / "r.json"));
  }

  TemporaryFolder folder_;
};

TEST_F(Reliability, IsWarnedOfAndReported) {
  const Ran ran = render("explicit_euler", 0.01, "null");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("top.toml:9: numerics.method: the motion cannot be trusted"),
            std::string::npos)
      << ran.err;
  const auto report = nlohmann::json::parse(read_text(folder_ / "r.json"));
  EXPECT_EQ(report["trusted"], false);
  EXPECT_GE(report["doubts"].size(), 2U);
  EXPECT_GT(report["attitude_error_rad"].get<double>(), 0.1);
}

TEST_F(Reliability, GoodOnesAreQuiet) {
  const Ran ran = render("dmv8", 0.05, "null");
  EXPECT_EQ(ran.err, "");
  const auto report = nlohmann::json::parse(read_text(folder_ / "r.json"));
  EXPECT_EQ(report["trusted"], true);
  EXPECT_TRUE(report["doubts"].empty());
}

TEST_F(Reliability, AStepBeyondTheLimitIsToldWithTheLimit) {
  const Ran ran = render("rk4", 1.6, "null");
  EXPECT_NE(ran.err.find("top.toml:10: numerics.step: a step of 1.6 s is beyond 1.41 s"),
            std::string::npos)
      << ran.err;
}

TEST_F(Reliability, NotANumberEndsTheRunAndLeavesNoFilm) {
  const Ran ran = render("explicit_euler", 1.5, "a.mp4", "[1, 2, 3]");
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_NE(ran.err.find("explicit_euler"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("t = "), std::string::npos) << ran.err;
  EXPECT_EQ(folder_.entries(), 1) << "the scene alone";
}

// 2.06 rad/s at one frame in two seconds
TEST_F(Reliability, BackwardTurningIsTold) {
  write_text(folder_ / "top.toml",
             fmt::format(fmt::runtime(std::string(kTop)), "[1, 1, 2]", "dmv8", 0.05) +
                 "time_scale = 10\n");
  const Ran ran = run_polhode(fmt::format("render '{}' -o null", folder_ / "top.toml"));
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.err.find("backwards"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("video.fps"), std::string::npos) << ran.err;
}

// a heavy body keeps its energy with any step, and has no closed form to be held against
const char* const kHeavy = R"(format = 1
[body]
moments = [1, 2, 2.5]
center_of_mass = [0.1, 0, 0.3]
[motion]
hold = "pivot"
duration = 10
attitude = { zxz_deg = [0, 40, 0] }
spin = { body = [1, 8, 2] }
[numerics]
accuracy = 1e-4
[video]
size = "64x36"
fps = 10
)";

TEST(GivenSteps, AGivenStepIsHeldAgainstAFinerOne) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml", kHeavy);
  const struct {
    const char* options;
    bool trusted;
  } cases[] = {{" --method kick_strang --step 0.01", false},
               {" --method rk4 --step 0.05", false},
               {" --method dopri5 --tolerance 1e-4", false},
               {" --method rk4 --step 0.001", true},
               {" --method dop853 --tolerance 1e-10", true}};
  for (const auto& [options, trusted] : cases) {
    SCOPED_TRACE(options);
    const test::Ran ran = test::run_polhode("render '" + (folder / "scene.toml") +
                                            "' --still 1 -o '" + (folder / "a.png") +
                                            "' --report '" + (folder / "r.json") + "'" + options);
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto report = nlohmann::json::parse(test::read_text(folder / "r.json"));
    EXPECT_EQ(report["trusted"], trusted);
    EXPECT_EQ(report["doubts"].size(), trusted ? 0u : 1u) << report["doubts"];
    EXPECT_EQ(report["error_estimate_rad"].get<double>() <= 1e-4, trusted);
    EXPECT_EQ(ran.err.find("moves the attitude by up to") == std::string::npos, trusted) << ran.err;
  }
}

// a rate that grows makes steps too long that suit the start; the reason is told, not the accident
TEST(GivenSteps, GrowingRatesAreRefusedForTheirSteps) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml",
                   "format = 1\n[body]\nmoments = [1, 1.5, 0.6]\n[motion]\nduration = 20\n"
                   "torque = [{ kind = \"constant\", body = [0, 0, 3000] }]\n"
                   "spin = { body = [1, 2, 0] }\n");
  const test::Ran ran = test::run_polhode("inspect '" + (folder / "scene.toml") + "'");
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_NE(ran.err.find("steps"), std::string::npos) << ran.err;
}

// attitude alone makes no loop of a body that flies past a camera
TEST(GivenSteps, ALoopThatJumpsIsTold) {
  const test::TemporaryFolder folder;
  const std::string scene =
      "format = 1\n[body]\nmoments = [1, 2, 2.5]\n[motion]\nduration = 10\nspin = { body = [0, 0, "
      "1] }\n[video]\nsize = \"64x36\"\nfps = 5\nloop = true\n";
  test::write_text(folder / "still.toml", scene);
  test::write_text(folder / "flies.toml", scene + "[show]\nfixed_frame = true\n");
  const auto told = [&](const std::string& name, const std::string& set) {
    return test::run_polhode("render '" + (folder / name) + "' -o null" + set).err.find("jumps") !=
           std::string::npos;
  };
  EXPECT_FALSE(told("still.toml", ""));
  EXPECT_FALSE(told("flies.toml", ""));
  EXPECT_TRUE(told("flies.toml", " --set motion.velocity=[1,0,0]"));
}

}  // namespace
}  // namespace polhode
