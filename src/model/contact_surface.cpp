// SPDX-License-Identifier: MIT
#include "model/contact_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/at_place.h"
#include "base/check.h"
#include "base/error.h"
#include "math/so3.h"
#include "model/given_keys.h"
#include "model/solids.h"

namespace polhode {
namespace {

// a point of an outline: a circle about z, or on the axis a tip
SurfacePiece circle(double radius, double z) {
  SurfacePiece piece;
  piece.ring = radius;
  piece.center_P = Vec3(0, 0, z);
  return piece;
}

// the corners of the convex hull of an outline and of its mirror image (Andrew, Inf. Process. Lett.
// 9 (1979) 216), from the lowest on the axis to the highest
std::vector<Vec2> hull_of_outline(std::vector<Vec2> outline) {
  std::sort(outline.begin(), outline.end(), [](const Vec2& a, const Vec2& b) {
    return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
  });
  // flat ends reach to the axis: of the lowest and the highest points the outermost counts
  std::vector<Vec2> hull = {Vec2(0.0, outline.front().y())};
  outline.emplace_back(0.0, outline.back().y());
  for (const Vec2& p : outline) {
    while (hull.size() > 1) {
      const Vec2 edge = hull.back() - hull[hull.size() - 2], next = p - hull.back();
      if (edge.x() * next.y() - edge.y() * next.x() > 0.0) break;
      hull.pop_back();
    }
    hull.push_back(p);
  }
  return hull;
}

// The direction of a curve and its radius of curvature.
struct Bend {
  Vec2 along;     // unit
  double radius;  // m; negative: it bends to the right
};

// of the circle through three points of a curve, in order, at one of them
Bend bend_at(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& place) {
  const Vec2 u = b - a, v = c - b, w = c - a;
  const double size = u.norm() * v.norm() * w.norm();
  const double curvature = size > 0.0 ? 2.0 * (u.x() * v.y() - u.y() * v.x()) / size : 0.0;
  // at b the tangent, and from there it turns by twice the angle of the chord
  const Vec2 at_b = (u / u.squaredNorm() + v / v.squaredNorm()).normalized();
  const double half = std::asin(std::clamp(0.5 * (place - b).norm() * curvature, -1.0, 1.0));
  const double turn = (place - b).dot(at_b) < 0.0 ? -2.0 * half : 2.0 * half;
  const Vec2 along(std::cos(turn) * at_b.x() - std::sin(turn) * at_b.y(),
                   std::sin(turn) * at_b.x() + std::cos(turn) * at_b.y());
  return {along, curvature != 0.0 ? 1.0 / curvature : std::numeric_limits<double>::infinity()};
}

// Smooth parts of the convex hull of a smooth outline, and its corners. The curve of three or more
// neighbours is smooth; where the hull leaves the outline, another part begins.
std::vector<SurfacePiece> smooth_parts_of(const std::vector<Vec2>& outline) {
  const auto index_of = [&](const Vec2& p) {
    return std::find(outline.begin(), outline.end(), p) - outline.begin();
  };
  std::vector<SurfacePiece> pieces;
  std::vector<Vec2> part;
  const auto end_part = [&] {
    if (part.size() >= 3) {
      SurfacePiece piece;
      piece.outline = std::make_shared<const SmoothOutline>(part);
      pieces.push_back(piece);
    } else {
      for (const Vec2& p : part)
        pieces.push_back(circle(p.x(), p.y()));
    }
    part.clear();
  };
  for (const Vec2& p : hull_of_outline(outline)) {
    const std::ptrdiff_t here = index_of(p);
    // the middle of a flat end is no point of the outline
    if (here == static_cast<std::ptrdiff_t>(outline.size())) continue;
    if (!part.empty() && std::abs(here - index_of(part.back())) != 1) end_part();
    part.push_back(p);
  }
  end_part();
  return pieces;
}

// the corners of a solid of revolution as circles and tips
std::vector<SurfacePiece> edges_of(const std::vector<Vec2>& outline) {
  const std::vector<Vec2> hull = hull_of_outline(outline);
  std::vector<SurfacePiece> pieces;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    // the middle of a flat end is no corner
    const bool on_axis = hull[i].x() == 0.0;
    if (on_axis && ((i == 0 && hull.size() > 1 && hull[1].y() == hull[0].y()) ||
                    (i + 1 == hull.size() && i > 0 && hull[i - 1].y() == hull[i].y())))
      continue;
    SurfacePiece piece = circle(hull[i].x(), hull[i].y());
    pieces.push_back(piece);
  }
  return pieces;
}

SurfacePiece ball(double radius) {
  SurfacePiece piece;
  piece.ball = radius;
  return piece;
}

std::vector<SurfacePiece> cylinder_edges(double radius, double height) {
  if (height == 0.0) return {circle(radius, 0.0)};
  return {circle(radius, -0.5 * height), circle(radius, 0.5 * height)};
}

// in the solid's own frame; empty for solids with flat facets
std::vector<SurfacePiece> pieces_of(const SolidSpec& s) {
  if (s.kind == "sphere") return {ball(*s.radius)};
  if (s.kind == "ellipsoid") {
    SurfacePiece piece;
    piece.semi_axes = *s.semi_axes;
    return {piece};
  }
  if (s.kind == "disc") return cylinder_edges(*s.radius, s.thickness.value_or(0.0));
  if (s.kind == "cylinder") return cylinder_edges(*s.radius, *s.height);
  if (s.kind == "rod") return cylinder_edges(s.radius.value_or(0.0), *s.length);
  if (s.kind == "cone") return {circle(0.0, 0.0), circle(*s.radius, *s.height)};
  if (s.kind == "ring") {
    SurfacePiece torus = circle(*s.radius, 0.0);
    torus.ball = s.tube.value_or(0.0);
    return {torus};
  }
  if (s.kind == "lathe") return s.smooth ? smooth_parts_of(s.profile) : edges_of(s.profile);
  return {};
}

}  // namespace

