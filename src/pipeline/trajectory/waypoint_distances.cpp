// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory/waypoint_distances.h"

#include <algorithm>

namespace collision_monitor {
namespace {

void measureBlock(const CycleSetup& setup, const std::vector<LinkPairIndex>& pairs,
                  std::size_t first, WaypointDistances& distances,
                  std::vector<StateNumber>& nearest) noexcept {
  for (StateNumber& numbers : nearest) {
    std::fill(std::begin(numbers.of), std::end(numbers.of), kNotAsked);
  }
  for (const LinkPairIndex pair : pairs) {
    StateNumber& numbers = nearest[pair];
    const CheckedLinkPair& links = setup.checked[pair];
    const bool is_known = isJoined(distances.work.poses, links.a, links.b);
    std::fill(std::begin(numbers.of), std::end(numbers.of), is_known ? distances.reach : kUnknown);
  }
  fillVariables(distances.positions, first, distances.work);
  placeStates(setup, distances.work);
  measureLinkPairs(setup, distances.work, nearest);
}

}  // namespace

WaypointDistances makeWaypointDistances(const CycleSetup& setup, const JointPath& path,
                                        const LinkPoses& start, double reach) {
  std::vector<bool> moves(setup.model.variable_count, false);
  for (const JointId joint : path.joints) {
    moves[setup.model.joint(joint).first_variable] = true;
  }
  WaypointDistances distances{
      reach, makeShapeStatesWork(setup, standingAs(setup.model, start, moves)), {}, {}, 0, 0};
  JointPositions state(setup.model.variable_count, 0.0);
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    setPositions(setup.model, path, i, 0.0, state);
    distances.positions.insert(distances.positions.end(), state.begin(), state.end());
  }
  constexpr std::size_t kMostNumbers = 1U << 16U;  // 4 MB
  const std::size_t blocks = (path.times.size() + kStateCount - 1) / kStateCount;
  const std::size_t most = std::max<std::size_t>(1, kMostNumbers / setup.checked.size());
  distances.nearest.assign(std::min(blocks, most), std::vector<StateNumber>(setup.checked.size()));
  return distances;
}

std::uint64_t measureWaypoint(const CycleSetup& setup, const std::vector<LinkPairIndex>& pairs,
                              std::size_t waypoint, WaypointDistances& distances) noexcept {
  if (waypoint >= distances.first && waypoint < distances.last) {
    return 0;
  }
  const std::size_t end = distances.positions.size() / setup.model.variable_count;
  distances.first = distances.last = waypoint - waypoint % kStateCount;
  std::uint64_t work = 0;
  for (std::vector<StateNumber>& nearest : distances.nearest) {
    if (distances.last < end) {
      measureBlock(setup, pairs, distances.last, distances, nearest);
      distances.last = std::min(end, distances.last + kStateCount);
      work += setup.table.size();
    }
  }
  return work;
}

}  // namespace collision_monitor
