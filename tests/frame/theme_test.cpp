// SPDX-License-Identifier: MIT
#include "frame/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <gtest/gtest.h>

#include "base/units.h"
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

// names have nearly the colours of what they name, and can be read: 4.5 to one, as WCAG asks
TEST(Theme, NamesStandOutFromTheGround) {
  for (const Theme& theme : themes()) {
    for (const glm::vec3& color : {theme.omega,
                                   theme.momentum,
                                   theme.body_axes,
                                   theme.space_axes,
                                   theme.force,
                                   theme.friction,
                                   theme.velocity,
                                   theme.position})
      EXPECT_GE(contrast(readable(color, theme.background), theme.background), 4.5) << theme.name;
  }
}

// text keeps its colour where it can be read, and its hue elsewhere
TEST(Theme, TextIsChangedNoMoreThanItMustBe) {
  const glm::vec3 white(1.0f), black(0.0f), dark(0.5f, 0.1f, 0.0f), orange(1.0f, 0.5f, 0.0f);
  EXPECT_EQ(readable(dark, white), dark);
  EXPECT_EQ(readable(orange, black), orange);
  EXPECT_NEAR(contrast(readable(orange, white), white), 4.55, 0.01);
  EXPECT_NEAR(contrast(readable(dark, black), black), 4.55, 0.01);
  const glm::vec3 brown = readable(orange, white);
  EXPECT_NEAR(brown.g / brown.r, 0.5f, 1e-3f);
  const glm::vec3 grey(0.46f);
  EXPECT_GE(contrast(readable(grey, grey), grey), 4.5) << "from the ground itself";
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

// CIEDE2000 of two Lab colours: Sharma, Wu and Dalal, Color Research and Application 30 (2005) 21
double ciede2000(const Vec3& one, const Vec3& other) {
  const auto degrees = [](double y, double x) {
    const double angle = std::atan2(y, x) / kPi * 180.0;
    return angle < 0.0 ? angle + 360.0 : angle;
  };
  const auto cosine = [](double angle) {
    return std::cos(angle / 180.0 * kPi);
  };
  const auto part_of_25 = [](double chroma) {
    return std::sqrt(std::pow(chroma, 7) / (std::pow(chroma, 7) + std::pow(25.0, 7)));
  };
  const double mean = 0.5 * (std::hypot(one.y(), one.z()) + std::hypot(other.y(), other.z()));
  const double stretch = 1.5 - 0.5 * part_of_25(mean);
  const double a1 = stretch * one.y(), a2 = stretch * other.y();
  const double c1 = std::hypot(a1, one.z()), c2 = std::hypot(a2, other.z());
  const double h1 = degrees(one.z(), a1), h2 = degrees(other.z(), a2);
  const bool grey = c1 * c2 == 0.0;
  double turn = grey ? 0.0 : h2 - h1;
  if (std::abs(turn) > 180.0) turn -= std::copysign(360.0, turn);
  double hue = grey ? h1 + h2 : 0.5 * (h1 + h2);
  if (!grey && std::abs(h1 - h2) > 180.0) hue += hue < 180.0 ? 180.0 : -180.0;

  const double dark = std::pow(0.5 * (one.x() + other.x()) - 50.0, 2);
  const double chroma = 0.5 * (c1 + c2);
  const double t = 1.0 - 0.17 * cosine(hue - 30.0) + 0.24 * cosine(2.0 * hue) +
                   0.32 * cosine(3.0 * hue + 6.0) - 0.20 * cosine(4.0 * hue - 63.0);
  const double l = (other.x() - one.x()) / (1.0 + 0.015 * dark / std::sqrt(20.0 + dark));
  const double c = (c2 - c1) / (1.0 + 0.045 * chroma);
  const double h =
      2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * turn / 180.0 * kPi) / (1.0 + 0.015 * chroma * t);
  const double bend = 60.0 * std::exp(-std::pow((hue - 275.0) / 25.0, 2));
  const double rotation = -2.0 * part_of_25(chroma) * std::sin(bend / 180.0 * kPi);
  return std::sqrt(l * l + c * c + h * h + rotation * c * h);
}

