// SPDX-License-Identifier: MIT
// Every bad input of a user: one line with the place and what to do, exit code 2, and
// nothing left behind.
#include <algorithm>

#include "support/run.h"

namespace polhode {
namespace {

using test::Ran;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

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
     "[numerics]\nmethod = \"rk44\"\n[video]",
     ":10: numerics.method:",
     "did you mean 'rk4'?"},
    {"unknown_load",
     "body = [1, 0, 3] }",
     "body = [1, 0, 3] }\ntorque = [{ kind = \"sprng\", k = 1 }]",
     ":9: motion.torque[0].kind:",
     "did you mean 'spring'?"},
    {"load_without_its_key",
     "body = [1, 0, 3] }",
     "body = [1, 0, 3] }\ntorque = [{ kind = \"spring\" }]",
     ":9: motion.torque[0]:",
     "needs 'k'"},
    {"bigger_model_needed",
     "body = [1, 0, 3] }",
     "body = [1, 0, 3] }\ntorque = [{ kind = \"spring\", k = 1 }]\n[numerics]\nmodel = \"ode\"",
     ":11: numerics.model:",
     "depends on where the body is"},
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

TEST(BadInput, EachSceneIsOneLineWithItsPlace) {
  for (const BadScene& bad : kBadScenes) {
    SCOPED_TRACE(bad.name);
    const TemporaryFolder folder;
    std::string text = test::kSmallScene;
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
    {"render DIR/missing.toml -o DIR/a.mp4", 2, "missing.toml: the file does not exist"},
    {"render DIR -o DIR/a.mp4", 2, "folder"},
    {"render SCENE -o DIR/a.mp5", 2, ".mp4"},
    {"render SCENE -o DIR/nowhere/a.mp4", 2, "does not exist"},
    {"render SCENE -o SCENE/a.mp4", 2, "does not exist"},
    {"render SCENE -o DIR/a.mp4 --size 127x72", 2, "even"},
    {"render SCENE -o DIR/a.mp4 --size 16384x16384", 2, "at most 67108864 pixels"},
    {"render SCENE -o DIR/a.mp4 --size 12", 2, "--size"},
    {"render SCENE -o DIR/a.mp4 --size 99999999999x2", 2, "--size"},
    {"render SCENE -o DIR/a.mp4 --fps 0", 2, "--fps"},
    {"render SCENE -o DIR/a.mp4 --fps 29.97", 2, "30000/1001"},
    {"render SCENE -o DIR/a.mp4 --method rk44", 2, "did you mean 'rk4'?"},
    {"render SCENE -o DIR/a.mp4 --method rk4 --step -1", 2, "--step"},
    {"render SCENE -o DIR/a.mp4 --method rk4 --step nan", 2, "--step"},
    {"render SCENE -o DIR/a.mp4 --method rk4 --step 1e-15", 2, "steps"},
    {"render SCENE -o DIR/a.mp4 --method dopri5 --step 0.1", 2, "tolerance"},
    {"render SCENE -o DIR/a.mp4 --method rk4 --step 0.1x", 2, "--step: must be a number"},
    {"render SCENE -o DIR/a.mp4 --step 0.1", 2, "--step: this motion is computed in closed form"},
    {"render SCENE -o DIR/a.mp4 --accuracy 0", 2, "--accuracy: must be greater than 0, got 0"},
    {"render SCENE -o DIR/a.mp4 --method dopri5 --accuracy 1e-30", 2, "--accuracy: 1e-30 rad"},
    {"render SCENE -o ''", 2, "--output: must not be empty"},
    {"render SCENE -o DIR/a.mp4 --report ''", 2, "--report: must not be empty"},
    {"render SCENE -o DIR/.mp4", 2, "the ending needs a name before it"},
    {"render SCENE -o DIR/a%05d.mp4", 2, "a film is a single file"},
    {"render SCENE -o DIR/a%05d.png --still 0.5", 2, "--still: makes one picture"},
    {"render SCENE SCENE -o DIR/a.mp4", 2, "unexpected argument"},
    {"render SCENE -o DIR/a.mp4 --size", 2, "--size needs a value"},
    {"render SCENE --size= -o DIR/a.mp4", 2, "render: --size needs a value"},
    {"render SCENE -o DIR/a.mp4 --crf x", 2, "--crf: must be a number"},
    {"render SCENE -o DIR/a.mp4 --crf 1.5", 2, "--crf: must be a whole number"},
    {"simulate SCENE -o DIR/a.csv --rate abc", 2, "--rate: must be a number"},
    {"list", 2, "methods, models, shapes"},
    {"render SCENE -o DIR/a.mp4 --backend vulkan", 2, "--backend: unknown back end"},
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
    {"", 2, "give a command: new, render, join, verify, preview, simulate"},
    {"list methds", 2, "did you mean 'methods'?"},
    {"manual rendr", 2, "did you mean 'render'?"},
    {"manual -o SCENE", 2, "scene.toml"},
    {"completion fish", 2, "did you mean 'bash'?"},
    {"simulate SCENE -o DIR/a.csv --rate -5", 2, "--rate"},
    {"simulate SCENE -o DIR/a.csv --rate 1e8", 2, "1e+08 a second, are too many"},
    {"simulate SCENE -o DIR/a.csv --method explicit_euler --accuracy 1e-9", 2, "accuracy"},
    {"simulate SCENE -o DIR", 2, "folder"},
    {"simulate SCENE -o SCENE", 2, "the ending of scene files"},
    {"simulate SCENE -o DIR/a.xlsx", 2, "name a .csv, not '.xlsx'"},
    {"plot SCENE tlt -o DIR/a.svg", 2, "no plot is called 'tlt' (did you mean 'tilt'?)"},
    {"plot SCENE phase -o DIR/a.svg", 2, "PLOT: 'phase' needs a heavy symmetric top"},
    {"plot SCENE slip -o DIR/a.csv", 2, "PLOT: 'slip' needs a body on a table"},
    {"plot SCENE tilt -o DIR/a.xlsx", 2, ".svg, .png, .pdf or .csv, not as '.xlsx'"},
    {"plot SCENE tilt -o DIR/a.svg --at 0.1", 2, "--at: marks a point in a diagram"},
    {"plot SCENE polhode_map -o DIR/a.csv --at 99", 2, "--at: must be a time within the motion"},
    {"plot SCENE tilt -o SCENE", 2, "not as '.toml'"},
    {"lecture SCENE -o DIR/out", 2, "is a scene, not a deck"},
    {"render SCENE -o DIR/a.jpg --still 0.5", 2, "'.png'"},
    {"render SCENE -o DIR/a.jpg", 2, "'.png'"},
    {"chart SCENE -o DIR/out --pictures --methods rk4", 2, "--methods: is for charts of methods"},
    {"stability SCENE -o DIR/out --x numerics.step_ms",
     2,
     "--x numerics.step_ms: steps are in seconds here; give numerics.step"},
    {"section SCENE -o DIR/out --set motion.duration=9",
     2,
     "--set motion.duration: is not for sections"},
    {"section SCENE -o DIR/out --set motion.ensemble.members=9",
     2,
     "--set motion.ensemble.members: is not for sections"},
    {"stability SCENE -o DIR/out --set motion.duration_ms=9",
     2,
     "--set motion.duration_ms: is not for maps of stability"},
    {"chart SCENE -o DIR/out --set 'motion.ensemble={ members = 9 }'",
     2,
     "--set motion.ensemble: is not for charts of methods"},
    {"inspect SCENE --set numerics.compare=[rk4] --step 0.1",
     2,
     "--step: is for the methods that the scene compares"},
    {"inspect SCENE --set numerics.compare=[dopri5] --set numerics.tolerance=1e-3",
     2,
     "--set numerics.tolerance: is for the methods that the scene compares"},
    {"diff SCENE/a.png SCENE/b.png --no-text", 2, "--no-text: is for scenes"},
    {"diff SCENE/a.png SCENE/b.png --backend egl", 2, "--backend: is for scenes"},
    {"golden show DIR --jobs 2", 2, "--jobs: is for golden run and update, not for golden show"},
    {"golden show DIR --backend egl", 2, "--backend: is for golden run and update"},
    {"golden show DIR --cause new", 2, "--cause: is for golden update, not for golden show"},
    {"stability SCENE -o DIR/out --y-range 1e-300:1e300", 2, "--y-range: 1e-300:1e300 spans more"},
    {"stability SCENE -o DIR/out --y-range 1:1e200", 2, "--y-range: with 1e+200 times the spin"},
    {"inspect SCENE --set body.solid.mass=99999999999999999999",
     2,
     "--set body.solid.mass: '99999999999999999999' is beyond what an integer holds"},
    {"chart SCENE -o DIR/out --methods 'rk4, rk44'", 2, "'rk44' (did you mean 'rk4'?)"},
    {"inspect SCENE -o DIR/a.txt", 2, "inspect has no option -o (known: --help, --json, "},
    {"inspect -oDIR/a.txt SCENE", 2, "inspect has no option -o"},
    {"render SCENE -o DIR/a.mp4 --sise -1", 2, "did you mean '--size'?"},
    {"render SCENE SCENE -o DIR/a.mp4 --verbose", 2, "unexpected argument"},
    {"render SCENE SCENE -o DIR/a.mp4 -v --from -1", 2, "unexpected argument"},
    {"-o DIR/a.mp4 render SCENE", 2, "must come after the command"},
    {"simulate SCENE -o DIR/scene.toml/../a.csv", 2, "not exist"},
    {"simulate SCENE -o /dev/full", 2, "regular file"},
    {"render SCENE -o DIR/a.mp4 --report DIR/other.toml", 2, "the ending of scene files"},
    {"--size 12x12 render SCENE", 2, "must come after the command"},
    {"render SCENE -o DIR/a.mp4 --report DIR/a.mp4", 2, "overwrite"},
    {"render SCENE -o DIR/a_%03d.png --report DIR/./a_003.png", 2, "overwrite a frame of"},
};

TEST(BadInput, EachCallIsOneLineWithTheRightCode) {
  for (const BadCall& bad : kBadCalls) {
    SCOPED_TRACE(bad.arguments);
    const TemporaryFolder folder;
    write_text(folder / "scene.toml", test::kSmallScene);
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

TEST(BadInput, AMeshIsNotOverwritten) {
  const TemporaryFolder folder;
  std::string scene = test::kSmallScene;
  const std::size_t line = scene.find("solid = {");
  scene.replace(line,
                scene.find('\n', line) - line,
                "solid = { kind = \"mesh\", file = \"a.obj\", mass = 1 }");
  const std::string mesh =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  write_text(folder / "scene.toml", scene);
  write_text(folder / "a.obj", mesh);
  std::filesystem::create_symlink("a.obj", folder / "a.csv");
  for (const char* name : {"a.png", "f_00002.png", "chart.csv"})
    std::filesystem::create_symlink("a.obj", folder / name);
  for (const std::string arguments : {"render SCENE -o DIR/b.png --report DIR/a.obj",
                                      "render SCENE -o DIR/a.png --still 0",
                                      "preview SCENE -o DIR/a.png",
                                      "render SCENE -o hash:DIR/a.obj",
                                      "render SCENE -o DIR/f_%05d.png",
                                      "chart SCENE -o DIR --methods rk4",
                                      "simulate SCENE -o DIR/a.csv"}) {
    SCOPED_TRACE(arguments);
    std::string whole = arguments;
    whole.replace(whole.find("SCENE"), 5, folder / "scene.toml");
    for (std::size_t at; (at = whole.find("DIR")) != std::string::npos;)
      whole.replace(at, 3, folder.path().string());
    const Ran ran = run_polhode(whole);
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_NE(ran.err.find("would overwrite"), std::string::npos) << ran.err;
    EXPECT_EQ(test::read_text(folder / "a.obj"), mesh);
  }
}

// a scene may have the name of anything that its own command writes
TEST(BadInput, ASceneOfAnyNameIsKept) {
  const TemporaryFolder folder;
  const struct {
    const char *name, *arguments;
  } cases[] = {{"chart.csv", "chart DIR/chart.csv -o DIR --methods rk4"},
               {"stability.csv", "stability DIR/stability.csv -o DIR --methods rk4 --cells 2x2"},
               {"film.mp4.part", "render DIR/film.mp4.part -o DIR/film.mp4"},
               {"film.vtt.part", "render DIR/film.vtt.part -o DIR/film.webm"},
               {"index.html", "diff DIR/scene.toml DIR/b.png --html DIR"},
               {"a.png.toml", "golden update DIR --allow-dirty"},
               {"part.vtt.part", "join DIR/a.mp4 DIR/part.vtt.part -o DIR/part.mp4"},
               {"f_00007.png", "render DIR/f_00007.png -o DIR/f_%05d.png"}};
  write_text(folder / "scene.toml", "[[panel]]\nscene = \"index.html\"\n");
  write_text(folder / "cases.toml", "[[case]]\nname = \"a\"\nscene = \"a.png.toml\"\n");
  for (const auto& one : cases) {
    SCOPED_TRACE(one.name);
    write_text(folder / one.name, test::kSmallScene);
    std::string arguments = one.arguments;
    for (std::size_t at; (at = arguments.find("DIR")) != std::string::npos;)
      arguments.replace(at, 3, folder.path().string());
    const Ran ran = run_polhode(arguments);
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_NE(ran.err.find("would overwrite"), std::string::npos) << ran.err;
    EXPECT_EQ(test::read_text(folder / one.name), test::kSmallScene);
  }
}

TEST(BadInput, NamesOfFilesStayWithinTheLine) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  const Ran ran = run_polhode("render '" + (folder / "scene.toml") + "' --still 0 -o '" +
                              (folder / "a\nb\x1b[31m.png") + "'");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("a b\\x1b[31m.png: 1 picture"), std::string::npos) << ran.err;
}

// a report, a page and the tags of a film could not hold them
TEST(BadInput, WordsThatAreNotUtf8AreRefused) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  const std::string scene = "'" + (folder / "scene.toml") + "'";
  for (const std::string& arguments :
       {"render " + scene + " -o '" + (folder / "a\xff.mp4") + "'",
        "render " + scene + " -o '" + (folder / "a.mp4") + "' --set show.caption=a\xe4",
        "inspect " + scene + " --json --set title=\xff"}) {
    SCOPED_TRACE(arguments);
    const Ran ran = run_polhode(arguments);
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_NE(ran.err.find("which is not UTF-8 text"), std::string::npos) << ran.err;
  }
  using Listing = std::filesystem::directory_iterator;
  EXPECT_EQ(std::distance(Listing(folder.path()), Listing()), 1);
}

// pictures that would be empty or nearly so are told of
TEST(BadInput, ACameraThatSeesNothingIsWarnedOf) {
  const struct {
    const char* camera;
    const char* says;
  } cases[] = {{"eye = [5, 0, 0]\ntarget = [10, 0, 0]", "does not see"},
               {"eye = [0.05, 0, 0]", "comes within 0.05 m"},
               {"eye = [1e5, 0, 0]", "never as large as a pixel"},
               {"zoom = 1\n[show]\ntrail_points = [[0, 0, 1e5]]", "never as large as a pixel"},
               {"[[shots]]\nat = 0.1\neye = [1e5, 0, 0]\ntarget = [0, 0, 0]", "shots[0]: the body"},
               {"eye = [2, 0, 0]", ""},
               {"target = [0, 0, 0.1]", ""}};
  for (const auto& one : cases) {
    SCOPED_TRACE(one.camera);
    const TemporaryFolder folder;
    write_text(folder / "scene.toml",
               std::string(test::kSmallScene) + "[camera]\n" + one.camera + "\n");
    const Ran ran =
        run_polhode("render -q '" + (folder / "scene.toml") + "' -o '" + (folder / "a.png") + "'");
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err.empty(), *one.says == '\0') << ran.err;
    EXPECT_NE(ran.err.find(one.says), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace polhode
