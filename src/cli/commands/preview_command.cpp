// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/preview.h"
#include "cli/closing_line.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_preview(CLI::App& command) {
  auto job = std::make_shared<PreviewJob>();
  auto progress = std::make_shared<ProgressOptions>();
  add_scene(command, job->scene);
  add_text(command, "-o,--output", job->output, "the sheet (default output/SCENE_preview.png)")
      ->type_name("OUT.png");
  add_settings(command, job->overrides.settings);
  add_numerics_options(command, job->overrides);
  add_text(command, "--theme", job->overrides.theme, "colours: dark, light, projector or print")
      ->type_name("THEME");
  add_text(command, "--backend", job->backend, "OpenGL from osmesa, egl or auto")
      ->type_name("BACKEND");
  add_quiet(command, *progress);
  return [job, progress] {
    return make_and_tell(*progress, [&] { return write_preview(*job); });
  };
}

}  // namespace polhode
