// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/verify.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_verify(CLI::App& command) {
  auto job = std::make_shared<VerifyJob>();
  auto progress = std::make_shared<ProgressOptions>();
  command.add_option("output", job->output, "what `polhode render` made")
      ->required()
      ->type_name("OUT");
  add_text(command,
           "--report",
           job->report,
           "the report of that run (default: OUT with the ending .json)")
      ->type_name("FILE.json");
  add_progress(command, *progress);
  return [job, progress] {
    job->progress = progress_of(*progress);
    const Verified verified = verify(*job);
    print_out(verified.text + "\n");
    return verified.same ? 0 : static_cast<int>(Fault::check_failed);
  };
}

}  // namespace polhode
