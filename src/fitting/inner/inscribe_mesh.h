// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/inner_shape.h"

namespace collision_monitor {

/// inscribeShapes for a mesh. @pre the mesh is valid; see checkGeometry.
InnerShapes inscribeMesh(const TriangleMesh& mesh);

}  // namespace collision_monitor
