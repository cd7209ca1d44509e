// SPDX-License-Identifier: MIT
// The command `doctor`: checks what works on this machine and what is missing.
#pragma once

#include <string>
#include <vector>

#include "base/system/child_process.h"

namespace polhode {

// An optional program or file that only the caller knows how to find.
struct ExternalNeed {
  std::string name;   // what it is, for the first column of the list
  std::string state;  // "ok" with details, or "missing" with what to install, or "fails" and why
};

// The state of a program; `advice` is what to do if it is not installed.
std::string state_of_program(const ProgramFound& program, const std::string& advice);

// The result of the checks.
struct Diagnosis {
  std::string text;     // one line per check, in aligned columns
  bool healthy = true;  // false: no back end works, or H.264's encoder libx264 is missing
};

// Opens every OpenGL back end with its framebuffers, one after the other on the calling thread,
// and looks for fonts, encoders and gnuplot. `needs` are added to the list. Throws Error
// (interrupted) only.
Diagnosis examine(const std::vector<ExternalNeed>& needs);

}  // namespace polhode
