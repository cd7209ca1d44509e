// SPDX-License-Identifier: MIT
#include "frame/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include <glm/common.hpp>

#include "base/units.h"

namespace polhode {
namespace {

// unit normal of an outline edge, to the right of its direction: outwards
Vec2 edge_normal(const Vec2& from, const Vec2& to) {
  const Vec2 edge = to - from;
  return Vec2(edge.y(), -edge.x()).normalized();
}

// the normal at one end of an edge: shared with the neighbour where the surface is smooth
Vec2 shaded_normal(const Vec2& own, const Vec2* neighbour, double crease) {
  if (neighbour == nullptr || own.dot(*neighbour) < std::cos(crease)) return own;
  return (own + *neighbour).normalized();
}

// Corners stand as far outside of a circle as the middles of chords lie inside: half a sagitta.
double halfway_out(double angle_of_piece) {
  return 2.0 / (1.0 + std::cos(0.5 * angle_of_piece));
}

std::vector<Vec2> arc(double radius, double center_r, double from, double to, int pieces) {
  const double drawn = radius * halfway_out((to - from) / pieces);
  std::vector<Vec2> points;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = from + (to - from) * i / pieces;
    points.emplace_back(center_r + drawn * std::cos(angle), drawn * std::sin(angle));
  }
  return points;
}

// A circle of corners on a sphere; a pole is one corner and has no pieces.
struct Latitude {
  std::uint32_t first = 0;
  int pieces = 0;
  std::uint32_t corner(int piece) const {
    return first + (pieces > 0 ? static_cast<std::uint32_t>(piece % pieces) : 0);
  }
};

Latitude add_pole(Mesh& mesh, double z) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({glm::vec3(0.0, 0.0, z), glm::vec3(0.0, 0.0, z > 0.0 ? 1.0 : -1.0)});
  return {first, 0};
}

Latitude add_latitude(Mesh& mesh, double latitude, int pieces, double out) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const double z = std::sin(latitude);
  const double r = std::cos(latitude);
  const double out_around = out * halfway_out(2.0 * kPi / pieces);
  for (int k = 0; k < pieces; ++k) {
    const double angle = 2.0 * kPi * k / pieces;
    const glm::vec3 normal(r * std::cos(angle), r * std::sin(angle), z);
    mesh.vertices.push_back({normal * glm::vec3(out_around, out_around, out), normal});
  }
  return {first, pieces};
}

// the triangles between two circles: the one whose next corner comes first goes on
void sew(Mesh& mesh, const Latitude& low, const Latitude& high) {
  int a = 0, b = 0;  // pieces done
  while (a < low.pieces || b < high.pieces) {
    const bool low_goes_on =
        b == high.pieces || (a < low.pieces && (a + 1) * high.pieces <= (b + 1) * low.pieces);
    const std::uint32_t at_low = low.corner(a);
    const std::uint32_t at_high = high.corner(b);
    const std::uint32_t next = low_goes_on ? low.corner(++a) : high.corner(++b);
    mesh.indices.insert(mesh.indices.end(), {at_low, next, at_high});
  }
}

}  // namespace

int circle_segments(double radius_px) {
  constexpr double kSagitta = 0.5;  // pixels; half of it inside, half outside
  constexpr int kFewest = 8;
  constexpr double kLargest = 1e5;  // nothing is drawn larger
  if (radius_px <= kSagitta) return kFewest;
  const int needed =
      static_cast<int>(std::ceil(kPi / std::acos(1.0 - kSagitta / std::min(radius_px, kLargest))));
  return std::max(kFewest, needed);
}

