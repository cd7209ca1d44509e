// SPDX-License-Identifier: MIT
#include "base/system/system_error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>

namespace polhode {

Fault fault_of(int reason) {
  constexpr int kLacks[] = {ENOMEM, EAGAIN, EMFILE, ENFILE, ENOSPC, EDQUOT, EIO};
  const bool lacks = std::find(std::begin(kLacks), std::end(kLacks), reason) != std::end(kLacks);
  return lacks ? Fault::environment : Fault::input;
}

Error system_error(int reason, const std::string& what, const std::string& advice) {
  const Fault fault = fault_of(reason);
  std::string message = fmt::format("{}: {}", what, std::strerror(reason));
  if (fault == Fault::input && !advice.empty()) message += "; " + advice;
  return {fault, message};
}

}  // namespace polhode
