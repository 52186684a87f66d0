// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "support_fcl/fcl_adapter.h"

/// The collision elements of a set-up for FCL, in the form in which FCL is fastest.
namespace collision_monitor::test {

using FclObjects = std::vector<std::unique_ptr<FclObject>>;  ///< by ElementId

/// The collision element from which an element was made.
/// @throws std::runtime_error if a rule gives the element.
const CollisionElement& sourceOf(const RobotModel& model, const Element& element);

/// By ElementId; nullptr for a mesh without triangles.
std::vector<FclGeometry> fclGeometries(const CycleSetup& setup);

/// At these poses, by ElementId; nullptr where there is no geometry.
FclObjects placeFcl(const std::vector<FclGeometry>& geometries, const std::vector<Pose>& poses);

/// The number of element pairs in contact by FCL, which tests only pairs whose boxes meet.
std::size_t fclContacts(const CycleSetup& setup, const FclObjects& objects);

/// [m] The least distance of all pairs; 0 or less if surfaces cross. FCL is told the least distance
/// so far. It skips pairs whose boxes are farther apart, and stops at a contact.
double fclLeast(const CycleSetup& setup, const FclObjects& objects);

/// As fclLeast, with every pair measured alone.
double fclLeastOfEvery(const CycleSetup& setup, const FclObjects& objects);

}  // namespace collision_monitor::test
