// SPDX-License-Identifier: MIT
// From a motion to pictures: the draw list of any moment, made from exact quantities.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "frame/elements.h"
#include "frame/timeline.h"

namespace polhode {

// A label where the camera sees it: pixels, x to the right, y down.
struct SeenLabel {
  Vec2 from;  // where the vector that it names begins; `at` if it names a point
  Vec2 at;
  Vec2 away;  // unit
  std::string markup;
  glm::vec3 color;
  float fade = 1.0f;
};

// What a camera sees at one moment.
struct CameraView {
  DrawList list;
  std::vector<SeenLabel> labels;
};

// How a picture is taken: cameras, and the room that they leave at the sides.
struct Staging {
  CameraSpec camera;
  std::vector<ShotSpec> shots = {};
  Timeline timeline;
  FrameMargins margins = {};
};

// Immutable; all of it are pure functions of time and may be called from any thread.
class Composer {
 public:
  // Throws Error (input) when [show] asks for what this motion does not have.
  Composer(const Motion& motion,
           const BodySpec& body,
           const Staging& staging,
           const ShowSpec& show,
           const ThemeSpec& theme,
           PictureSize size);
  // With one camera, the film's clock that of the motion.
  Composer(const Motion& motion,
           const BodySpec& body,
           const CameraSpec& camera,
           const ShowSpec& show,
           const ThemeSpec& theme,
           PictureSize size);
  // The same picture, with the same camera and scale, of another motion of the same body; its
  // paths are those of that motion.
  Composer(const Composer& other, const Motion& motion);

  // At a moment of the film; the motion stands still behind `end` (s of the motion).
  CameraView camera_view(double film, double end) const;
  // At a moment of the motion.
  DrawList at(double t) const;
  // What a viewer of this film may miss, with the key at fault: a camera of the scene's own that
  // sees nothing or is inside the body, a body smaller than a pixel.
  std::vector<Error> warnings() const;

  // The camera at the start.
  Camera camera() const { return camera_at(0.0); }
  // The camera at a moment of the film.
  Camera camera_at(double film) const;
  const Timeline& timeline() const { return staging_.timeline; }
  const Scenery& scenery() const { return scenery_; }
  // Is the element of that name shown?
  bool shows(const std::string& name) const { return shown_.at(name); }
  // The geometry of this moment, as drawn; for tests and for at().
  Glyphs glyphs_at(const Sample& sample) const;
  Glyphs glyphs_at(const Sample& sample, double film) const;

 private:
  // A camera of the scene: where it stands in its rig, and how the rig moves.
  struct Rig {
    CameraSpec spec;
    double begins = 0.0;  // s of the film
    double move = 0.0;
    Camera camera;
  };
  std::vector<double> film_times() const;
  // What is shown at a moment of the film; without one, all that is ever shown.
  Glyphs glyphs_of(const Sample& sample, std::optional<double> film) const;
  Eigen::Isometry3d rig_from_space(const CameraSpec& spec, double film) const;
  std::vector<Vec3> points_to_frame(const CameraSpec& spec) const;
  std::vector<Rig> make_rigs(PictureSize size) const;
  // Radii in pixels, where things come nearest to their cameras.
  struct Largest {
    double body = 0.0;
    double cone = 0.0;  // of rims
    double tube = 0.0;  // shafts of arrows, rods, arcs
    double head = 0.0;  // of arrows
  };
  Largest largest_on_screen() const;
  SeenLabel seen(const LabelGlyph& label, const Camera& camera) const;

  Scenery scenery_;
  std::map<std::string, bool> shown_;
  GlyphMeshes meshes_;
  DrawingFrame drawing_;
  Staging staging_;
  std::vector<Rig> rigs_;  // in the order in which they come
};

// How far the attitude may be off, in rad, so that no drawn point moves by more than this many
// pixels. An upper bound that needs no motion: what is drawn reaches at most kReachOfVectors times
// the body's radius (m, from the reference point).
double attitude_tolerance(const CameraSpec& camera,
                          double pixels,
                          double body_radius,
                          PictureSize size);

}  // namespace polhode
