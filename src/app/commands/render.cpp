// SPDX-License-Identifier: MIT
#include "app/commands/render.h"

#include <chrono>
#include <memory>

#include <sys/resource.h>

#include "base/system/atomic_file.h"
#include "base/system/console.h"
#include "base/system/overwriting.h"
#include "film/frame_workers.h"
#include "film/output/open_output.h"
#include "film/output/resumed_film.h"
#include "film/report/film_report.h"
#include "video/captions.h"
#include "video/frame_sink.h"
#include "video/plain_sinks.h"
#include "video/png_sink.h"

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
    return std::filesystem::absolute(name).lexically_normal().string();
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
  refuse_same_file(job.report, "--report", input_files(plan.scene));
  if (output == kStandardOutput && job.report == kStandardOutput) {
    throw input_error("the film itself goes to standard output; give a file name")
        .at({{}, 0, "--report"});
  }
  refuse_same_file(job.report, "--report", {output});
  if (plan.resume) refuse_same_file(job.report, "--report", {folder_of_pieces(output)});
  if (!plan.story.empty()) refuse_same_file(job.report, "--report", {captions_beside(output)});
  if (is_sequence && !job.report.empty() && is_frame_of(output, job.report)) {
    throw input_error("--report would overwrite a frame of {}; choose another name", output);
  }
}

}  // namespace

Made render_film(const RenderJob& job) {
  const auto wall_start = std::chrono::steady_clock::now();

  // load and check everything that can be checked before work begins
  const RenderPlan plan = plan_render(job);
  refuse_overwriting(job, plan);
  const bool reported = !job.report.empty();
  std::unique_ptr<AtomicFile> report_file;
  if (reported && job.report != "-") report_file = std::make_unique<AtomicFile>(job.report);
  const std::unique_ptr<RenderOutput> output = open_output(plan, reported);

  // find the motion and what each frame shows; open the renderer
  const PreparedFilm film(plan);
  output->begin(film);
  std::unique_ptr<FrameRenderer> renderer = open_frame_renderer(film, plan.setup, output->frames());
  film.warn();

  // draw here, convert and encode behind the queue
  Progress progress(job.progress, output->range().count, "frames", output->already_there());
  render_frames(*output, *renderer, [&](const PipelineStep& step) {
    progress.show(step.done, limiting_stage(plan, step));
  });

  // report
  Made made;
  made.output = plan.sink.output;
  made.frames = output->range().count;
  made.every = output->sink().keeps_every();
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

}  // namespace polhode
