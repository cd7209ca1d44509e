// SPDX-License-Identifier: MIT
#include "frame/body_look.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "base/check.h"
#include "base/error.h"
#include "math/so3.h"
#include "model/solids.h"

namespace polhode {
namespace {

// what is thin in mechanics still has to be seen
constexpr double kThinDisc = 0.03;   // thickness over radius
constexpr double kThinRing = 0.025;  // tube over radius
constexpr double kThinRod = 0.012;   // radius over length
constexpr int kCoarse = 16;          // pieces of a circle, the least that looks round
constexpr double kFlattest = 0.05;   // least over largest semi-axis of a drawn ellipsoid

std::vector<Vec2> upwards(std::vector<Vec2> profile) {
  // an outline drawn downwards encloses a negative volume and is turned round
  double volume = 0.0;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const double sum = profile[i].x() + profile[i + 1].x();
    volume +=
        (sum * sum - profile[i].x() * profile[i + 1].x()) * (profile[i + 1].y() - profile[i].y());
  }
  if (volume < 0.0) std::reverse(profile.begin(), profile.end());

  // both ends are closed to the axis, unless the outline closes by itself: a tube
  if (profile.front() == profile.back()) return profile;
  profile.insert(profile.begin(), Vec2(0, profile.front().y()));
  profile.emplace_back(0, profile.back().y());
  return profile;
}

// Leaves out the points that lie within `tolerance` (m) of a straight piece between others (Douglas
// and Peucker, Cartographica 10 (1973) 112), unless the outline turns noticeably on the way.
std::vector<Vec2> simplified(const std::vector<Vec2>& outline, double tolerance) {
  constexpr double kMostTurn = 0.15;  // rad, from the piece to the edges that it stands for
  const double least = std::cos(kMostTurn);
  std::vector<Vec2> kept = {outline.front()};
  // the pieces that are still to be looked at, the lowest on top
  std::vector<std::pair<std::size_t, std::size_t>> pieces = {{0, outline.size() - 1}};
  while (!pieces.empty()) {
    const auto [first, last] = pieces.back();
    pieces.pop_back();
    const Vec2 along = outline[last] - outline[first];
    const double length = along.norm();
    double farthest = 0.0;
    std::size_t split = (first + last) / 2;
    bool straight = length > 0.0;
    for (std::size_t i = first; i < last && length > 0.0; ++i) {
      const Vec2 edge = outline[i + 1] - outline[i], out = outline[i] - outline[first];
      straight = straight && edge.dot(along) >= least * edge.norm() * length;
      const double distance = std::abs(along.x() * out.y() - along.y() * out.x()) / length;
      if (distance > farthest) {
        farthest = distance;
        split = i;
      }
    }
    if (last - first < 2 || (straight && farthest <= tolerance)) {
      kept.push_back(outline[last]);
    } else {
      pieces.emplace_back(split, last);
      pieces.emplace_back(first, split);
    }
  }
  return kept;
}

Mesh cylinder_mesh(double radius, double height, int segments) {
  const double z = 0.5 * height;
  return revolved({{0, -z}, {radius, -z}, {radius, z}, {0, z}}, segments);
}

// half-width of the strip that shows the spin: a share of how far the body reaches from the axis of
// the strip, and at most a share of how far the painted mesh reaches across it. Otherwise it covers
// whole arms and spokes.
constexpr double kMarkOfReach = 0.13;
constexpr double kMarkOfBreadth = 1.0 / 3.0;

// how far a mesh reaches from its z axis
double reach_from_axis(const Mesh& mesh) {
  double reach = 0.0;
  for (const Vertex& v : mesh.vertices)
    reach = std::max(reach, to_eigen(v.position).head<2>().norm());
  return reach;
}

// the widest strip about the x axis that a mesh can carry
double widest_mark(const Mesh& mesh) {
  double breadth = 0.0;
  for (const Vertex& v : mesh.vertices)
    breadth = std::max(breadth, static_cast<double>(std::abs(v.position.y)));
  return kMarkOfBreadth * breadth;
}

// Whether a part whose coordinates are placed like this in those of another has its strip in the
// same half-plane: both about the same z axis, and along the same x.
bool marks_meet(const Placement& place, double width) {
  constexpr double kSlack = 1e-3;  // rad
  const Vec3 x = place.linear().col(0), z = place.linear().col(2);
  return (x - Vec3::UnitX()).norm() < kSlack && std::abs(z.y()) < kSlack &&
         place.translation().head<2>().norm() < width;
}

// how far a mesh reaches from its own origin
double reach_of(const Mesh& mesh) {
  double reach = 0.0;
  for (const Vertex& v : mesh.vertices)
    reach = std::max(reach, to_eigen(v.position).norm());
  return reach;
}

// the middle one of the sides of the box around a mesh
double breadth_of(const Mesh& mesh) {
  Vec3 low = to_eigen(mesh.vertices.front().position), high = low;
  for (const Vertex& v : mesh.vertices) {
    low = low.cwiseMin(to_eigen(v.position));
    high = high.cwiseMax(to_eigen(v.position));
  }
  const Vec3 sides = high - low;
  return sides.sum() - sides.maxCoeff() - sides.minCoeff();
}

LookPart painted(Mesh mesh, const Placement& place, const glm::vec3& color, const Theme& theme) {
  Material material;
  material.color = color;
  material.mark_color = theme.mark;
  const double width = kMarkOfReach * reach_from_axis(mesh);
  material.grain = static_cast<float>(width);
  material.mark_width = static_cast<float>(std::min(width, widest_mark(mesh)));
  const double breadth = breadth_of(mesh);
  return {std::make_shared<const Mesh>(std::move(mesh)), place, material, nullptr, breadth};
}

// whether it is a surface of revolution about z
bool is_round(const SolidSpec& solid) {
  if (solid.kind == "ellipsoid") return solid.semi_axes->x() == solid.semi_axes->y();
  return solid.kind != "box" && solid.kind != "mesh";
}

// `segments` are those of a circle as large as the body
LookPart solid_part(const SolidSpec& solid, const Theme& theme, int segments, double body_reach) {
  Placement place = Placement::Identity();
  place.linear() = from_xyz_turns(solid.turn);
  place.translation() = solid.at;
  // a chord's distance from its arc goes with the radius over the square of the pieces
  const double size = body_reach > 0.0 ? reach_of(solid_mesh(solid, kCoarse)) / body_reach : 1.0;
  const double pieces = std::ceil(segments * std::sqrt(std::min(1.0, size)));
  LookPart part = painted(solid_mesh(solid, std::max(kCoarse, static_cast<int>(pieces))),
                          place,
                          solid.color ? color_from_hex(*solid.color) : theme.body,
                          theme);
  part.material.turned = is_round(solid);
  return part;
}

// Paints one strip on a body of several parts. A strip on each, in its own coordinates, would point
// a different way on each, and would be nothing but stripes on thin ones, which show by themselves
// how the body turns. The widest part leads; those about the same axis that are broad enough carry
// the same strip, and the rest none.
void share_mark(std::vector<LookPart>& look) {
  const LookPart& widest =
      *std::max_element(look.begin(), look.end(), [](const LookPart& a, const LookPart& b) {
        return reach_from_axis(*a.mesh) < reach_from_axis(*b.mesh);
      });
  const Placement lead_from_body = widest.body_from_mesh.inverse();
  double reach = 0.0;
  for (const Vec3& point : points_of(look))
    reach = std::max(reach, (lead_from_body * point).head<2>().norm());
  const double width = kMarkOfReach * reach;
  for (LookPart& part : look) {
    const bool marked =
        marks_meet(lead_from_body * part.body_from_mesh, width) && width <= widest_mark(*part.mesh);
    part.material.mark_width = marked ? static_cast<float>(width) : 0.0f;
  }
}

// the homogeneous ellipsoid with these mass properties: a1^2 = 5 (I2 + I3 - I1) / (2 m)
LookPart inertia_ellipsoid(const BodyModel& model, const Theme& theme, int segments) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(model.body.tensor);
  const bool diagonal = Mat3(model.body.tensor.diagonal().asDiagonal()) == model.body.tensor;
  const Vec3 moments = diagonal ? Vec3(model.body.tensor.diagonal()) : solver.eigenvalues();
  Vec3 axes;
  for (int i = 0; i < 3; ++i) {
    const double square =
        2.5 * (moments[(i + 1) % 3] + moments[(i + 2) % 3] - moments[i]) / model.body.mass;
    axes[i] = std::sqrt(std::max(square, 0.0));
  }
  // a moment set that no body has, or a flat one, still gets some thickness
  axes = axes.cwiseMax(kFlattest * axes.maxCoeff());

