// SPDX-License-Identifier: MIT
// The real binary from scene to product.
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/commands/new_scene.h"
#include "image/png.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

class GoodRun : public ::testing::Test {
 protected:
  GoodRun() { write_text(folder_ / "scene.toml", test::kSmallScene); }
  std::string scene() const { return fmt::format("'{}'", folder_ / "scene.toml"); }
  std::string out(const std::string& name) const { return fmt::format(" -o '{}'", folder_ / name); }

  TemporaryFolder folder_;
};

TEST_F(GoodRun, FilmWithReport) {
  const Ran ran = run_polhode("render -q " + scene() + out("a.mp4") + " --report '" +
                              (folder_ / "r.json") + "'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(folder_.entries(), 3);
  const auto report = nlohmann::json::parse(read_text(folder_ / "r.json"));
  EXPECT_EQ(report["frames"], 10);
  EXPECT_EQ(report["model"], "symmetric");
  EXPECT_EQ(report["method"], "exact");
  EXPECT_LT(report["energy_drift"].get<double>(), 1e-14);
  EXPECT_LT(report["momentum_drift"].get<double>(), 1e-14);
  EXPECT_EQ(report["fps"], "10/1");
  EXPECT_EQ(report["scene_hash"].get<std::string>().size(), 32u);
  EXPECT_FALSE(report["gl_renderer"].get<std::string>().empty());
  EXPECT_FALSE(report["model_reason"].get<std::string>().empty());
  for (const char* stage : {"simulate", "compose", "draw", "read_back", "convert", "encode"}) {
    EXPECT_GT(report["stages"][stage]["wall_s"].get<double>(), 0.0) << stage;
    EXPECT_GT(report["stages"][stage]["cpu_s"].get<double>(), 0.0) << stage;
  }
  EXPECT_EQ(report["stages"]["smooth"]["wall_s"], 0.0) << "nothing was smoothed";
}

// what `new` writes is taken by the command that it names, without a warning
TEST_F(GoodRun, NewScenesAndTheirNextCommands) {
  for (const NewKind& kind : new_kinds()) {
    SCOPED_TRACE(kind.name);
    const TemporaryFolder folder;
    const std::string first =
        folder / ("mine" + std::filesystem::path(kind.files[0]).extension().string());
    const Ran made = run_polhode(fmt::format("new {} -o '{}'", kind.name, first));
    ASSERT_EQ(made.code, 0) << made.err;
    const std::string words = "next: polhode ";
    const std::size_t at = made.err.find(words);
    ASSERT_NE(at, std::string::npos) << made.err;
    std::string next = made.err.substr(at + words.size());
    next.pop_back();  // the end of the line
    const bool deck = next.rfind("lecture ", 0) == 0;
    const std::string rest =
        deck ? " --to html -o '" + (folder / "out'") : " --to 0.5 -o '" + (folder / "a.mp4'");
    const Ran ran = run_polhode(next + " --size 64x36" + rest);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err.find("warning"), std::string::npos) << ran.err;
  }
}

// a film with --set is the film of the scene that has the value, and its report knows
TEST_F(GoodRun, SettingsAreAsIfInTheFile) {
  const std::string set = " --set motion.spin.body[2]=5 --set 'body.solid.mass_g = 500'";
  ASSERT_EQ(run_polhode("render " + scene() + set + out("set.hash")).code, 0);
  std::string text = test::kSmallScene;
  text.replace(text.find("[1, 0, 3]"), 9, "[1, 0, 5]");
  text.replace(text.find("mass = 1.0"), 10, "mass = 0.5");
  write_text(folder_ / "own.toml", text);
  ASSERT_EQ(run_polhode("render '" + (folder_ / "own.toml") + "'" + out("own.hash")).code, 0);
  EXPECT_EQ(read_text(folder_ / "set.hash"), read_text(folder_ / "own.hash"));
  const std::string report = "'" + (folder_ / "r.json") + "'";
  ASSERT_EQ(run_polhode("render " + scene() + set + out("a.mp4") + " --report " + report).code, 0);
  EXPECT_EQ(run_polhode("verify '" + (folder_ / "a.mp4") + "' --report " + report).code, 0);
  for (const std::string& command :
       {"simulate " + scene() + set + out("a.csv"),
        "inspect " + scene() + set,
        "preview " + scene() + set + out("p.png"),
        "plot " + scene() + " tilt" + set + out("tilt.svg"),
        "chart " + scene() + set + " --methods rk4" + out("chart"),
        "stability " + scene() + set + " --methods rk4 --cells 2x2" + out("map")}) {
    const Ran ran = run_polhode(command);
    EXPECT_EQ(ran.code, 0) << command << ran.err;
    const Ran wrong = run_polhode(command + " --set motion.spin.body[2]=fast");
    EXPECT_EQ(wrong.code, 2) << command;
    EXPECT_NE(wrong.err.find("--set motion.spin.body[2]: must be a number"), std::string::npos)
        << wrong.err;
  }
}

TEST_F(GoodRun, StillIsTheFrameOfTheFilm) {
  ASSERT_EQ(run_polhode("render " + scene() + out("still.png") + " --still 0.5").code, 0);
  ASSERT_EQ(run_polhode("render " + scene() + out("f_%03d.png")).code, 0);
  EXPECT_EQ(read_png(folder_ / "still.png").pixels, read_png(folder_ / "f_005.png").pixels);
  EXPECT_EQ(folder_.entries(), 1 + 1 + 10);
}

TEST_F(GoodRun, TransparentStillKeepsAlpha) {
  ASSERT_EQ(run_polhode("render " + scene() + out("still.png") + " --still 0.5 --transparent").code,
            0);
  EXPECT_EQ(read_png(folder_ / "still.png").at(0, 0)[3], 0);
}

