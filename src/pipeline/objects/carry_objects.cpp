// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/objects/carry_objects.h"

#include <algorithm>

#include "geometry/ball_motion.h"

namespace collision_monitor {
namespace {

Pose poseOf(const RobotModel& model, std::size_t carrier, std::size_t object,
            const LinkPoses& poses) noexcept {
  return poses.world_from_link[carrier] *
         model.joint(*model.links[object].parent_joint).parent_from_joint;
}

/// Whether an object stands where its carrier leads to.
bool isCarried(const RobotModel& model, std::size_t carrier, std::size_t object,
               const LinkPoses& poses) noexcept {
  const bool is_alike = poses.status[object] == poses.status[carrier] &&
                        poses.part[object] == poses.part[carrier] &&
                        poses.part_status[object] == poses.part_status[carrier];
  return is_alike && (poses.status[carrier] != LinkStatus::known ||
                      isSame(poses.world_from_link[object], poseOf(model, carrier, object, poses)));
}

template <class Value>
void copyToObjects(const ObjectRun& run, std::vector<Value>& values) noexcept {
  std::fill(values.begin() + static_cast<std::ptrdiff_t>(run.first),
            values.begin() + static_cast<std::ptrdiff_t>(run.last), values[index(run.carrier)]);
}

}  // namespace

void carryPoses(const RobotModel& model, const std::vector<ObjectRun>& objects,
                LinkPoses& poses) noexcept {
  for (const ObjectRun& run : objects) {
    const std::size_t carrier = index(run.carrier);
    if (poses.age[run.first] != poses.age[carrier]) {
      copyToObjects(run, poses.age);
    }
    if (isCarried(model, carrier, run.first, poses)) {
      continue;
    }
    copyToObjects(run, poses.status);
    copyToObjects(run, poses.part);
    copyToObjects(run, poses.part_status);
    for (std::size_t i = run.first; i < run.last; ++i) {
      poses.world_from_link[i] = poseOf(model, carrier, i, poses);
    }
  }
}

void carryVelocities(const std::vector<ObjectRun>& objects, LinkPoses& poses) noexcept {
  LinkVelocities& velocities = poses.velocities;
  for (const ObjectRun& run : objects) {
    const std::size_t carrier = index(run.carrier);
    const Twist& twist = velocities.of_link[carrier];
    const Twist& carried = velocities.of_link[run.first];
    if (velocities.known[run.first] != velocities.known[carrier] ||
        carried.linear != twist.linear || carried.angular != twist.angular) {
      copyToObjects(run, velocities.known);
      copyToObjects(run, velocities.of_link);
    }
  }
}

}  // namespace collision_monitor
