// SPDX-License-Identifier: MIT
// The record of a film: what was requested, computed and made. `render` writes it as the JSON
// report and `verify` reads it, both from one list of fields.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film/frame_renderer.h"
#include "film/output/render_output.h"
#include "film/prepared_film.h"
#include "film/report/motion_report.h"

namespace polhode {

// The settings of the encoder, see EncoderSettings (video/video_spec.h), which also has the
// defaults. Absent: the format has no such setting.
struct EncoderRecord {
  std::optional<std::string> codec, preset;
  std::optional<int> crf;
  int threads = 2;
  bool finest = false;
};

// Lists the keys of "encoder".
template <class Visitor>
void report_fields(Visitor& v, EncoderRecord& s) {
  v.field("codec", s.codec);
  v.field("preset", s.preset);
  v.field("crf", s.crf);
  v.field("threads", s.threads);
  v.field("finest", s.finest);
}

// Time spent in each stage of a film: computing the motion, the members of DrawingTimes (summed
// over processes), and those of SinkTimes.
struct FilmTimes {
  StageTime simulate, compose, draw, read_back, smooth, convert, encode;
};

// Lists the keys of "stages".
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

// Lists the keys of "loop".
template <class Visitor>
void report_fields(Visitor& v, Loop& s) {
  v.field("duration_s", s.duration);
  v.field("residual_rad", s.residual);
}

// The content of the report.
struct FilmReport {        // NOLINT(bugprone-exception-escape): JSON moves without throwing
  std::string output;      // as the user named it
  std::string scene_file;  // as the user named it
  std::string title;       // of the scene
  std::string scene_hash;  // scene_hash() (scene/scene.h) of `scene`
  Json versions;           // versions() of film/report/motion_report.h
  std::string backend, gl_renderer, gl_version;  // RendererInfo in render/renderer.h
  int samples = 0;                               // per pixel, RendererInfo::samples
  std::string edges;  // how edges are antialiased: "outlines" or "samples"
  SimulationReport motion;
  int frames = 0;    // number of frames of this output, with those that an earlier run has made
  PictureSize size;  // pixels
  FrameRate fps;     // frames per second of film
  double from_s = 0.0, to_s = 0.0;  // s of motion that the whole film covers
  // As in RenderJob (film/render_plan.h), but still: true for a single picture.
  bool transparent = false, text = true, still = false, resume = false;
  std::optional<int> pieces;         // of --resume, if their number was given
  std::optional<std::string> shard;  // "K/N"; absent: the whole film
  int first_frame = 0;               // number of the first frame in the film; 0 except for shards
  int jobs = 1;                      // processes that drew
  std::vector<std::optional<std::string>> captions;  // of each step of the story; absent: none
  EncoderRecord encoder;
  FilmTimes stages;
  StageTime total;                        // of the run; cpu_s: of all processes
  Json scene;                             // scene_to_json() (scene/canonical.h), in SI
  std::vector<std::string> frame_hashes;  // frame_hash() (video/plain_sinks.h) of each frame
  // Comparison::report() (film/comparison.h); absent: no methods are compared
  std::optional<Json> compare;
  // Of a film of several scenes: its file, cameras and scales as FilmFile has them, and "panels",
  // for each caption, scene_file, scene_hash, the keys of its SimulationReport, and
  // scene_to_json(). Absent: it shows one scene.
  std::optional<Json> film;
  std::optional<Loop> loop;  // how well the film closes; absent: it does not loop
};

// The keys of the report; docs/render.md documents them. Absent values of `field` keys are written
// as null, `optional` keys are left out (film/report/json_fields.h). To add a key: a line here and
// a member above.
template <class Visitor>
void report_fields(Visitor& v, FilmReport& s) {
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
  v.optional("pieces", s.pieces);
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
  v.optional("film", s.film);
  v.optional("loop", s.loop);
}

// The record of a film that `renderer` has drawn into `output`, whose sink is finished. `total` is
// left for the caller to set. Throws Error as FrameRenderer::info does.
FilmReport film_report(const RenderPlan& plan,
                       const PreparedFilm& film,
                       const RenderOutput& output,
                       const FrameRenderer& renderer);

}  // namespace polhode
