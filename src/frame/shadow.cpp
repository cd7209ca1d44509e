// SPDX-License-Identifier: MIT
#include "frame/shadow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "base/units.h"
#include "frame/to_glm.h"

namespace polhode {
namespace {

// How finely the floor is sampled.
struct Grid {
  int per_radius;  // samples per radius of the floor
  int corners;     // samples from one corner of the mesh to the next
  int blurs;       // means of three neighbours, in each direction
};
constexpr Grid kLampGrid{56, 2, 2};
constexpr Grid kSkyGrid{16, 1, 4};
Grid finer(Grid grid, double fineness) {
  grid.per_radius = static_cast<int>(std::lround(grid.per_radius * fineness));
  return grid;
}
constexpr int kLights = 12;       // points of the light
constexpr int kSkyPoints = 12;    // points of the sky
constexpr double kSkyPart = 0.8;  // of the light of the sky: what comes lower falls far away

// the vertices of a caster in samples, with their heights
std::vector<glm::vec3> in_samples(const ShadowCaster& caster, int per_radius) {
  const glm::mat4 place = to_glm(caster.floor_from_mesh.matrix());
  std::vector<glm::vec3> points;
  points.reserve(caster.mesh->vertices.size());
  for (const Vertex& vertex : caster.mesh->vertices) {
    const glm::vec3 p(place * glm::vec4(vertex.position, 1.0f));
    points.push_back(static_cast<float>(per_radius) * glm::vec3(p.x, p.y, std::max(p.z, 0.0f)));
  }
  return points;
}

// The samples of a rectangle of the floor, and how much light is kept from each.
class Samples {
 public:
  // low, high: corners of the rectangle, in samples from the middle of the floor; lights: how many
  // points of light there are
  Samples(const Grid& grid, int lights, const glm::vec2& low, const glm::vec2& high)
      : grid_(grid), lights_(lights) {
    const int step = grid.corners;
    const auto whole = [&](float at) {
      const auto most = static_cast<float>(grid.per_radius);
      const float steps = glm::clamp(at, -most, most) / static_cast<float>(step);
      return static_cast<int>(std::floor(steps)) * step;
    };
    const auto beyond = static_cast<float>(grid.blurs + 2 * step);
    left_ = whole(low.x - beyond);
    bottom_ = whole(low.y - beyond);
    columns_ = whole(high.x + beyond) - left_ + 1;
    rows_ = whole(high.y + beyond) - bottom_ + 1;
    const std::size_t count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    stopped_.assign(count, 0);
    dark_.assign(count, 0.0f);
  }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  glm::vec2 place(int x, int y) const {
    return glm::vec2(left_ + x, bottom_ + y) / static_cast<float>(grid_.per_radius);
  }
  int step() const { return grid_.corners; }
  glm::vec2 from_corner(const glm::vec2& from_middle) const {
    return from_middle - glm::vec2(left_, bottom_);
  }
  float dark(int x, int y) const { return dark_[index(x, y)]; }

  // a triangle, from the corner of the rectangle, stops the light of this point
  void stop(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    if (b.y < a.y) std::swap(a, b);
    if (c.y < b.y) std::swap(b, c);
    if (b.y < a.y) std::swap(a, b);
    // most are so small that no sample is within
    if (first(a.y) >= first(c.y)) return;
    if (first(std::min({a.x, b.x, c.x})) >= first(std::max({a.x, b.x, c.x}))) return;
    const Edge whole(a, c);
    stop_between(whole, Edge(a, b));
    stop_between(whole, Edge(b, c));
  }
  // no more triangles stop the light of this point
  void next_light() {
    for (std::size_t i = 0; i < dark_.size(); ++i)
      dark_[i] += static_cast<float>(stopped_[i]);
    std::fill(stopped_.begin(), stopped_.end(), std::uint8_t{0});
  }

  // all lights have been stopped: their number becomes a part, and smooth
  void blur() {
    for (float& dark : dark_)
      dark /= static_cast<float>(lights_);
    for (int k = 0; k < grid_.blurs; ++k) {
      mean_along_rows();
      mean_along_columns();
    }
  }

 private:
  // An edge that goes up, in samples from the corner of the rectangle.
  struct Edge {
    Edge(const glm::vec2& low, const glm::vec2& high)
        : from(low), to(high.y), slope((high.x - low.x) / (high.y - low.y)) {}
    float at(int row) const { return from.x + (static_cast<float>(row) - from.y) * slope; }

