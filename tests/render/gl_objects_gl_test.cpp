// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <gtest/gtest.h>

#include "render/gl_objects.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

constexpr int kSide = 32;  // pixels

class GlObjects : public ::testing::Test {
 protected:
  std::array<int, 4> pixel(int x, int y) const {
    std::array<std::uint8_t, 4> bytes{};
    gl_.ReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return {bytes[0], bytes[1], bytes[2], bytes[3]};
  }

  const std::unique_ptr<Context> context_ = open_context("auto");
  const Gl gl_{*context_};
};

using Pixel = std::array<int, 4>;

TEST_F(GlObjects, AFramebufferKeepsWhatIsDrawn) {
  const Framebuffer first(gl_, kSide, kSide, 0, Buffers::depth);
  gl_.ClearColor(0.2f, 0.4f, 0.6f, 0.8f);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const Framebuffer second(gl_, kSide, kSide, 0, Buffers::color);
  gl_.ClearColor(1, 1, 1, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, first.id());
  EXPECT_EQ(pixel(0, 0), (Pixel{51, 102, 153, 204}));
  EXPECT_EQ(pixel(kSide - 1, kSide - 1), (Pixel{51, 102, 153, 204}));
  gl_.BindFramebuffer(GL_FRAMEBUFFER, second.id());
  EXPECT_EQ(pixel(3, 3), (Pixel{255, 255, 255, 255}));
}

TEST_F(GlObjects, AFramebufferThatIsTooLargeIsAnError) {
  test::expect_error([&] { Framebuffer(gl_, 1'000'000, 16, 0, Buffers::color); },
                     Fault::environment,
                     "",
                     "cannot create a 1000000x16 framebuffer");
  while (gl_.GetError() != GL_NO_ERROR) {
  }
}

// what the shaders are compiled with for a flat colour (render/surface.cpp)
std::string flat_head() {
  return "#define FINISH 0\n#define FLAT 1\n#define SOFT 0\n#define MARKED 0\n#define SHELL 0\n"
         "#define FADING 0\n#define FACES 2\n#define LIT_AT_CORNERS 0\n" +
         shader_source("light.glsl");
}

// a function that is declared and nowhere defined
TEST_F(GlObjects, ShadersThatDoNotLinkAreAnError) {
  test::expect_error(
      [&] {
        const Program program(
            gl_,
            "scene.vert",
            "scene.frag",
            flat_head() + "float nowhere(vec3 a, vec3 b);\n#define dot nowhere\n");
      },
      Fault::environment,
      "",
      "shaders scene.vert and scene.frag do not link here");
}

// a mesh covers the pixels whose centres lie inside of it, and no others
TEST_F(GlObjects, AMeshIsDrawnWhereItsCornersAre) {
  const Framebuffer buffer(gl_, kSide, kSide, 0, Buffers::color);
  gl_.Viewport(0, 0, kSide, kSide);
  gl_.ClearColor(0, 0, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  const Program program(gl_, "scene.vert", "scene.frag", flat_head());
  program.use();
  const glm::mat4 identity(1.0f);
  const glm::vec3 color(1.0f, 0.4f, 0.0f);
  gl_.UniformMatrix4fv(program.uniform("u_clip_from_world"), 1, GL_FALSE, glm::value_ptr(identity));
  gl_.UniformMatrix4fv(program.uniform("u_world_from_mesh"), 1, GL_FALSE, glm::value_ptr(identity));
  gl_.Uniform3fv(program.uniform("u_color"), 1, glm::value_ptr(color));
  gl_.Uniform1f(program.uniform("u_alpha"), 1.0f);
  gl_.Uniform1f(program.uniform("u_fade"), 1.0f);

  // a quarter of the picture: x from -1 to 0, y from -1 to 0 of clip space
  Mesh quad;
  for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {0.0f, -1.0f}, {0.0f, 0.0f}, {-1.0f, 0.0f}})
    quad.vertices.push_back({{x, y, 0.0f}, {0.0f, 0.0f, 1.0f}});
  quad.indices = {0, 1, 2, 0, 2, 3};
  const GpuMesh mesh(gl_, quad);
  mesh.draw();
  int covered = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool inside = x < kSide / 2 && y < kSide / 2;
      ASSERT_EQ(pixel(x, y), (inside ? Pixel{255, 102, 0, 255} : Pixel{0, 0, 0, 0}))
          << x << ' ' << y;
      covered += inside ? 1 : 0;
    }
  }
  EXPECT_EQ(covered, kSide * kSide / 4);
  EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(GlObjects, AUniformThatIsNotThereHasNoPlace) {
  const Program program(gl_, "scene.vert", "scene.frag", flat_head());
  EXPECT_EQ(program.uniform("u_nonsense"), -1);
  EXPECT_GE(program.uniform("u_color"), 0);
}

