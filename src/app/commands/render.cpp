// SPDX-License-Identifier: MIT
#include "app/commands/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include "app/piecewise.h"
#include "base/one_line.h"
#include "base/system/atomic_file.h"
#include "base/system/console.h"
#include "base/system/files.h"
#include "base/system/overwriting.h"
#include "base/system/scratch_folder.h"
#include "film/frame_workers.h"
#include "film/output/open_output.h"
#include "film/output/resumed_film.h"
#include "film/output/segments.h"
#include "film/report/film_report.h"
#include "video/captions.h"
#include "video/frame_sink.h"
#include "video/pipeline.h"
#include "video/plain_sinks.h"
#include "video/png_sink.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

// of this process and of those that have ended
double process_cpu_seconds() {
  double sum = 0.0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& t : {usage.ru_utime, usage.ru_stime}) {
      sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    }
  }
  return sum;
}

// whether the file has the name of a frame of the sequence, whatever its number
bool is_frame_of(const std::string& sequence, const std::string& file) {
  const auto whole = [](const std::string& name) {
    return absolute_path(name).string();
  };
  const NumberedName name = parse_numbered_name(whole(sequence));
  std::string number = whole(file);
  if (!number.starts_with(name.before) || !number.ends_with(name.after)) return false;
  if (number.size() <= name.before.size() + name.after.size()) return false;
  number.erase(number.size() - name.after.size()).erase(0, name.before.size());
  return number.find_first_not_of("0123456789") == std::string::npos;
}

// no output lands on what is needed, or on another output
void refuse_overwriting(const RenderJob& job, const RenderPlan& plan) {
  std::string output = plan.sink.output;
  if (output.starts_with(kHashPrefix)) output.erase(0, kHashPrefix.size());
  refuse_same_file(output, "the output", input_files(plan.scene));
  const bool is_sequence = output.ends_with(".png") && has_frame_number(output);
  for (const std::filesystem::path& file : input_files(plan.scene)) {
    if (is_sequence && is_frame_of(output, file)) {
      throw input_error(
          "a frame of {} would overwrite {}; choose another name", output, file.string());
    }
  }
  refuse_same_file(captions_beside(output), "its captions", input_files(plan.scene));
  refuse_same_file(job.report, "--report", input_files(plan.scene));
  if (output == kStandardOutput && job.report == kStandardOutput) {
    throw input_error("the film itself goes to standard output; give a file name")
        .at({{}, 0, "--report"});
  }
  // "-o - --report FILE > FILE" would leave the film without a name
  if (output == kStandardOutput) refuse_same_file(job.report, "--report", {"/dev/stdout"});
  if (job.report == kStandardOutput) refuse_same_file(output, "the output", {"/dev/stdout"});
  refuse_same_file(job.report, "--report", {output, output + ".part"});
  if (plan.resume) refuse_same_file(job.report, "--report", {folder_of_pieces(output)});
  if (!plan.story.empty()) {
    refuse_same_file(
        job.report, "--report", {captions_beside(output), captions_beside(output) + ".part"});
  }
  if (is_sequence && !job.report.empty() && is_frame_of(output, job.report)) {
    throw input_error("--report would overwrite a frame of {}; choose another name", output);
  }
}

// pictures of a longer film that had the same name; `frames`: of the whole film, whose end only one
// shard makes
void warn_of_pictures_behind(const RenderPlan& plan, const FrameRange& made, int frames) {
  const std::string& output = plan.sink.output;
  if (plan.sink.still || find_sink_kind(output).name != "png sequence") return;
  if (made.first + made.count < frames) return;
  const std::string next = parse_numbered_name(output).of(frames);
  if (is_there(next))
    spdlog::warn("{} and what follows it are pictures of an earlier film", one_line(next));
}

}  // namespace

