// SPDX-License-Identifier: MIT
// Everything one picture consists of, as a value: what render/ draws and nothing else. Its world is
// space, moved and scaled so that single precision is enough (DrawingFrame in frame/camera.h).
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "frame/mesh.h"
#include "image/pixel_box.h"
#include "image/sprite.h"

namespace polhode {

// How the surface of a body looks.
enum class Finish { plain, wood, metal, ceramic };

// Colours are sRGB-encoded, 0..1.
struct Material {
  glm::vec3 color{0.8f};
  float alpha = 1.0f;          // under 1: translucent, and listed in DrawList::translucent
  float gloss = 0.3f;          // strength of the highlight
  glm::vec3 mark_color{0.0f};  // of the mark that shows the spin
  float mark_width = 0.0f;     // half-width of the strip x > 0, |y| < width in mesh units; 0 = none
  Finish finish = Finish::plain;
  bool flat = false;  // the same colour and alpha from everywhere, without light
  bool soft = false;  // of a flat disc: alpha falls to nothing at its rim
  float fade = 1.0f;  // under 1: the whole thing comes or goes, whatever its alpha

  bool opaque() const { return alpha >= 1.0f && fade >= 1.0f; }
};

// Which faces are drawn.
enum class Faces { front, back, both };

struct DrawItem {
  MeshPtr mesh;
  glm::mat4 world_from_mesh{1.0f};
  Material material;
  Faces faces = Faces::front;
};

// Where it is seen from.
struct View {
  glm::mat4 clip_from_world{1.0f};  // OpenGL clip space, y up
  glm::vec3 eye{0.0f};
  glm::vec3 key_light{0.0f};   // unit vector towards the main light
  glm::vec3 fill_light{0.0f};  // unit vector towards the weaker one
};

struct DrawList {
  View view;
  glm::vec3 background{0.0f};         // sRGB-encoded, 0..1
  std::vector<DrawItem> opaque;       // any order
  std::vector<DrawItem> translucent;  // back to front, drawn after the opaque ones
};

// A part of the picture with a camera of its own.
struct Panel {
  PixelBox place;
  DrawList list;
};

// A whole frame: panels that together cover it without overlap, and what is laid over them in this
// order.
struct Picture {
  std::vector<Panel> panels;
  std::vector<Stamp> stamps;
};

}  // namespace polhode
