// SPDX-License-Identifier: MIT
// Every bad input of a user: one line with the place and what to do, exit code 2 (3 when the
// machine lacks something), and nothing left behind.
#include <algorithm>

#include "support/run.h"

namespace polhode {
namespace {

using testing::Ran;
using testing::run_polhode;
using testing::TemporaryFolder;
using testing::write_text;

struct BadScene {
  std::string name;
  std::string replace;  // text of the small scene
  std::string with;
  std::string place;  // must be in the message, after the file name
  std::string says;   // must be in the message
};

const BadScene kBadScenes[] = {
    {"syntax", "duration = 1", "duration = = 1", ":6:", "not valid TOML"},
    {"unknown_key", "mass = 1.0", "mas = 1.0", ":4: body.solid.mas:", "did you mean 'mass'?"},
    {"unknown_table", "[motion]", "[motoin]", ":5: motoin:", "did you mean 'motion'?"},
    {"wrong_type",
     "duration = 1",
     "duration = \"long\"",
     ":6: motion.duration:",
     "must be a number"},
    {"not_a_number", "duration = 1", "duration = nan", ":6: motion.duration:", "finite"},
    {"infinity", "body = [1, 0, 3]", "body = [1, 0, inf]", ":8: motion.spin.body[2]:", "finite"},
    {"negative_mass", "mass = 1.0", "mass = -1.0", ":4: body.solid.mass:", "greater than 0"},
    {"zero_duration", "duration = 1", "duration = 0", ":6: motion.duration:", "greater than 0"},
    {"odd_size", "128x72", "127x72", "", "even"},
    {"absurd_size", "128x72", "1280000x72", ":10: video.size:", ""},
    {"impossible_moments",
     "solid = { kind = \"ellipsoid\", semi_axes = [0.1, 0.1, 0.2], mass = 1.0 }",
     "moments = [1, 1, 3]",
     ":4: body.moments:",
     "mathematical"},
    {"negative_moment",
     "solid = { kind = \"ellipsoid\", semi_axes = [0.1, 0.1, 0.2], mass = 1.0 }",
     "moments = [1, -1, 1]",
     ":4: body.moments[1]:",
     "0"},
    {"unknown_method",
     "[video]",
     "[numerics]\nmethod = \"rk5\"\n[video]",
     ":10: numerics.method:",
     "did you mean 'rk4'?"},
    {"unknown_solid", "ellipsoid", "elipsoid", ":4: body.solid.kind:", "did you mean 'ellipsoid'?"},
    {"missing_dimension", "semi_axes = [0.1, 0.1, 0.2], ", "", ":4: body.solid:", "semi_axes"},
    {"wrong_dimension", "semi_axes", "radius = 1, semi_axes", ":4: body.solid.radius:", "it takes"},
    {"two_bodies", "[motion]", "moments = [1, 1, 1]\n[motion]", ":5: body:", "exactly one of"},
    {"unknown_format", "format = 1", "format = 2", ":1: format:", "1"},
    {"closed_form_missing",
     "body = [1, 0, 3] }",
     "body = [1, 0, 3] }\n[numerics]\nmodel = \"spherical\"",
     ":10: numerics.model:",
     "not equal"},
};

TEST(BadScene, EachIsOneLineWithItsPlace) {
  for (const BadScene& bad : kBadScenes) {
    SCOPED_TRACE(bad.name);
    const TemporaryFolder folder;
    std::string text = testing::kSmallScene;
    const std::size_t at = text.find(bad.replace);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, bad.replace.size(), bad.with);
    write_text(folder / "scene.toml", text);
    const Ran ran =
        run_polhode("render '" + (folder / "scene.toml") + "' -o '" + (folder / "film.mp4") + "'");
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    if (!bad.place.empty()) {
      EXPECT_NE(ran.err.find("scene.toml" + bad.place), std::string::npos) << ran.err;
    }
    EXPECT_NE(ran.err.find(bad.says), std::string::npos) << ran.err;
    EXPECT_EQ(folder.entries(), 1) << "only the scene itself is there";
  }
}

struct BadCall {
  std::string arguments;  // SCENE and DIR are replaced
  int code;
  std::string says;
};

const BadCall kBadCalls[] = {
    {"render DIR/missing.toml -o DIR/a.mp4", 2, "missing.toml: no such file"},
    {"render DIR -o DIR/a.mp4", 2, "folder"},
    {"render SCENE -o DIR/a.mp5", 2, ".mp4"},
    {"render SCENE -o DIR/nowhere/a.mp4", 2, "does not exist"},
    {"render SCENE -o SCENE/a.mp4", 2, "does not exist"},
    {"render SCENE -o DIR/a.mp4 --size 127x72", 2, "even"},
    {"render SCENE -o DIR/a.mp4 --size 12", 2, "--size"},
    {"render SCENE -o DIR/a.mp4 --size 99999999999x2", 2, "--size"},
    {"render SCENE -o DIR/a.mp4 --fps 0", 2, "--fps"},
    {"render SCENE -o DIR/a.mp4 --fps 29.97", 2, "30000/1001"},
    {"render SCENE -o DIR/a.mp4 --method rk44", 2, "did you mean 'rk4'?"},
    {"render SCENE -o DIR/a.mp4 --method rk4 --step -1", 2, "--step"},
    {"render SCENE -o DIR/a.mp4 --method rk4 --step nan", 2, "--step"},
    {"render SCENE -o DIR/a.mp4 --method rk4 --step 1e-15", 2, "steps"},
    {"render SCENE -o DIR/a.mp4 --method dopri5 --step 0.1", 2, "tolerance"},
    {"render SCENE -o DIR/a.mp4 --backend vulkan", 2, "osmesa"},
    {"render SCENE -o DIR/a.mp4 --quality best", 2, "lecture"},
    {"render SCENE -o DIR/a.mp4 --preset fst", 2, "did you mean 'fast'?"},
    {"render SCENE -o DIR/a.mp4 --crf 0", 2, "--crf"},
    {"render SCENE -o DIR/a.mp4 --still 0.5", 2, ".png"},
    {"render SCENE -o DIR/a.png --still 5", 2, "--still"},
    {"render SCENE -o DIR/a.mp4 --from 0.5 --to 0.5", 2, "--to"},
    {"render SCENE -o DIR/a.mp4 --transparent", 2, "alpha"},
    {"render SCENE -o DIR/%s.png", 2, "%05d"},
    {"render SCENE -o DIR/a.mp4 --report DIR/nowhere/r.json", 2, "does not exist"},
    {"render SCENE -o DIR/a.mp4 --sise 12x12", 2, "did you mean '--size'?"},
    {"render SCENE -o DIR/a.mp4 --progress loud", 2, "json"},
    {"rendr SCENE", 2, "did you mean 'render'?"},
    {"render", 2, "scene"},
    {"", 2, "subcommand"},
    {"list methds", 2, "did you mean 'methods'?"},
    {"simulate SCENE -o DIR/a.csv --rate -5", 2, "--rate"},
    {"simulate SCENE -o DIR/a.csv --method explicit_euler --accuracy 1e-9", 2, "accuracy"},
    {"simulate SCENE -o DIR", 2, "folder"},
    {"simulate SCENE -o SCENE", 2, "overwrite"},
    {"simulate SCENE -o DIR/../scene.toml/../scene.toml", 2, "not exist"},
    {"simulate SCENE -o /dev/full", 2, "ordinary file"},
    {"render SCENE -o DIR/a.mp4 --report SCENE", 2, "overwrite"},
    {"render SCENE -o DIR/a.mp4 --report DIR/a.mp4", 2, "overwrite"},
};

TEST(BadCall, EachIsOneLineWithTheRightCode) {
  for (const BadCall& bad : kBadCalls) {
    SCOPED_TRACE(bad.arguments);
    const TemporaryFolder folder;
    write_text(folder / "scene.toml", testing::kSmallScene);
    std::string arguments = bad.arguments;
    for (std::size_t at; (at = arguments.find("SCENE")) != std::string::npos;) {
      arguments.replace(at, 5, folder / "scene.toml");
    }
    for (std::size_t at; (at = arguments.find("DIR")) != std::string::npos;) {
      arguments.replace(at, 3, folder.path().string());
    }
    const Ran ran = run_polhode(arguments);
    EXPECT_EQ(ran.code, bad.code) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find(bad.says), std::string::npos) << ran.err;
    EXPECT_EQ(folder.entries(), 1) << "only the scene itself is there";
  }
}