// pairs 1, 12, 21 and 34 of the paper's table
TEST(Theme, TheMeasureOfColoursIsThePublishedOne) {
  EXPECT_NEAR(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
  EXPECT_NEAR(ciede2000({50, 2.49, -0.001}, {50, -2.49, 0.0011}), 7.2195, 1e-4);
  EXPECT_NEAR(ciede2000({50, 2.5, 0}, {73, 25, -18}), 27.1492, 1e-4);
  EXPECT_NEAR(ciede2000({2.0776, 0.0795, -1.135}, {0.9033, -0.0636, -0.5514}), 0.9082, 1e-4);
}

// How colours look to eyes that see all, and to those that do not see red, green or blue: matrices
// of Machado, Oliveira and Fernandes (2009) for linear colours. Lab.
using Eyes = std::array<Mat3, 4>;
Eyes all_eyes() {
  Mat3 red, green, blue;
  // clang-format off
  red   <<  0.152286, 1.052583, -0.204868,  0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  green <<  0.367322, 0.860646, -0.227968,  0.280085, 0.672501, 0.047413, -0.011820,  0.042940, 0.968881;
  blue  <<  1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733,  0.691367, 0.303900;
  // clang-format on
  return {Mat3(Mat3::Identity()), red, green, blue};
}
Vec3 seen_by(const Mat3& eye, const glm::vec3& color) {
  const Vec3 linear = Vec3(color.r, color.g, color.b).unaryExpr([](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  });
  return lab((eye * linear).cwiseMax(0.0).cwiseMin(1.0));
}

// every two vectors are told apart by every eye; ten is a clear difference at a glance
TEST(Theme, VectorsAreToldApartByEveryEye) {
  for (const Theme& theme : themes()) {
    const glm::vec3 colors[] = {theme.omega,
                                theme.momentum,
                                theme.body_axes,
                                theme.force,
                                theme.friction,
                                theme.velocity,
                                theme.position};
    for (const Mat3& eye : all_eyes()) {
      for (std::size_t i = 0; i < std::size(colors); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_GE(ciede2000(seen_by(eye, colors[i]), seen_by(eye, colors[j])), 11.5)
              << theme.name << ' ' << i << ' ' << j;
        }
      }
    }
  }
}

// the rates of Euler's angles, by the vertical, the tilt and the body's axis, and Omega, their sum
TEST(Theme, RatesAreToldApartByEveryEye) {
  for (const Theme& theme : themes()) {
    const glm::vec3 colors[] = {theme.omega, theme.space_axes, theme.position, theme.body_axes};
    for (const Mat3& eye : all_eyes()) {
      for (std::size_t i = 0; i < std::size(colors); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_GE(ciede2000(seen_by(eye, colors[i]), seen_by(eye, colors[j])), 11.5)
              << theme.name << ' ' << i << ' ' << j;
        }
      }
    }
  }
}

// a path is told from the axis whose tip draws it, from vectors, and from the cone that it lies on
TEST(Theme, PathsAreToldFromWhatDrawsThem) {
  for (const Theme& theme : themes()) {
    EXPECT_GE(contrast(theme.trail, theme.background), 3.0) << theme.name;
    for (const Mat3& eye : all_eyes()) {
      for (const glm::vec3& other : {theme.body_axes,
                                     theme.omega,
                                     theme.momentum,
                                     theme.force,
                                     theme.friction,
                                     theme.velocity,
                                     theme.position,
                                     theme.space_axes,
                                     theme.precession_cone})
        EXPECT_GE(ciede2000(seen_by(eye, theme.trail), seen_by(eye, other)), 11.5) << theme.name;
    }
  }
}

// in a Poinsot picture ellipsoid, plane and vectors are told apart, also by those who do not see
// red, green or blue
TEST(Theme, PoinsotsSurfacesHaveTheirOwnColours) {
  for (const Theme& theme : themes()) {
    for (const Mat3& eye : all_eyes()) {
      const auto apart = [&](const glm::vec3& a, const glm::vec3& b) {
        return (seen_by(eye, a) - seen_by(eye, b)).norm();
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
      EXPECT_GE(contrast(color, theme.background), 2.6) << theme.name << ": curves";
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
