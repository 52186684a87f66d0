// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/world.h"
#include "model/kinematics/joint_path.h"
#include "peers/fcl_elements.h"
#include "support_fcl/solid.h"

namespace collision_monitor::test {

/// The same states for us and for FCL.
struct PlacedStates {
  const CycleSetup& setup;
  JointPositions positions;                           ///< of all states, one after the other
  std::vector<std::vector<Pose>> world_from_element;  ///< by state and ElementId
  std::vector<FclObjects> fcl;                        ///< by state
  std::vector<Inside> insides;                        ///< by ElementId

  std::size_t size() const { return fcl.size(); }
};

/// By ElementId: the geometry from which the element was made, of a link or of an object.
/// @param world the objects of the set-up
/// @throws std::runtime_error for what FCL has no geometry: padding, cones, planes, and shapes that
/// rules give.
std::vector<Geometry> sourceGeometries(const CycleSetup& setup, const World& world);

/// Random states, always the same ones of a model. A model without moving joints has one state.
/// @param geometries as sourceGeometries
PlacedStates drawPlacedStates(const CycleSetup& setup, const std::vector<Geometry>& geometries,
                              std::size_t count);

/// Whether one element of the pair is inside the other, which FCL does not see.
Holds holdsOneInOther(const PlacedStates& states, std::size_t state, const ElementPair& pair);

}  // namespace collision_monitor::test
