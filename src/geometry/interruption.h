// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

/// How long work of a set-up is given up from outside: because the program is to end, say.
namespace collision_monitor {

/// Ends work that is wanted no more. No std::exception: what makes a problem of every fault that
/// it meets, and goes on, must let this one pass.
struct Interrupted {};

/// Whether work may go on; asked often, so it must not take long.
using GoesOn = std::function<bool()>;

/// While it lives, what the library does on this thread ends in Interrupted as soon as `goes_on`
/// says no: reading files and meshes, fitting, making and ruling pairs.
/// Limits: the innermost one is asked alone. The libraries below are not interrupted.
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

/// Long work calls it again and again.
/// @throws Interrupted where the work of this thread is wanted no more
void throwIfInterrupted();

/// What throwIfInterrupted asks on this thread, for others that do a part of its work; empty if
/// there is nothing to ask.
GoesOn goesOnHere();

}  // namespace collision_monitor