Mesh revolved(const std::vector<Vec2>& outline, int segments, double crease) {
  Mesh mesh;
  std::vector<Vec2> points;
  for (const Vec2& p : outline) {
    if (points.empty() || (p - points.back()).norm() > 0.0) points.push_back(p);
  }
  const bool closed = points.size() > 2 && (points.front() - points.back()).norm() == 0.0;
  std::vector<Vec2> normals;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    normals.push_back(edge_normal(points[i], points[i + 1]));
  }

  // a circle of corners; its number
  const double out = halfway_out(2.0 * kPi / segments);
  const auto add_circle = [&](const Vec2& p, const Vec2& n) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k <= segments; ++k) {
      const double angle = 2.0 * kPi * (k % segments) / segments;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      mesh.vertices.push_back({glm::vec3(out * p.x() * c, out * p.x() * s, p.y()),
                               glm::vec3(n.x() * c, n.x() * s, n.y())});
    }
    return first;
  };
  std::uint32_t high = 0;
  Vec2 normal_high = Vec2::Zero();
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vec2* before = i > 0 ? &normals[i - 1] : closed ? &normals.back() : nullptr;
    const Vec2* after = i + 1 < normals.size() ? &normals[i + 1]
                        : closed               ? &normals.front()
                                               : nullptr;
    // a band of quads; those that touch the axis are triangles. Where shading goes on, it begins
    // with the corners at which the last one ended.
    const Vec2 normal_low = shaded_normal(normals[i], before, crease);
    const bool goes_on = i > 0 && (normal_low - normal_high).norm() < 1e-12;
    const std::uint32_t low = goes_on ? high : add_circle(points[i], normal_low);
    normal_high = shaded_normal(normals[i], after, crease);
    high = add_circle(points[i + 1], normal_high);
    for (int k = 0; k < segments; ++k) {
      const std::uint32_t a = low + static_cast<std::uint32_t>(k);
      const std::uint32_t b = high + static_cast<std::uint32_t>(k);
      if (points[i].x() > 0.0) mesh.indices.insert(mesh.indices.end(), {a, a + 1, b});
      if (points[i + 1].x() > 0.0) mesh.indices.insert(mesh.indices.end(), {b, a + 1, b + 1});
    }
  }
  return mesh;
}

Mesh unit_sphere(int segments, int most_around) {
  Mesh mesh;
  const int bands = std::max(8, segments / 2);
  Latitude low = add_pole(mesh, -halfway_out(kPi / bands));
  for (int i = 1; i <= bands; ++i) {
    const double angle = kPi * i / bands;  // from the lower pole
    const int pieces = static_cast<int>(std::ceil(segments * std::sin(angle)));
    const Latitude high = i == bands ? add_pole(mesh, halfway_out(kPi / bands))
                                     : add_latitude(mesh,
                                                    angle - 0.5 * kPi,
                                                    std::clamp(pieces, 8, std::max(8, most_around)),
                                                    halfway_out(kPi / bands));
    sew(mesh, low, high);
    low = high;
  }
  return mesh;
}

Mesh unit_sphere(int segments) {
  return unit_sphere(segments, segments);
}

Mesh unit_cylinder(int segments) {
  return revolved({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, segments);
}

Mesh unit_cone(int segments) {
  return revolved({{0, 0}, {1, 0}, {0, 1}}, segments);
}

Mesh unit_disc(int segments) {
  Mesh mesh;
  mesh.vertices.push_back({{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}});
  const double out = halfway_out(2.0 * kPi / segments);
  for (int k = 0; k < segments; ++k) {
    const double angle = 2.0 * kPi * k / segments;
    mesh.vertices.push_back(
        {glm::vec3(out * std::cos(angle), out * std::sin(angle), 0.0), {0.0f, 0.0f, 1.0f}});
    const auto here = static_cast<std::uint32_t>(k + 1);
    const auto next = static_cast<std::uint32_t>((k + 1) % segments + 1);
    for (const std::uint32_t corner : {0u, here, next})
      mesh.indices.push_back(corner);
  }
  return mesh;
}

namespace {

// of lines on a floor of radius 1, which fade as it does
float strength_of_lines(const Vec2& p) {
  const double out = std::clamp(2.0 * p.norm() - 1.0, 0.0, 1.0);
  return static_cast<float>(1.0 - out * out * (3.0 - 2.0 * out));
}

// a strip between corners, each with the strength of the line there, dense on its middle and gone
// at its sides
void add_strip(const std::array<Vec2, 3>& from,
               const std::array<Vec2, 3>& to,
               float strength_from,
               float strength_to,
               Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const std::array<Vec2, 3>* end : {&from, &to}) {
    const float strength = end == &from ? strength_from : strength_to;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& p = (*end)[i];
      mesh.vertices.push_back(
          {glm::vec3(p.x(), p.y(), 0.0), {0.0f, 0.0f, i == 1 ? strength : 0.0f}});
    }
  }
  for (const std::uint32_t side : {first, first + 1})
    mesh.indices.insert(mesh.indices.end(), {side, side + 1, side + 4, side, side + 4, side + 3});
}

constexpr int kPiecesOfLine = 24;  // on a floor, along which it fades

