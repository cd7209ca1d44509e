// SPDX-License-Identifier: MIT
// What a glTF file says, as values: nodes, meshes, animation tracks. Names and meanings are those
// of the glTF 2.0 specification (Khronos, 2021).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "frame/draw_list.h"
#include "image/image.h"
#include "math/notation.h"

namespace polhode {

// Numbers that several tracks may share.
using Numbers = std::shared_ptr<const std::vector<float>>;

// How one property of a node changes: `values` has three numbers (of a turn four: x, y, z, w) for
// each of the ascending times (s).
struct GltfTrack {
  Numbers times = {}, values = {};  // null: it does not change
  bool steps = false;               // each value stays until the next
};

// A node in its tree. Transforms lead to the parent's coordinates.
struct GltfNode {
  std::string name;
  int parent = -1;  // index of a node before it; -1: the scene
  Vec3 translation = Vec3::Zero();
  Quat rotation = Quat::Identity();
  Vec3 scale = Vec3::Ones();
  GltfTrack translated = {}, rotated = {}, scaled = {};
  int mesh = -1;  // indices in the lists of the document; -1: none
  int camera = -1;
  int light = -1;
  nlohmann::json extras = nlohmann::json::object();
};

// A mesh with its material.
struct GltfMesh {
  std::string name;
  MeshPtr mesh;
  int material = 0;
  std::string texture = {};  // PNG that colours it by x and y of its mesh, over the square around
                             // the origin that holds the mesh; empty: none
};

// A material, and how it looks where only the standard model of glTF is known.
struct GltfMaterial {
  std::string name;
  Material look;
  bool both_sides = false;
};

struct GltfCamera {
  std::string name;
  double aspect = 1.0;  // width to height
  double yfov = 0.5;    // vertical, rad
  double znear = 0.01, zfar = 100.0;
};

// Light from infinitely far, along -z of its node.
struct GltfLight {
  std::string name;
  double intensity = 1.0;
};

struct GltfDocument {
  std::string title, generator, copyright;  // copyright: empty for none
  std::vector<GltfNode> nodes;
  std::vector<GltfMesh> meshes;
  std::vector<GltfMaterial> materials;
  std::vector<GltfCamera> cameras;
  std::vector<GltfLight> lights;
  nlohmann::json extras = nlohmann::json::object();  // of the asset
};

}  // namespace polhode
