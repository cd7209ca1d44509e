// SPDX-License-Identifier: MIT
#include "base/version.h"

namespace polhode {

std::string program_version() {
  return POLHODE_VERSION;
}

}  // namespace polhode
