// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <mutex>

namespace collision_monitor {

/// Who may replace the set-up. Whoever takes both takes `change` first.
struct ChangeLocks {
  /// Held by each change that is asked for, and while late robots are taken in: a reload takes
  /// long.
  std::timed_mutex change;
  /// Held from reading the rules of the current set-up to replacing it. Rules that end take it
  /// alone, so that no mute lasts longer than a long change allows.
  std::mutex swap;

  /// Waits for changes that are nearly done. Callers refuse what does not get the lock: it would
  /// keep a thread of the services waiting.
  std::unique_lock<std::timed_mutex> beginChange() {
    constexpr std::chrono::seconds kPatience(2);
    return std::unique_lock<std::timed_mutex>(change, kPatience);
  }
};

/// Why a change is refused that does not get the lock.
inline constexpr const char* kOtherChange =
    "nothing was changed: another change is running (a reload, objects, rules, or a robot that has "
    "come); try again when it is done";

}  // namespace collision_monitor
