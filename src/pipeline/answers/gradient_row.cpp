// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/gradient_row.h"

#include <algorithm>

#include "collision_monitor/model/kinematics.h"

namespace collision_monitor {
namespace {

/// Adds a value to the entry of a variable; makes the entry if it is missing.
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

}  // namespace

GradientRows::GradientRows(const CycleSetup& setup, const LinkPoses& poses)
    : setup_(setup), joined_(setup.model.links.size()) {
  row_.reserve(setup.model.variable_count);
  std::size_t twists = 0;
  for (const Joint& joint : setup.model.joints) {
    twists += freedomOf(joint);
  }
  twists_.reserve(twists);
  moveTo(poses);
}

void GradientRows::moveTo(const LinkPoses& poses) noexcept {
  twists_.clear();
  for (const Joint& joint : setup_.model.joints) {
    addLink(poses, joint);
  }
}

void GradientRows::addLink(const LinkPoses& poses, const Joint& joint) {
  const std::size_t first = twists_.size();
  for (std::size_t k = 0; k < freedomOf(joint); ++k) {
    twists_.push_back(jointTwist(joint, k, poses.world_from_link[index(joint.parent)],
                                 poses.world_from_link[index(joint.child)]));
  }
  joined_[index(joint.child)] = {joint.parent, joint.first_variable, first, twists_.size(), false};
}

void GradientRows::addJoint(const Wrench& pull, const Joined& joined) noexcept {
  for (std::size_t i = joined.first; i < joined.last; ++i) {
    add(static_cast<std::uint32_t>(joined.first_variable + i - joined.first),
        power(pull, twists_[i]), row_);
  }
}

const GradientRow& GradientRows::of(const PairDistance& distance) noexcept {
  const CheckedLinkPair& pair = setup_.checked[setup_.link_pair_of[index(distance.pair)]];
  LinkId a = pair.a;
  LinkId b = pair.b;
  // As in distanceRate: the derivative of the distance is the power of a unit force along the
  // normal on B.
  const SignedDistance& measured = distance.measured;
  const Wrench on_b = forceAt(measured.point_on_b, measured.normal_a_to_b);
  const Wrench on_a = -on_b;
  row_.clear();
  // Parents come before their children: the link of the larger id is no ancestor of the other.
  while (a != b) {
    const bool is_a = index(a) > index(b);
    const bool climbs_a = joined_[index(is_a ? a : b)].is_root ? !is_a : is_a;
    LinkId& link = climbs_a ? a : b;
    const Joined& joined = joined_[index(link)];
    if (joined.is_root) {
      break;  // links of two robots; both ends are roots
    }
    addJoint(climbs_a ? on_a : on_b, joined);
    link = joined.parent;
  }
  // Entries mostly come in descending order.
  std::reverse(row_.begin(), row_.end());
  std::sort(row_.begin(), row_.end(), [](const GradientEntry& one, const GradientEntry& other) {
    return one.variable < other.variable;
  });
  return row_;
}

}  // namespace collision_monitor
