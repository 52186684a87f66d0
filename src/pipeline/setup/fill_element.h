// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/pipeline/element.h"

namespace collision_monitor {

/// Fills shapes, mesh and exactness of an element from a geometry of the URDF.
/// @throws std::invalid_argument if the geometry cannot be used.
void fillElement(const Geometry& geometry, RefineGeometry refine, Element& element);
void fillElement(const TriangleMesh& mesh, RefineGeometry refine, Element& element);

/// Copies these from an element of the same geometry and refinement.
void fillAs(const Element& other, Element& element);

}  // namespace collision_monitor
