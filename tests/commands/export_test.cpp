// SPDX-License-Identifier: MIT
// `polhode export` as a user calls it.
#include <algorithm>
#include <filesystem>
#include <string>

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

constexpr const char* kTop =
    "format = 1\ntitle = \"A top\"\n[body]\nmoments = [1, 1, 1.8]\n[motion]\nduration = 2\n"
    "spin = { body = [0.6, 0, 5] }\n";

class Export : public ::testing::Test {
 protected:
  Export() { write_text(folder_ / "top.toml", kTop); }
  Ran run(const std::string& options) const {
    return run_polhode(fmt::format("export '{}' {}", folder_ / "top.toml", options));
  }
  std::string in_folder(const std::string& name) const { return "'" + (folder_ / name) + "'"; }
  // the piece of JSON
  static nlohmann::json json_of(const std::string& bytes) {
    std::uint32_t size = 0;
    std::copy_n(bytes.data() + 12, 4, reinterpret_cast<char*>(&size));
    return nlohmann::json::parse(bytes.substr(20, size));
  }

  TemporaryFolder folder_;
};

TEST_F(Export, WritesAFileAndTellsHowExactItIs) {
  const Ran ran =
      run("-o " + in_folder("top.glb") + " --author 'A. Teacher' --licence 'CC BY 4.0'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("key times; playback within"), std::string::npos) << ran.err;
  const nlohmann::json json = json_of(read_text(folder_ / "top.glb"));
  EXPECT_EQ(json.at("asset").at("copyright"), "A. Teacher, CC BY 4.0");
  EXPECT_EQ(json.at("asset").at("extras").at("title"), "A top");
  EXPECT_EQ(json.at("asset").at("extras").at("scene").get<std::string>().size(), 32u);
}

TEST_F(Export, StandardOutputHasTheSameBytesEachTime) {
  const Ran one = run("-o - --quiet"), other = run("-o - --quiet");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.out.substr(0, 4), "glTF");
  EXPECT_EQ(one.out, other.out);
  EXPECT_EQ(one.err, "");
}

// the animation of a film that repeats can be repeated
TEST_F(Export, EndsWhereTheFilmRepeats) {
  const Ran ran =
      run("-o - -q --set video.loop=true --set 'motion.spin.body=[0, 0, 6.283185307179586]'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json json = json_of(ran.out);
  double last = 0.0;
  for (const nlohmann::json& sampler : json.at("animations").at(0).at("samplers")) {
    const nlohmann::json& times = json.at("accessors").at(sampler.at("input").get<std::size_t>());
    last = std::max(last, times.at("max").at(0).get<double>());
  }
  EXPECT_NEAR(last, 1.0, 1e-3);
}

TEST_F(Export, TellsThatItHasNoComparedMotions) {
  const Ran ran = run("-o - -q --set 'numerics.compare=[\"rk4\"]' --set numerics.step=0.01");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("numerics.compare: models have the one motion"), std::string::npos)
      << ran.err;
}

// a finer accuracy has more keys, and the error that is told is smaller
TEST_F(Export, AccuracyCountsForPlayback) {
  const auto told = [&](const std::string& accuracy) {
    const Ran ran = run("-o - --quiet --accuracy " + accuracy);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return json_of(ran.out)
        .at("asset")
        .at("extras")
        .at("accuracy")
        .at("measured_pixels")
        .get<double>();
  };
  EXPECT_LE(told("0.1px"), 0.1);
  EXPECT_LE(told("0.01px"), 0.01);
}

TEST_F(Export, WrongInputIsToldAndNothingIsWritten) {
  const auto fails = [&](const std::string& options, const std::string& words) {
    const Ran ran = run(options);
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
    EXPECT_EQ(folder_.entries(), 1) << options;
  };
  fails("-o " + in_folder("top.gltf"), "name a .glb");
  fails("-o " + in_folder("top.toml"), "");
  fails("-o " + in_folder("no/top.glb"), "no");
  fails("-o " + in_folder("a.glb") + " --from 5", "--from");
  fails("-o " + in_folder("a.glb") + " --from 1 --to 0.5", "--to");
  fails("-o " + in_folder("a.glb") + " --set 'motion.spin={body=[0,0,1e9]}'", "--from and --to");
  fails("-o " + in_folder("a.glb") + " --set show.omga=true", "omega");
}

TEST_F(Export, AFilmOfSeveralScenesIsNoModel) {
  write_text(folder_ / "film.toml",
             "[[panel]]\nscene = \"top.toml\"\n[[panel]]\nscene = \"top.toml\"\n");
  const Ran ran = run_polhode("export " + in_folder("film.toml") + " -o " + in_folder("a.glb"));
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("film.toml"), std::string::npos) << ran.err;
}

TEST_F(Export, AFullDiskLeavesNothing) {
  const Ran ran = run_polhode("export " + in_folder("top.toml") + " -o " + in_folder("top.glb"),
                              "ulimit -f 1;");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_EQ(folder_.entries(), 1);
  const Ran piped = run_polhode("export " + in_folder("top.toml") + " -o - --quiet",
                                "sh -c '\"$@\" >/dev/full' sh");
  EXPECT_EQ(piped.code, 3) << piped.err;
}

}  // namespace
}  // namespace polhode