Made render_film(const RenderJob& job) {
  const auto wall_start = std::chrono::steady_clock::now();

  // load and check everything that can be checked before work begins
  const RenderPlan plan = plan_render(job);
  refuse_overwriting(job, plan);
  refuse_other_work(job.submitted, words_of_film(plan));
  const bool is_part = plan.resume && plan.shard;
  const bool reported = !job.report.empty() && !is_part;
  std::unique_ptr<AtomicFile> report_file;
  if (reported && job.report != "-") report_file = std::make_unique<AtomicFile>(job.report);
  const std::unique_ptr<RenderOutput> output = open_output(plan, reported);

  // find the motion and what each frame shows; open the renderer
  const PreparedFilm film(plan);
  output->begin(film);
  std::unique_ptr<FrameRenderer> renderer = open_frame_renderer(film, plan.setup, output->frames());
  film.warn();

  // draw here, convert and encode behind the queue
  render_with_progress(plan, *output, *renderer, job.progress);

  warn_of_pictures_behind(plan, output->range(), film.frames().count);

  // report
  Made made;
  made.output = is_part ? folder_of_pieces(plan.sink.output) : plan.sink.output;
  made.frames = output->range().count;
  made.from_earlier = output->already_there();
  made.is_picture = plan.sink.still;
  if (!reported) return made;
  FilmReport record = film_report(plan, film, *output, *renderer);
  renderer.reset();  // its processes are reaped, and their time is counted
  record.total.wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  record.total.cpu_s = process_cpu_seconds();
  const std::string report = json_of(record).dump(2) + "\n";
  if (report_file == nullptr) {
    print_out(report);
  } else {
    try {
      report_file->commit_with(report);
    } catch (const Error& error) {
      throw Error(error.fault(),
                  fmt::format("{}; {} is complete", error.message(), plan.sink.output),
                  error.place());
    }
  }
  return made;
}

namespace {

// Draws and encodes a few stretches of the film; returns the seconds of one processor per frame.
double cost_of_frame(const RenderPlan& plan, const PreparedFilm& film, FrameRenderer& renderer) {
  constexpr int kStretches = 4, kMostOfStretch = 30;
  constexpr double kEnough = 2.0;  // s
  const int frames = film.frames().count;
  Image image;
  renderer.render(frames / 2, image);  // what is done once is done
  const double drawn = seconds_of([&] { renderer.render(frames / 3, image); });
  const int length =
      std::clamp(static_cast<int>(kEnough / kStretches / std::max(drawn, 1e-4)), 1, kMostOfStretch);
  const ScratchFolder scratch;
  SinkJob job = plan.sink;
  job.output = scratch / ("sample" + std::filesystem::path(job.output).extension().string());
  job.segment = true;
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  const auto number = [&](int i) {
    return static_cast<int>((static_cast<long>(i / length) * frames / kStretches + i % length) %
                            frames);
  };
  const double before = process_cpu_seconds();
  run_pipeline(
      kStretches * length,
      [&](int i, Image& into) { return renderer.begin(number(i), into); },
      *sink,
      [](const PipelineStep&) {});
  return (process_cpu_seconds() - before) / (kStretches * length);
}

// Pieces of about ten seconds of work, but of one to five seconds of film, which is what key frames
// and lost work allow.
int suitable_pieces(const RenderPlan& plan, int frames, double of_frame) {
  constexpr double kWork = 10.0, kLongest = 5.0;  // s
  const double film = frames / plan.sink.fps.value();
  const double wanted = std::clamp(frames * of_frame / kWork, film / kLongest, std::max(film, 1.0));
  return std::clamp(static_cast<int>(std::ceil(wanted)), 1, frames);
}

}  // namespace

DividedWork divided_film(RenderJob job) {
  const bool asked = job.resume;
  job.resume = true;
  job.jobs = 1;
  const RenderPlan plan = [&] {
    try {
      return plan_render(job);
    } catch (const Error& error) {
      if (asked || error.place().key != "--resume") throw;
      if (job.still)
        throw input_error("a single picture cannot be divided into tasks").at({{}, 0, "--still"});
      throw input_error("'{}' cannot be divided into tasks: choose a .mp4, .webm or .mov",
                        job.output)
          .at({{}, 0, "--output"});
    }
  }();
  refuse_overwriting(job, plan);
  if (job.report == "-") {
    throw input_error("goes into the log of the collecting job; name a file")
        .at({{}, 0, "--report"});
  }
  DividedWork work;
  work.words = words_of_film(plan);
  work.output = plan.sink.output;
  work.things = "pieces";
  std::unique_ptr<PreparedFilm> film;
  std::unique_ptr<FrameRenderer> renderer;
  work.start_s = seconds_of([&] {
    film = std::make_unique<PreparedFilm>(plan);
    renderer = open_frame_renderer(*film, plan.setup, {});
  });
  film->warn();
  const int frames = film->frames().count;
  const double of_frame = cost_of_frame(plan, *film, *renderer);
  work.pieces = job.pieces ? plan.pieces : suitable_pieces(plan, frames, of_frame);
  work.piece_s = of_frame * frames / static_cast<double>(work.pieces);
  work.options = {"--resume", fmt::format("--pieces={}", work.pieces)};
  RenderPlan whole = plan;
  whole.pieces = static_cast<int>(work.pieces);
  open_output(whole, false);  // what is in its way is told now
  return work;
}

}  // namespace polhode
