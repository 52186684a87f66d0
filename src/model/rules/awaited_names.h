// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

/// While it lives, names and groups in rules that match nothing are accepted on this thread: they
/// may be those of robots that come later.
class AwaitedNames {
 public:
  /// @param are_awaited false: nothing changes
  explicit AwaitedNames(bool are_awaited);
  ~AwaitedNames();
  AwaitedNames(const AwaitedNames&) = delete;
  AwaitedNames& operator=(const AwaitedNames&) = delete;

 private:
  bool outer_;
};

/// Whether a name that matches nothing is accepted.
bool areNamesAwaited();

}  // namespace collision_monitor
