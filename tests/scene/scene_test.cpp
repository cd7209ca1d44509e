// SPDX-License-Identifier: MIT
// Scenes out of files: what is no file, numbers put in place of its own, lines for messages.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "scene/scene_file.h"
#include "scene/scene_texts.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode::test {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test.
class SceneFiles : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string error_of_file(const fs::path& path) {
    try {
      load_scene(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      EXPECT_EQ(error.place().file, path.string());
      return error.message();
    }
    return "";
  }
  const fs::path folder_ =
      fs::path(::testing::TempDir()) / ("polhode_load_" + std::to_string(getpid()));
};

TEST_F(SceneFiles, ReadsAFileAndRemembersItsName) {
  const fs::path file = folder_ / "scene.toml";
  std::ofstream(file) << kBody;
  EXPECT_EQ(load_scene(file).file, file.string());
}

TEST_F(SceneFiles, SaysWhatIsWrongWithTheFile) {
  EXPECT_EQ(error_of_file(folder_ / "none.toml"), "the file does not exist");
  EXPECT_EQ(error_of_file(folder_), "is a folder; give a file");
  std::ofstream(folder_ / "empty.toml").close();
  EXPECT_NE(error_of_file(folder_ / "empty.toml").find("is empty"), std::string::npos);
  EXPECT_NE(error_of_file("/dev/zero").find("is not a regular file"), std::string::npos);
}

TEST_F(SceneFiles, SaysWhereAMeshWasLookedFor) {
  const fs::path file = folder_ / "scene.toml";
  std::ofstream(file) << "[body]\nsolid = { kind = \"mesh\", file = \"none.obj\", mass = 1 }\n";
  EXPECT_EQ(error_of_file(file), (folder_ / "none.obj").string() + ": the file does not exist");
}

TEST_F(SceneFiles, SaysThatAFileCannotBeRead) {
  // the first byte of this one is as on a disk that is broken
  expect_error([] { load_scene("/proc/self/mem"); }, Fault::environment, "", "cannot be read");
  if (geteuid() == 0) return;  // root may read everything else
  const fs::path file = folder_ / "secret.toml";
  std::ofstream(file) << kBody;
  fs::permissions(file, fs::perms::none);
  EXPECT_NE(error_of_file(file).find("cannot be read"), std::string::npos);
}

// every scene that ships must be read
TEST(Scene, EveryShippedOneIsRead) {
  const fs::path scenes = fs::path(POLHODE_SOURCE_DIR) / "scenes";
  if (!fs::exists(scenes)) GTEST_SKIP() << "no scenes yet";
  for (const fs::directory_entry& entry : fs::directory_iterator(scenes)) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(load_scene(entry.path())) << entry.path();
  }
}

TEST(Scene, TheLineOfAKeyIsItsOwnOrThatAroundIt) {
  const Scene scene = parse_scene(
      "[body]\n\nparts = [\n{ kind = \"rod\", length = 1 },\n{ kind = \"rod\", radius_cm = 1 "
      "},\n]\n"
      "[motion.attitude]\nzxz_deg = [0,\n0, 0]\n",
      "test.toml");
  EXPECT_EQ(line_of(scene, "body"), 1);
  EXPECT_EQ(line_of(scene, "body.parts"), 3);
  EXPECT_EQ(line_of(scene, "body.parts[1]"), 5);
  EXPECT_EQ(line_of(scene, "body.parts[1].radius"), 5);
  EXPECT_EQ(line_of(scene, "body.parts[0].radius"), 4);
  EXPECT_EQ(line_of(scene, "body.parts[7].radius"), 3);
  EXPECT_EQ(line_of(scene, "body.mass"), 1);
  EXPECT_EQ(line_of(scene, "motion.attitude.zxz"), 8);
  EXPECT_EQ(line_of(scene, "motion.attitude.zxz[1]"), 8);
  EXPECT_EQ(line_of(scene, "video.fps"), 0);
  EXPECT_EQ(line_of(scene, ""), 0);
}

