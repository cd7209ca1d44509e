// SPDX-License-Identifier: MIT
// Decks: what is read from them, what numbers are quoted, what they may reach.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/commands/inspect.h"
#include "lecture/deck.h"
#include "lecture/figures.h"
#include "lecture/media.h"
#include "lecture/quotes.h"
#include "lecture/sandbox.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;
using test::write_text;

Deck deck_of(const std::string& text) {
  return parse_deck(text, "deck.md", {".", false});
}

// the one problem of a deck
std::string problem_of(const std::string& text) {
  const Deck deck = deck_of(text);
  return deck.problems.empty() ? "none" : deck.problems.front().what();
}

TEST(Deck, PicturesOfScenesAreFound) {
  const Deck deck = deck_of(
      "---\ntitle: T\n---\n\n# One\n\n![The *space* cone](a%20b.toml){.film from=0 to=8}\n\n"
      "![](c.toml){.compare with=\"d.toml e.toml\"}\n\n![x](c.toml){.still at=2.5}\n");
  ASSERT_TRUE(deck.problems.empty()) << deck.problems.front().what();
  ASSERT_EQ(deck.pictures.size(), 3U);
  EXPECT_EQ(deck.pictures[0].kind, PictureKind::film);
  EXPECT_EQ(deck.pictures[0].scenes, std::vector<std::string>{"a b.toml"});
  EXPECT_EQ(deck.pictures[0].settings.at("to"), "8");
  EXPECT_EQ(plain_text(deck.pictures[0].caption), "The space cone");
  EXPECT_EQ(deck.pictures[1].scenes, (std::vector<std::string>{"c.toml", "d.toml", "e.toml"}));
  EXPECT_EQ(deck.pictures[1].line, 9);
  EXPECT_EQ(deck.pictures[2].line, 11);
  EXPECT_EQ(deck.pictures[2].name, "c-2");
}

TEST(Deck, WrongWordsGetTheirLineAndTheNearestOne) {
  EXPECT_EQ(problem_of("# One\n\n![](a.toml){.filn}\n"),
            "deck.md:3: unknown kind of picture '.filn' (did you mean 'film'?)");
  EXPECT_EQ(problem_of("\n\n![](a.toml){.film form=2}\n"),
            "deck.md:3: a .film has no 'form' (did you mean 'from'?)");
  EXPECT_NE(problem_of("![](a.toml){.film .loop}\n").find("either"), std::string::npos);
  EXPECT_NE(problem_of("![](a.toml)\n").find("say what to make"), std::string::npos);
  EXPECT_NE(problem_of("x ![](a.toml){.film}\n").find("paragraph of its own"), std::string::npos);
  EXPECT_NE(problem_of("![](a.toml){.compare}\n").find("second scene"), std::string::npos);
  EXPECT_NE(problem_of("---\nheader-includes: x\n---\n").find("header-includes"),
            std::string::npos);
  EXPECT_NE(problem_of("---\nlang: '\"><script>'\n---\n").find("lang"), std::string::npos);
}

TEST(Deck, TextOfOthersStaysText) {
  for (const char* text : {"<script>alert(1)</script>\n",
                           "a <img src=x onerror=alert(1)> b\n",
                           "`<b>`{=html}\n",
                           "```{=latex}\n\\input{/etc/passwd}\n```\n",
                           "\\input{/etc/passwd}\n"}) {
    Deck deck = deck_of(text);
    for_each_node(deck.blocks, [](const Json& node) {
      EXPECT_NE(node["t"], "RawBlock");
      EXPECT_NE(node["t"], "RawInline");
    });
  }
  EXPECT_NE(problem_of("# A {onclick=\"alert(1)\"}\n").find("onclick"), std::string::npos);
  EXPECT_NE(problem_of("[a](b){style=\"x\"}\n"), "none");
  EXPECT_NE(problem_of("[x](javascript:alert(1))\n").find("link"), std::string::npos);
  EXPECT_NE(problem_of("[x](file:///etc/passwd)\n").find("link"), std::string::npos);
  EXPECT_EQ(problem_of("[x](https://example.org) [y](#film=a&t=2)\n"), "none");
  EXPECT_NE(problem_of("![x](http://example.org/a.png)\n"), "none");
  EXPECT_NE(problem_of("$\\input{/etc/passwd}$\n").find("\\input"), std::string::npos);
  EXPECT_NE(problem_of("$\\mbox{\\write18{ls}}$\n").find("\\write"), std::string::npos);
  EXPECT_NE(problem_of("$a^^5cb$\n").find("^^"), std::string::npos);
  EXPECT_EQ(problem_of("$\\left(\\frac{a}{b}\\right)\\letter$\n"), "none");
}

