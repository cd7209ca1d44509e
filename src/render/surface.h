// SPDX-License-Identifier: MIT
// How surfaces are shaded: a program for each kind of material, made when it is first seen.
#pragma once

#include <map>
#include <memory>
#include <tuple>

#include <glm/mat4x4.hpp>

#include "frame/draw_list.h"
#include "render/gl_objects.h"

namespace polhode {

class SurfacePrograms {
 public:
  explicit SurfacePrograms(const Gl& gl) : gl_(gl) {}

  // What all items of a panel share; clip_from_world as it is drawn.
  void begin(const View& view, const glm::mat4& clip_from_world);
  // The next mesh is drawn with this material, here.
  void use(const Material& material, Faces faces, const glm::mat4& world_from_mesh);

 private:
  // What a program is made for: the constants of the shaders.
  struct Kind {
    Finish finish = Finish::plain;
    bool flat = false, soft = false, marked = false, shell = false, fading = false;
    Faces faces = Faces::front;
    friend bool operator<(const Kind& a, const Kind& b) {
      return std::tie(a.finish, a.flat, a.soft, a.marked, a.shell, a.fading, a.faces) <
             std::tie(b.finish, b.flat, b.soft, b.marked, b.shell, b.fading, b.faces);
    }
  };
  struct Uniforms {
    explicit Uniforms(const Program& p);
    GLint clip_from_world, world_from_mesh, normal_from_mesh, eye, key_light, fill_light, color,
        alpha, gloss, mark_color, mark_width, fade;
  };
  struct Made {
    Made(const Gl& gl, const std::string& head);
    Program program;
    Uniforms u;
    bool has_view = false;  // of the panel that is being drawn
  };
  Made& made(const Kind& kind);

  const Gl& gl_;
  std::map<Kind, std::unique_ptr<Made>> programs_;
  const Made* used_ = nullptr;
  View view_;
  glm::mat4 clip_from_world_{1.0f};
};

}  // namespace polhode
