// SPDX-License-Identifier: MIT
#include "frame/shadow.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"

namespace polhode {
namespace {

constexpr int kCells = 200;  // of the floor, from -1 to 1

// The darkness at the middles of a grid of cells, by the triangles of the mesh.
class Darkness {
 public:
  // part: the component of the normals that says it
  explicit Darkness(const MeshPtr& shadow, int part = 2)
      : at_(static_cast<std::size_t>(kCells * kCells), 0.0), shadow_(shadow), part_(part) {
    if (shadow == nullptr) return;
    for (std::size_t i = 0; i + 2 < shadow->indices.size(); i += 3)
      add(corner(i), corner(i + 1), corner(i + 2));
  }
  double operator()(int x, int y) const { return at_[index(x, y)]; }
  double area() const {
    double sum = 0.0;
    for (const double dark : at_)
      sum += dark * (2.0 / kCells) * (2.0 / kCells);
    return sum;
  }
  static Vec2 middle(int x, int y) {
    return Vec2(2.0 * x + 1.0 - kCells, 2.0 * y + 1.0 - kCells) / kCells;
  }

 private:
  const Vertex& corner(std::size_t i) const { return shadow_->vertices[shadow_->indices[i]]; }
  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * kCells + x); }
  void add(const Vertex& a, const Vertex& b, const Vertex& c) {
    EXPECT_EQ(a.position.z, 0.0f);
    const auto flat = [](const Vertex& v) {
      return Vec2(v.position.x, v.position.y);
    };
    const Vec2 ab = flat(b) - flat(a), ac = flat(c) - flat(a);
    const double twice = ab.x() * ac.y() - ab.y() * ac.x();
    EXPECT_GT(twice, 0.0) << "seen from above";
    const auto cell = [](double p) {
      return static_cast<int>(std::floor(0.5 * (p + 1.0) * kCells));
    };
    const Vec2 low = flat(a).cwiseMin(flat(b)).cwiseMin(flat(c));
    const Vec2 high = flat(a).cwiseMax(flat(b)).cwiseMax(flat(c));
    for (int y = std::max(0, cell(low.y())); y <= std::min(kCells - 1, cell(high.y())); ++y) {
      for (int x = std::max(0, cell(low.x())); x <= std::min(kCells - 1, cell(high.x())); ++x) {
        const Vec2 p = middle(x, y) - flat(a);
        const double u = (p.x() * ac.y() - p.y() * ac.x()) / twice;
        const double v = (ab.x() * p.y() - ab.y() * p.x()) / twice;
        if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
        at_[index(x, y)] = a.normal[part_] + u * (b.normal[part_] - a.normal[part_]) +
                           v * (c.normal[part_] - a.normal[part_]);
      }
    }
  }

  std::vector<double> at_;
  MeshPtr shadow_;
  int part_;
};

// a box with edges along the axes
struct Block {
  Vec3 middle, half;

  ShadowCaster caster(double density = 1.0) const {
    ShadowCaster caster{std::make_shared<const Mesh>(box(2.0 * half)), Placement::Identity()};
    caster.floor_from_mesh.translation() = middle;
    caster.density = density;
    return caster;
  }
  // does the ray from a point of the floor towards the light (x, y per height) meet the box?
  bool stops(const Vec2& from, const Vec2& slope) const {
    double in = 0.0, out = 1e9;
    const Vec3 start(from.x(), from.y(), 0.0), along(slope.x(), slope.y(), 1.0);
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double low = middle[k] - half[k] - start[k], high = middle[k] + half[k] - start[k];
      if (along[k] == 0.0) {
        if (low > 0.0 || high < 0.0) return false;
        continue;
      }
      in = std::max(in, std::min(low / along[k], high / along[k]));
      out = std::min(out, std::max(low / along[k], high / along[k]));
    }
    return in < out;
  }
};

// what the rim leaves of a shadow
double left(const Vec2& at) {
  const double in = std::clamp((1.0 - at.norm()) / kFloorRim, 0.0, 1.0);
  return in * in * (3.0 - 2.0 * in);
}

const Block kBlock{{0.1, -0.05, 0.5}, {0.12, 0.2, 0.15}};

