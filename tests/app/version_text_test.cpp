// SPDX-License-Identifier: MIT
#include "app/version_text.h"

#include <gtest/gtest.h>

#include "base/version.h"
#include "video/film_sink.h"

namespace polhode {
namespace {

TEST(VersionText, NamesTheProgramAndItsCommit) {
  EXPECT_EQ(version_text("1a2b3c").rfind("polhode " + program_version() + " (commit 1a2b3c)\n", 0),
            0U);
  EXPECT_EQ(version_text("").rfind("polhode " + program_version() + "\n", 0), 0U);
}

// each with what it was compiled with and what it has found
TEST(VersionText, NamesCompilerAndLibraries) {
  const std::string text = version_text("");
  for (const std::string& words :
       {std::string(__VERSION__), std::string("FFmpeg " + libav_version()), std::string("Eigen")})
    EXPECT_NE(text.find(words), std::string::npos) << words << " in " << text;
}

}  // namespace
}  // namespace polhode