TEST_F(GoodRun, HashesAreTheSameOnBothBackEndsAndTwice) {
  ASSERT_EQ(run_polhode("render " + scene() + out("a.hash") + " --backend osmesa").code, 0);
  ASSERT_EQ(run_polhode("render " + scene() + out("b.hash") + " --backend egl").code, 0);
  EXPECT_EQ(read_text(folder_ / "a.hash"), read_text(folder_ / "b.hash"));
}

// the points of a plot are those of the table of the motion
TEST_F(GoodRun, APlotAsATable) {
  ASSERT_EQ(run_polhode("plot " + scene() + " energy" + out("e.csv")).code, 0);
  const std::string table = read_text(folder_ / "e.csv");
  const Ran ran = run_polhode("simulate " + scene() + " -o - --rate 1");
  std::istringstream rows(ran.out);
  std::string row;
  std::getline(rows, row);
  std::getline(rows, row);
  const std::string energy = row.substr(row.rfind(',') + 1);
  EXPECT_NE(table.find("\ntotal,0," + energy + "\n"), std::string::npos) << energy;
  ASSERT_EQ(run_polhode("plot " + scene() + " polhode_map --at 0.5" + out("map.pdf")).code, 0);
  EXPECT_TRUE(read_text(folder_ / "map.pdf").starts_with("%PDF-"));
  EXPECT_EQ(folder_.entries(), 1 + 2);
}

// more than is kept in memory at once
TEST_F(GoodRun, ALongTableIsWhole) {
  const Ran ran = run_polhode("simulate " + scene() + " -o - --rate 20000");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1 + 20001);
  ASSERT_EQ(run_polhode("simulate " + scene() + out("a.csv") + " --rate 20000").code, 0);
  EXPECT_TRUE(read_text(folder_ / "a.csv") == ran.out);
}

TEST_F(GoodRun, TableOfTheMotion) {
  const Ran ran = run_polhode("simulate " + scene() + " -o - --rate 4");
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::istringstream lines(ran.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "t,qw,qx,qy,qz,wx,wy,wz,Lx,Ly,Lz,x,y,z,energy");
  int rows = 0;
  std::vector<double> first;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    std::vector<double> row;
    while (std::getline(cells, cell, ','))
      row.push_back(std::stod(cell));
    ASSERT_EQ(row.size(), 15u);
    EXPECT_EQ(row[0], rows * 0.25);
    if (rows == 0) first = row;
    // omega in body axes at the start is the scene's; L in space and the energy never change
    if (rows == 0) {
      EXPECT_NEAR(row[5], 1.0, 1e-14);
      EXPECT_NEAR(row[7], 3.0, 1e-14);
    }
    for (const std::size_t i : {8u, 9u, 10u, 14u})
      EXPECT_NEAR(row[i], first[i], 1e-14 * (1 + std::abs(first[i])));
    EXPECT_NEAR(std::hypot(std::hypot(row[1], row[2]), std::hypot(row[3], row[4])), 1.0, 1e-14);
    ++rows;
  }
  EXPECT_EQ(rows, 5);
}

TEST_F(GoodRun, InspectTellsTheBodyAndTheTheory) {
  const Ran ran = run_polhode("inspect " + scene() + " --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto facts = nlohmann::json::parse(ran.out);
  // ellipsoid: m (b^2 + c^2) / 5
  EXPECT_NEAR(facts["mass_kg"].get<double>(), 1.0, 1e-15);
  EXPECT_EQ(facts["center_of_mass_m"].size(), 3u);
  EXPECT_NEAR(facts["tensor_kg_m2"][0][0].get<double>(), 0.010, 1e-16);
  EXPECT_NEAR(facts["principal_moments_kg_m2"][0].get<double>(), 0.004, 1e-16);
  EXPECT_EQ(facts["principal_axes"][0].get<std::vector<double>>(), (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(facts["reference"], "center of mass");
  EXPECT_EQ(facts["kind"], "symmetric prolate");
  EXPECT_EQ(facts["model"], "symmetric");
  EXPECT_FALSE(facts["model_reason"].get<std::string>().empty());
  EXPECT_GT(facts["evaluations_of_ode"].get<long>(), 10);
  const auto& derived = facts["derived"];
  const double momentum = std::hypot(0.010 * 1.0, 0.004 * 3.0);
  EXPECT_NEAR(derived["precession_rate_rad_per_s"].get<double>(), momentum / 0.010, 1e-13);
  EXPECT_NEAR(derived["spin_rate_rad_per_s"].get<double>(), 0.012 * (250.0 - 100.0), 1e-13);

  // the same as text, angles in degrees too
  const Ran text = run_polhode("inspect " + scene());
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("symmetric prolate"), std::string::npos);
  EXPECT_NE(text.out.find(" deg/s)"), std::string::npos);
}

TEST_F(GoodRun, EveryHelpReadsAndEveryListLists) {
  for (const char* arguments : {"--help",
                                "render --help",
                                "simulate --help",
                                "inspect --help",
                                "list --help",
                                "schema --help",
                                "doctor --help",
                                "--version",
                                "list methods",
                                "list models",
                                "list shapes",
                                "list scenes",
                                "list formats",
                                "schema",
                                "doctor",
                                "manual",
                                "manual stability",
                                "completion bash",
                                "completion zsh"}) {
    const Ran ran = run_polhode(arguments);
    EXPECT_EQ(ran.code, 0) << arguments << ran.err;
    EXPECT_GT(ran.out.size(), 4u) << arguments;
    EXPECT_EQ(ran.err, "") << arguments;
  }
}

}  // namespace
}  // namespace polhode
