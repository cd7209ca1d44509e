// SPDX-License-Identifier: MIT
#include "app/compare/golden_cases.h"

#include <gtest/gtest.h>

#include "app/compare/golden_folders.h"
#include "base/version.h"
#include "support/expect_error.h"
#include "support/in_child.h"

namespace polhode {
namespace {

using test::GoldenFolder;

TEST(GoldenCases, NamesOfReferencesTellCaseAndCause) {
  EXPECT_EQ(reference_file("g", "top", ""), "g/top.png");
  EXPECT_EQ(reference_file("g", "top", "mesa-25"), "g/top.mesa-25.png");
  EXPECT_EQ(sidecar_file("g/top.mesa-25.png"), "g/top.mesa-25.png.toml");
}

TEST(GoldenCases, AreLoadedWithTheirReferencesTheFirstOneFirst) {
  const GoldenFolder folder;
  EXPECT_TRUE(folder.only_case().references.empty());
  GoldenSidecar sidecar;
  sidecar.cause = "arm";
  sidecar.verdict.thresholds.max = 9;
  folder.accept("top.arm.png", Image(4, 4), sidecar);
  folder.accept("top.png", Image(4, 4));
  // of other cases, of no cause, and a picture that a failed run has left
  for (const char* other : {"top2.png", "stop.png", "top.a b.png", "top..png", "top.png.bak"})
    test::write_text(folder / other, "");
  const LoadedCase one = folder.only_case();
  ASSERT_EQ(one.references.size(), 2U);
  EXPECT_EQ(one.references[0].cause, "");
  EXPECT_EQ(one.references[0].file, folder / "top.png");
  EXPECT_FALSE(one.references[0].has_sidecar);
  EXPECT_EQ(one.references[1].cause, "arm");
  EXPECT_TRUE(one.references[1].has_sidecar);
  EXPECT_EQ(one.references[1].sidecar.verdict.thresholds.max, 9);
}

TEST(GoldenCases, HaveTheRuleOfTheFolderOrTheirOwn) {
  EXPECT_EQ(GoldenFolder().only_case().verdict.thresholds.max, 3);
  EXPECT_EQ(GoldenFolder().only_case().verdict.reason, "ours");
  const GoldenFolder own("verdict = { max = 8, reason = \"thin lines\" }\n");
  EXPECT_EQ(own.only_case().verdict.thresholds.max, 8);
  EXPECT_EQ(own.only_case().verdict.reason, "thin lines");
}

// a folder in which nobody may look around, and a sidecar that leads nowhere
TEST(GoldenCases, WhatCannotBeReadIsNamed) {
  const GoldenFolder folder;
  std::filesystem::permissions(folder.name(), std::filesystem::perms{0311});
  EXPECT_EQ(test::exit_code_in_child([&] {
              static_cast<void>(!setuid(65534));  // root may read everything
              try {
                load_cases(folder.name(), "");
              } catch (const Error& error) {
                return error.fault() == Fault::input && error.place().file == folder.name() ? 0 : 1;
              }
              return 2;
            }),
            0);
  std::filesystem::permissions(folder.name(), std::filesystem::perms::owner_all);
  folder.accept("top.png", Image(4, 4));
  std::filesystem::create_symlink("top.png.toml", folder / "top.png.toml");
  test::expect_input_error([&] { folder.only_case(); }, "", "cannot be looked at");
}

TEST(GoldenCases, CanBeChosenByName) {
  const GoldenFolder folder(
      "[[case]]\nname = \"plane\"\nscene = \"top.toml\"\n[[case]]\nname = \"cone\"\nscene = "
      "\"top.toml\"\n");
  EXPECT_EQ(load_cases(folder.name(), "").size(), 3U);
  const std::vector<LoadedCase> two = load_cases(folder.name(), "cone,top");
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].spec.name, "top") << "in the order of the file";
  EXPECT_EQ(two[1].spec.name, "cone");
  test::expect_input_error(
      [&] { load_cases(folder.name(), "top,plan"); }, "--cases", "did you mean 'plane'?");
}

TEST(GoldenCases, AFolderWithoutAListIsRefused) {
  const test::TemporaryFolder empty;
  test::expect_input_error([&] { load_cases(empty.path(), ""); }, "", "has no cases.toml");
  test::expect_input_error(
      [&] { load_cases(empty / "none", ""); }, "", "the folder does not exist");
  test::write_text(empty / "file", "");
  test::expect_input_error([&] { load_cases(empty / "file", ""); }, "", "is no folder");
}

// as `render --still` draws it, and what it was drawn with
TEST(GoldenCases, AreDrawnAsTheirListSays) {
  const GoldenFolder folder("text = true\n");
  const DrawnCase drawn = folder.drawn();
  EXPECT_EQ(drawn.image.width, 64);
  EXPECT_EQ(drawn.image.height, 48);
  EXPECT_EQ(drawn.image.at(0, 0)[3], 255);
  EXPECT_EQ(drawn.sidecar.polhode, program_version());
  EXPECT_FALSE(drawn.sidecar.backend.empty());
  EXPECT_FALSE(drawn.sidecar.cpu_vendor.empty());
  EXPECT_GT(drawn.sidecar.samples, 0);
  const std::size_t llvm = drawn.sidecar.renderer.find("LLVM ");
  if (llvm != std::string::npos) {
    EXPECT_EQ(
        drawn.sidecar.renderer.compare(llvm + 5, drawn.sidecar.llvm.size(), drawn.sidecar.llvm), 0);
    EXPECT_EQ(drawn.sidecar.llvm.find_first_not_of("0123456789."), std::string::npos);
    EXPECT_FALSE(drawn.sidecar.llvm.empty());
  }
  const GoldenFolder plain("");
  EXPECT_NE(plain.drawn().image.pixels, drawn.image.pixels) << "the words are not there";
  const GoldenFolder clear("transparent = true\n");
  EXPECT_EQ(clear.drawn().image.at(0, 0)[3], 0);
}

}  // namespace
}  // namespace polhode
