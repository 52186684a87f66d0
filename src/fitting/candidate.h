// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// What the choice goes by. Units: metres.
double coarseness(const Overshoot& overshoot) noexcept;

/// The least coarse of candidates; at nearly the same coarseness the one whose distances cost
/// least. @pre one of them is of an allowed kind.
Enclosure chooseTightest(const std::vector<Enclosure>& candidates, const ShapeKinds& kinds);

/// The candidates, one of each kind, proven and measured.
std::vector<Enclosure> encloseCapsule(const Capsule& capsule);
std::vector<Enclosure> encloseCylinder(const Cylinder& cylinder);
std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh);
std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh, const TriangleBvh& bvh);

}  // namespace collision_monitor
