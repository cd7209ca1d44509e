// SPDX-License-Identifier: MIT
#include "film/report/motion_report.h"

#include <gtest/gtest.h>

#include "base/version.h"

namespace polhode {
namespace {

SimulationReport some_report() {
  SimulationReport report;
  report.model = "ode";
  report.model_reason = "there is gravity";
  report.method = "dop853";
  report.method_reason = "asked for";
  report.tolerance = 1e-9;
  report.accuracy_rad = 0.001;
  report.record.steps = 120;
  report.record.rejected = 7;
  report.record.evaluations = 1524;
  report.record.drift.energy = -3e-12;
  return report;
}

TEST(MotionReport, HasEveryKeyAndNullForWhatIsNotKnown) {
  const Json json = json_of(some_report());
  EXPECT_EQ(json.at("model"), "ode");
  EXPECT_EQ(json.at("model_reason"), "there is gravity");
  EXPECT_EQ(json.at("method"), "dop853");
  EXPECT_EQ(json.at("method_reason"), "asked for");
  EXPECT_EQ(json.at("tolerance"), 1e-9);
  EXPECT_EQ(json.at("steps"), 120);
  EXPECT_EQ(json.at("rejected_steps"), 7);
  EXPECT_EQ(json.at("evaluations"), 1524);
  EXPECT_EQ(json.at("accuracy_rad"), 0.001);
  EXPECT_EQ(json.at("energy_drift"), -3e-12);
  for (const char* key : {"step_s", "error_estimate_rad", "attitude_error_rad", "momentum_drift"})
    EXPECT_TRUE(json.at(key).is_null()) << key;
  EXPECT_EQ(json.at("doubts"), Json::array());
  EXPECT_EQ(json.size(), 16U);
}

TEST(MotionReport, IsTrustedUntilThereIsADoubt) {
  SimulationReport report = some_report();
  EXPECT_EQ(json_of(report).at("trusted"), true);
  report.reliability.doubts = {"energy is not kept"};
  EXPECT_EQ(json_of(report).at("trusted"), false);
  EXPECT_EQ(json_of(report).at("doubts").at(0), "energy is not kept");
}

TEST(MotionReport, IsReadBackAsItWasWritten) {
  SimulationReport report = some_report();
  report.step = 0.25;
  report.error_estimate_rad = 1e-5;
  report.reliability.doubts = {"one", "two"};
  const Json json = json_of(report);
  SimulationReport read;
  read.tolerance = 9.0;
  read_json(json, read);
  EXPECT_EQ(json_of(read), json);
  EXPECT_EQ(read.record.steps, 120);
  EXPECT_EQ(read.tolerance, 1e-9);
  Json without = json;
  without.erase("method");
  EXPECT_THROW(read_json(without, read), Json::exception);
}

// whose change changes pixels or bytes
TEST(Versions, NameTheProgramItsCompilerAndItsLibraries) {
  const Json all = versions();
  EXPECT_EQ(all.at("polhode"), program_version());
  EXPECT_EQ(all.at("compiler"), __VERSION__);
  int world = 0, major = 0, minor = 0;
  const std::string eigen = all.at("eigen");
  EXPECT_EQ(std::sscanf(eigen.c_str(), "%d.%d.%d", &world, &major, &minor), 3) << eigen;
  EXPECT_EQ(all.at("ffmpeg").get<std::string>().find_first_of("0123456789"), 0U) << all.dump();
  EXPECT_EQ(all.size(), 4U);
}

}  // namespace
}  // namespace polhode
