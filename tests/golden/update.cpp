// SPDX-License-Identifier: MIT
// Draws the golden pictures anew: a deliberate act, `cmake --build --preset golden-update`.
#include <cstdio>

#include "base/error.h"
#include "golden/cases.h"

int main() {
  try {
    for (const polhode::golden::Case& one : polhode::golden::cases()) {
      polhode::golden::render(one, polhode::golden::reference(one));
      std::printf("%s\n", polhode::golden::reference(one).c_str());
    }
    return 0;
  } catch (const polhode::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.fault());
  }
}
