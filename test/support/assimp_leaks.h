// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// assimp 5.2 leaks what it has built when a file turns out to be malformed. Leaks of ours are
// still found: only stacks that end in assimp are passed over. Included by tests that read such
// files.
#ifdef __SANITIZE_ADDRESS__
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is the sanitizer's.
extern "C" __attribute__((used)) inline const char* __lsan_default_suppressions() {
  return "leak:libassimp";
}
#endif