// a straight line on a floor
void add_line(const Vec2& from, const Vec2& to, double half_width, Mesh& mesh) {
  const Vec2 along = (to - from).normalized(), aside = half_width * Vec2(-along.y(), along.x());
  for (int i = 0; i < kPiecesOfLine; ++i) {
    const Vec2 here = from + (to - from) * i / kPiecesOfLine;
    const Vec2 next = from + (to - from) * (i + 1) / kPiecesOfLine;
    add_strip({here + aside, here, here - aside},
              {next + aside, next, next - aside},
              strength_of_lines(here),
              strength_of_lines(next),
              mesh);
  }
}

// how far it is from a point inside the unit circle to that circle
double way_to_rim(const Vec2& from, const Vec2& along) {
  const double inwards = -along.dot(from);
  return inwards + std::sqrt(inwards * inwards + 1.0 - from.squaredNorm());
}

// the unit vector at an angle from +x
Vec2 ray(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Mesh dial(int segments, double half_width) {
  constexpr int kTicks = 12;
  constexpr double kShort = 0.05, kLong = 0.11;
  Mesh mesh;
  for (int k = 0; k < segments; ++k) {
    const Vec2 here = ray(2.0 * kPi * k / segments), next = ray(2.0 * kPi * (k + 1) / segments);
    const double in = 1.0 - half_width, out = 1.0 + half_width;
    add_strip({in * here, here, out * here}, {in * next, next, out * next}, 1.0f, 1.0f, mesh);
  }
  for (int k = 0; k < kTicks; ++k) {
    const Vec2 along = ray(2.0 * kPi * k / kTicks);
    const Vec2 aside = half_width * Vec2(-along.y(), along.x());
    const Vec2 from = (1.0 - (k % 3 == 0 ? kLong : kShort)) * along;
    add_strip({from + aside, from, from - aside},
              {along + aside, along, along - aside},
              1.0f,
              1.0f,
              mesh);
  }
  return mesh;
}

Mesh floor_sector(const Vec2& tip, double angle, double half_angle) {
  Mesh mesh;
  for (const double side : {-half_angle, half_angle}) {
    const Vec2 along = ray(angle + side);
    const double reach = way_to_rim(tip, along);
    for (int i = 0; i <= kPiecesOfLine; ++i) {
      const Vec2 p = tip + reach * i / kPiecesOfLine * along;
      mesh.vertices.push_back({glm::vec3(p.x(), p.y(), 0.0), {0.0f, 0.0f, strength_of_lines(p)}});
    }
  }
  for (std::uint32_t i = 0; i < kPiecesOfLine; ++i) {
    const std::uint32_t other = i + kPiecesOfLine + 1;
    mesh.indices.insert(mesh.indices.end(), {i, i + 1, other + 1, i, other + 1, other});
  }
  return mesh;
}

Mesh floor_grid(const Vec2& through, double angle, double spacing, double half_width) {
  Mesh mesh;
  for (const double turn : {angle, angle + 0.5 * kPi}) {
    const Vec2 along = ray(turn), across(-along.y(), along.x());
    const double offset = across.dot(through);
    for (double k = std::ceil((-1.0 - offset) / spacing); offset + k * spacing < 1.0; k += 1.0) {
      const double away = offset + k * spacing;
      const Vec2 half = std::sqrt(std::max(0.0, 1.0 - away * away)) * along;
      add_line(away * across - half, away * across + half, half_width, mesh);
    }
  }
  return mesh;
}

Mesh polar_floor_grid(const Vec2& center, double angle, double spacing, double half_width) {
  constexpr int kSpokes = 12;
  constexpr double kPiece = kPi / 72.0;  // of circles, rad
  const double away = center.norm();
  const double towards = std::atan2(-center.y(), -center.x());  // the middle of the floor
  Mesh mesh;
  for (double radius = spacing; radius < 1.0 + away; radius += spacing) {
    // the part of the circle that is on the floor
    const double beyond = (away * away + radius * radius - 1.0) / (2.0 * away * radius);
    const double half = radius <= 1.0 - away ? kPi : std::acos(std::clamp(beyond, -1.0, 1.0));
    const int pieces = std::max(1, static_cast<int>(std::ceil(2.0 * half / kPiece)));
    for (int i = 0; i < pieces; ++i) {
      const Vec2 here = ray(towards + half * (2.0 * i / pieces - 1.0));
      const Vec2 next = ray(towards + half * (2.0 * (i + 1) / pieces - 1.0));
      const auto across = [&](const Vec2& out) -> std::array<Vec2, 3> {
        return {center + (radius - half_width) * out,
                center + radius * out,
                center + (radius + half_width) * out};
      };
      add_strip(across(here),
                across(next),
                strength_of_lines(center + radius * here),
                strength_of_lines(center + radius * next),
                mesh);
    }
  }
  for (int k = 0; k < kSpokes; ++k) {
    const Vec2 along = ray(angle + 2.0 * kPi * k / kSpokes);
    const double reach = way_to_rim(center, along);
    if (reach > spacing)
      add_line(center + spacing * along, center + reach * along, half_width, mesh);
  }
  return mesh;
}

Mesh torus(double radius, double tube, int segments) {
  // around the tube as fine as along it: pieces grow with the root of the radius
  const int around = std::max(6, static_cast<int>(std::ceil(segments * std::sqrt(tube / radius))));
  std::vector<Vec2> outline = arc(tube, radius, 0.0, 2.0 * kPi, around);
  outline.back() = outline.front();
  return revolved(outline, segments, 0.5 * kPi);  // round, however few they are
}

Mesh unit_cone_shell(int segments) {
  return revolved({{0, 0}, {1, 1}}, segments);
}

Mesh box(const Vec3& size) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      // u x v points outwards
      const Vec3 n = side * Vec3::Unit(axis);
      const Vec3 u = Vec3::Unit((axis + 1) % 3);
      const Vec3 v = n.cross(u);
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        const Vec3 p = 0.5 * size.cwiseProduct(n + a * u + b * v);
        mesh.vertices.push_back({glm::vec3(p.x(), p.y(), p.z()), glm::vec3(n.x(), n.y(), n.z())});
      }
      mesh.indices.insert(mesh.indices.end(),
                          {first, first + 1, first + 2, first, first + 2, first + 3});
    }
  }
  return mesh;
}

