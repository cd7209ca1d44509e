// SPDX-License-Identifier: MIT
// Options that several commands share, and the conversion of option values. Values are converted
// here and not by CLI11, so that errors look like those of scene files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/compare/diff.h"
#include "base/system/progress.h"
#include "film/overrides.h"

namespace polhode {

// Add an option. `names` is in CLI11's form, "-o,--output"; errors use the last name. `target` must
// outlive parsing; it is not changed if the option is absent, and the last of several values
// counts. Parsing throws Error (input), naming the option, for text that is not a finite number,
// and for empty text.
CLI::Option* add_number(CLI::App& command,
                        const std::string& names,
                        std::optional<double>& target,
                        const std::string& doc);
CLI::Option* add_whole_number(CLI::App& command,
                              const std::string& names,
                              std::optional<int>& target,
                              const std::string& doc);
CLI::Option* add_text(CLI::App& command,
                      const std::string& names,
                      std::string& target,
                      const std::string& doc);
CLI::Option* add_text(CLI::App& command,
                      const std::string& names,
                      std::optional<std::string>& target,
                      const std::string& doc);

// The positional argument for a scene file.
void add_scene(CLI::App& command, std::filesystem::path& scene);

// The positional arguments for one or more scene files.
void add_scenes(CLI::App& command, std::vector<std::filesystem::path>& scenes);

// The values of --progress and --quiet.
struct ProgressOptions {
  std::string progress = "auto";
  bool quiet = false;
};
// Adds --progress and --quiet.
void add_progress(CLI::App& command, ProgressOptions& options);
// Adds only --quiet, for commands with a closing line but without progress.
void add_quiet(CLI::App& command, ProgressOptions& options);
// The kind of progress to show. Throws Error (input), naming --progress.
ProgressKind progress_of(const ProgressOptions& options);

// Adds --method, --step, --tolerance and --accuracy.
void add_numerics_options(CLI::App& command, Overrides& overrides);

// The values of --max, --fraction, --limit, --ssim and --flip.
struct ThresholdOptions {
  std::optional<int> max, limit;  // levels of 255
  std::optional<double> fraction, ssim, flip;
};
// Adds these options.
void add_thresholds(CLI::App& command, ThresholdOptions& given);

// The default thresholds with the given values in their place. Throws Error as check_thresholds
// does.
Thresholds thresholds_of(const ThresholdOptions& given);

}  // namespace polhode
