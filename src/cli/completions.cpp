// SPDX-License-Identifier: MIT
#include "cli/completions.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/value_kinds.h"

namespace polhode {
namespace {

using Options = std::vector<const CLI::Option*>;

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

bool takes_several(const CLI::Option& option) {
  return option.get_items_expected_max() > 1;
}

// "-o", "--output"
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
    names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    names.push_back("--" + name);
  return names;
}

// those of the command, and those of the program that may stand behind it
Options named_options(const CLI::App& program, const CLI::App& command) {
  Options options;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) options.push_back(option);
  }
  for (const CLI::Option* option : program.get_options()) {
    if (option->check_lname("verbose")) options.push_back(option);
  }
  return options;
}

Options arguments_of(const CLI::App& command) {
  Options options;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) options.push_back(option);
  }
  return options;
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

// a call of the functions at the end of the script
std::string bash_value(const CLI::Option& option) {
  const ValueKind* kind = find_value_kind(option.get_type_name());
  if (kind == nullptr) return ":";
  switch (kind->form) {
    case ValueForm::word:
      return fmt::format("_polhode_words '{}'", joined(kind->words));
    case ValueForm::words_with_commas:
      return fmt::format("_polhode_list '{}'", joined(kind->words));
    case ValueForm::file:
      return "_polhode_files " + (kind->endings.empty() ? "''" : kind->endings.front());
    case ValueForm::folder:
      return "_polhode_folders";
  }
  return ":";
}

const char* const kBashHead =
    R"sh(# bash completion for polhode, written by `polhode completion bash`
_polhode_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }
_polhode_list() {
  local head=
  [[ $word == *,* ]] && head=${word%,*},
  mapfile -t COMPREPLY < <(compgen -P "$head" -W "$1" -- "${word##*,}")
  compopt -o nospace
}
_polhode_files() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -f -X "${1:+!*.$1}" -- "$word"; [[ -z $1 ]] || compgen -d -- "$word")
}
_polhode_folders() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -d -- "$word")
}
_polhode() {
  local word=$2 before=$3 at=1 place=0
  COMPREPLY=()
  # options of the program stand before the command
  while (( at < COMP_CWORD )) && [[ ${COMP_WORDS[at]} == -* ]]; do (( ++at )); done
  local command=${COMP_WORDS[at]}
  # --option=value arrives as three words
  if [[ $word == '=' ]]; then
    word=
  elif [[ $before == '=' ]]; then
    before=${COMP_WORDS[COMP_CWORD-2]}
  fi
)sh";

std::string bash_command(const CLI::App& program, const CLI::App& command) {
  std::string values;
  std::vector<std::string> with_value, all;
  for (const CLI::Option* option : named_options(program, command)) {
    const std::vector<std::string> names = names_of(*option);
    all.insert(all.end(), names.begin(), names.end());
    if (!takes_value(*option)) continue;
    with_value.insert(with_value.end(), names.begin(), names.end());
    values +=
        fmt::format("        {}) {}; return ;;\n", fmt::join(names, "|"), bash_value(*option));
  }
  std::string places;
  int place = 0;
  for (const CLI::Option* option : arguments_of(command)) {
    const std::string number = takes_several(*option) ? "*" : std::to_string(place++);
    places += fmt::format("        {}) {} ;;\n", number, bash_value(*option));
  }
  std::string text = fmt::format("    {})\n", command.get_name());
  if (!values.empty()) text += "      case $before in\n" + values + "      esac\n";
  text += fmt::format("      if [[ $word == -* ]]; then _polhode_words '{}'; return; fi\n",
                      joined(all));
  if (!places.empty()) {
    text += fmt::format("      _polhode_place '{}'\n      case $place in\n{}      esac\n",
                        joined(with_value),
                        places);
  }
  return text + "      ;;\n";
}

// what stands behind `submit` is a command with arguments of its own
constexpr const char* kBashWork = R"sh(  if [[ $command == submit ]]; then
    local i
    for (( i = at + 1; i < COMP_CWORD; ++i )); do
      if [[ ' {} ' == *" ${{COMP_WORDS[i]}} "* ]]; then at=$i; command=${{COMP_WORDS[i]}}; break; fi
    done
  fi
)sh";

constexpr const char* kZshWork = R"sh(  if [[ $command == submit ]]; then
    local i
    for (( i = 2; i < CURRENT; ++i )); do
      if [[ ' {} ' == *" $words[i] "* ]]; then
        command=$words[i]; shift $(( i - 1 )) words; (( CURRENT -= i - 1 )); break
      fi
    done
  fi
)sh";

