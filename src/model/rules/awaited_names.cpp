// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/rules/awaited_names.h"

namespace collision_monitor {
namespace {

/// One per thread, like what throwIfInterrupted asks.
thread_local bool awaited = false;

}  // namespace

AwaitedNames::AwaitedNames(bool are_awaited) : outer_(awaited) { awaited = are_awaited || outer_; }

AwaitedNames::~AwaitedNames() { awaited = outer_; }

bool areNamesAwaited() { return awaited; }

}  // namespace collision_monitor
