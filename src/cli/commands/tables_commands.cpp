// SPDX-License-Identifier: MIT
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands/doctor.h"
#include "app/commands/list.h"
#include "app/commands/schema.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "lecture/lecture.h"

namespace polhode {

Action define_list(CLI::App& command) {
  auto what = std::make_shared<std::string>();
  command.add_option("what", *what, fmt::format("{}", fmt::join(list_names(), ", ")))
      ->type_name("TABLE");
  return [what] {
    if (what->empty()) {
      throw input_error("give the name of a table: {}", fmt::join(list_names(), ", "))
          .at({{}, 0, "list"});
    }
    print_out(list_table(*what));
    return 0;
  };
}

Action define_schema(CLI::App& command) {
  const auto films = std::make_shared<bool>(false);
  command.add_flag("--film", *films, "the schema of film files");
  return [films] {
    print_out(schema_text(*films));
    return 0;
  };
}

Action define_doctor(CLI::App&) {
  return [] {
    const Diagnosis diagnosis = examine(lecture_needs());
    print_out(diagnosis.text);
    return diagnosis.healthy ? 0 : static_cast<int>(Fault::environment);
  };
}

}  // namespace polhode
