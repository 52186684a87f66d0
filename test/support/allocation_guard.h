// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace collision_monitor::test {

/// Counts the calls of operator new in this thread while it lives. Linking its source file replaces
/// the global operator new and delete of the test program.
class AllocationGuard {
 public:
  AllocationGuard();
  ~AllocationGuard();
  AllocationGuard(const AllocationGuard&) = delete;
  AllocationGuard& operator=(const AllocationGuard&) = delete;

  std::size_t count() const;
};

}  // namespace collision_monitor::test
