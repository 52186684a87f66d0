// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/link_velocities.h"

#include <algorithm>

#include "collision_monitor/model/kinematics.h"
#include "motion/link_velocity.h"
#include "pipeline/objects/carry_objects.h"

namespace collision_monitor {
namespace {

bool isPlaced(const LinkPoses& poses, std::size_t link) noexcept {
  return poses.status[link] == LinkStatus::known && isFinite(poses.world_from_link[link]);
}

/// Adds a new stamp of one link, `duration` [s] after the last one; 0: the gap was too long.
/// @param share smoothingShare of `duration`
void trackLink(const LinkPoses& poses, double duration, double share, std::size_t link,
               VelocityTracker& tracker) noexcept {
  const bool is_known = isPlaced(poses, link);
  Twist& twist = tracker.filtered.of_link[link];
  unsigned char& is_moving = tracker.filtered.known[link];
  const bool was_known = tracker.was_known[link] != 0 && tracker.part[link] == poses.part[link];
  if (is_known && was_known && duration > 0.0) {
    const Twist now =
        twistBetween(tracker.world_from_link[link], poses.world_from_link[link], duration);
    twist = is_moving != 0 ? smoothed(twist, now, share) : now;
    is_moving = 1;
  } else {
    is_moving = 0;
  }
  tracker.was_known[link] = is_known ? 1 : 0;
  tracker.part[link] = poses.part[link];
  tracker.world_from_link[link] = poses.world_from_link[link];
}

/// Sets a link's velocity from the tracker, if it was tracked in the part where the link is now.
void tellVelocity(const VelocityTracker& tracker, std::size_t link, LinkPoses& poses) noexcept {
  const bool is_top = poses.part[link] == link;
  const bool is_of_part = tracker.part[link] == poses.part[link];
  const bool is_told = is_of_part && tracker.filtered.known[link] != 0;
  poses.velocities.of_link[link] = is_top ? Twist() : tracker.filtered.of_link[link];
  poses.velocities.known[link] = isPlaced(poses, link) && (is_top || is_told) ? 1 : 0;
}

/// The sum of the motions of the joint's variables; not finite if one velocity is unknown.
Twist twistOf(const Joint& joint, const JointVelocities& velocities,
              const LinkPoses& poses) noexcept {
  Twist twist;
  for (std::size_t k = 0; k < freedomOf(joint); ++k) {
    twist = twist + velocities[joint.first_variable + k] *
                        jointTwist(joint, k, poses.world_from_link[index(joint.parent)],
                                   poses.world_from_link[index(joint.child)]);
  }
  return twist;
}

void applyJointVelocity(const RobotModel& model, const JointVelocities& velocities,
                        std::size_t link, LinkPoses& poses) noexcept {
  LinkVelocities& moving = poses.velocities;
  const auto& parent_joint = model.links[link].parent_joint;
  if (!parent_joint || !isPlaced(poses, link) || poses.part[link] == link) {
    return;
  }
  const Joint& joint = model.joint(*parent_joint);
  const Twist own = twistOf(joint, velocities, poses);
  if (moving.known[index(joint.parent)] != 0 && isFinite(own)) {
    moving.of_link[link] = moving.of_link[index(joint.parent)] + own;
    moving.known[link] = 1;
  }
}

}  // namespace

VelocityTracker makeVelocityTracker(const RobotModel& model) {
  VelocityTracker tracker;
  tracker.stamp_ns.resize(model.robots.size(), 0);
  tracker.world_from_link.resize(model.links.size());
  tracker.was_known.resize(model.links.size(), 0);
  tracker.part.resize(model.links.size(), kWorldPart);
  tracker.filtered.of_link.resize(model.links.size());
  tracker.filtered.known.resize(model.links.size(), 0);
  tracker.objects = objectRuns(model);
  return tracker;
}

void resetTracker(VelocityTracker& tracker) noexcept {
  std::fill(tracker.was_known.begin(), tracker.was_known.end(), 0);
  std::fill(tracker.filtered.known.begin(), tracker.filtered.known.end(), 0);
}

void trackVelocities(const RobotModel& model, const VelocityOptions& options,
                     VelocityTracker& tracker, LinkPoses& poses) noexcept {
  for (std::size_t i = 0; i < model.robots.size(); ++i) {
    const Robot& robot = model.robots[i];
    const std::int64_t stamp_ns = poses.robot_stamp_ns[i];
    const double passed = 1e-9 * static_cast<double>(stamp_ns - tracker.stamp_ns[i]);
    const double duration = passed <= options.longest_gap ? passed : 0.0;
    const double share = smoothingShare(duration, options.time_constant);
    forOwnLinks(model, robot, [&](std::size_t link) noexcept {
      if (stamp_ns != tracker.stamp_ns[i]) {
        trackLink(poses, duration, share, link, tracker);
      }
      tellVelocity(tracker, link, poses);
    });
    tracker.stamp_ns[i] = stamp_ns;
  }
  carryVelocities(tracker.objects, poses);
}

void applyJointVelocities(const RobotModel& model, const JointVelocities& velocities,
                          LinkPoses& poses) noexcept {
  for (const Robot& robot : model.robots) {
    forOwnLinks(model, robot, [&](std::size_t link) noexcept {
      applyJointVelocity(model, velocities, link, poses);
    });
  }
}

}  // namespace collision_monitor
