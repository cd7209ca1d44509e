// SPDX-License-Identifier: MIT
#include "model/solids.h"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/nearest.h"
#include "base/units.h"
#include "math/so3.h"
#include "model/given_keys.h"

namespace polhode {
namespace {

MassProperties centered(const Vec3& moments) {
  return {1.0, Vec3::Zero(), moments.asDiagonal()};
}

MassProperties box(const SolidSpec& s) {
  const Vec3 q = s.size->cwiseProduct(*s.size) / 12.0;
  return centered({q.y() + q.z(), q.x() + q.z(), q.x() + q.y()});
}

MassProperties ellipsoid_with(const Vec3& semi_axes) {
  const Vec3 q = semi_axes.cwiseProduct(semi_axes) / 5.0;
  return centered({q.y() + q.z(), q.x() + q.z(), q.x() + q.y()});
}

// also disc (thin: height 0) and rod (thin: radius 0)
MassProperties cylinder_with(double radius, double height) {
  const double across = radius * radius / 4.0 + height * height / 12.0;
  return centered({across, across, radius * radius / 2.0});
}

// apex at the origin, base at z = height
MassProperties cone(const SolidSpec& s) {
  const double r2 = *s.radius * *s.radius;
  const double h = *s.height;
  const double across = 3.0 * (r2 / 20.0 + h * h / 80.0);
  return {1.0, Vec3(0, 0, 0.75 * h), Vec3(across, across, 0.3 * r2).asDiagonal()};
}

// a torus about z: distance R from the axis to the tube's centre, tube radius a
MassProperties ring(const SolidSpec& s) {
  const double R2 = *s.radius * *s.radius;
  const double a2 = std::pow(s.tube.value_or(0.0), 2);
  const double across = R2 / 2.0 + 5.0 * a2 / 8.0;
  return centered({across, across, R2 + 0.75 * a2});
}

// Integrals over the polygon between the outline and the axis; exact, because three Gauss points
// integrate the quartics along each edge exactly.
struct LatheIntegrals {
  double r2 = 0, r2z = 0, r2zz = 0, r4 = 0;  // of r^2, r^2 z, r^2 z^2, r^4 over z
};

LatheIntegrals integrate(const std::vector<Vec2>& profile) {
  const double offset = std::sqrt(0.15);
  const double nodes[] = {0.5 - offset, 0.5, 0.5 + offset};
  const double weights[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  LatheIntegrals sum;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const Vec2 edge = profile[i + 1] - profile[i];
    for (int k = 0; k < 3; ++k) {
      const Vec2 p = profile[i] + nodes[k] * edge;
      const double r2dz = weights[k] * p.x() * p.x() * edge.y();
      sum.r2 += r2dz;
      sum.r2z += r2dz * p.y();
      sum.r2zz += r2dz * p.y() * p.y();
      sum.r4 += r2dz * p.x() * p.x();
    }
  }
  return sum;
}

double lathe_volume(const SolidSpec& s) {
  return kPi * std::abs(integrate(lathe_outline(s)).r2);
}

// the same quotients serve an outline drawn upwards or downwards: the signs cancel
MassProperties lathe(const SolidSpec& s) {
  const LatheIntegrals sum = integrate(lathe_outline(s));
  const double z = sum.r2z / sum.r2;
  const double across = (sum.r4 / 4.0 + sum.r2zz) / sum.r2 - z * z;
  return {1.0, Vec3(0, 0, z), Vec3(across, across, sum.r4 / (2.0 * sum.r2)).asDiagonal()};
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// do the segments ab and cd have a point in common?
bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double side_c = cross(b - a, c - a), side_d = cross(b - a, d - a);
  const double side_a = cross(d - c, a - c), side_b = cross(d - c, b - c);
  if (side_c * side_d > 0.0 || side_a * side_b > 0.0) return false;
  // on one line they meet if their boxes do
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  return !apart(a.x(), b.x(), c.x(), d.x()) && !apart(a.y(), b.y(), c.y(), d.y());
}

// does the outline turn back on itself at b?
bool turns_back(const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(b - a, c - b) == 0.0 && (b - a).dot(c - b) < 0.0;
}

void check_profile(const std::vector<Vec2>& profile, const Place& place) {
  if (profile.size() < 2 || profile.size() > 2000) {
    throw input_error("needs 2 to 2000 points (radius, z), found {}", profile.size()).at(place);
  }
  for (const Vec2& p : profile) {
    if (p.x() < 0.0) throw input_error("radius must not be negative, got {}", p.x()).at(place);
  }

  double highest = 0.0;
  for (const Vec2& p : profile)
    highest = std::max(highest, p.cwiseAbs().maxCoeff());
  if (std::abs(integrate(profile).r2) <= 1e-12 * highest * highest * highest) {
    throw input_error("the outline encloses no volume; points are (radius, z)").at(place);
  }

  // the outline, closed through the axis if it does not close by itself, must not meet itself
  const bool closed = profile.front() == profile.back();
  std::vector<Vec2> outline;
  if (!closed) outline.emplace_back(0, profile.front().y());
  for (const Vec2& p : profile)
    if (outline.empty() || outline.back() != p) outline.push_back(p);
  if (!closed && outline.back().x() > 0.0) outline.emplace_back(0, profile.back().y());
  const auto refuse = [&](const Vec2& p) {
    throw input_error("the outline meets itself near ({}, {})", p.x(), p.y()).at(place);
  };
  const std::size_t edges = outline.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t next = i + 1 < edges ? i + 1 : 0;
    if ((next > 0 || closed) && turns_back(outline[i], outline[i + 1], outline[next + 1]))
      refuse(outline[i + 1]);
    for (std::size_t j = i + 2; j < edges; ++j) {
      if (closed && i == 0 && j + 1 == edges) continue;  // they join
      if (segments_meet(outline[i], outline[i + 1], outline[j], outline[j + 1]))
        refuse(outline[i + 1]);
    }
  }
}

double cylinder_volume(const SolidSpec& s) {
  return kPi * *s.radius * *s.radius * *s.height;
}

// the names of the dimensions that were given
std::vector<std::string> given_dimensions(const SolidSpec& s) {
  std::vector<std::string> names;
  if (s.size) names.emplace_back("size");
  if (s.semi_axes) names.emplace_back("semi_axes");
  if (s.radius) names.emplace_back("radius");
  if (s.height) names.emplace_back("height");
  if (s.length) names.emplace_back("length");
  if (s.thickness) names.emplace_back("thickness");
  if (s.tube) names.emplace_back("tube");
  if (!s.profile.empty()) names.emplace_back("profile");
  if (s.smooth) names.emplace_back("smooth");
  if (s.file) names.emplace_back("file");
  if (s.scale) names.emplace_back("scale");
  return names;
}

const SolidKind& kind_of(const SolidSpec& solid, const std::string& path) {
  for (const SolidKind& kind : solid_kinds()) {
    if (kind.name == solid.kind) return kind;
  }
  throw input_error("unknown solid '{}'{}", solid.kind, suggestion(solid.kind, solid_names()))
      .at({{}, 0, fmt::format("{}.kind", path)});
}

}  // namespace

