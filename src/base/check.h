// SPDX-License-Identifier: MIT
// Assertions about the program itself: CHECK is active in every build, ASSERT in debug builds only.
// Both print the condition and abort. The message names the file without its folder, so the binary
// does not depend on where it was built.
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
