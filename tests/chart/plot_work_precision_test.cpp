// SPDX-License-Identifier: MIT
// GCC 12 sees members without a value where the whole struct is written by its initializer
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "chart/plot_work_precision.h"

#include <cmath>

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

}  // namespace
}  // namespace polhode::test
