// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

/// The points with z <= 0 in its own frame, which a pose places. The boundary plane passes through
/// the frame's origin, and z points out of the solid.
struct HalfSpace {};

}  // namespace collision_monitor
