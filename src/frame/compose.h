// SPDX-License-Identifier: MIT
// From a motion to pictures: the draw list of any moment, made from exact quantities.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "frame/elements.h"

namespace polhode {

// A label where the camera sees it: pixels, x to the right, y down.
struct SeenLabel {
  Vec2 from;  // where the vector that it names begins; `at` if it names a point
  Vec2 at;
  Vec2 away;  // unit
  std::string markup;
  glm::vec3 color;
};

// What a camera sees at one moment.
struct Shot {
  DrawList list;
  std::vector<SeenLabel> labels;
};

// Immutable; shot() and at() are pure functions of t and may be called from any thread.
class Composer {
 public:
  // Throws Error (input) when [show] asks for what this motion does not have.
  Composer(const Motion& motion,
           const BodySpec& body,
           const CameraSpec& camera,
           const ShowSpec& show,
           const ThemeSpec& theme,
           FrameSize size,
           const FrameMargins& margins = {});
  // The same picture, with the same camera and scale, of another motion of the same body.
  Composer(const Composer& other, const Motion& motion);

  Shot shot(double t) const;
  DrawList at(double t) const { return shot(t).list; }
  // What a viewer of this film may miss, with the key at fault: a camera of the scene's own that
  // sees nothing or is inside the body, a body smaller than a pixel.
  std::vector<Error> warnings() const;

  const Camera& camera() const { return camera_; }
  const Stage& stage() const { return stage_; }
  // Is the element of that name shown?
  bool shows(const std::string& name) const { return shown_.at(name); }
  // The geometry of this moment, as drawn; for tests and for at().
  Marks marks_at(const Sample& sample) const;

 private:
  std::vector<Vec3> points_to_frame() const;
  SeenLabel seen(const LabelMark& label) const;

  Stage stage_;
  std::map<std::string, bool> shown_;
  MarkMeshes meshes_;
  DrawingFrame drawing_;
  Camera camera_;
};

// How far the attitude may be off, in rad, so that no drawn point moves by more than this many
// pixels. An upper bound that needs no motion: what is drawn reaches at most kReachOfVectors times
// the body's radius (m, from the reference point).
double attitude_tolerance(const CameraSpec& camera,
                          double pixels,
                          double body_radius,
                          FrameSize size);

}  // namespace polhode
