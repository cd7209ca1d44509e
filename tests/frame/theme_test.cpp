// SPDX-License-Identifier: MIT
#include "frame/theme.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode {
namespace {

// relative luminance and contrast of sRGB colours (WCAG 2.1)
double luminance(const glm::vec3& color) {
  const auto linear = [](double c) {
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

double contrast(const glm::vec3& a, const glm::vec3& b) {
  const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

TEST(Theme, HexColoursAreSrgb) {
  EXPECT_EQ(color_from_hex("#ff0080"), glm::vec3(255, 0, 128) / 255.0f);
  test::expect_input_error([] { color_from_hex("red"); }, "", "#");
}

// vectors and their names stand out from the ground in every theme: three to one, what WCAG asks
// of graphics
TEST(Theme, VectorsStandOutFromTheGround) {
  for (const Theme& theme : themes()) {
    for (const glm::vec3& color : {theme.omega,
                                   theme.momentum,
                                   theme.body_axes,
                                   theme.force,
                                   theme.velocity,
                                   theme.position})
      EXPECT_GE(contrast(color, theme.background), 3.0) << theme.name;
    EXPECT_GE(glm::distance(theme.omega, theme.momentum), 0.5f) << theme.name;
  }
}

TEST(Theme, TheScenesOwnGroundReplacesTheThemes) {
  ThemeSpec spec;
  spec.theme = "light";
  spec.background = "#123456";
  const Theme theme = make_theme(spec);
  EXPECT_EQ(theme.background, color_from_hex("#123456"));
  spec.background.reset();
  EXPECT_EQ(theme.omega, make_theme(spec).omega);
  EXPECT_NE(theme.background, make_theme(spec).background);
}

TEST(Theme, AnUnknownOneNamesTheNearest) {
  ThemeSpec spec;
  spec.theme = "projectr";
  test::expect_input_error([&] { make_theme(spec); }, "video.theme", "'projector'");
}

TEST(Theme, EveryMaterialHasItsFinish) {
  const std::pair<const char*, Finish> table[] = {{"plain", Finish::plain},
                                                  {"painted_wood", Finish::wood},
                                                  {"brushed_metal", Finish::metal},
                                                  {"ceramic", Finish::ceramic}};
  ASSERT_EQ(material_names().size(), std::size(table));
  for (const auto& [name, finish] : table)
    EXPECT_EQ(finish_named(name), finish) << name;
}

}  // namespace
}  // namespace polhode
