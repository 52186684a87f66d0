// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/interrupted.h"

/// Interrupts long work of a set-up from outside, for example because the program is to end.
namespace collision_monitor {

/// While it lives, the library's work on this thread ends with Interrupted as soon as `goes_on`
/// returns false. This covers reading files and meshes, fitting, making pairs and applying rules.
/// Limits: only the innermost one is asked. Libraries that this one calls are not.
class Interruptible {
 public:
  /// @param goes_on empty: work is not interrupted
  explicit Interruptible(GoesOn goes_on);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  GoesOn goes_on_;
  const GoesOn* outer_;
};

/// Long work calls this again and again.
/// @throws Interrupted when the work of this thread is no longer wanted
void throwIfInterrupted();

/// What throwIfInterrupted asks on this thread, for other threads that do a part of its work. Empty
/// if there is nothing to ask.
GoesOn goesOnHere();

}  // namespace collision_monitor