TEST_F(GlObjects, AShaderThatDoesNotCompileIsNamed) {
  test::expect_error(
      [&] { Program(gl_, "scene.vert", "scene.frag", "#error broken on purpose\n"); },
      Fault::environment,
      "",
      "scene.vert does not compile");
}

// Functions that count the objects that are not deleted yet.
const Gl* g_real = nullptr;
int g_alive = 0;

void generate(GLsizei count, GLuint* names, void (*real)(GLsizei, GLuint*)) {
  g_alive += count;
  real(count, names);
}
void erase(GLsizei count, const GLuint* names, void (*real)(GLsizei, const GLuint*)) {
  for (GLsizei i = 0; i < count; ++i)
    g_alive -= names[i] != 0 ? 1 : 0;
  real(count, names);
}

Gl counting(const Gl& real) {
  g_real = &real;
  g_alive = 0;
  Gl gl = real;
  gl.GenFramebuffers = [](GLsizei n, GLuint* names) {
    generate(n, names, g_real->GenFramebuffers);
  };
  gl.GenRenderbuffers = [](GLsizei n, GLuint* names) {
    generate(n, names, g_real->GenRenderbuffers);
  };
  gl.DeleteFramebuffers = [](GLsizei n, const GLuint* names) {
    erase(n, names, g_real->DeleteFramebuffers);
  };
  gl.DeleteRenderbuffers = [](GLsizei n, const GLuint* names) {
    erase(n, names, g_real->DeleteRenderbuffers);
  };
  gl.CreateShader = [](GLenum stage) {
    ++g_alive;
    return g_real->CreateShader(stage);
  };
  gl.CreateProgram = [] {
    ++g_alive;
    return g_real->CreateProgram();
  };
  gl.DeleteShader = [](GLuint name) {
    g_alive -= name != 0 ? 1 : 0;
    g_real->DeleteShader(name);
  };
  gl.DeleteProgram = [](GLuint name) {
    g_alive -= name != 0 ? 1 : 0;
    g_real->DeleteProgram(name);
  };
  return gl;
}

TEST_F(GlObjects, WhatCannotBeMadeLeavesNothingBehind) {
  const Gl gl = counting(gl_);
  EXPECT_THROW(Framebuffer(gl, 1'000'000, 16, 0, Buffers::depth), Error);
  EXPECT_EQ(g_alive, 0);
  while (gl_.GetError() != GL_NO_ERROR) {
  }
  // the vertex shader is good, the other file has no #version
  EXPECT_THROW(Program(gl, "scene.vert", "light.glsl", flat_head()), Error);
  EXPECT_EQ(g_alive, 0);
  {
    const Framebuffer buffer(gl, kSide, kSide, 0, Buffers::depth);
    const Program program(gl, "scene.vert", "scene.frag", flat_head());
    EXPECT_EQ(g_alive, 4) << "the shaders are deleted with the program";
  }
  EXPECT_EQ(g_alive, 0);
}

// every file of shaders/ is in the binary as it is on disk
TEST(GlObjectsShaders, AreEmbedded) {
  std::map<std::string, std::string> on_disk;
  for (const auto& file : std::filesystem::directory_iterator(POLHODE_SOURCE_DIR "/shaders"))
    on_disk[file.path().filename().string()] = test::read_text(file.path().string());
  EXPECT_EQ(embedded_shaders(), on_disk);
}

}  // namespace
}  // namespace polhode
