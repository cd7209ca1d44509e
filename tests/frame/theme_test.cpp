// SPDX-License-Identifier: MIT
#include "frame/theme.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "math/notation.h"
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

// CIE Lab of a linear sRGB colour (D65)
Vec3 lab(const Vec3& linear) {
  Mat3 xyz_from_rgb;
  // clang-format off
  xyz_from_rgb << 0.4124, 0.3576, 0.1805,
                  0.2126, 0.7152, 0.0722,
                  0.0193, 0.1192, 0.9505;
  // clang-format on
  const Vec3 xyz = (xyz_from_rgb * linear).cwiseQuotient(Vec3(0.9505, 1.0, 1.089));
  const Vec3 f = xyz.unaryExpr(
      [](double v) { return v > 0.008856 ? std::cbrt(v) : 7.787 * v + 16.0 / 116.0; });
  return {116.0 * f.y() - 16.0, 500.0 * (f.x() - f.y()), 200.0 * (f.y() - f.z())};
}

// in a Poinsot picture ellipsoid, plane and vectors are told apart, also by those who do not see
// red, green or blue (matrices of Machado, Oliveira and Fernandes 2009, for linear colours)
TEST(Theme, PoinsotsSurfacesHaveTheirOwnColours) {
  Mat3 red, green, blue;
  // clang-format off
  red   <<  0.152286, 1.052583, -0.204868,  0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  green <<  0.367322, 0.860646, -0.227968,  0.280085, 0.672501, 0.047413, -0.011820,  0.042940, 0.968881;
  blue  <<  1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733,  0.691367, 0.303900;
  // clang-format on
  for (const Theme& theme : themes()) {
    for (const Mat3& eye : {Mat3(Mat3::Identity()), red, green, blue}) {
      const auto seen = [&](const glm::vec3& color) {
        const Vec3 linear = Vec3(color.r, color.g, color.b).unaryExpr([](double c) {
          return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        });
        return lab((eye * linear).cwiseMax(0.0).cwiseMin(1.0));
      };
      const auto apart = [&](const glm::vec3& a, const glm::vec3& b) {
        return (seen(a) - seen(b)).norm();
      };
      EXPECT_GT(apart(theme.ellipsoid, theme.plane), 30.0) << theme.name;
      for (const glm::vec3& surface : {theme.ellipsoid, theme.plane}) {
        EXPECT_GT(apart(surface, theme.omega), 20.0) << theme.name;
        EXPECT_GT(apart(surface, theme.momentum), 20.0) << theme.name;
      }
      EXPECT_GT(apart(theme.polhode, theme.ellipsoid), 20.0) << theme.name;
      EXPECT_GT(apart(theme.herpolhode, theme.plane), 18.0) << theme.name;
    }
    for (const glm::vec3& color : {theme.polhode, theme.herpolhode, theme.plane})
      EXPECT_GE(contrast(color, theme.background), 3.0) << theme.name << ": curves, names";
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
