// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/geometry/ids.h"
#include "ros_edge/outputs/conversions.h"

namespace collision_monitor {
namespace {

void fillPoints(const ContactPoints& points, Contact& message) {
  message.points.resize(points.size);
  for (std::size_t i = 0; i < points.size; ++i) {
    toMessage(points.points[i], message.points[i]);
  }
  message.feature = points.feature;
}

/// Fills everything but points and poses.
void fillPair(const Watch& watch, const PairDistance& distance, Contact& message) {
  const CycleSetup& setup = watch.setup();
  const BodyPair& pair = setup.table[distance.pair];
  const CheckedLinkPair& links = setup.checked[setup.link_pair_of[index(distance.pair)]];
  message.frame_id = frameOf(*watch.fixed, watch.poses, links.a);
  message.link_a = setup.model.link(links.a).name;
  message.link_b = setup.model.link(links.b).name;
  message.shape_a = shapeName(setup, distance, pair.a);
  message.shape_b = shapeName(setup, distance, pair.b);
  message.quality = static_cast<std::uint8_t>(distance.quality);
  toMessage(distance.measured.normal_a_to_b, message.normal);
  message.depth = std::max(0.0, -distance.measured.distance);
  message.island = watch.buffers.events.island_of_link[index(links.a)];
}

void fill(const Watch& watch, const PairDistance& distance, Contact& message) {
  const CycleSetup& setup = watch.setup();
  const CheckedLinkPair& links = setup.checked[setup.link_pair_of[index(distance.pair)]];
  fillPair(watch, distance, message);
  fillPoints(contactPointsOf(watch, distance), message);
  message.passed_at = kUnknown;
  toMessage(watch.poses.world_from_link[index(links.a)], message.pose_a);
  toMessage(watch.poses.world_from_link[index(links.b)], message.pose_b);
}

void fill(const Watch& watch, const PassedContact& passed, Contact& message) {
  fillPair(watch, passed.distance, message);
  fillPoints(onePointOf(passed.distance.measured), message);
  message.passed_at = passed.time * watch.buffers.sweep.elapsed;
  toMessage(passed.world_from_link_a, message.pose_a);
  toMessage(passed.world_from_link_b, message.pose_b);
}

}  // namespace

ContactPoints onePointOf(const SignedDistance& measured) {
  ContactPoints points;
  points.points[0] = 0.5 * (measured.point_on_a + measured.point_on_b);
  points.size = 1;
  return points;
}

ContactPoints contactPointsOf(const Watch& watch, const PairDistance& distance) {
  const auto manifold = contactManifold(watch.setup(), watch.buffers.body_poses, distance);
  if (!manifold) {
    return onePointOf(distance.measured);
  }
  ContactPoints points;
  points.size = manifold->size;
  points.feature = nameOf(manifold->feature);
  for (std::size_t i = 0; i < manifold->size; ++i) {
    const ManifoldPoint& point = manifold->points[i];
    points.points[i] = 0.5 * (point.point_on_a + point.point_on_b);
  }
  return points;
}

bool isInContact(const Watch& watch, const PairDistance& distance) {
  const std::uint32_t link_pair = watch.setup().link_pair_of[index(distance.pair)];
  const Limits& limits = limitsOf(watch.setup(), link_pair);
  const PairEvents& events = watch.buffers.events;
  // A pair that only passed contact is listed as passed.
  const double kept = events.passed[link_pair] == kNone ? limits.hysteresis : 0.0;
  return events.verdicts[link_pair] == Verdict::contact &&
         isTouching(distance, limits.contact_distance + kept);
}

void toMessage(const Watch& watch, Contacts& message) {
  message.header = makeHeader(watch.poses.stamp_ns, watch.fixed->world_frame);
  message.island_count = watch.buffers.events.island_count;
  std::size_t count = 0;
  const auto next = [&]() -> Contact& {
    message.contacts.resize(std::max(message.contacts.size(), count + 1));
    return message.contacts[count++];
  };
  for (const PairDistance& distance : watch.buffers.distances.pairs) {
    if (isInContact(watch, distance)) {
      fill(watch, distance, next());
    }
  }
  for (const PassedContact& passed : watch.buffers.distances.passed) {
    fill(watch, passed, next());
  }
  message.contacts.resize(count);
}

}  // namespace collision_monitor