TEST(Reliability, FilesStayInTheFolderOfTheDeck) {
  const TemporaryFolder outer;
  std::filesystem::create_directories(outer / "deck/in");
  write_text(outer / "secret.toml", "x");
  write_text(outer / "deck/a.toml", "x");
  write_text(outer / "deck/in/b.toml", "x");
  std::filesystem::create_symlink("../secret.toml", outer / "deck/link.toml");
  std::filesystem::create_directory_symlink("..", outer / "deck/up");
  std::filesystem::create_symlink("a.toml", outer / "deck/fine.toml");
  const DeckRoot root{outer / "deck", false};
  const auto asked = [&](const std::string& name) {
    return [&root, name] {
      trusted_file(root, root.folder, name);
    };
  };
  EXPECT_NO_THROW(asked("a.toml")());
  EXPECT_NO_THROW(asked("in/b.toml")());
  EXPECT_NO_THROW(asked("fine.toml")());
  for (const std::string name : {"../secret.toml",
                                 "in/../../secret.toml",
                                 "link.toml",
                                 "up/secret.toml",
                                 "in",
                                 "none.toml",
                                 "",
                                 "a\n.toml"})
    EXPECT_THROW(asked(name)(), Error) << name;
  EXPECT_THROW(asked(outer / "secret.toml")(), Error);
  EXPECT_NO_THROW(trusted_file({outer / "deck", true}, outer / "deck", "../secret.toml"));
}

TEST(Reliability, MeshesOfScenesToo) {
  const TemporaryFolder outer;
  std::filesystem::create_directory(outer / "deck");
  write_text(outer / "m.obj", "v 0 0 0\n");
  write_text(outer / "deck/s.toml",
             "format = 1\n[body]\nsolid = { kind = \"mesh\", file = \"../m.obj\", mass = 1 }\n");
  try {
    trusted_scene({outer / "deck", false}, "s.toml");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("leaves the deck's folder"), std::string::npos);
  }
}

TEST(Reliability, NamesInAddresses) {
  EXPECT_EQ(percent_encoded("a b\"<é>.png"), "a%20b%22%3C%C3%A9%3E.png");
  EXPECT_EQ(percent_decoded("a%20b%zz%2"), "a b%zz%2");
}

const Json kAnswer = {{"kind", "symmetric"},
                      {"principal_moments_kg_m2", {0.25, 1e-5, 3.0}},
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
  EXPECT_EQ(told("precession_rate|%.4g,deg_per_s"), "72°/s");
  EXPECT_EQ(told("precession_rate|,none"), "1.257");
  EXPECT_EQ(told("flip_time"), "−0.0002442\u00A0s");
  EXPECT_EQ(told("flip_time|%.2e,us"), "−2.44 × 10²\u00A0µs");
  EXPECT_EQ(told("principal_moments.1"), "1 × 10⁻⁵\u00A0kg m²");
  EXPECT_EQ(told("principal_moments_kg_m2"), "(0.25, 1 × 10⁻⁵, 3)\u00A0kg m²");
  EXPECT_EQ(told("stable"), "yes");
  EXPECT_EQ(quoted(kAnswer, parse_quote("{inspect:s.toml#precession_rate}")).tex,
            "1.257\\;\\text{rad/s}");
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
  EXPECT_NE(why("flip_time|%.999999g").find("not a number format"), std::string::npos);
  EXPECT_NE(why("flip_time|%.3g,rpm").find("cannot be converted"), std::string::npos);
  EXPECT_THROW(parse_quote("{inspect:nothing}"), Error);
}

