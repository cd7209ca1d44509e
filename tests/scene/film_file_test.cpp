// SPDX-License-Identifier: MIT
#include "scene/film_file.h"

#include <gtest/gtest.h>

#include "scene/scene_file.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

class FilmFiles : public testing::Test {
 protected:
  FilmFiles() {
    test::write_text(folder_ / "a.toml", test::kSmallScene);
    test::write_text(folder_ / "b.toml", test::kSmallScene);
  }
  Scene film(const std::string& text, const std::vector<Setting>& settings = {}) {
    test::write_text(folder_ / "film.toml", text);
    return load_scene(folder_ / "film.toml", settings);
  }
  // what is said of a film that is refused, without the folder
  std::string why(const std::string& text) {
    try {
      film(text);
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      std::string words = error.what();
      const std::string folder = folder_.path().string() + "/";
      for (std::size_t at = words.find(folder); at != std::string::npos; at = words.find(folder))
        words.erase(at, folder.size());
      return words;
    }
    return "nothing";
  }

  test::TemporaryFolder folder_;
};

const std::string kTwo = "[[panel]]\nscene = \"a.toml\"\n[[panel]]\nscene = \"b.toml\"\n";

TEST_F(FilmFiles, AreTheirScenesWithWhatIsDifferent) {
  const Scene film = this->film(
      "title = \"Both\"\n" + kTwo +
      "caption = \"faster\"\nset = { \"motion.spin.body[2]\" = 7, motion.duration = 9 }\n"
      "[video]\nsize = \"320x180\"\n");
  ASSERT_EQ(film.panels.size(), 2U);
  EXPECT_EQ(film.title, "Both");
  EXPECT_EQ(film.panels[0].caption, "test");
  EXPECT_EQ(film.panels[1].caption, "faster");
  const Scene alone = load_scene(folder_ / "a.toml");
  EXPECT_EQ(film.panels[0].scene.motion.spin.body, alone.motion.spin.body);
  EXPECT_EQ((*film.panels[1].scene.motion.spin.body)[2], 7.0);
  for (const ScenePanel& panel : film.panels) {
    EXPECT_EQ(panel.scene.video.size.width, 320);
    EXPECT_EQ(panel.scene.motion.duration, 9.0) << "as long as the longest";
    EXPECT_TRUE(panel.scene.panels.empty());
  }
  EXPECT_EQ(film.motion.spin.body, alone.motion.spin.body) << "it is the first";
}

TEST_F(FilmFiles, TablesAreMergedAndPathsReplace) {
  const auto end = [&](const std::string& set) {
    return film("[[panel]]\nscene = \"a.toml\"\nset = " + set).panels[0].scene.motion;
  };
  const MotionSpec before = load_scene(folder_ / "a.toml").motion;
  EXPECT_EQ(end("{ motion = { duration = 3 } }").spin.body, before.spin.body);
  EXPECT_FALSE(end("{ \"motion.spin\" = { rates = [1, 2, 3] } }").spin.body);
}

TEST_F(FilmFiles, OneLengthMayBeGivenForAll) {
  const Scene common = film(kTwo + "[motion]\nduration = 2\n");
  EXPECT_EQ(common.panels[1].scene.motion.duration, 2.0);
  const Scene asked = film(kTwo, {{"motion.duration", "4"}, {"panel[1].caption", "second"}});
  EXPECT_EQ(asked.panels[0].scene.motion.duration, 4.0);
  EXPECT_EQ(asked.panels[1].caption, "second");
}

TEST_F(FilmFiles, ASweepIsAPanelForEachValue) {
  const std::string sweep =
      "[sweep]\nscene = \"a.toml\"\nkey = \"motion.spin.body[2]\"\nvalues = [5, 10.5]\n";
  const Scene film = this->film(sweep + "caption = \"{} rad/s\"\n");
  ASSERT_EQ(film.panels.size(), 2U);
  EXPECT_EQ(film.panels[1].caption, "10.5 rad/s");
  EXPECT_EQ(this->film(sweep + "caption = \"{}: Ω = {}\"\n").panels[1].caption, "10.5: Ω = 10.5");
  EXPECT_EQ((*film.panels[1].scene.motion.spin.body)[2], 10.5);
  EXPECT_EQ(this->film(sweep).panels[0].caption, "motion.spin.body[2] = 5");
}

// the heading of a panel would tell another value
TEST_F(FilmFiles, WhatASweepChangesIsNotSetOtherwise) {
  const std::string sweep =
      "[sweep]\nscene = \"a.toml\"\nkey = \"motion.spin.body[2]\"\nvalues = [5, 10.5]\n";
  for (const char* key : {"motion.spin.body[2]", "motion.spin.body", "motion.spin", "motion"}) {
    test::expect_input_error(
        [&] {
          film(sweep, {{key, "1"}});
        },
        fmt::format("--set {}", key),
        "the sweep changes 'motion.spin.body[2]'");
  }
  EXPECT_EQ((*film(sweep, {{"motion.spin.body[0]", "1"}}).panels[1].scene.motion.spin.body)[2],
            10.5);
  EXPECT_EQ(film(sweep, {{"sweep.values", "[3]"}}).panels[0].caption, "motion.spin.body[2] = 3");
}

