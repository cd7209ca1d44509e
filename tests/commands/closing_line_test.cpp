// SPDX-License-Identifier: MIT
// The line with which render, join and preview say what they did, with the real program.
#include <regex>

#include <nlohmann/json.hpp>

#include "support/run.h"

namespace polhode {
namespace {

using test::Ran;

// A folder with a scene of ten frames at ten a second.
class ClosingLine : public ::testing::Test {
 protected:
  void SetUp() override { test::write_text(folder_ / "scene.toml", test::kSmallScene); }

  // `polhode WORDS` in the folder
  Ran run(const std::string& words) const {
    return test::run_polhode(words, "cd '" + folder_.path().string() + "' &&");
  }
  std::string said(const std::string& words) const {
    const Ran ran = run(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.err;
  }

  test::TemporaryFolder folder_;
};

const std::string kTime = R"( in \d+\.\d+ s)";
const std::string kRate = R"( \(\d+(\.\d+)? frames/s\))";

bool is_line(const std::string& said, const std::string& pattern) {
  return std::regex_match(said, std::regex("polhode: " + pattern + "\n"));
}

TEST_F(ClosingLine, TellsFileFramesSecondsAndRateOfAFilm) {
  const std::string film = said("render scene.toml -o a.mp4");
  EXPECT_TRUE(is_line(film, R"(a\.mp4: 10 frames)" + kTime + kRate)) << film;
  // a GIF has 30 frames/s of the 60 that are drawn
  const std::string gif = said("render scene.toml -o a.gif --fps 60 --to 0.5");
  EXPECT_NE(gif.find("\npolhode: a.gif: 15 frames in "), std::string::npos) << gif;
  const std::string reported = said("render scene.toml -o a.gif --fps 60 --to 0.5 --report a.json");
  EXPECT_NE(reported.find("\npolhode: a.gif: 15 frames in "), std::string::npos) << reported;
  const std::string numbered = said("render scene.toml -o f_%d.png --to 0.1 --progress none");
  EXPECT_TRUE(is_line(numbered, R"(f_%d\.png: 1 frame)" + kTime + kRate)) << numbered;
  const std::string unnamed = said("render scene.toml");
  EXPECT_TRUE(is_line(unnamed, R"(output/scene\.mp4: 10 frames)" + kTime + kRate)) << unnamed;
}

TEST_F(ClosingLine, LeavesStandardOutputToTheData) {
  const Ran ran = run("render scene.toml -o - --size 64x36");
  EXPECT_EQ(ran.code, 0);
  EXPECT_TRUE(is_line(ran.err, "standard output: 10 frames" + kTime + kRate)) << ran.err;
  EXPECT_EQ(ran.out.rfind("YUV4MPEG2", 0), 0u);
  EXPECT_EQ(ran.out.find("polhode: "), std::string::npos);
}

TEST_F(ClosingLine, CallsPicturesPictures) {
  const std::string still = said("render scene.toml -o a.png --still 0.5");
  EXPECT_TRUE(is_line(still, R"(a\.png: 1 picture)" + kTime)) << still;
  const std::string sheet = said("preview scene.toml -o sheet.png");
  EXPECT_TRUE(is_line(sheet, R"(sheet\.png: 12 pictures)" + kTime)) << sheet;
}

TEST_F(ClosingLine, OfJoinCountsThePartsAndTheirFrames) {
  said("render scene.toml --shard 1/2 -o 1.mp4");
  said("render scene.toml --shard 2/2 -o 2.mp4");
  const std::string joined = said("join 1.mp4 2.mp4 -o a.mp4");
  EXPECT_TRUE(is_line(joined, R"(a\.mp4: 10 frames of 2 parts)" + kTime + kRate)) << joined;
}

TEST_F(ClosingLine, OfQuietCommandsIsAbsentAndSoIsTheBar) {
  EXPECT_EQ(said("render scene.toml -o a.mp4 -q"), "");
  EXPECT_EQ(said("render scene.toml -o a.mp4 --quiet --progress bar"), "");
  EXPECT_EQ(said("render scene.toml -o a.mp4 --progress json -q"), "");
  EXPECT_EQ(said("preview scene.toml -o a.png -q"), "");
  said("render scene.toml --shard 1/1 -o 1.mp4 -q");
  EXPECT_EQ(said("join 1.mp4 -o b.mp4 -q"), "");
  // but what is wrong is told
  const Ran wrong = run("render nowhere.toml -q");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(std::count(wrong.err.begin(), wrong.err.end(), '\n'), 1) << wrong.err;
}

TEST_F(ClosingLine, IsAnObjectAmongProgressLinesOfJson) {
  std::istringstream lines(said(R"(render scene.toml -o 'a "b".mp4' --progress json)"));
  nlohmann::json last;
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    last = nlohmann::json::parse(line);  // throws on anything else
    for (const char* key : {"done", "total", "frames_per_s", "seconds_left", "limit"}) {
      EXPECT_TRUE(last.contains(key)) << line;
    }
  }
  EXPECT_GE(count, 2);
  EXPECT_EQ(last.at("output"), "a \"b\".mp4");
  EXPECT_EQ(last.at("done"), 10);
  EXPECT_EQ(last.at("total"), 10);
  EXPECT_EQ(last.at("frames"), 10);
  EXPECT_GT(last.at("seconds"), 0.0);
  EXPECT_NEAR(last.at("frames_per_s").get<double>() * last.at("seconds").get<double>(), 10.0, 0.5);
}

// a rate of nothing would say nothing
TEST_F(ClosingLine, TellsWhatEarlierRunsHaveMade) {
  const std::string film = "render scene.toml -o a.mp4 --resume --pieces 2";
  ASSERT_EQ(run(film + " --shard 1/1").code, 0);
  const Ran ran = run(film);
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("a.mp4: 10 frames, all of them from earlier runs, in"), std::string::npos)
      << ran.err;
  EXPECT_EQ(ran.err.find("frames/s"), std::string::npos) << ran.err;
}

TEST_F(ClosingLine, IsAbsentWhenNothingWasMade) {
  const Ran ran = run("render scene.toml -o missing/a.mp4");
  EXPECT_NE(ran.code, 0);
  EXPECT_EQ(ran.err.find("frames/s"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace polhode
