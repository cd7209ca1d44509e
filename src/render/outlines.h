// SPDX-License-Identifier: MIT
// Smooth outlines without extra samples: a picture with one sample per pixel jumps where the
// outline of a mesh passes between two pixel centres; the geometry tells where it passes, so each
// pixel that it crosses takes the share of its neighbour's colour that lies on the other side
// (E. Persson, "Geometric post-process anti-aliasing", 2011; here with exact areas).
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "frame/draw_list.h"
#include "image/image.h"

namespace polhode {

// The edges of a mesh between faces, found once.
class MeshEdges {
 public:
  explicit MeshEdges(const Mesh& mesh);

  // How far the mesh reaches from its own origin along an axis.
  float reach() const { return reach_; }

  // Calls seen(a, b) with the ends, mesh coordinates, of each edge that may be an outline from this
  // eye: between a face that looks there and one that does not, at a crease, at a border.
  template <class Seen>
  void each_seen(const glm::vec3& eye, const Seen& seen) const {
    std::vector<char>& towards = towards_;
    towards.resize(planes_.size());
    for (std::size_t i = 0; i < planes_.size(); ++i)
      towards[i] = glm::dot(planes_[i], glm::vec4(eye, 1.0f)) > 0.0f ? 1 : 0;
    for (const Edge& edge : smooth_) {
      if (towards[edge.faces[0]] != towards[edge.faces[1]])
        seen(points_[edge.ends[0]], points_[edge.ends[1]]);
    }
    for (const Edge& edge : sharp_) {
      if ((towards[edge.faces[0]] | towards[edge.faces[1]]) != 0 || edge.border)
        seen(points_[edge.ends[0]], points_[edge.ends[1]]);
    }
  }

 private:
  struct Edge {
    std::array<std::uint32_t, 2> ends;   // in points_
    std::array<std::uint32_t, 2> faces;  // in planes_; a border has the same twice
    bool border = false;
  };
  float reach_ = 0.0f;
  std::vector<glm::vec3> points_;  // corners, each once
  std::vector<glm::vec4> planes_;  // of the faces: positive for eyes that see them
  std::vector<Edge> smooth_;       // where shading goes on: outlines only against the eye
  std::vector<Edge> sharp_;
  mutable std::vector<char> towards_;  // scratch
};

// Collects the outlines of one panel and smooths them.
class OutlineSmoother {
 public:
  // Begins with a panel at `place`.
  void begin(const View& view, const PixelBox& place);
  // The outlines of a thing that is drawn there.
  void add(const MeshEdges& edges, const DrawItem& item);
  // Where the things added so far may have pixels, or neighbours of pixels: inside their outlines,
  // so in each band of rows between the leftmost and the rightmost. Boxes that do not overlap; all
  // things must be before the eye.
  std::vector<PixelBox> covered() const;
  // Mixes across all outlines that nothing hides. `depth` is OpenGL's, 0 near to 1 far, of a box
  // that holds all that is covered, rows from the top; the picture is premultiplied there, with one
  // sample per pixel. The depths are used and left as they were.
  void smooth(const PixelBox& box, std::vector<float>& depth, Image& image);

 private:
  // A straight piece of an outline: pixels of the picture; depths are a little nearer than the
  // edge.
  struct EdgePart {
    glm::vec2 from, to;
    float depth_from, depth_to;
  };
  // A pixel of the box that edges cross, and how much of it lies beyond them, where the neighbours
  // to the right, to the left, below and above have the colour.
  struct Crossed {
    int x, y;
    float depth;
    std::array<float, 4> shares{};
  };
  void collect(const EdgePart& piece, std::vector<float>& depth);
  std::size_t index_of(int x, int y) const;

  View view_;
  PixelBox place_;
  PixelBox box_;                                    // that is being smoothed
  float depth_scale_ = 0.0f, depth_offset_ = 0.0f;  // z of clip space = scale * w + offset
  float pixel_ = 0.0f;                              // size of a pixel at w = 1, drawing units
  std::vector<std::pair<const Mesh*, glm::mat4>> shells_;  // translucent things added so far
  std::vector<EdgePart> pieces_;
  std::vector<Crossed> crossed_;
  std::vector<std::array<std::uint8_t, 4>> mixed_;  // their new colours
};

}  // namespace polhode