    glm::vec2 from;
    float to, slope;
  };
  // in the rows of the shorter of two edges
  void stop_between(const Edge& longer, const Edge& shorter) {
    const int top = std::min(rows_, first(shorter.to));
    for (int row = std::max(0, first(shorter.from.y)); row < top; ++row) {
      const float one = longer.at(row), other = shorter.at(row);
      const int begin = std::max(0, first(std::min(one, other)));
      const int end = std::min(columns_, first(std::max(one, other)));
      if (begin >= end) continue;
      std::memset(&stopped_[index(begin, row)], 1, static_cast<std::size_t>(end - begin));
    }
  }
  // the first sample from there on, which std::ceil tells more slowly
  static int first(float at) {
    constexpr float kFar = 1e6f;
    const float near = glm::clamp(at, -kFar, kFar);
    const int whole = static_cast<int>(near);
    return static_cast<float>(whole) < near ? whole + 1 : whole;
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }
  // the mean of each sample and its neighbours; beyond the rectangle nothing is dark
  void mean_along_rows() {
    for (int y = 0; y < rows_; ++y) {
      float before = 0.0f;
      for (int x = 0; x < columns_; ++x) {
        float& dark = dark_[index(x, y)];
        const float here = dark;
        const float next = x + 1 < columns_ ? dark_[index(x + 1, y)] : 0.0f;
        dark = (before + here + next) / 3.0f;
        before = here;
      }
    }
  }
  void mean_along_columns() {
    std::vector<float> before(static_cast<std::size_t>(columns_), 0.0f);
    const std::vector<float> none = before;
    for (int y = 0; y < rows_; ++y) {
      float* const row = &dark_[index(0, y)];
      const float* const next = y + 1 < rows_ ? &dark_[index(0, y + 1)] : none.data();
      for (std::size_t x = 0; x < before.size(); ++x) {
        const float here = row[x];
        row[x] = (before[x] + here + next[x]) / 3.0f;
        before[x] = here;
      }
    }
  }

  Grid grid_;
  int lights_;
  int left_ = 0, bottom_ = 0, columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> stopped_;  // 1: the light of this point
  std::vector<float> dark_;            // how many points before this one, then which part of them
};

// Squares of samples, where there is anything at any of their corners. normal(x, y) is that of a
// corner; its z is how much there is.
template <class Normal>
MeshPtr mesh_of(const Samples& samples, const Normal& normal) {
  Mesh mesh;
  const int step = samples.step();
  const int columns = (samples.columns() - 1) / step + 1;
  const int rows = (samples.rows() - 1) / step + 1;
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  };
  std::vector<glm::vec3> normals;
  normals.reserve(index(0, rows));
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x)
      normals.push_back(normal(step * x, step * y));
  }
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> corners(normals.size(), kNone);
  const auto corner = [&](int x, int y) {
    std::uint32_t& number = corners[index(x, y)];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(mesh.vertices.size());
      const glm::vec2 at = samples.place(step * x, step * y);
      mesh.vertices.push_back({{at.x, at.y, 0.0f}, normals[index(x, y)]});
    }
    return number;
  };
  for (int y = 0; y + 1 < rows; ++y) {
    for (int x = 0; x + 1 < columns; ++x) {
      const auto amount = [&](int right, int up) {
        return normals[index(x + right, y + up)].z;
      };
      if (amount(0, 0) + amount(1, 0) + amount(0, 1) + amount(1, 1) == 0.0f) continue;
      const std::uint32_t a = corner(x, y), b = corner(x + 1, y);
      const std::uint32_t c = corner(x + 1, y + 1), d = corner(x, y + 1);
      // cut along the edge of a shadow, which would get teeth if it were cut across
      const auto differ = [&](int right1, int right2) {
        return glm::distance(normals[index(x + right1, y)], normals[index(x + right2, y + 1)]);
      };
      if (differ(0, 1) <= differ(1, 0)) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
      } else {
        mesh.indices.insert(mesh.indices.end(), {a, b, d, b, c, d});
      }
    }
  }
  if (mesh.indices.empty()) return nullptr;
  return std::make_shared<const Mesh>(std::move(mesh));
}

// What is left of something on the floor that falls smoothly from 1 to 0 within `width` of the rim.
float left_near_rim(const glm::vec2& at, double width) {
  return glm::smoothstep(0.0f, static_cast<float>(width), 1.0f - glm::length(at));
}

// The vertices of casters in samples, in their order.
std::vector<std::vector<glm::vec3>> all_in_samples(const std::vector<ShadowCaster>& casters,
                                                   int per_radius) {
  std::vector<std::vector<glm::vec3>> points;
  points.reserve(casters.size());
  for (const ShadowCaster& caster : casters)
    points.push_back(in_samples(caster, per_radius));
  return points;
}

