// SPDX-License-Identifier: MIT
// The record of a film: what was asked, what was found, and what was made. The JSON report is
// written and read by the one list of its fields.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film/frame_renderer.h"
#include "film/motion_report.h"
#include "film/output/render_output.h"
#include "film/prepared_film.h"

namespace polhode {

// What the encoder was told; absent: the format has none.
struct EncoderRecord {
  std::optional<std::string> codec, preset;
  std::optional<int> crf;
  int threads = 2;
  bool finest = false;
};

template <class Visitor>
void report_fields(Visitor& v, EncoderRecord& s) {
  v.field("codec", s.codec);
  v.field("preset", s.preset);
  v.field("crf", s.crf);
  v.field("threads", s.threads);
  v.field("finest", s.finest);
}

// Times of the stages that make a film.
struct FilmTimes {
  StageTime simulate, compose, draw, read_back, smooth, convert, encode;
};

template <class Visitor>
void report_fields(Visitor& v, FilmTimes& s) {
  v.field("simulate", s.simulate);
  v.field("compose", s.compose);
  v.field("draw", s.draw);
  v.field("read_back", s.read_back);
  v.field("smooth", s.smooth);
  v.field("convert", s.convert);
  v.field("encode", s.encode);
}

template <class Visitor>
void report_fields(Visitor& v, Loop& s) {
  v.field("duration_s", s.duration);
  v.field("residual_rad", s.residual);
}

struct FilmRecord {        // NOLINT(bugprone-exception-escape): JSON moves without throwing
  std::string output;      // as it was given
  std::string scene_file;  // as it was given
  std::string title;
  std::string scene_hash;
  Json versions;
  std::string backend, gl_renderer, gl_version;
  int samples = 0;    // per pixel
  std::string edges;  // "outlines" or "samples"
  SimulationReport motion;
  int frames = 0;  // of this output
  PictureSize size;
  FrameRate fps;
  double from_s = 0.0, to_s = 0.0;  // of the motion
  bool transparent = false, text = true, still = false, resume = false;
  std::optional<std::string> shard;  // "K/N"; absent: the whole film
  int first_frame = 0;               // of a shard
  int jobs = 1;
  std::vector<std::optional<std::string>> captions;  // of the steps of the story
  EncoderRecord encoder;
  FilmTimes stages;
  StageTime total;  // cpu: of all processes
  Json scene;       // in SI, every value
  std::vector<std::string> frame_hashes;
  std::optional<Json> compare;  // a row for each method that is compared
  std::optional<Loop> loop;     // where a film closes
};

// Keys: docs/render.md. A new one is a line here and a member above.
template <class Visitor>
void report_fields(Visitor& v, FilmRecord& s) {
  v.field("output", s.output);
  v.field("scene_file", s.scene_file);
  v.field("title", s.title);
  v.field("scene_hash", s.scene_hash);
  v.field("versions", s.versions);
  v.field("backend", s.backend);
  v.field("gl_renderer", s.gl_renderer);
  v.field("gl_version", s.gl_version);
  v.field("samples", s.samples);
  v.field("edges", s.edges);
  report_fields(v, s.motion);
  v.field("frames", s.frames);
  v.field("width", s.size.width);
  v.field("height", s.size.height);
  v.field("fps", s.fps);
  v.field("from_s", s.from_s);
  v.field("to_s", s.to_s);
  v.field("transparent", s.transparent);
  v.field("text", s.text);
  v.field("still", s.still);
  v.field("resume", s.resume);
  v.field("shard", s.shard);
  v.field("first_frame", s.first_frame);
  v.field("jobs", s.jobs);
  v.field("captions", s.captions);
  v.field("encoder", s.encoder);
  v.field("stages", s.stages);
  v.field("total", s.total);
  v.field("scene", s.scene);
  v.field("frame_hashes", s.frame_hashes);
  v.optional("compare", s.compare);
  v.optional("loop", s.loop);
}

// The record of a film that `renderer` has drawn into `output`; all but the total time.
FilmRecord film_record(const RenderPlan& plan,
                       const PreparedFilm& film,
                       const RenderOutput& output,
                       const FrameRenderer& renderer);

}  // namespace polhode
