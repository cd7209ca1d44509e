// SPDX-License-Identifier: MIT
// Pictures against projected geometry: what is computed by Camera::project is found in the pixels.
// Coverage is read from the alpha channel of transparent pictures, so shading plays no part.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/units.h"
#include "frame/compose.h"
#include "frame/to_glm.h"
#include "math/so3.h"
#include "render/renderer.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

constexpr PictureSize kSize{640, 480};

// how edges are made smooth while a test runs
Edges edges_now = Edges::samples;

Image draw(const DrawList& list) {
  const std::unique_ptr<Context> context = open_context("osmesa");
  Renderer renderer(*context, {kSize.width, kSize.height, 4, true, edges_now});
  Image image;
  renderer.draw(list, image);
  return image;
}

// calls f(pixel centre, coverage 0..1) for every pixel that something covers
void for_covered(const Image& image, const std::function<void(const Vec2&, double)>& f) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double alpha = image.at(x, y)[3] / 255.0;
      if (alpha > 0.0) f(Vec2(x + 0.5, y + 0.5), alpha);
    }
  }
}

// A straight-sided tip has a width that falls linearly to zero and a middle that moves linearly:
// both lines, fitted between `from` and `to` pixels behind the expected tip, meet at the tip that
// was drawn.
Vec2 find_tip(
    const Image& image, const Vec2& expected, const Vec2& backwards, double from, double to) {
  const Vec2 back = backwards.normalized();
  const Vec2 across(-back.y(), back.x());
  const int bins = static_cast<int>((to - from) / 2.0);
  std::vector<double> width(static_cast<std::size_t>(bins)), middle(width.size());
  for_covered(image, [&](const Vec2& p, double alpha) {
    const double s = (p - expected).dot(back);
    const int bin = static_cast<int>(std::floor((s - from) / 2.0));
    if (bin < 0 || bin >= bins) return;
    width[static_cast<std::size_t>(bin)] += alpha / 2.0;
    middle[static_cast<std::size_t>(bin)] += alpha / 2.0 * (p - expected).dot(across);
  });
  double n = 0, s1 = 0, s2 = 0, w1 = 0, ws = 0, m1 = 0, ms = 0;
  for (int i = 0; i < bins; ++i) {
    const double s = from + 2.0 * i + 1.0;
    const double w = width[static_cast<std::size_t>(i)];
    const double m = middle[static_cast<std::size_t>(i)] / w;
    n += 1, s1 += s, s2 += s * s, w1 += w, ws += w * s, m1 += m, ms += m * s;
  }
  const double det = n * s2 - s1 * s1;
  const double slope = (n * ws - s1 * w1) / det;
  const double tip_s = -(w1 - slope * s1) / n / slope;
  const double middle_slope = (n * ms - s1 * m1) / det;
  const double tip_across = (m1 - middle_slope * s1) / n + middle_slope * tip_s;
  return expected + tip_s * back + tip_across * across;
}

Camera test_camera() {
  return {Vec3(4, 1, 1.5), Vec3(0, 0, 0), 0.6, kSize, Vec3::Zero(), 1.5};
}

