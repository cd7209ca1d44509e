// SPDX-License-Identifier: MIT
// Whose fault it is that a call of the system failed.
#pragma once

#include <string>

#include "base/error.h"

namespace polhode {

// The fault, by the errno of the call: (environment) if memory, threads, disk space or open files
// lack or a device fails; else (input), such as for a file that does not exist or may not be
// written.
Fault fault_of(int reason);

// An Error of that fault without a place, "WHAT: REASON", such as "cannot be read: Permission
// denied". `advice`, what the user can do about bad input ("choose another output"), follows where
// the fault is (input).
Error system_error(int reason, const std::string& what, const std::string& advice = "");

}  // namespace polhode
