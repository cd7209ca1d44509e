// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/join.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_join(CLI::App& command) {
  auto job = std::make_shared<JoinJob>();
  command.add_option("parts", job->parts, "pieces made by `polhode render --shard`, in any order")
      ->required()
      ->type_name("PART");
  add_text(command, "-o,--output", job->output, "the film, with the ending of its pieces")
      ->required()
      ->type_name("OUT");
  return [job] {
    join_pieces(*job);
    return 0;
  };
}

}  // namespace polhode
