// SPDX-License-Identifier: MIT
#include "app/compare/golden_results.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/compare/golden_folders.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::GoldenFolder;
using test::reddened;

// the folder's one case, drawn and judged
class ResultOfACase : public ::testing::Test {
 protected:
  ResultOfACase() : drawn_(folder_.drawn()) {
    job_.folder = folder_.name();
    job_.progress = ProgressKind::none;
  }
  const CaseResult& result() {
    cases_ = load_cases(folder_.name(), "");
    results_ = draw_cases(job_, cases_);
    return results_.at(0);
  }

  GoldenFolder folder_;
  DrawnCase drawn_;
  GoldenJob job_;
  std::vector<LoadedCase> cases_;
  std::vector<CaseResult> results_;
};

TEST_F(ResultOfACase, WithoutAReferenceSaysHowToMakeOne) {
  const CaseResult& one = result();
  EXPECT_EQ(one.outcome(), "no reference");
  EXPECT_NE(one.reason().find("golden update"), std::string::npos);
  ASSERT_TRUE(one.drawn);
  EXPECT_EQ(one.drawn->image.pixels, drawn_.image.pixels);
}

TEST_F(ResultOfACase, IsTheSameWithinItsRule) {
  folder_.accept("top.png", reddened(drawn_.image, 3));
  EXPECT_EQ(result().outcome(), "same");
  EXPECT_EQ(result().reason(), "");
  EXPECT_EQ(result().verdict->values.largest, 3);
  folder_.accept("top.png", reddened(drawn_.image, 4));
  EXPECT_EQ(result().outcome(), "different");
  EXPECT_NE(result().reason(), "");
  EXPECT_EQ(result().reference.pixels, reddened(drawn_.image, 4).pixels);
}

TEST_F(ResultOfACase, TheSidecarsRuleGoesBeforeTheCases) {
  GoldenSidecar sidecar;
  sidecar.verdict.thresholds.max = 4;
  sidecar.verdict.reason = "another machine";
  folder_.accept("top.png", reddened(drawn_.image, 4), sidecar);
  EXPECT_EQ(result().outcome(), "same");
  EXPECT_EQ(result().rule.reason, "another machine");
}

// the second is nearer to what is drawn, the third as near as it
TEST_F(ResultOfACase, TheMostAlikeReferenceCounts) {
  folder_.accept("top.png", reddened(drawn_.image, 40));
  folder_.accept("top.arm.png", drawn_.image);
  folder_.accept("top.mips.png", drawn_.image);
  const CaseResult& one = result();
  EXPECT_EQ(one.outcome(), "same");
  ASSERT_NE(one.best, nullptr);
  EXPECT_EQ(one.best->cause, "arm");
}

TEST_F(ResultOfACase, AReferenceOfAnotherSizeIsNamedUnlessAnotherFits) {
  folder_.accept("top.png", Image(32, 24));
  EXPECT_EQ(result().outcome(), "different");
  EXPECT_EQ(result().reason(), "the reference is 32x24 pixels, the picture 64x48");
  folder_.accept("top.arm.png", drawn_.image);
  EXPECT_EQ(result().outcome(), "same");
  EXPECT_EQ(result().best->cause, "arm");
}

// one bad case does not hide the others
TEST_F(ResultOfACase, ThatCannotBeDrawnIsItsError) {
  folder_.write_cases(
      "name = \"bad\"\nscene = \"none.toml\"\n[[case]]\nname = \"top\"\nscene = \"top.toml\"\n"
      "size = \"64x48\"\nstill = 0.5\n");
  folder_.accept("top.png", drawn_.image);
  EXPECT_EQ(result().outcome(), "error");
  EXPECT_NE(result().reason().find("none.toml"), std::string::npos);
  EXPECT_EQ(results_.at(1).outcome(), "same");
}

// after a reference that the picture matches
TEST_F(ResultOfACase, AnUnreadableReferenceIsItsError) {
  folder_.accept("top.png", drawn_.image);
  test::write_text(folder_ / "top.arm.png", "no picture");
  const CaseResult& one = result();
  EXPECT_EQ(one.outcome(), "error");
  EXPECT_FALSE(one.same());
  EXPECT_FALSE(one.verdict);
  EXPECT_NE(one.reason().find("top.arm.png"), std::string::npos);
}

TEST_F(ResultOfACase, AWrongBackEndIsTheUsersErrorNotTheCases) {
  job_.backend = "osmsea";
  test::expect_input_error([&] { result(); }, "--backend", "did you mean 'osmesa'?");
}

TEST(SameRule, EveryNumberAndTheReasonCount) {
  const GoldenVerdict rule{{1, 0.5, 2, 0.9, 0.1}, "why"};
  EXPECT_TRUE(same_rule(rule, rule));
  for (const GoldenVerdict& other : {GoldenVerdict{{2, 0.5, 2, 0.9, 0.1}, "why"},
                                     {{1, 0.6, 2, 0.9, 0.1}, "why"},
                                     {{1, 0.5, 3, 0.9, 0.1}, "why"},
                                     {{1, 0.5, 2, {}, 0.1}, "why"},
                                     {{1, 0.5, 2, 0.9, 0.2}, "why"},
                                     {{1, 0.5, 2, 0.9, 0.1}, "why not"}})
    EXPECT_FALSE(same_rule(rule, other));
}

TEST(JsonText, TakesNamesThatAreNoUtf8) {
  const std::string text = json_text({{"name", "a\xFF"}});
  EXPECT_EQ(nlohmann::json::parse(text).at("name"), "a\uFFFD");
  EXPECT_EQ(text.back(), '\n');
}

}  // namespace
}  // namespace polhode
