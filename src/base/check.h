// SPDX-License-Identifier: MIT
// CHECK(condition) and ASSERT(condition): assertions about the program itself (faults of the user
// throw Error, see base/error.h). If the condition is false, they print it on stderr and abort the
// process. CHECK is active in every build, ASSERT in debug builds only: with NDEBUG it does not
// evaluate its condition. The message names the file without its folder, so the binary does not
// depend on where it was built.
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
