// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "narrow_phase/convex/convex_pairs.h"
#include "peers/fcl_elements.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "support/robots/file_loader.h"

/// A robot of the shared data that moves through random configurations, for us and for FCL.
namespace collision_monitor::test {

constexpr std::size_t kStates = 400;  ///< a hundredth of the path between two configurations apart

/// The first description of an arm and of four robots with many links; none without shared data.
std::vector<RobotFile> benchRobots();

/// The name of its folder.
std::string robotNameOf(const RobotFile& robot);

struct RobotScene {
  CycleSetup setup;               ///< one enclosing shape per element
  std::vector<LinkPoses> states;  ///< kStates
  BodyPoses poses;                ///< of the last state placed
  BodyBounds boxes;
  BroadPhase broad_phase;
  std::vector<PairId> candidates;
  PairDistances distances;
  std::vector<std::pair<double, ElementPairIndex>> bounds;  ///< [m] in the last state
  RefineStore memory;
  ElementPairIndex nearest{0};  ///< in the last state
  std::unique_ptr<RefineScratch> scratch;
  std::vector<std::optional<ConvexGeometry>> hulls;   ///< by ElementId
  std::vector<std::vector<Pose>> world_from_element;  ///< by state and ElementId
  std::vector<ConvexWarmStart> warm;                  ///< of hulls, by ElementPairIndex
  std::vector<ConvexQuery> queries;                   ///< of hulls, by ElementPairIndex
  std::vector<ConvexDistance> answers;                ///< to `queries`
  std::vector<FclObjects> fcl_states;                 ///< by state: the geometries
  std::vector<FclObjects> fcl_hulls;
};

std::unique_ptr<RobotScene> makeRobotScene(const RobotFile& robot);

/// Places the robot, and fills `bounds` with the distances of enclosing shapes whose boxes meet.
void boundPairs(RobotScene& scene, std::size_t state);

/// False if the bodies are proven to be `distance` apart.
/// @pre the robot is placed.
bool mayBeNearer(const RobotScene& scene, const BodyPair& pair, double distance);

/// [m] Distance of the geometries, or a proven bound of at least `enough`.
/// @pre the robot is placed.
double measurePair(RobotScene& scene, ElementPairIndex pair, double enough);

/// Whether the geometries touch.
bool touch(RobotScene& scene, ElementPairIndex pair);

/// Measures the signed distances of the hulls of all pairs of geometries, into `answers`.
void measureHulls(RobotScene& scene, std::size_t state);

}  // namespace collision_monitor::test
