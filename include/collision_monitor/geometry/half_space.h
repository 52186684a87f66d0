// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

/// Everything below a plane: the points with z <= 0 in its own frame, to be placed by a pose. The
/// plane passes through the frame's origin and z points out of the solid.
struct HalfSpace {};

}  // namespace collision_monitor
