// SPDX-License-Identifier: MIT
// A function attribute that makes GCC compile a second copy of the function for processors with
// wide vector registers.
#pragma once

// Write it in front of a function definition. On x86-64 the AVX2 copy runs if the processor has
// AVX2, else the default one. Both give the same bits, because plain AVX2 has no fused
// multiply-add. On other processors, and with a sanitizer, there is one copy only: the choice
// between two runs before the sanitizer is ready.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define POLHODE_WIDE_REGISTERS [[gnu::target_clones("avx2", "default")]]
#else
#define POLHODE_WIDE_REGISTERS
#endif
