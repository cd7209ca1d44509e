// SPDX-License-Identifier: MIT
// Composes the picture of a motion at any time: the draw list and the labels.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "frame/elements.h"
#include "frame/seen_labels.h"
#include "frame/timeline.h"

namespace polhode {

// What a camera sees at one moment.
struct CameraView {
  DrawList list;
  LabelView names;
  std::optional<Vec2> way_to_body = {};  // Camera::way_to(), of a body that is shown
};

// How the motion is filmed: cameras, time and margins.
struct Staging {
  CameraSpec camera;                 // until the first shot begins
  std::vector<ShotSpec> shots = {};  // in any order
  Timeline timeline;
  FrameMargins margins = {};  // for automatic cameras
};

class Composer;

// What pictures side by side have in common.
struct Shared {
  std::optional<Scale> scale = {};                           // absent: its own
  std::vector<Motion> ensemble = {};                         // shown beside the motion
  std::vector<std::shared_ptr<const Composer>> beside = {};  // automatic cameras show all of them
};

// Immutable, with copies of all that it is made from. All members are pure functions of time and
// may be called from any thread; those that take a time throw Error (check_failed) as Motion::at
// does. Glyphs and cameras are in S, m; draw lists in the units of their drawing frame.
class Composer {
 public:
  // Throws Error (input) naming the key: show.NAME for an element that is asked for but that this
  // motion does not have, show.body_opacity below 1 with cones, camera.eye at the target, a
  // camera.direction of zero (shots[i].* for a shot), motion.position for a body too small to be
  // drawn so far from the origin; and Error as make_scenery does. `body` is that of the motion;
  // size: of the camera's picture.
  Composer(const Motion& motion,
           const BodySpec& body,
           const Staging& staging,
           const ShowSpec& show,
           const ThemeSpec& theme,
           PictureSize size,
           const Shared& shared = {});
  // With a single camera and without a story: film time is motion time. Throws Error likewise.
  Composer(const Motion& motion,
           const BodySpec& body,
           const CameraSpec& camera,
           const ShowSpec& show,
           const ThemeSpec& theme,
           PictureSize size);
  // Another motion of the same body with the same cameras and scales. The drawn paths, and what
  // CameraSpec::follow follows, are those of the new motion. From `fails` on (s of motion), if it
  // is given, its vectors, angles and cones are not drawn. Throws Error as make_paths does.
  Composer(const Composer& other, const Motion& motion, std::optional<double> fails = {});

  // The view at the time `film` (s of film). After `end` (s of motion) the motion stands still.
  CameraView camera_view(double film, double end) const;
  // Its labels alone.
  LabelView label_view(double film, double end) const;
  // The draw list at the time t (s of motion).
  DrawList at(double t) const;
  // Warnings, which are not thrown, with the key concerned: shots[i].at for a shot that is never
  // seen, shots[i].move for one that does not come to its end, motion.duration for paths with
  // corners, camera.eye or shots[i].eye for a camera that sees nothing or comes inside the body,
  // camera or shots[i] for a body that is always smaller than a pixel from there. Empty: none.
  std::vector<Error> warnings() const;

  // The camera at the start of the film.
  Camera camera() const { return camera_at(0.0); }
  // The camera at the time `film` (s of film).
  Camera camera_at(double film) const;
  // The number of cameras: that of the scene and one for each shot, in the order in which they
  // come.
  std::size_t cameras() const { return rigs_.size(); }
  // One of them at the time `film` (s of film), whether or not the film is seen by it then.
  Camera camera_at(double film, std::size_t index) const;
  // The first time after `film` at which the film is cut to another camera, s of film; infinite:
  // never.
  double next_cut(double film) const;
  // References to members.
  const Timeline& timeline() const { return staging_.timeline; }
  const Scenery& scenery() const { return scenery_; }
  // Whether the element is shown in this film; `name` is that of one of elements().
  bool shows(const std::string& name) const { return shown_.at(name); }
  // The glyphs of a moment; `film` in s of film, by default the last film time that shows the
  // sample.
  Glyphs glyphs_at(const Sample& sample) const;
  Glyphs glyphs_at(const Sample& sample, double film) const;

 private:
  // A camera of the scene in its rig, and when it takes over.
  struct Rig {
    CameraSpec spec;
    double begins = 0.0;  // s of the film
    double move = 0.0;
    Camera camera;
    std::optional<std::size_t> shot = {};  // its index; absent: the scene's camera
  };
  std::vector<Error> warnings_of_shots() const;
  // The index of the one that the film is seen by then.
  std::size_t rig_at(double film) const;
  std::optional<Error> warning_of_unseen() const;
  std::vector<double> film_times() const;
  // The glyphs shown at that film time; without one, all that are ever shown. for_framing: as in
  // Glyphs.
  Glyphs glyphs_of(const Sample& sample, std::optional<double> film, bool for_framing = true) const;
  // What a camera follows: never "auto".
  std::string follow_of(const CameraSpec& spec, PictureSize size) const;
  bool is_larger_followed(CameraSpec spec, PictureSize size) const;
  bool is_small_on_table(CameraSpec spec, PictureSize size) const;
  bool keeps_place_in_space() const;
  Eigen::Isometry3d rig_from_space(const CameraSpec& spec, double film) const;
  // a camera where its rig has taken it
  Camera placed(const Rig& rig, double film) const;
  Vec3 turn_between_rigs(const Rig& from, const Rig& to, double film) const;
  std::vector<Vec3> own_points(const CameraSpec& spec) const;
  // with those of the pictures beside it
  std::vector<Vec3> points_to_frame(const CameraSpec& spec) const;
  std::vector<Rig> make_rigs(PictureSize size) const;
  // Radii in pixels where things are closest to their cameras.
  struct Largest {
    double body = 0.0;
    double cone = 0.0;        // of rims
    double tube = 0.0;        // shafts of arrows, rods, arcs
    double head = 0.0;        // of arrows
    std::vector<Cone> cones;  // all that were seen
  };
  Largest largest_on_screen() const;
  std::optional<Vec2> way_to_body(const Sample& sample, double film, const Camera& camera) const;

  Scenery scenery_;
  std::map<std::string, bool> shown_;
  GlyphMeshes meshes_;
  DrawingFrame drawing_;
  Staging staging_;
  std::optional<double> fails_;  // s of motion
  std::vector<std::shared_ptr<const Composer>> beside_;
  std::vector<Rig> rigs_;  // in the order in which they come
  Ball body_B_;            // around the body, in B
};

}  // namespace polhode