// the casters stop light from these slopes; `points` are their vertices
void stop_light(const std::vector<ShadowCaster>& casters,
                const std::vector<std::vector<glm::vec3>>& points,
                const std::vector<Vec2>& slopes,
                Samples& samples) {
  const auto lights = static_cast<int>(slopes.size());
  std::vector<glm::vec2> fallen;
  for (int light = 0; light < lights; ++light) {
    const Vec2& there = slopes[static_cast<std::size_t>(light)];
    const glm::vec2 slope(there.x(), there.y());
    for (std::size_t i = 0; i < casters.size(); ++i) {
      // what is half transparent stops the light of half of the points
      if (light + 0.5 > casters[i].density * lights) continue;
      fallen.clear();
      for (const glm::vec3& p : points[i])
        fallen.push_back(samples.from_corner(glm::vec2(p) - p.z * slope));
      const std::vector<std::uint32_t>& indices = casters[i].mesh->indices;
      for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
        const std::uint32_t a = indices[k], b = indices[k + 1], c = indices[k + 2];
        if (points[i][a].z + points[i][b].z + points[i][c].z <= 0.0f) continue;
        // the sides that face the light are enough
        const glm::vec2 ab = fallen[b] - fallen[a], ac = fallen[c] - fallen[a];
        if (ab.x * ac.y <= ab.y * ac.x) continue;
        samples.stop(fallen[a], fallen[b], fallen[c]);
      }
    }
    samples.next_light();
  }
  samples.blur();
}

}  // namespace

std::vector<Vec2> light_slopes(const Vec3& to_light) {
  const Vec3 given = to_light.normalized();
  const double height = std::max(given.z(), kLeastLightHeight);
  const double across = std::sqrt(1.0 - height * height) / height;
  const Vec2 middle = across * Vec2(given.x(), given.y()).stableNormalized();

  // spread evenly over a disc (a sunflower's seeds), in an order in which any first ones are too
  std::vector<Vec2> slopes;
  Vec2 mean = Vec2::Zero();
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  for (int k = 0; k < kLights; ++k) {
    const int seed = 7 * k % kLights;
    const double out = kLightSize * std::sqrt((seed + 0.5) / kLights);
    slopes.emplace_back(out * std::cos(golden * seed), out * std::sin(golden * seed));
    mean += slopes.back() / kLights;
  }
  for (Vec2& slope : slopes)
    slope += middle - mean;
  return slopes;
}

MeshPtr shadow_mesh(const std::vector<ShadowCaster>& casters,
                    const Vec3& to_light,
                    double fineness,
                    double rim) {
  const Grid grid = finer(kLampGrid, fineness);
  const std::vector<Vec2> slopes = light_slopes(to_light);
  const std::vector<std::vector<glm::vec3>> points = all_in_samples(casters, grid.per_radius);
  glm::vec2 low(std::numeric_limits<float>::infinity());
  glm::vec2 high(-low);
  for (const std::vector<glm::vec3>& of_caster : points) {
    for (const Vec2& slope : slopes) {
      for (const glm::vec3& p : of_caster) {
        const glm::vec2 falls = glm::vec2(p) - p.z * glm::vec2(slope.x(), slope.y());
        low = glm::min(low, falls);
        high = glm::max(high, falls);
      }
    }
  }
  if (!(low.x <= high.x)) return nullptr;
  Samples samples(grid, static_cast<int>(slopes.size()), low, high);
  stop_light(casters, points, slopes, samples);
  const auto normal = [&](int x, int y) {
    return glm::vec3(0.0f, 0.0f, samples.dark(x, y) * left_near_rim(samples.place(x, y), rim));
  };
  return mesh_of(samples, normal);
}

std::vector<Vec2> sky_slopes() {
  // as much light comes from each: points of a disc straight below those of the sky
  std::vector<Vec2> slopes;
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  for (int k = 0; k < kSkyPoints; ++k) {
    const int seed = 5 * k % kSkyPoints;  // any first ones are spread evenly
    const double square = kSkyPart * (seed + 0.5) / kSkyPoints;
    const double slope = std::sqrt(square / (1.0 - square));
    slopes.emplace_back(slope * std::cos(golden * seed), slope * std::sin(golden * seed));
  }
  return slopes;
}

MeshPtr floor_mesh(const std::vector<ShadowCaster>& casters, double fineness) {
  const Grid grid = finer(kSkyGrid, fineness);
  const std::vector<Vec2> slopes = sky_slopes();
  const glm::vec2 corner(static_cast<float>(grid.per_radius));
  Samples samples(grid, static_cast<int>(slopes.size()), -corner, corner);
  stop_light(casters, all_in_samples(casters, grid.per_radius), slopes, samples);
  const auto normal = [&](int x, int y) {
    return glm::vec3(samples.dark(x, y), 0.0f, left_near_rim(samples.place(x, y), kFloorRim));
  };
  return mesh_of(samples, normal);
}

}  // namespace polhode