TEST(Quotes, StandInTextFormulasAndCaptions) {
  Deck deck = deck_of(
      "A ({inspect:s.toml#flip_time|%.1e}), $x = {inspect:s.toml#flip_time|%.1e}$\n\n"
      "![c {inspect:s.toml#stable}](s.toml){.film}\n\n{inspect:s.toml#nothing}\n");
  fill_quotes(deck, "\n\n\n{inspect:s.toml#nothing}", [](const std::string&) -> const Json& {
    return kAnswer;
  });
  EXPECT_EQ(plain_text(deck.blocks[0]["c"]),
            "A (−2.4 × 10⁻⁴\u00A0s), x = -2.4\\times 10^{-4}\\;\\text{s}");
  EXPECT_EQ(plain_text(deck.pictures[0].caption), "c yes");
  ASSERT_EQ(deck.problems.size(), 1U);
  EXPECT_EQ(deck.problems[0].place().line, 4);
  EXPECT_EQ(quoted_scenes(deck_of("{inspect:s.toml#a} {inspect:t.toml#b}")).size(), 2U);
}

TEST(Figures, HostileWordsAreEscaped) {
  DeckPicture picture;
  picture.kind = PictureKind::film;
  picture.name = "n";
  picture.scenes = {"s.toml"};
  picture.settings["alt"] = "\"><script>alert(1)</script>";
  const Json facts = {{"film", "a\"b.mp4"},
                      {"poster", "p<.png"},
                      {"poster_at", 0.0},
                      {"stills", Json::array()},
                      {"vtt", "WEBVTT\n\n<script>"},
                      {"pauses", Json::array()},
                      {"frames", 10},
                      {"fps", 30.0},
                      {"width", 64},
                      {"height", 36},
                      {"title", "</p><script>x</script>"}};
  const Figure figure{&picture, {facts, facts}, ""};
  for (const Json& blocks : {page_blocks(figure), slide_blocks(figure), handout_blocks(figure)}) {
    const std::string text = blocks.dump();
    EXPECT_EQ(text.find("<script"), std::string::npos) << text;
    EXPECT_EQ(text.find("p<.png"), std::string::npos) << text;
  }
}

TEST(MediaFolder, KeepsWhatIsWholeAndMakesTheRest) {
  const TemporaryFolder folder;
  int made = 0;
  const auto product = [&](const std::string& key) {
    return Product{"one", key, [&](const std::filesystem::path& where, const std::string& stem) {
                     ++made;
                     write_text((where / (stem + ".txt")).string(), "content");
                     return Json{{"text", stem + ".txt"}};
                   }};
  };
  const auto obtain = [&](const std::string& key) {
    Media media(folder.path());
    return media.obtain(product(key))["text"].get<std::string>();
  };
  const std::string file = obtain("a");
  obtain("a");
  EXPECT_EQ(made, 1);
  EXPECT_NE(obtain("b"), file);
  EXPECT_EQ(made, 2);
  // cut short, changed, gone: made again
  write_text(folder / file, "conten");
  obtain("a");
  EXPECT_EQ(made, 3);
  std::filesystem::remove(folder / file);
  obtain("a");
  EXPECT_EQ(made, 4);
  // what nobody asked for goes, what is not ours stays
  write_text(folder / "mine.json", "{}");
  write_text(folder / "evil.json", R"({"files":[{"name":"mine.json"}]})");
  Media media(folder.path());
  media.obtain(product("a"));
  media.forget_the_rest();
  EXPECT_TRUE(std::filesystem::exists(folder / file));
  EXPECT_TRUE(std::filesystem::exists(folder / "mine.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / (Media::stem_of(product("b")) + ".txt")));
}

// The formulas of the shipped lecture, evaluated with the numbers of inspect.
class LectureFormulas : public ::testing::Test {
 protected:
  static Json answer(const std::string& scene) {
    return inspection(
        solve(load_with_overrides(POLHODE_SOURCE_DIR "/scenes/lectures/" + scene + ".toml", {})));
  }
  static double derived(const Json& one, const std::string& key) {
    return one.at("derived").at(key);
  }
  static void expect_near(double a, double b) { EXPECT_NEAR(a, b, 1e-9 * std::abs(b)); }
};

TEST_F(LectureFormulas, FreeSymmetricTop) {
  for (const char* scene : {"free_top", "oblate_top"}) {
    const Json top = answer(scene);
    const std::vector<double> I = top.at("principal_moments_kg_m2");
    const bool prolate = top.at("kind") == "symmetric prolate";
    const double I1 = I[1], I3 = prolate ? I[0] : I[2],
                 L = derived(top, "angular_momentum_kg_m2_per_s");
    expect_near(derived(top, "precession_rate_rad_per_s"), L / I1);
    const double c = std::cos(derived(top, "axis_to_momentum_angle_rad"));
    expect_near(std::abs(derived(top, "spin_rate_rad_per_s")),
                std::abs(L * c * (1.0 / I3 - 1.0 / I1)));
  }
}

TEST_F(LectureFormulas, ThreePointsArePlanar) {
  const std::vector<double> I = answer("three_points").at("principal_moments_kg_m2");
  expect_near(I[0] + I[1], I[2]);
}

TEST_F(LectureFormulas, PlateWobblesTwiceAsFast) {
  const Json plate = answer("plate");
  const double tilt = derived(plate, "axis_to_momentum_angle_rad"),
               rate = derived(plate, "precession_rate_rad_per_s");
  const double spin = rate * std::cos(tilt) + derived(plate, "spin_rate_rad_per_s");
  expect_near(rate, 2.0 * spin / std::cos(tilt));
}

TEST_F(LectureFormulas, MiddleAxis) {
  const Json handle = answer("t_handle");
  const std::vector<double> I = handle.at("principal_moments_kg_m2");
  const double sigma = 9.0 * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2]));
  EXPECT_NEAR(derived(handle, "growth_rate_off_middle_axis_per_s"), sigma, 1e-3 * sigma);
}

