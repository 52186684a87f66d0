// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "support_fcl/fcl_adapter.h"

/// The collision elements of a set-up for FCL, which is given what it is fastest with.
namespace collision_monitor::test {

using FclObjects = std::vector<std::unique_ptr<FclObject>>;  ///< by ElementId

/// What an element was made of.
/// @throws std::runtime_error for one that a rule gives.
const CollisionElement& sourceOf(const RobotModel& model, const Element& element);

/// By ElementId; nullptr for a mesh without triangles.
std::vector<FclGeometry> fclGeometries(const CycleSetup& setup);

/// At these poses, by ElementId; nullptr where there is no geometry.
FclObjects placeFcl(const std::vector<FclGeometry>& geometries, const std::vector<Pose>& poses);

/// Pairs of elements that FCL sees in contact: it is asked of those whose boxes meet.
std::size_t fclContacts(const CycleSetup& setup, const FclObjects& objects);

/// [m] The least distance of all pairs; 0 or less where surfaces cross. FCL knows the least so far,
/// and is not asked of pairs whose boxes are farther apart, nor after a contact.
double fclLeast(const CycleSetup& setup, const FclObjects& objects);

/// The same with every pair measured alone.
double fclLeastOfEvery(const CycleSetup& setup, const FclObjects& objects);

}  // namespace collision_monitor::test