  Placement place = Placement::Identity();
  place.translation() = model.body.center;
  if (!diagonal) {
    Mat3 R = solver.eigenvectors();
    if (R.determinant() < 0.0) R.col(0) = -R.col(0);
    place.linear() = R;
  }
  return painted(scaled(unit_sphere(segments), axes), place, theme.body, theme);
}

// balls, and thin rods from the centre of mass to them
std::vector<LookPart> points_look(const BodySpec& spec,
                                  const BodyModel& model,
                                  const Theme& theme,
                                  int segments) {
  double reach = 0.0;
  double heaviest = 0.0;
  for (const PointSpec& point : spec.points) {
    reach = std::max(reach, (point.at - model.body.center).norm());
    heaviest = std::max(heaviest, point.m);
  }
  // one ball and one rod, placed as often as needed
  const int fine = std::max(kCoarse, static_cast<int>(0.36 * segments));  // balls are small
  LookPart ball = painted(unit_sphere(fine), Placement::Identity(), theme.body, theme);
  ball.material.turned = true;
  LookPart rod = painted(unit_cylinder(fine), Placement::Identity(), theme.stand, theme);
  rod.material.mark_width = 0.0f;
  std::vector<LookPart> look;
  for (const PointSpec& point : spec.points) {
    const Vec3 arm = point.at - model.body.center;
    const double radius = 0.13 * reach * std::cbrt(point.m / heaviest);
    ball.body_from_mesh = Placement::Identity();
    ball.body_from_mesh.translation() = point.at;
    ball.body_from_mesh.linear() *= radius;
    ball.breadth = 2.0 * radius;
    look.push_back(ball);
    if (arm.norm() < radius) continue;
    rod.body_from_mesh.translation() = model.body.center;
    rod.body_from_mesh.linear() = turn_between(Vec3::UnitZ(), arm).toRotationMatrix() *
                                  Vec3(0.025 * reach, 0.025 * reach, arm.norm()).asDiagonal();
    rod.breadth = 0.05 * reach;
    look.push_back(rod);
  }
  return look;
}

}  // namespace