// rays to all points of the light: the darkness is right but for the stated blur
TEST(Shadow, IsWhereTheBodyHidesTheLight) {
  for (const Vec3& to_light : {Vec3(0, 0, 1), Vec3(-0.4, 0.2, 1.0), Vec3(0.9, 0.5, 1.0)}) {
    SCOPED_TRACE(to_light.transpose());
    const Darkness dark(shadow_mesh({kBlock.caster()}, to_light));
    const std::vector<Vec2> slopes = light_slopes(to_light);
    const auto hidden = [&](const Vec2& at) {
      double sum = 0.0;
      for (const Vec2& slope : slopes)
        sum += kBlock.stops(at, slope) ? 1.0 / static_cast<double>(slopes.size()) : 0.0;
      return sum;
    };
    double area = 0.0;
    int full = 0, partly = 0;
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) {
        const Vec2 at = Darkness::middle(x, y);
        area += left(at) * hidden(at) * (2.0 / kCells) * (2.0 / kCells);
        // between the least and the most of the neighbourhood
        double least = 1.0, most = 0.0;
        for (int k = 0; k < 16; ++k) {
          for (const double out : {0.5, 1.0}) {
            const double turn = 2.0 * kPi * k / 16;
            const double here =
                hidden(at + out * kShadowBlur * Vec2(std::cos(turn), std::sin(turn)));
            least = std::min(least, here);
            most = std::max(most, here);
          }
        }
        EXPECT_GE(dark(x, y), left(at) * least - 0.01) << at.transpose();
        EXPECT_LE(dark(x, y), left(at) * most + 0.01) << at.transpose();
        full += dark(x, y) > 0.99;
        partly += dark(x, y) > 0.1 && dark(x, y) < 0.9;
      }
    }
    EXPECT_NEAR(dark.area(), area, 0.03 * area);
    EXPECT_GT(full, 100);
    EXPECT_GT(partly, 100) << "the rim is soft";
  }
}

// the higher a body is, the wider is the half shadow around it
TEST(Shadow, IsSofterFurtherAway) {
  const auto partly = [](double height) {
    const Block block{{0, 0, height}, {0.3, 0.3, 0.05}};
    const Darkness dark(shadow_mesh({block.caster()}, Vec3::UnitZ()));
    int count = 0;
    for (int x = 0; x < kCells; ++x)
      count += dark(x, kCells / 2) > 0.05 && dark(x, kCells / 2) < 0.95;
    return count;
  };
  EXPECT_GT(partly(1.2), 2 * partly(0.06));
}

// what is half transparent is half as dark
TEST(Shadow, OfSomethingTranslucentIsPaler) {
  const Darkness dark(shadow_mesh({kBlock.caster(0.5)}, Vec3::UnitZ()));
  const auto x = static_cast<int>(0.5 * (kBlock.middle.x() + 1.0) * kCells);
  const auto y = static_cast<int>(0.5 * (kBlock.middle.y() + 1.0) * kCells);
  EXPECT_NEAR(dark(x, y), 0.5, 0.01);
}

// nothing to stop the light, nothing above the floor, nothing on it
TEST(Shadow, MayBeNone) {
  EXPECT_EQ(shadow_mesh({}, Vec3::UnitZ()), nullptr);
  EXPECT_EQ(shadow_mesh({kBlock.caster(0.0)}, Vec3::UnitZ()), nullptr);
  Block block = kBlock;
  block.middle.z() = -0.5;
  EXPECT_EQ(shadow_mesh({block.caster()}, Vec3::UnitZ()), nullptr);
  block.middle = Vec3(5.0, 0.0, 0.5);
  EXPECT_EQ(shadow_mesh({block.caster()}, Vec3::UnitZ()), nullptr);
}

// low light is raised, so that shadows stay short
TEST(Shadow, OfALowLightStaysShort) {
  for (const Vec3& to_light : {Vec3(1, 0, 0), Vec3(1, 0, -1), Vec3(0, 0, -1)}) {
    Vec2 mean = Vec2::Zero();
    const std::vector<Vec2> slopes = light_slopes(to_light);
    for (const Vec2& slope : slopes)
      mean += slope / static_cast<double>(slopes.size());
    EXPECT_LT(mean.norm(), 1.8);
    EXPECT_NE(shadow_mesh({kBlock.caster()}, to_light), nullptr);
  }
}

// rays to all points of the sky: the floor keeps what the body hides, but for the stated blur
TEST(Floor, IsDarkWhereTheBodyHidesTheSky) {
  const Darkness dark(floor_mesh({kBlock.caster()}), 0);
  const std::vector<Vec2> slopes = sky_slopes();
  const auto hidden = [&](const Vec2& at) {
    double sum = 0.0;
    for (const Vec2& slope : slopes)
      sum += kBlock.stops(at, slope) ? 1.0 / static_cast<double>(slopes.size()) : 0.0;
    return sum;
  };
  double area = 0.0, found = 0.0;
  for (int y = 0; y < kCells; y += 2) {
    for (int x = 0; x < kCells; x += 2) {
      const Vec2 at = Darkness::middle(x, y);
      if (at.norm() > 0.9) continue;
      area += hidden(at);
      found += dark(x, y);
      double least = 1.0, most = 0.0;
      for (int k = 0; k < 12; ++k) {
        for (const double out : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const double turn = 2.0 * kPi * k / 12;
          const double here = hidden(at + out * kSkyBlur * Vec2(std::cos(turn), std::sin(turn)));
          least = std::min(least, here);
          most = std::max(most, here);
        }
      }
      EXPECT_GE(dark(x, y), least - 0.01) << at.transpose();
      EXPECT_LE(dark(x, y), most + 0.01) << at.transpose();
    }
  }
  EXPECT_NEAR(found, area, 0.06 * area);
}

