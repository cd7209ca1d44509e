// SPDX-License-Identifier: MIT
// The shipped decks: their formulas against the numbers of inspect, and that nothing in them is
// wrong.
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "app/commands/inspect.h"
#include "base/json.h"
#include "lecture/deck/deck.h"
#include "lecture/deck/quotes.h"
#include "lecture/deck/sandbox.h"
#include "scene/scene_file.h"
#include "support/run.h"

namespace polhode {
namespace {

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
