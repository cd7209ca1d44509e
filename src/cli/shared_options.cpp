// SPDX-License-Identifier: MIT
#include "cli/shared_options.h"

#include <cmath>
#include <limits>

#include "base/at_place.h"
#include "base/error.h"
#include "base/numbers.h"
#include "scene/setting.h"

namespace polhode {
namespace {

// "-o,--output" is called --output
std::string long_name(const std::string& names) {
  return names.substr(names.rfind(',') + 1);
}

double number_in(const std::string& text, const std::string& option) {
  const std::optional<double> value = parse_number(text);
  if (!value) {
    throw input_error("must be a number, such as 1.5; found '{}'", text.substr(0, 40))
        .at({{}, 0, option});
  }
  return *value;
}

// runs `read` on the option's text; CLI11 keeps the last of several
template <class Read>
CLI::Option* add_reader(CLI::App& command,
                        const std::string& names,
                        const std::string& doc,
                        const Read& read) {
  return command
      .add_option_function<std::string>(
          names, [names, read](const std::string& text) { read(text, long_name(names)); }, doc)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->allow_extra_args(false);
}

std::string text_in(const std::string& text, const std::string& option) {
  if (text.empty()) throw input_error("must not be empty").at({{}, 0, option});
  return text;
}

}  // namespace

CLI::Option* add_number(CLI::App& command,
                        const std::string& names,
                        std::optional<double>& target,
                        const std::string& doc) {
  return add_reader(
      command, names, doc, [&target](const std::string& text, const std::string& option) {
        target = number_in(text, option);
      });
}

CLI::Option* add_whole_number(CLI::App& command,
                              const std::string& names,
                              std::optional<int>& target,
                              const std::string& doc) {
  return add_reader(
      command, names, doc, [&target](const std::string& text, const std::string& option) {
        const double value = number_in(text, option);
        if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
          throw input_error("must be a whole number, such as 18; found '{}'", text.substr(0, 40))
              .at({{}, 0, option});
        }
        target = static_cast<int>(value);
      });
}

CLI::Option* add_text(CLI::App& command,
                      const std::string& names,
                      std::string& target,
                      const std::string& doc) {
  return add_reader(command,
                    names,
                    doc,
                    [&target](const std::string& text, const std::string& option) {
                      target = text_in(text, option);
                    })
      ->default_str(target);
}

CLI::Option* add_text(CLI::App& command,
                      const std::string& names,
                      std::optional<std::string>& target,
                      const std::string& doc) {
  return add_reader(
      command, names, doc, [&target](const std::string& text, const std::string& option) {
        target = text_in(text, option);
      });
}

void add_scene(CLI::App& command, std::filesystem::path& scene) {
  command.add_option("scene", scene, "scene file")->required()->type_name("SCENE");
}

void add_scenes(CLI::App& command, std::vector<std::filesystem::path>& scenes) {
  command.add_option("scenes", scenes, "scene files")->required()->type_name("SCENE");
}

void add_progress(CLI::App& command, ProgressOptions& options) {
  add_text(command, "--progress", options.progress, "auto, bar, json or none")->type_name("KIND");
  add_quiet(command, options);
}

void add_quiet(CLI::App& command, ProgressOptions& options) {
  command.add_flag("-q,--quiet", options.quiet, "print warnings and errors only on stderr");
}

ProgressKind progress_of(const ProgressOptions& options) {
  const ProgressKind kind = parse_progress(options.progress);
  return options.quiet ? ProgressKind::none : kind;
}

void add_settings(CLI::App& command, std::vector<Setting>& settings) {
  command
      .add_option_function<std::vector<std::string>>(
          "--set",
          [&settings](const std::vector<std::string>& texts) {
            at_place({{}, 0, "--set"}, [&] {
              for (const std::string& text : texts)
                settings.push_back(parse_setting(text));
            });
          },
          "replaces a value of the scene, as motion.spin.body[2]=40; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_numerics_options(CLI::App& command, Overrides& overrides) {
  add_text(command, "--method", overrides.method, "integrator, see `polhode list methods`")
      ->type_name("METHOD");
  add_number(command, "--step", overrides.step, "step of fixed-step methods, seconds")
      ->type_name("H");
  add_number(command, "--tolerance", overrides.tolerance, "local error of adaptive methods")
      ->type_name("E");
  add_text(command,
           "--accuracy",
           overrides.accuracy,
           "attitude error allowed over the whole motion: 0.1px, or radians")
      ->type_name("A");
}

void add_part(CLI::App& command, PartOptions& part) {
  add_text(command,
           "--shard",
           part.shard,
           "make only the K-th of N parts; the same command without it collects them")
      ->type_name("K/N");
  add_submitted(command, part.submitted);
}

void add_submitted(CLI::App& command, std::string& submitted) {
  add_text(command,
           "--submitted",
           submitted,
           "stop unless the work is still the one that `polhode submit` named so")
      ->type_name("HASH");
}

void add_thresholds(CLI::App& command, ThresholdOptions& given) {
  add_whole_number(command,
                   "--max",
                   given.max,
                   "difference of values that is ignored, in levels of 255 (default: 3)")
      ->type_name("N");
  add_number(command,
             "--fraction",
             given.fraction,
             "share of pixels that may differ by more (default: 5e-4)")
      ->type_name("F");
  add_whole_number(command,
                   "--limit",
                   given.limit,
                   "difference that no value may exceed, in levels (default: 70)")
      ->type_name("N");
  add_number(command, "--ssim", given.ssim, "smallest allowed SSIM, up to 1 (default: not checked)")
      ->type_name("S");
  add_number(
      command, "--flip", given.flip, "largest allowed mean FLIP, from 0 (default: not checked)")
      ->type_name("F");
}

Thresholds thresholds_of(const ThresholdOptions& given) {
  Thresholds thresholds;
  thresholds.max = given.max.value_or(thresholds.max);
  thresholds.fraction = given.fraction.value_or(thresholds.fraction);
  thresholds.limit = given.limit.value_or(thresholds.limit);
  thresholds.ssim = given.ssim;
  thresholds.flip = given.flip;
  check_thresholds(thresholds);
  return thresholds;
}

}  // namespace polhode
