// SPDX-License-Identifier: MIT
#include <memory>

#include "app/compare/diff.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_diff(CLI::App& command) {
  auto job = std::make_shared<DiffJob>();
  auto progress = std::make_shared<ProgressOptions>();
  auto given = std::make_shared<ThresholdOptions>();
  command
      .add_option("actual",
                  job->actual,
                  "the result: picture.png, frame_%05d.png, a folder of .png, film.mp4, or a "
                  "scene.toml, which is rendered first")
      ->required()
      ->type_name("ACTUAL");
  command.add_option("reference", job->reference, "what it should look like; the same kinds")
      ->required()
      ->type_name("REFERENCE");
  add_thresholds(command, *given);
  command.add_flag("--json", job->json, "print all numbers of every frame as JSON");
  add_text(command, "--html", job->html, "write an HTML report, DIR/index.html")->type_name("DIR");
  add_number(command, "--still", job->still, "time of a scene's picture, s (default: 0)")
      ->type_name("T");
  add_text(command,
           "--size",
           job->overrides.size,
           "picture size of a scene (default: that of the other side)")
      ->type_name("WxH");
  add_text(command,
           "--fps",
           job->overrides.fps,
           "frame rate of a scene's film (default: that of the other side)")
      ->type_name("N");
  command.add_flag_callback(
      "--no-text",
      [job] { job->text = false; },
      "draw scenes without labels, clock, title and caption");
  add_text(command, "--backend", job->backend, "OpenGL for scenes: osmesa, egl or auto")
      ->type_name("BACKEND");
  add_progress(command, *progress);
  return [=] {
    job->thresholds = thresholds_of(*given);
    job->progress = progress_of(*progress);
    const DiffResult result = diff(*job);
    print_out(result.text);
    return result.same ? 0 : static_cast<int>(Fault::check_failed);
  };
}

}  // namespace polhode
