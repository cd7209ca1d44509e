// SPDX-License-Identifier: MIT
// Broken promises inside the program: CHECK always looks, ASSERT only in debug builds. Both abort.
// They name the file without its folder: what users run does not depend on where it was built.
#pragma once

#include <cstdio>
#include <cstdlib>

#define CHECK(condition)                                                                        \
  do {                                                                                          \
    if (!(condition)) {                                                                         \
      std::fprintf(stderr, "%s:%d: broken promise: %s\n", __FILE_NAME__, __LINE__, #condition); \
      std::abort();                                                                             \
    }                                                                                           \
  } while (false)

#ifdef NDEBUG
#define ASSERT(condition) static_cast<void>(0)
#else
#define ASSERT(condition) CHECK(condition)
#endif
