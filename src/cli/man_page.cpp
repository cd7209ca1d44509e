// SPDX-License-Identifier: MIT
#include "cli/man_page.h"

#include <cctype>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/version.h"
#include "cli/command.h"
#include "cli/commit.h"
#include "cli/value_kinds.h"

namespace polhode {
namespace {

// Text as man(7) wants it: no dot or quote begins a line as a macro, and - stays the minus that one
// can copy.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if (c == '`') {
      out += "\\(ga";
    } else if (c == '\'') {
      out += "\\(aq";
    } else if (c == '^') {
      out += "\\(ha";
    } else if (c == '~') {
      out += "\\(ti";
    } else {
      if (c == '.' && (out.empty() || out.back() == '\n')) out += "\\&";
      out += c;
    }
  }
  return out;
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + escaped(text) + "\\fR";
}

// a phrase of --help as a sentence
std::string sentence(std::string phrase) {
  if (!phrase.empty())
    phrase[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(phrase[0])));
  return phrase + ".";
}

std::string head(const std::string& name, const std::string& doc) {
  std::string upper = name;
  for (char& c : upper)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return fmt::format(".TH {} 1 {} \"Polhode {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n",
                     upper,
                     program_date(),
                     program_version(),
                     escaped(name),
                     escaped(doc));
}

// "-o, --output OUT" and what it means, with the words that may stand there
std::string option_entry(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
    names.push_back(bold("-" + name));
  for (const std::string& name : option.get_lnames())
    names.push_back(bold("--" + name));
  std::string title = fmt::format("{}", fmt::join(names, ", "));
  const std::string value = option.get_type_name();
  const bool takes = option.get_items_expected_max() > 0;
  if (option.get_positional()) {
    title = italic(value);
  } else if (takes) {
    title += " " + italic(value);
  }
  std::string text = ".TP\n" + title + "\n" + escaped(option.get_description()) + "\n";
  if (const std::string& preset = option.get_default_str(); takes && !preset.empty()) {
    text += "(default: " + escaped(preset) + ")\n";
  }
  const ValueKind* kind = takes ? find_value_kind(value) : nullptr;
  if (kind != nullptr && !kind->words.empty()) {
    text += fmt::format(".br\n{} is {}: {}.\n",
                        italic(value),
                        kind->form == ValueForm::word ? "one of" : "any of, with commas between",
                        escaped(fmt::format("{}", fmt::join(kind->words, ", "))));
  }
  return text;
}

std::string section(const char* title, const CLI::App& app, bool positional) {
  std::string entries;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() == positional) entries += option_entry(*option);
  }
  return entries.empty() ? "" : fmt::format(".SH {}\n", title) + entries;
}

const char* const kExitStatus =
    ".SH EXIT STATUS\n"
    ".TP\n0\nDone.\n"
    ".TP\n1\nA check said no.\n"
    ".TP\n2\nThe input or the command line is wrong.\n"
    ".TP\n3\nThe environment failed: no OpenGL, no encoder, a full disk.\n"
    ".TP\n130\nInterrupted.\n";

}  // namespace

std::string program_man_page(const CLI::App& program) {
  std::string page = head("polhode", "physically exact films of spinning bodies");
  page += ".SH SYNOPSIS\n.B polhode\n.I COMMAND\n[\\fIOPTION\\fR ...] [\\fIARGUMENT\\fR ...]\n";
  page +=
      ".SH DESCRIPTION\n" + escaped(program.get_description()) +
      "\nA scene file tells the body, how it is held and how it starts; each command below makes\n"
      "something of it and has a page of its own, such as\n.BR polhode\\-render (1).\n";
  page += ".SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands({})) {
    page += ".TP\n" + bold(command->get_name()) + "\n" + escaped(command->get_description()) + "\n";
  }
  page += section("OPTIONS", program, false);
  page += kExitStatus;
  page +=
      ".SH ENVIRONMENT\n"
      ".TP\n\\fBPOLHODE_SCENES\\fR\n"
      "Folder of the example scenes, instead of those that were installed with the program.\n"
      ".TP\n\\fBPOLHODE_REVEAL\\fR\nFolder of reveal.js, for the slides of\n"
      ".BR polhode\\-lecture (1).\n"
      ".TP\n\\fBPOLHODE_CHROMIUM\\fR\nThe program that prints the handout of\n"
      ".BR polhode\\-lecture (1).\n";
  page +=
      ".SH EXAMPLES\n"
      ".EX\npolhode list scenes\npolhode render free_symmetric_top.toml \\-o top.mp4\n.EE\n";
  std::vector<std::string> pages;
  for (const CLI::App* command : program.get_subcommands({})) {
    pages.push_back(".BR polhode\\-" + escaped(command->get_name()) + " (1)");
  }
  return page + ".SH SEE ALSO\n" + fmt::format("{}", fmt::join(pages, ",\n")) + "\n";
}

std::string command_man_page(const CLI::App& program, const CLI::App& command) {
  std::string page = head("polhode-" + command.get_name(), command.get_description());
  page +=
      fmt::format(".SH SYNOPSIS\n.B polhode {}\n[\\fIOPTION\\fR ...]", escaped(command.get_name()));
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const bool several = option->get_items_expected_max() > 1;
    const std::string word = italic(option->get_type_name()) + (several ? " ..." : "");
    page += option->get_required() ? " " + word : " [" + word + "]";
  }
  page += "\n.SH DESCRIPTION\n" + escaped(sentence(command.get_description())) + "\n";
  page += section("ARGUMENTS", command, true) + section("OPTIONS", command, false);
  for (const CLI::Option* option : program.get_options()) {
    if (option->check_lname("verbose")) page += option_entry(*option);
  }
  for (const Command& row : commands()) {
    if (command.get_name() != row.name) continue;
    page += fmt::format(".SH EXAMPLES\n.EX\n{}\n.EE\n", escaped(row.example));
  }
  return page + kExitStatus + ".SH SEE ALSO\n.BR polhode (1)\n";
}

}  // namespace polhode
