// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/world.h"

namespace collision_monitor {

/// Sorts very many objects of one carrier so that neighbours in space are neighbours in memory: a
/// cycle asks for those that are near. Few objects keep their order, as do those at one place.
///
/// Source: Morton, "A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing"
/// (1966).
/// @param objects in the same frame
void orderByPlace(std::vector<const WorldObject*>& objects);

}  // namespace collision_monitor