// Long, because it is one table: a row for each.
const std::vector<SolidKind>& solid_kinds() {
  static const std::vector<SolidKind> kinds = {
      {"box",
       "edges along x, y, z; origin at its centre",
       {"size"},
       {},
       [](const SolidSpec& s) { return s.size->prod(); },
       box},
      {"sphere",
       "origin at its centre",
       {"radius"},
       {},
       [](const SolidSpec& s) { return 4.0 / 3.0 * kPi * std::pow(*s.radius, 3); },
       [](const SolidSpec& s) {
         return ellipsoid_with(Vec3::Constant(*s.radius));
       }},
      {"ellipsoid",
       "semi-axes along x, y, z; origin at its centre",
       {"semi_axes"},
       {},
       [](const SolidSpec& s) { return 4.0 / 3.0 * kPi * s.semi_axes->prod(); },
       [](const SolidSpec& s) {
         return ellipsoid_with(*s.semi_axes);
       }},
      {"cylinder",
       "about z; origin at its centre",
       {"radius", "height"},
       {},
       cylinder_volume,
       [](const SolidSpec& s) {
         return cylinder_with(*s.radius, *s.height);
       }},
      {"cone",
       "about z, apex at the origin, base at z = height",
       {"radius", "height"},
       {},
       [](const SolidSpec& s) { return cylinder_volume(s) / 3.0; },
       cone},
      {"disc",
       "about z, thin unless it has a thickness; origin at its centre",
       {"radius"},
       {"thickness"},
       [](const SolidSpec& s) { return kPi * *s.radius * *s.radius * s.thickness.value_or(0.0); },
       [](const SolidSpec& s) {
         return cylinder_with(*s.radius, s.thickness.value_or(0.0));
       }},
      {"ring",
       "hoop about z, a torus when it has a tube; origin at its centre",
       {"radius"},
       {"tube"},
       [](const SolidSpec& s) {
         return 2.0 * kPi * kPi * *s.radius * std::pow(s.tube.value_or(0.0), 2);
       },
       ring},
      {"rod",
       "along z, thin unless it has a radius; origin at its centre",
       {"length"},
       {"radius"},
       [](const SolidSpec& s) { return kPi * std::pow(s.radius.value_or(0.0), 2) * *s.length; },
       [](const SolidSpec& s) {
         return cylinder_with(s.radius.value_or(0.0), *s.length);
       }},
      {"lathe",
       "solid of revolution about z of the outline `profile`, closed to the axis; a tube when it "
       "ends where it began",
       {"profile"},
       {"smooth"},
       lathe_volume,
       lathe},
      {"mesh",
       "the closed surface in an OBJ or STL file; origin and axes of the file",
       {"file"},
       {"scale"},
       [](const SolidSpec& s) { return volume_of(*s.mesh); },
       [](const SolidSpec& s) {
         return mass_properties_of(*s.mesh);
       }},
  };
  return kinds;
}

