// SPDX-License-Identifier: MIT
// Points of a work-precision chart that no method has been run for.
#pragma once

#include "chart/work_precision.h"

namespace polhode::test {

inline WorkPoint drawn(const char* method, double time_us, double error_rad, const char* status) {
  WorkPoint p;
  p.method = method;
  p.time_us = time_us;
  p.error_rad = error_rad;
  p.evaluations = 10;
  p.status = status;
  return p;
}

}  // namespace polhode::test
