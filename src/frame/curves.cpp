// SPDX-License-Identifier: MIT
#include "frame/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/system/interrupt.h"
#include "base/units.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr int kMostHalvings = 12;
constexpr std::size_t kPointsOfPiece = 64;

struct PathPoint {
  double parameter;
  Vec3 point;
};

// how far a point is from where a straight piece is at the same parameter: a film that ends the
// path there must end it where its point is
double distance_from_piece(const PathPoint& inside, const PathPoint& from, const PathPoint& to) {
  const double part = (inside.parameter - from.parameter) / (to.parameter - from.parameter);
  return (inside.point - from.point - part * (to.point - from.point)).norm();
}

// the axes in the order of their moments
std::array<int, 3> ascending(const Vec3& moments) {
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(
      order.begin(), order.end(), [&](int i, int k) { return moments[i] < moments[k]; });
  return order;
}

// what of a path is not needed: points where the straight piece between those kept is anyway
Path thinned(const Path& path, double tolerance) {
  Path kept;
  const auto keep = [&](std::size_t i) {
    kept.parameters.push_back(path.parameters[i]);
    kept.points.push_back(path.points[i]);
  };
  const auto at = [&](std::size_t i) {
    return PathPoint{path.parameters[i], path.points[i]};
  };
  keep(0);
  std::size_t start = 0;
  for (std::size_t i = 2; i < path.points.size(); ++i) {
    bool straight = i - start < 64;
    for (std::size_t k = start + 1; straight && k < i; ++k) {
      straight = distance_from_piece(at(k), at(start), at(i)) <= tolerance;
    }
    if (straight) continue;
    start = i - 1;
    keep(start);
  }
  keep(path.points.size() - 1);
  return kept;
}

}  // namespace

Path sampled(const std::function<Vec3(double)>& curve,
             double from,
             double to,
             int pieces,
             double tolerance,
             std::size_t most_points) {
  Path path;
  const auto add = [&](const PathPoint& end) {
    path.parameters.push_back(end.parameter);
    path.points.push_back(end.point);
  };
  const auto at = [&](double parameter) {
    return PathPoint{parameter, curve(parameter)};
  };
  // adds the end of a piece, and what is needed inside it
  const std::function<void(const PathPoint&, const PathPoint&, int)> refine =
      [&](const PathPoint& a, const PathPoint& b, int depth) {
        const PathPoint m = at(0.5 * (a.parameter + b.parameter));
        const auto is_off = [&](const PathPoint& inside) {
          return distance_from_piece(inside, a, b) > tolerance;
        };
        const bool off = is_off(m) || is_off(at(0.5 * (a.parameter + m.parameter))) ||
                         is_off(at(0.5 * (m.parameter + b.parameter)));
        const bool full = path.points.size() >= most_points;
        path.coarse = path.coarse || (off && full);
        if (off && depth < kMostHalvings && !full) {
          refine(a, m, depth + 1);
          refine(m, b, depth + 1);
        } else {
          add(b);
        }
      };
  PathPoint a = at(from);
  add(a);
  for (int i = 1; i <= pieces; ++i) {
    stop_if_interrupted();
    const PathPoint b = at(from + (to - from) * i / pieces);
    refine(a, b, 0);
    a = b;
  }
  Path kept = thinned(path, 0.5 * tolerance);
  kept.coarse = path.coarse;
  return kept;
}

