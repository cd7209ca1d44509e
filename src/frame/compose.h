// SPDX-License-Identifier: MIT
// From a motion to pictures: the draw list of any moment, made from exact quantities.
#pragma once

#include <string>
#include <vector>

#include "frame/arrow.h"
#include "frame/body_look.h"
#include "frame/camera.h"
#include "frame/cone.h"
#include "frame/theme.h"
#include "frame/view_spec.h"
#include "motion/motion.h"

namespace polhode {

// ShowSpec with every default resolved.
struct Shown {
  bool body = true;
  bool axes = false;
  bool space_axes = false;
  bool omega = true;
  bool momentum = true;
  bool space_cone = false;  // free symmetric tops that wobble
  bool body_cone = false;
  bool precession_cone = false;  // bodies on a pivot
  bool pivot = false;
};

// Lengths of what is drawn, in metres of the scene.
struct Scale {
  double body = 1.0;      // farthest drawn point of the body from the reference point
  double omega = 1.0;     // metres per rad/s
  double momentum = 1.0;  // metres per kg m^2/s
};

// Immutable; at() is a pure function of t and may be called from any thread.
class Composer {
 public:
  // Throws Error (input) when [show] asks for what this motion does not have.
  Composer(const Motion& motion,
           const BodySpec& body,
           const CameraSpec& camera,
           const ShowSpec& show,
           const ThemeSpec& theme,
           FrameSize size);

  DrawList at(double t) const;
  // What a viewer of this film may miss, one line each: a camera of the scene's own that sees
  // nothing or is inside the body, a body smaller than a pixel.
  std::vector<std::string> warnings() const;

  const Camera& camera() const { return camera_; }
  const Shown& shown() const { return shown_; }
  const Scale& scale() const { return scale_; }
  // The cones of this moment, as drawn; for tests and for at().
  std::vector<Cone> cones_at(const Sample& sample) const;
  // Where the tips of the two vectors are drawn, space, m.
  Vec3 omega_tip(const Sample& sample) const;
  Vec3 momentum_tip(const Sample& sample) const;

 private:
  Camera make_camera(const CameraSpec& spec, FrameSize size) const;
  std::vector<Vec3> points_to_frame() const;
  DrawingFrame make_drawing_frame() const;
  void add_vector(DrawList& list,
                  const Vec3& from,
                  const Vec3& tip,
                  const ArrowShape& shape,
                  const glm::vec3& color,
                  float gloss) const;
  Vec3 figure_axis_B() const;
  void add_body(DrawList& list, const Sample& sample) const;
  void add_axes(DrawList& list, const Sample& sample) const;
  void add_stand(DrawList& list) const;
  bool stays_above_stand() const;

  Motion motion_;
  Theme theme_;
  std::vector<LookPart> look_;
  Scale scale_;
  Shown shown_;
  ArrowMeshes arrows_;
  ConeMeshes cones_;
  DrawingFrame drawing_;
  Camera camera_;
};

// How far the attitude may be off, in rad, so that no drawn point moves by more than this many
// pixels. An upper bound that needs no motion: what is drawn reaches at most kReach times the
// body's radius (m, from the reference point).
double attitude_tolerance(const CameraSpec& camera,
                          double pixels,
                          double body_radius,
                          FrameSize size);

// The distance of the farthest drawn body point from the reference point, m.
double body_radius(const std::vector<LookPart>& look, const Model& model);

}  // namespace polhode
