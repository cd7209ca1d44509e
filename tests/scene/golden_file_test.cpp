// SPDX-License-Identifier: MIT
#include "scene/golden_file.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

GoldenSidecar some_sidecar() {
  GoldenSidecar sidecar;
  sidecar.cause = "a \"quoted\" \\ cause\nof two lines ü";
  sidecar.polhode = "1.2.3";
  sidecar.backend = "osmesa";
  sidecar.renderer = "llvmpipe";
  sidecar.samples = 4;
  sidecar.verdict.thresholds.max = 5;
  sidecar.verdict.thresholds.fraction = 1.0 / 3.0;
  sidecar.verdict.thresholds.flip = 0.1;
  sidecar.verdict.reason = "\t#[verdict]";
  return sidecar;
}

// what is written is read back, whatever stands in it
TEST(GoldenFile, ASidecarReadsBackAsItWas) {
  const TemporaryFolder folder;
  const GoldenSidecar sent = some_sidecar();
  test::write_text(folder / "a.toml", sidecar_text(sent));
  const GoldenSidecar read = load_golden_sidecar(folder / "a.toml");
  EXPECT_EQ(read.cause, sent.cause);
  EXPECT_EQ(read.polhode, sent.polhode);
  EXPECT_EQ(read.backend, sent.backend);
  EXPECT_EQ(read.renderer, sent.renderer);
  EXPECT_EQ(read.llvm, "");
  EXPECT_EQ(read.samples, 4);
  EXPECT_EQ(read.verdict.reason, sent.verdict.reason);
  EXPECT_EQ(read.verdict.thresholds.max, 5);
  EXPECT_EQ(read.verdict.thresholds.fraction, 1.0 / 3.0) << "to the last bit";
  EXPECT_EQ(read.verdict.thresholds.flip, std::optional<double>(0.1));
  EXPECT_FALSE(read.verdict.thresholds.ssim);
}

TEST(GoldenFile, CasesAreReadWithTheirRules) {
  const TemporaryFolder folder;
  test::write_text(folder / "cases.toml",
                   "[verdict]\nmax = 2\nreason = \"why\"\n"
                   "[[case]]\nname = \"a\"\nscene = \"../a.toml\"\nstill_ms = 1500\n"
                   "[[case]]\nname = \"b-2\"\nscene = \"b.toml\"\nsize = \"64x48\"\n"
                   "verdict = { max = 9 }\n");
  const GoldenFile golden = load_golden_file(folder / "cases.toml");
  EXPECT_EQ(golden.verdict.thresholds.max, 2);
  ASSERT_EQ(golden.cases.size(), 2u);
  EXPECT_EQ(golden.cases[0].still, 1.5);
  EXPECT_FALSE(golden.cases[0].verdict);
  EXPECT_EQ(golden.cases[1].verdict->thresholds.max, 9);
  EXPECT_EQ(golden.cases[1].size.width, 64);
}

// names become names of files: nothing else may stand in them, and none twice
TEST(GoldenFile, NamesThatAreNoFileNamesAreRefused) {
  EXPECT_TRUE(is_plain_name("a_B-9"));
  for (const char* name : {"", "../a", "a.b", "a b", "ü", "a/b"})
    EXPECT_FALSE(is_plain_name(name)) << name;
  const TemporaryFolder folder;
  const auto load = [&](const std::string& cases) {
    return [&, cases] {
      test::write_text(folder / "cases.toml", cases);
      load_golden_file(folder / "cases.toml");
    };
  };
  const std::string one = "[[case]]\nname = \"a\"\nscene = \"a.toml\"\n";
  test::expect_input_error(
      load("[[case]]\nname = \"../a\"\nscene = \"a.toml\"\n"), "case[0].name", "letters, digits");
  test::expect_input_error(load(one + one), "case[1].name", "two cases 'a'");
  test::expect_input_error(load("[[case]]\nname = \"a\"\n"), "case[0].scene", "");
  test::expect_input_error(load(one + "scne = 1\n"), "case[0].scne", "did you mean 'scene'?");
}

}  // namespace
}  // namespace polhode
