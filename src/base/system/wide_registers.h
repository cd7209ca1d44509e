// SPDX-License-Identifier: MIT
// A function attribute: compile a second copy for processors with wide vector registers.
#pragma once

// The AVX2 copy gives the same bits as the default one, because it has no fused multiply-add. GCC
// selects the copy at run time.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define POLHODE_WIDE_REGISTERS [[gnu::target_clones("avx2", "default")]]
#else
#define POLHODE_WIDE_REGISTERS
#endif
