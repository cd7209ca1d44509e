// SPDX-License-Identifier: MIT
// Options that several commands share, and the conversion of option values. Values are converted
// here and not by CLI11, so that errors look like those of scene files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/compare/diff.h"
#include "app/piecewise.h"
#include "base/system/progress.h"
#include "film/overrides.h"
#include "scene/setting.h"

namespace polhode {

// The next four functions add an option with one value to `command`, which owns the returned
// option. `names` is in CLI11's form, "-o,--output"; errors use the last name as key. `doc` is the
// phrase for --help. `target` must outlive parsing; it is not changed if the option is absent, and
// if the option is given several times, the last value counts. Parsing throws Error (input), with
// the option as key, for a value that `target` cannot take.

// The value is any finite number.
CLI::Option* add_number(CLI::App& command,
                        const std::string& names,
                        std::optional<double>& target,
                        const std::string& doc);
// The value is an integer that fits an int; "2.0" is one too.
CLI::Option* add_whole_number(CLI::App& command,
                              const std::string& names,
                              std::optional<int>& target,
                              const std::string& doc);
// The value is any text that is not empty. The present value of `target` is shown as the default.
CLI::Option* add_text(CLI::App& command,
                      const std::string& names,
                      std::string& target,
                      const std::string& doc);
// The value is any text that is not empty; no default is shown.
CLI::Option* add_text(CLI::App& command,
                      const std::string& names,
                      std::optional<std::string>& target,
                      const std::string& doc);

// Adds the required positional argument SCENE, one scene file. `scene` must outlive parsing.
void add_scene(CLI::App& command, std::filesystem::path& scene);

// Adds the required positional arguments SCENE, one or more scene files. `scenes` must
// outlive parsing.
void add_scenes(CLI::App& command, std::vector<std::filesystem::path>& scenes);

// The values of --progress and --quiet.
struct ProgressOptions {
  std::string progress = "auto";  // one of progress_names(), not yet checked
  bool quiet = false;             // no progress and no closing line
};
// Adds --progress and --quiet. `options` must outlive parsing.
void add_progress(CLI::App& command, ProgressOptions& options);
// Adds only --quiet, for commands with a closing line but without progress. `options` must
// outlive parsing.
void add_quiet(CLI::App& command, ProgressOptions& options);
// The kind of progress to show: none with --quiet. Throws Error (input), with --progress as key,
// for an unknown kind, also with --quiet.
ProgressKind progress_of(const ProgressOptions& options);

// Adds --set, which may be given several times. `settings` must outlive parsing, which throws Error
// (input), with --set as key, for a value that is not KEY=VALUE.
void add_settings(CLI::App& command, std::vector<Setting>& settings);

// Adds --method, --step, --tolerance and --accuracy. `overrides` must outlive parsing;
// load_with_overrides() checks the values.
void add_numerics_options(CLI::App& command, Overrides& overrides);

// Adds --shard and --submitted, for work that several runs do together. `part` must outlive
// parsing; part_of_work() (app/piecewise.h) checks the values.
void add_part(CLI::App& command, PartOptions& part);

// Adds only --submitted. `submitted` must outlive parsing.
void add_submitted(CLI::App& command, std::string& submitted);

// The values of --max, --fraction, --limit, --ssim and --flip, with the meaning of the members of
// Thresholds (image/verdict.h). Absent: not given.
struct ThresholdOptions {
  std::optional<int> max, limit;  // levels of 0..255
  std::optional<double> fraction, ssim, flip;
};
// Adds these options. `given` must outlive parsing.
void add_thresholds(CLI::App& command, ThresholdOptions& given);

// The given values, and the defaults of Thresholds for those that were not given. Throws Error
// (input), with the option as key, for a value out of range, as check_thresholds does.
Thresholds thresholds_of(const ThresholdOptions& given);

}  // namespace polhode
