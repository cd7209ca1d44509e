// SPDX-License-Identifier: MIT
// The JSON report of a run: what was made, from what, how, how exact and how fast.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "film/load.h"
#include "render/renderer.h"
#include "video/frame_sink.h"

namespace polhode {

// Times of every stage of a film.
struct FilmTimes {
  StageTime simulate;
  StageTime compose;
  StageTime draw;
  StageTime read_back;
  StageTime smooth;
  StageTime convert;
  StageTime encode;
  StageTime total;  // cpu: the whole process
};

// What was written.
struct FilmFacts {
  std::string output;
  int frames = 0;
  double from_s = 0.0;
  double to_s = 0.0;
  bool transparent = false;
  bool text = true;
  bool still = false;
  bool resume = false;  // encoded in pieces
  std::string shard;    // "K/N"; empty: the whole film
  int first_frame = 0;  // of a shard
  int jobs = 1;
  std::vector<std::optional<std::string>> captions;  // of the steps of the story
  std::vector<std::string> hashes;                   // of the frames
  EncoderSettings encoder;
  RendererInfo renderer;
  FilmTimes times;
};

// Keys: see docs/render.md.
nlohmann::ordered_json film_report(const Solved& solved, const FilmFacts& facts);

// How the motion was found; part of every report.
nlohmann::ordered_json motion_report(const SimulationReport& report);

// Versions of the program and of the libraries that pixels and bytes depend on.
nlohmann::ordered_json versions();

}  // namespace polhode
