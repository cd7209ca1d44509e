// SPDX-License-Identifier: MIT
#include "base/version.h"

#include <gtest/gtest.h>

#include "support/run.h"

namespace polhode {
namespace {

// the changelog is the other place where people look for it
TEST(Version, IsTheOneOfTheBuildFileAndOfTheChangelog) {
  const std::string build = test::read_text(POLHODE_SOURCE_DIR "/CMakeLists.txt");
  EXPECT_NE(build.find("VERSION " + program_version()), std::string::npos) << program_version();
  const std::string changes = test::read_text(POLHODE_SOURCE_DIR "/CHANGELOG.md");
  EXPECT_NE(changes.find(program_version()), std::string::npos) << program_version();
}

TEST(Version, IsThreeNumbers) {
  int major = -1, minor = -1, patch = -1, read = 0;
  const std::string version = program_version();
  ASSERT_EQ(std::sscanf(version.c_str(), "%d.%d.%d%n", &major, &minor, &patch, &read), 3);
  EXPECT_EQ(static_cast<std::size_t>(read), version.size()) << version;
}

}  // namespace
}  // namespace polhode
