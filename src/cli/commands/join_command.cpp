// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/join.h"
#include "cli/closing_line.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_join(CLI::App& command) {
  auto job = std::make_shared<JoinJob>();
  auto progress = std::make_shared<ProgressOptions>();
  command.add_option("parts", job->parts, "pieces made by `polhode render --shard`, in any order")
      ->required()
      ->type_name("PART");
  add_text(
      command, "-o,--output", job->output, "the joined film, with the same ending as its pieces")
      ->required()
      ->type_name("OUT");
  add_quiet(command, *progress);
  return [job, progress] {
    return make_and_tell(*progress, [&] { return join_pieces(*job); });
  };
}

}  // namespace polhode