// with a path or a table there, in another unit or around it
TEST_F(FilmFiles, SettingsOfAPanelReplaceWhatItSets) {
  const auto spin = [&](const std::string& set, const Setting& setting) {
    return *film(kTwo + "set = " + set + "\n", {setting}).panels[1].scene.motion.spin.body;
  };
  const std::string key = "panel[1].set.motion.spin.body";
  for (const char* set : {"{ \"motion.spin.body[2]\" = 7 }",
                          "{ motion = { spin = { body = [1, 2, 3] } } }",
                          "{ \"motion.spin\" = { body = [1, 2, 3] } }",
                          "{}"}) {
    EXPECT_EQ(spin(set, {key, "[4, 5, 6]"}), Vec3(4, 5, 6)) << set;
    EXPECT_EQ(spin(set, {key + "[2]", "8"})[2], 8.0) << set;
    EXPECT_EQ(spin(set, {"panel[1].set.motion", "{ spin = { body = [4, 5, 6] } }"}), Vec3(4, 5, 6))
        << set;
  }
  EXPECT_EQ(spin("{ \"motion.spin\" = { body = [1, 2, 3] }, \"motion.spin.body[2]\" = 9 }",
                 {"panel[1].set.motion.duration", "2"}),
            Vec3(1, 2, 9));
  // it is narrower than one for all
  for (const bool first : {true, false}) {
    const Setting all = {"motion.spin.body[2]", "5"}, one = {key + "[2]", "6"};
    const Scene both = film(kTwo, first ? std::vector{one, all} : std::vector{all, one});
    EXPECT_EQ((*both.panels[0].scene.motion.spin.body)[2], 5.0);
    EXPECT_EQ((*both.panels[1].scene.motion.spin.body)[2], 6.0);
    EXPECT_THROW(refuse_given_for_panels(both.panels[1].scene, "motion.spin"), Error);
    EXPECT_NO_THROW(refuse_given_for_panels(both.panels[0].scene, "motion.spin"));
  }
  test::expect_input_error(
      [&] {
        film(kTwo, {{"panel[2].set.motion.duration", "2"}});
      },
      "--set panel[2].set.motion.duration",
      "no value at");
}

// whatever changes a pixel changes the hash, and nothing else does
TEST_F(FilmFiles, HashesFollowWhatIsShown) {
  const std::string before = scene_hash(film(kTwo));
  EXPECT_EQ(scene_hash(film("# a comment\n" + kTwo)), before);
  for (const char* more :
       {"caption = \"x\"\n", "set = { \"motion.spin.body[2]\" = 7 }\n", "[video]\nfps = 12\n"}) {
    EXPECT_NE(scene_hash(film(kTwo + more)), before) << more;
  }
  for (const char* first : {"title = \"x\"\n", "cameras = \"own\"\n", "scales = \"own\"\n"})
    EXPECT_NE(scene_hash(film(first + kTwo)), before) << first;
}

