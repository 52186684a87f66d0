// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Before any header of Highway: instruction sets that are left out. Vectors whose length is only
/// known at run time cannot stand in structs, and NEON serves the same machines. Under the address
/// sanitizer every set takes most of a minute to compile: AVX2 and the plainest stand for all.
#ifdef __SANITIZE_ADDRESS__
#define HWY_DISABLED_TARGETS                                                                     \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | \
   HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif
