// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/gradient_row.h"

#include <algorithm>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/motion/closing.h"

namespace collision_monitor {
namespace {

/// Adds to the variable's entry, or makes one.
void add(std::uint32_t variable, double value, GradientRow& row) noexcept {
  const auto place = std::find_if(row.begin(), row.end(), [&](const GradientEntry& entry) {
    return entry.variable == variable;
  });
  if (place == row.end()) {
    row.push_back({variable, value});
  } else {
    place->value += value;
  }
}

/// Which of the two links of a pair a joint moves.
enum class Side : unsigned char { a, b };

void addJoint(const RobotModel& model, const LinkPoses& poses, const SignedDistance& measured,
              std::pair<JointId, Side> moved, GradientRow& row) noexcept {
  const Joint& joint = model.joint(moved.first);
  for (std::size_t k = 0; k < freedomOf(joint); ++k) {
    const Twist twist = jointTwist(joint, k, poses.world_from_link[index(joint.parent)],
                                   poses.world_from_link[index(joint.child)]);
    const double rate = moved.second == Side::a ? distanceRate(measured, twist, Twist())
                                                : distanceRate(measured, Twist(), twist);
    add(static_cast<std::uint32_t>(joint.first_variable + k), rate, row);
  }
}

}  // namespace

GradientRow makeGradientRow(const RobotModel& model) {
  GradientRow row;
  row.reserve(model.variable_count);
  return row;
}

void gradientRow(const CycleSetup& setup, const LinkPoses& poses, const PairDistance& distance,
                 GradientRow& row) noexcept {
  const RobotModel& model = setup.model;
  const CheckedLinkPair& pair = setup.checked[setup.link_pair_of[index(distance.pair)]];
  LinkId a = pair.a;
  LinkId b = pair.b;
  row.clear();
  // Parents stand before their children: the later of the two links is no ancestor of the other.
  while (a != b) {
    const bool is_a = index(a) > index(b);
    const bool climbs_a = model.link(is_a ? a : b).parent_joint ? is_a : !is_a;
    LinkId& link = climbs_a ? a : b;
    const auto& joint = model.link(link).parent_joint;
    if (!joint) {
      break;  // two robots, both at their roots
    }
    addJoint(model, poses, distance.measured, {*joint, climbs_a ? Side::a : Side::b}, row);
    link = model.joint(*joint).parent;
  }
  std::sort(row.begin(), row.end(), [](const GradientEntry& one, const GradientEntry& other) {
    return one.variable < other.variable;
  });
}

}  // namespace collision_monitor
