// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_monitor/model/world.h"
#include "collision_monitor/pipeline/setup.h"

/// The shapes of objects, made ready for set-ups.
namespace collision_monitor {

/// What an object adds to a set-up. Links and ids are filled in when it is added: the element of a
/// body is its position among these elements.
///
/// Frames: that of the object stands in place of the link's.
struct PreparedObject {
  std::shared_ptr<const ObjectShapes> shapes;  ///< made from these
  double padding{0.0};                         ///< [m]
  std::vector<Body> bodies;
  std::vector<BodyLabel> labels;
  std::vector<Element> elements;
};

/// [m] Half the size of the box that stands for a plane among the bodies, below it. It holds every
/// point that may come near: poses from outside end at kFarthest.
constexpr double kPlaneReach = 4.0 * kFarthest;

/// [m] How far that box sticks out, so that rounding at its size never makes a distance too large:
/// the rotation of a long chain may be off by 2e-14.
constexpr double kPlaneWidening = 2e-4;

/// Makes bodies and elements: primitives are their own shapes, and a cylinder, cone, mesh or plane
/// has a box or another shape around it. The element of a cone is a hull that sticks out by at most
/// 0.2 % of its radius; other elements are exact.
/// @pre checkObject found no fault
/// @throws SetupError that names the object, if its shapes cannot be made
std::shared_ptr<const PreparedObject> prepareObject(const WorldObject& object,
                                                    RefineGeometry refine);

/// By name of the object.
using PreparedObjects = std::map<std::string, std::shared_ptr<const PreparedObject>>;

/// Prepares all objects of a world, on all processors. Takes those over from `former` whose shapes
/// and padding are the same.
/// @throws Interrupted
PreparedObjects prepareObjects(const World& world, RefineGeometry refine,
                               const PreparedObjects& former);

}  // namespace collision_monitor
