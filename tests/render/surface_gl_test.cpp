// SPDX-License-Identifier: MIT
// What a material looks like, on a square that fills the picture.
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "render/gl_objects.h"
#include "render/surface.h"

namespace polhode {
namespace {

constexpr int kSurfaceSide = 64;  // pixels

class Surface : public ::testing::Test {
 protected:
  Surface() {
    gl_.Viewport(0, 0, kSurfaceSide, kSurfaceSide);
    view_.eye = glm::vec3(0, 0, 5);
    view_.key_light = view_.fill_light = glm::vec3(0, 0, 1);
  }

  // the square in the plane z = 0, from -1 to 1, drawn without blending: premultiplied colours;
  // size: of the world's units; right: the z of the normals at x = 1
  Image drawn(const Material& material, float size = 1.0f, float right = 1.0f) {
    Mesh square;
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
      square.vertices.push_back({{x, y, 0.0f}, {0.0f, 0.0f, x < 0.0f ? 1.0f : right}});
    square.indices = {0, 1, 2, 0, 2, 3};
    glm::mat4 world_from_mesh(size), clip_from_world(1.0f / size);
    world_from_mesh[3][3] = clip_from_world[3][3] = 1.0f;
    return drawn(material, square, size, world_from_mesh, clip_from_world);
  }

