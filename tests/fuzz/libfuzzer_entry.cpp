// SPDX-License-Identifier: MIT
// The functions that libFuzzer calls, for the harness that this is linked with.
#include <cstddef>
#include <cstdint>

#include <spdlog/spdlog.h>

#include "base/error.h"
#include "fuzz/harness.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  spdlog::set_level(spdlog::level::off);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // libFuzzer passes no data as a null pointer
  const std::string bytes(data, data + size);
  try {
    polhode::run_harness(bytes);
  } catch (const polhode::Error&) {
    return 0;  // refused, as bad input should be
  }
  return 0;
}