// the real loader against a machine without the libraries: files of their names that are no
// libraries
TEST(Environment, WithoutAnyOpenGlTheRunSaysWhatIsMissing) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", testing::kSmallScene);
  for (const char* name :
       {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1", "libEGL.so"}) {
    write_text(folder / name, "");
  }
  const std::string before = "LD_LIBRARY_PATH='" + folder.path().string() + "'";
  const long files = folder.entries();
  for (const std::string backend : {"auto", "osmesa", "egl"}) {
    const Ran ran = run_polhode("render '" + (folder / "scene.toml") + "' -o '" +
                                    (folder / "a.mp4") + "' --backend " + backend,
                                before);
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_EQ(folder.entries(), files);
  }
  // with one of the two back, auto finds it
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
    std::filesystem::remove(folder / name);
  }
  const Ran ran = run_polhode("render '" + (folder / "scene.toml") + "' -o '" + (folder / "a.png") +
                                  "' --report '" + (folder / "r.json") + "'",
                              before);
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(testing::read_text(folder / "r.json").find("\"backend\": \"osmesa\""),
            std::string::npos);
}

TEST(Environment, AFullDiskLeavesNothing) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", testing::kSmallScene);
  // one block of 512 bytes (sh) is less than any film; stdout and stderr stay below it
  const Ran ran = run_polhode(
      "render '" + (folder / "scene.toml") + "' -o '" + (folder / "a.mp4") + "'", "ulimit -f 1;");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_EQ(folder.entries(), 1);
}

TEST(Environment, InterruptLeavesNothingAndSaysSo) {
  const TemporaryFolder folder;
  std::string text = testing::kSmallScene;
  text.replace(text.find("duration = 1"), 12, "duration = 1000");
  write_text(folder / "scene.toml", text);
  const Ran ran =
      run_polhode("render '" + (folder / "scene.toml") + "' -o '" + (folder / "a.mp4") + "'",
                  "timeout --preserve-status -s INT 1");
  EXPECT_EQ(ran.code, 130) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_EQ(folder.entries(), 1);
}

}  // namespace
}  // namespace polhode
