// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/pair_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/constants.h"
#include "pipeline/data/motion_bound.h"

namespace collision_monitor {
namespace {

/// Index of the range that moves a joint; adds it where it is not there. Empty: none moves it.
std::optional<std::size_t> variableOf(JointId source, const std::vector<JointRange>& ranges,
                                      PairMotion& motion) {
  const auto is_it = [&](const JointRange& range) { return range.joint == source; };
  const auto known = std::find_if(motion.ranges.begin(), motion.ranges.end(), is_it);
  if (known != motion.ranges.end()) {
    return static_cast<std::size_t>(known - motion.ranges.begin());
  }
  const auto range = std::find_if(ranges.begin(), ranges.end(), is_it);
  if (range == ranges.end()) {
    return std::nullopt;
  }
  motion.ranges.push_back(*range);
  return motion.ranges.size() - 1;
}

/// A joint that mimics a continuous one does not repeat where that one does, unless both turn by
/// the same angle.
bool isWhole(const RobotModel& model, const Joint& joint, double factor, const JointRange& range) {
  const bool is_continuous = model.joint(range.joint).type == JointType::continuous;
  const bool turns_as_far = joint.type != JointType::prismatic && std::abs(factor) == 1.0;
  return range.is_whole && (!is_continuous || turns_as_far);
}

/// @return false if the ranges do not cover the motion of the link's joint.
bool addJoint(const RobotModel& model, const std::vector<JointRange>& ranges, LinkId child,
              bool carries_b, PairMotion& motion) {
  const auto& parent_joint = model.link(child).parent_joint;
  if (!parent_joint) {
    return true;  // the root of a robot stands
  }
  const Joint& joint = model.joint(*parent_joint);
  motion.scale += joint.parent_from_joint.translation.norm();
  if (joint.type == JointType::fixed) {
    return true;
  }
  if (freedomOf(joint) != 1) {
    return false;
  }
  const double factor = joint.mimic ? joint.mimic->multiplier : 1.0;
  if (factor == 0.0) {
    return true;
  }
  const auto variable =
      variableOf(joint.mimic ? joint.mimic->source : *parent_joint, ranges, motion);
  if (!variable) {
    return false;
  }
  const bool is_prismatic = joint.type == JointType::prismatic;
  const JointRange& range = motion.ranges[*variable];
  if (is_prismatic) {
    motion.scale += std::abs(factor) * std::max(std::abs(range.lower), std::abs(range.upper));
    motion.scale += joint.mimic ? std::abs(joint.mimic->offset) : 0.0;
  }
  motion.joints.push_back({child, joint.axis, is_prismatic, carries_b, *variable, factor});
  return isWhole(model, joint, factor, range);
}

void placeJoints(const JointCell& cell, PlacedCell& placed) {
  for (std::size_t i = 0; i < placed.motion.joints.size(); ++i) {
    const PairJoint& joint = placed.motion.joints[i];
    const Pose& frame = placed.world_from_link[index(joint.child)];
    placed.axes[i].noalias() = frame.rotation * joint.axis;
    placed.points[i] = frame.translation;
    placed.halves[i] = std::abs(joint.factor) * cell.half[joint.variable];
  }
}

}  // namespace

PairMotion makePairMotion(const RobotModel& model, const std::vector<JointRange>& ranges, LinkId a,
                          LinkId b) {
  std::vector<LinkId> up = linksToRoot(model, a);
  std::vector<LinkId> down = linksToRoot(model, b);
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  PairMotion motion;
  motion.a = a;
  motion.b = b;
  motion.is_whole = true;
  for (const LinkId link : up) {
    motion.is_whole = addJoint(model, ranges, link, false, motion) && motion.is_whole;
  }
  std::reverse(down.begin(), down.end());
  for (const LinkId link : down) {
    motion.is_whole = addJoint(model, ranges, link, true, motion) && motion.is_whole;
  }
  motion.links.assign(up.rbegin(), up.rend());
  motion.links.insert(motion.links.end(), down.begin(), down.end());
  return motion;
}

JointCell wholeCell(const PairMotion& motion) {
  JointCell cell;
  for (const JointRange& range : motion.ranges) {
    cell.middle.push_back(0.5 * range.lower + 0.5 * range.upper);
    cell.half.push_back(0.5 * range.upper - 0.5 * range.lower);
  }
  // After a full turn, a joint repeats itself.
  for (std::size_t i = 0; i < motion.ranges.size(); ++i) {
    const bool only_turns =
        std::all_of(motion.joints.begin(), motion.joints.end(), [&](const PairJoint& joint) {
          return joint.variable != i || (!joint.is_prismatic && std::abs(joint.factor) == 1.0);
        });
    cell.half[i] = only_turns ? std::min(cell.half[i], kPi) : cell.half[i];
  }
  return cell;
}

JointCell halfOf(const JointCell& cell, std::size_t variable, double side) {
  JointCell half = cell;
  half.half[variable] *= 0.5;
  half.middle[variable] += side * half.half[variable];
  return half;
}

PlacedCell makePlacedCell(const RobotModel& model, const PairMotion& motion,
                          const std::vector<Pose>& world_from_root) {
  const std::size_t count = motion.joints.size();
  PlacedCell placed{motion,
                    defaultPositions(model),
                    {},
                    std::vector<Eigen::Vector3d>(count),
                    std::vector<Eigen::Vector3d>(count),
                    std::vector<double>(count)};
  placeLinks(model, placed.state, world_from_root, placed.world_from_link);
  return placed;
}

void place(const RobotModel& model, const JointCell& cell, PlacedCell& placed) {
  for (std::size_t i = 0; i < placed.motion.ranges.size(); ++i) {
    placed.state[model.joint(placed.motion.ranges[i].joint).first_variable] = cell.middle[i];
  }
  for (const LinkId link : placed.motion.links) {
    if (const auto& parent_joint = model.link(link).parent_joint) {
      const Joint& joint = model.joint(*parent_joint);
      placed.world_from_link[index(link)] =
          placed.world_from_link[index(joint.parent)] * parentFromChild(joint, placed.state);
    }
  }
  placeJoints(cell, placed);
}

}  // namespace collision_monitor
