// SPDX-License-Identifier: MIT
// Functions that are worth a second copy for processors with wide registers.
#pragma once

// The same bits on every processor: wider registers, but no fused operations.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define POLHODE_WIDE_REGISTERS [[gnu::target_clones("avx2", "default")]]
#else
#define POLHODE_WIDE_REGISTERS
#endif
