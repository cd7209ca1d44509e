// SPDX-License-Identifier: MIT
#include "app/render_film.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "app/comparison.h"
#include "app/film_marks.h"
#include "app/film_plan.h"
#include "app/report.h"
#include "app/version.h"
#include "base/atomic_file.h"
#include "base/console.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/nearest.h"
#include "frame/film.h"
#include "image/average.h"
#include "render/renderer.h"
#include "video/encoders.h"
#include "video/film_output.h"
#include "video/pipeline.h"
#include "video/plain_sinks.h"

namespace polhode {
namespace {

const Quality& find_quality(const std::string& name) {
  std::vector<std::string> names;
  for (const Quality& row : qualities()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  throw input_error("no quality is called '{}'{}", name, suggestion(name, names))
      .at({{}, 0, "--quality"});
}

// a .png without a number in its name is one picture, and only that takes --still
bool is_still(const RenderJob& job, const std::string& output) {
  const bool numbered = output.find('%') != std::string::npos;
  const bool picture = output.ends_with(".png") && !numbered && !output.starts_with(kHashPrefix);
  if (job.still && output.ends_with(".png") && numbered) {
    throw input_error("makes one picture, but '{}' numbers its pictures; leave out the %", output)
        .at({{}, 0, "--still"});
  }
  if (job.still && find_sink_kind(output).film) {
    throw input_error("makes one picture, but '{}' is a film; name a .png", output)
        .at({{}, 0, "--still"});
  }
  return job.still || picture;
}

// the default name; its folder is made if need be
std::string output_of(const RenderJob& job) {
  if (!job.output.empty()) return job.output;
  std::error_code ignored;  // the file's own error tells what is wrong
  std::filesystem::create_directory("output", ignored);
  return "output/" + job.scene.stem().string() + (job.still ? ".png" : ".mp4");
}

SinkJob sink_job(const RenderJob& job,
                 const Scene& scene,
                 const Quality& quality,
                 const std::string& output,
                 bool still) {
  SinkJob sink;
  sink.output = output;
  sink.width = scene.video.size.width;
  sink.height = scene.video.size.height;
  sink.fps = scene.video.fps;
  sink.encoder =
      settle_encoder(output, {quality.grade, quality.preset, job.codec, job.preset, job.crf});
  sink.transparent = job.transparent;
  sink.still = still;
  sink.title = scene.title;
  sink.comment = fmt::format("polhode {}, scene {}", program_version(), scene_hash(scene));
  return sink;
}

Scene without_text(Scene scene) {
  scene.show.labels = false;
  scene.show.title = false;
  scene.show.clock = false;
  scene.show.caption.clear();
  for (StoryStep& step : scene.story)
    step.caption.reset();
  return scene;
}

Scene shrunk(Scene scene, int factor) {
  // even sides stay even
  PictureSize& size = scene.video.size;
  if (factor > 1) {
    size.width = std::max(kSmallestSide, size.width / (2 * factor) * 2);
    size.height = std::max(kSmallestSide, size.height / (2 * factor) * 2);
  }
  return scene;
}

// the wheels of coaches in films
void warn_of_backward_turning(const Scene& scene, const Motion& motion, const Frames& frames) {
  constexpr double kBlurring = kPi;  // an angle of the shutter beyond which nothing seems to turn
  if (frames.count < 2 || scene.video.shutter >= kBlurring) return;
  double fastest = 0.0;
  const int looks = std::min(frames.count, 200);
  for (int i = 0; i < looks; ++i) {
    const double t = frames.from + (frames.to - frames.from) * i / looks;
    fastest = std::max(fastest, motion.at(t).w_B.norm());
  }
  const std::optional<std::string> words =
      turns_backwards(fastest, scene.video.time_scale / frames.rate);
  if (!words) return;
  const Error warning = input_error(
      "{}: take a higher video.fps, a smaller video.time_scale, or blur it with "
      "video.shutter_deg = 360",
      *words);
  spdlog::warn("{}", placed(scene, warning.at({{}, 0, "video.fps"})).what());
}

void warn_of_missing_fonts() {
  for (const FontFound& font : examine_fonts()) {
    if (font.there) continue;
    spdlog::warn("the font {} is missing, {} serves instead; install {}",
                 font.wanted,
                 font.found.empty() ? "another" : font.found,
                 font.package);
  }
}

// as many as leave no gaps: the body turns by a few degrees from one to the next
int moments_of_shutter(const Motion& motion, const Scene& scene, double open) {
  constexpr double kTurn = 0.06;  // rad
  constexpr int kMost = 48;
  if (open <= 0.0) return 1;
  double fastest = 0.0;
  for (const double t : framing_times(motion))
    fastest = std::max(fastest, motion.at(t).w_B.norm());
  const double turned = fastest * open * scene.video.time_scale;
  return std::clamp(static_cast<int>(std::ceil(turned / kTurn)), 4, kMost);
}

double process_cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

const std::vector<Quality>& qualities() {
  static const std::vector<Quality> table = {
      {"draft", "half size, fast", 2, "ultrafast", Grade::draft},
      {"lecture", "for projection", 1, "veryfast", Grade::lecture},
      {"archive", "for keeping, slow", 1, "slow", Grade::archive},
  };
  return table;
}

void render_film(const RenderJob& job) {
  const auto wall_start = std::chrono::steady_clock::now();
  const Quality& quality = find_quality(job.quality);

  // load and check everything that can be checked before work begins
  Scene asked = load_with_overrides(job.scene, job.overrides);
  const std::vector<StoryStep> story = asked.story;  // with its words, whatever the picture shows
  if (!job.text) asked = without_text(std::move(asked));
  const Scene scene = shrunk(std::move(asked), quality.shrink);
  const std::string output = output_of(job);
  const bool still = is_still(job, output);
  const Piece piece{job.from, job.to, job.still, still};
  check_piece(scene, piece);
  const SinkJob sink_settings = sink_job(job, scene, quality, output, still);
  refuse_same_file(output, "the output", job.scene);
  refuse_same_file(job.report, "--report", job.scene);
  if (output == kStandardOutput && job.report == kStandardOutput) {
    throw input_error("the film goes to standard output already; name a file")
        .at({{}, 0, "--report"});
  }
  refuse_same_file(job.report, "--report", output);
  if (!story.empty()) refuse_same_file(job.report, "--report", captions_beside(output));
  std::unique_ptr<AtomicFile> report_file;
  if (!job.report.empty() && job.report != "-")
    report_file = std::make_unique<AtomicFile>(job.report);
  const std::unique_ptr<FrameSink> sink = make_sink(sink_settings);

  // simulate
  const Solved solved = solve(scene);
  const Frames frames = with_place(scene, [&] { return plan_frames(solved, piece); });
  std::unique_ptr<Comparison> comparison;
  if (!scene.numerics.compare.empty())
    comparison = std::make_unique<Comparison>(solved, scene.video.time_scale / frames.rate);
  sink->describe(film_marks(scene, story, frames));
  const Film film = with_place(
      scene, [&] { return make_film(solved, frames.timeline, comparison.get(), job.text); });
  if (job.text) warn_of_missing_fonts();
  if (frames.loop && frames.loop->residual > scene.video.loop_residual) {
    const Error warning = input_error(
        "the motion comes back to its start only to {:.2g} degrees (after {:.4g} s); give it a "
        "longer "
        "motion.duration to look in",
        frames.loop->residual * 180.0 / kPi,
        frames.loop->duration);
    spdlog::warn("{}", placed(scene, warning.at({{}, 0, "video.loop"})).what());
  }

  for (const Error& warning : film.panels().front().composer->warnings())
    spdlog::warn("{}", placed(scene, warning).what());
  warn_of_backward_turning(scene, solved.simulation.motion, frames);

  // open the drawing side; the threads that start here are the rasteriser's
  const std::set<int> threads_before = thread_ids();
  const std::unique_ptr<Context> context = open_context(job.backend);
  Renderer renderer(*context,
                    {scene.video.size.width, scene.video.size.height, 4, job.transparent});
  std::set<int> rasteriser = thread_ids();
  for (const int id : threads_before)
    rasteriser.erase(id);

  // how long the shutter is open, s of film, and in how many pictures that is seen
  const double open = scene.video.shutter / (2.0 * kPi) / frames.rate;
  const int moments = moments_of_shutter(solved.simulation.motion, scene, open);
  AveragePicture blurred;

  // compose and draw here, convert and encode behind the queue
  StageTime compose_time;
  Progress progress(job.progress, frames.count);
  const auto produce = [&](int index, Image& image) {
    const auto composed = [&](double film_time) {
      const StageTimer timer(compose_time);
      return film.at(film_time);
    };
    Picture picture = composed(frames.film_time(index));
    if (moments == 1) {
      renderer.draw(picture, image);
      return;
    }
    // what moves while the shutter is open; the text stands still
    for (int k = 0; k < moments; ++k) {
      Picture moment = composed(frames.film_time(index) + open * (k + 0.5) / moments);
      moment.stamps.clear();
      renderer.draw(moment, image);
      blurred.add(image);
    }
    blurred.mean(image);
    for (const Stamp& stamp : picture.stamps)
      lay_over(image, stamp);
  };
  run_pipeline(frames.count, produce, *sink, [&](int done) { progress.show(done); });

  // report
  if (job.report.empty()) return;
  FilmFacts facts{output,
                  frames.count,
                  frames.from,
                  frames.to,
                  job.transparent,
                  sink_settings.encoder,
                  renderer.info(),
                  {}};
  facts.times = {solved.simulate_time,
                 compose_time,
                 renderer.times().draw,
                 renderer.times().read_back,
                 renderer.times().smooth,
                 sink->times().convert,
                 sink->times().encode,
                 {}};
  ThreadClocks clocks(rasteriser);
  clocks.read();
  facts.times.draw.cpu_s += clocks.total();
  facts.times.total.wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  facts.times.total.cpu_s = process_cpu_seconds();
  nlohmann::ordered_json told = film_report(solved, facts);
  if (comparison) told["compare"] = comparison->report();
  if (frames.loop) {
    told["loop"] = {{"duration_s", frames.loop->duration}, {"residual_rad", frames.loop->residual}};
  }
  const std::string report = told.dump(2) + "\n";
  if (report_file == nullptr) {
    print_out(report);
  } else {
    report_file->commit_with(report);
  }
}

}  // namespace polhode