SmoothOutline::SmoothOutline(const std::vector<Vec2>& points) {
  CHECK(points.size() >= 3);
  constexpr double kLeastTurn = 1e-9;  // rad
  const std::size_t n = points.size();
  const auto mirrored = [](const Vec2& p) {
    return Vec2(-p.x(), p.y());
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& p = points[i];
    reach_ = std::max(reach_, p.norm());
    // of the ends those on the axis have their mirror image for a neighbour
    const std::size_t middle = std::clamp<std::size_t>(i, 1, n - 2);
    Bend bend = bend_at(points[middle - 1], points[middle], points[middle + 1], p);
    if (i == 0 && p.x() == 0.0) bend = bend_at(mirrored(points[1]), p, points[1], p);
    if (i + 1 == n && p.x() == 0.0) bend = bend_at(points[n - 2], p, mirrored(points[n - 2]), p);
    // outwards is to the right of the curve
    const Vec2 out(bend.along.y(), -bend.along.x());
    Node node;
    node.angle = std::atan2(out.y(), out.x());
    node.h = p.dot(out);
    node.slope = p.dot(bend.along);
    node.bend = bend.radius - node.h;
    const bool turns = nodes_.empty() || node.angle > nodes_.back().angle + kLeastTurn;
    if (turns && bend.radius > 0.0 && std::isfinite(bend.radius)) nodes_.push_back(node);
  }
  const auto refuse = [](double r, double z) {
    throw input_error(
        "the smooth outline is too uneven near ({:.3g}, {:.3g}) to roll on; give its points at "
        "more even distances",
        r,
        z);
  };
  if (nodes_.size() < 2) refuse(points.front().x(), points.front().y());
  // convex between nodes too
  constexpr int kLooks = 4;
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
    for (int k = 1; k < kLooks; ++k) {
      const double part = static_cast<double>(k) / kLooks;
      const Point p = at(nodes_[i].angle + part * (nodes_[i + 1].angle - nodes_[i].angle));
      if (!(p.curvature > 0.0)) refuse(p.r, p.z);
    }
  }
}

double SmoothOutline::support(double angle) const {
  const Point p = at(angle);
  return p.r * std::cos(angle) + p.z * std::sin(angle);
}

