// SPDX-License-Identifier: MIT
#include "cli/shared_options.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode {
namespace {

// parses the words of a command line
void parse(CLI::App& app, std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  app.parse(words);
}

TEST(SharedOptions, NumbersAreReadWhole) {
  for (const auto& [text, value] :
       {std::pair{"1.5", 1.5}, {"-3e-7", -3e-7}, {"0", 0.0}, {"1e300", 1e300}}) {
    CLI::App app;
    std::optional<double> number;
    add_number(app, "-n,--number", number, "a number");
    parse(app, {std::string("--number=") + text});
    EXPECT_EQ(number, value) << text;
  }
}

// what is no finite number is refused with the option's long name, whichever name was written
TEST(SharedOptions, OtherTextIsNoNumber) {
  for (const char* text : {"", "1,5", "1.5x", " 1", "nan", "inf", "1e999", "0x10", "one"}) {
    CLI::App app;
    std::optional<double> number;
    add_number(app, "-n,--number", number, "a number");
    test::expect_input_error(
        [&] {
          parse(app, {"-n", text});
        },
        "--number",
        "must be a number, such as 1.5");
    EXPECT_FALSE(number);
  }
}

TEST(SharedOptions, WholeNumbersHaveNoFractionAndFit) {
  const auto read = [](const char* text) {
    CLI::App app;
    std::optional<int> number;
    add_whole_number(app, "--crf", number, "a whole number");
    parse(app, {"--crf", text});
    return number;
  };
  EXPECT_EQ(read("18"), 18);
  EXPECT_EQ(read("2e3"), 2000);
  EXPECT_EQ(read("-2147483647"), -2147483647);
  for (const char* text : {"1.5", "2147483648", "1e20"})
    test::expect_input_error([&] { read(text); }, "--crf", "must be a whole number");
}

TEST(SharedOptions, TheLastOfSeveralHoldsAndAnAbsentOneChangesNothing) {
  CLI::App app;
  std::optional<double> number = 7.0;
  std::string text = "default";
  add_number(app, "--number", number, "a number");
  add_text(app, "--text", text, "a text");
  parse(app, {});
  EXPECT_EQ(number, 7.0);
  EXPECT_EQ(text, "default");
  parse(app, {"--number", "1", "--text", "a", "--number", "2"});
  EXPECT_EQ(number, 2.0);
  EXPECT_EQ(text, "a");
  test::expect_input_error([&] { parse(app, {"--text", ""}); }, "--text", "must not be empty");
}

TEST(SharedOptions, QuietSilencesEveryKindOfProgress) {
  EXPECT_EQ(progress_of({"bar", false}), ProgressKind::bar);
  EXPECT_EQ(progress_of({"json", false}), ProgressKind::json);
  EXPECT_EQ(progress_of({"bar", true}), ProgressKind::none);
  test::expect_input_error([] { progress_of({"bra", true}); }, "--progress", "'bar'");
}

TEST(SharedOptions, ThresholdsAreTheDefaultsWithWhatWasGiven) {
  ThresholdOptions given;
  given.max = 9;
  given.flip = 0.25;
  const Thresholds thresholds = thresholds_of(given);
  EXPECT_EQ(thresholds.max, 9);
  EXPECT_EQ(thresholds.flip, 0.25);
  EXPECT_EQ(thresholds.limit, Thresholds{}.limit);
  EXPECT_EQ(thresholds.fraction, Thresholds{}.fraction);
  EXPECT_FALSE(thresholds.ssim);
  given.max = 256;
  EXPECT_THROW(thresholds_of(given), Error);
}

}  // namespace
}  // namespace polhode
