// SPDX-License-Identifier: MIT
#include <memory>

#include "app/render_film.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_render(CLI::App& command) {
  auto job = std::make_shared<RenderJob>();
  auto progress = std::make_shared<std::string>("auto");
  command.add_option("scene", job->scene, "scene file")->required()->type_name("SCENE");
  command
      .add_option("-o,--output",
                  job->output,
                  "what to write; its ending says the kind, see `polhode list formats` "
                  "(default output/SCENE.mp4)")
      ->type_name("OUT");
  command.add_option("--size", job->overrides.size, "picture size")->type_name("WxH");
  command.add_option("--fps", job->overrides.fps, "frames per second, 60 or 30000/1001")
      ->type_name("N");
  command.add_option("--from", job->from, "start of the film, seconds of the motion")
      ->type_name("T");
  command.add_option("--to", job->to, "end of the film, seconds of the motion")->type_name("T");
  command.add_option("--still", job->still, "one picture at this time")->type_name("T");
  command.add_option("--quality", job->quality, "draft, lecture or archive")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--preset", job->preset, "x264 preset, ultrafast to veryslow")->type_name("P");
  command.add_option("--crf", job->crf, "x264 quality, 1 (best) to 51")->type_name("N");
  add_numerics_options(command, job->overrides);
  command.add_option("--backend", job->backend, "OpenGL from osmesa, egl or auto")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_flag("--transparent", job->transparent, "no background, where the format has alpha");
  command
      .add_option("--report", job->report, "write what was done, how exact and how fast, as JSON")
      ->type_name("FILE.json");
  command.add_option("--progress", *progress, "auto, bar, json or none")
      ->type_name("KIND")
      ->capture_default_str();
  return [job, progress] {
    job->progress = parse_progress(*progress);
    render_film(*job);
    return 0;
  };
}

}  // namespace polhode
