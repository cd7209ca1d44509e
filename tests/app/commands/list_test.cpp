// SPDX-License-Identifier: MIT
#include "app/commands/list.h"

#include <cstdlib>
#include <sstream>

#include <gtest/gtest.h>

#include "app/commands/new_scene.h"
#include "frame/elements.h"
#include "model/loads.h"
#include "model/solids.h"
#include "motion/diagram.h"
#include "motion/solution_method.h"
#include "motion/stepper_table.h"
#include "support/expect_error.h"
#include "support/in_child.h"
#include "support/run.h"
#include "support/scenes.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

std::vector<std::string> lines_of(const std::string& name) {
  std::istringstream text(list_table(name));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);)
    lines.push_back(line);
  return lines;
}

// the line that begins with the name
std::string line_of(const std::string& table, const std::string& name) {
  for (const std::string& line : lines_of(table)) {
    if (line.rfind(name + " ", 0) == 0) return line;
  }
  return "";
}

// a heading, and a line for each row of the table that the program works with
TEST(List, TablesHaveALineForEachRow) {
  EXPECT_EQ(lines_of("methods").size(), stepper_table().size() + 1);
  EXPECT_EQ(lines_of("models").size(), solution_methods().size() + 1);
  EXPECT_EQ(lines_of("shapes").size(), solid_kinds().size() + 1);
  EXPECT_EQ(lines_of("formats").size(), sink_kinds().size() + 1);
  EXPECT_EQ(lines_of("torques").size(), load_kinds().size() + 1);
  EXPECT_EQ(lines_of("elements").size(), elements().size() + 1);
  EXPECT_EQ(lines_of("plots").size(), plot_names().size() + 1);
  EXPECT_EQ(lines_of("starts").size(), new_kinds().size() + 1);
  for (const std::string& name : list_names())
    EXPECT_GT(lines_of(name).size(), 1U) << name;
}

TEST(List, MethodsSayWhatTheyKeepAndTake) {
  const std::string rk4 = line_of("methods", "rk4");
  EXPECT_NE(rk4.find(" 4      fixed     -  "), std::string::npos) << rk4;
  EXPECT_NE(rk4.find("free heavy loads rotators"), std::string::npos) << rk4;
  EXPECT_NE(rk4.find("h < 2 sqrt 2 / rate of L in the body"), std::string::npos) << rk4;
  const std::string dmv = line_of("methods", "dmv2");
  EXPECT_NE(dmv.find("energy |L| L symplectic reversible  free  "), std::string::npos) << dmv;
  const std::string gauss = line_of("methods", "gauss6");
  EXPECT_NE(gauss.find("energy |L| reversible  "), std::string::npos) << gauss;
  EXPECT_NE(line_of("methods", "dop853").find("adaptive"), std::string::npos);
  EXPECT_NE(line_of("methods", "dop853").find("free heavy loads tables"), std::string::npos);
  const std::string euler = line_of("methods", "table_euler");
  EXPECT_NE(euler.find("  tables rotators  "), std::string::npos) << euler;
}

TEST(List, ShapesAndFormatsSayWhatTheyNeedAndCan) {
  const std::string ellipsoid = line_of("shapes", "ellipsoid");
  EXPECT_NE(ellipsoid.find("semi_axes"), std::string::npos) << ellipsoid;
  EXPECT_NE(line_of("formats", "mp4").find(" no "), std::string::npos);
  EXPECT_NE(line_of("formats", "webm").find(" yes "), std::string::npos);
}

TEST(List, TorquesSayTheirKeys) {
  const std::string damping = line_of("torques", "damping");
  EXPECT_NE(damping.find(" c "), std::string::npos) << damping;
  EXPECT_NE(damping.find("of about from until ramp"), std::string::npos) << damping;
  EXPECT_NE(line_of("torques", "constant").find("space|body"), std::string::npos);
  EXPECT_NE(line_of("plots", "tilt").find("time"), std::string::npos);
  EXPECT_NE(line_of("plots", "satellite_map").find("satellite"), std::string::npos);
}

TEST(List, UnknownTablesNameTheNearest) {
  test::expect_input_error([] { list_table("method"); }, "", "did you mean 'methods'?");
}

// those of a folder that is named, in order, with their titles; else of the folder here
TEST(List, ScenesAreThoseOfTheFolder) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "scenes");
  test::write_text(folder / "scenes/b.toml", test::kSmallScene);
  test::write_text(folder / "scenes/a.toml", test::kSmallScene);
  test::write_text(folder / "scenes/notes.md", "no scene");
  const auto listed = [&](const char* named) {
    return test::exit_code_in_child([&] {
      std::filesystem::current_path(folder.path());
      unsetenv("POLHODE_SCENES");
      if (named != nullptr) setenv("POLHODE_SCENES", named, 1);
      try {
        const std::string table = list_table("scenes");
        if (table == "file           title\nscenes/a.toml  test\nscenes/b.toml  test\n") return 1;
        if (table.find("/scenes/heavy_top.toml") != std::string::npos) return 2;
        return 3;
      } catch (const Error& error) {
        return error.fault() == Fault::input ? 4 : 5;
      }
    });
  };
  EXPECT_EQ(listed(nullptr), 1);
  EXPECT_EQ(listed("scenes"), 1);
  EXPECT_EQ(listed(POLHODE_SOURCE_DIR "/scenes"), 2);
  EXPECT_EQ(listed("nowhere"), 4);
}

}  // namespace
}  // namespace polhode
