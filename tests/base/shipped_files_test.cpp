// SPDX-License-Identifier: MIT
#include "base/shipped_files.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "base/system/child_process.h"
#include "support/run.h"

namespace polhode::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTell = "POLHODE_TEST_TELLS_SHIPPED_FILES";

// what a copy of this program at `binary` finds
fs::path found_from(const fs::path& binary) {
  // all of it, also where this program runs a share of the tests
  const ChildResult told = run_child({"env",
                                      "-u",
                                      "GTEST_TOTAL_SHARDS",
                                      "-u",
                                      "GTEST_SHARD_INDEX",
                                      std::string(kTell) + "=1",
                                      binary.string(),
                                      "--gtest_filter=ShippedFiles.*"},
                                     "");
  const std::size_t begin = told.out.find('<'), end = told.out.find('>');
  return begin == std::string::npos ? "" : told.out.substr(begin + 1, end - begin - 1);
}

TEST(ShippedFiles, AreFoundFromWhereTheProgramIs) {
  if (std::getenv(kTell) != nullptr) {
    std::printf("<%s>\n", shipped_files().c_str());
    return;
  }
  const TemporaryFolder prefix;
  fs::create_directories(prefix.path() / "bin");
  const fs::path binary = prefix.path() / "bin" / "program";
  fs::copy_file("/proc/self/exe", binary);

  // neither is there, the one of a build folder, and the installed one, which comes first
  EXPECT_EQ(found_from(binary), prefix.path() / "share/polhode");
  fs::create_directories(prefix.path() / "bin/share/polhode");
  EXPECT_EQ(found_from(binary), prefix.path() / "bin/share/polhode");
  fs::create_directories(prefix.path() / "share/polhode");
  EXPECT_EQ(found_from(binary), prefix.path() / "share/polhode");
}

TEST(ShippedScenes, AreTheChosenFolderElseShipped) {
  setenv("POLHODE_SCENES", "/some/where", 1);
  EXPECT_EQ(shipped_scenes(), "/some/where");
  setenv("POLHODE_SCENES", "", 1);
  EXPECT_EQ(shipped_scenes(), shipped_files() / "scenes");
  unsetenv("POLHODE_SCENES");
  EXPECT_EQ(shipped_scenes(), shipped_files() / "scenes");
}

}  // namespace
}  // namespace polhode::test
