// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/export.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_export(CLI::App& command) {
  auto job = std::make_shared<ExportJob>();
  auto progress = std::make_shared<ProgressOptions>();
  add_scene(command, job->scene);
  add_text(command, "-o,--output", job->output, "glTF file, or - for standard output")
      ->required()
      ->type_name("FILE.glb");
  add_number(command, "--from", job->from, "begin at this time of the motion")
      ->type_name("SECONDS");
  add_number(command, "--to", job->to, "end at this time of the motion")->type_name("SECONDS");
  add_text(command, "--author", job->author, "author, for the file's notices")->type_name("NAME");
  add_text(command, "--licence", job->licence, "licence, for the file's notices")
      ->type_name("TEXT");
  add_text(command, "--theme", job->overrides.theme, "colours: dark, light, projector or print")
      ->type_name("THEME");
  add_settings(command, job->overrides.settings);
  add_numerics_options(command, job->overrides);
  add_quiet(command, *progress);
  return [job, progress] {
    job->progress = progress_of(*progress);
    const Exported made = write_glb(*job);
    if (progress->quiet) return 0;
    const ExportReport& report = made.report;
    print_err(fmt::format(
        "{}: {:.2f} MB, {} key times; playback within {:.2g} m of the motion, {:.2g} pixels of a "
        "picture 1080 high{}\n",
        made.output,
        static_cast<double>(made.bytes) * 1e-6,
        report.keys,
        report.error,
        report.error * report.pixels_per_metre,
        report.error > report.tolerance
            ? fmt::format(
                  ", more than asked: glTF has places in single precision, and the body is up to "
                  "{:.2g} m away",
                  report.farthest)
            : ""));
    return 0;
  };
}

}  // namespace polhode
