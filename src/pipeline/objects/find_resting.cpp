// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/objects/find_resting.h"

#include <algorithm>

#include "geometry/ball_motion.h"

namespace collision_monitor {
namespace {

/// After this many cycles at rest the motions of the last two cycles are those of rest, too.
constexpr std::uint32_t kSettled = 3;

/// Velocities that fade away after a motion count as equal: bounds keep the greater one.
bool isEqual(const Twist& one, const Twist& other) noexcept {
  return (one.linear == other.linear && one.angular == other.angular) ||
         (isFaded(one) && isFaded(other));
}

/// Whether a link is as it was in the last cycle.
bool rests(const LinkPoses& poses, const LastPoses& last, const Rest& rest,
           std::size_t link) noexcept {
  const bool is_known = poses.status[link] == LinkStatus::known;
  const bool is_twist_known = poses.velocities.known[link] != 0;
  return poses.part[link] == kWorldPart && last.part[link] == kWorldPart &&
         is_known == (last.known[link] != 0) &&
         (!is_known || isSame(poses.world_from_link[link], last.world_from_link[link])) &&
         is_twist_known == rest.is_twist_known &&
         (!is_twist_known || isEqual(poses.velocities.of_link[link], rest.twist));
}

void clear(MovedParts& moved) noexcept {
  moved.links.clear();
  moved.bodies.clear();
  moved.elements.clear();
}

void addRange(std::size_t first, std::size_t last, std::vector<IndexRange>& ranges) {
  if (first < last) {
    ranges.push_back({first, last});
  }
}

/// Adds what stands between two groups of carried objects.
void addBetween(const CarriedObjects& former, const CarriedObjects& next, MovedParts& moved) {
  addRange(former.last_link, next.first_link, moved.links);
  addRange(former.last_body, next.first_body, moved.bodies);
  addRange(former.last_element, next.first_element, moved.elements);
}

/// An empty group after everything.
CarriedObjects endOf(const CycleSetup& setup) noexcept {
  CarriedObjects end;
  end.first_link = setup.model.links.size();
  end.first_body = setup.bodies.size();
  end.first_element = setup.elements.size();
  return end;
}

}  // namespace

Rest settledRest(const Twist& twist) noexcept { return {kSettled, true, twist}; }

bool isFaded(const Twist& twist) noexcept {
  constexpr double kFaded = 1e-9;  // [m/s], [rad/s]
  return twist.linear.norm() <= kFaded && twist.angular.norm() <= kFaded;
}

void moveAll(const CycleSetup& setup, MovedParts& moved) {
  for (std::vector<IndexRange>* ranges : {&moved.links, &moved.bodies, &moved.elements}) {
    ranges->reserve(setup.carried.size() + 1);
  }
  clear(moved);
  addBetween(CarriedObjects(), endOf(setup), moved);
}

void findResting(const CycleSetup& setup, const LinkPoses& poses, LastPoses& last,
                 BodyPoses& body_poses) noexcept {
  MovedParts& moved = body_poses.moved;
  clear(moved);
  CarriedObjects passed;
  for (std::size_t i = 0; i < setup.carried.size(); ++i) {
    const CarriedObjects& objects = setup.carried[i];
    Rest& rest = last.rests[i];
    const bool has_rested = rests(poses, last, rest, objects.first_link);
    const bool is_later = poses.stamp_ns > last.stamp_ns;
    rest.cycles = has_rested ? std::min(kSettled, rest.cycles + (is_later ? 1U : 0U)) : 0;
    rest.is_twist_known = poses.velocities.known[objects.first_link] != 0;
    rest.twist = poses.velocities.of_link[objects.first_link];
    if (rest.cycles == kSettled) {
      addBetween(passed, objects, moved);
      passed = objects;
    }
  }
  addBetween(passed, endOf(setup), moved);
}

}  // namespace collision_monitor
