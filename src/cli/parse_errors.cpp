// SPDX-License-Identifier: MIT
#include "cli/parse_errors.h"

#include <algorithm>
#include <cctype>

#include <fmt/ranges.h>

#include "base/nearest.h"
#include "base/utf8.h"
#include "cli/command.h"

namespace polhode {
namespace {

// the option in "--size=12x12" and "-oFILE"; "" if the word has none, such as "-" and "-1.5"
std::string option_in(const std::string& word) {
  if (word.starts_with("--")) return word == "--" ? "" : word.substr(0, word.find('='));
  const bool letter = word.size() > 1 && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
  return letter && word[0] == '-' ? word.substr(0, 2) : "";
}

// the first option that this command does not have; "" if there is none
std::string unknown_option(const std::vector<std::string>& known,
                           const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    std::string option = option_in(word);
    if (option.empty()) continue;
    if (std::find(known.begin(), known.end(), option) == known.end()) return option;
  }
  return {};
}

void add_names(const CLI::App& app,
               std::vector<std::string>& long_names,
               std::vector<std::string>& all) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      long_names.push_back("--" + name);
      all.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames())
      all.push_back("-" + name);
  }
}

}  // namespace

void refuse_words_in_other_encodings(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    for (std::size_t i = 0, length = 0; i < word.size(); i += length) {
      length = utf8_length(word, i);
      if (length > 0) continue;
      throw input_error(
          "'{}' goes on with the byte 0x{:02x}, which is not UTF-8 text; write values as UTF-8, "
          "and "
          "rename a file or folder whose name is not",
          word.substr(0, i),
          static_cast<unsigned char>(word[i]));
    }
  }
}

// CLI11 only says that it was unexpected
void refuse_unknown_command(const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return;
  std::vector<std::string> names;
  for (const Command& command : commands()) {
    if (command.name == words.front()) return;
    names.emplace_back(command.name);
  }
  throw input_error("unknown command '{}'{}", words.front(), suggestion(words.front(), names));
}

Error explain(const CLI::ParseError& error,
              const CLI::App& app,
              const std::vector<std::string>& words) {
  if (app.get_subcommands().empty()) {
    std::vector<std::string> names;
    for (const Command& command : commands())
      names.emplace_back(command.name);
    return input_error("give a command: {}; see `polhode --help`", fmt::join(names, ", "));
  }
  const CLI::App& command = *app.get_subcommands().front();
  std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    std::vector<std::string> own, of_program, all;
    add_names(command, own, all);
    add_names(app, of_program, all);
    const std::string unknown = unknown_option(all, words);
    if (!unknown.empty()) {
      // one letter is near to every other
      const std::string hint = unknown.starts_with("--")
                                   ? suggestion(unknown, own)
                                   : fmt::format(" (known: {})", fmt::join(own, ", "));
      return input_error("{} has no option {}{}", command.get_name(), unknown, hint);
    }
    const std::vector<std::string> left = app.remaining(true);
    const std::string word = left.empty() ? "" : left.front();
    text = word.starts_with("-") ? fmt::format("'{}' must come after the command", word)
                                 : fmt::format("unexpected argument '{}'", word);
  } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    // "--size: 1 required TEXT missing" in several wordings; the first word is the option
    text = text.substr(0, text.find(':')) + " needs a value";
  }
  return input_error(
      "{}: {}; see `polhode {} --help`", command.get_name(), text, command.get_name());
}

std::vector<std::string> with_work_apart(const CLI::App& app, std::vector<std::string> words) {
  if (words.empty() || words.front() != kSubmit) return words;
  const CLI::App* command = app.get_subcommand(kSubmit);
  const auto takes_value = [&](const std::string& name) {
    const CLI::Option* option = command->get_option_no_throw(name);
    return option != nullptr && option->get_items_expected_max() > 0;
  };
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--") return words;
    if (!word.starts_with('-')) {
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(i), "--");
      return words;
    }
    if (word.find('=') == std::string::npos && takes_value(word)) ++i;
  }
  return words;
}

void parse_words(CLI::App& app, const std::vector<std::string>& words) {
  // CLI11 takes the word after "--size=" for its value
  for (const std::string& word : words) {
    if (word == "--") break;
    if (!word.starts_with("--") || word.find('=') != word.size() - 1) continue;
    throw input_error("{}: {} needs a value; see `polhode {} --help`",
                      words.front(),
                      word.substr(0, word.size() - 1),
                      words.front());
  }
  app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
}

}  // namespace polhode
