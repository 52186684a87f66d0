// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Disabled instruction sets; include this before Highway. Vectors of a length only known at run
/// time cannot be members of structs, and NEON serves the same machines. With the address sanitizer
/// each set takes most of a minute to compile, so only AVX2 and the baseline remain.
#ifdef __SANITIZE_ADDRESS__
#define HWY_DISABLED_TARGETS                                                                     \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | \
   HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif
