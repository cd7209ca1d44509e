// SPDX-License-Identifier: MIT
// A solved scene as a glTF document: what its film shows, as nodes that move as the bodies do.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "export/gltf_document.h"
#include "export/gltf_looks.h"
#include "export/key_times.h"
#include "film/solving.h"

namespace polhode {

// What is to be written.
struct ExportPlan {
  std::optional<double> from, to;  // s of motion; absent: start and end of the motion or its loop
  std::string author, licence;     // empty: none
  // How far what a player makes of the file may be from the exact motion: pixels of a picture 1080
  // pixels high, where the film's cameras see it largest; or radians, of a body turned about its
  // reference point.
  double pixels = 0.1;
  std::optional<double> radians = {};  // absent: `pixels` counts
  PaintMarks paint = nullptr;          // textures of marked bodies; null: they have none
  // Is told what is being followed, again and again; empty: nobody is.
  std::function<void(const std::string& words)> tell = {};
};

// What was found.
struct ExportReport {
  std::size_t keys = 0;           // key times of all nodes together
  double tolerance = 0.0;         // m
  double farthest = 0.0;          // how far the body goes from the origin of the file, m
  double error = 0.0;             // as measured, and of places that far away in single precision, m
  double pixels_per_metre = 0.0;  // where the film's cameras see things largest, 1080 pixels high
};

// The document and what was found. Below the root, which turns S so that its Z is up, coordinates
// are those of S (m) from `origin`, the reference point at the start; the node "body_frame" moves
// with the body axes from the body origin. Nodes are named after the elements that they belong to
// (docs/export.md). Things that keep their place in the body are below "body_frame". Stories hide
// nothing. The time of the animation is film time without pauses. Throws Error (input) with --from
// or --to as key as check_time_range() and plan_frame_times() (film/frame_times.h) do, with
// show.trail_length as key if it is too short to be cut into pieces, without a place for a motion
// that is too long to be tabulated, as composer_alone() (film/stage.h) does;
// (check_failed) as Motion::at does.
struct ExportedScene {
  GltfDocument document;
  ExportReport report;
};
ExportedScene export_scene(const Solved& solved, const ExportPlan& plan);

// The finest accuracy that numbers of single precision hold, rad.
inline constexpr double kFinestPlayback = 1e-6;

}  // namespace polhode
