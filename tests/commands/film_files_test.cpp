// SPDX-License-Identifier: MIT
// Films of several scenes, with the real program.
#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "base/json.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;
class SeveralScenes : public ::testing::Test {
 protected:
  SeveralScenes() {
    write_text(folder_ / "scene.toml", test::kSmallScene);
    write_text(folder_ / "film.toml",
               "title = \"Slow and fast\"\n"
               "[[panel]]\nscene = \"scene.toml\"\ncaption = \"slow\"\n"
               "[[panel]]\nscene = \"scene.toml\"\ncaption = \"fast\"\n"
               "set = { \"motion.spin.body[2]\" = 9 }\n"
               "[video]\nsize = \"256x96\"\n"
               "[show]\nplots = [\"tilt\"]\n"
               "[[story]]\nat = 0\ncaption = \"They turn\"\n"
               "[[story]]\nat = 0.5\nhold = 0.5\ncaption = \"They stand\"\n");
  }
  std::string at(const std::string& name) const { return fmt::format("'{}'", folder_ / name); }
  void run(const std::string& command, int code = 0) const {
    const Ran ran = run_polhode(command);
    ASSERT_EQ(ran.code, code) << command << '\n' << ran.err;
  }
  std::string hashes(const std::string& options) const {
    run(fmt::format("render {} -o {} {}", at("film.toml"), at("a.hash"), options));
    return read_text(folder_ / "a.hash");
  }

  TemporaryFolder folder_;
};

TEST_F(SeveralScenes, AreOneFilmInOneOrManyPieces) {
  const std::string whole = hashes("");
  EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 15);
  EXPECT_EQ(hashes("--jobs 2"), whole);
  EXPECT_NE(hashes("--set motion.spin.body[0]=2"), whole);
  EXPECT_EQ(hashes("--set title='\"Slow and fast\"'"), whole);
  EXPECT_EQ(hashes("--shard 1/2") + hashes("--shard 2/2"), whole);
  run(fmt::format("render {} -o {} --resume", at("film.toml"), at("resumed.mp4")));
  EXPECT_NE(read_text(folder_ / "resumed.vtt").find("They stand"), std::string::npos);
}

// the report has what is needed to make it again, and what it says is looked at
TEST_F(SeveralScenes, AreVerified) {
  run(fmt::format("render {} -o {} --report {}", at("film.toml"), at("a.mp4"), at("a.json")));
  const std::string honest = read_text(folder_ / "a.json");
  const Json report = Json::parse(honest);
  const Json& panels = report.at("film").at("panels");
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(report.at("title"), "Slow and fast");
  EXPECT_EQ(panels[1].at("caption"), "fast");
  EXPECT_EQ(panels[1].at("scene").at("motion").at("spin").at("body")[2], 9.0);
  EXPECT_EQ(panels[1].at("method"), "exact");
  run(fmt::format("verify {}", at("a.mp4")));
  const auto altered = [&](const std::function<void(Json&)>& change) {
    Json other = report;
    change(other);
    write_text(folder_ / "a.json", other.dump());
    return run_polhode(fmt::format("verify {}", at("a.mp4"))).code;
  };
  EXPECT_EQ(altered([](Json&) {}), 0);
  EXPECT_EQ(altered([](Json& r) { r["film"]["panels"][1]["caption"] = "fastest"; }), 1);
  EXPECT_EQ(altered([](Json& r) { r["film"]["panels"][1]["trusted"] = false; }), 1);
  EXPECT_EQ(altered([](Json& r) { r["film"]["panels"][1]["scene"]["motion"]["duration"] = 2; }), 1);
  EXPECT_EQ(altered([](Json& r) { r["film"]["scales"] = "own"; }), 1);
  EXPECT_EQ(altered([](Json& r) { r["film"]["panels"] = Json::array(); }), 2);
  EXPECT_EQ(altered([](Json& r) { r.erase("film"); }), 1);
}

