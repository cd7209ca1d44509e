// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/render.h"
#include "cli/closing_line.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

namespace {

// the options of the command, which are parsed into the job and beside it
struct RenderOptions {
  RenderJob job;
  ProgressOptions progress;
  std::optional<int> jobs;

  RenderJob checked() const {
    RenderJob checked = job;
    checked.jobs = jobs.value_or(job.jobs);
    checked.progress = progress_of(progress);
    return checked;
  }
};

std::shared_ptr<RenderOptions> add_render_options(CLI::App& command) {
  auto options = std::make_shared<RenderOptions>();
  RenderJob* job = &options->job;
  add_scene(command, job->scene);
  add_text(command,
           "-o,--output",
           job->output,
           "what to write; the ending selects the format, see `polhode list formats` "
           "(default output/SCENE.mp4, .png with --still)")
      ->type_name("OUT");
  add_text(command, "--size", job->overrides.size, "picture size")->type_name("WxH");
  add_text(command, "--fps", job->overrides.fps, "frames per second, 60 or 30000/1001")
      ->type_name("N");
  add_text(command, "--theme", job->overrides.theme, "colours: dark, light, projector or print")
      ->type_name("THEME");
  add_number(command, "--from", job->from, "start of the film, seconds of the motion")
      ->type_name("T");
  add_number(command, "--to", job->to, "end of the film, seconds of the motion")->type_name("T");
  add_number(command, "--still", job->still, "one picture at this time")->type_name("T");
  add_text(command, "--quality", job->quality, "draft, lecture or archive")->type_name("QUALITY");
  add_text(command, "--codec", job->codec, "of .mp4 films: h264, hevc or av1")->type_name("CODEC");
  add_text(command, "--preset", job->preset, "effort of the encoder, ultrafast to veryslow")
      ->type_name("PRESET");
  add_whole_number(command, "--crf", job->crf, "quality, 1 (best) to 51; to 63 for VP9 and AV1")
      ->type_name("N");
  add_settings(command, job->overrides.settings);
  add_numerics_options(command, job->overrides);
  add_text(command, "--backend", job->backend, "OpenGL from osmesa, egl or auto")
      ->type_name("BACKEND");
  command.add_flag("--transparent", job->transparent, "no background, where the format has alpha");
  add_whole_number(command, "--jobs", options->jobs, "processes that draw (default 1)")
      ->type_name("N");
  command.add_flag("--resume",
                   job->resume,
                   "make the film in pieces; after a crash, continue from the complete ones");
  add_whole_number(command,
                   "--pieces",
                   job->pieces,
                   "number of pieces of --resume (default: one for each five seconds)")
      ->type_name("N");
  add_text(command,
           "--shard",
           job->shard,
           "only the K-th of N parts, for `polhode join` or, with --resume, for the run without it")
      ->type_name("K/N");
  add_submitted(command, job->submitted);
  command.add_flag_callback(
      "--no-text", [job] { job->text = false; }, "no labels, clock, title or caption");
  add_text(command,
           "--report",
           job->report,
           "write settings, accuracy and speed as JSON; - for standard output")
      ->type_name("FILE.json");
  add_progress(command, options->progress);
  return options;
}

}  // namespace

Action define_render(CLI::App& command) {
  const std::shared_ptr<RenderOptions> options = add_render_options(command);
  return [options] {
    return make_and_tell(options->progress, [&] { return render_film(options->checked()); });
  };
}

Divide divide_render(CLI::App& command) {
  const std::shared_ptr<RenderOptions> options = add_render_options(command);
  return [options] {
    return divided_film(options->checked());
  };
}

}  // namespace polhode
