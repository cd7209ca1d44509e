// SPDX-License-Identifier: MIT
// The complete description of one picture, as a value: the input of render/. World coordinates are
// space S, shifted and scaled for single precision (DrawingFrame in frame/camera.h).
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "frame/mesh.h"
#include "image/pixel_box.h"
#include "image/sprite.h"

namespace polhode {

// The procedural surface texture of a body.
enum class Finish { plain, wood, metal, ceramic };

// The material of an item. Colours are sRGB-encoded, 0..1.
struct Material {
  glm::vec3 color{0.8f};
  float alpha = 1.0f;          // 0..1; below 1: translucent, belongs in DrawList::translucent
  float gloss = 0.3f;          // strength of the highlight, 0..1
  glm::vec3 mark_color{0.0f};  // of the strip that makes the spin visible
  float mark_width = 0.0f;     // the strip is x > 0, |y| < width in mesh units, and the half x < 0
                               // is darker; 0: neither
  Finish finish = Finish::plain;
  float grain = 0.0f;   // the unit of length of the finish, mesh units
  bool turned = false;  // the strokes of metal go round z; else they are along x
  bool flat = false;    // unlit: the same colour and alpha from every direction
  bool vivid = false;   // half lit, half as if flat: a line whose colour is to be recognised
  bool soft = false;    // of a mesh in the plane z = 0, if flat: the z of normals multiplies alpha,
                        // and their x mixes the colour with mark_color
  float fade = 1.0f;    // multiplies alpha; below 1 while the item appears or disappears
  bool covers = false;  // parts of other items behind it are hidden, in the sense of `hidden`; of
                        // translucent items, soft ones alone can do that
  bool thin = false;    // hides no items with `hidden`, which are drawn over it
  float hidden = 0.0f;  // opacity of the parts that items with `covers` hide; 0: not seen
  float dashes = 0.0f;  // number of dashes of these parts from z = 0 to z = 1, which are narrower
                        // (kDashBreadth); 0: unbroken
  // Where near_side.xyz . (mesh coordinates) + near_side.w is negative, the colour is mark_color;
  // zero: it is nowhere.
  glm::vec4 near_side{0.0f};

  // Whether it belongs in DrawList::opaque.
  bool opaque() const { return alpha >= 1.0f && fade >= 1.0f; }
};

// How broad dashes are in the x and y of a mesh, in units of what is seen of it: a line behind a
// body is thinner than one that lies on it.
inline constexpr float kDashBreadth = 0.6f;

// Which faces are drawn: those whose outside the eye sees, those whose inside it sees, or both.
enum class Faces { front, back, both };

// A mesh at its position.
struct DrawItem {
  MeshPtr mesh;  // never null
  glm::mat4 world_from_mesh{1.0f};
  Material material;
  Faces faces = Faces::front;
};

// Camera and lights.
struct View {
  glm::mat4 clip_from_world{1.0f};  // OpenGL clip space, y up
  glm::vec3 eye{0.0f};              // world coordinates
  glm::vec3 key_light{0.0f};        // unit vector towards the main light
  glm::vec3 fill_light{0.0f};       // unit vector towards the weaker light
  bool light_ground = false;        // the studio is pale, and lights bodies as such a one does
};

// What is drawn from one camera.
struct DrawList {
  View view;
  glm::vec3 background{0.0f};         // sRGB-encoded, 0..1
  std::vector<DrawItem> opaque;       // any order; those that cover are drawn first
  std::vector<DrawItem> translucent;  // back to front, drawn after the opaque ones
};

// A rectangle of the picture with its own camera.
struct Panel {
  PixelBox place;  // pixels of the frame
  DrawList list;
};

// A whole frame: panels that cover it without overlap, and stamps that are drawn over them in this
// order.
struct Picture {
  std::vector<Panel> panels;
  std::vector<Stamp> stamps;
};

}  // namespace polhode