Mesh solid_mesh(const SolidSpec& s, int segments) {
  // what is thinner about its axis than it is long needs fewer pieces there
  const auto thinner = [segments](double radius, double reach) {
    return std::max(kCoarse, static_cast<int>(std::ceil(segments * std::sqrt(radius / reach))));
  };
  if (s.kind == "box") return box(*s.size);
  if (s.kind == "sphere") return scaled(unit_sphere(segments), Vec3::Constant(*s.radius));
  if (s.kind == "ellipsoid") {
    const Vec3& a = *s.semi_axes;
    const int around = std::min(segments, thinner(std::max(a.x(), a.y()), a.maxCoeff()));
    return scaled(unit_sphere(segments, around), a);
  }
  if (s.kind == "cylinder") {
    const int around = thinner(*s.radius, std::hypot(*s.radius, 0.5 * *s.height));
    return cylinder_mesh(*s.radius, *s.height, around);
  }
  if (s.kind == "cone") {
    const int around = thinner(*s.radius, std::hypot(*s.radius, *s.height));
    return revolved({{0, 0}, {*s.radius, *s.height}, {0, *s.height}}, around);
  }
  if (s.kind == "disc") {
    const double thickness = std::max(s.thickness.value_or(0.0), kThinDisc * *s.radius);
    return cylinder_mesh(*s.radius, thickness, segments);
  }
  if (s.kind == "ring") {
    return torus(*s.radius, std::max(s.tube.value_or(0.0), kThinRing * *s.radius), segments);
  }
  if (s.kind == "rod") {
    const double radius = std::max(s.radius.value_or(0.0), kThinRod * *s.length);
    const double reach = std::hypot(radius, 0.5 * *s.length);
    return cylinder_mesh(radius, *s.length, thinner(radius, reach));
  }
  if (s.kind == "mesh") return faceted(*s.mesh);
  CHECK(s.kind == "lathe");
  const std::vector<Vec2> outline = upwards(lathe_outline(s));
  double radius = 0.0, reach = 0.0;
  for (const Vec2& point : outline) {
    radius = std::max(radius, point.x());
    reach = std::max(reach, point.norm());
  }
  // as far off as the pieces of its circles
  const double tolerance = reach * (1.0 - std::cos(kPi / segments));
  return revolved(simplified(outline, tolerance), thinner(radius, reach));
}

