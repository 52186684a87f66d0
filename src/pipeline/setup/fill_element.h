// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/pipeline/element.h"

namespace collision_monitor {

/// Fills in what an element is, from the geometry of the URDF: its shapes, mesh and exactness.
/// @throws std::invalid_argument when the geometry is of no use.
void fillElement(const Geometry& geometry, RefineGeometry refine, Element& element);

/// The same where an element of the same geometry, refined alike, has it already.
void fillAs(const Element& other, Element& element);

}  // namespace collision_monitor