std::vector<std::string> solid_names() {
  std::vector<std::string> names;
  for (const SolidKind& kind : solid_kinds())
    names.push_back(kind.name);
  return names;
}

void check_dimensions(const SolidSpec& solid, const std::string& path) {
  const SolidKind& kind = kind_of(solid, path);
  const std::vector<std::string> given = given_dimensions(solid);
  std::vector<std::string> known = kind.needs;
  known.insert(known.end(), kind.takes.begin(), kind.takes.end());
  require_keys(kind.name, kind.needs, given, path);
  refuse_other_keys(kind.name, known, given, path);

  // a dimension that may be zero is one of the optional ones
  if (contains(kind.needs, "radius") && *solid.radius < magnitude_of(Unit::length).least) {
    throw input_error("must be greater than 0 and not too small to be computed with, got {}",
                      *solid.radius)
        .at({{}, 0, path + ".radius"});
  }
  if (solid.tube && solid.radius && *solid.tube > *solid.radius) {
    throw input_error("the tube ({} m) must not be thicker than the ring's radius ({} m)",
                      *solid.tube,
                      *solid.radius)
        .at({{}, 0, path + ".tube"});
  }
  if (contains(kind.needs, "file") && !solid.mesh) {
    throw input_error("'{}' was not read; a scene with a mesh must be a file", *solid.file)
        .at({{}, 0, path + ".file"});
  }
  if (solid.profile.empty()) return;
  if (solid.smooth && solid.profile.size() > kMostSmooth) {
    throw input_error(
        "has {} points; a smooth outline can have at most {}", solid.profile.size(), kMostSmooth)
        .at({{}, 0, path + ".profile"});
  }
  check_profile(lathe_outline(solid), {{}, 0, path + ".profile"});
}

