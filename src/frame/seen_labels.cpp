// SPDX-License-Identifier: MIT
#include "frame/seen_labels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "frame/arrow.h"
#include "math/so3.h"

namespace polhode {
namespace {

// the tip and the rim of an arrow's head (S, m); empty for an arrow of no length
std::vector<Vec3> outline_of_head(const ArrowGlyph& arrow) {
  constexpr int kAround = 12;
  const Vec3 along = arrow.tip - arrow.from;
  const double length = along.norm();
  if (!(length > 0.0)) return {};
  const ArrowShape shape = fitting(arrow.shape, length);
  const Mat3 turn = turn_between(Vec3::UnitZ(), along / length).toRotationMatrix();
  std::vector<Vec3> points = {arrow.tip};
  for (int k = 0; k < kAround; ++k) {
    const double angle = 2.0 * kPi * k / kAround;
    const Vec3 rim(shape.head_radius * std::cos(angle),
                   shape.head_radius * std::sin(angle),
                   -shape.head_length);
    points.push_back(arrow.tip + turn * rim);
  }
  return points;
}

// Whether a vector hides a point from the eye: it passes before it, or around it.
bool hides(const ArrowGlyph& arrow, const Vec3& point, const Camera& camera) {
  const Vec3 along = arrow.tip - arrow.from;
  const double length = along.norm();
  if (!(length > 0.0)) return false;
  const Vec3 axis = along / length;
  const ArrowShape shape = fitting(arrow.shape, length);
  // where the line of sight is nearest to the axis
  const Vec3 sight = (point - camera.eye()).normalized();
  const Vec3 across = axis.cross(sight);
  const double sine2 = across.squaredNorm();
  if (sine2 < 1e-12) return false;
  const Vec3 between = camera.eye() - arrow.from;
  const double at = sight.cross(across).dot(between) / sine2;
  const double far = axis.cross(across).dot(between) / sine2;
  if (at < 0.0 || at > length) return false;
  const double of_head = (length - at) / shape.head_length;
  const double radius = of_head < 1.0 ? of_head * shape.head_radius : shape.shaft_radius;
  const double off = std::abs(between.dot(across)) / std::sqrt(sine2);
  return off < radius && far - radius < (point - camera.eye()).norm();
}

// How much of the head of the vector that a label names is not hidden by other vectors, 0..1: the
// name of one of which nothing is seen would be read as that of the other.
double uncovered(const LabelGlyph& label,
                 const std::vector<ArrowGlyph>& arrows,
                 const Camera& camera) {
  constexpr double kLeast = 0.35, kInFull = 0.65;
  if (!label.of_arrow) return 1.0;
  const auto own = std::find_if(
      arrows.begin(), arrows.end(), [&](const ArrowGlyph& arrow) { return arrow.tip == label.at; });
  if (own == arrows.end() || own->rim) return 1.0;
  const std::vector<Vec3> points = outline_of_head(*own);
  if (points.empty()) return 1.0;
  const auto seen = std::count_if(points.begin(), points.end(), [&](const Vec3& point) {
    return std::none_of(arrows.begin(), arrows.end(), [&](const ArrowGlyph& other) {
      return &other != &*own && hides(other, point, camera);
    });
  });
  const double part = static_cast<double>(seen) / static_cast<double>(points.size());
  return std::clamp((part - kLeast) / (kInFull - kLeast), 0.0, 1.0);
}

TextRoom around(const Vec2& point, double radius) {
  return {point.x() - radius, point.y() - radius, point.x() + radius, point.y() + radius};
}

// the smallest rectangle that holds both
TextRoom both(const TextRoom& a, const TextRoom& b) {
  return {std::min(a.left, b.left),
          std::min(a.top, b.top),
          std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

// the rectangles around what labels must not cover, as the camera sees it
std::vector<TextRoom> marks_of(const Glyphs& glyphs, const Camera& camera) {
  std::vector<TextRoom> marks;
  for (const ArrowGlyph& arrow : glyphs.arrows) {
    const std::vector<Vec3> points = outline_of_head(arrow);
    const bool seen = std::all_of(
        points.begin(), points.end(), [&](const Vec3& point) { return camera.sees(point); });
    if (points.empty() || !seen) continue;
    TextRoom room = around(camera.project(points.front()), 0.0);
    for (const Vec3& point : points)
      room = both(room, around(camera.project(point), 0.0));
    marks.push_back(room);
  }
  for (const MarkGlyph& mark : glyphs.marks) {
    if (!camera.sees(mark.at)) continue;
    marks.push_back(
        around(camera.project(mark.at), mark.radius * camera.pixels_per_metre(mark.at)));
  }
  return marks;
}

// rims of cones, arcs and curves, in straight pieces
std::vector<TextShaft> curves_of(const Glyphs& glyphs, const Camera& camera) {
  constexpr int kPiecesOfRim = 24, kPiecesOfArc = 8;
  std::vector<TextShaft> curves;
  const auto add = [&](int pieces, const std::function<Vec3(double)>& point_at) {
    for (int k = 0; k < pieces; ++k) {
      const Vec3 from = point_at(1.0 * k / pieces), to = point_at((k + 1.0) / pieces);
      if (camera.sees(from) && camera.sees(to))
        curves.push_back({camera.project(from), camera.project(to)});
    }
  };
  for (const Cone& cone : glyphs.cones) {
    const Vec3 across = cone.slant * std::sin(cone.half_angle) * cone.axis.unitOrthogonal();
    const Vec3 middle = cone.apex + cone.slant * std::cos(cone.half_angle) * cone.axis;
    add(kPiecesOfRim, [&](double part) -> Vec3 {
      return middle + Eigen::AngleAxisd(2.0 * kPi * part, cone.axis) * across;
    });
  }
  for (const ArcGlyph& arc : glyphs.arcs)
    add(kPiecesOfArc, [&](double part) { return point_of(arc, part); });
  for (const RodGlyph& rod : glyphs.rods)
    add(1, [&](double part) -> Vec3 { return rod.from + part * (rod.to - rod.from); });
  for (const LineGlyph& line : glyphs.lines)
    add(1, [&](double part) -> Vec3 { return line.from + part * (line.to - line.from); });
  return curves;
}

// nothing if the camera does not see all of it
std::optional<SeenCircle> seen_circle(const CircleGlyph& circle, const Camera& camera) {
  const Vec3 ends[] = {circle.center + circle.half_a,
                       circle.center - circle.half_a,
                       circle.center + circle.half_b,
                       circle.center - circle.half_b};
  Vec2 seen[4];
  for (std::size_t i = 0; i < 4; ++i) {
    if (!camera.sees(ends[i])) return {};
    seen[i] = camera.project(ends[i]);
  }
  return SeenCircle{0.25 * (seen[0] + seen[1] + seen[2] + seen[3]),
                    0.5 * (seen[0] - seen[1]),
                    0.5 * (seen[2] - seen[3])};
}

// Of a curve as the camera sees it, the point that is farthest in a direction (a unit vector,
// pixels). What reaches nearly as far counts too, so that the point moves smoothly with the curve.
std::optional<Vec2> farthest_seen(const std::vector<Vec3>& curve,
                                  const Vec2& direction,
                                  const Camera& camera) {
  constexpr double kNear = 0.01;  // of how far the curve reaches
  std::vector<Vec2> points;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Vec3& point : curve) {
    if (!camera.sees(point)) return {};
    points.push_back(camera.project(point));
    least = std::min(least, direction.dot(points.back()));
    most = std::max(most, direction.dot(points.back()));
  }
  if (!(most > least)) return {};
  Vec2 sum = Vec2::Zero();
  double weights = 0.0;
  for (const Vec2& point : points) {
    const double weight = std::exp((direction.dot(point) - most) / (kNear * (most - least)));
    sum += weight * point;
    weights += weight;
  }
  return sum / weights;
}

SeenLabel seen_label(const LabelGlyph& label, const Camera& camera, const Scenery& scenery) {
  const Vec2 at = camera.project(label.at);
  // a little way along; where that is towards the eye, the label stands above
  const Vec3 step = 0.05 * scenery.scale.body * label.away.stableNormalized();
  const Vec2 along = camera.project(label.at + step) - at;
  const double pixel = 0.05 * scenery.scale.body * camera.pixels_per_metre(label.at);
  const Vec2 away = along + 0.1 * pixel * Vec2(0.0, -1.0);
  const Vec2 from = camera.sees(label.at - label.away) ? camera.project(label.at - label.away) : at;
  SeenLabel seen{from,
                 at,
                 away.normalized(),
                 label.markup,
                 readable(label.color, scenery.theme.background),
                 label.fade,
                 label.of_arrow,
                 label.size};
  if (label.circle) seen.circle = seen_circle(*label.circle, camera);
  const Vec2 up_right = Vec2(1.0, -1.0).normalized();
  if (const std::optional<Vec2> corner = farthest_seen(label.curve, up_right, camera)) {
    seen.away = up_right;
    seen.from = *corner;
    seen.at = *corner + label.away.norm() * camera.pixels_per_metre(label.at) * up_right;
  }
  return seen;
}

}  // namespace

LabelView seen_labels(const Glyphs& glyphs, const Camera& camera, const Scenery& scenery) {
  LabelView names;
  for (const LabelGlyph& label : glyphs.labels) {
    if (!camera.sees(label.at)) continue;
    const double presence = uncovered(label, glyphs.arrows, camera);
    if (presence <= 0.0) continue;
    names.labels.push_back(seen_label(label, camera, scenery));
    names.labels.back().fade *= static_cast<float>(presence);
  }
  names.marks = marks_of(glyphs, camera);
  names.curves = curves_of(glyphs, camera);
  return names;
}

std::vector<Vec2> seen_outline(const std::vector<Vec3>& points_S, const Camera& camera) {
  constexpr int kDirections = 24;
  std::vector<Vec2> points;
  for (const Vec3& point : points_S) {
    if (!camera.sees(point)) return {};
    points.push_back(camera.project(point));
  }
  std::vector<Vec2> outline;
  for (int k = 0; k < kDirections && !points.empty(); ++k) {
    const double angle = 2.0 * kPi * k / kDirections;
    const Vec2 direction(std::cos(angle), std::sin(angle));
    outline.push_back(
        *std::max_element(points.begin(), points.end(), [&](const Vec2& a, const Vec2& b) {
          return a.dot(direction) < b.dot(direction);
        }));
  }
  return outline;
}

}  // namespace polhode
