// SPDX-License-Identifier: MIT
#include "app/compare/golden_update.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/compare/golden_folders.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::GoldenFolder;
using test::reddened;

class UpdateOfACase : public ::testing::Test {
 protected:
  UpdateOfACase() : drawn_(folder_.drawn()) {
    job_.folder = folder_.name();
    job_.progress = ProgressKind::none;
    job_.allow_dirty = true;
    job_.json = true;
  }
  // what is said of the one reference
  std::string update() const {
    const auto json = nlohmann::json::parse(golden_update(job_).text);
    const auto& one = json.at("cases").at(0);
    return fmt::format("{} {}{}",
                       one.at("reference").get<std::string>(),
                       one.at("written") ? "written: " : "",
                       one.at("what").get<std::string>());
  }
  Image reference(const std::string& name = "top.png") const { return read_png(folder_ / name); }
  GoldenSidecar sidecar(const std::string& name = "top.png") const {
    return load_golden_sidecar(folder_ / (name + ".toml"));
  }

  // what stands beside a reference since before the thresholds of its case were changed
  GoldenSidecar old_sidecar() const {
    GoldenSidecar old = drawn_.sidecar;
    old.verdict.reason = "old";
    return old;
  }

  GoldenFolder folder_;
  DrawnCase drawn_;
  GoldenJob job_;
};

TEST_F(UpdateOfACase, WritesAReferenceThatIsMissing) {
  EXPECT_EQ(update(), "top.png written: new");
  EXPECT_EQ(reference().pixels, drawn_.image.pixels);
  EXPECT_EQ(sidecar().cause, "");
  EXPECT_EQ(sidecar().renderer, drawn_.sidecar.renderer);
  EXPECT_EQ(sidecar().verdict.reason, "ours");
  EXPECT_EQ(update(), "top.png unchanged");
}

TEST_F(UpdateOfACase, KeepsWhatIsWithinItsThresholdsUnlessAllAreAskedFor) {
  update();
  const Image noisy = reddened(drawn_.image, 2);
  folder_.accept("top.png", noisy);
  EXPECT_EQ(update(),
            "top.png kept: the same within its thresholds (largest 2, 0% of the pixels over 3 "
            "levels)");
  EXPECT_EQ(reference().pixels, noisy.pixels);
  job_.all = true;
  EXPECT_EQ(update(), "top.png written: changed: largest 2, 0% of the pixels over 3 levels");
  EXPECT_EQ(reference().pixels, drawn_.image.pixels);
}

TEST_F(UpdateOfACase, WritesWhatIsDifferent) {
  update();
  folder_.accept("top.png", reddened(drawn_.image, 30));
  EXPECT_EQ(update(), "top.png written: changed: largest 30, 100% of the pixels over 3 levels");
  EXPECT_EQ(reference().pixels, drawn_.image.pixels);
  folder_.accept("top.png", Image(32, 24));
  EXPECT_EQ(update(), "top.png written: changed: was 32x24 pixels, is 64x48");
  EXPECT_EQ(reference().pixels, drawn_.image.pixels);
}

// the picture is that of the machine that its sidecar names
TEST_F(UpdateOfACase, NewThresholdsReachTheSidecarAlone) {
  GoldenSidecar old = old_sidecar();
  old.renderer = "another machine";
  const Image noisy = reddened(drawn_.image, 2);
  folder_.accept("top.png", noisy, old);
  EXPECT_NE(update().find("; thresholds written"), std::string::npos);
  EXPECT_EQ(reference().pixels, noisy.pixels);
  EXPECT_EQ(sidecar().renderer, "another machine");
  EXPECT_EQ(sidecar().verdict.reason, "ours");
}

TEST_F(UpdateOfACase, NewThresholdsReachReferencesOfOtherCauses) {
  GoldenSidecar old = old_sidecar();
  old.cause = "mesa-25";
  const Image noisy = reddened(drawn_.image, 2);
  folder_.accept("top.mesa-25.png", noisy, old);
  EXPECT_EQ(update(),
            "top.png kept: matches top.mesa-25.png; thresholds of top.mesa-25.png written");
  EXPECT_EQ(sidecar("top.mesa-25.png").verdict.reason, "ours");
  EXPECT_EQ(sidecar("top.mesa-25.png").cause, "mesa-25");
  EXPECT_EQ(reference("top.mesa-25.png").pixels, noisy.pixels);
  EXPECT_EQ(update(), "top.png kept: matches top.mesa-25.png");
}