Mesh tube_along(const std::vector<Vec3>& points, double radius, int sides, bool closed) {
  CHECK(points.size() >= 2);
  const std::size_t n = points.size();
  const auto tangent = [&](std::size_t i) {
    const std::size_t before = i > 0 ? i - 1 : closed ? n - 1 : 0;
    const std::size_t after = i + 1 < n ? i + 1 : closed ? 0 : n - 1;
    const Vec3 along = points[after] - points[before];
    return along.norm() > 0.0 ? Vec3(along.normalized()) : Vec3::UnitX();
  };

  // a normal that is carried along without turning about the tangent
  Mesh mesh;
  Vec3 t = tangent(0);
  Vec3 normal = t.unitOrthogonal();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 now = tangent(i);
    if (t.dot(now) > -0.999999) normal = turn_between(t, now) * normal;
    t = now;
    const Vec3 across = t.cross(normal);
    for (int k = 0; k < sides; ++k) {
      const double angle = 2.0 * kPi * k / sides;
      const Vec3 out = std::cos(angle) * normal + std::sin(angle) * across;
      mesh.vertices.push_back({to_glm(Vec3(points[i] + radius * out)), to_glm(out)});
    }
  }

  const auto quad = [&](std::size_t ring, std::size_t next) {
    for (int k = 0; k < sides; ++k) {
      const auto a = static_cast<std::uint32_t>(ring * static_cast<std::size_t>(sides)) + k;
      const auto b =
          static_cast<std::uint32_t>(ring * static_cast<std::size_t>(sides)) + (k + 1) % sides;
      const auto c = static_cast<std::uint32_t>(next * static_cast<std::size_t>(sides)) + k;
      const auto d =
          static_cast<std::uint32_t>(next * static_cast<std::size_t>(sides)) + (k + 1) % sides;
      for (const std::uint32_t corner : {a, b, c, b, d, c})
        mesh.indices.push_back(corner);
    }
  };
  for (std::size_t i = 0; i + 1 < n; ++i)
    quad(i, i + 1);
  if (closed) {
    quad(n - 1, 0);
    return mesh;
  }
  const auto close_end = [&](std::size_t ring, const Vec3& outwards, bool turned) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({to_glm(points[ring]), to_glm(outwards)});
    for (std::size_t k = 0; k < static_cast<std::size_t>(sides); ++k) {
      const Vertex& corner = mesh.vertices[ring * static_cast<std::size_t>(sides) + k];
      mesh.vertices.push_back({glm::vec3(corner.position), to_glm(outwards)});
    }
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(sides); ++k) {
      const std::uint32_t here = first + 1 + k;
      const std::uint32_t next = first + 1 + (k + 1) % static_cast<std::uint32_t>(sides);
      mesh.indices.insert(mesh.indices.end(), {first, turned ? next : here, turned ? here : next});
    }
  };
  close_end(0, -tangent(0), true);
  close_end(n - 1, tangent(n - 1), false);
  return mesh;
}

Trail::Trail(Path path, double tube_radius, double unit, int sides)
    : path_(std::move(path)), tube_radius_(tube_radius), sides_(sides) {
  if (path_.points.size() < 2) return;
  place_.translation() = path_.points.front();
  place_.linear() *= unit;
  for (std::size_t start = 0; start + 1 < path_.points.size(); start += kPointsOfPiece) {
    stop_if_interrupted();
    const std::size_t end = std::min(start + kPointsOfPiece + 1, path_.points.size());
    pieces_.push_back(std::make_shared<const Mesh>(
        tube({path_.points.begin() + static_cast<std::ptrdiff_t>(start),
              path_.points.begin() + static_cast<std::ptrdiff_t>(end)})));
  }
}

Mesh Trail::tube(const std::vector<Vec3>& points) const {
  const double unit = place_.linear()(0, 0);
  std::vector<Vec3> scaled;
  scaled.reserve(points.size());
  for (const Vec3& point : points)
    scaled.emplace_back((point - place_.translation()) / unit);
  return tube_along(scaled, tube_radius_ / unit, sides_, false);
}

Vec3 Trail::at(double parameter) const {
  const auto after = std::upper_bound(path_.parameters.begin(), path_.parameters.end(), parameter);
  if (after == path_.parameters.begin()) return path_.points.front();
  if (after == path_.parameters.end()) return path_.points.back();
  const auto i = static_cast<std::size_t>(after - path_.parameters.begin());
  const double part =
      (parameter - path_.parameters[i - 1]) / (path_.parameters[i] - path_.parameters[i - 1]);
  return path_.points[i - 1] + part * (path_.points[i] - path_.points[i - 1]);
}

