// SPDX-License-Identifier: MIT
// Follows what a film shows through the motion: glyphs of one moment become things that keep their
// mesh and move.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "frame/compose.h"

namespace polhode {

// Where a thing is at one moment. A point p of it, in its own coordinates, is at
// at + turn * (size times p, by components), in S, m.
struct Pose {
  Vec3 at = Vec3::Zero();  // S, m
  Quat turn = Quat::Identity();
  Vec3 size = Vec3::Zero();  // factors; zero while the thing is not there
};

// What a thing is made of.
enum class ThingKind {
  mesh,   // its mesh
  arrow,  // a unit cylinder and a unit cone; size: shrinking of its shape, the same, its length (m)
  rod,    // a unit cylinder; size: radius, radius, length (m)
  arc,    // pieces of a tube in the plane of its x and y, from x on; size: radius (m), tube (m),
          // angle (rad)
  label,  // nothing; z is the direction in which the text stands beside `at`; size: 1
};

// A thing that is drawn, for as long as the film lasts.
struct Thing {
  std::string element;  // name of the element that draws it, or "points"
  ThingKind kind = ThingKind::mesh;
  bool round = false;  // it may turn about its z unnoticed: of turn, only that direction counts
  MeshPtr mesh = {};   // of a mesh
  Material material = {};
  bool both_sides = false;  // its insides are seen too
  ArrowShape shape = {};    // of an arrow, m
  LabelGlyph label = {};    // of a label, as when it was first seen
  Vec3 low = Vec3::Zero();  // corners of the box of its mesh, its own coordinates
  Vec3 high = Vec3::Zero();
};

// A path that grows with the motion.
struct ObservedTrail {
  std::string element;
  const Trail* trail = nullptr;  // of the composer's scenery
  Material material = {};
  double length = 0.0;   // the longest part that was seen, s of motion
  bool on_body = false;  // the path is in B, else in S
};

// Everything that a composer draws but shadows, as things. Elements are seen as if the story hid
// none of them. Not thread-safe; the composer must outlive it.
class Observer {
 public:
  // segments: pieces that stand for a full circle in the unit meshes of cones.
  Observer(const Composer& composer, int segments);

  // The poses of all things at the time t (s of motion), by the index of the thing; a thing that
  // was never seen up to now is missing at the end. Seen once, a moment is kept. The reference is
  // valid as long as the observer. Throws Error (check_failed) as Motion::at does.
  const std::vector<Pose>& at(double t);
  // All things that were ever seen, and all paths. `at` adds to them.
  const std::vector<Thing>& things() const { return things_; }
  const std::vector<ObservedTrail>& trails() const { return trails_; }
  // The pose of a thing at a time.
  Pose pose(std::size_t thing, double t);

 private:
  const Sample& sample_at(double t);
  // what the element of that name, or what stands beside the table of elements, draws
  void look_at(const std::string& name, double t, std::vector<Pose>& poses);
  std::size_t index_of(const std::string& key, const Thing& thing);
  void add_meshes(const std::string& element,
                  const char* kind,
                  const std::vector<MeshGlyph>& glyphs,
                  bool both_sides,
                  std::vector<Pose>& poses);
  void add_paths(const std::string& element, const std::vector<PathGlyph>& paths);
  void add_cones(const std::string& element,
                 const std::vector<Cone>& cones,
                 std::vector<Pose>& poses);
  void add_lines(const std::string& element, const Glyphs& glyphs, std::vector<Pose>& poses);
  void add_labels(const std::string& element, const Glyphs& glyphs, std::vector<Pose>& poses);
  void add_glyphs(const std::string& element, const Glyphs& glyphs, std::vector<Pose>& poses);
  void put(std::size_t index, const Pose& pose, std::vector<Pose>& poses) const;

  const Composer& composer_;
  int segments_;
  MeshPtr shell_;
  MeshPtr floor_;  // without what lies on it
  std::vector<Thing> things_;
  std::vector<ObservedTrail> trails_;
  std::map<std::string, std::size_t> indices_;
  std::map<std::string, double> tubes_;  // of rims, in their rings, as when they were first seen
  std::map<double, Sample> samples_;
  std::map<double, std::vector<Pose>> moments_;  // of all things
  // the things of one element, and where they were seen without the others
  struct Together {
    std::vector<std::size_t> things;
    std::map<double, std::vector<Pose>> seen;
  };
  std::map<std::string, Together> of_element_;
  std::vector<std::pair<Together*, std::size_t>> places_;  // of each thing: where, and which there
};

// Where the z of a round thing points to in b, S; the other way where that is nearer to how it
// points in a, if nobody can tell.
Vec3 nearer_axis(const Thing& thing, const Pose& a, const Pose& b);

// The pose as it is between two keys at the fraction `part` (0..1), played back: places and sizes
// linear, turns by slerp.
Pose between(const Thing& thing, const Pose& a, const Pose& b, double part);

// How far, at most, points of the thing in one pose are from the same points in another, m.
double distance(const Thing& thing, const Pose& a, const Pose& b);

}  // namespace polhode
