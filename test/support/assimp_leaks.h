// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// assimp 5.2 leaks memory when a file is malformed. This suppresses only leaks whose stacks end in
// assimp, so leaks of this package are still found. For tests that read such files.
#ifdef __SANITIZE_ADDRESS__
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is the sanitizer's.
extern "C" __attribute__((used)) inline const char* __lsan_default_suppressions() {
  return "leak:libassimp";
}
#endif
