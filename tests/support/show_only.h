// SPDX-License-Identifier: MIT
// A [show] table with nothing but what is named.
#pragma once

#include <string>

#include "frame/elements.h"

namespace polhode::test {

// "": nothing at all.
inline ShowSpec show_only(const std::string& name) {
  ShowSpec show;
  for (const Element& element : elements())
    show[element.name] = element.name == name;
  return show;
}

}  // namespace polhode::test