// equal parts of the light of the sky, Lambert's law: as much within half of the radius of the disc
// below it as its area says
TEST(Floor, HasAnEvenSky) {
  int inner = 0;
  for (const Vec2& slope : sky_slopes())
    inner += slope.norm() / std::sqrt(1.0 + slope.squaredNorm()) < 0.5 ? 1 : 0;
  EXPECT_NEAR(inner, 0.25 / 0.8 * static_cast<double>(sky_slopes().size()), 0.8);
}

// what stands on it darkens it more than what hovers, and nothing does not
TEST(Floor, IsDarkestWhereSomethingStands) {
  const auto darkest = [](double height) {
    float most = 0.0f;
    const MeshPtr floor = floor_mesh({Block{{0, 0, height}, {0.2, 0.2, 0.1}}.caster()});
    for (const Vertex& vertex : floor->vertices)
      most = std::max(most, vertex.normal.x);
    return most;
  };
  EXPECT_GT(darkest(0.1), 0.6f);
  EXPECT_LT(darkest(0.8), 0.5f * darkest(0.1));
  const MeshPtr bare = floor_mesh({});
  for (const Vertex& vertex : bare->vertices)
    EXPECT_EQ(vertex.normal.x, 0.0f);
}

// a full shadow is everywhere as much of its floor as is left of that, so that it ends nowhere
// before the floor; on what does not fade, it is full almost to the rim
TEST(Floor, AndItsShadowFadeAlike) {
  const ShadowCaster roof = Block{{0, 0, 0.3}, {2.0, 2.0, 0.1}}.caster();
  int faded = 0;
  const MeshPtr shadow = shadow_mesh({roof}, Vec3(0, 0, 1));
  for (const Vertex& vertex : shadow->vertices) {
    const double in = std::clamp((1.0 - glm::length(vertex.position)) / kFloorRim, 0.0, 1.0);
    EXPECT_NEAR(vertex.normal.z, in * in * (3.0 - 2.0 * in), 1e-5);
    faded += vertex.normal.z > 0.0f && vertex.normal.z < 1.0f ? 1 : 0;
  }
  EXPECT_GT(faded, 100);
  const MeshPtr bare = floor_mesh({});
  for (const Vertex& vertex : bare->vertices) {
    const double in = std::clamp((1.0 - glm::length(vertex.position)) / kFloorRim, 0.0, 1.0);
    EXPECT_NEAR(vertex.normal.z, in * in * (3.0 - 2.0 * in), 1e-5);
  }
  const MeshPtr sharp = shadow_mesh({roof}, Vec3(0, 0, 1), 1.0, 0.1);
  for (const Vertex& vertex : sharp->vertices) {
    if (glm::length(vertex.position) >= 0.9f) continue;
    EXPECT_NEAR(vertex.normal.z, 1.0f, 1e-5f);
  }
}

// a body that is small on its floor has as sharp a shadow as one that is large on a finer one
TEST(Shadow, IsAsFineAsAsked) {
  const ShadowCaster small = Block{{0, 0, 0.05}, {0.05, 0.05, 0.05}}.caster();
  const auto corners = [&](double fineness) {
    return shadow_mesh({small}, Vec3(0.3, 0.2, 1.0), fineness)->vertices.size();
  };
  EXPECT_GT(corners(4.0), 4 * corners(1.0));
  EXPECT_GT(floor_mesh({small}, 4.0)->vertices.size(), 10 * floor_mesh({small})->vertices.size());
}

// opaque in the middle and gone at the rim
TEST(Floor, FadesOutwards) {
  const MeshPtr floor = floor_mesh({});
  for (const Vertex& vertex : floor->vertices) {
    const float radius = glm::length(vertex.position);
    if (radius < 0.5f) {
      EXPECT_EQ(vertex.normal.z, 1.0f);
    }
    if (radius >= 1.0f) {
      EXPECT_EQ(vertex.normal.z, 0.0f);
    }
  }
}

}  // namespace
}  // namespace polhode