SmoothOutline::Point SmoothOutline::at(double angle) const {
  const double inside = std::clamp(angle, nodes_.front().angle, nodes_.back().angle);
  auto above = std::upper_bound(
      nodes_.begin() + 1, nodes_.end() - 1, inside, [](double x, const Node& node) {
        return x < node.angle;
      });
  const Node &a = *(above - 1), &b = *above;
  // h = a0 + a1 x + ... + a5 x^5 in x = 0..1
  const double d = b.angle - a.angle, x = (inside - a.angle) / d;
  const double a0 = a.h, a1 = d * a.slope, a2 = 0.5 * d * d * a.bend;
  const double p = b.h - a0 - a1 - a2, q = d * b.slope - a1 - 2.0 * a2;
  const double r = d * d * b.bend - 2.0 * a2;
  const double a3 = 10.0 * p - 4.0 * q + 0.5 * r, a4 = -15.0 * p + 7.0 * q - r;
  const double a5 = 6.0 * p - 3.0 * q + 0.5 * r;
  const double h = a0 + x * (a1 + x * (a2 + x * (a3 + x * (a4 + x * a5))));
  const double slope = (a1 + x * (2.0 * a2 + x * (3.0 * a3 + x * (4.0 * a4 + x * 5.0 * a5)))) / d;
  const double bend = (2.0 * a2 + x * (6.0 * a3 + x * (12.0 * a4 + x * 20.0 * a5))) / (d * d);
  const double c = std::cos(inside), s = std::sin(inside);
  // a corner turns on the spot
  return {h * c - slope * s, h * s + slope * c, inside == angle ? h + bend : 0.0};
}

ContactSurface::ContactSurface(std::vector<SurfacePiece> pieces) : pieces_(std::move(pieces)) {
  CHECK(!pieces_.empty());
  for (const SurfacePiece& piece : pieces_) {
    const double size = piece.semi_axes.maxCoeff() + piece.ring + piece.ball +
                        (piece.outline ? piece.outline->reach() : 0.0);
    reach_ = std::max(reach_, piece.center_P.norm() + size);
  }
}

double ContactSurface::support(const Vec3& down_P, const SurfacePiece& piece) const {
  double sum = down_P.dot(piece.center_P) + piece.ball;
  if (piece.ring == 0.0 && piece.semi_axes.x() == 0.0 && !piece.outline) return sum;
  const Vec3 d = piece.R_PD.transpose() * down_P;
  if (piece.outline)
    return sum + piece.outline->support(std::atan2(d.z(), std::hypot(d.x(), d.y())));
  if (piece.ring > 0.0) sum += piece.ring * std::hypot(d.x(), d.y());
  return sum + piece.semi_axes.cwiseProduct(d).norm();
}

int ContactSurface::lowest(const Vec3& down_P) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < pieces_.size(); ++i) {
    if (support(down_P, pieces_[i]) > support(down_P, pieces_[best])) best = i;
  }
  return static_cast<int>(best);
}

