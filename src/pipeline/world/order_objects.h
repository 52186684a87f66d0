// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/world.h"

namespace collision_monitor {

/// Sorts very many objects of one carrier so that neighbours in space are neighbours in memory: a
/// cycle asks for those that are near, and each node of a RigidTree holds neighbours. Few objects
/// keep their order, as do those at one place.
/// @param objects in the same frame
void orderByPlace(std::vector<const WorldObject*>& objects);

}  // namespace collision_monitor
