// SPDX-License-Identifier: MIT
#include "cli/value_kinds.h"

#include "app/commands/list.h"
#include "app/commands/new_scene.h"
#include "cli/command.h"
#include "cli/option_words.h"
#include "motion/diagram.h"

namespace polhode {
namespace {

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Command& command : commands())
    names.emplace_back(command.name);
  return names;
}

std::vector<std::string> divisible_words() {
  std::vector<std::string> names;
  for (const Command& command : commands())
    if (command.divide != nullptr) names.emplace_back(command.name);
  return names;
}

std::vector<std::string> new_kind_words() {
  std::vector<std::string> names;
  for (const NewKind& kind : new_kinds())
    names.emplace_back(kind.name);
  return names;
}

}  // namespace

const std::vector<ValueKind>& value_kinds() {
  static const std::vector<ValueKind> table = {
      {"ACTION", ValueForm::word, golden_actions(), {}},
      {"BACKEND", ValueForm::word, backend_words(), {}},
      {"CODEC", ValueForm::word, codec_words(), {}},
      {"COMMAND", ValueForm::word, command_names(), {}},
      {"KIND", ValueForm::word, progress_words(), {}},
      {"METHOD", ValueForm::word, method_words(), {}},
      {"METHODS", ValueForm::words_with_commas, stepper_words(), {}},
      {"DOCUMENTS", ValueForm::words_with_commas, document_words(), {}},
      {"NEW", ValueForm::word, new_kind_words(), {}},
      {"PLOT", ValueForm::word, plot_names(), {}},
      {"PRESET", ValueForm::word, preset_words(), {}},
      {"QUALITY", ValueForm::word, quality_words(), {}},
      {"WORK", ValueForm::word, divisible_words(), {}},
      {"SHELL", ValueForm::word, {"bash", "zsh"}, {}},
      {"THEME", ValueForm::word, theme_words(), {}},
      {"TABLE", ValueForm::word, list_names(), {}},
      {"SCENE", ValueForm::file, {}, {"toml"}},
      {"DECK", ValueForm::file, {}, {"md"}},
      {"FILE.csv", ValueForm::file, {}, {"csv"}},
      {"FILE.glb", ValueForm::file, {}, {"glb"}},
      {"FILE.json", ValueForm::file, {}, {"json"}},
      {"OUT.png", ValueForm::file, {}, {"png"}},
      {"OUT", ValueForm::file, {}, {}},
      {"PART", ValueForm::file, {}, {}},
      {"ACTUAL", ValueForm::file, {}, {}},
      {"REFERENCE", ValueForm::file, {}, {}},
      {"JOB", ValueForm::folder, {}, {}},
      {"DIR", ValueForm::folder, {}, {}},
  };
  return table;
}

const ValueKind* find_value_kind(const std::string& name) {
  for (const ValueKind& kind : value_kinds()) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

}  // namespace polhode
