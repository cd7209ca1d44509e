// SPDX-License-Identifier: MIT
// The command `doctor`: what works on this machine and what is missing.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// Something that the program uses if it is installed, and "ok" or what to install.
struct ExternalNeed {
  std::string name;
  std::string state;
};

// `healthy` is false when no film can be made.
struct Diagnosis {
  std::string text;
  bool healthy = true;
};

// Opens every back end, and looks for fonts, encoders and programs; `needs` are listed too.
Diagnosis examine(const std::vector<ExternalNeed>& needs);

}  // namespace polhode
