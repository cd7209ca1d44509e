// SPDX-License-Identifier: MIT
// The shader programs of surfaces: one per kind of material, compiled when it is first used.
#pragma once

#include <map>
#include <memory>
#include <tuple>

#include <glm/mat4x4.hpp>

#include "frame/draw_list.h"
#include "render/gl_objects.h"

namespace polhode {

// Use it on the thread of the context. The context and `gl`, to which it keeps a reference, must
// outlive it.
class SurfacePrograms {
 public:
  explicit SurfacePrograms(const Gl& gl) : gl_(gl) {}

  // Sets what all items of a panel share. clip_from_world is used instead of that of `view`. To be
  // called before use(), once per panel.
  void begin(const View& view, const glm::mat4& clip_from_world);
  // Selects the program for the next mesh, compiling it if needed, and sets its material and
  // position. `hidden`: its parts that something covers are drawn, dashes narrower than the rest.
  // `faces` says which faces will be drawn; the caller sets OpenGL's culling accordingly. Throws
  // Error (environment) as Program does.
  void use(const Material& material,
           Faces faces,
           const glm::mat4& world_from_item,
           bool hidden = false);

 private:
  // The constants that a program is compiled with.
  struct Kind {
    Finish finish = Finish::plain;
    bool turned = false;
    bool flat = false, vivid = false, soft = false, marked = false, sided = false;
    bool shell = false, fading = false, dashed = false;
    bool light_ground = false;
    Faces faces = Faces::front;
    auto all() const {
      return std::tie(finish,
                      turned,
                      flat,
                      vivid,
                      soft,
                      marked,
                      sided,
                      shell,
                      fading,
                      dashed,
                      light_ground,
                      faces);
    }
    friend bool operator<(const Kind& a, const Kind& b) { return a.all() < b.all(); }
  };
  struct Uniforms {
    explicit Uniforms(const Program& p);
    GLint clip_from_world, world_from_mesh, normal_from_mesh, eye, key_light, fill_light, color,
        alpha, gloss, mark_color, mark_width, grain, fade, dashes, near_side, across;
  };
  struct Made {
    Made(const Gl& gl, const std::string& head);
    Program program;
    Uniforms u;
    bool has_view = false;  // its view uniforms are those of the current panel
  };
  Made& made(const Kind& kind);

  const Gl& gl_;
  std::map<Kind, std::unique_ptr<Made>> programs_;
  const Made* used_ = nullptr;
  View view_;
  glm::mat4 clip_from_world_{1.0f};
};

}  // namespace polhode
