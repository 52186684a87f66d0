// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "peers/peer_pairs.h"
#include "support_fcl/fcl_adapter.h"

/// The collision elements of a set-up for FCL, in the form in which FCL is fastest.
namespace collision_monitor::test {

using FclObjects = PeerObjects<FclObject>;

/// The collision element from which an element was made.
/// @throws std::runtime_error if a rule gives the element.
const CollisionElement& sourceOf(const RobotModel& model, const Element& element);

/// By ElementId; nullptr for a mesh without triangles.
std::vector<FclGeometry> fclGeometries(const CycleSetup& setup);

FclObjects placeFcl(const std::vector<FclGeometry>& geometries, const std::vector<Pose>& poses);

/// The number of element pairs in contact by FCL, which tests only pairs whose boxes meet.
std::size_t fclContacts(const CycleSetup& setup, const FclObjects& objects);

/// Whether any element pair is in contact by FCL: it stops at the first.
bool fclHasContact(const CycleSetup& setup, const FclObjects& objects);

/// As leastDistance.
double fclLeast(const CycleSetup& setup, const FclObjects& objects);

/// As leastOfEveryDistance.
double fclLeastOfEvery(const CycleSetup& setup, const FclObjects& objects);

}  // namespace collision_monitor::test
