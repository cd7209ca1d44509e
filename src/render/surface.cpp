// SPDX-License-Identifier: MIT
#include "render/surface.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace polhode {
namespace {

// the inverse transposed, up to a factor, of a matrix of any size: its determinant may be out of
// single precision's reach
glm::mat3 normal_from_mesh(const glm::mat3& world_from_mesh) {
  const float size = std::max({glm::length(world_from_mesh[0]),
                               glm::length(world_from_mesh[1]),
                               glm::length(world_from_mesh[2])});
  return glm::transpose(glm::inverse(world_from_mesh / size));
}

}  // namespace

SurfacePrograms::Uniforms::Uniforms(const Program& p)
    : clip_from_world(p.uniform("u_clip_from_world")),
      world_from_mesh(p.uniform("u_world_from_mesh")),
      normal_from_mesh(p.uniform("u_normal_from_mesh")),
      eye(p.uniform("u_eye")),
      key_light(p.uniform("u_key_light")),
      fill_light(p.uniform("u_fill_light")),
      color(p.uniform("u_color")),
      alpha(p.uniform("u_alpha")),
      gloss(p.uniform("u_gloss")),
      mark_color(p.uniform("u_mark_color")),
      mark_width(p.uniform("u_mark_width")),
      grain(p.uniform("u_grain")),
      fade(p.uniform("u_fade")),
      dashes(p.uniform("u_dashes")),
      near_side(p.uniform("u_near_side")),
      across(p.uniform("u_across")) {}

SurfacePrograms::Made::Made(const Gl& gl, const std::string& head)
    : program(gl, "scene.vert", "scene.frag", head), u(program) {}

SurfacePrograms::Made& SurfacePrograms::made(const Kind& kind) {
  std::unique_ptr<Made>& entry = programs_[kind];
  if (entry == nullptr) {
    const std::string constants = fmt::format(
        "#define FINISH {}\n#define TURNED {:d}\n#define FLAT {:d}\n#define VIVID {:d}\n"
        "#define SOFT {:d}\n#define MARKED {:d}\n#define SIDED {:d}\n"
        "#define SHELL {:d}\n#define FADING {:d}\n#define DASHED {:d}\n#define LIGHT_GROUND {:d}\n"
        "#define FACES {}\n#define LIT_AT_CORNERS {:d}\n",
        static_cast<int>(kind.finish),
        kind.turned,
        kind.flat,
        kind.vivid,
        kind.soft,
        kind.marked,
        kind.sided,
        kind.shell,
        kind.fading,
        kind.dashed,
        kind.light_ground,
        static_cast<int>(kind.faces),
        kind.shell && !kind.flat && !kind.marked && kind.finish == Finish::plain);
    entry = std::make_unique<Made>(gl_, constants + shader_source("light.glsl"));
  }
  return *entry;
}

void SurfacePrograms::begin(const View& view, const glm::mat4& clip_from_world) {
  view_ = view;
  clip_from_world_ = clip_from_world;
  for (const auto& [kind, entry] : programs_)
    entry->has_view = false;
}

void SurfacePrograms::use(const Material& material,
                          Faces faces,
                          const glm::mat4& world_from_item,
                          bool hidden) {
  const bool dashed = hidden && material.dashes > 0.0f;
  const float fade = hidden ? material.fade * material.hidden : material.fade;
  Made& now = made({material.finish,
                    material.finish == Finish::metal && material.turned,
                    material.flat,
                    material.vivid,
                    material.flat && material.soft,
                    material.mark_width > 0.0f,
                    material.near_side != glm::vec4(0.0f),
                    material.alpha < 1.0f,
                    fade < 1.0f,
                    dashed,
                    view_.light_ground && !material.flat,
                    faces});
  const Uniforms& u = now.u;
  if (used_ != &now) now.program.use();
  used_ = &now;
  if (!now.has_view) {
    gl_.UniformMatrix4fv(u.clip_from_world, 1, GL_FALSE, glm::value_ptr(clip_from_world_));
    gl_.Uniform3fv(u.eye, 1, glm::value_ptr(view_.eye));
    gl_.Uniform3fv(u.key_light, 1, glm::value_ptr(view_.key_light));
    gl_.Uniform3fv(u.fill_light, 1, glm::value_ptr(view_.fill_light));
    now.has_view = true;
  }
  glm::mat4 world_from_mesh = world_from_item;
  if (dashed) world_from_mesh = glm::scale(world_from_item, {kDashBreadth, kDashBreadth, 1.0f});
  const glm::mat3 normals = normal_from_mesh(glm::mat3(world_from_mesh));
  gl_.UniformMatrix4fv(u.world_from_mesh, 1, GL_FALSE, glm::value_ptr(world_from_mesh));
  gl_.UniformMatrix3fv(u.normal_from_mesh, 1, GL_FALSE, glm::value_ptr(normals));
  gl_.Uniform3fv(u.color, 1, glm::value_ptr(material.color));
  gl_.Uniform1f(u.alpha, material.alpha);
  gl_.Uniform1f(u.gloss, material.gloss);
  gl_.Uniform3fv(u.mark_color, 1, glm::value_ptr(material.mark_color));
  gl_.Uniform1f(u.mark_width, material.mark_width);
  gl_.Uniform1f(u.grain, material.grain);
  gl_.Uniform1f(u.fade, fade);
  gl_.Uniform1f(u.dashes, material.dashes);
  gl_.Uniform4fv(u.near_side, 1, glm::value_ptr(material.near_side));
  if (dashed) {
    const glm::vec3 to_eye = view_.eye - glm::vec3(world_from_mesh[3]);
    const float x = glm::dot(to_eye, glm::normalize(glm::vec3(world_from_mesh[0])));
    const float y = glm::dot(to_eye, glm::normalize(glm::vec3(world_from_mesh[1])));
    const float far = std::max(std::hypot(x, y), 1e-6f);  // an eye on the axis sees no limb
    gl_.Uniform3fv(u.across, 1, glm::value_ptr(glm::vec3(-y, x, 0.0f) / far));
  }
}

}  // namespace polhode
