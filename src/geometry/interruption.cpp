// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/interruption.h"

#include <utility>

namespace collision_monitor {
namespace {

/// One per thread, so that the function need not be passed from the set-up down to the innermost
/// loop of a fit.
thread_local const GoesOn* asked = nullptr;

}  // namespace

Interruptible::Interruptible(GoesOn goes_on) : goes_on_(std::move(goes_on)), outer_(asked) {
  asked = goes_on_ ? &goes_on_ : nullptr;
}

Interruptible::~Interruptible() { asked = outer_; }

void throwIfInterrupted() {
  if (asked != nullptr && !(*asked)()) {
    throw Interrupted();
  }
}

GoesOn goesOnHere() { return asked == nullptr ? GoesOn() : GoesOn(std::ref(*asked)); }

}  // namespace collision_monitor