class SceneNumbers : public testing::Test {
 protected:
  SceneNumbers() : file_(folder_ / "scene.toml") { write_text(file_, kSmallScene); }

  TemporaryFolder folder_;
  std::string file_;
};

TEST_F(SceneNumbers, StandWhereTheFilesStood) {
  const Scene scene = load_scene(file_,
                                 {},
                                 {{"motion.spin.body[2]", -7.5},
                                  {"motion.duration", 2.0},
                                  {"body.solid.semi_axes[0]", 0.15},
                                  {"numerics.step", 0.25}});
  EXPECT_EQ(*scene.motion.spin.body, Vec3(1, 0, -7.5));
  EXPECT_EQ(scene.motion.duration, 2.0);
  EXPECT_EQ((*scene.body.solid->semi_axes)[0], 0.15);
  EXPECT_EQ(scene.numerics.step, 0.25);
  EXPECT_EQ(*load_scene(file_).motion.spin.body, Vec3(1, 0, 3));
}

TEST_F(SceneNumbers, AreFound) {
  EXPECT_EQ(number_in_scene(file_, {}, "motion.spin.body[2]"), 3.0);
  EXPECT_EQ(number_in_scene(file_, {}, "body.solid.mass"), 1.0);
  for (const char* path : {"motion.spin.body[3]", "motion.spn", "motion.spin", "video.size"})
    EXPECT_FALSE(number_in_scene(file_, {}, path)) << path;
}

// what is no number of the file is refused, by its path or by the strict reader
TEST_F(SceneNumbers, WrongPathsAreRefused) {
  const auto with = [&](const char* path, double value = 1.0) {
    return [=, this] {
      load_scene(file_, {}, {{path, value}});
    };
  };
  for (const char* path : {"motion.spin.body[7]", "motion.spin", "video.size[0]", "motion.spin[0]"})
    expect_input_error(with(path), std::string(path) + " = 1", "no number at");
  for (const char* path : {"motion.spin.body[", "motion..spin", "motion.spin.body[x]", ""})
    expect_input_error(with(path), std::string(path) + " = 1", "not a key");
  expect_input_error(with("motion.durration"), "motion.durration = 1", "did you mean 'duration'?");
  expect_input_error(with("motion.duration", -1.0), "motion.duration = -1", "greater than 0");
}

class SceneSettings : public SceneNumbers {
 protected:
  Scene with(const std::vector<std::string>& texts) const {
    std::vector<Setting> settings;
    for (const std::string& text : texts)
      settings.push_back(parse_setting(text));
    return load_scene(file_, settings);
  }
};

TEST_F(SceneSettings, StandAsIfInTheFile) {
  const Scene scene = with({"motion.spin.body[2]=-7.5",
                            "motion.attitude={ zxz_deg = [0, 90, 0] }",
                            "body.solid.mass_g=250",
                            "video.theme=light",
                            "video.size=\"64x48\"",
                            "show.floor=true",
                            "title = a = b"});
  EXPECT_EQ(*scene.motion.spin.body, Vec3(1, 0, -7.5));
  EXPECT_NEAR((*scene.motion.attitude.zxz)[1], 0.5 * kPi, 1e-15);
  EXPECT_EQ(*scene.body.solid->mass, 0.25) << "instead of the mass in kilograms";
  EXPECT_EQ(scene.theme.theme, "light");
  EXPECT_EQ(scene.video.size.width, 64);
  EXPECT_EQ(scene.show.asked.at("floor"), true);
  EXPECT_EQ(scene.title, "a = b");
  // and the same scene written out has the same hash
  std::string text = kSmallScene;
  const auto write = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  write("\"test\"", "\"a = b\"");
  write("mass = 1.0", "mass = 0.25");
  write("[0, 40, 0]", "[0, 90, 0]");
  write("[1, 0, 3]", "[1, 0, -7.5]");
  write("\"128x72\"", "\"64x48\"\ntheme = \"light\"");
  EXPECT_EQ(scene_hash(scene), scene_hash(parse_scene(text + "[show]\nfloor = true\n", "")));
  // errors that are found later can name them
  EXPECT_EQ(scene.options.at("body.solid.mass").key, "--set body.solid.mass_g");
  EXPECT_EQ(line_of(scene, "motion.attitude.zxz"), line_of(scene, "motion"));
}