std::vector<MeshPtr> Trail::part(double from, double to) const {
  std::vector<MeshPtr> meshes;
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const std::size_t start = k * kPointsOfPiece;
    const std::size_t end = std::min(start + kPointsOfPiece, path_.points.size() - 1);
    const double low = path_.parameters[start];
    const double high = path_.parameters[end];
    if (high <= from || low >= to) continue;
    if (low >= from && high <= to) {
      meshes.push_back(pieces_[k]);
      continue;
    }
    // cut at one end or both
    std::vector<Vec3> points = {at(std::max(low, from))};
    for (std::size_t i = start; i <= end; ++i) {
      const double parameter = path_.parameters[i];
      if (parameter > std::max(low, from) && parameter < std::min(high, to))
        points.push_back(path_.points[i]);
    }
    points.push_back(at(std::min(high, to)));
    meshes.push_back(std::make_shared<const Mesh>(tube(points)));
  }
  return meshes;
}

std::vector<Vec3> polhode(const Vec3& moments, const Vec3& w_P, int pieces) {
  const Vec3 y = moments.cwiseProduct(w_P);
  const double energy2 = y.dot(w_P);
  const double momentum2 = y.squaredNorm();
  if (energy2 == 0.0) return {};
  const std::array<int, 3> order = ascending(moments);

  // round the axis of the largest moment, or of the smallest
  const bool about_largest = momentum2 >= energy2 * moments[order[1]];
  const int axis = about_largest ? order[2] : order[0];
  const int a = about_largest ? order[0] : order[1];
  const int b = about_largest ? order[1] : order[2];
  const double sign = w_P[axis] < 0.0 ? -1.0 : 1.0;
  const double room = std::abs(energy2 * moments[axis] - momentum2);
  const auto semi_axis = [&](int i) {
    const double slope = moments[i] * std::abs(moments[axis] - moments[i]);
    return slope > 0.0 ? std::sqrt(room / slope) : 0.0;
  };
  if (room < 1e-12 * energy2 * moments[axis]) return {};
  std::vector<Vec3> points;
  for (int k = 0; k < pieces; ++k) {
    const double angle = 2.0 * kPi * k / pieces;
    Vec3 w = Vec3::Zero();
    w[a] = semi_axis(a) * std::cos(angle);
    w[b] = semi_axis(b) * std::sin(angle);
    const double rest = energy2 - moments[a] * w[a] * w[a] - moments[b] * w[b] * w[b];
    w[axis] = sign * std::sqrt(std::max(0.0, rest) / moments[axis]);
    points.push_back(w);
  }
  return points;
}

std::vector<std::vector<Vec3>> separatrix(const Vec3& moments, const Vec3& w_P, int pieces) {
  const double energy2 = w_P.dot(moments.cwiseProduct(w_P));
  const auto [least, middle, most] = ascending(moments);
  const double below = moments[middle] - moments[least], above = moments[most] - moments[middle];
  if (energy2 == 0.0 || std::min(below, above) < 1e-9 * moments[most]) return {};
  const auto component = [&](int axis, double part) {
    return std::sqrt(energy2 * part / moments[axis]);
  };
  std::vector<std::vector<Vec3>> ellipses;
  for (const double sign : {1.0, -1.0}) {
    std::vector<Vec3>& points = ellipses.emplace_back();
    for (int k = 0; k < pieces; ++k) {
      const double angle = 2.0 * kPi * k / pieces;
      Vec3 w = Vec3::Zero();
      w[middle] = component(middle, 1.0) * std::cos(angle);
      w[least] = component(least, above / (below + above)) * std::sin(angle);
      w[most] = sign * component(most, below / (below + above)) * std::sin(angle);
      points.push_back(w);
    }
  }
  return ellipses;
}

}  // namespace polhode