TEST_F(LectureFormulas, HeavyTops) {
  // rods: 2 pi sqrt(I / (m g a)), I = m L^2 / 12 + m a^2
  for (const auto& [scene, a] : {std::pair{"rod_near_centre", 0.05}, {"rod_at_end", 0.2}})
    expect_near(derived(answer(scene), "small_oscillation_period_s"),
                2.0 * kPi * std::sqrt((0.16 / 12.0 + a * a) / (9.80665 * a)));
  // a wheel with its axle level
  const Json wheel = answer("bicycle_wheel");
  const double I3 = wheel.at("principal_moments_kg_m2")[2], m = wheel.at("mass_kg");
  expect_near(derived(wheel, "mean_precession_rate_rad_per_s"), m * 9.80665 * 0.15 / (I3 * 23.0));
  // steady precession, and the threshold of sleep
  const Json top = answer("top_cusps");
  const std::vector<double> I = top.at("principal_moments_kg_m2");
  const double c = std::cos(derived(top, "tilt_at_start_rad")),
               weight = derived(top, "potential_energy_J") / c, spin = I[0] * 130.0;
  const double root = std::sqrt(spin * spin - 4.0 * I[1] * weight * c);
  expect_near(derived(top, "slow_steady_precession_rad_per_s"), (spin - root) / (2.0 * I[1] * c));
  expect_near(derived(top, "fast_steady_precession_rad_per_s"), (spin + root) / (2.0 * I[1] * c));
  expect_near(derived(top, "sleeping_top_stability_ratio"), spin * spin / (4.0 * I[1] * weight));
}

// Every scene that a shipped deck names is there, every quote has its number.
TEST(ShippedDecks, HaveNoProblems) {
  for (const char* name : {"rigid_body", "dzhanibekov"}) {
    const std::filesystem::path file =
        std::string(POLHODE_SOURCE_DIR "/scenes/lectures/") + name + ".md";
    Deck deck = read_deck(file, false);
    std::map<std::string, Json> answers;
    for (const DeckPicture& picture : deck.pictures) {
      for (const std::string& scene : picture.scenes)
        EXPECT_NO_THROW(load_scene(trusted_scene(deck.root, scene))) << scene;
    }
    fill_quotes(deck, test::read_text(file.string()), [&](const std::string& scene) -> const Json& {
      Json& one = answers[scene];
      if (one.is_null())
        one = inspection(solve(load_with_overrides(trusted_scene(deck.root, scene), {})));
      return one;
    });
    for (const Error& problem : deck.problems)
      ADD_FAILURE() << problem.what();
    EXPECT_GE(deck.pictures.size(), 4U);
  }
}

}  // namespace
}  // namespace polhode
