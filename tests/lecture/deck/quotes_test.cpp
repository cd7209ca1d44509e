// SPDX-License-Identifier: MIT
#include "lecture/deck/quotes.h"

#include <gtest/gtest.h>

#include "lecture/decks.h"

namespace polhode {
namespace {

using test::deck_of;

const Json kAnswer = {{"kind", "symmetric"},
                      {"principal_moments_kg_m2", {0.25, 1e-5, 3.0}},
                      {"conserved", nullptr},
                      {"events", Json::array()},
                      {"derived",
                       {{"precession_rate_rad_per_s", 1.2566370614359172},
                        {"flip_time_s", -2.44228e-4},
                        {"stable", true}}}};

std::string told(const std::string& words) {
  return quoted(kAnswer, parse_quote("{inspect:s.toml#" + words + "}")).text;
}

TEST(Quotes, NumbersAsReadersWantThem) {
  EXPECT_EQ(told("precession_rate"), "1.257\u00A0rad/s");
  EXPECT_EQ(told("derived.precession_rate_rad_per_s|%.2f"), "1.26\u00A0rad/s");
  EXPECT_EQ(told("derived.precession_rate|%.2f"), "1.26\u00A0rad/s");
  EXPECT_EQ(told("precession_rate|%.4g,deg_per_s"), "72°/s");
  EXPECT_EQ(told("precession_rate|%.3e,deg_per_s"), "7.200 × 10¹\u00A0°/s");
  EXPECT_EQ(told("precession_rate|,none"), "1.257");
  EXPECT_EQ(told("flip_time"), "−0.0002442\u00A0s");
  EXPECT_EQ(told("flip_time|%.2e,us"), "−2.44 × 10²\u00A0µs");
  EXPECT_EQ(told("principal_moments.1"), "1 × 10⁻⁵\u00A0kg m²");
  EXPECT_EQ(told("principal_moments_kg_m2"), "(0.25, 1 × 10⁻⁵, 3)\u00A0kg m²");
  EXPECT_EQ(told("stable"), "yes");
  EXPECT_EQ(quoted(kAnswer, parse_quote("{inspect:s.toml#precession_rate}")).tex,
            "1.257\\;\\text{rad/s}");
}

// 1 of each key's unit in every other unit that it can be told in
TEST(Quotes, UnitsAreConvertedAsTheyAre) {
  const struct {
    const char* key;
    const char* unit;
    const char* text;
  } rows[] = {{"angle_rad", "deg", "57.3°"},
              {"rate_rad_per_s", "deg_per_s", "57.3°/s"},
              {"rate_rad_per_s", "rpm", "9.55\u00A0rpm"},
              {"rate_rad_per_s", "hz", "0.159\u00A0Hz"},
              {"time_s", "ms", "1 × 10³\u00A0ms"},
              {"time_s", "us", "1 × 10⁶\u00A0µs"},
              {"time_s", "min", "0.0167\u00A0min"},
              {"time_s", "h", "0.000278\u00A0h"},
              {"time_s", "d", "1.16 × 10⁻⁵\u00A0d"},
              {"length_m", "cm", "100\u00A0cm"},
              {"length_m", "mm", "1 × 10³\u00A0mm"},
              {"mass_kg", "g", "1 × 10³\u00A0g"},
              {"moment_kg_m2", "g_cm2", "1 × 10⁷\u00A0g cm²"},
              {"moment_kg_m2", "kg_cm2", "1 × 10⁴\u00A0kg cm²"},
              {"energy_J", "mJ", "1 × 10³\u00A0mJ"},
              {"energy_J", "kJ", "0.001\u00A0kJ"},
              {"growth_per_s", "per_min", "60\u00A01/min"}};
  for (const auto& row : rows) {
    const Json answer = {{row.key, 1.0}};
    EXPECT_EQ(quoted(answer, {"s.toml", row.key, "%.3g", row.unit}).text, row.text) << row.unit;
  }
}

TEST(Quotes, AKeyIsMoreThanItsUnit) {
  EXPECT_EQ(split_unit("flip_time_s"), (std::pair<std::string, std::string>{"flip_time", "s"}));
  EXPECT_EQ(split_unit("L_kg_m2_per_s"), (std::pair<std::string, std::string>{"L", "kg m²/s"}));
  EXPECT_EQ(split_unit("_s"), (std::pair<std::string, std::string>{"_s", ""}));
  EXPECT_EQ(split_unit("kind"), (std::pair<std::string, std::string>{"kind", ""}));
}

TEST(Quotes, WrongOnesSayWhy) {
  const auto why = [](const std::string& words) -> std::string {
    try {
      return told(words);
    } catch (const Error& error) {
      return error.what();
    }
  };
  EXPECT_NE(why("precesion_rate").find("did you mean 'precession_rate"), std::string::npos);
  EXPECT_NE(why("flip_time|%s").find("not a number format"), std::string::npos);
  EXPECT_NE(why("kind|%.3g").find("'kind' is no number; leave out '|%.3g'"), std::string::npos);
  EXPECT_NE(why("conserved|%.3g").find("'conserved' has no number here"), std::string::npos);
  EXPECT_NE(why("events").find("'events' has no number here"), std::string::npos);
  EXPECT_NE(why("flip_time|%#.3g").find("not a number format"), std::string::npos);
  EXPECT_NE(why("flip_time|%.999999g").find("not a number format"), std::string::npos);
  EXPECT_NE(why("flip_time|%.3g,rpm").find("cannot be converted"), std::string::npos);
  EXPECT_THROW(parse_quote("{inspect:nothing}"), Error);
  EXPECT_EQ(parse_quote("{inspect:s.toml#mass\\|%.1f}").format, "%.1f") << "in a table";
}

TEST(Quotes, StandInTextFormulasAndCaptions) {
  Deck deck = deck_of(
      "A ({inspect:s.toml#flip_time|%.1e}), $x = {inspect:s.toml#flip_time|%.1e}$\n\n"
      "![c {inspect:s.toml#stable}](s.toml){.film alt=\"d {inspect:s.toml#flip_time|%.1e}\"}\n\n"
      "{inspect:s.toml#nothing}\n");
  fill_quotes(deck, "\n\n\n{inspect:s.toml#nothing}", [](const std::string&) -> const Json& {
    return kAnswer;
  });
  EXPECT_EQ(plain_text(deck.blocks[0]["c"]),
            "A (−2.4 × 10⁻⁴\u00A0s), x = {-2.4\\times 10^{-4}\\;\\text{s}}");
  EXPECT_EQ(plain_text(deck.pictures[0].caption), "c yes");
  EXPECT_EQ(deck.pictures[0].settings.at("alt"), "d −2.4 × 10⁻⁴\u00A0s");
  ASSERT_EQ(deck.problems.size(), 1U);
  EXPECT_EQ(deck.problems[0].place().line, 4);
  const std::string table = "| a |\n|---|\n| {inspect:s.toml#nothing\\|%.1f} |\n";
  deck = deck_of(table);
  fill_quotes(deck, table, [](const std::string&) -> const Json& { return kAnswer; });
  ASSERT_EQ(deck.problems.size(), 1U);
  EXPECT_EQ(deck.problems[0].place().line, 3);
  EXPECT_EQ(quoted_scenes(deck_of("{inspect:s.toml#a} {inspect:t.toml#b}")).size(), 2U);
}

// what is done to a number is done to all of it, and not to its first digit
TEST(Quotes, AreWholeInFormulas) {
  const std::string quote = "{inspect:s.toml#flip_time|%.1e,none}";
  const auto tex_of = [&](const std::string& formula, const std::string& asked) {
    std::string text = formula;
    for (std::size_t at = text.find('Q'); at != std::string::npos; at = text.find('Q'))
      text.replace(at, 1, asked);
    Deck deck = deck_of("$" + text + "$\n");
    fill_quotes(deck, "", [](const std::string&) -> const Json& { return kAnswer; });
    EXPECT_TRUE(deck.problems.empty());
    return plain_text(deck.blocks[0]["c"]);
  };
  const std::string value = "{-2.4\\times 10^{-4}}", apart = "{\\left(-2.4\\times 10^{-4}\\right)}";
  for (const std::string before : {"",
                                   "a=",
                                   "\\sqrt ",
                                   "\\approx ",
                                   "a = \\, ",
                                   "\\left(",
                                   "a^",
                                   "a &= ",
                                   "\\frac{1}",
                                   "a \\\\ ",
                                   "a \\\\[2pt] "})
    EXPECT_EQ(tex_of(before + "Q", quote), before + value) << before;
  // it would be taken from what stands there
  for (const std::string before : {"a", "2\\,", "a-", "\\Omega ", "\\cdot ", "\\frac{1}{2} "})
    EXPECT_EQ(tex_of(before + "Q", quote), before + apart) << before;
  EXPECT_EQ(tex_of("\\frac Q2", quote), "\\frac " + value + "2");
  for (const std::string behind :
       {"^2", " ^2", "_1^2", "_{a}^2", "{}^2", "\\,^2", "'", "~^2", "\\quad^2", "\\right.^2", "²"})
    EXPECT_EQ(tex_of("Q" + behind, quote), apart + behind) << behind;
  for (const std::string around : {"{%}^2", "{ % }^2", "{{%}\\,}^2", "\\mathrm{ %}^2"}) {
    const std::size_t at = around.find('%');
    const std::string before = around.substr(0, at), behind = around.substr(at + 1);
    EXPECT_EQ(tex_of(before + "Q" + behind, quote), before + apart + behind) << around;
  }
  EXPECT_EQ(tex_of("Q ^2", "{inspect:s.toml#principal_moments.2|%.2f,none}"), "{3.00} ^2");
  EXPECT_EQ(tex_of("\\int_Q^3", quote), "\\int_" + value + "^3");
  // among words a number is a formula of its own
  EXPECT_EQ(tex_of("\\text{a Q b}", quote), "\\text{a $" + value + "$ b}");
  EXPECT_EQ(tex_of("\\textQ", quote), "\\text{$" + value + "$}");
  EXPECT_EQ(tex_of("\\text{a $c=Q$}", quote), "\\text{a $c=" + value + "$}");
}

// what pandoc takes apart is told, not left in the text
TEST(Quotes, WithSpacesOrMarkupAreRefused) {
  for (const char* quote : {"{inspect:my top.toml#stable}",
                            "{inspect:s.toml#flip_time|%.3g, ms}",
                            "{inspect: s.toml#stable}",
                            "{inspect:s~b~.toml#stable}",
                            "{inspect:s.toml#stable"}) {
    SCOPED_TRACE(quote);
    const std::string text = fmt::format("First.\n\nThen {} and words.\n", quote);
    Deck deck = deck_of(text);
    fill_quotes(deck, text, [](const std::string&) -> const Json& { return kAnswer; });
    ASSERT_EQ(deck.problems.size(), 1U);
    EXPECT_EQ(deck.problems[0].place().line, 3);
    EXPECT_NE(deck.problems[0].message().find("has a space or markup"), std::string::npos);
    EXPECT_TRUE(quoted_scenes(deck_of(text)).empty());
  }
}

}  // namespace
}  // namespace polhode
