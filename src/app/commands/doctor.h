// SPDX-License-Identifier: MIT
// The command `doctor`: checks what works on this machine and what is missing.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// An optional program or file, with "ok" or what to install.
struct ExternalNeed {
  std::string name;
  std::string state;
};

// The result of the checks.
struct Diagnosis {
  std::string text;
  bool healthy = true;  // false: no film can be made
};

// Opens every back end and looks for fonts, encoders and programs. `needs` are added to the list.
// Throws Error (interrupted) only.
Diagnosis examine(const std::vector<ExternalNeed>& needs);

}  // namespace polhode
