// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/watch.h"

#include <utility>

namespace collision_monitor {

Watch::Watch(std::shared_ptr<const MonitorSetup> fixed_parts, const TransformStore& store)
    : fixed(std::move(fixed_parts)),
      reader(fixed->setup.model, store, {fixed->world_frame, fixed->parameters.max_age}),
      poses(makeLinkPoses(fixed->setup.model)),
      buffers(makeBuffers(
          fixed->setup, fixed->parameters.broad_phase.value_or(chooseBroadPhase(fixed->setup)))) {}

BroadPhaseKind chooseBroadPhase(const CycleSetup& setup) noexcept {
  constexpr std::size_t kManyPairs = 500;
  return setup.table.size() < kManyPairs ? BroadPhaseKind::brute_force
                                         : BroadPhaseKind::sweep_and_prune;
}

void findUnknownLinks(const Watch& watch, std::vector<LinkId>& links) {
  links.clear();
  const RobotModel& model = watch.setup().model;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (hasShapes(model.links[i]) && watch.poses.status[i] != LinkStatus::known) {
      links.push_back(idAt<LinkId>(i));
    }
  }
}

}  // namespace collision_monitor