TEST_F(UpdateOfACase, IsJudgedByTheNewThresholds) {
  GoldenSidecar old = old_sidecar();
  old.verdict.thresholds.max = 40;
  folder_.accept("top.png", reddened(drawn_.image, 30), old);
  job_.cause = "mesa-25";
  EXPECT_EQ(update(), "top.mesa-25.png written: new; thresholds of top.png written");
  EXPECT_EQ(sidecar().verdict.reason, "ours");
  EXPECT_EQ(update(), "top.mesa-25.png unchanged");
  // also of the one that does not match, where another does
  folder_.accept("top.png", reddened(drawn_.image, 30), old);
  job_.cause = "";
  EXPECT_EQ(update(), "top.png kept: matches top.mesa-25.png; thresholds of top.png written");
  EXPECT_EQ(sidecar().verdict.reason, "ours");
}

TEST_F(UpdateOfACase, ACauseAddsASecondReferenceWhereTheFirstDoesNotMatch) {
  update();
  job_.cause = "mesa-25";
  EXPECT_EQ(update(), "top.mesa-25.png kept: matches top.png");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "top.mesa-25.png"));
  const Image other = reddened(drawn_.image, 30);
  folder_.accept("top.png", other);
  EXPECT_EQ(update(), "top.mesa-25.png written: new");
  EXPECT_EQ(reference("top.mesa-25.png").pixels, drawn_.image.pixels);
  EXPECT_EQ(sidecar("top.mesa-25.png").cause, "mesa-25");
  EXPECT_EQ(reference().pixels, other.pixels) << "the first one stays";
  job_.cause = "";
  EXPECT_EQ(update(), "top.png kept: matches top.mesa-25.png");
  job_.cause = "../../x";
  test::expect_input_error([&] { golden_update(job_); }, "--cause", "such as mesa-25");
}

TEST_F(UpdateOfACase, NothingIsWrittenWhenACaseCannotBeDrawn) {
  folder_.write_cases(
      "name = \"top\"\nscene = \"top.toml\"\n[[case]]\nname = \"bad\"\nscene = \"none.toml\"\n");
  test::expect_input_error([&] { golden_update(job_); }, "", "nothing was updated: ");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "top.png"));
}

TEST_F(UpdateOfACase, CountsWhatItHasWritten) {
  job_.json = false;
  EXPECT_NE(golden_update(job_).text.find("1 of 1 references written\n"), std::string::npos);
  EXPECT_NE(golden_update(job_).text.find("0 of 1 references written\n"), std::string::npos);
}

// an update must be reviewed by itself
TEST_F(UpdateOfACase, ReferencesOfTwoCasesAreTwoFiles) {
  update();
  test::write_text(folder_ / "cases.toml",
                   test::read_text(folder_ / "cases.toml") +
                       "[[case]]\nname = \"second\"\nscene = \"top.toml\"\n");
  std::filesystem::create_symlink("top.png", folder_ / "second.png");
  test::expect_input_error([&] { update(); }, "", "is that of 'top' by a link");
}

TEST_F(UpdateOfACase, ATreeWithChangesIsRefused) {
  job_.allow_dirty = false;
  test::expect_input_error([&] { golden_update(job_); }, "", "git does not track this folder");
  const std::string git =
      fmt::format("git -C '{}' -c user.name=t -c user.email=t@example.org ", folder_.name());
  ASSERT_EQ(std::system((git + "init -q").c_str()), 0);
  test::expect_input_error([&] { golden_update(job_); }, "", "and others");
  ASSERT_EQ(std::system((git + "add . && " + git + "commit -q -m all").c_str()), 0);
  EXPECT_EQ(update(), "top.png written: new");
  test::expect_input_error([&] { golden_update(job_); }, "", "top.png");
  // what git ignores cannot be brought back
  std::ofstream(folder_ / ".gitignore") << "*.png\n";
  ASSERT_EQ(std::system((git + "add . && " + git + "commit -q -m ignore").c_str()), 0);
  test::expect_input_error([&] { golden_update(job_); }, "", "git ignores this file");
  ASSERT_EQ(std::system((git + "add -f top.png && " + git + "commit -q -m picture").c_str()), 0);
  EXPECT_EQ(update(), "top.png unchanged");
}

}  // namespace
}  // namespace polhode
