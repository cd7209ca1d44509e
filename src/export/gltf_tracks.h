// SPDX-License-Identifier: MIT
// Key times and poses as tracks of glTF nodes.
#pragma once

#include <functional>
#include <vector>

#include "export/gltf_document.h"
#include "export/key_times.h"

namespace polhode {

// Makes tracks; those with the same key times share them.
class TrackMaker {
 public:
  // A number of each pose: its index is that of the component.
  using Value = std::function<double(const Pose& pose, int component)>;
  using Size = std::function<Vec3(const Pose& pose)>;

  // A track with three components (of a turn four) for each pose; none if they are always the same.
  GltfTrack track(const KeyedPoses& keys, int components, const Value& value);
  // Sets place and turn of a node and how they change; places count from `from` (S, m).
  void set_poses(const Thing& thing, const KeyedPoses& keys, const Vec3& from, GltfNode& node);
  // Sets the factors of a node, which follow from the poses of its thing, and how they change.
  void set_size(const KeyedPoses& keys, const Size& size, GltfNode& node);

 private:
  Numbers shared_times(const std::vector<double>& times);

  std::vector<Numbers> times_;
};

}  // namespace polhode