// shells take quotes away
TEST_F(SceneSettings, TakeListsOfWordsWithoutQuotes) {
  const Scene scene = with({"show.plots=[omega, tilt]"});
  EXPECT_EQ(scene.show.plots, (std::vector<std::string>{"omega", "tilt"}));
  for (const char* text : {"show.plots=[omega, 3 4]", "show.plots=[omega", "show.plots=[a.b, c]"})
    expect_input_error([&] { with({text}); }, "--set show.plots", "not valid TOML");
}

// a table that the option brings, and one of the file that it does not go with
TEST_F(SceneSettings, ThatBringATableAreToBlame) {
  expect_error([&] { with({"motion.spinn.body=[1,2,3]"}); },
               Fault::input,
               "--set motion.spinn.body",
               "motion.spinn: unknown key (did you mean 'spin'?)");
  expect_error([&] { with({"motion.spin.rates=[1,2,3]"}); },
               Fault::input,
               "motion.spin",
               "; 'motion.spin.rates' is set from outside this file");
}

TEST_F(SceneSettings, ThatAreWrongAreNamedByTheirOption) {
  const struct {
    const char *text, *key, *words;
  } cases[] = {
      {"motion.spin.body[2]=fast", "--set motion.spin.body[2]", "must be a number"},
      {"motion.spin.body[3]=1", "--set motion.spin.body[3]", "no value at"},
      {"motion.spn=1", "--set motion.spn", "did you mean 'spin'?"},
      {"motion={spn=1}", "--set motion", "motion.spn: unknown key"},
      {"body.solid.mass_g=x", "--set body.solid.mass_g", "must be a number"},
      {"title=\"open", "--set title", "not valid TOML"},
      {"title=1\nmass=2", "--set title", "more than one value"},
      {"a[=1", "--set a[", "not a key"},
      {"a b=1", "--set a b", "not a key"},
      {".motion.duration=1", "--set .motion.duration", "not a key"},
      {"motion.duration", "", "no KEY=VALUE"},
      {"title=", "", "title has no value after its '='; an empty text is title='\"\"'"},
      {"=1", "", "no KEY=VALUE"},
  };
  for (const auto& [text, key, words] : cases) {
    SCOPED_TRACE(text);
    expect_input_error([&, text = text] { with({text}); }, key, words);
  }
}

// the names as they are spelled, of every place where a mesh may stand; none is opened
TEST(Scene, MeshFilesAreNamedWithoutBeingOpened) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml",
             "[body]\nparts = [{ kind = \"mesh\", file = \"a.obj\", mass = 1 },\n"
             "{ kind = \"box\", size = [1, 1, 1], mass = 1 }]\n"
             "look = { kind = \"mesh\", file = \"sub/b.stl\" }\n");
  std::vector<std::string> files = named_files(folder / "scene.toml");
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files, (std::vector<std::string>{"a.obj", "sub/b.stl"}));
}

TEST(Scene, ItsInputsAreItsFileAndItsMeshes) {
  const Scene scene = parse_scene(
      "[body]\nparts = [{ kind = \"mesh\", file = \"a.obj\", mass = 1 }]\n", "in/scene.toml");
  EXPECT_EQ(input_files(scene), (std::vector<std::filesystem::path>{"in/scene.toml", "in/a.obj"}));
}

}  // namespace
}  // namespace polhode::test
