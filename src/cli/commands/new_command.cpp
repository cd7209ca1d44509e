// SPDX-License-Identifier: MIT
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands/new_scene.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {
namespace {

// the kinds, a line each
std::string words_for_kinds() {
  std::vector<std::string> lines;
  for (const NewKind& kind : new_kinds())
    lines.push_back(fmt::format("{}: {}", kind.name, kind.doc));
  return fmt::format("{}", fmt::join(lines, "; "));
}

}  // namespace

Action define_new(CLI::App& command) {
  auto kind = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>();
  command.add_option("kind", *kind, words_for_kinds())->type_name("NEW");
  add_text(command, "-o,--output", *output, "name of the file (default: that of the kind)")
      ->type_name("OUT");
  return [kind, output] {
    if (kind->empty())
      throw input_error("give what to write: {}", words_for_kinds()).at({{}, 0, "new"});
    print_err(fmt::format("polhode: {}\n", write_new(*kind, *output)));
    return 0;
  };
}

}  // namespace polhode