// one after the other: the frames of each scene, which a film of it alone has too
TEST_F(SeveralScenes, FollowOneAnotherInTurn) {
  write_text(folder_ / "turns.toml",
             "arrange = \"in_turn\"\ncameras = \"own\"\nscales = \"own\"\n"
             "[sweep]\nscene = \"scene.toml\"\nkey = \"motion.spin.body[2]\"\nvalues = [3, 9]\n");
  const auto frames = [&](const std::string& scene, const std::string& options) {
    run(fmt::format("render {} -o {} {}", at(scene), at("a.hash"), options));
    std::istringstream lines(read_text(folder_ / "a.hash"));
    std::vector<std::string> found;  // without the numbers of the frames
    for (std::string line; std::getline(lines, line);)
      found.push_back(line.substr(line.find_last_of(" ,") + 1));
    return found;
  };
  const std::vector<std::string> whole = frames("turns.toml", "--no-text");
  std::vector<std::string> alone = frames("scene.toml", "--no-text --set motion.spin.body[2]=3");
  const std::vector<std::string> second =
      frames("scene.toml", "--no-text --set motion.spin.body[2]=9");
  alone.insert(alone.end(), second.begin(), second.end());
  ASSERT_EQ(whole.size(), 20U);
  EXPECT_EQ(whole, alone);
  // in pieces, and from a time in the second
  std::vector<std::string> pieces = frames("turns.toml", "--no-text --shard 1/3");
  for (const char* piece : {"--no-text --shard 2/3", "--no-text --shard 3/3"}) {
    const std::vector<std::string> more = frames("turns.toml", piece);
    pieces.insert(pieces.end(), more.begin(), more.end());
  }
  EXPECT_EQ(pieces, whole);
  const std::vector<std::string> late = frames("turns.toml", "--no-text --from 1.2");
  EXPECT_EQ(late, std::vector<std::string>(whole.begin() + 12, whole.end()));
  // plots and captions go through all of them; the report makes it again
  run(fmt::format("render {} -o {} --set 'show.plots=[\"tilt\"]' --report {}",
                  at("turns.toml"),
                  at("a.mp4"),
                  at("a.json")));
  EXPECT_EQ(Json::parse(read_text(folder_ / "a.json")).at("film").at("arrange"), "in_turn");
  run(fmt::format("verify {}", at("a.mp4")));
  run(fmt::format("render {} -o {} --still 2.1", at("turns.toml"), at("b.png")), 2);
}

// the last frame of a panel shows nothing of the next, which begins while it is exposed
TEST_F(SeveralScenes, AnOpenShutterClosesWithItsPanel) {
  const auto frame = [&](double next_spin) {
    write_text(folder_ / "turns.toml",
               fmt::format("arrange = \"in_turn\"\ncameras = \"own\"\nscales = \"own\"\n"
                           "[sweep]\nscene = \"scene.toml\"\nkey = \"motion.spin.body[2]\"\n"
                           "values = [9, {}]\n[motion]\nduration = 0.97\n"
                           "[video]\nshutter_deg = 360\n",
                           next_spin));
    run(fmt::format(
        "render {} -o {} --no-text --from 0.9 --to 0.96", at("turns.toml"), at("a.hash")));
    return read_text(folder_ / "a.hash");
  };
  EXPECT_EQ(frame(3.0), frame(5.0));
}

// a body that turns ever faster, and too fast for the film after its end
TEST_F(SeveralScenes, InTurnAreLookedAtWithinTheirMotions) {
  write_text(folder_ / "spun.toml",
             "[body]\nmoments = [1, 1, 2]\n[motion]\nduration = 1\n"
             "torque = [{ kind = \"constant\", body = [0, 0, 52] }]\n");
  write_text(folder_ / "film.toml",
             "arrange = \"in_turn\"\n[[panel]]\nscene = \"spun.toml\"\n"
             "[[panel]]\nscene = \"spun.toml\"\n[video]\nsize = \"64x36\"\nfps = 10\n");
  const Ran ran = run_polhode(fmt::format("render {} -o {}", at("film.toml"), at("a.mp4")));
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err.find("from frame to frame"), std::string::npos) << ran.err;
}

// a pendulum that swings twice a frame is within its swing at all frames, though fast between them
TEST_F(SeveralScenes, InTurnAreLookedAtInFramesThatTheyShow) {
  write_text(folder_ / "swing.toml",
             "[body]\nsolid = { kind = \"rod\", length = 0.05, radius = 0.001, mass = 1 }\n"
             "pivot = [0, 0, 0.025]\n[motion]\nhold = \"pivot\"\nduration = 1\n"
             "attitude = { zxz_deg = [0, 40, 0] }\n");
  write_text(
      folder_ / "spin.toml",
      "[body]\nmoments = [1, 1, 2]\n[motion]\nduration = 1\nspin = { body = [0, 0, 300] }\n");
  write_text(folder_ / "film.toml",
             "arrange = \"in_turn\"\n[[panel]]\nscene = \"swing.toml\"\n"
             "[[panel]]\nscene = \"spin.toml\"\n[video]\nsize = \"64x36\"\nfps = 2\n"
             "[[story]]\nat = 0.6\ncaption = \"late\"\n");
  const auto told = [&](const std::string& options) {
    const Ran ran =
        run_polhode(fmt::format("render {} -o {} {}", at("film.toml"), at("a.mp4"), options));
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.err;
  };
  EXPECT_EQ(told("--to 1").find("from frame to frame"), std::string::npos) << told("--to 1");
  const std::string whole = told("");
  EXPECT_NE(whole.find("video.fps: the body turns by 8594 degrees"), std::string::npos) << whole;
  EXPECT_NE(whole.find("story[0].at: is never seen"), std::string::npos) << whole;
  EXPECT_EQ(told("--fps 10").find("is never seen"), std::string::npos);
}