TEST_F(FilmFiles, WhatIsWrongIsToldWhereItStands) {
  EXPECT_EQ(why("pannel = 1\n" + kTwo), "film.toml:1: pannel: unknown key (did you mean 'panel'?)");
  EXPECT_EQ(why(kTwo + "[video]\nfps = 0\n"),
            "film.toml:6: video.fps: must be 1 to 1000 frames per second, got 0");
  EXPECT_EQ(why(kTwo + "set = { motion.durations = 1 }\n"),
            "film.toml:5: panel[1].set.motion.durations: unknown key (did you mean 'duration'?)");
  EXPECT_EQ(why(kTwo + "set = { \"motion.spin.body[7]\" = 1 }\n"),
            "film.toml:5: panel[1].set.motion.spin.body[7]: the scene has no value at "
            "'motion.spin.body[7]'");
  EXPECT_EQ(why(kTwo + "set = { \"not a key\" = 1 }\n").substr(0, 31),
            "film.toml:5: panel[1].set.not a");
  EXPECT_EQ(why(kTwo + "[[panel]]\nscene = \"c.toml\"\n"),
            "film.toml:6: panel[2].scene: the file 'c.toml' does not exist");
  EXPECT_EQ(why("[sweep]\nscene = \"c.toml\"\nkey = \"x\"\nvalues = [1, 2]\n"),
            "film.toml:2: sweep.scene: the file 'c.toml' does not exist");
  EXPECT_NE(why("[[panel]]\nscene = \"film.toml\"\n")
                .find("film.toml:2: panel[0].scene: 'film.toml' is a"),
            std::string::npos);
  EXPECT_NE(
      why(kTwo + "[sweep]\nscene = \"a.toml\"\nkey = \"x\"\nvalues = [1]\n").find("exactly one"),
      std::string::npos);
  EXPECT_NE(why(kTwo + "[video]\nloop = true\n").find("film.toml:6: video.loop"),
            std::string::npos);
  EXPECT_NE(why(kTwo + "[show]\nviews = [\"space\", \"body\"]\n").find("film.toml:6: show.views"),
            std::string::npos);
  EXPECT_NE(
      why(kTwo + "[numerics]\ncompare = [\"rk4\", \"dmv2\"]\n").find("numerics.compare: a panel"),
      std::string::npos);
  // what all panels share cannot differ in one
  EXPECT_NE(
      why(kTwo + "set = { \"video.fps\" = 10 }\n").find("'video.fps' is one for the whole film"),
      std::string::npos);
  EXPECT_NE(
      why("[sweep]\nscene = \"a.toml\"\nkey = \"video.theme\"\nvalues = [\"dark\", \"light\"]\n")
          .find("film.toml:4: sweep.values[0]: 'video.theme' is one for the whole film"),
      std::string::npos);
  EXPECT_NE(why(kTwo + "set = { \"camera.fov_deg\" = 20 }\n").find("or set cameras = \"own\""),
            std::string::npos);
  // as is what lasts as long in all
  EXPECT_EQ(why("[sweep]\nscene = \"a.toml\"\nkey = \"motion.duration\"\nvalues = [1, 2]\n"),
            "film.toml:3: sweep.key: 'motion.duration' is one for the whole film; set it beside "
            "[sweep]");
  // nobody could say which counts
  EXPECT_EQ(why(kTwo + "set = { \"body.solid.mass\" = 1, body = { solid = { mass = 2 } } }\n"),
            "film.toml:5: panel[1].set.body.solid.mass: 'body.solid.mass' is given twice");
  EXPECT_NE(why(kTwo + "[motion]\nduration = 1\nduration_ms = 2\n").find("give only one of"),
            std::string::npos);
  EXPECT_EQ(why(kTwo + "set = { \"motion.duration\" = 1 }\n[motion]\nduration = 2\n"),
            "film.toml:5: panel[1].set.motion.duration: 'motion.duration' is given for the whole "
            "film; leave one out");
  std::string many_keys = "k0 = 1";
  for (int i = 1; i < 1001; ++i)
    many_keys += fmt::format(", k{} = 1", i);
  EXPECT_NE(why(kTwo + "set = { " + many_keys + " }\n").find("sets 1001 values; at most 1000"),
            std::string::npos);
  std::string deep = "a";
  for (int i = 0; i < 120'000; ++i)
    deep += ".a";
  EXPECT_NE(why(kTwo + "set = { \"" + deep + "\" = 1 }\n").find("has more than 100 parts"),
            std::string::npos);
  std::string many;
  for (int i = 0; i < 10; ++i)
    many += "[[panel]]\nscene = \"a.toml\"\n";
  EXPECT_NE(why(many).find("has 10 panels; at most 9"), std::string::npos);
}

// a key of a sweep, a value of it, and a table that a panel brings
TEST_F(FilmFiles, ChangesAreToBlameForWhatTheyBring) {
  const std::string sweep = "[sweep]\nscene = \"a.toml\"\n";
  EXPECT_EQ(why(sweep + "key = \"motion.spinn.body[2]\"\nvalues = [1]\n"),
            "film.toml:3: sweep.key: the scene has no value at 'motion.spinn.body[2]'");
  EXPECT_EQ(why(sweep + "key = \"body.solid.mass\"\nvalues = [1,\n2,\n-3]\n"),
            "film.toml:6: sweep.values[2]: must be greater than 0, got -3");
  EXPECT_EQ(why(kTwo + "set = { \"motion.spinn.body\" = [1, 2, 3] }\n"),
            "film.toml:5: panel[1].set.motion.spinn.body: motion.spinn: unknown key (did you mean "
            "'spin'?)");
}

TEST_F(FilmFiles, NameTheirFiles) {
  film(kTwo);
  EXPECT_EQ(named_files(folder_ / "film.toml"), (std::vector<std::string>{"a.toml", "b.toml"}));
  EXPECT_EQ(input_files(load_scene(folder_ / "film.toml")).size(), 3U);
}

// numbers along the axes of a map are of one scene
TEST_F(FilmFiles, AreRefusedWhereOneMotionIsWanted) {
  const Scene film = this->film(kTwo);
  test::expect_input_error(
      [&] { refuse_panels(film); }, "", "is a film of 2 scenes; name one of them");
  EXPECT_THROW(load_scene(folder_ / "film.toml", {}, {{"motion.duration", 2.0}}), Error);
}

}  // namespace
}  // namespace polhode
