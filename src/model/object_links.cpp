// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/object_links.h"

namespace collision_monitor {

std::vector<ObjectRun> objectRuns(const RobotModel& model) {
  std::vector<ObjectRun> runs;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!isObject(model, idAt<LinkId>(i))) {
      continue;
    }
    const LinkId carrier = model.joint(*model.links[i].parent_joint).parent;
    if (runs.empty() || runs.back().last != i || runs.back().carrier != carrier) {
      runs.push_back({carrier, i, i});
    }
    runs.back().last = i + 1;
  }
  return runs;
}

Pose poseBeside(const RobotModel& model, LinkId first, LinkId other) {
  const auto pose_of = [&](LinkId object) {
    return model.joint(*model.link(object).parent_joint).parent_from_joint;
  };
  return inverse(pose_of(first)) * pose_of(other);
}

}  // namespace collision_monitor
