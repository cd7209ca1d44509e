// SPDX-License-Identifier: MIT
// GCC 12 sees members without a value where the whole struct is written by its initializer
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "chart/plot_work_precision.h"

#include <cmath>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "chart/work_points.h"

namespace polhode::test {
namespace {

TEST(PlotWorkPrecision, TableHasTheContractsColumns) {
  WorkPanel panel;
  panel.scene = "with, comma";
  panel.points = {drawn("rk4", 5.0, 1e-3, kPointOk), drawn("rk4", 5.0, NAN, "no_solution")};
  const std::string csv = work_precision_csv({panel});
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "scene,method,order,step,evaluations,time_us,error_rad,energy_drift,momentum_drift,"
            "status");
  EXPECT_NE(csv.find("\"with, comma\",rk4,0,0,10,5,0.001,0,0,ok\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",nan,0,0,no_solution\n"), std::string::npos) << csv;
}

// names of methods, the title and the reference are in the picture; a panel without points is drawn
// too
TEST(PlotWorkPrecision, PictureNamesWhatItShows) {
  WorkPanel full, empty;
  full.title = "A title";
  full.reference = "closed form";
  full.accuracy_rad = 1e-4;
  full.accuracy_why = "0.1 px";
  full.points = {drawn("rk4", 5.0, 1e-3, kPointOk), drawn("rk4", 50.0, 1e-7, kPointOk)};
  empty.title = "Empty one";
  empty.reference = "nobody";
  const std::string svg = plot_work_precision({full, empty}, PlotFormat::svg);
  for (const char* words : {"A title", "closed form", "rk4", "0.1 px", "Empty one", "nobody"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
}

// colour and mark tell any two methods apart
TEST(PlotWorkPrecision, EachMethodHasItsOwnLook) {
  WorkPanel panel;
  panel.title = "All";
  panel.reference = "nobody";
  panel.accuracy_rad = 1e-4;
  for (const StepperInfo& row : stepper_table())
    panel.points.push_back(drawn(row.name.c_str(), 5.0, 1e-3, kPointOk));
  const std::set<std::string> looks = [&] {
    std::set<std::string> found;
    const std::string script = work_precision_script({panel});
    const std::regex look("with linespoints (linecolor rgb '#[0-9A-F]+' pointtype [0-9]+)");
    for (std::sregex_iterator at(script.begin(), script.end(), look), end; at != end; ++at)
      found.insert((*at)[1]);
    return found;
  }();
  EXPECT_EQ(looks.size(), stepper_table().size());
}

// no point shows that a splitting has no error on a free body; words do
TEST(PlotWorkPrecision, TellsWhichMethodsAreExact) {
  WorkPanel panel;
  panel.title = "A book";
  panel.reference = "closed form";
  panel.accuracy_rad = 1e-4;
  panel.points = {drawn("rk4", 5.0, 1e-3, kPointOk)};
  const auto says_so = [&] {
    return work_precision_script({panel}).find("kicks: exact on a free body") != std::string::npos;
  };
  panel.free_body = true;
  EXPECT_FALSE(says_so());
  panel.points.push_back(drawn("kick_strang", 1.0, 1e-10, kPointOk));
  EXPECT_TRUE(says_so());
  panel.free_body = false;
  EXPECT_FALSE(says_so());
}

}  // namespace
}  // namespace polhode::test
