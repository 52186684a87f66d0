// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/waypoint_distances.h"

#include <algorithm>

namespace collision_monitor {

WaypointDistances makeWaypointDistances(const CycleSetup& setup, const JointPath& path,
                                        const LinkPoses& start, double reach) {
  std::vector<bool> moves(setup.model.variable_count, false);
  for (const JointId joint : path.joints) {
    moves[setup.model.joint(joint).first_variable] = true;
  }
  WaypointDistances distances{
      reach, makeStatesWork(setup, standingAs(setup.model, start, moves)), {}, {}};
  JointPositions state(setup.model.variable_count, 0.0);
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    setPositions(setup.model, path, i, 0.0, state);
    distances.positions.insert(distances.positions.end(), state.begin(), state.end());
  }
  distances.nearest.resize(setup.checked.size());
  return distances;
}

std::uint64_t measureWaypoint(const CycleSetup& setup, const std::vector<LinkPairIndex>& pairs,
                              std::size_t waypoint, WaypointDistances& distances) noexcept {
  const std::size_t first = waypoint - waypoint % kStateCount;
  if (first == distances.first) {
    return 0;
  }
  distances.first = first;
  for (StateNumber& nearest : distances.nearest) {
    std::fill(std::begin(nearest.of), std::end(nearest.of), kNotAsked);
  }
  for (const LinkPairIndex pair : pairs) {
    StateNumber& nearest = distances.nearest[pair];
    const CheckedLinkPair& links = setup.checked[pair];
    const bool is_known = isJoined(distances.work.poses, links.a, links.b);
    std::fill(std::begin(nearest.of), std::end(nearest.of), is_known ? distances.reach : kUnknown);
  }
  fillVariables(distances.positions, first, distances.work);
  placeStates(setup, distances.work);
  measureLinkPairs(setup, distances.work, distances.nearest);
  return setup.table.size();
}

}  // namespace collision_monitor
