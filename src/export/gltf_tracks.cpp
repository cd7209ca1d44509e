// SPDX-License-Identifier: MIT
#include "export/gltf_tracks.h"

#include "math/so3.h"

namespace polhode {

GltfTrack TrackMaker::track(const KeyedPoses& keys, int components, const Value& value) {
  auto values = std::make_shared<std::vector<float>>();
  values->reserve(keys.poses.size() * static_cast<std::size_t>(components));
  for (const Pose& pose : keys.poses) {
    for (int i = 0; i < components; ++i)
      values->push_back(static_cast<float>(value(pose, i) + 0.0));
  }
  const auto width = static_cast<std::size_t>(components);
  for (std::size_t k = width; k < values->size(); ++k) {
    if ((*values)[k] != (*values)[k % width]) return {shared_times(keys.times), values};
  }
  return {};
}

void TrackMaker::set_poses(const Thing& thing,
                           const KeyedPoses& keys,
                           const Vec3& from,
                           GltfNode& node) {
  KeyedPoses continuous = keys;
  std::vector<Pose>& poses = continuous.poses;
  if (keys.still) poses.resize(1);
  // what is not there has no place: it is where it comes or was
  const auto there = [](const Pose& pose) {
    return !pose.size.isZero(0.0);
  };
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!there(poses[i])) poses[i] = {poses[i - 1].at, poses[i - 1].turn, Vec3::Zero()};
  }
  for (std::size_t i = poses.size() - 1; i-- > 0;) {
    if (!there(poses[i])) poses[i] = {poses[i + 1].at, poses[i + 1].turn, Vec3::Zero()};
  }
  // from one key to the next the shorter way; what is round turns as little as it can
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Quat& before = poses[i - 1].turn;
    if (thing.round) {
      const Vec3 axis = nearer_axis(thing, poses[i - 1], poses[i]);
      poses[i].turn = (turn_between(before * Vec3::UnitZ(), axis) * before).normalized();
    }
    if (before.dot(poses[i].turn) < 0.0) poses[i].turn.coeffs() *= -1.0;
  }
  node.translation = poses.front().at - from;
  node.rotation = poses.front().turn;
  if (poses.size() == 1) return;
  node.translated =
      track(continuous, 3, [&](const Pose& pose, int i) { return pose.at[i] - from[i]; });
  node.rotated =
      track(continuous, 4, [](const Pose& pose, int i) { return pose.turn.coeffs()[i]; });
}

void TrackMaker::set_size(const KeyedPoses& keys, const Size& size, GltfNode& node) {
  node.scale = size(keys.poses.front());
  if (keys.still) return;
  node.scaled = track(keys, 3, [&](const Pose& pose, int i) { return size(pose)[i]; });
}

Numbers TrackMaker::shared_times(const std::vector<double>& times) {
  std::vector<float> narrow(times.begin(), times.end());
  for (const Numbers& known : times_) {
    if (*known == narrow) return known;
  }
  times_.push_back(std::make_shared<const std::vector<float>>(std::move(narrow)));
  return times_.back();
}

}  // namespace polhode