  Image drawn(const Material& material,
              const Mesh& square,
              float size,
              const glm::mat4& world_from_mesh,
              const glm::mat4& clip_from_world) {
    const GpuMesh mesh(gl_, square);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    SurfacePrograms programs(gl_);
    View view = view_;
    view.eye *= size;
    programs.begin(view, clip_from_world);
    programs.use(material, Faces::front, world_from_mesh);
    mesh.draw();
    Image image(kSurfaceSide, kSurfaceSide);
    gl_.ReadPixels(
        0, 0, kSurfaceSide, kSurfaceSide, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return image;
  }

  const std::unique_ptr<Context> context_ = open_context("auto");
  const Gl gl_{*context_};
  const Framebuffer buffer_{gl_, kSurfaceSide, kSurfaceSide, 0, Buffers::color};
  View view_;
};

TEST_F(Surface, FlatOnesHaveTheirColourAndAlpha) {
  Material material;
  material.color = glm::vec3(0.2f, 0.4f, 0.8f);
  material.flat = true;
  material.alpha = 0.5f;
  material.fade = 0.5f;
  const Image image = drawn(material);
  for (const auto& [x, y] : {std::pair{0, 0}, {31, 40}, {63, 63}}) {
    const std::uint8_t* p = image.at(x, y);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(p[c], 255.0 * 0.25 * static_cast<double>(material.color[c]), 0.6);
    EXPECT_NEAR(p[3], 255.0 * 0.25, 0.6);
  }
}

// alpha is in proportion to the z of the normals
TEST_F(Surface, SoftOnesAreAsOpaqueAsTheirNormalsSay) {
  Material material;
  material.flat = material.soft = true;
  material.alpha = 0.8f;
  const Image image = drawn(material, 1.0f, 0.25f);
  for (int y = 0; y < kSurfaceSide; y += 5) {
    for (int x = 0; x < kSurfaceSide; x += 5) {
      const double part = (x + 0.5) / kSurfaceSide;
      EXPECT_NEAR(image.at(x, y)[3], 255.0 * 0.8 * (1.0 - 0.75 * part), 1.0) << x << ' ' << y;
    }
  }
}

// a floor below the eye and behind it: the part of it on the ray through each pixel says its alpha
TEST_F(Surface, SoftOnesReachBehindTheEye) {
  constexpr float kReach = 9.0f;
  constexpr int kCells = 6;  // along each side
  Mesh floor;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const glm::vec2 at = glm::vec2(i, j) * (2.0f / kCells) - 1.0f;
      floor.vertices.push_back({{at.x, at.y, 0.0f}, {0.0f, 0.0f, 0.75f + 0.25f * at.x}});
    }
  }
  for (std::uint32_t k = 0; k + kCells + 2 < floor.vertices.size(); ++k) {
    if (k % (kCells + 1) == kCells) continue;
    const std::uint32_t up = k + kCells + 1;
    floor.indices.insert(floor.indices.end(), {k, k + 1, up + 1, k, up + 1, up});
  }
  Material material;
  material.flat = material.soft = true;
  const glm::mat4 world_from_mesh = glm::scale(glm::mat4(1.0f), {kReach, kReach, 1.0f});
  const glm::vec3 eye(0.5f, -0.3f, 0.6f);
  const glm::mat4 clip_from_world =
      glm::perspective(0.9f, 1.0f, 0.1f, 30.0f) *
      glm::lookAt(eye, eye + glm::vec3(1.0f, 0.6f, -0.9f), glm::vec3(0, 0, 1));
  const Image image = drawn(material, floor, 1.0f, world_from_mesh, clip_from_world);
  const glm::mat4 world_from_clip = glm::inverse(clip_from_world);
  for (int y = 0; y < kSurfaceSide; y += 3) {
    for (int x = 0; x < kSurfaceSide; x += 3) {
      const glm::vec2 clip = (glm::vec2(x, y) + 0.5f) * (2.0f / kSurfaceSide) - 1.0f;
      const glm::vec4 far = world_from_clip * glm::vec4(clip, 1.0f, 1.0f);
      const glm::vec3 ray = glm::vec3(far) / far.w - eye;
      const glm::vec3 floor_at = eye - ray * (eye.z / ray.z);
      EXPECT_NEAR(image.at(x, y)[3], 255.0f * (0.75f + 0.25f * floor_at.x / kReach), 1.5f)
          << x << ' ' << y;
    }
  }
}

// the less a light falls straight on a surface, the darker it is
TEST_F(Surface, LitOnesDarkenWithTheAngleOfTheLight) {
  Material material;
  material.color = glm::vec3(0.5f);
  material.gloss = 0.0f;
  int before = 256;
  for (const double angle : {0.0, 0.5, 1.0, 1.5}) {
    view_.key_light = glm::vec3(std::sin(angle), 0.0, std::cos(angle));
    const int now = drawn(material).at(kSurfaceSide / 2, kSurfaceSide / 2)[0];
    EXPECT_LT(now, before) << angle;
    before = now;
  }
  EXPECT_GT(before, 0) << "the fill light is left";
}

// more than half of the light of vivid ones comes from everywhere
TEST_F(Surface, VividOnesKeepTheirColourInTheShade) {
  Material material;
  material.color = glm::vec3(0.8f, 0.4f, 0.1f);
  material.gloss = 0.0f;
  view_.key_light = view_.fill_light = glm::vec3(1.0f, 0.0f, 0.0f);
  const auto light = [&] {
    return std::pow(drawn(material).at(kSurfaceSide / 2, kSurfaceSide / 2)[0] / (255.0 * 0.8), 2);
  };
  for (const bool light_ground : {false, true}) {
    view_.light_ground = light_ground;
    material.vivid = false;
    EXPECT_LT(light(), 0.6);
    material.vivid = true;
    EXPECT_GT(light(), 0.68);
  }
}

// what turns away from the eye parts from the ground: darker before a light one, lit from behind
// before a dark one
TEST_F(Surface, LimbsPartFromTheGround) {
  Material material;
  material.color = glm::vec3(0.5f);
  material.gloss = 0.0f;
  const auto seen_from = [&](const glm::vec3& eye, bool light_ground) {
    view_.eye = eye;
    view_.light_ground = light_ground;
    return drawn(material).at(kSurfaceSide / 2, kSurfaceSide / 2)[0];
  };
  const glm::vec3 above(0, 0, 500), edge_on(500, 0, 20);
  EXPECT_LT(seen_from(edge_on, true), seen_from(above, true) - 15);
  EXPECT_GT(seen_from(edge_on, false), seen_from(above, false) + 4);
}

// a molecule and a planet are shaded alike, though the determinants of their matrices are out of
// single precision's reach
TEST_F(Surface, ShadingDoesNotDependOnTheSize) {
  Material material;
  material.mark_width = 0.2f;
  view_.key_light = glm::normalize(glm::vec3(0.3f, 0.4f, 1.0f));
  const Image metre = drawn(material);
  for (const float size : {1e-15f, 1e14f})
    EXPECT_EQ(drawn(material, size).pixels, metre.pixels) << size;
}

// the strip lies along +x, and the half beyond is darker: a turn is told from half a turn
TEST_F(Surface, TheMarkTellsHalfATurn) {
  Material material;
  material.color = glm::vec3(0.5f);
  material.gloss = 0.0f;
  material.mark_color = glm::vec3(0.5f, 0.0f, 0.0f);
  material.mark_width = 0.25f;
  const Image image = drawn(material);
  const auto at = [&](double x, double y) {
    return image.at(static_cast<int>((x + 1.0) * 0.5 * kSurfaceSide),
                    static_cast<int>((y + 1.0) * 0.5 * kSurfaceSide));
  };
  EXPECT_EQ(at(0.5, 0.0)[1], 0) << "on the strip";
  EXPECT_EQ(at(0.5, 0.2)[1], 0) << "on the strip";
  EXPECT_GT(at(0.5, 0.3)[1], 0) << "beside it";
  EXPECT_GT(at(-0.5, 0.0)[1], 0) << "opposite";
  EXPECT_LT(at(-0.5, 0.0)[1], at(0.5, 0.5)[1]) << "the darker half";
}

}  // namespace
}  // namespace polhode