std::vector<LookPart> body_look(const BodySpec& spec,
                                const BodyModel& model,
                                const Theme& theme,
                                int segments) {
  if (spec.look) {
    check_dimensions(*spec.look, "body.look");
    if (spec.look->mass || spec.look->density) {
      throw input_error("a look has no mass; the mass is given by the other keys of [body]")
          .at({{}, 0, spec.look->mass ? "body.look.mass" : "body.look.density"});
    }
    return {solid_part(*spec.look, theme, segments, 0.0)};
  }
  if (!spec.points.empty()) return points_look(spec, model, theme, segments);
  if (spec.solid) return {solid_part(*spec.solid, theme, segments, 0.0)};
  if (spec.parts.empty()) return {inertia_ellipsoid(model, theme, segments)};
  // a rough look tells how large the body is, and so how fine each part must be
  std::vector<LookPart> rough, look;
  for (const SolidSpec& part : spec.parts)
    rough.push_back(solid_part(part, theme, kCoarse, 0.0));
  const double reach = body_radius(rough, model);
  for (const SolidSpec& part : spec.parts)
    look.push_back(solid_part(part, theme, segments, reach));
  share_mark(look);
  return look;
}

std::vector<Vec3> hull_of(const std::vector<LookPart>& look) {
  // directions spread evenly over the sphere (Fibonacci's lattice)
  constexpr int kDirections = 500;
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  Eigen::Matrix<double, kDirections, 3> directions;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections;
    const double across = std::sqrt(1.0 - z * z);
    directions.row(i) << across * std::cos(golden * i), across * std::sin(golden * i), z;
  }
  const std::vector<Vec3> points = points_of(look);
  std::vector<double> farthest(kDirections, -std::numeric_limits<double>::infinity());
  std::vector<Vec3> hull(kDirections, Vec3::Zero());
  for (const Vec3& point : points) {
    const Eigen::Matrix<double, kDirections, 1> reach = directions * point;
    for (int i = 0; i < kDirections; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (reach[i] <= farthest[k]) continue;
      farthest[k] = reach[i];
      hull[k] = point;
    }
  }
  return hull;
}

std::vector<Vec3> points_of(const std::vector<LookPart>& look) {
  std::vector<Vec3> points;
  for (const LookPart& part : look) {
    for (const Vertex& vertex : part.mesh->vertices) {
      points.push_back(part.body_from_mesh * to_eigen(vertex.position));
    }
  }
  return points;
}

double body_radius(const std::vector<LookPart>& look, const BodyModel& model) {
  double radius = 0.0;
  for (const Vec3& point : points_of(look)) {
    radius = std::max(radius, (point - model.reference_B()).norm());
  }
  return radius;
}

}  // namespace polhode