std::vector<Vec2> lathe_outline(const SolidSpec& solid) {
  constexpr int kPieces = 8;  // of a segment between two points
  const std::vector<Vec2>& points = solid.profile;
  if (!solid.smooth || points.size() < 3) return points;
  const std::size_t n = points.size();
  const bool closed = points.front() == points.back();
  // beyond the ends an open outline goes straight on
  const auto point = [&](std::ptrdiff_t i) -> Vec2 {
    const auto last = static_cast<std::ptrdiff_t>(n) - 1;
    if (i < 0) return closed ? points[n - 2] : Vec2(2.0 * points[0] - points[1]);
    if (i > last) return closed ? points[1] : Vec2(2.0 * points[n - 1] - points[n - 2]);
    return points[static_cast<std::size_t>(i)];
  };
  std::vector<Vec2> outline = {points.front()};
  for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(n); ++i) {
    const Vec2 a = point(i - 1), b = point(i), c = point(i + 1), d = point(i + 2);
    // centripetal: knots apart by the square root of the chord, so that nothing overshoots in loops
    const double ta = std::sqrt((b - a).norm()), tb = std::sqrt((c - b).norm());
    const double tc = std::sqrt((d - c).norm());
    for (int k = 1; k <= kPieces; ++k) {
      const double t = tb * k / kPieces;
      const Vec2 ab = a + (b - a) * (ta > 0.0 ? (t + ta) / ta : 1.0);
      const Vec2 bc = b + (c - b) * (tb > 0.0 ? t / tb : 0.0);
      const Vec2 cd = c + (d - c) * (tc > 0.0 ? (t - tb) / tc : 0.0);
      const Vec2 abc = ab + (bc - ab) * ((t + ta) / (tb + ta));
      const Vec2 bcd = bc + (cd - bc) * (t / (tc + tb));
      Vec2 next = tb > 0.0 ? Vec2(abc + (bcd - abc) * (t / tb)) : c;
      if (k == kPieces) next = c;
      next.x() = std::max(0.0, next.x());
      outline.push_back(next);
    }
  }
  return outline;
}

void load_meshes(BodySpec& body, const std::filesystem::path& folder) {
  const auto load = [&](SolidSpec& solid, const std::string& path) {
    if (solid.kind != "mesh" || !solid.file) return;
    try {
      solid.mesh = std::make_shared<const TriangleMesh>(
          load_solid_mesh(folder / *solid.file, solid.scale.value_or(1.0)));
    } catch (const Error& error) {
      // the place is the scene's key; the mesh file is named in the message
      throw Error(error.fault(),
                  fmt::format("{}: {}", (folder / *solid.file).string(), error.message()),
                  {{}, 0, path + ".file"});
    }
  };
  if (body.solid) load(*body.solid, "body.solid");
  for (std::size_t i = 0; i < body.parts.size(); ++i)
    load(body.parts[i], fmt::format("body.parts[{}]", i));
  if (body.look) load(*body.look, "body.look");
}

MassProperties mass_properties(const SolidSpec& solid, const std::string& path) {
  check_dimensions(solid, path);
  const SolidKind& kind = kind_of(solid, path);
  if (solid.mass.has_value() == solid.density.has_value()) {
    throw input_error("give {} exactly one of mass and density", with_article(kind.name))
        .at({{}, 0, path});
  }
  const double volume = kind.volume(solid);
  if (solid.density && volume <= 0.0) {
    throw input_error("a thin {} has no volume; give its mass", kind.name)
        .at({{}, 0, path + ".density"});
  }
  const double mass = solid.mass ? *solid.mass : *solid.density * volume;
  MassProperties own = kind.per_mass(solid);
  own.mass = mass;
  own.tensor *= mass;
  return moved(own, from_xyz_turns(solid.turn), solid.at);
}

}  // namespace polhode