SurfacePoint ContactSurface::at(const Vec3& down_P, const Vec3& down_rate_P, int piece) const {
  const SurfacePiece& p = pieces_[static_cast<std::size_t>(piece)];
  SurfacePoint point;
  point.arm_P = p.center_P + p.ball * down_P;
  point.arm_rate_P = p.ball * down_rate_P;
  point.height = down_P.dot(p.center_P) + p.ball;
  const bool is_ellipsoid = p.semi_axes.x() > 0.0;
  if (p.ring == 0.0 && !is_ellipsoid && !p.outline) return point;

  const Vec3 d = p.R_PD.transpose() * down_P;
  const Vec3 rate = p.R_PD.transpose() * down_rate_P;
  const double across = std::sqrt(d.x() * d.x() + d.y() * d.y());
  const Vec3 out = across > 0.0 ? Vec3(d.x() / across, d.y() / across, 0.0) : Vec3(1, 0, 0);
  const Vec3 along(-out.y(), out.x(), 0.0);
  if (p.outline) {
    constexpr double kAtAxis = 1e-9;
    const SmoothOutline::Point here = p.outline->at(std::atan2(d.z(), across));
    // in the plane through the axis, and around it; on the axis both radii are one
    const Vec3 up = across * Vec3::UnitZ() - d.z() * out;
    const double around = across > kAtAxis ? here.r / across : here.curvature;
    point.arm_P += p.R_PD * (here.r * out + here.z * Vec3::UnitZ());
    point.arm_rate_P +=
        p.R_PD * (here.curvature * up.dot(rate) * up + around * along.dot(rate) * along);
    point.height += here.r * across + here.z * d.z();
  }
  if (p.ring > 0.0) {
    point.arm_P += p.R_PD * (p.ring * out);
    if (across > 0.0) point.arm_rate_P += p.R_PD * (p.ring / across * along.dot(rate) * along);
    point.height += p.ring * across;
  }
  if (is_ellipsoid) {
    const Vec3 squares = p.semi_axes.cwiseProduct(p.semi_axes);
    const Vec3 scaled = squares.cwiseProduct(d);
    const double size = std::sqrt(scaled.dot(d));
    point.arm_P += p.R_PD * (scaled / size);
    point.arm_rate_P += p.R_PD * (squares.cwiseProduct(rate) / size -
                                  scaled.dot(rate) / (size * size * size) * scaled);
    point.height += size;
  }
  return point;
}

double ContactSurface::height(const Vec3& down_P, int piece) const {
  return support(down_P, pieces_[static_cast<std::size_t>(piece)]);
}

double ContactSurface::clearance(const Vec3& down_P, int piece) const {
  const double here = height(down_P, piece);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (static_cast<int>(i) == piece) continue;
    least = std::min(least, here - support(down_P, pieces_[i]));
  }
  return least;
}

double ContactSurface::tilt_of_face(const Vec3& down_P, int piece) const {
  const SurfacePiece& p = pieces_[static_cast<std::size_t>(piece)];
  if (p.ring == 0.0) return 1.0;
  return down_P.cross(p.R_PD.col(2)).norm();
}

const SurfacePiece* ContactSurface::as_sphere() const {
  const SurfacePiece& p = pieces_.front();
  const bool round = pieces_.size() == 1 && p.ring == 0.0 && p.semi_axes.isZero(0.0) && !p.outline;
  return round ? &p : nullptr;
}

std::shared_ptr<const ContactSurface> make_contact_surface(const BodySpec& spec,
                                                           const MassProperties& body,
                                                           const Mat3& R_BP) {
  std::vector<SurfacePiece> all;
  int solids = 0;
  const auto add = [&](const SolidSpec& solid, const std::string& path) {
    check_dimensions(solid, path);
    const std::vector<SurfacePiece> own =
        at_place({{}, 0, path + ".profile"}, [&] { return pieces_of(solid); });
    if (own.empty()) {
      throw input_error(
          "{} has facets, on which no body rolls: it lies on them; on a table take a solid "
          "without them, such as sphere, ellipsoid, disc, ring or lathe (body.look gives the "
          "surface, where the mass is given otherwise)",
          with_article(solid.kind))
          .at({{}, 0, path + ".kind"});
    }
    const Mat3 R_BD = from_xyz_turns(solid.turn);
    for (SurfacePiece piece : own) {
      piece.name = solid.kind;
      piece.solid = solids;
      piece.center_P = R_BP.transpose() * (R_BD * piece.center_P + solid.at - body.center);
      piece.R_PD = R_BP.transpose() * R_BD;
      all.push_back(std::move(piece));
    }
    ++solids;
  };
  if (spec.look) {
    add(*spec.look, "body.look");
  } else if (spec.solid) {
    add(*spec.solid, "body.solid");
  } else if (!spec.parts.empty()) {
    for (std::size_t i = 0; i < spec.parts.size(); ++i)
      add(spec.parts[i], fmt::format("body.parts[{}]", i));
  } else {
    throw input_error(
        "moments, a tensor or points say nothing of the surface that touches the table; give it "
        "with body.look, such as look = {{ kind = \"sphere\", radius = 0.02 }}")
        .at({{}, 0, "motion.hold"});
  }
  return std::make_shared<const ContactSurface>(std::move(all));
}

}  // namespace polhode