Mesh faceted(const TriangleMesh& surface) {
  // area vectors of the faces, and the faces around each point
  std::vector<Vec3> areas;
  std::vector<std::vector<std::size_t>> around(surface.points.size());
  for (const std::array<int, 3>& corners : surface.triangles) {
    Vec3 p[3];
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = surface.points[static_cast<std::size_t>(corners[i])];
      around[static_cast<std::size_t>(corners[i])].push_back(areas.size());
    }
    areas.push_back((p[1] - p[0]).cross(p[2] - p[0]));
  }

  // every corner has its own normal: the mean over the faces that join its own smoothly
  const double least = std::cos(kCreaseAngle);
  Mesh mesh;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    for (const int corner : surface.triangles[t]) {
      Vec3 normal = Vec3::Zero();
      for (const std::size_t other : around[static_cast<std::size_t>(corner)]) {
        if (areas[t].dot(areas[other]) >= least * areas[t].norm() * areas[other].norm())
          normal += areas[other];
      }
      normal.normalize();
      const Vec3& p = surface.points[static_cast<std::size_t>(corner)];
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(
          {glm::vec3(p.x(), p.y(), p.z()), glm::vec3(normal.x(), normal.y(), normal.z())});
    }
  }
  return mesh;
}

Mesh clustered(const Mesh& mesh, int cells) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const Vertex& vertex : mesh.vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  const glm::vec3 size = glm::max(high - low, glm::vec3(std::numeric_limits<float>::min()));
  const auto last = static_cast<float>(cells - 1);

  Mesh out;
  std::map<std::array<int, 3>, std::uint32_t> first;  // vertex of `out` for each cell
  std::vector<std::uint32_t> number;                  // and for each vertex of `mesh`
  number.reserve(mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec3 at =
        glm::min((vertex.position - low) / size * static_cast<float>(cells), glm::vec3(last));
    const std::array<int, 3> cell{
        static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z)};
    const auto [found, is_new] =
        first.emplace(cell, static_cast<std::uint32_t>(out.vertices.size()));
    if (is_new) out.vertices.push_back(vertex);
    number.push_back(found->second);
  }
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t a = number[mesh.indices[i]];
    const std::uint32_t b = number[mesh.indices[i + 1]];
    const std::uint32_t c = number[mesh.indices[i + 2]];
    if (a != b && b != c && c != a) out.indices.insert(out.indices.end(), {a, b, c});
  }
  return out;
}

Mesh scaled(const Mesh& mesh, const Vec3& factors) {
  const glm::vec3 f(factors.x(), factors.y(), factors.z());
  Mesh out = mesh;
  for (Vertex& vertex : out.vertices) {
    vertex.position *= f;
    vertex.normal = glm::normalize(vertex.normal / f);
  }
  return out;
}

}  // namespace polhode
