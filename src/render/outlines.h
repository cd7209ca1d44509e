// SPDX-License-Identifier: MIT
// Antialiases outlines without multisampling. The position of an outline is known from the
// geometry, so each pixel that it crosses is mixed with the neighbour on the other side, by the
// area that lies there (E. Persson, "Geometric post-process anti-aliasing", 2011; here with exact
// areas). Not thread-safe.
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

// The edges between the faces of a mesh, found once. Not thread-safe, not even each_seen().
class MeshEdges {
 public:
  // Copies what it needs of the mesh.
  explicit MeshEdges(const Mesh& mesh);

  // The largest absolute coordinate of the mesh.
  float reach() const { return reach_; }

  // Calls seen(a, b) with the end points (glm::vec3) of each edge that may be an outline for this
  // eye: an edge between a face towards the eye and one away from it, a crease of which a face is
  // towards the eye, or a border. Eye and points are in mesh coordinates.
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
    bool border = false;                 // not between exactly two faces
  };
  float reach_ = 0.0f;
  std::vector<glm::vec3> points_;      // corners, each once
  std::vector<glm::vec4> planes_;      // of the faces: positive for points in front of them
  std::vector<Edge> smooth_;           // smoothly shaded: outlines only where faces turn away
  std::vector<Edge> sharp_;            // creases and borders
  mutable std::vector<char> towards_;  // scratch
};

// Collects the outlines of one panel and antialiases them. Call begin(), add() for every item, then
// covered() and smooth(). It needs no OpenGL.
class OutlineSmoother {
 public:
  // Starts a panel at `place` (pixels of the picture), and forgets the one before.
  void begin(const View& view, const PixelBox& place);
  // Adds the outlines of an item of the panel; `edges` are those of item.mesh. Both are read only
  // during the call.
  void add(const MeshEdges& edges, const DrawItem& item);
  // Boxes, without overlap, that contain all pixels of the items added so far and the neighbours of
  // these pixels. All items must be in front of the eye.
  std::vector<PixelBox> covered() const;
  // Antialiases all visible outlines in `image`, the whole picture, which has premultiplied alpha
  // and one sample per pixel. `depth` holds OpenGL's depths (0 near, 1 far) of `box` (pixels of the
  // picture), rows from the top; `box` must contain covered(). The depths are changed temporarily
  // and restored.
  void smooth(const PixelBox& box, std::vector<float>& depth, Image& image);

 private:
  // A straight piece of an outline in pixels of the picture. Its depths are slightly nearer than
  // the edge.
  struct EdgePart {
    glm::vec2 from, to;
    float depth_from, depth_to;  // OpenGL's, 0 near, 1 far
  };
  // A pixel crossed by edges. `shares` are the areas beyond them that get the colour of the right,
  // left, lower and upper neighbour.
  struct Crossed {
    int x, y;     // from the upper left corner of box_
    float depth;  // OpenGL's depth of the pixel
    std::array<float, 4> shares{};
  };
  void collect(const EdgePart& piece, std::vector<float>& depth);
  std::size_t index_of(int x, int y) const;

  View view_;
  PixelBox place_;
  PixelBox box_;                                    // being processed
  float depth_scale_ = 0.0f, depth_offset_ = 0.0f;  // z of clip space = scale * w + offset
  float pixel_ = 0.0f;                              // size of a pixel at w = 1, drawing units
  std::vector<std::pair<const Mesh*, glm::mat4>> shells_;  // translucent items added so far
  std::vector<EdgePart> pieces_;
  std::vector<Crossed> crossed_;
  std::vector<std::array<std::uint8_t, 4>> mixed_;  // their new colours
};

}  // namespace polhode
