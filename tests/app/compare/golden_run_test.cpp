// SPDX-License-Identifier: MIT
#include "app/compare/golden_run.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "app/compare/golden_folders.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::GoldenFolder;

class RunOfACase : public ::testing::Test {
 protected:
  RunOfACase() {
    job_.folder = folder_.name();
    job_.output = pictures_.path().string();
    job_.progress = ProgressKind::none;
  }

  GoldenFolder folder_;
  test::TemporaryFolder pictures_;
  GoldenJob job_;
};

// pictures of failures are for a person to look at, and go when the case passes
TEST_F(RunOfACase, LeavesPicturesOfWhatIsDifferent) {
  const Image image = folder_.drawn().image;
  folder_.accept("top.png", test::reddened(image, 100));
  const GoldenResult different = golden_run(job_);
  EXPECT_EQ(different.exit_code, 1);
  EXPECT_NE(
      different.text.find("1 of 1 cases failed; pictures of what differs are in " + job_.output),
      std::string::npos)
      << different.text;
  EXPECT_EQ(read_png(pictures_ / "top.actual.png").pixels, image.pixels);
  EXPECT_EQ(pictures_.entries(), 2);

  folder_.accept("top.png", image);
  EXPECT_EQ(golden_run(job_).exit_code, 0);
  EXPECT_EQ(pictures_.entries(), 0);
}

// they would pass for references in the next run
TEST_F(RunOfACase, LeavesNoneAmongTheReferences) {
  for (const std::string& output :
       {folder_.name(),
        folder_.name() + "/../" + std::filesystem::path(folder_.name()).filename().string()}) {
    job_.output = output;
    test::expect_input_error(
        [&] { golden_run(job_); }, "--output", "is the folder of the references");
  }
}

TEST_F(RunOfACase, PromisesNoPicturesWhereNothingWasDrawn) {
  folder_.write_cases("name = \"top\"\nscene = \"none.toml\"\nstill = 0.5\n");
  const GoldenResult result = golden_run(job_);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.text.find("pictures are in"), std::string::npos) << result.text;
}

}  // namespace
}  // namespace polhode
