// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace collision_monitor {

/// Thrown to end work that is no longer wanted. It is not a std::exception: code that turns every
/// fault into a problem and goes on must let it pass.
struct Interrupted {};

/// Whether work may go on. It is called often, so it must be fast.
using GoesOn = std::function<bool()>;

}  // namespace collision_monitor
