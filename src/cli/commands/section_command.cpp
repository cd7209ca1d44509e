// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/section.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

namespace {

// the options of the command, which are parsed into the job and beside it
struct SectionOptions {
  SectionJob job;
  SectionMapAxes axes;
  ProgressOptions progress;
  std::optional<std::string> cells;
  std::optional<int> starts, crossings, jobs;

  SectionJob checked() const {
    if (jobs && *jobs < 1)
      throw input_error("must be greater than 0, got {}", *jobs).at({{}, 0, "--jobs"});
    if (axes.x.empty() != axes.y.empty()) {
      throw input_error("a map needs two keys, --x and --y")
          .at({{}, 0, axes.x.empty() ? "--x" : "--y"});
    }
    const bool is_map = !axes.x.empty();
    if (is_map && starts) {
      throw input_error("a map has a start for each cell, that of the scene")
          .at({{}, 0, "--starts"});
    }
    if (!is_map && (axes.x_range || axes.y_range || cells)) {
      const char* option = axes.x_range ? "--x-range" : axes.y_range ? "--y-range" : "--cells";
      throw input_error("is for maps; give --x and --y").at({{}, 0, option});
    }
    SectionJob checked = job;
    if (is_map) {
      checked.map = axes;
      checked.map->cells = cells.value_or(axes.cells);
    }
    checked.starts = starts.value_or(job.starts);
    checked.crossings = crossings.value_or(job.crossings);
    checked.jobs = jobs.value_or(job.jobs);
    checked.progress = progress_of(progress);
    return checked;
  }
};

std::shared_ptr<SectionOptions> add_section_options(CLI::App& command) {
  auto options = std::make_shared<SectionOptions>();
  SectionJob* job = &options->job;
  SectionMapAxes* axes = &options->axes;
  add_scene(command, job->scene);
  add_text(command,
           "-o,--output",
           job->output,
           "folder for section.csv and section.png (default: output/SCENE_section)")
      ->type_name("DIR");
  add_whole_number(
      command, "--starts", options->starts, "motions beside that of the scene (default: 60)")
      ->type_name("N");
  add_whole_number(
      command, "--crossings", options->crossings, "crossings of each motion (default: 500)")
      ->type_name("N");
  add_whole_number(command, "--jobs", options->jobs, "threads (default: one per processor)")
      ->type_name("N");
  add_text(command, "--x", axes->x, "a map instead: scene key on the horizontal axis")
      ->type_name("KEY");
  add_text(command, "--y", axes->y, "scene key on the vertical axis of the map")->type_name("KEY");
  add_text(
      command, "--x-range", axes->x_range, "range of the axis (default: around the scene's value)")
      ->type_name("A:B");
  add_text(
      command, "--y-range", axes->y_range, "range of the axis (default: around the scene's value)")
      ->type_name("A:B");
  add_text(command,
           "--cells",
           options->cells,
           "number of cells of the map, horizontal x vertical (default: 32x32)")
      ->type_name("NxM");
  add_settings(command, job->settings);
  add_part(command, job->part);
  add_progress(command, options->progress);
  return options;
}

}  // namespace

Action define_section(CLI::App& command) {
  const std::shared_ptr<SectionOptions> options = add_section_options(command);
  return [options] {
    print_out(section(options->checked()));
    return 0;
  };
}

Divide divide_section(CLI::App& command) {
  const std::shared_ptr<SectionOptions> options = add_section_options(command);
  return [options] {
    return divided_section(options->checked());
  };
}

}  // namespace polhode