// every test runs with samples and with outlines
class Geometry : public ::testing::TestWithParam<Edges> {
 protected:
  void SetUp() override { edges_now = GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(By,
                         Geometry,
                         ::testing::Values(Edges::samples, Edges::outlines),
                         [](const auto& tested) {
                           return tested.param == Edges::samples ? "samples" : "outlines";
                         });

TEST_P(Geometry, AnArrowsTipIsWithinHalfAPixelOfTheVectorsEnd) {
  const Camera camera = test_camera();
  for (const Vec3& vector : {Vec3(0, 0, 1),
                             Vec3(0, 1, 0),
                             Vec3(0, -1, -0.4),
                             Vec3(0.4, 0.7, 0.6),
                             Vec3(-0.5, -0.6, 0.8)}) {
    DrawList list;
    list.view = camera.view();
    const ArrowShape shape{0.03, 0.12, 0.5};
    add_arrow(list.opaque, arrow_meshes(96, 96), Vec3::Zero(), vector, shape, Material{});
    const Image image = draw(list);

    const Vec2 tip = camera.project(vector);
    const Vec3 neck = vector * (1.0 - shape.head_length / vector.norm());
    const Vec2 back = camera.project(neck) - tip;
    const Vec2 found = find_tip(image, tip, back, 0.25 * back.norm(), 0.75 * back.norm());
    EXPECT_LT((found - tip).norm(), 0.5)
        << "found " << found.transpose() << ", tip " << tip.transpose();
  }
}

// the same check must fail for an arrow that ends elsewhere: a net that catches
TEST_P(Geometry, AShiftOfOnePixelIsSeen) {
  const Camera camera = test_camera();
  const Vec3 end(0, 0, 1);
  DrawList list;
  list.view = camera.view();
  const double metre_per_pixel = 1.0 / camera.pixels_per_metre(end);
  add_arrow(list.opaque,
            arrow_meshes(96, 96),
            Vec3::Zero(),
            end + Vec3(0, 0, metre_per_pixel),
            {0.03, 0.12, 0.5},
            Material{});
  const Vec2 tip = camera.project(end);
  const Vec2 back = camera.project(0.5 * end) - tip;
  const Vec2 found = find_tip(draw(list), tip, back, 0.25 * back.norm(), 0.75 * back.norm());
  EXPECT_GT((found - tip).norm(), 0.5);
}

Cone test_cone() {
  return {Vec3(0.05, 0.1, -0.6), Vec3(0.1, 0.2, 1).normalized(), 0.5, 1.3, 0.006, Material{}};
}

TEST_P(Geometry, AConesApexIsWithinHalfAPixel) {
  const Camera camera = test_camera();
  const Cone cone = test_cone();  // opaque, so that alpha is coverage
  DrawList list;
  list.view = camera.view();
  add_cones(list, cone_meshes(128), {cone}, camera.eye());
  list.opaque.clear();  // the shell alone
  const Vec2 apex = camera.project(cone.apex);
  const Vec2 along = camera.project(cone.apex + 0.5 * cone.axis) - apex;
  const Vec2 found = find_tip(draw(list), apex, along, 0.3 * along.norm(), along.norm());
  EXPECT_LT((found - apex).norm(), 0.5);
}

TEST_P(Geometry, AConesRimIsWithinHalfAPixelOfTheCircle) {
  const Camera camera = test_camera();
  const Cone cone = test_cone();
  DrawList list;
  list.view = camera.view();
  add_cones(list, cone_meshes(128), {cone}, camera.eye());
  list.translucent.clear();  // the rim alone
  const Image image = draw(list);

  const Mat3 R = turn_between(Vec3::UnitZ(), cone.axis).toRotationMatrix();
  const auto rim = [&](double angle) {
    const double across = std::sin(cone.half_angle);
    return camera.project(cone.apex + cone.slant * (R * Vec3(across * std::cos(angle),
                                                             across * std::sin(angle),
                                                             std::cos(cone.half_angle))));
  };
  int checked = 0;
  for (double angle = 0.1; angle < 2 * kPi; angle += 0.35) {
    // the middle of the tube's width around this point of the rim
    const Vec2 point = rim(angle);
    const Vec2 tangent = (rim(angle + 1e-4) - rim(angle - 1e-4)).normalized();
    const Vec2 normal(-tangent.y(), tangent.x());
    double weight = 0.0;
    double sum = 0.0;
    for_covered(image, [&](const Vec2& p, double alpha) {
      if (std::abs((p - point).dot(tangent)) > 4.0 || std::abs((p - point).dot(normal)) > 6.0)
        return;
      weight += alpha;
      sum += alpha * (p - point).dot(normal);
    });
    ASSERT_GT(weight, 1.0);
    EXPECT_LT(std::abs(sum / weight), 0.5) << "at angle " << angle;
    ++checked;
  }
  EXPECT_GE(checked, 15);
}

// a ball covers the ellipse that the pinhole projection of a sphere is: area and centre
TEST_P(Geometry, ABallHasItsProjectedAreaAndCentre) {
  const double radius = 0.5;
  const double distance = 4.0;
  const double fov = 0.6;
  const Camera camera(Vec3(distance, 0, 0), Vec3::Zero(), fov, kSize, Vec3::Zero(), radius);
  SolidSpec ball;
  ball.kind = "sphere";
  ball.radius = radius;
  DrawList list;
  list.view = camera.view();
  list.opaque.push_back({std::make_shared<const Mesh>(solid_mesh(ball, 256)), glm::mat4(1.0f), {}});
  double area = 0.0;
  Vec2 centre = Vec2::Zero();
  for_covered(draw(list), [&](const Vec2& p, double alpha) {
    area += alpha;
    centre += alpha * p;
  });
  const double focal = 0.5 * kSize.height / std::tan(0.5 * fov);
  const double radius_px = focal * radius / std::sqrt(distance * distance - radius * radius);
  EXPECT_NEAR(area, kPi * radius_px * radius_px, 0.002 * area);
  EXPECT_NEAR((centre / area - Vec2(320, 240)).norm(), 0.0, 0.05);
}

// a whole scene: the tips that the composer promises are where its arrows end
TEST_P(Geometry, TipsOfOmegaAndMomentumAreInTheirPlace) {
  for (const bool momentum : {true, false}) {
    ShowSpec show;
    for (const char* name : {"body", "space_axes", "space_cone", "body_cone"})
      show[name] = false;
    show["omega"] = !momentum;
    show["momentum"] = momentum;
    const BodySpec body = test::prolate_body();
    const Motion motion = test::moving(body, test::wobbling());
    const Composer composer(motion, body, CameraSpec{}, show, ThemeSpec{}, kSize);
    for (const double t : {0.0, 1.3, 2.9}) {
      const Sample s = motion.at(t);
      const Vec3 end =
          momentum ? momentum_tip(composer.scenery(), s) : omega_tip(composer.scenery(), s);
      const Vec2 tip = composer.camera().project(end);
      const Vec2 back =
          composer.camera().project(end - 0.17 * composer.scenery().scale.body * end.normalized()) -
          tip;
      const Vec2 found =
          find_tip(draw(composer.at(t)), tip, back, 0.25 * back.norm(), 0.75 * back.norm());
      EXPECT_LT((found - tip).norm(), 0.5) << t;
    }
  }
}

// A curve of a film, drawn alone: wherever it runs free, the middle of what is covered across it is
// within half a pixel of the projected curve.
// tube: the radius of the curve's tube, in units of the body's radius.
void expect_on_curve(const char* name,
                     double tube,
                     const std::function<Vec3(const Scenery&, const Sample&)>& curve) {
  const BodySpec body = test::brick_body();
  MotionSpec spec = test::wobbling();
  spec.duration = 2.0;
  const Motion motion = test::moving(body, spec);
  const Composer picture(motion, body, CameraSpec{}, test::show_only(name), ThemeSpec{}, kSize);
  const Image image = draw(picture.at(spec.duration));
  const Camera& camera = picture.camera();
  std::vector<std::pair<double, double>> found;  // what is covered, how far its middle is off
  for (double t = 0.1; t < 1.9; t += 0.05) {
    const auto pixel = [&](double at) {
      return camera.project(curve(picture.scenery(), motion.at(at)));
    };
    const Vec2 here = pixel(t);
    const Vec2 along = (pixel(t + 1e-3) - pixel(t - 1e-3)).normalized();
    const Vec2 across(-along.y(), along.x());
    // a neighbour nearer than a few pixels makes the place no use
    const Vec3 point = curve(picture.scenery(), motion.at(t));
    const double thick = tube * picture.scenery().scale.body * camera.pixels_per_metre(point);
    double sum = 0.0, moment = 0.0, far = 0.0;
    for_covered(image, [&](const Vec2& p, double alpha) {
      const Vec2 off = p - here;
      if (std::abs(off.dot(along)) > 1.0 || off.norm() > thick + 11.0) return;
      if (std::abs(off.dot(across)) > thick + 4.0) far += alpha;
      sum += alpha;
      moment += alpha * off.dot(across);
    });
    if (far > 0.0) continue;
    ASSERT_GT(sum, 0.5) << name << ": nothing at " << here.transpose();
    found.emplace_back(sum, std::abs(moment / sum));
  }
  // where another turn of the curve runs close by there is more than one tube to see
  std::vector<double> sums;
  for (const auto& [sum, off] : found)
    sums.push_back(sum);
  ASSERT_GT(sums.size(), 8U) << name;
  std::nth_element(sums.begin(), sums.begin() + 4, sums.end());
  int looked = 0;
  for (const auto& [sum, off] : found) {
    if (sum > 1.3 * sums[4]) continue;
    ++looked;
    EXPECT_LT(off, 0.5) << name;
  }
  EXPECT_GT(looked, 8) << name;
}

TEST_P(Geometry, ACurveLiesOnTheProjectedCurve) {
  expect_on_curve("herpolhode", 0.016, [](const Scenery& scenery, const Sample& now) {
    return omega_tip(scenery, now);
  });
  expect_on_curve("trail", 0.008, [](const Scenery& scenery, const Sample& now) {
    return Vec3(now.reference_S +
                kTrailRadius * scenery.scale.body * (now.q_SB * Vec3(Vec3::UnitZ())));
  });
}

// What a convex thing covers of each row of pixels, against the chord of its analytic contour
// (points all around, in pixels): each end within half a pixel, but for the rows at the very top
// and bottom, where the chord changes within a row.
void expect_contour(const Image& image, const std::vector<Vec2>& contour) {
  double top = 1e9, bottom = -1e9;
  for (const Vec2& point : contour) {
    top = std::min(top, point.y());
    bottom = std::max(bottom, point.y());
  }
  const double rim = 0.08 * (bottom - top);
  // left and right end of the contour at a height
  const auto chord_at = [&](double y) {
    std::array<double, 2> ends = {1e9, -1e9};
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2& a = contour[i];
      const Vec2& b = contour[(i + 1) % contour.size()];
      const double part = (y - a.y()) / (b.y() - a.y());
      if (!(part >= 0.0 && part <= 1.0)) continue;
      const double x = a.x() + part * (b.x() - a.x());
      ends[0] = std::min(ends[0], x);
      ends[1] = std::max(ends[1], x);
    }
    return ends;
  };
  int looked = 0;
  for (int y = static_cast<int>(std::ceil(top + rim)); y + 1 < bottom - rim; ++y) {
    if (y < 0 || y >= image.height) continue;
    const std::array<double, 2> ends = chord_at(y + 0.5);
    const std::array<double, 2> below = chord_at(y + 1.0), above = chord_at(y);
    const double middle = 0.5 * (ends[0] + ends[1]);
    std::array<double, 2> covered = {0.0, 0.0};  // left and right of the middle
    for (int x = 0; x < image.width; ++x) {
      const double alpha = image.at(x, y)[3] / 255.0;
      const double before = std::clamp(middle - x, 0.0, 1.0);
      covered[0] += alpha * before;
      covered[1] += alpha * (1.0 - before);
    }
    ++looked;
    for (std::size_t side = 0; side < 2; ++side) {
      // square to the contour, which leans by so much
      const double lean = below[side] - above[side];
      const double off = covered[side] - std::abs(ends[side] - middle);
      ASSERT_LT(std::abs(off) / std::hypot(1.0, lean), 0.5) << "row " << y << ", side " << side;
    }
  }
  EXPECT_GT(looked, 20);
}

// one mesh of a picture, drawn alone and opaque, so that alpha is coverage
Image draw_alone(const Composer& picture, const MeshGlyph& glyph) {
  DrawList list;
  list.view = picture.camera().view();
  DrawItem item{glyph.mesh, to_glm(glyph.space_from_mesh.matrix()), Material{}, Faces::both};
  list.opaque.push_back(item);
  return draw(list);
}

Composer shown_alone(const char* name) {
  const BodySpec body = test::ellipsoid_body({0.1, 0.15, 0.2});
  return {test::moving(body, test::wobbling()),
          body,
          CameraSpec{},
          test::show_only(name),
          ThemeSpec{},
          kSize};
}

// of an ellipsoid {c + A x : |x| = 1} the eye sees the circle in which the plane e.x = 1 cuts the
// unit sphere, e = A^-1 (eye - c)
std::vector<Vec2> contour_of_ellipsoid(const Camera& camera, const Placement& place) {
  const Vec3 eye = place.inverse() * camera.eye();
  const double e2 = eye.squaredNorm();
  const Vec3 u = eye.unitOrthogonal();
  const Vec3 v = eye.normalized().cross(u);
  std::vector<Vec2> contour;
  for (int i = 0; i < 1440; ++i) {
    const double turn = 2.0 * kPi * i / 1440;
    const Vec3 x = eye / e2 + std::sqrt(1.0 - 1.0 / e2) * (std::cos(turn) * u + std::sin(turn) * v);
    contour.push_back(camera.project(place * x));
  }
  return contour;
}

TEST_P(Geometry, AnEllipsoidsContourIsWithinHalfAPixel) {
  for (const char* name : {"ellipsoid", "binet", "trail_sphere"}) {
    SCOPED_TRACE(name);
    const Composer picture = shown_alone(name);
    const Glyphs glyphs = picture.glyphs_at(picture.scenery().motion.at(0.7));
    const MeshGlyph& shell = glyphs.shells.at(0);
    expect_contour(draw_alone(picture, shell),
                   contour_of_ellipsoid(picture.camera(), shell.space_from_mesh));
  }
}

TEST_P(Geometry, ADiscsRimIsWithinHalfAPixel) {
  const Composer picture = shown_alone("plane");
  const Glyphs glyphs = picture.glyphs_at(picture.scenery().motion.at(0.7));
  const MeshGlyph& disc = glyphs.sheets.at(0).mesh;
  std::vector<Vec2> rim;
  for (int i = 0; i < 1440; ++i) {
    const double turn = 2.0 * kPi * i / 1440;
    const Vec3 on_rim(std::cos(turn), std::sin(turn), 0.0);
    rim.push_back(picture.camera().project(disc.space_from_mesh * on_rim));
  }
  expect_contour(draw_alone(picture, disc), rim);
}

}  // namespace
}  // namespace polhode