TEST_F(SeveralScenes, ArePreviewedButHaveNoOneMotion) {
  run(fmt::format("preview {} -o {}", at("film.toml"), at("sheet.png")));
  for (const char* command : {"simulate -o -", "chart", "stability"}) {
    const Ran ran = run_polhode(fmt::format("{} {}", command, at("film.toml")));
    EXPECT_EQ(ran.code, 2) << command << ran.err;
    EXPECT_NE(ran.err.find("is a film of 2 scenes; name one of them"), std::string::npos)
        << ran.err;
  }
  const Ran facts = run_polhode(fmt::format("inspect {}", at("film.toml")));
  EXPECT_EQ(facts.code, 0) << facts.err;
  EXPECT_EQ(facts.out.find("slow\n"), 0U) << facts.out;
  EXPECT_NE(facts.out.find("\n\nfast\n"), std::string::npos) << facts.out;
  const Ran json = run_polhode(fmt::format("inspect {} --json", at("film.toml")));
  EXPECT_EQ(Json::parse(json.out).at("panels")[1].at("caption"), "fast");
  // no output lands on what is shown
  run(fmt::format("render {} -o a.mp4 --report {}", at("film.toml"), at("scene.toml")), 2);
}

// a deck that asks for one motion of several, or for a loop of them
TEST_F(SeveralScenes, AreNoNumbersAndNoLoopOfADeck) {
  for (const char* what : {".inspect", ".loop"}) {
    write_text(folder_ / "deck.md", fmt::format("# One\n\n![a](film.toml){{{}}}\n", what));
    const Ran ran = run_polhode(
        fmt::format("lecture {} -o {} --to html --size 64x36", at("deck.md"), at("out")));
    EXPECT_EQ(ran.code, 2) << what << ran.err;
    EXPECT_NE(ran.err.find("film.toml: is a film of 2 scenes"), std::string::npos) << ran.err;
  }
}

// one camera has one list of shots
TEST_F(SeveralScenes, ShotsOfOnePanelAreRefused) {
  write_text(folder_ / "shots.toml",
             std::string(test::kSmallScene) + "[[shots]]\nat = 0.2\nzoom = 1\n");
  const std::string sweep =
      "[sweep]\nscene = \"shots.toml\"\nkey = \"shots[0].zoom\"\nvalues = [1, 3]\n";
  write_text(folder_ / "sweep.toml", sweep);
  const Ran same = run_polhode(fmt::format("render {} -o {}", at("sweep.toml"), at("a.hash")));
  EXPECT_EQ(same.code, 2);
  EXPECT_NE(same.err.find("is one for the whole film"), std::string::npos) << same.err;
  write_text(folder_ / "sweep.toml", "cameras = \"own\"\n" + sweep);
  run(fmt::format("render {} -o {}", at("sweep.toml"), at("a.hash")));
}

TEST_F(SeveralScenes, WhatCannotBeReadIsToldOrRefused) {
  write_text(folder_ / "small.toml",
             "[[panel]]\nscene = \"scene.toml\"\n[[panel]]\nscene = \"scene.toml\"\n"
             "set = { body.solid.semi_axes = [0.01, 0.01, 0.02] }\n");
  const auto still = [&](const char* film, const char* picture) {
    return run_polhode(
        fmt::format("render {} --still 0 --size 128x64 -o {}", at(film), at(picture)));
  };
  const Ran small = still("small.toml", "a.png");
  EXPECT_EQ(small.code, 0);
  EXPECT_NE(small.err.find("one body is 10 times as large as another"), std::string::npos)
      << small.err;
  write_text(folder_ / "many.toml",
             "[sweep]\nscene = \"scene.toml\"\nkey = \"motion.spin.body[2]\"\nvalues = [1, 2, 3]\n"
             "[show]\nplots = [\"omega\"]\n");
  const Ran many = still("many.toml", "b.png");
  EXPECT_EQ(many.code, 2);
  EXPECT_NE(many.err.find("many.toml:6: show.plots: a plot holds 6 curves, and 'omega' of 3 panels "
                          "has 9"),
            std::string::npos)
      << many.err;
}

}  // namespace
}  // namespace polhode