// sets `place`: how many arguments, options and their values not counted, stand before the word
const char* const kBashPlace = R"sh(_polhode_place() {
  local i=$(( at + 1 ))
  place=0
  while (( i < COMP_CWORD )); do
    if [[ " $1 " == *" ${COMP_WORDS[i]} "* ]]; then
      (( ++i ))
      [[ ${COMP_WORDS[i]} == '=' ]] && (( ++i ))
    elif [[ ${COMP_WORDS[i]} != -* ]]; then
      (( ++place ))
    fi
    (( ++i ))
  done
}
)sh";

// zsh ends a description at a colon or bracket
std::string zsh_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return out;
}

// ":what:how to complete it"
std::string zsh_value(const CLI::Option& option) {
  const std::string name = option.get_type_name();
  const ValueKind* kind = find_value_kind(name);
  std::string how = " ";
  if (kind != nullptr) {
    switch (kind->form) {
      case ValueForm::word:
        how = "(" + joined(kind->words) + ")";
        break;
      case ValueForm::words_with_commas:
        how = "_sequence compadd - " + joined(kind->words);
        break;
      case ValueForm::file:
        how =
            kind->endings.empty() ? "_files" : "_files -g \"*." + kind->endings.front() + "(-.)\"";
        break;
      case ValueForm::folder:
        how = "_files -/";
        break;
    }
  }
  return ":" + zsh_escaped(name) + ":" + how;
}

// one specification of _arguments for each option or argument
std::string zsh_option(const CLI::Option& option) {
  const std::vector<std::string> names = names_of(option);
  const std::string doc = zsh_escaped(option.get_description());
  const std::string value = takes_value(option) ? zsh_value(option) : "";
  std::string text;
  for (const std::string& name : names) {
    const char* equals = takes_value(option) && name.rfind("--", 0) == 0 ? "=" : "";
    text += fmt::format("        '({}){}{}[{}]{}' \\\n", joined(names), name, equals, doc, value);
  }
  return text;
}

std::string zsh_command(const CLI::App& program, const CLI::App& command) {
  std::string text = fmt::format("    {})\n      _arguments -s \\\n", command.get_name());
  for (const CLI::Option* option : named_options(program, command))
    text += zsh_option(*option);
  int place = 1;
  for (const CLI::Option* option : arguments_of(command)) {
    const std::string number = takes_several(*option) ? "*" : std::to_string(place++);
    text += fmt::format("        '{}{}' \\\n", number, zsh_value(*option));
  }
  return text + "        && return 0\n      ;;\n";
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::vector<std::string> names, options;
  for (const CLI::App* command : program.get_subcommands({}))
    names.push_back(command->get_name());
  for (const CLI::Option* option : program.get_options()) {
    for (const std::string& name : names_of(*option))
      options.push_back(name);
  }
  std::string text = kBashHead;
  text += fmt::format(
      "  if (( COMP_CWORD == at )); then\n"
      "    if [[ $word == -* ]]; then _polhode_words '{}'; else _polhode_words '{}'; fi\n"
      "    return\n  fi\n{}  case $command in\n",
      joined(options),
      joined(names),
      fmt::format(kBashWork, joined(find_value_kind("WORK")->words)));
  for (const CLI::App* command : program.get_subcommands({}))
    text += bash_command(program, *command);
  return text + "  esac\n}\n" + kBashPlace + "complete -F _polhode polhode\n";
}

std::string zsh_completion(const CLI::App& program) {
  std::string text =
      "#compdef polhode\n# zsh completion for polhode, written by `polhode completion zsh`\n"
      "_polhode() {\n  local curcontext=$curcontext state line\n"
      "  while (( CURRENT > 2 )) && [[ $words[2] == -* ]]; do shift words; (( CURRENT-- )); done\n"
      "  if (( CURRENT == 2 )); then\n    local -a names\n    names=(\n";
  for (const CLI::App* command : program.get_subcommands({})) {
    text += fmt::format(
        "      '{}:{}'\n", command->get_name(), zsh_escaped(command->get_description()));
  }
  text += "    )\n    _describe command names\n    _arguments \\\n";
  for (const CLI::Option* option : program.get_options())
    text += zsh_option(*option);
  text +=
      "      && return 0\n    return\n  fi\n"
      "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n";
  text += fmt::format(kZshWork, joined(find_value_kind("WORK")->words)) + "  case $command in\n";
  for (const CLI::App* command : program.get_subcommands({}))
    text += zsh_command(program, *command);
  return text +
         "  esac\n}\n"
         "# read by autoload, or by `source`\n"
         "if [[ $funcstack[1] == _polhode ]]; then _polhode \"$@\"; else compdef _polhode polhode; "
         "fi\n";
}

}  // namespace polhode
