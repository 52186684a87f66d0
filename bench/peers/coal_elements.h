// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "peers/coal_adapter.h"
#include "peers/peer_pairs.h"

/// The collision elements of a set-up for Coal, as fcl_elements.h has them for FCL.
namespace collision_monitor::test {

using CoalObjects = PeerObjects<CoalObject>;

/// By ElementId; nullptr for a mesh without triangles.
std::vector<CoalGeometry> coalGeometries(const CycleSetup& setup);

CoalObjects placeCoal(const std::vector<CoalGeometry>& geometries, const std::vector<Pose>& poses);

/// The number of element pairs in contact by Coal, which tests only pairs whose boxes meet.
std::size_t coalContacts(const CycleSetup& setup, const CoalObjects& objects);

/// As leastDistance.
double coalLeast(const CycleSetup& setup, const CoalObjects& objects);

/// As leastOfEveryDistance.
double coalLeastOfEvery(const CycleSetup& setup, const CoalObjects& objects);

}  // namespace collision_monitor::test
